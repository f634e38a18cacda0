// SPDX-License-Identifier: Apache-2.0
// Which triangles share an edge.
export module abut.triangles.edges;
import abut.core.standard;

export namespace abut {

// An edge of a triangle, by its ends in order.
struct EdgeOfTriangle {
  std::uint32_t low, high, triangle;
  bool is_forward;  // from low to high along the winding
};

[[nodiscard]] std::vector<EdgeOfTriangle> edges_in_order(std::span<const std::uint32_t> triangles) {
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

// Calls visit(sharing) for each edge, with all that lie there.
template <class Visitor>
void visit_edges(std::span<const std::uint32_t> triangles, Visitor&& visit) {
  const std::vector<EdgeOfTriangle> edges = edges_in_order(triangles);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) {
      ++end;
    }
    visit(std::span(edges).subspan(begin, end - begin));
  }
}

}  // namespace abut
