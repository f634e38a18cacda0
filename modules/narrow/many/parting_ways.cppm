// SPDX-License-Identifier: Apache-2.0
// The shortest way that parts a shape from all triangles of a surface that it meets, or meets on the way. No contact is
// deeper.
export module abut.narrow.many.parting_ways;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.many.last_touch;
import abut.narrow.many.parts_hull;
import abut.narrow.many.parts_met;
import abut.narrow.many.triangle_contacts;

export namespace abut {

// What a side is made of: its parts, or itself.
template <class S>
struct PartOf {
  using type = S;
};
template <Surface S>
struct PartOf<S> {
  using type = typename S::Part;
};

// What lies there under a number: a part, or the whole where there are none.
template <class S>
[[nodiscard]] decltype(auto) part_of(const S& side, std::uint32_t number) {
  if constexpr (Surface<S>) {
    return side.part(number);
  } else {
    return (side);
  }
}

template <Surface A, class Other>
class PartingWays {
 public:
  using B = typename PartOf<Other>::type;

  PartingWays(const A& a, const Other& other, const Pose& ab, const QuerySettings& settings)
      : a_(a), other_(other), ab_(ab), settings_(settings) {}

  // What is near: its number. `way`: the shortest one out of it alone. What is within the margin only stands in no way,
  // so that the margin has no say. Where two triangles only touch, rounding tells their way, and whether they are met
  // without a margin.
  std::size_t add(const Triangle& triangle, const B& b, const Fronts<B>& fronts, const Vec3& way, Real gap,
                  Real touching) {
    const std::size_t part = met_.add(triangle, b, ab_, fronts, touching);
    if (gap <= (Surface<Other> ? 0 : touching)) {
      met_.put_in_the_way(part, gap, way);
    }
    return part;
  }
  [[nodiscard]] Lanes overlaps_along(std::size_t part, const Columns& directions, Lanes lowest) const {
    return met_.overlaps_along(part, directions, lowest);
  }

  // Where b begins along directions, unless it is made of parts: each knows its own.
  template <class Directions>
  [[nodiscard]] auto lowest_along(const Directions& directions) const {
    if constexpr (!Surface<Other>) {
      return abut::lowest_along(other_, ab_, directions);
    } else if constexpr (std::same_as<Directions, Columns>) {
      return all_lanes(0);
    } else {
      return Real{0};
    }
  }

  // The shortest way out of all, if shorter than `most`. `on_the_way`: what b may meet on a way.
  template <class OnTheWay>
  [[nodiscard]] PartingWay shortest(Real most, const OnTheWay& on_the_way) {
    PartingWay way = out_of_met(most, on_the_way);
    // It may lead into what is not met yet. Then another may be shorter.
    while (way.depth < most && prolong(way, most, on_the_way)) {
      way = out_of_met(most, on_the_way);
    }
    return way;
  }

  // A part, and how far b overlaps it along a way.
  struct PartOnWay {
    Real overlap;
    std::uint32_t number, number_of_b;
  };
  struct TouchOfPart {
    LastTouch touch;
    PartOnWay part;
  };
  // What b touches last on a way before it touches nothing, if it is deeper than `least`: first of what it touches
  // there, then of what it touches where that is left.
  template <class OnTheWay>
  [[nodiscard]] std::optional<TouchOfPart> last_touch_deeper_than(Real least, const PartingWay& way,
                                                                  const OnTheWay& on_the_way) const {
    std::optional<TouchOfPart> last;
    for (auto next = last_touch_from(least, way, on_the_way); next;
         next = last_touch_from(last->touch.depth, way, on_the_way)) {
      last = next;
    }
    return last;
  }

 private:
  // Of what b touches after a length of a way the one that it touches last.
  template <class OnTheWay>
  [[nodiscard]] std::optional<TouchOfPart> last_touch_from(Real length, const PartingWay& way,
                                                           const OnTheWay& on_the_way) const {
    const Real slack = 2 * met_.noise();
    [[clang::uninitialized]] SmallVector<PartOnWay, 64> parts;
    on_the_way.visit({way.direction, length, length}, length + slack, slack,
                     [&](const Triangle& triangle, const B& b, Real, Real leave) {
                       parts.push_back({std::min(leave, way.depth), triangle.index(), number_of_part(b)});
                     });
    std::ranges::sort(parts.span(), [](const PartOnWay& one, const PartOnWay& other) {
      return std::tuple(other.overlap, one.number, one.number_of_b) <
             std::tuple(one.overlap, other.number, other.number_of_b);
    });
    const Pose there{ab_.rotation, ab_.position + length * way.direction};
    std::optional<TouchOfPart> last;
    for (const PartOnWay& part : parts.span()) {
      const Real deepest = last ? last->touch.depth : length;
      if (!(part.overlap > deepest + slack)) {
        break;  // the others part no later
      }
      const Triangle triangle = a_.part(part.number);
      const auto& b = part_of(other_, part.number_of_b);
      const Real reach = b.radius() + slack;
      const CoreSeparation core = begin_separation(triangle, b, there, settings_, reach).core;
      if (core.beyond || core.distance > reach) {
        continue;
      }
      const auto touch = last_touch(triangle, b, ab_, {part.overlap, way.direction}, settings_);
      if (touch && touch->depth > deepest + slack) {
        last = TouchOfPart{*touch, part};
      }
    }
    return last;
  }

  // Hulls tell their ways to less than this share: what ends as soon stands in none.
  static constexpr Real way_blur = 1e-9;
  // A longer look costs more where the way ends soon, a shorter one takes more of them.
  static constexpr Real far_ahead = 2;

  // The shortest way out of what is met. No way is shorter than the one out of the hull of what b overlaps. Only where
  // something else stands in that way, others may be as short: the one out of the hull of that too, those of faces,
  // along edges and of single parts.
  template <class OnTheWay>
  [[nodiscard]] PartingWay out_of_met(Real most, const OnTheWay& on_the_way) const {
    PartingWay best{most, {0, 0, 0}};
    const auto lowest = [&](const Columns& directions) { return lowest_along(directions); };
    const auto consider = [&](std::span<const Vec3> ways) {
      best = met_.shortest(ways, best, lowest, meets_on(on_the_way));
    };
    [[clang::uninitialized]] PartsHull<B> hull(met_.fours(), extent_of_other(), Surface<Other> || a_.has_fronts());
    for (bool is_first = true;; is_first = false) {
      auto way = hull.way_out(met_.fours(), other_, ab_, best.depth, met_.noise());
      if (way) {
        consider(std::span(&way->direction, 1));
        way->depth *= 1 + way_blur;
      }
      const bool is_free = !way || best.depth <= way->depth + met_.noise();
      if (is_free && is_first) {
        return best;
      }
      if (is_free || !take_in_the_way(*way, on_the_way, hull)) {
        break;
      }
    }
    best = met_.shortest_of_parts(best, lowest, meets_on(on_the_way));
    consider(own_ways().span());
    return best;
  }

  // Takes into a hull what else stands in a way. Whether there is any.
  template <class OnTheWay>
  [[nodiscard]] bool take_in_the_way(const PartingWay& way, const OnTheWay& on_the_way, PartsHull<B>& hull) const {
    bool is_any = false;
    met_.visit_in_the_way(way, lowest_along(way.direction), meets_on(on_the_way),
                          [&](std::size_t place, std::uint64_t lanes) { is_any = hull.take(place, lanes) || is_any; });
    return is_any;
  }
  [[nodiscard]] Real extent_of_other() const {
    if constexpr (Surface<Other>) {
      return 0;
    } else {
      return other_.extent() + largest_magnitude(placed_centre(other_, ab_));
    }
  }

  // A bit for each of four parts that b may meet on a way: no further from it than the way is long, and within what b
  // sweeps.
  template <class OnTheWay>
  [[nodiscard]] static auto meets_on(const OnTheWay& on_the_way) {
    return [&](const FourParts<B>& parts, const PartingWay& way) {
      const std::uint64_t are_within = bits_of(parts.gap <= all_lanes(way.depth) + parts.noise);
      return are_within == 0 ? 0 : are_within & on_the_way.meets(parts, way);
    };
  }

  // To the nearest of 2^23 numbers between two powers of two: lengths that differ by rounding mostly become equal, and
  // the order of a and b has no say. Infinity stays.
  [[nodiscard]] static Real without_rounding(Real length) {
    constexpr std::uint64_t lost = (std::uint64_t{1} << 29) - 1;
    return std::bit_cast<Real>((std::bit_cast<std::uint64_t>(length) + lost / 2 + 1) & ~lost);
  }

  // Meets what b touches where a way ends, then what it touches where that is left. So it goes on up to `far_ahead`
  // times the way. Whether any is new.
  template <class OnTheWay>
  [[nodiscard]] bool prolong(const PartingWay& way, Real most, const OnTheWay& on_the_way) {
    struct Obstacle {
      Real enter, leave;
      std::uint32_t number, number_of_b;
    };
    // What b touches there may seem to lie beyond it, by rounding.
    const Real slack = 2 * met_.noise() + way_blur * way.depth;
    // What is left before the end is no obstacle, but for a front.
    const bool meets_front = on_the_way.meets_front(way, slack);
    const Stretch ahead{way.direction, meets_front ? 0 : way.depth, std::min(most, far_ahead * way.depth)};
    const Real least = meets_front ? -infinity : way.depth + slack;
    [[clang::uninitialized]] SmallVector<Obstacle, 64> obstacles;
    on_the_way.visit(ahead, least, slack, [&](const Triangle& triangle, const B& b, Real enter, Real leave) {
      const bool is_left = Fronts<B>(triangle, b, ab_).allows(way.direction);
      if (!is_left || leave > way.depth + slack) {
        obstacles.push_back({enter, is_left ? leave : infinity, triangle.index(), number_of_part(b)});
      }
    });
    std::ranges::sort(obstacles.span(), {}, [](const Obstacle& obstacle) {
      const auto [low, high] = std::minmax(obstacle.number, obstacle.number_of_b);
      return std::tuple(without_rounding(obstacle.enter), -without_rounding(obstacle.leave), low, high,
                        obstacle.number);
    });
    Real end = way.depth;
    bool is_longer = false;
    for (const Obstacle& obstacle : obstacles.span()) {
      if (obstacle.enter <= end + slack && obstacle.leave > end + slack &&
          meet(a_.part(obstacle.number), part_of(other_, obstacle.number_of_b), obstacle.leave)) {
        end = obstacle.leave;
        is_longer = true;
      }
    }
    return is_longer;
  }

  // Along the sides of b, or its edges where it has none, when it is one body.
  [[nodiscard]] SmallVector<Vec3, 8> own_ways() const {
    SmallVector<Vec3, 8> ways;
    if constexpr (FewFaced<Other> && !std::same_as<Other, Triangle>) {
      const auto add = [&](const Vec3& local) {
        const Vec3 way = ab_.rotation * local;
        ways.push_back(way);
        ways.push_back(-way);
      };
      std::ranges::for_each(other_.face_normals(), add);
      if (other_.face_normals().empty()) {
        std::ranges::for_each(other_.edge_directions(), add);
      }
    }
    return ways;
  }

  // A part that stands in a way of some length. Whether it is new.
  bool meet(const Triangle& triangle, const B& b, Real depth) {
    std::optional<std::size_t> part = met_.find(triangle.index(), number_of_part(b));
    if (part && met_.is_in_the_way(*part)) {
      return false;
    }
    const Real radii = b.radius();
    const CoreSeparation core = begin_separation(triangle, b, ab_, settings_, depth + radii).core;
    if (core.beyond || core.distance - radii > depth) {
      return false;
    }
    if (!part) {
      const Real touching = touching_within<B>(core_size(triangle, b, ab_), settings_);
      part = met_.add(triangle, b, ab_, Fronts<B>(triangle, b, ab_), touching);
    }
    met_.put_in_the_way(*part, core.distance - radii, core.normal);
    return true;
  }

  const A& a_;
  const Other& other_;
  const Pose& ab_;
  const QuerySettings& settings_;
  PartsMet<B> met_;
};

}  // namespace abut
