module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
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

[[nodiscard]] abut_vec3 unit_or_zero(const abut_vec3& v) {
  return largest_component(v) == 0 ? v : normalized(v);
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

}  // namespace

void add_planes(const TriangleList& list, Surface& out) {
  out.reserve(out.size() + list.indices.size() / 3);
  for (std::size_t i = 0; i < list.indices.size() / 3; ++i) {
    const Corners corners = corners_of(list, i);
    const abut_vec3 normal = unit_or_zero(area_vector(corners));
    out.push_back({normal, dot(normal, corners[0])});
  }
}

void write_outlines(const TriangleList& list, const Space& space, std::span<float> out) {
  const double distance = growth * 0x1p-24 * space.extent;
  for (std::size_t i = 0; i < list.indices.size() / 3; ++i) {
    const Corners corners = corners_of(list, i);
    const bool has_area = largest_component(area_vector(corners)) != 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const abut_vec3 moved =
          has_area ? grown(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3], distance) : corners[0];
      const abut_vec3 local = subtract(moved, space.origin);
      const std::size_t at = 9 * i + 3 * k;
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
