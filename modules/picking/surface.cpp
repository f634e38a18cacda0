module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

module abut.picking;
import :source;
import :surface;
import :vector;

namespace abut::picking {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Widest corner, and sharpest fold, of a pair: beyond them its outline could not be grown outwards.
constexpr double least_sine_of_corner = 0.1;
constexpr double least_cosine_of_fold = 0.5;

// Growth of outlines in units of the rounding of a coordinate (2^-24 of the extent of the space).
// Rays start within 3 * sqrt(3) extents; their rounding and that of the ray-triangle test stay below
// this. In trials on rays aimed at edges and vertices 4 sufficed.
constexpr double growth = 16;
// A sharp corner moves by at most this many times the growth.
constexpr double longest_miter = 4;

[[nodiscard]] abut_vec3 vertex(const TriangleList& list, std::uint32_t index) {
  const std::size_t at = 3 * static_cast<std::size_t>(index);
  return {list.xyz[at], list.xyz[at + 1], list.xyz[at + 2]};
}

[[nodiscard]] Triangle triangle(const TriangleList& list, std::size_t index) {
  return {list.indices[3 * index], list.indices[3 * index + 1], list.indices[3 * index + 2]};
}

[[nodiscard]] abut_vec3 area_vector(const TriangleList& list, const Triangle& t) {
  const abut_vec3 a = vertex(list, t[0]);
  return cross(subtract(vertex(list, t[1]), a), subtract(vertex(list, t[2]), a));
}

[[nodiscard]] Plane plane_of(const TriangleList& list, const Triangle& t) {
  const abut_vec3 normal = normalized(area_vector(list, t));
  return {normal, dot(normal, vertex(list, t[0]))};
}

[[nodiscard]] abut_vec3 unit_or_zero(const abut_vec3& v) { return largest_component(v) == 0 ? v : normalized(v); }

// Whether the two corners that a pair has at a vertex together stay well below a half turn.
[[nodiscard]] bool is_convex_at(const abut_vec3& at, const abut_vec3& first, const abut_vec3& shared, const abut_vec3& last) {
  const abut_vec3 a = unit_or_zero(subtract(first, at));
  const abut_vec3 b = unit_or_zero(subtract(shared, at));
  const abut_vec3 c = unit_or_zero(subtract(last, at));
  return length(cross(a, b)) * dot(b, c) + dot(a, b) * length(cross(b, c)) > least_sine_of_corner;
}

// Two triangles as the corners of one pair, when they share an edge in opposite directions.
[[nodiscard]] std::optional<Corners> joined(const TriangleList& list, const Triangle& first, const Triangle& second) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t from = first[i];
    const std::uint32_t to = first[(i + 1) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      if (second[k] != to || second[(k + 1) % 3] != from) continue;
      const Corners corners{first[(i + 2) % 3], from, second[(k + 2) % 3], to};
      const abut_vec3 v0 = vertex(list, corners[0]);
      const abut_vec3 v1 = vertex(list, corners[1]);
      const abut_vec3 v2 = vertex(list, corners[2]);
      const abut_vec3 v3 = vertex(list, corners[3]);
      const bool flat = dot(plane_of(list, first).normal, plane_of(list, second).normal) > least_cosine_of_fold;
      if (flat && is_convex_at(v1, v0, v3, v2) && is_convex_at(v3, v0, v1, v2)) return corners;
      return std::nullopt;
    }
  }
  return std::nullopt;
}

void append(Surface& surface, const TriangleList& list, const Corners& corners, std::uint32_t first, std::uint32_t second) {
  const Plane plane = plane_of(list, {corners[0], corners[1], corners[3]});
  const bool alone = first == second;
  surface.patches.push_back({{plane, alone ? plane : plane_of(list, {corners[2], corners[3], corners[1]})}});
  surface.triangles.push_back({first, second});
  surface.corners.push_back(corners);
}

struct Edge {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
};

// Edges of the triangles that wait for a partner, so that equal edges lie side by side.
[[nodiscard]] std::vector<Edge> sorted_edges(const TriangleList& list, const std::vector<std::uint32_t>& waiting) {
  std::vector<Edge> edges;
  edges.reserve(3 * waiting.size());
  for (const std::uint32_t index : waiting) {
    const Triangle t = triangle(list, index);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), index});
    }
  }
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle < b.triangle;
  });
  return edges;
}

void join_waiting(Surface& surface, const TriangleList& list, const std::vector<std::uint32_t>& waiting) {
  const std::vector<Edge> edges = sorted_edges(list, waiting);
  std::vector<std::uint8_t> taken(list.indices.size() / 3, 0);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge& a = edges[i];
    const Edge& b = edges[i + 1];
    if (a.low != b.low || a.high != b.high || taken[a.triangle] != 0 || taken[b.triangle] != 0) continue;
    if (const auto corners = joined(list, triangle(list, a.triangle), triangle(list, b.triangle))) {
      append(surface, list, *corners, a.triangle, b.triangle);
      taken[a.triangle] = 1;
      taken[b.triangle] = 1;
    }
  }
  for (const std::uint32_t index : waiting) {
    if (taken[index] != 0) continue;
    const Triangle t = triangle(list, index);
    append(surface, list, {t[0], t[1], t[2], t[2]}, index, index);
  }
}

// A corner moved outwards in its plane, so that both edges that meet there move by `distance`.
[[nodiscard]] abut_vec3 grown(const abut_vec3& corner, const abut_vec3& next, const abut_vec3& previous, double distance) {
  const abut_vec3 a = unit_or_zero(subtract(next, corner));
  const abut_vec3 b = unit_or_zero(subtract(previous, corner));
  const double sine = length(cross(a, b));
  const double miter = distance * std::min(longest_miter, 1 / std::max(sine, 1e-9));
  return subtract(corner, scale(add(a, b), miter));
}

}  // namespace

Surface make_surface(const TriangleList& list) {
  Surface surface;
  const std::size_t count = list.indices.size() / 3;
  surface.patches.reserve(count / 2 + 1);
  surface.triangles.reserve(count / 2 + 1);
  surface.corners.reserve(count / 2 + 1);
  std::vector<std::uint32_t> waiting;
  std::optional<std::uint32_t> previous;
  // Most meshes that come from quads or grids list the two halves one after the other.
  for (std::size_t i = 0; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    if (largest_component(area_vector(list, triangle(list, i))) == 0) continue;
    if (!previous) {
      previous = index;
    } else if (const auto corners = joined(list, triangle(list, *previous), triangle(list, i))) {
      append(surface, list, *corners, *previous, index);
      previous.reset();
    } else {
      waiting.push_back(*previous);
      previous = index;
    }
  }
  if (previous) waiting.push_back(*previous);
  join_waiting(surface, list, waiting);
  return surface;
}

void write_outlines(const Surface& surface, const TriangleList& list, const Space& space, std::span<float> out) {
  const double distance = growth * 0x1p-24 * space.extent;
  for (std::size_t i = 0; i < surface.corners.size(); ++i) {
    const Corners& corners = surface.corners[i];
    const bool alone = corners[2] == corners[3];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = alone && k == 2 ? 0 : (k + 1) % 4;
      const std::size_t previous = alone && k == 3 ? 1 : (k + 3) % 4;
      const abut_vec3 moved = grown(vertex(list, corners[k]), vertex(list, corners[next]), vertex(list, corners[previous]), distance);
      const abut_vec3 local = subtract(moved, space.origin);
      const std::size_t at = 12 * i + 3 * k;
      out[at] = static_cast<float>(local.x);
      out[at + 1] = static_cast<float>(local.y);
      out[at + 2] = static_cast<float>(local.z);
    }
  }
}

abut_aabb box_of(const TriangleList& list) {
  abut_aabb box = empty_box;
  for (std::size_t i = 0; i + 2 < list.xyz.size(); i += 3) extend(box, {list.xyz[i], list.xyz[i + 1], list.xyz[i + 2]});
  return box;
}

Space space_around(const abut_aabb& box) {
  const abut_vec3 origin = centre_of(box);
  return {origin, reach_of(box, origin)};
}

}  // namespace abut::picking
