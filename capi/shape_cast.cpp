// SPDX-License-Identifier: Apache-2.0
// Two shapes that move.
#include "options.hpp"
#include "query_arguments.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape.shape_cast;
import abut.pairs.any_shape;

using namespace abut::capi;

namespace {

abut_status read_options(const abut_query_options* options, abut::QuerySettings& settings) {
  if (options == nullptr) {
    return ABUT_OK;
  }
  abut_status status = check_struct_size({"options"}, *options);
  status = status != ABUT_OK ? status
                             : check_value({"options"}, ".algorithm", options->algorithm, ABUT_ALGORITHM_LIBCCD_MPR);
  status =
      status != ABUT_OK ? status : to_status(abut::check_not_negative("options.error_bound", options->error_bound));
  status = status != ABUT_OK ? status : to_status(abut::check_not_negative("options.margin", options->margin));
  if (status == ABUT_OK && options->algorithm != ABUT_ALGORITHM_AUTO) {
    return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + std::to_string(options->algorithm) +
                                        "; moving shapes have no other way than ABUT_ALGORITHM_AUTO");
  }
  if (status == ABUT_OK) {
    settings.error_bound = options->error_bound;
    settings.margin = options->margin;
  }
  return status;
}

struct Moving {
  abut_pose pose;
  abut_vec3 displacement;
};

abut_status check_moving(std::string_view pose_name, std::string_view displacement_name, const Moving& moving) {
  const abut_status status = check_pose({pose_name}, moving.pose);
  return status != ABUT_OK ? status : check_position({displacement_name}, "", moving.displacement);
}

abut_status cast(const abut::AnyShape& a, const Moving& of_a, const abut::AnyShape& b, const Moving& of_b,
                 const abut_query_options* options, abut_cast_hit* hit, std::uint32_t* found) {
  abut::QuerySettings settings;
  abut_status status = check_moving("pose_a", "displacement_a", of_a);
  status = status != ABUT_OK ? status : check_moving("pose_b", "displacement_b", of_b);
  status = status != ABUT_OK ? status : read_options(options, settings);
  if (status != ABUT_OK) {
    return status;
  }
  std::optional<abut::ShapeCastHit> met;
  const abut::Outcome outcome = abut::cast_shapes(a, to_pose(of_a.pose), to_vec3(of_a.displacement), b,
                                                  to_pose(of_b.pose), to_vec3(of_b.displacement), settings, 1, met);
  if (outcome != abut::Outcome::ok) {
    return refuse(ABUT_UNSUPPORTED, "there is no algorithm for " + std::string(abut::kind_name(a.index())) + " and " +
                                        std::string(abut::kind_name(b.index())));
  }
  if (met) {
    *hit = from_cast({}, *met);
  }
  *found = met ? 1 : 0;
  return ABUT_OK;
}

}  // namespace

abut_status abut_pair_cast(const abut_shape* a, const abut_pose* pose_a, const abut_vec3* displacement_a,
                           const abut_shape* b, const abut_pose* pose_b, const abut_vec3* displacement_b,
                           const abut_query_options* options, abut_cast_hit* hit, uint32_t* found) {
  return guard([&] {
    const abut_status status = check_none_null<8>({{{"a", a},
                                                    {"pose_a", pose_a},
                                                    {"displacement_a", displacement_a},
                                                    {"b", b},
                                                    {"pose_b", pose_b},
                                                    {"displacement_b", displacement_b},
                                                    {"hit", hit},
                                                    {"found", found}}});
    return status != ABUT_OK ? status
                             : cast(shape_of(a), {*pose_a, *displacement_a}, shape_of(b), {*pose_b, *displacement_b},
                                    options, hit, found);
  });
}
