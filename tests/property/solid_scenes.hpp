// The scenes of scenes.hpp for solids whose distance no oracle knows beforehand: placed by their support points.
#pragma once

#include <vector>

#include "scenes.hpp"
#include "solids.hpp"

namespace property {

// Every scene once or more. Gaps of zero and more are exact but for rounding where the orientations are at random;
// elsewhere, and of overlaps, they are the separation along one direction, which the distance does not fall below.
[[nodiscard]] std::vector<Placement> solid_placements(const SolidSubject& a, const SolidSubject& b, Random& random);

}  // namespace property
