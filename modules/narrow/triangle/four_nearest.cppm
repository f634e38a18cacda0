// SPDX-License-Identifier: Apache-2.0
// The points of four triangles that are nearest to a given one, without branches: each lane takes what belongs to the
// region that the given point lies over. Source: Ericson, "Real-Time Collision Detection", 2005, section 5.1.5.
export module abut.narrow.triangle.four_nearest;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.triangle.triangle_point;

export namespace abut {

struct FourNearest {
  Columns on, between;   // the nearest points, and from there to the given one
  Lanes square;          // of the distance
  LaneNumbers is_aside;  // on an edge or a corner, beyond doubt

  [[gnu::always_inline]] inline FourNearest(const FourTriangles& t, const Vec3& point) {
    const Columns p = Columns::all(point), ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a, bp = p - t.b, cp = p - t.c;
    const Lanes ab_a = dot(ab, ap), ac_a = dot(ac, ap), ab_b = dot(ab, bp), ac_b = dot(ac, bp), ab_c = dot(ab, cp),
                ac_c = dot(ac, cp);
    const Lanes over_a = ab_b * ac_c - ab_c * ac_b, over_b = ab_c * ac_a - ab_a * ac_c,
                over_c = ab_a * ac_b - ab_b * ac_a, to_c = ac_b - ab_b, to_b = ab_c - ac_c;
    // The shares of b and c in the point, times a common divisor. Of the regions that a point is in by rounding, the
    // last one that is written counts.
    Lanes of_b = over_b, of_c = over_c, divisor = over_a + over_b + over_c;
    is_aside = LaneNumbers(0);
    const auto take = [&](LaneNumbers is_there, Lanes b, Lanes c, Lanes d) {
      of_b = is_there ? b : of_b;
      of_c = is_there ? c : of_c;
      divisor = is_there ? d : divisor;
      is_aside |= is_there;
    };
    const Lanes zero = all_lanes(0), one = all_lanes(1);
    take((over_a <= zero) & (to_c >= zero) & (to_b >= zero), to_b, to_c, to_c + to_b);
    take((over_b <= zero) & (ac_a >= zero) & (ac_c <= zero), zero, ac_a, ac_a - ac_c);
    take((ac_c >= zero) & (ab_c <= ac_c), zero, one, one);
    take((over_c <= zero) & (ab_a >= zero) & (ab_b <= zero), ab_a, zero, ab_a - ab_b);
    take((ab_b >= zero) & (ac_b <= ab_b), one, zero, one);
    take((ab_a <= zero) & (ac_a <= zero), zero, zero, one);
    const Lanes share = one / divisor;
    on = t.a + (of_b * share) * ab + (of_c * share) * ac;
    between = p - on;
    square = dot(between, between);
    // Of slivers, shares may be rounding, or no numbers.
    const LaneNumbers is_settled = gap_beyond(t) <= proven_share * square;
    for (std::uint64_t open = ~bits_of(is_settled) & 15u; open != 0; open &= open - 1) {
      take_alone(t, point, static_cast<std::size_t>(std::countr_zero(open)));
    }
  }

  // How much nearer to the point than the point of the triangle the triangle may come, along the line between both and
  // times its length.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes gap_beyond(const FourTriangles& t) const {
    return maximum(maximum(dot(between, t.a - on), dot(between, t.b - on)),
                   maximum(dot(between, t.c - on), all_lanes(0)));
  }

 private:
  // No triangle comes nearer than its nearest point by more than this share.
  static constexpr Real proven_share = 1e-10;

  // A triangle by itself, where its nearest point was in doubt.
  [[gnu::noinline, gnu::cold]] void take_alone(const FourTriangles& t, const Vec3& point, std::size_t lane) {
    const Vec3 nearest = nearest_on(t[lane], point), way = point - nearest;
    on.x[lane] = nearest.x;
    on.y[lane] = nearest.y;
    on.z[lane] = nearest.z;
    between.x[lane] = way.x;
    between.y[lane] = way.y;
    between.z[lane] = way.z;
    square[lane] = squared_norm(way);
    is_aside[lane] = 0;
  }
};

}  // namespace abut
