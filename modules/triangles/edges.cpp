// SPDX-License-Identifier: Apache-2.0
module abut.triangles.edges;
import abut.core.standard;

namespace abut {

std::vector<EdgeOfTriangle> edges_in_order(std::span<const std::uint32_t> triangles) {
  std::vector<EdgeOfTriangle> edges;
  edges.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t start = triangles[i], end = triangles[i - i % 3 + (i + 1) % 3];
    edges.push_back({std::min(start, end), std::max(start, end), static_cast<std::uint32_t>(i / 3), start < end});
  }
  std::ranges::sort(edges, [](const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
    return std::tuple(a.low, a.high, a.triangle, a.is_forward) < std::tuple(b.low, b.high, b.triangle, b.is_forward);
  });
  return edges;
}

}  // namespace abut
