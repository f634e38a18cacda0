// SPDX-License-Identifier: Apache-2.0
// Closest points of two segments in closed form (Ericson, "Real-Time Collision Detection", 2005, 5.1.9).
export module abut.narrow.apart.segment_cores;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.box_cores;

export namespace abut {

// A segment on both sides of a centre, along a direction of length one.
struct CentredSegment {
  Lanes axis;
  Real half_length;
};

[[nodiscard]] [[gnu::always_inline]] inline Lanes cross(Lanes a, Lanes b) {
  return multiply_add(a, b.yzxw, -(a.yzxw * b)).yzxw;
}

// The segment a around the origin and b around `centre`. `square`: of the sine between both, which is not zero.
[[nodiscard]] [[gnu::always_inline]] inline NearPoints near_points_of_segments(const CentredSegment& a,
                                                                               const CentredSegment& b, Lanes centre,
                                                                               Real square) {
  const auto limited = [](Real s, Real most) { return s < -most ? -most : s > most ? most : s; };
  const Real cosine = dot(a.axis, b.axis), from_a = dot(a.axis, centre), from_b = dot(b.axis, centre);
  // Between the lines, then each point under the other one.
  const Real start = limited((from_a - cosine * from_b) / square, a.half_length);
  const Real t = limited(start * cosine - from_b, b.half_length);
  const Real s = limited(t * cosine + from_a, a.half_length);
  [[clang::uninitialized]] NearPoints near;
  near.on_a = a.axis * s;
  near.on_b = multiply_add(b.axis, all_lanes(t), centre);
  near.between = near.on_b - near.on_a;
  near.square = dot(near.between, near.between);
  // What the ends of both would reach beyond the points.
  const Real slope_a = dot(a.axis, near.between), slope_b = dot(b.axis, near.between);
  near.gap = (a.half_length * std::fabs(slope_a) - slope_a * s) + (b.half_length * std::fabs(slope_b) + slope_b * t);
  near.rounds = 1;
  return near;
}

}  // namespace abut
