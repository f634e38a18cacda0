module;

#include <abut/picking.h>

#include "embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

module abut.picking;
import :hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

[[nodiscard]] abut_vec3 vertex_of(const TriangleList& list, std::uint32_t index) {
  const std::size_t at = 3 * static_cast<std::size_t>(index);
  return {list.xyz[at], list.xyz[at + 1], list.xyz[at + 2]};
}

}  // namespace

abut_vec3 normal_of_triangle(const TriangleList& list, const std::array<std::uint32_t, 3>& corners) {
  const abut_vec3 a = vertex_of(list, corners[0]);
  const abut_vec3 area = cross(subtract(vertex_of(list, corners[1]), a), subtract(vertex_of(list, corners[2]), a));
  return largest_component(area) == 0 ? area : normalized(area);
}

// Signed volumes of the ray with the three edges (Plücker); 0 on an edge, which both neighbours count.
std::optional<double> crossing_of_triangle(const TriangleList& list, const std::array<std::uint32_t, 3>& corners,
                                           const abut_vec3& origin, const abut_vec3& direction) {
  const abut_vec3 a = subtract(vertex_of(list, corners[0]), origin);
  const abut_vec3 b = subtract(vertex_of(list, corners[1]), origin);
  const abut_vec3 c = subtract(vertex_of(list, corners[2]), origin);
  const double u = dot(direction, cross(b, c));
  const double v = dot(direction, cross(c, a));
  const double w = dot(direction, cross(a, b));
  const double sum = u + v + w;
  const double blur = 1e-13 * (std::fabs(u) + std::fabs(v) + std::fabs(w));
  const bool is_inside = std::min({u, v, w}) >= -blur || std::max({u, v, w}) <= blur;
  if (!is_inside || sum == 0) return std::nullopt;
  const double distance = (u * dot(a, direction) + v * dot(b, direction) + w * dot(c, direction)) / sum;
  return std::isfinite(distance) ? std::optional(distance) : std::nullopt;
}

void merge_crossings(std::vector<AllHits::Crossing>& crossings, const abut_vec3& direction,
                     std::vector<abut_pick>& out) {
  std::ranges::sort(crossings, [](const AllHits::Crossing& a, const AllHits::Crossing& b) {
    if (a.pick.distance != b.pick.distance) return a.pick.distance < b.pick.distance;
    if (a.pick.geometry.slot != b.pick.geometry.slot) return a.pick.geometry.slot < b.pick.geometry.slot;
    return a.pick.feature.index < b.pick.feature.index;
  });
  out.clear();
  for (const AllHits::Crossing& crossing : crossings) {
    const bool enters = dot(crossing.pick.normal, direction) < 0;
    // The last crossing of the same geometry decides: a surface is not entered twice in a row there.
    const auto last = std::find_if(out.rbegin(), out.rend(), [&](const abut_pick& pick) {
      return pick.geometry.slot == crossing.pick.geometry.slot;
    });
    const bool repeats = last != out.rend() && (dot(last->normal, direction) < 0) == enters &&
                         crossing.pick.distance - last->distance <= crossing.blur;
    if (!repeats) out.push_back(crossing.pick);
  }
}

}  // namespace abut::picking
