// SPDX-License-Identifier: Apache-2.0
// The scenes of scenes.hpp for solids whose distance no oracle knows beforehand: placed by their support points.
#pragma once

#include <vector>

#include "scenes.hpp"
#include "solids.hpp"

namespace property {

// Every scene once or more. Gaps of zero and more are exact but for rounding where the orientations are at random;
// elsewhere, and of overlaps, they are the separation along one direction, which the distance does not fall below.
[[nodiscard]] std::vector<Placement> solid_placements(const SolidSubject& a, const SolidSubject& b, Random& random);

// Puts b so that the middles of the features furthest along n face each other, `gap` apart along n. The slack, an
// angle, says what ties for the furthest.
[[nodiscard]] Placement facing(const std::string& scene, const SolidSubject& a, const abut_pose& pose_a,
                               const SolidSubject& b, const abut_quat& turn_b, const oracle::Vec& n, double gap,
                               double slack);

// A normal or an axis in the local frame, either way.
[[nodiscard]] oracle::Vec main_direction(const SolidSubject& subject, Random& random);

}  // namespace property
