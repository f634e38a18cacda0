module abut.shape.mesh;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.midphase.bvh;
import abut.shape;

namespace abut {
namespace {

struct HalfEdge {
  std::uint32_t low, high;  // vertices
  std::uint32_t triangle;
  std::uint8_t edge;  // 0: from corner 0 to 1, ...
};

}  // namespace

Result<Mesh> Mesh::make(std::span<const Real> parameters, std::span<const Real> reals, std::span<const std::uint32_t> indices) {
  if (Fault fault = check_count("parameter_count", parameters.size(), 1)) {
    return *fault;
  }
  if (parameters[0] != 0 && parameters[0] != 1) {
    return error_about(Errc::unknown_value, "sides", parameters[0], "0 (both) or 1 (front)");
  }
  if (reals.empty()) {
    return Error{Errc::empty, "vertex_count is 0; a mesh needs vertices"};
  }
  if (indices.empty()) {
    return Error{Errc::empty, "triangle_count is 0; a mesh needs at least one triangle"};
  }
  if (reals.size() % 3 != 0) {
    return error_about(Errc::invalid_argument, "real_count", static_cast<std::uint64_t>(reals.size()), "a multiple of 3");
  }
  if (indices.size() % 3 != 0) {
    return error_about(Errc::invalid_argument, "index_count", static_cast<std::uint64_t>(indices.size()), "a multiple of 3");
  }
  if (reals.size() / 3 > no_index || indices.size() / 3 > no_index) {
    return Error{Errc::size_overflow, "a mesh has at most 2^32 - 1 vertices and triangles"};
  }
  if (Fault fault = check_all_finite("xyz", reals)) {
    return *fault;
  }
  const std::size_t vertex_count = reals.size() / 3;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= vertex_count) {
      return error_about(Errc::index_out_of_range, "triangles[" + std::to_string(i) + "]", std::uint64_t{indices[i]},
                         "below vertex_count, which is " + std::to_string(vertex_count));
    }
  }
  Data data{{}, {indices.begin(), indices.end()}, parameters[0] == 1, Aabb::empty(), {}};
  data.vertices.resize(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) {
    data.vertices[i] = {reals[3 * i], reals[3 * i + 1], reals[3 * i + 2]};
  }
  for (const std::uint32_t index : indices) {
    data.box.include(data.vertices[index]);
  }
  return Mesh(std::move(data));
}

Mesh::Tree Mesh::make_tree(const Data& data) {
  const std::size_t count = data.indices.size() / 3;
  const auto corner = [&](std::size_t triangle, std::size_t i) { return data.vertices[data.indices[3 * triangle + i % 3]]; };
  std::vector<Aabb> boxes(count, Aabb::empty());
  std::vector<HalfEdge> edges;
  edges.reserve(3 * count);
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      boxes[triangle].include(corner(triangle, i));
      const auto [low, high] = std::minmax(data.indices[3 * triangle + i], data.indices[3 * triangle + (i + 1) % 3]);
      edges.push_back({low, high, static_cast<std::uint32_t>(triangle), static_cast<std::uint8_t>(i)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle, a.edge) < std::tie(b.low, b.high, b.triangle, b.edge);
  });

  // An edge between exactly two triangles is an inner one when the surface goes on flat (within
  // rounding) across it, or, seen from the only side that counts, dips there.
  std::vector<std::uint8_t> inner(count, 0);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const HalfEdge& a = edges[i];
    const HalfEdge& b = edges[i + 1];
    const bool more = i + 2 < edges.size() && edges[i + 2].low == a.low && edges[i + 2].high == a.high;
    const bool before = i > 0 && edges[i - 1].low == a.low && edges[i - 1].high == a.high;
    if (a.low != b.low || a.high != b.high || more || before) {
      continue;
    }
    const Vec3 base = corner(a.triangle, a.edge);
    const Vec3 normal = cross(corner(a.triangle, a.edge + 1u) - base, corner(a.triangle, a.edge + 2u) - base);
    const Vec3 beyond = corner(b.triangle, b.edge + 2u) - base;
    const Vec3 inward = cross(normal, corner(a.triangle, a.edge + 1u) - base);
    const Real rise = dot(normal, beyond);
    const Real flat = 1e-9 * std::sqrt(squared_norm(normal) * squared_norm(beyond));
    // Where the other triangle lies back on this one, as a repeated triangle does, the edge is a rim.
    const bool goes_on = std::fabs(rise) <= flat && dot(inward, beyond) < 0;
    if (goes_on || (data.one_sided && rise > flat)) {
      inner[a.triangle] = static_cast<std::uint8_t>(inner[a.triangle] | (1u << a.edge));
      inner[b.triangle] = static_cast<std::uint8_t>(inner[b.triangle] | (1u << b.edge));
    }
  }
  return {Bvh(boxes), std::move(inner)};
}

std::vector<Mesh> Mesh::samples() {
  const auto xyz = std::to_array<Real>({1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1});
  const auto tetrahedron = std::to_array<std::uint32_t>({0, 1, 3, 0, 3, 2, 0, 2, 1, 1, 2, 3});
  const auto both = std::to_array<Real>({0}), front = std::to_array<Real>({1});
  std::vector<Real> sheet_xyz;
  std::vector<std::uint32_t> sheet;
  for (std::uint32_t j = 0; j < 5; ++j) {
    for (std::uint32_t i = 0; i < 5; ++i) {
      const Real x = 0.5 * i - 1, y = 0.5 * j - 1;
      sheet_xyz.insert(sheet_xyz.end(), {x, y, 0.3 * x * y});
      if (i < 4 && j < 4) {
        const std::uint32_t k = 5 * j + i;
        sheet.insert(sheet.end(), {k, k + 1, k + 6, k, k + 6, k + 5});
      }
    }
  }
  return {make(both, xyz, tetrahedron).value(), make(front, sheet_xyz, sheet).value()};
}

}  // namespace abut
