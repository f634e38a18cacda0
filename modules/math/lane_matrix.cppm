// SPDX-License-Identifier: Apache-2.0
// Rotations on vectors in lanes, and placements relative to each other.
export module abut.math.lane_matrix;
import abut.math.lanes;
import abut.math.pose;
import abut.math.vec3;

export namespace abut {

// A matrix by its columns.
struct LaneMatrix {
  Lanes x, y, z;
  [[nodiscard]] [[gnu::always_inline]] static inline LaneMatrix columns_of(const Rotation& r) {
    return {lanes_of(r.x), lanes_of(r.y), lanes_of(r.z)};
  }
  [[nodiscard]] [[gnu::always_inline]] static inline LaneMatrix rows_of(const Rotation& r) {
    return {Lanes{r.x.x, r.y.x, r.z.x, 0}, Lanes{r.x.y, r.y.y, r.z.y, 0}, Lanes{r.x.z, r.y.z, r.z.z, 0}};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Lanes operator*(Lanes v) const {
    return multiply_add(z, v.zzzz, multiply_add(y, v.yyyy, x * v.xxxx));
  }
  [[nodiscard]] [[gnu::always_inline]] inline Lanes operator*(const Vec3& v) const {
    return multiply_add(z, all_lanes(v.z), multiply_add(y, all_lanes(v.y), x * all_lanes(v.x)));
  }
  // The product plus an offset.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes apply(Lanes v, Lanes offset) const {
    return multiply_add(z, v.zzzz, multiply_add(y, v.yyyy, multiply_add(x, v.xxxx, offset)));
  }
  [[nodiscard]] [[gnu::always_inline]] inline Lanes apply(const Vec3& v, Lanes offset) const {
    return multiply_add(z, all_lanes(v.z), multiply_add(y, all_lanes(v.y), multiply_add(x, all_lanes(v.x), offset)));
  }
};

// The pose of b in the frame of a: the positions are subtracted first, so that far from the origin
// only the rounding of the given positions is left.
[[nodiscard]] [[gnu::always_inline]] inline Pose relative(const Pose& a, const Pose& b) {
  const LaneMatrix back = LaneMatrix::rows_of(a.rotation);
  return {{vec3_of(back * b.rotation.x), vec3_of(back * b.rotation.y), vec3_of(back * b.rotation.z)},
          vec3_of(back * (b.position - a.position))};
}

}  // namespace abut
