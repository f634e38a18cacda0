// SPDX-License-Identifier: Apache-2.0
// The triangles of a surface that a shape meets, or may meet on its way out. They tell how far the shape has to move to
// be parted from all.
export module abut.narrow.many.parts_met;
import abut.capability;
import abut.capability.second_order;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.cores.difference;
import abut.narrow.many.triangle_contacts;

export namespace abut {

// The number of b, where it is a triangle.
template <Convex B>
[[nodiscard]] std::uint32_t number_of_part(const B& b) {
  if constexpr (std::same_as<B, Triangle>) {
    return b.index();
  } else {
    return 0;
  }
}

// Where a convex b begins along directions.
template <Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Lanes lowest_along(const B& b, const Pose& ab, const Columns& directions) {
  if constexpr (BoxCored<B>) {
    const auto reach = [&](const Vec3& axis, Real half) {
      return half * absolute(dot(directions, Columns::all(axis)));
    };
    const auto& [x, y, z] = ab.rotation;
    const Vec3 half = b.half();
    return dot(directions, Columns::all(ab.position)) -
           (reach(x, half.x) + reach(y, half.y) + reach(z, half.z) + b.radius());
  } else {
    const auto placed = place(b, ab);
    const auto lowest = [&](std::size_t lane) {
      const Vec3 direction = directions[lane];
      return dot(direction, placed_support(b, placed, -direction).point) - b.radius();
    };
    return {lowest(0), lowest(1), lowest(2), lowest(3)};
  }
}
template <Convex B>
[[nodiscard]] Real lowest_along(const B& b, const Pose& ab, const Vec3& direction) {
  if constexpr (BoxCored<B>) {
    return lowest_along(b, ab, Columns::all(direction))[0];
  } else {
    return dot(direction, placed_support(b, place(b, ab), -direction).point) - b.radius();
  }
}

// Triangles of b in the frame of a, where b is made of such.
template <Convex B>
struct PlacedTriangles {};
template <>
struct PlacedTriangles<Triangle> {
  FourTriangles of;
};

// Four triangles of a surface and what each of them meets, one per lane.
template <Convex B>
struct FourParts {
  FourTriangles triangles;
  FourFronts fronts;
  Lanes gap;    // how far both are apart; not positive where they overlap
  Lanes noise;  // how far both may overlap that only touch
  [[no_unique_address]] PlacedTriangles<B> placed;

  [[nodiscard]] static FourParts all(const Triangle& triangle, const B& b, const Pose& ab, const Fronts<B>& fronts,
                                     Real gap, Real noise) {
    FourParts parts{FourTriangles::all(triangle.corners()), fronts.in_all(), all_lanes(gap), all_lanes(noise), {}};
    parts.triangles.numbers.fill(triangle.index());
    if constexpr (std::same_as<B, Triangle>) {
      parts.placed.of = FourTriangles::all({ab * b.corners()[0], ab * b.corners()[1], ab * b.corners()[2]});
      parts.placed.of.numbers.fill(b.index());
    }
    return parts;
  }
  // The same of one of them, four times.
  [[nodiscard]] [[gnu::always_inline]] inline FourParts all_of(std::size_t lane) const {
    FourParts parts{
        FourTriangles::all(triangles[lane]), fronts.all_of(lane), all_lanes(gap[lane]), all_lanes(noise[lane]), {}};
    if constexpr (std::same_as<B, Triangle>) {
      parts.placed.of = FourTriangles::all(placed.of[lane]);
    }
    return parts;
  }
  [[nodiscard]] std::uint32_t number_of_b(std::size_t lane) const {
    if constexpr (std::same_as<B, Triangle>) {
      return placed.of.numbers[lane];
    } else {
      return 0;
    }
  }
  void put(std::size_t lane, const FourParts& one) {
    triangles.put(lane, one.triangles);
    fronts.put(lane, one.fronts);
    gap[lane] = one.gap[0];
    noise[lane] = one.noise[0];
    if constexpr (std::same_as<B, Triangle>) {
      placed.of.put(lane, one.placed.of);
    }
  }

  // How far b has to move along directions to be parted from the triangles, lane by lane; without end where it would
  // have to pass through the front of a side. `lowest`: where b begins along the direction, unless it is a triangle, or
  // a point of b that tells no more than that.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes overlaps_along(const Columns& directions, Lanes lowest) const {
    const Lanes overlaps = reach_along(directions, lowest);
    return (overlaps <= noise) | fronts.allow(directions) ? overlaps : all_lanes(infinity);
  }
  // The same whatever the fronts.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes reach_along(const Columns& directions, Lanes lowest) const {
    const auto along = [&](const FourTriangles& t, const auto& better) {
      return better(better(dot(directions, t.a), dot(directions, t.b)), dot(directions, t.c));
    };
    if constexpr (std::same_as<B, Triangle>) {
      lowest = along(placed.of, [](Lanes p, Lanes q) { return minimum(p, q); });
    }
    return along(triangles, [](Lanes p, Lanes q) { return maximum(p, q); }) - lowest;
  }
};

// How far b has to move along a direction to be parted.
struct PartingWay {
  Real depth;
  Vec3 direction;
};

// What lies between two lengths of a way.
struct Stretch {
  Vec3 direction;
  Real begin, end;
};

// Parts that lately were not parted. One of them mostly stands in the way again.
class LatelyInTheWay {
 public:
  void put_first(std::size_t part) {
    count_ = std::min(count_ + 1, parts_.size());
    for (std::size_t i = count_ - 1; i > 0; --i) {
      parts_[i] = parts_[i - 1];
    }
    parts_[0] = part;
  }
  [[nodiscard]] std::span<const std::size_t> parts() const [[clang::lifetimebound]] {
    return std::span(parts_).first(count_);
  }

 private:
  std::array<std::size_t, 4> parts_{};
  std::size_t count_ = 0;
};

// The hull of the Minkowski differences of some parts, each of them its triangle less b: the way that leaves it soonest
// parts them all. Behind a front a difference goes on without end, as no way leads there; `far` stands in for that.
struct PartsHull {
  SmallVector<LaneNumbers, 24> parts, fronts;  // whether they and their fronts are in it, four by four
  bool has_fronts;                             // whether any part may have one
  Real far;
  SmallVector<Vec3, 2> along;  // fronts along which all ways lead
};

template <Convex B>
class PartsMet {
 public:
  // The number of the new part. It stands in no way yet.
  std::size_t add(const Triangle& triangle, const B& b, const Pose& ab, const Fronts<B>& fronts, Real noise) {
    const FourParts<B> one = FourParts<B>::all(triangle, b, ab, fronts, infinity, noise);
    const std::size_t lane = size_ % 4;
    if (lane == 0) {
      fours_.push_back(one);  // the last one stands in for those that lack
    } else {
      fours_[size_ / 4].put(lane, one);
    }
    noise_ = std::max(noise_, noise);
    return size_++;
  }
  // From now on a part stands in ways. `gap`: how far b is apart from it. `way`: the least one out of it alone.
  void put_in_the_way(std::size_t part, Real gap, const Vec3& way) {
    fours_[part / 4].gap[part % 4] = gap;
    ways_.push_back(way);
  }
  [[nodiscard]] bool is_in_the_way(std::size_t part) const { return fours_[part / 4].gap[part % 4] < infinity; }
  // The largest of those of the parts.
  [[nodiscard]] Real noise() const { return noise_; }
  // Which part is of a triangle of the surface, by its number, and of that of b where b is one itself.
  [[nodiscard]] std::optional<std::size_t> find(std::uint32_t number, std::uint32_t number_of_b) const {
    for (std::size_t part = 0; part < size_; ++part) {
      const FourParts<B>& four = fours_[part / 4];
      if (four.triangles.numbers[part % 4] == number && four.number_of_b(part % 4) == number_of_b) {
        return part;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] Lanes overlaps_along(std::size_t part, const Columns& directions, Lanes lowest) const {
    return fours_[part / 4].all_of(part % 4).overlaps_along(directions, lowest);
  }

  // The largest magnitude of a coordinate of a triangle that stands in ways.
  [[nodiscard]] Real extent() const {
    Lanes most = all_lanes(0);
    for (const FourParts<B>& four : fours_.span()) {
      Lanes size = four.triangles.size();
      if constexpr (std::same_as<B, Triangle>) {
        size = maximum(size, four.placed.of.size());
      }
      most = maximum(most, four.gap < all_lanes(infinity) ? size : all_lanes(0));
    }
    return largest(most);
  }
  // Of what b overlaps. What b only touches may lie behind a front.
  [[nodiscard]] PartsHull hull(bool has_fronts, Real far) const {
    [[clang::uninitialized]] PartsHull hull;
    hull.has_fronts = has_fronts;
    hull.far = far;
    for (const FourParts<B>& four : fours_.span()) {
      hull.parts.push_back(four.gap <= four.noise);
      hull.fronts.push_back(four.gap < -four.noise);
    }
    return hull;
  }
  // Takes into a hull what else b meets on a way, and fronts that it touches. Whether there is any.
  template <class MeetsOn>
  [[nodiscard]] bool take_in(PartsHull& hull, const PartingWay& way, Real lowest, const MeetsOn& meets_on) const {
    bool is_any = false;
    const auto take = [&](std::size_t place, std::uint64_t lanes) {
      for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        is_any = is_any || hull.fronts[place][lane] == 0;
        hull.parts[place][lane] = hull.fronts[place][lane] = -1;
      }
    };
    for (std::size_t place = 0; place < fours_.size(); ++place) {
      take(place, bits_of(touching_overlaps(place, way.direction, lowest) == all_lanes(infinity)));
    }
    Real depth = way.depth;
    while (depth < infinity && prolong(depth, way.direction, lowest, meets_on, take)) {
    }
    return is_any;
  }
  // The support points of a hull, for EPA. `support_of_b`: that of b against a direction, unless it is a triangle.
  template <class SupportOfB>
  [[nodiscard]] SupportPair support_pair(const PartsHull& hull, const Vec3& direction,
                                         const SupportOfB& support_of_b) const {
    const Columns directions = Columns::all(direction);
    Lanes best = all_lanes(-infinity);
    LaneNumbers places = 0;
    for (std::size_t place = 0; place < fours_.size(); ++place) {
      const Lanes reach = reach_in(hull, place, directions);
      const LaneNumbers is_better = reach > best;
      best = is_better ? reach : best;
      places = is_better ? LaneNumbers(static_cast<std::int64_t>(place)) : places;
    }
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits_of(best == all_lanes(largest(best)))));
    const auto place = static_cast<std::size_t>(places[lane]);
    const FourParts<B>& four = fours_[place];
    SupportPair pair{extreme(four.triangles[lane], direction), {0, 0, 0}, no_index, no_index};
    if constexpr (std::same_as<B, Triangle>) {
      pair.b = extreme(four.placed.of[lane], -direction);
    } else {
      pair.b = support_of_b(direction);
    }
    for (const Vec3& front : hull.along.span()) {
      pair.a = pair.a + std::copysign(hull.far, dot(direction, front)) * front;
    }
    if (hull.has_fronts && hull.fronts[place][lane] != 0) {
      for (const Vec3& front : {four.fronts.a[lane], four.fronts.b[lane]}) {
        if (dot(direction, front) < 0) {
          pair.a = pair.a - hull.far * front;
        }
      }
    }
    return pair;
  }
  // The front in a hull against which a way leads most, if any: as `far` has an end, some ways seem short that do.
  [[nodiscard]] std::optional<Vec3> front_against(const PartsHull& hull, const Vec3& way) const {
    Vec3 most{0, 0, 0};
    for (std::size_t part = 0; hull.has_fronts && part < size_; ++part) {
      const FourParts<B>& four = fours_[part / 4];
      const std::size_t lane = part % 4;
      if (hull.fronts[part / 4][lane] == 0) {
        continue;
      }
      for (const Vec3& front : {four.fronts.a[lane], four.fronts.b[lane]}) {
        most = dot(way, front) < std::min(dot(way, most), -least_sine) ? front : most;
      }
    }
    return most == Vec3{0, 0, 0} ? std::nullopt : std::optional(most);
  }
  // How the support function of a hull runs near a direction, but for what b has to do with it: to the corners across
  // the nearest creases. `top`: the support point.
  [[nodiscard]] SecondOrder second_order(const PartsHull& hull, const DirectionFrame& frame, const Vec3& top) const {
    SecondOrder near = second_order_of_point(in_frame(frame, top));
    near.is_sum = false;
    std::array<Real, 3> angles{infinity, infinity, infinity};
    const auto offer = [&](const Vec3& corner) {
      const InFrame edge = in_frame(frame, corner - top);
      const Real angle = -edge.n / std::hypot(edge.x, edge.y);
      std::size_t at = near.edge_count;
      const auto is_same = [&](const InFrame& other) { return other.x == edge.x && other.y == edge.y; };
      if (!(angle < angles.back()) || std::ranges::any_of(std::span(near.edges).first(at), is_same)) {
        return;
      }
      at = std::min(at, angles.size() - 1);
      for (; at > 0 && angle < angles[at - 1]; --at) {
        angles[at] = angles[at - 1];
        near.edges[at] = near.edges[at - 1];
      }
      angles[at] = angle;
      near.edges[at] = edge;
      near.edge_count = std::min(near.edge_count + 1, angles.size());
    };
    for (std::size_t part = 0; part < size_; ++part) {
      const FourParts<B>& four = fours_[part / 4];
      const std::size_t lane = part % 4;
      if (hull.parts[part / 4][lane] == 0) {
        continue;
      }
      const Vec3 front = four.fronts.a[lane];
      for (const Vec3& corner : four.triangles[lane]) {
        offer(corner);
        if (squared_norm(front) > 0 && hull.fronts[part / 4][lane] != 0) {
          offer(corner - hull.far * front);
        }
      }
    }
    for (const Vec3& front : hull.along.span()) {
      offer(top - 2 * std::copysign(hull.far, dot(frame.n, front)) * front);
    }
    return near;
  }

  // How far b has to move along the best of some ways, if less far than along the best one so far. `lowest_along`:
  // where b begins along directions. meets_on(parts, way) has a bit for each of four parts that b may meet on a way.
  template <class LowestAlong, class MeetsOn>
  [[nodiscard]] PartingWay shortest(std::span<const Vec3> ways, PartingWay best, const LowestAlong& lowest_along,
                                    const MeetsOn& meets_on) const {
    LatelyInTheWay obstacles;
    const auto consider = [&](const Columns& directions) {
      std::uint64_t lanes = all_four;
      const Lanes lowest = lowest_along(directions);
      Lanes overlaps = all_lanes(0);
      for (const std::size_t part : obstacles.parts()) {
        overlaps = maximum(overlaps, overlaps_along(part, directions, lowest));
        lanes &= bits_of(overlaps < all_lanes(best.depth));
        if (lanes == 0) {
          return;
        }
      }
      for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        const Vec3 direction = directions[lane];
        const Real depth = overlap_of_all(direction, lowest[lane], best.depth, obstacles, meets_on);
        best = depth < best.depth ? PartingWay{depth, direction} : best;
      }
    };
    for (std::size_t first = 0; first < ways.size(); first += 4) {
      // The last one stands in for those that lack.
      const auto way = [&](std::size_t i) { return lanes_of(ways[std::min(first + i, ways.size() - 1)]); };
      consider(Columns::of(way(0), way(1), way(2), way(3)));
    }
    return best;
  }
  // The least ways out of parts that stand in ways, and those out of their faces.
  [[nodiscard]] SmallVector<Vec3, 96> ways() const {
    SmallVector<Vec3, 96> ways = ways_;
    const auto add_face = [&](const TriangleCorners& corners) {
      if (const auto normal = UnitVec3::make(cross(corners[1] - corners[0], corners[2] - corners[0]))) {
        ways.push_back(*normal);
        ways.push_back(-*normal);
      }
    };
    for (std::size_t part = 0; part < size_; ++part) {
      const FourParts<B>& four = fours_[part / 4];
      if (!is_in_the_way(part)) {
        continue;
      }
      add_face(four.triangles[part % 4]);
      if constexpr (std::same_as<B, Triangle>) {
        add_face(four.placed.of[part % 4]);
      }
    }
    return ways;
  }

 private:
  static constexpr std::uint64_t all_four = 15;
  static constexpr Real least_sine = 1e-12;  // as of fronts that allow a way, within rounding

  [[nodiscard]] static Vec3 extreme(const TriangleCorners& corners, const Vec3& direction) {
    const Real a = dot(direction, corners[0]), b = dot(direction, corners[1]), c = dot(direction, corners[2]);
    return a >= b && a >= c ? corners[0] : b >= c ? corners[1] : corners[2];
  }
  // How far parts reach along a direction in a hull. Those that are not in it reach nowhere.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes reach_in(const PartsHull& hull, std::size_t place,
                                                             const Columns& directions) const {
    const FourParts<B>& four = fours_[place];
    Lanes reach = four.reach_along(directions, all_lanes(0));
    if (hull.has_fronts) {
      const auto behind = [&](const Columns& fronts) { return minimum(dot(directions, fronts), all_lanes(0)); };
      const Lanes stretch = hull.far * (behind(four.fronts.a) + behind(four.fronts.b));
      reach -= hull.fronts[place] ? stretch : all_lanes(0);
    }
    return hull.parts[place] ? reach : all_lanes(-infinity);
  }

  // How far b has to move to be parted from those of four parts that it meets already.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes touching_overlaps(std::size_t place, const Vec3& direction,
                                                                      Real lowest) const {
    const FourParts<B>& four = fours_[place];
    return four.gap <= four.noise ? four.overlaps_along(Columns::all(direction), all_lanes(lowest)) : all_lanes(0);
  }

  // How far b has to move along a direction until it overlaps no part, nor enters one on the way. Where that is as
  // far as `enough`, the answer is no less.
  template <class MeetsOn>
  [[nodiscard]] Real overlap_of_all(const Vec3& direction, Real lowest, Real enough, LatelyInTheWay& obstacles,
                                    const MeetsOn& meets_on) const {
    Real depth = 0;
    if (!(depth < enough)) {
      return depth;
    }
    bool are_some_apart = false;
    for (std::size_t place = 0; place < fours_.size(); ++place) {
      const Lanes overlaps = touching_overlaps(place, direction, lowest);
      depth = std::max(depth, largest(overlaps));
      if (!(depth < enough)) {
        const std::uint64_t blocking = bits_of(overlaps >= all_lanes(enough));
        obstacles.put_first(4 * place + static_cast<std::size_t>(std::countr_zero(blocking)));
        return depth;
      }
      are_some_apart = are_some_apart || bits_of(fours_[place].gap > fours_[place].noise) != 0;
    }
    while (are_some_apart && depth < enough && prolong(depth, direction, lowest, meets_on, [](auto&&...) {})) {
    }
    return depth;
  }
  // Makes a way longer where b enters parts on it that it does not overlap. Whether it did. `on_met` is told which.
  template <class MeetsOn, class OnMet>
  [[nodiscard]] bool prolong(Real& depth, const Vec3& direction, Real lowest, const MeetsOn& meets_on,
                             const OnMet& on_met) const {
    bool has_grown = false;
    for (std::size_t place = 0; place < fours_.size(); ++place) {
      const FourParts<B>& four = fours_[place];
      const Lanes overlaps = four.overlaps_along(Columns::all(direction), all_lanes(lowest));
      std::uint64_t met = bits_of((four.gap > four.noise) & (overlaps > all_lanes(depth)));
      met = met == 0 ? 0 : met & meets_on(four, PartingWay{depth, direction});
      on_met(place, met);
      for (; met != 0; met &= met - 1) {
        depth = std::max(depth, overlaps[static_cast<std::size_t>(std::countr_zero(met))]);
        has_grown = true;
      }
    }
    return has_grown;
  }

  SmallVector<FourParts<B>, 24> fours_;
  std::size_t size_ = 0;
  Real noise_ = 0;
  SmallVector<Vec3, 96> ways_;
};

}  // namespace abut
