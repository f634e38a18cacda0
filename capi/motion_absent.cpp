// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `motion`.
#include "guard.hpp"
#include "impact_options.hpp"

using namespace abut::capi;

void abut_impact_options_init(abut_impact_options* options, uint32_t struct_size) {
  fill_defaults(default_impact_options, struct_size, options);
}

abut_status abut_movement_between(const abut_pose* /*start*/, const abut_pose* /*end*/, const abut_vec3* /*centre*/,
                                  double /*duration*/, abut_movement* /*out*/) {
  return guard(refuse_motion);
}

abut_status abut_pair_time_of_impact(const abut_shape* /*a*/, const abut_pose* /*pose_a*/,
                                     const abut_movement* /*movement_a*/, const abut_shape* /*b*/,
                                     const abut_pose* /*pose_b*/, const abut_movement* /*movement_b*/,
                                     double /*duration*/, const abut_impact_options* /*options*/,
                                     abut_impact* /*out*/) {
  return guard(refuse_motion);
}

abut_status abut_pairs_time_of_impact(const abut_shape* /*a*/, const abut_pose* /*poses_a*/,
                                      const abut_movement* /*movements_a*/, const abut_shape* /*b*/,
                                      const abut_pose* /*poses_b*/, const abut_movement* /*movements_b*/,
                                      size_t /*count*/, double /*duration*/, const abut_impact_options* /*options*/,
                                      abut_impact* /*out*/) {
  return guard(refuse_motion);
}

abut_status abut_universe_impacts(const abut_universe* /*universe*/, const abut_step_impact** /*impacts*/,
                                  size_t* /*count*/) {
  return guard(refuse_motion);
}

abut_status abut_universe_advance_to_first_impact(abut_universe* /*universe*/, double /*dt*/,
                                                  abut_step_impact* /*out*/) {
  return guard(refuse_motion);
}

abut_status abut_universe_cast_movement(const abut_universe* /*universe*/, const abut_shape* /*shape*/,
                                        const abut_pose* /*pose*/, const abut_movement* /*movement*/,
                                        double /*duration*/, const abut_impact_options* /*options*/,
                                        const abut_query_filter* /*filter*/, abut_hit_mode /*mode*/,
                                        abut_impact_hit* /*hits*/, size_t /*capacity*/, size_t* /*count*/) {
  return guard(refuse_motion);
}

abut_status abut_universe_cast_movements(const abut_universe* /*universe*/, const abut_shape* const* /*shapes*/,
                                         const abut_pose* /*poses*/, const abut_movement* /*movements*/,
                                         size_t /*count*/, double /*duration*/, const abut_impact_options* /*options*/,
                                         const abut_query_filter* /*filter*/, abut_impact_hit* /*hits*/) {
  return guard(refuse_motion);
}
