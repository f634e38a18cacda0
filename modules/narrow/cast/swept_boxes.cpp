// SPDX-License-Identifier: Apache-2.0
module abut.narrow.cast.swept_boxes;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cast.linear_cast;

namespace abut {
namespace {

// The common stretch of all axes, up to four each time. Along an axis the centre of b is at `offset` and moves by
// `speed`. The boxes overlap where the magnitude of its place is at most `reach`.
struct CommonStretch {
  Lanes enter = all_lanes(-infinity), leave = all_lanes(infinity);

  [[gnu::always_inline]] inline void narrow(Lanes offset, Lanes speed, Lanes reach) {
    const Lanes inverse = all_lanes(1) / speed;
    const Lanes first = (-reach - offset) * inverse, last = (reach - offset) * inverse;
    enter = maximum(enter, minimum(first, last));
    leave = minimum(leave, maximum(first, last));
  }
};

}  // namespace

Passage passage_of_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab, const LinearMotion& motion,
                         Real slack) {
  const Lanes a = lanes_of(half_a), b = lanes_of(half_b);
  const LaneMatrix rows = LaneMatrix::rows_of(ab.rotation), columns = LaneMatrix::columns_of(ab.rotation);
  const LaneMatrix wide_rows{absolute(rows.x), absolute(rows.y), absolute(rows.z)};
  const LaneMatrix wide_columns{absolute(columns.x), absolute(columns.y), absolute(columns.z)};
  const Vec3 &at = ab.position, &by = motion.direction;
  const Lanes centre = lanes_of(at), speed = lanes_of(by), near = all_lanes(slack);
  CommonStretch common;
  common.narrow(centre, speed, a + wide_columns * b + near);
  common.narrow(rows * centre, rows * speed, b + wide_rows * a + near);
  // Across one edge of a and each edge of b, in a lane. Along the two other axes of a this axis has the components -q
  // and p. What of b reaches along it are minors of p and q.
  const auto across = [&](Lanes p, Lanes q, Real half_p, Real half_q, Real at_p, Real at_q, Real by_p, Real by_q) {
    const Lanes square = multiply_add(p, p, q * q);
    const Lanes of_a = multiply_add(absolute(q), all_lanes(half_p), absolute(p) * all_lanes(half_q));
    const Lanes to_next = absolute(multiply_add(p, q.yzxw, -(q * p.yzxw)));
    const Lanes to_last = absolute(multiply_add(p, q.zxyw, -(q * p.zxyw)));
    const Lanes of_b = multiply_add(b.yzxw, to_next, b.zxyw * to_last);
    const Lanes reach = multiply_add(near, __builtin_elementwise_sqrt(square), of_a + of_b);
    common.narrow(multiply_add(p, all_lanes(at_q), q * all_lanes(-at_p)),
                  multiply_add(p, all_lanes(by_q), q * all_lanes(-by_p)),
                  square > slender_square ? reach : all_lanes(infinity));
  };
  across(rows.y, rows.z, half_a.y, half_a.z, at.y, at.z, by.y, by.z);
  across(rows.z, rows.x, half_a.z, half_a.x, at.z, at.x, by.z, by.x);
  across(rows.x, rows.y, half_a.x, half_a.y, at.x, at.y, by.x, by.y);
  return {largest(common.enter), -largest(-common.leave)};
}

}  // namespace abut
