// SPDX-License-Identifier: Apache-2.0
// Places two solids where a question is hard: faces to faces, a hair apart, one in the other.
#pragma once
#include "oracle/quad.hpp"
#include "oracle/solid.hpp"
#include "scene.hpp"

namespace bench {

// A direction out of a flat or straight side in the local frame; of a sphere any.
[[nodiscard]] oracle::Vec side_normal(const Solid& solid, Random& random);

// As unit quaternions: the turn that takes the unit vector u to v, and a turn by an angle about any axis.
[[nodiscard]] Quaternion turn_from(const oracle::Vec& u, const oracle::Vec& v);
[[nodiscard]] Quaternion small_turn(double angle, Random& random);

// Places the second solid so that the furthest features of both along n face each other, with a gap along n. n is a
// unit direction of the world. What is within the slack, an angle, of furthest counts with its middle.
[[nodiscard]] Placement facing(const oracle::Solid& a, const Placement& pose_a, const oracle::Solid& b,
                               const Quaternion& turn_b, const oracle::Vec& n, double gap, double slack);

// Where the second solid has to be so that a random point inside of it meets one inside of the first.
[[nodiscard]] Placement meeting(const oracle::Solid& a, const Placement& pose_a, const oracle::Solid& b,
                                const Quaternion& turn_b, Random& random);

}  // namespace bench
