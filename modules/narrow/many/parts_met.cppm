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
  std::array<bool, 4> offers_ways;

  [[nodiscard]] static FourParts all(const Triangle& triangle, const B& b, const Pose& ab, const Fronts<B>& fronts,
                                     Real gap, Real noise) {
    FourParts parts{FourTriangles::all(triangle.corners()), fronts.in_all(), all_lanes(gap), all_lanes(noise), {}, {}};
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
        FourTriangles::all(triangles[lane]), fronts.all_of(lane), all_lanes(gap[lane]), all_lanes(noise[lane]), {}, {}};
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
    offers_ways[lane] = false;
    if constexpr (std::same_as<B, Triangle>) {
      placed.of.put(lane, one.placed.of);
    }
  }

  // How far b has to move along directions to be parted from the triangles, lane by lane; without end where it would
  // have to pass through the front of a side. `lowest`: where b begins along the direction, unless it is a triangle, or
  // a point of b that tells no more than that.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes overlaps_along(const Columns& directions, Lanes lowest) const {
    const auto along = [&](const FourTriangles& t, const auto& better) {
      return better(better(dot(directions, t.a), dot(directions, t.b)), dot(directions, t.c));
    };
    if constexpr (std::same_as<B, Triangle>) {
      lowest = along(placed.of, [](Lanes p, Lanes q) { return minimum(p, q); });
    }
    const Lanes overlaps = along(triangles, [](Lanes p, Lanes q) { return maximum(p, q); }) - lowest;
    return (overlaps <= noise) | fronts.allow(directions) ? overlaps : all_lanes(infinity);
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
  // The number of the new part. It offers no ways yet, and stands in none.
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
  // Takes the ways out of the faces of a part. `gap`: how far b is apart from it.
  void offer_ways(std::size_t part, const Triangle& triangle, const B& b, const Pose& ab, Real gap) {
    fours_[part / 4].gap[part % 4] = gap;
    fours_[part / 4].offers_ways[part % 4] = true;
    offering_.push_back(part);
    deepest_ = std::max(deepest_, -gap);
    add_face(triangle.normal(), triangle.is_one_sided());
    if constexpr (std::same_as<B, Triangle>) {
      add_face(-(ab.rotation * b.normal()), b.is_one_sided());
    }
  }
  // The largest of those of the parts.
  [[nodiscard]] Real noise() const { return noise_; }
  // How deep the deepest part is by itself.
  [[nodiscard]] Real deepest() const { return deepest_; }
  // The parts that offer ways.
  [[nodiscard]] std::span<const std::size_t> offering() const { return offering_.span(); }
  // Of a part: which triangle of the surface, and of b where b is made of such.
  struct Numbers {
    std::uint32_t of_a, of_b;
  };
  [[nodiscard]] Numbers numbers(std::size_t part) const {
    const FourParts<B>& four = fours_[part / 4];
    return {four.triangles.numbers[part % 4], four.number_of_b(part % 4)};
  }
  // Which part is of a triangle of the surface, by its number, and of that of b where b is one itself.
  [[nodiscard]] std::optional<std::size_t> find(std::uint32_t number, std::uint32_t number_of_b) const {
    for (std::size_t part = 0; part < size_; ++part) {
      const Numbers found = numbers(part);
      if (found.of_a == number && found.of_b == number_of_b) {
        return part;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] bool offers_ways(std::size_t part) const { return fours_[part / 4].offers_ways[part % 4]; }
  // Directions that might part the whole: the normals of contacts, the least ways out of parts, and the ways out of
  // faces. Most that come again are known: a face has its ways out of every part, and flat surfaces have few.
  void add_way(const Vec3& way) {
    std::size_t& known = known_[place_of(way)];
    const auto is_same = [&](const Vec3& other) {
      return ((way.x == other.x) & (way.y == other.y) & (way.z == other.z)) != 0;  // no branch is guessed
    };
    const bool is_new = !(known < ways_.size() && is_same(ways_[known]));
    known = is_new ? ways_.size() : known;
    ways_.push_back_if(way, is_new);
  }

  [[nodiscard]] Lanes overlaps_along(std::size_t part, const Columns& directions, Lanes lowest) const {
    return fours_[part / 4].all_of(part % 4).overlaps_along(directions, lowest);
  }

  // How far b has to move, along the best of the ways and of the mean of `normals`; not more than `most`.
  // `lowest_along`: where b begins along directions. meets_on(parts, way) has a bit for each of four parts that b may
  // meet on a way.
  template <class LowestAlong, class MeetsOn>
  [[nodiscard]] PartingWay way_out(const Vec3& normals, Real most, const LowestAlong& lowest_along,
                                   const MeetsOn& meets_on) const {
    PartingWay best{most, {0, 0, 0}};
    LatelyInTheWay obstacles;
    const auto consider = [&](const Columns& directions, std::uint64_t lanes) {
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
    // Over a crest the way between the faces is shorter than out of any one of them.
    if (const auto between = UnitVec3::make(normals)) {
      consider(Columns::all(*between), 1);
    }
    const std::span<const Vec3> ways = ways_.span();
    for (std::size_t first = 0; first < ways.size(); first += 4) {
      // The last one stands in for those that lack.
      const auto way = [&](std::size_t i) { return lanes_of(ways[std::min(first + i, ways.size() - 1)]); };
      consider(Columns::of(way(0), way(1), way(2), way(3)), 15);
    }
    return best;
  }

 private:
  static constexpr std::size_t known_ways = 64;

  // Among the ways that are known.
  [[nodiscard]] static std::size_t place_of(const Vec3& way) {
    const auto bits = [](Real value) { return std::bit_cast<std::uint64_t>(value); };
    return spread(bits(way.x) + 3 * bits(way.y) + 7 * bits(way.z), std::bit_width(known_ways - 1));
  }
  void add_face(const Vec3& normal, bool is_one_sided) {
    if (squared_norm(normal) > 0) {
      add_way(normal);
      if (!is_one_sided) {
        add_way(-normal);
      }
    }
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
    for (bool has_grown = are_some_apart; has_grown;) {
      has_grown = false;
      for (const FourParts<B>& four : fours_.span()) {
        const Lanes overlaps = four.overlaps_along(Columns::all(direction), all_lanes(lowest));
        std::uint64_t met = bits_of((four.gap > four.noise) & (overlaps > all_lanes(depth)));
        met = met == 0 ? 0 : met & meets_on(four, PartingWay{depth, direction});
        for (; met != 0; met &= met - 1) {
          depth = std::max(depth, overlaps[static_cast<std::size_t>(std::countr_zero(met))]);
          has_grown = true;
        }
        if (!(depth < enough)) {
          return depth;
        }
      }
    }
    return depth;
  }

  SmallVector<FourParts<B>, 24> fours_;
  SmallVector<std::size_t, 96> offering_;
  std::size_t size_ = 0;
  Real noise_ = 0, deepest_ = 0;
  SmallVector<Vec3, 192> ways_;
  std::array<std::size_t, known_ways> known_{};  // numbers of ways, each where its bits lead
};

}  // namespace abut
