// SPDX-License-Identifier: Apache-2.0
// Springs, bonds and the mouse of response.h.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"

#include <cstdint>
#include <utility>

#include "defaults.hpp"

import abut.response;

namespace {

using abut::capi::guarded;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::Anchor;
using abut::response::Link;

constexpr abut_link_options usual_link{.struct_size = sizeof(abut_link_options),
                                       .reserved = 0,
                                       .a = {},
                                       .b = {},
                                       .point_a = {},
                                       .point_b = {},
                                       .stiffness = 0,
                                       .damping = 0,
                                       .most_force = 0,
                                       .break_force = 0};

[[nodiscard]] abut_status refuse_link(std::uint64_t link) noexcept {
  return refuse(ABUT_STALE_ID, "link", static_cast<double>(link), "the link has ended");
}

// A point of the world, in the frame of its part, which is woken.
[[nodiscard]] abut_status fasten(abut_universe* universe, abut_part_id part, const abut_vec3& point, Anchor& out) {
  out = {.part = part, .point = point};
  if (part.slot == 0) return ABUT_OK;
  abut_pose pose;
  abut_status status = abut_part_pose(universe, part, &pose);
  if (status != ABUT_OK) return status;
  using namespace abut::response;
  out.point = times(transposed(matrix_of(normalized(pose.orientation))), subtract(point, pose.position));
  abut_motion motion = 0;
  status = abut_part_motion(universe, part, &motion);
  return status == ABUT_OK && motion == ABUT_MOTION_DYNAMIC ? abut_part_wake(universe, part) : status;
}

// At most one of them is null, for the world.
[[nodiscard]] abut_status check_parts(const abut_universe* universe, abut_part_id a, abut_part_id b) {
  const auto is_null = [](abut_part_id part) { return part.slot == 0 && part.generation == 0; };
  const auto is_there = [&](abut_part_id part) {
    abut_pose pose;
    return abut_part_pose(universe, part, &pose) == ABUT_OK;
  };
  if (!is_null(a) && !is_there(a)) return abut::capi::refuse_stale("options.a", a);
  if ((!is_null(b) || is_null(a)) && !is_there(b)) return abut::capi::refuse_stale("options.b", b);
  return ABUT_OK;
}

}  // namespace

void abut_link_options_init(abut_link_options* options, uint32_t struct_size) {
  abut::capi::fill_defaults(usual_link, struct_size, options);
}

abut_status abut_response_add_link(abut_response* response, const abut_link_options* options, std::uint64_t* out) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (options == nullptr) return refuse_null("options");
    if (out == nullptr) return refuse_null("out");
    if (const abut_status status = abut::capi::check_options(*options); status != ABUT_OK) return status;
    if (const abut_status status = check_parts(its.universe.get(), options->a, options->b); status != ABUT_OK)
      return status;
    if (options->a.slot == options->b.slot) {
      return refuse(ABUT_INVALID_ARGUMENT, "options.b.slot", options->b.slot,
                    "a link joins two parts, or a part and the world");
    }
    const auto is_body = [&](abut_part_id part) { return its.simulation.mass_of(part).has_value(); };
    if (!is_body(options->a) && !is_body(options->b)) {
      return refuse(ABUT_INVALID_ARGUMENT, "options.b.slot", options->b.slot,
                    "one of the parts of a link must be a body of this response");
    }
    Link link;
    link.stiffness = options->stiffness;
    link.damping = options->damping;
    link.most_force = options->most_force;
    link.break_force = options->break_force;
    abut_status status = fasten(its.universe.get(), options->a, options->point_a, link.a);
    if (status == ABUT_OK) status = fasten(its.universe.get(), options->b, options->point_b, link.b);
    if (status == ABUT_OK) *out = its.simulation.add_link(link);
    return status;
  });
}

abut_status abut_response_move_link(abut_response* response, std::uint64_t link, const abut_vec3* point_a) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (point_a == nullptr) return refuse_null("point_a");
    if (const abut_status status = abut::capi::check_vector(*point_a, "point_a"); status != ABUT_OK) return status;
    Link* const found = its.simulation.find_link(link);
    if (found == nullptr) return refuse_link(link);
    if (found->a.part.slot != 0) {
      return refuse(ABUT_INVALID_ARGUMENT, "link", static_cast<double>(link),
                    "its point a is one of a part; only a point of the world can be moved");
    }
    if (const abut_status status = abut_part_wake(its.universe.get(), found->b.part); status != ABUT_OK) return status;
    found->a.point = *point_a;
    return ABUT_OK;
  });
}

abut_status abut_response_link_force(const abut_response* response, std::uint64_t link, abut_vec3* out) {
  if (response == nullptr) return refuse_null("response");
  if (out == nullptr) return refuse_null("out");
  const Link* const found = response->simulation.find_link(link);
  if (found == nullptr) return refuse_link(link);
  *out = found->force;
  return ABUT_OK;
}

abut_status abut_response_remove_link(abut_response* response, std::uint64_t link) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (its.simulation.find_link(link) == nullptr) return refuse_link(link);
    its.simulation.remove_link(link);
    return ABUT_OK;
  });
}

abut_status abut_response_release(abut_response* response, abut_geometry_id a, abut_geometry_id b) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (its.simulation.release(a, b)) return ABUT_OK;
    for (const auto& [name, geometry] : {std::pair("a", a), std::pair("b", b)}) {
      abut_pose pose;
      if (abut_geometries_poses(its.universe.get(), &geometry, 1, &pose) == ABUT_STALE_ID)
        return abut::capi::refuse_stale(name, geometry);
    }
    return refuse(ABUT_STALE_ID, "b.slot", b.slot, "the two geometries have no bond");
  });
}
