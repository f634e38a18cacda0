// SPDX-License-Identifier: Apache-2.0
// Where a point lies in a triangle.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

module abut.picking;
import :crossing;
import :entry;
import :source;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

using Weights = std::array<double, 3>;

// Of the corners of a triangle, at a point that is projected to its plane; none where it has no area.
[[nodiscard]] std::optional<Weights> weights_at(const std::array<abut_vec3, 3>& corners, const abut_vec3& point) {
  const abut_vec3 first = subtract(corners[1], corners[0]);
  const abut_vec3 second = subtract(corners[2], corners[0]);
  const abut_vec3 from = subtract(point, corners[0]);
  const abut_vec3 normal = cross(first, second);
  const double square = dot(normal, normal);
  if (!(square > 0)) return std::nullopt;
  const double of_second = dot(cross(from, second), normal) / square;
  const double of_third = dot(cross(first, from), normal) / square;
  return Weights{1 - of_second - of_third, of_second, of_third};
}

}  // namespace

abut_status Tracer::weigh(abut_geometry_id id, std::uint32_t face, const abut_vec3& point,
                          abut_barycentric& out) const {
  const std::uint32_t index = entry_in_slot(id.slot);
  if (index == nowhere || entries_[index].id.generation != id.generation) return ABUT_STALE_ID;
  const Entry& entry = entries_[index];
  const ShapeRecord& shape = shapes_[entry.shape];
  if (shape.triangle_count == 0) return ABUT_UNSUPPORTED;
  if (const abut_status status = make_crossed(shape); status != ABUT_OK) return status;
  const CrossedSurface& surface = *shape.crossed;
  const abut_vec3 local = to_local(entry.frame, point);
  bool is_there = false;
  double least_of_best = -infinity;
  const auto look_at = [&](std::uint32_t triangle) {
    is_there = true;
    const std::optional<Weights> weights = weights_at(surface.corners_of(triangle), local);
    // The triangle of the face that holds the point, or from which it is least far off.
    if (!weights || !(std::ranges::min(*weights) > least_of_best)) return;
    least_of_best = std::ranges::min(*weights);
    const std::size_t corner = 3 * std::size_t{triangle};
    const std::vector<std::uint32_t>& indices = surface.list.indices;
    out = {.triangle = triangle,
           .vertices = {indices[corner], indices[corner + 1], indices[corner + 2]},
           .weights = {(*weights)[0], (*weights)[1], (*weights)[2]}};
  };
  if (surface.faces.empty()) {
    if (face < surface.size()) look_at(face);
  } else {
    for (std::uint32_t i = 0; i < surface.size(); ++i) {
      if (surface.faces[i] == face) look_at(i);
    }
  }
  if (!is_there) return ABUT_INDEX_OUT_OF_RANGE;
  return least_of_best > -infinity ? ABUT_OK : ABUT_ZERO_VECTOR;
}

}  // namespace abut::picking
