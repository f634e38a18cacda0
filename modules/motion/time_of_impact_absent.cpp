// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `motion`.
module abut.motion.time_of_impact;
import abut.capability;

namespace abut {

Outcome time_of_impact(const MovingShape& /*a*/, const MovingShape& /*b*/, const ImpactOptions& /*options*/,
                       Impact& /*out*/) {
  return Outcome::unsupported;
}

}  // namespace abut
