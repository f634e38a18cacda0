// SPDX-License-Identifier: Apache-2.0
// Rotations and rigid placements.
export module abut.math.pose;
import abut.core.standard;
import abut.math.vec3;

export namespace abut {

struct Quat {
  Real w, x, y, z;
};

[[nodiscard]] inline std::optional<Quat> normalized(const Quat& q) {
  const Real square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  if (!(square > 0) || !std::isfinite(square)) {
    return std::nullopt;
  }
  const Real s = 1 / std::sqrt(square);
  return Quat{s * q.w, s * q.x, s * q.y, s * q.z};
}

// A rotation matrix by its columns: the images of the axes.
struct Rotation {
  Vec3 x, y, z;

  [[nodiscard]] static inline constexpr Rotation identity() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

  // The matrix of a quaternion of any positive length: dividing by the square of the length instead
  // of normalising first saves a rounding.
  [[nodiscard]] static inline Rotation from(const Quat& q) {
    const Real s = 2 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    const Real xx = s * q.x * q.x, yy = s * q.y * q.y, zz = s * q.z * q.z;
    const Real xy = s * q.x * q.y, xz = s * q.x * q.z, yz = s * q.y * q.z;
    const Real wx = s * q.w * q.x, wy = s * q.w * q.y, wz = s * q.w * q.z;
    return {{1 - yy - zz, xy + wz, xz - wy}, {xy - wz, 1 - xx - zz, yz + wx}, {xz + wy, yz - wx, 1 - xx - yy}};
  }

  [[nodiscard]] inline constexpr Vec3 operator*(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
  // The inverse rotation applied to v.
  [[nodiscard]] inline constexpr Vec3 undo(const Vec3& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  [[nodiscard]] inline constexpr Rotation operator*(const Rotation& b) const {
    return {*this * b.x, *this * b.y, *this * b.z};
  }
  [[nodiscard]] inline constexpr Rotation inverse() const {
    return {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}};
  }
};

// Maps local points p to rotation * p + position.
struct Pose {
  Rotation rotation;
  Vec3 position;

  [[nodiscard]] static inline constexpr Pose identity() { return {Rotation::identity(), {0, 0, 0}}; }

  [[nodiscard]] inline constexpr Vec3 operator*(const Vec3& p) const { return rotation * p + position; }
  [[nodiscard]] inline constexpr Vec3 undo(const Vec3& p) const { return rotation.undo(p - position); }
  [[nodiscard]] inline constexpr Pose operator*(const Pose& b) const {
    return {rotation * b.rotation, rotation * b.position + position};
  }
  [[nodiscard]] inline constexpr Pose inverse() const {
    const Rotation back = rotation.inverse();
    return {back, -(back * position)};
  }
};

}  // namespace abut
