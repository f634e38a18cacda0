// SPDX-License-Identifier: Apache-2.0
// Turns as vectors: an axis times an angle in radians. Nothing here calls a function of the platform, so that answers
// are the same bits everywhere.
export module abut.math.turn;
import abut.core.standard;
import abut.math.pose;
import abut.math.vec3;

export namespace abut {

// The turn from one orientation to another, which is at most half a turn. Exactly zero for equal orientations; lengths
// of the quaternions do not matter.
[[nodiscard]] Vec3 turn_between(const Quat& before, const Quat& after);

// A rotation as a quaternion.
[[nodiscard]] Quat quaternion_of(const Rotation& rotation);

// The rotation by a turn of at most 1,000 radians, within four units of rounding. Exactly the identity for no turn.
[[nodiscard]] Rotation rotation_by(const Vec3& turn);

}  // namespace abut
