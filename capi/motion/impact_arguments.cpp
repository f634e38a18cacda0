// SPDX-License-Identifier: Apache-2.0
#include "motion/impact_arguments.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.motion.paths.path;
import abut.motion.time_of_impact;

namespace abut::capi {

static_assert(static_cast<abut_impact_state>(ImpactState::apart) == ABUT_IMPACT_APART);
static_assert(static_cast<abut_impact_state>(ImpactState::touches) == ABUT_IMPACT_TOUCHES);
static_assert(static_cast<abut_impact_state>(ImpactState::starts_together) == ABUT_IMPACT_STARTS_TOGETHER);
static_assert(static_cast<abut_impact_state>(ImpactState::undecided) == ABUT_IMPACT_UNDECIDED);
static_assert(ImpactOptions{}.most_rounds == default_impact_options.most_rounds);

namespace {

Motion to_motion(const abut_movement& movement) {
  return {to_vec3(movement.velocity), to_vec3(movement.angular_velocity), to_vec3(movement.acceleration),
          to_vec3(movement.angular_acceleration)};
}

}  // namespace

abut_status read_impact_options(const abut_impact_options* given, ImpactQuery& out) {
  if (given == nullptr) {
    return ABUT_OK;
  }
  abut_status status = check_struct_size({"options"}, *given);
  status = status != ABUT_OK ? status : to_status(check_not_negative("options.tolerance", given->tolerance));
  status = status != ABUT_OK ? status : to_status(check_not_negative("options.margin", given->margin));
  status = status != ABUT_OK ? status : check_threads(given->threads);
  status = status != ABUT_OK ? status : check_reserved({"options"}, given->reserved);
  if (status == ABUT_OK && given->most_rounds == 0) {
    return refuse(ABUT_OUT_OF_RANGE, "options.most_rounds is 0; it must be positive");
  }
  out = {{given->tolerance, given->margin, given->most_rounds}, given->threads};
  return status;
}

abut_status read_path(const Where& where_pose, const abut_pose& pose, const Where& where, const abut_movement& movement,
                      double duration, std::optional<Path>& out) {
  abut_status status = check_pose(where_pose, pose);
  status = status != ABUT_OK ? status : check_position(where, ".velocity", movement.velocity);
  status = status != ABUT_OK ? status : check_position(where, ".angular_velocity", movement.angular_velocity);
  status = status != ABUT_OK ? status : check_position(where, ".acceleration", movement.acceleration);
  status = status != ABUT_OK ? status : check_position(where, ".angular_acceleration", movement.angular_acceleration);
  status = status != ABUT_OK ? status : check_position(where, ".centre", movement.centre);
  if (status != ABUT_OK) {
    return status;
  }
  const auto path = Path::along(to_pose(pose), to_vec3(movement.centre), to_motion(movement), duration);
  if (!path) {
    return refuse_field(where, path.error());
  }
  out = path.value();
  return ABUT_OK;
}

abut_impact from_impact(const Impact& found) {
  return {static_cast<abut_impact_state>(found.state),
          found.rounds,
          found.lower,
          found.upper,
          from_distance(found.contact),
          found.child_a,
          found.child_b};
}

}  // namespace abut::capi
