// SPDX-License-Identifier: Apache-2.0
// Arguments of questions about shapes that move and turn, and their answers.
#ifndef ABUT_CAPI_IMPACT_ARGUMENTS_HPP
#define ABUT_CAPI_IMPACT_ARGUMENTS_HPP

#include "options.hpp"
#include "pairs/answers.hpp"

import abut.motion.paths.path;
import abut.motion.time_of_impact;

namespace abut::capi {

inline constexpr abut_impact_options default_impact_options{sizeof(abut_impact_options), 1024, 0, 0, 0, 0};

struct ImpactQuery {
  ImpactOptions options;
  std::uint32_t threads = default_impact_options.threads;
};
// Options that may be null.
[[nodiscard]] abut_status read_impact_options(const abut_impact_options* given, ImpactQuery& out);
[[nodiscard]] abut_status read_path(const Where& where_pose, const abut_pose& pose, const Where& where,
                                    const abut_movement& movement, double duration, std::optional<Path>& out);

[[nodiscard]] abut_impact from_impact(const Impact& found);

}  // namespace abut::capi

#endif
