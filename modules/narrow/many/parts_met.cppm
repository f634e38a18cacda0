// SPDX-License-Identifier: Apache-2.0
// The triangles of a surface that a shape meets, or may meet on its way out. They tell how far the shape has to move to
// be parted from all.
export module abut.narrow.many.parts_met;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
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

  [[nodiscard]] std::span<const FourParts<B>> fours() const [[clang::lifetimebound]] { return fours_.span(); }

  // How far b has to move along the best of some ways, if less far than along the best one so far. `lowest_along`:
  // where b begins along directions. meets_on(parts, way) has a bit for each of four parts that b may meet on a way.
  template <class LowestAlong, class MeetsOn>
  [[nodiscard]] PartingWay shortest(std::span<const Vec3> ways, const PartingWay& best, const LowestAlong& lowest_along,
                                    const MeetsOn& meets_on) const {
    LatelyInTheWay obstacles;
    return shortest(ways, best, obstacles, lowest_along, meets_on);
  }
  // The same of all ways that parts in the way show: the least one out of each, those out of its faces and along its
  // edges.
  template <class LowestAlong, class MeetsOn>
  [[nodiscard]] PartingWay shortest_of_parts(PartingWay best, const LowestAlong& lowest_along,
                                             const MeetsOn& meets_on) const {
    LatelyInTheWay obstacles;
    best = shortest(ways_.span(), best, obstacles, lowest_along, meets_on);
    for (std::size_t part = 0; part < size_; ++part) {
      if (is_in_the_way(part)) {
        best = shortest(ways_of_sides(part).span(), best, obstacles, lowest_along, meets_on);
      }
    }
    return best;
  }
  // Calls visit(place, lanes) with what b meets on a way and is not parted from at its end, beside what it overlaps: by
  // the place of four parts, and a bit for each. Fronts that it touches stand in the way too.
  template <class MeetsOn, class Visit>
  void visit_in_the_way(const PartingWay& way, Real lowest, const MeetsOn& meets_on, const Visit& visit) const {
    for (std::size_t place = 0; place < fours_.size(); ++place) {
      visit(place, bits_of(touching_overlaps(place, way.direction, lowest) == all_lanes(infinity)));
      visit(place, met_beyond(place, way, lowest, meets_on).lanes);
    }
  }

 private:
  static constexpr std::uint64_t all_four = 15;

  template <class LowestAlong, class MeetsOn>
  [[nodiscard]] PartingWay shortest(std::span<const Vec3> ways, PartingWay best, LatelyInTheWay& obstacles,
                                    const LowestAlong& lowest_along, const MeetsOn& meets_on) const {
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
  // Out of the faces of a part and along its edges.
  [[nodiscard]] SmallVector<Vec3, 16> ways_of_sides(std::size_t part) const {
    SmallVector<Vec3, 16> ways;
    const auto add = [&](const Vec3& along) {
      if (const auto way = UnitVec3::make(along)) {
        ways.push_back(*way);
        ways.push_back(-*way);
      }
    };
    const auto add_ways_of = [&](const TriangleCorners& corners) {
      const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
      for (const Vec3& along : {cross(ab, ac), ab, ac, corners[2] - corners[1]}) {
        add(along);
      }
    };
    const FourParts<B>& four = fours_[part / 4];
    add_ways_of(four.triangles[part % 4]);
    if constexpr (std::same_as<B, Triangle>) {
      add_ways_of(four.placed.of[part % 4]);
    }
    return ways;
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
    for (bool has_grown = are_some_apart; has_grown && depth < enough;) {
      has_grown = false;
      for (std::size_t place = 0; place < fours_.size(); ++place) {
        const MetBeyond beyond = met_beyond(place, {depth, direction}, lowest, meets_on);
        has_grown = has_grown || beyond.lanes != 0;
        depth = std::max(depth, beyond.depth);
      }
    }
    return depth;
  }
  // Of four parts those that b does not overlap, but meets on a way and is not parted from at its end: by bit, and the
  // furthest end of them.
  struct MetBeyond {
    std::uint64_t lanes;
    Real depth;
  };
  template <class MeetsOn>
  [[nodiscard]] MetBeyond met_beyond(std::size_t place, const PartingWay& way, Real lowest,
                                     const MeetsOn& meets_on) const {
    const FourParts<B>& four = fours_[place];
    const Lanes overlaps = four.overlaps_along(Columns::all(way.direction), all_lanes(lowest));
    const std::uint64_t beyond = bits_of((four.gap > four.noise) & (overlaps > all_lanes(way.depth)));
    MetBeyond met{beyond == 0 ? 0 : beyond & meets_on(four, way), 0};
    for (std::uint64_t lanes = met.lanes; lanes != 0; lanes &= lanes - 1) {
      met.depth = std::max(met.depth, overlaps[std::countr_zero(lanes)]);
    }
    return met;
  }

  SmallVector<FourParts<B>, 24> fours_;
  std::size_t size_ = 0;
  Real noise_ = 0;
  SmallVector<Vec3, 96> ways_;
};

}  // namespace abut
