// SPDX-License-Identifier: Apache-2.0
// The order in which boxes of two trees may meet that move and turn.
export module abut.motion.impacts.motion_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.paths.path;
import abut.trees.volumes.eight_boxes;
import abut.trees.boxes.two_trees;

export namespace abut {

// Take an axis of one body. The gap between a box of it and one of the other is the least of those of corners. The way
// of each corner is straight but for a bend. So the gaps at both ends of a span tell until when the boxes are apart.
// After a share s of the span the gap is at least
//
//   begin - s (begin - end + half),   half = bend * length^2 / 2,
//
// and it is never below min(begin, end) - half / 4. The axis that tells most counts.
class MotionOrder {
 public:
  // `begin`, `end`: b in the frame of a. `bend_in_a`: of the ways of points of b in the frame of a, at most; so the
  // other one. Boxes meet that come as near as `slack`.
  MotionOrder(const Vec3& origin_a, const Vec3& origin_b, const Pose& begin, const Pose& end, const TimeSpan& span,
              Real bend_in_a, Real bend_in_b, Real slack)
      : origin_a_(origin_a),
        origin_b_(origin_b),
        begin_(origin_a, origin_b, begin),
        bend_in_a_(bend_in_a),
        bend_in_b_(bend_in_b),
        slack_(slack),
        end_(origin_a, origin_b, end),
        b_in_a_{begin, end},
        a_in_b_{begin.inverse(), end.inverse()},
        span_(span) {}

  // Lets the span end earlier, with b at `end` then. What meets later is of no interest.
  void end_at(Real time, const Pose& end) {
    span_.end = time;
    end_ = BoxAxes(origin_a_, origin_b_, end);
    b_in_a_[1] = end;
    a_in_b_[1] = end.inverse();
  }

  // Times before which boxes are apart; infinity where they are for the whole span. A box beyond all numbers meets at
  // the begin.
  [[nodiscard]] [[gnu::always_inline]] inline EightWays ways(const EightBoxes& eight, const OneBox& other,
                                                             bool are_of_b) const {
    return {ways_of_four(eight, 0, other, are_of_b), ways_of_four(eight, 1, other, are_of_b)};
  }
  [[nodiscard]] static inline Real way_of(Real limit) { return limit; }

  // The same for two triangles, along the normals of both.
  [[nodiscard]] Real way_of(const TriangleCorners& a, const TriangleCorners& b) const {
    const Real share = std::max(share_across(a, b, b_in_a_, half_bend(bend_in_a_)),
                                share_across(b, a, a_in_b_, half_bend(bend_in_b_)));
    return share < 1 ? span_.begin + (inward * span_.length()) * share : infinity;
  }

 private:
  static constexpr Real inward = 1 - 1e-12;

  [[nodiscard]] [[gnu::always_inline]] inline Lanes ways_of_four(const EightBoxes& eight, std::size_t four,
                                                                 const OneBox& other, bool are_of_b) const {
    struct Apart {
      Lanes between, reach;
    };
    [[clang::uninitialized]] std::array<Apart, 6> at_begin;
    begin_.for_each<Lanes>(eight, four, other, are_of_b, [&](int axis, Lanes between, Lanes reach) {
      at_begin[static_cast<std::size_t>(axis)] = {between, reach};
    });
    const Real half_in_a = half_bend(bend_in_a_), half_in_b = half_bend(bend_in_b_);
    Lanes share = all_lanes(0);
    end_.for_each<Lanes>(eight, four, other, are_of_b, [&](int axis, Lanes between, Lanes reach) {
      const Apart& first = at_begin[static_cast<std::size_t>(axis)];
      const Real half = (axis < 3) == are_of_b ? half_in_b : half_in_a;
      // The side on which the other box is; on the whole, where it changes sides.
      const LaneNumbers is_below = first.between + between < all_lanes(0);
      const Lanes b = (is_below ? -first.between : first.between) - first.reach - slack_;
      const Lanes e = (is_below ? -between : between) - reach - slack_;
      const Lanes lost = b - e + half;
      const LaneNumbers is_free = (minimum(b, e) > all_lanes(0.25 * half)) | (lost <= all_lanes(0));
      const Lanes reached = is_free ? all_lanes(infinity) : b / lost;
      const LaneNumbers tells_more = (reached > share) & (b > all_lanes(0));
      share = tells_more ? reached : share;
    });
    return share < all_lanes(1) ? span_.begin + (inward * span_.length()) * share : all_lanes(infinity);
  }

  // The share of the span for which a triangle is apart from the plane of another one, in whose frame it is placed.
  [[nodiscard]] Real share_across(const TriangleCorners& of_plane, const TriangleCorners& other,
                                  const std::array<Pose, 2>& places, Real half) const {
    const auto normal = UnitVec3::make(cross(of_plane[1] - of_plane[0], of_plane[2] - of_plane[0]));
    if (!normal) {
      return 0;
    }
    struct Heights {
      Real low = infinity, high = -infinity;
    };
    const auto heights_at = [&](const Pose& place) {
      Heights heights;
      for (const Vec3& corner : other) {
        const Real height = dot(*normal, place * corner - of_plane[0]);
        heights = {std::min(heights.low, height), std::max(heights.high, height)};
      }
      return heights;
    };
    const Heights first = heights_at(places[0]), last = heights_at(places[1]);
    const bool is_above = first.low > slack_;
    const Real b = (is_above ? first.low : -first.high) - slack_, e = (is_above ? last.low : -last.high) - slack_;
    if (!(b > 0)) {
      return 0;
    }
    const Real lost = b - e + half;
    return std::min(b, e) > 0.25 * half || lost <= 0 ? infinity : b / lost;
  }

  [[nodiscard]] inline Real half_bend(Real bend) const { return 0.5 * bend * span_.length() * span_.length(); }

  Vec3 origin_a_, origin_b_;
  BoxAxes begin_;
  Real bend_in_a_, bend_in_b_, slack_;
  BoxAxes end_;
  std::array<Pose, 2> b_in_a_, a_in_b_;  // at the begin and at the end
  TimeSpan span_;
};

}  // namespace abut
