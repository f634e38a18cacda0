// SPDX-License-Identifier: Apache-2.0
// The hull of the Minkowski differences of parts, each of them a triangle less b. The way that leaves the hull soonest
// is the shortest that parts b from all of them. Of all directions d it has the least value of the support function
//   h(d) = max h_part(d).
// Behind a front a difference goes on without end, as no way leads there.
export module abut.narrow.many.parts_hull;
import abut.capability;
import abut.capability.second_order;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.difference;
import abut.narrow.cores.direction_cover;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.many.parts_met;
import abut.narrow.many.triangle_contacts;
import abut.narrow.polytope.epa;

export namespace abut {

template <Convex B>
class PartsHull {
 public:
  // All parts that are met. Each call takes the same.
  using Fours = std::span<const FourParts<B>>;

  // Of what b overlaps; what b only touches may lie behind a front. `extent`: of b, 0 where that is a triangle.
  PartsHull(Fours fours, Real extent, bool has_fronts) : has_fronts_(has_fronts) {
    Lanes most = all_lanes(0);
    for (const FourParts<B>& four : fours) {
      parts_.push_back(four.gap <= four.noise);
      fronts_.push_back(four.gap < -four.noise);
      Lanes size = four.triangles.size();
      if constexpr (std::same_as<B, Triangle>) {
        size = maximum(size, four.placed.of.size());
      }
      most = maximum(most, four.gap < all_lanes(infinity) ? size : all_lanes(0));
    }
    size_ = 2 * (largest(most) + extent);
    far_ = 16 * size_;
  }

  // Takes in some of four parts with their fronts, by bit. Whether any is new.
  bool take(std::size_t place, std::uint64_t lanes) {
    bool is_new = false;
    for (; lanes != 0; lanes &= lanes - 1) {
      const int lane = std::countr_zero(lanes);
      is_new = is_new || fronts_[place][lane] == 0;
      parts_[place][lane] = fronts_[place][lane] = -1;
    }
    return is_new;
  }
  // All ways lead along a front from now on.
  void hold(const Vec3& front) { held_.push_back(front); }

  // The shortest way out, if shorter than `most`. `other`: b, or what is made of such; `noise`: of depths.
  template <class Other>
  [[nodiscard]] std::optional<PartingWay> way_out(Fours fours, const Other& other, const Pose& ab, Real most,
                                                  Real noise) const {
    auto way = least_overlap(fours, other, ab, most, noise);
    if (!way || !front_against(fours, way->direction)) {
      return way;
    }
    // The way leads a little against fronts. Where these go on further, it leads against those alone that bound it.
    PartsHull held = *this;
    held.far_ *= 1000;
    way = held.least_overlap(fours, other, ab, most, noise);
    while (way && held.held_.size() < 2) {
      const auto front = front_against(fours, way->direction);
      if (!front) {
        break;
      }
      held.hold(*front);
      way = held.least_overlap(fours, other, ab, most, noise);
      // The search leaves a part across them that is rounding, but forbidden.
      for (const Vec3& along : held.held_.span()) {
        if (way) {
          const Vec3 settled = way->direction - dot(way->direction, along) * along;
          way->direction = UnitVec3::make(settled).value_or(UnitVec3::from_unit_unchecked(way->direction));
        }
      }
    }
    return way;
  }

  // The points of a part and of b that reach furthest toward each other. `support_of_b`: that of b against a direction,
  // unless b is a triangle.
  template <class SupportOfB>
  [[nodiscard]] SupportPair support_pair(Fours fours, const Vec3& direction, const SupportOfB& support_of_b) const {
    const Columns directions = Columns::all(direction);
    Lanes best = all_lanes(-infinity);
    LaneNumbers places = 0;
    for (std::size_t place = 0; place < fours.size(); ++place) {
      const Lanes reach = reach_along(fours[place], place, directions);
      const LaneNumbers is_better = reach > best;
      best = is_better ? reach : best;
      places = is_better ? LaneNumbers(static_cast<std::int64_t>(place)) : places;
    }
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits_of(best == all_lanes(largest(best)))));
    const auto place = static_cast<std::size_t>(places[lane]);
    const FourParts<B>& four = fours[place];
    SupportPair pair{support_of(four.triangles[lane], direction).point, {0, 0, 0}, no_index, no_index};
    if constexpr (std::same_as<B, Triangle>) {
      pair.b = support_of(four.placed.of[lane], -direction).point;
    } else {
      pair.b = support_of_b(direction);
    }
    pair.a = pair.a + end_along_held(direction);
    if (has_fronts_ && fronts_[place][lane] != 0) {
      for (const Vec3& front : {four.fronts.a[lane], four.fronts.b[lane]}) {
        if (dot(direction, front) < 0) {
          pair.a = pair.a - far_ * front;
        }
      }
    }
    return pair;
  }
  // How the support function runs near a direction, but for what b has to do with it: to the corners across the nearest
  // creases. `top`: the support point.
  [[nodiscard]] SecondOrder second_order(Fours fours, const DirectionFrame& frame, const Vec3& top) const {
    SecondOrder near = second_order_of_point(in_frame(frame, top));
    near.is_sum = false;
    std::array<Real, 3> tangents{infinity, infinity, infinity};  // of the angles between the direction and creases
    const auto offer = [&](const Vec3& corner) {
      const InFrame edge = in_frame(frame, corner - top);
      const Real across = std::sqrt(edge.x * edge.x + edge.y * edge.y);
      const Real tangent = across > 0 ? -edge.n / across : infinity;
      std::size_t at = near.edge_count;
      const auto is_same = [&](const InFrame& other) { return other.x == edge.x && other.y == edge.y; };
      if (!(tangent < tangents.back()) || std::ranges::any_of(std::span(near.edges).first(at), is_same)) {
        return;
      }
      at = std::min(at, tangents.size() - 1);
      for (; at > 0 && tangent < tangents[at - 1]; --at) {
        tangents[at] = tangents[at - 1];
        near.edges[at] = near.edges[at - 1];
      }
      tangents[at] = tangent;
      near.edges[at] = edge;
      near.edge_count = std::min(near.edge_count + 1, tangents.size());
    };
    const Vec3 along_held = end_along_held(frame.n);
    visit_parts(fours, [&](const FourParts<B>& four, std::size_t lane, bool has_front) {
      const Vec3 front = four.fronts.a[lane];
      for (const Vec3& corner : four.triangles[lane]) {
        offer(corner + along_held);
        if (has_front && squared_norm(front) > 0) {
          offer(corner + along_held - far_ * front);
        }
      }
    });
    for (const Vec3& front : held_.span()) {
      offer(top - 2 * std::copysign(far_, dot(frame.n, front)) * front);
    }
    return near;
  }

 private:
  // All parts go on as far both ways along fronts that are held: any way across is long.
  [[nodiscard]] Vec3 end_along_held(const Vec3& direction) const {
    Vec3 end{0, 0, 0};
    for (const Vec3& front : held_.span()) {
      end = end + std::copysign(far_, dot(direction, front)) * front;
    }
    return end;
  }
  // How far four parts reach. Those that are not in the hull reach nowhere.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes reach_along(const FourParts<B>& four, std::size_t place,
                                                                const Columns& directions) const {
    Lanes reach = four.reach_along(directions, all_lanes(0));
    if (has_fronts_) {
      const auto behind = [&](const Columns& fronts) { return minimum(dot(directions, fronts), all_lanes(0)); };
      const Lanes stretch = far_ * (behind(four.fronts.a) + behind(four.fronts.b));
      reach -= fronts_[place] ? stretch : all_lanes(0);
    }
    return parts_[place] ? reach : all_lanes(-infinity);
  }
  // Calls visit(four, lane, has_front) for each part of the hull.
  template <class Visit>
  void visit_parts(Fours fours, const Visit& visit) const {
    for (std::size_t place = 0; place < fours.size(); ++place) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (parts_[place][lane] != 0) {
          visit(fours[place], lane, has_fronts_ && fronts_[place][lane] != 0);
        }
      }
    }
  }
  // The front against which a way leads most, if any: as `far` has an end, some ways seem short that do.
  [[nodiscard]] std::optional<Vec3> front_against(Fours fours, const Vec3& way) const {
    std::optional<Vec3> most;
    Real least = least_cosine_of_front;
    visit_parts(fours, [&](const FourParts<B>& four, std::size_t lane, bool has_front) {
      for (const Vec3& front : {four.fronts.a[lane], four.fronts.b[lane]}) {
        if (has_front && dot(way, front) < least) {
          least = dot(way, front);
          most = front;
        }
      }
    });
    return most;
  }

  // The shortest way out, which may lead a little against fronts.
  template <class Other>
  [[nodiscard]] std::optional<PartingWay> least_overlap(Fours fours, const Other& other, const Pose& ab, Real most,
                                                        Real noise) const {
    const auto support = [&](const Vec3& direction) {
      return support_pair(fours, direction, [&](const Vec3& along) {
        if constexpr (std::same_as<B, Triangle>) {
          return along;
        } else {
          return placed_support(other, place(other, ab), -along).point;
        }
      });
    };
    const auto second_order_near = [&](const DirectionFrame& frame) {
      if constexpr (Curved<B>) {
        return pair_second_order(second_order(fours, frame, support(frame.n).a), other, ab, frame);
      } else {
        return PairSecondOrder{};
      }
    };
    Difference difference;
    difference.support = [&support](const Vec3& direction) { return support(direction); };
    // Its corners are as far off as what goes on behind fronts, and so is their rounding.
    difference.size = has_fronts_ ? 2 * far_ + size_ : size_;
    difference.is_curved = Curved<B>;
    if constexpr (Curved<B>) {
      difference.second_order = [&second_order_near](const DirectionFrame& frame) { return second_order_near(frame); };
      difference.add_balls = [](Real, DirectionCover&) {};
    }
    const Real error = std::max(touching_distance(size_), noise);
    Real radius = 0;
    if constexpr (Convex<Other>) {
      radius = other.radius();
    }
    if (radius > 0) {
      const WideGjkResult apart = wide_gjk(difference, {0, 0, 1}, error, infinity, error);
      if (const Real depth = radius - apart.gjk.upper; !apart.gjk.overlap) {
        return depth < most ? std::optional(PartingWay{depth, apart.gjk.normal}) : std::nullopt;
      }
    }
    const auto least = least_overlap_below(most - radius, difference, error);
    return least ? std::optional(PartingWay{radius + least->depth, least->normal}) : std::nullopt;
  }

  SmallVector<LaneNumbers, 24> parts_, fronts_;  // whether they and their fronts are in it, four by four
  SmallVector<Vec3, 2> held_;                    // fronts along which all ways lead
  Real size_;                                    // bounds all coordinates
  Real far_;                                     // how far what is behind a front goes on here: no way is as long
  bool has_fronts_;                              // whether any part may have one
};

}  // namespace abut
