// SPDX-License-Identifier: Apache-2.0
// Seeded placements of two shapes: the situations in which collision code goes wrong.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "subject.hpp"

namespace property {

using Random = std::mt19937_64;

struct Placement {
  std::string scene;
  abut_pose a;
  abut_pose b;
};

// Every scene once or more, for two shapes of which the oracle can tell the signed distance.
[[nodiscard]] std::vector<Placement> placements(const Subject& a, const Subject& b, Random& random);

// Apart only: above and beside the surface `a`.
[[nodiscard]] std::vector<Placement> placements_above(const Subject& a, const Subject& b, Random& random);

[[nodiscard]] abut_quat random_orientation(Random& random);
[[nodiscard]] abut_vec3 random_direction(Random& random);
[[nodiscard]] double between(Random& random, double low, double high);

[[nodiscard]] abut_vec3 rounded(const oracle::Vec& v);
[[nodiscard]] abut_vec3 moved(const abut_vec3& from, const abut_vec3& along, double distance);

// A turn by an angle about a unit axis.
[[nodiscard]] abut_quat about(const abut_vec3& axis, double angle);

// The pose that does `first`, then `second`, rounded once.
[[nodiscard]] abut_pose composed(const abut_pose& second, const abut_pose& first);

// Moves the pose of b along the oracle's normal until the signed distance is about `gap`.
[[nodiscard]] abut_pose moved_to_gap(const Subject& a, const abut_pose& pose_a, const Subject& b,
                                     const abut_pose& pose_b, double gap);

}  // namespace property
