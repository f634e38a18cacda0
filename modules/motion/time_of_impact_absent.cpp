// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `motion`: nobody asks, since the C interface asks first.
module abut.motion.time_of_impact;
import abut.capability;
import abut.core.standard;
import abut.motion.path;
import abut.pairs.registry;

namespace abut {

bool has_motion() { return false; }

Outcome time_of_impact(const AnyShape& /*a*/, const Path& /*path_a*/, const AnyShape& /*b*/, const Path& /*path_b*/,
                       const ImpactOptions& /*options*/, Impact& /*out*/) {
  return Outcome::unsupported;
}

}  // namespace abut
