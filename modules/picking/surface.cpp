// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

module abut.picking;
import :source;
import :surface;
import :vector;

namespace abut::picking {

namespace {

// Growth of outlines in units of the rounding of a coordinate (2^-24 of the extent of the space).
// Rays start within 3 * sqrt(3) extents; their rounding and that of the ray-triangle test stay below
// this. In trials with rays aimed at edges and vertices 4 sufficed.
constexpr double growth = 16;
// A sharp corner moves by at most this many times the growth.
constexpr double longest_miter = 4;

// Where the halves of a quad are folded by more than the angle of this cosine, it cannot be grown.
constexpr double least_fold_cosine = 0.9;

using Corners = std::array<abut_vec3, 3>;

[[nodiscard]] abut_vec3 vertex(const TriangleList& list, std::size_t corner) {
  const std::size_t at = 3 * static_cast<std::size_t>(list.indices[corner]);
  return {list.xyz[at], list.xyz[at + 1], list.xyz[at + 2]};
}

[[nodiscard]] Corners corners_of(const TriangleList& list, std::size_t triangle) {
  return {vertex(list, 3 * triangle), vertex(list, 3 * triangle + 1), vertex(list, 3 * triangle + 2)};
}

[[nodiscard]] abut_vec3 area_vector(const Corners& corners) {
  return cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0]));
}

[[nodiscard]] abut_vec3 unit_or_zero(const abut_vec3& v) { return largest_component(v) == 0 ? v : normalized(v); }

// A quad of two triangles, the first with corners 0, 1 and 3, the second with 2, 3 and 1.
struct Quad {
  std::array<abut_vec3, 4> corners;
  std::array<abut_vec3, 2> normals;  // of the triangles
};

// None when the triangles do not share an edge in opposite directions, or have no area.
[[nodiscard]] std::optional<Quad> quad_of(const TriangleList& list, std::size_t pair) {
  const auto index = [&](std::size_t half, std::size_t corner) {
    return list.indices[3 * (2 * pair + half) + corner % 3];
  };
  const abut_vec3 first = area_vector(corners_of(list, 2 * pair));
  const abut_vec3 second = area_vector(corners_of(list, 2 * pair + 1));
  if (largest_component(first) == 0 || largest_component(second) == 0) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (index(0, i + 1) != index(1, j + 2) || index(0, i + 2) != index(1, j + 1)) continue;
      return Quad{{vertex(list, 6 * pair + i), vertex(list, 6 * pair + (i + 1) % 3), vertex(list, 6 * pair + 3 + j),
                   vertex(list, 6 * pair + (i + 2) % 3)},
                  {normalized(first), normalized(second)}};
    }
  }
  return std::nullopt;
}

// The corners moved outwards, so that each side moves by `distance` in the plane of its triangle.
[[nodiscard]] std::array<abut_vec3, 4> grown(const Quad& quad, double distance) {
  std::array<abut_vec3, 4> outwards{};
  for (std::size_t k = 0; k < 4; ++k) {
    const abut_vec3 side = unit_or_zero(subtract(quad.corners[(k + 1) % 4], quad.corners[k]));
    outwards[k] = cross(side, quad.normals[k == 1 || k == 2 ? 1 : 0]);
  }
  std::array<abut_vec3, 4> out{};
  for (std::size_t k = 0; k < 4; ++k) {
    const abut_vec3& before = outwards[(k + 3) % 4];
    const double miter = distance / std::max(1 + dot(before, outwards[k]), 2 / (longest_miter * longest_miter));
    out[k] = add(quad.corners[k], scale(add(before, outwards[k]), miter));
  }
  return out;
}

// A corner moved outwards in its plane, so that both edges that meet there move by `distance`.
[[nodiscard]] abut_vec3 grown(const abut_vec3& corner, const abut_vec3& next, const abut_vec3& previous,
                              double distance) {
  const abut_vec3 a = unit_or_zero(subtract(next, corner));
  const abut_vec3 b = unit_or_zero(subtract(previous, corner));
  const double sine = length(cross(a, b));
  const double miter = distance * std::min(longest_miter, 1 / std::max(sine, 1e-9));
  return subtract(corner, scale(add(a, b), miter));
}

void write_corner(const abut_vec3& corner, const Space& space, std::size_t at, std::span<float> out) {
  const abut_vec3 local = subtract(corner, space.origin);
  out[at] = static_cast<float>(local.x);
  out[at + 1] = static_cast<float>(local.y);
  out[at + 2] = static_cast<float>(local.z);
}

[[nodiscard]] Corners grown(const Corners& corners, double distance) {
  return {grown(corners[0], corners[1], corners[2], distance), grown(corners[1], corners[2], corners[0], distance),
          grown(corners[2], corners[0], corners[1], distance)};
}

}  // namespace

abut_ray ray_at_triangle(const TriangleList& list, std::size_t triangle) {
  const Corners corners = corners_of(list, triangle);
  const abut_vec3 middle = scale(add(add(corners[0], corners[1]), corners[2]), 1.0 / 3);
  const abut_vec3 normal = unit_or_zero(area_vector(corners));
  const double away = length(subtract(corners[1], corners[0])) + length(subtract(corners[2], corners[0]));
  // Without an area there is no front; its corners lie on the borders of faces.
  if (largest_component(normal) == 0) return {middle, {1, 0, 0}, 0};
  return {add(middle, scale(normal, away)), scale(normal, -1), infinity};
}

void add_planes(const TriangleList& list, Surface& out) {
  out.reserve(out.size() + list.indices.size() / 3);
  for (std::size_t i = 0; i < list.indices.size() / 3; ++i) {
    const Corners corners = corners_of(list, i);
    const abut_vec3 normal = unit_or_zero(area_vector(corners));
    out.push_back({normal, dot(normal, corners[0])});
  }
}

void write_outlines(const TriangleList& list, const Space& space, Outlines outlines, std::span<float> out) {
  const double distance = growth * 0x1p-24 * space.extent;
  std::size_t at = 0;
  const auto write = [&](const Corners& corners) {
    for (const abut_vec3& corner : corners) write_corner(corner, space, std::exchange(at, at + 3), out);
  };
  for (std::size_t i = 0; i < list.indices.size() / 3; ++i) {
    const Corners corners = corners_of(list, i);
    const bool has_area = largest_component(area_vector(corners)) != 0;
    const Corners exact = has_area ? corners : Corners{corners[0], corners[0], corners[0]};
    if (outlines == Outlines::both) write(exact);
    write(has_area ? grown(corners, distance) : exact);
  }
}

bool is_paired(const TriangleList& list) {
  const std::size_t count = list.indices.size() / 3;
  if (count == 0 || count % 2 != 0) return false;
  for (std::size_t i = 0; i < count / 2; ++i) {
    if (!quad_of(list, i)) return false;
  }
  return true;
}

bool is_steep(const TriangleList& list) {
  for (std::size_t i = 0; i < list.indices.size() / 6; ++i) {
    const std::optional<Quad> quad = quad_of(list, i);
    if (quad && dot(quad->normals[0], quad->normals[1]) < least_fold_cosine) return true;
  }
  return false;
}

void write_quads(const TriangleList& list, const Space& space, std::span<float> out) {
  const double distance = growth * 0x1p-24 * space.extent;
  for (std::size_t i = 0; i < list.indices.size() / 6; ++i) {
    const std::optional<Quad> quad = quad_of(list, i);
    const std::array<abut_vec3, 4> corners = quad ? grown(*quad, distance) : std::array<abut_vec3, 4>{};
    for (std::size_t k = 0; k < 4; ++k) write_corner(corners[k], space, 12 * i + 3 * k, out);
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
