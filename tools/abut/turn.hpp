// SPDX-License-Identifier: Apache-2.0
// Rotations about an axis by degrees, the same bits on every machine: sine and cosine by their series, since those of
// the system differ from one processor to the next.
#pragma once

#include "common/vector.hpp"

namespace cli {

/// The rotation about an axis that is not zero; counter-clockwise seen from where the axis points to.
[[nodiscard]] abut_quat turn_by(const abut_vec3& axis, double degrees);

/// First b, then a: the pose of b when b is given in the frame of a.
[[nodiscard]] abut_pose compose(const abut_pose& a, const abut_pose& b);

inline constexpr abut_pose identity_pose{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};

}  // namespace cli
