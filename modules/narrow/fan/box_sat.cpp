// SPDX-License-Identifier: Apache-2.0
module abut.narrow.fan.box_sat;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.sat;

namespace abut {
namespace {

constexpr std::uint32_t face_axes = 6, all_axes = 15;

struct Best {
  Real value;
  int axis;
};
// The largest of the first three lanes, the first one among equals.
[[nodiscard]] inline Best best_of(Lanes values) {
  Best best{values[0], 0};
  best = values[1] > best.value ? Best{values[1], 1} : best;
  return values[2] > best.value ? Best{values[2], 2} : best;
}

[[nodiscard]] inline const Vec3& column(const Rotation& r, int axis) { return axis == 0 ? r.x : axis == 1 ? r.y : r.z; }
[[nodiscard]] inline Vec3 unit(int axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}
// Of two symmetric bodies the side that faces the other one is the better one.
[[nodiscard]] inline Vec3 toward(const Vec3& n, const Vec3& apart) { return dot(n, apart) < 0 ? -n : n; }
[[nodiscard]] inline CoreFeature face_of(int axis, bool is_positive) {
  return core_face(static_cast<std::size_t>(2 * axis) + (is_positive ? 1 : 0));
}

}  // namespace

SatResult sat_of_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab, Real noise, Real limit) {
  const Lanes a = lanes_of(half_a), b = lanes_of(half_b), centre = lanes_of(ab.position);
  const LaneMatrix rows = LaneMatrix::rows_of(ab.rotation);
  const LaneMatrix columns = LaneMatrix::columns_of(ab.rotation);
  const LaneMatrix wide_rows{absolute(rows.x), absolute(rows.y), absolute(rows.z)};
  const LaneMatrix wide_columns{absolute(columns.x), absolute(columns.y), absolute(columns.z)};

  const Lanes offsets_a = absolute(centre), offsets_b = absolute(rows * centre);
  const Lanes of_a = offsets_a - a - wide_columns * b, of_b = offsets_b - b - wide_rows * a;
  // Of axes that are equal within the noise the one along which the centres are furthest apart, whichever
  // box it belongs to, so that the order of the boxes does not matter.
  const Real least = best_of(maximum(of_a, of_b)).value - noise;
  const Best from_a = best_of(of_a >= all_lanes(least) ? offsets_a : Lanes(-infinity));
  const Best from_b = best_of(of_b >= all_lanes(least) ? offsets_b : Lanes(-infinity));
  SatResult best{0, {0, 0, 0}, face_axes, {}};
  if (from_b.value > from_a.value) {
    const Vec3& n = column(ab.rotation, from_b.axis);
    const bool is_opposite = dot(n, ab.position) < 0;
    best.separation = of_b[from_b.axis];
    best.normal = is_opposite ? -n : n;
    best.features.b = face_of(from_b.axis, is_opposite);
  } else {
    best.separation = of_a[from_a.axis];
    best.normal = toward(unit(from_a.axis), ab.position);
    best.features.a = face_of(from_a.axis, !(ab.position[from_a.axis] < 0));
  }
  if (best.separation > limit) {
    return best;
  }

  // The axis across edge i of a and edge j of b, in lane j, has the components -q and p along the two
  // other axes of a. What of b reaches along it are minors of p and q: they stay exact for edges that are
  // nearly parallel, where entries of the matrix would drown in rounding.
  const auto across = [&](Lanes p, Lanes q, Lanes wide_p, Lanes wide_q, Real half_p, Real half_q, Real at_p,
                          Real at_q) {
    const Lanes square = multiply_add(p, p, q * q);
    const Lanes offset = absolute(multiply_add(p, all_lanes(at_q), q * all_lanes(-at_p)));
    const Lanes of_first = multiply_add(wide_q, all_lanes(half_p), wide_p * all_lanes(half_q));
    const Lanes to_next = absolute(multiply_add(p, q.yzxw, -(q * p.yzxw)));
    const Lanes to_last = absolute(multiply_add(p, q.zxyw, -(q * p.zxyw)));
    const Lanes of_second = multiply_add(b.yzxw, to_next, b.zxyw * to_last);
    return square > parallel_square ? (offset - of_first - of_second) / __builtin_elementwise_sqrt(square)
                                    : Lanes(-infinity);
  };
  const Vec3& t = ab.position;
  const Lanes with_x = across(rows.y, rows.z, wide_rows.y, wide_rows.z, half_a.y, half_a.z, t.y, t.z);
  const Lanes with_y = across(rows.z, rows.x, wide_rows.z, wide_rows.x, half_a.z, half_a.x, t.z, t.x);
  const Lanes with_z = across(rows.x, rows.y, wide_rows.x, wide_rows.y, half_a.x, half_a.y, t.x, t.y);
  best.axes = all_axes;
  const Lanes largest = maximum(maximum(with_x, with_y), with_z);
  const Best edges = best_of(largest);
  if (edges.value > best.separation + noise) {
    const int axis = with_x[edges.axis] == edges.value ? 0 : with_y[edges.axis] == edges.value ? 1 : 2;
    best.separation = edges.value;
    best.features = {core_edge(static_cast<std::size_t>(axis)), core_edge(static_cast<std::size_t>(edges.axis))};
    const Vec3 edge_a = unit(axis), edge_b = column(ab.rotation, edges.axis), n = cross(edge_a, edge_b);
    best.normal = toward(unit_across_edges(edge_a, edge_b, n, squared_norm(n)), t);
  }
  return best;
}

}  // namespace abut
