// SPDX-License-Identifier: Apache-2.0
// How deep two surfaces are in each other, of which one or both are solid. The least way out that is found is an upper
// bound, as with a convex shape. Points that lie deep in both give a lower one.
export module abut.narrow.many.solid_pair_depth;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.many.solid_depth;
import abut.narrow.many.solid_pair_exit;
import abut.narrow.many.solid_point;
import abut.narrow.many.two_parts;

export namespace abut {

template <Enclosing A, Enclosing B>
class SolidPairDepthSearch {
 public:
  SolidPairDepthSearch(const A& a, const B& b, const Pose& ab, const QuerySettings& settings)
      : a_(a), b_(b), ab_(ab), exit_(a, b, ab, settings) {}

  // Nothing where both are outside of each other.
  [[nodiscard]] std::optional<SolidDepth> find() {
    const bool do_cross = exit_.do_cross({0, 0, 0});
    const std::optional<Vec3> inside = do_cross ? std::nullopt : exit_.place_inside({0, 0, 0});
    if (!do_cross && !inside) {
      return std::nullopt;
    }
    try_boxes();
    if (inside) {
      try_from(*inside);
    } else {
      find_crossings();
    }
    for (const Vec3& direction : outward_.span()) {
      try_along(direction, first_along(direction));
    }
    refine();
    raise_lower();
    return SolidDepth{best_, std::clamp(lower_, Real{0}, best_.length), exit_.touching()};
  }

 private:
  static constexpr std::size_t most_directions = 4, most_crossings = 256;
  static constexpr int most_turns = 7, most_climbs = 4;
  static constexpr Real same_direction = 0.9, settled_share = 1e-4;

  struct Crossing {
    std::uint32_t of_a, of_b;
  };

  [[nodiscard]] bool is_settled() const {
    return best_.length - lower_ <= settled_share * best_.length + exit_.touching();
  }

  // Directions out of triangles that cross: of all together, then of those that differ. Trees give them in an order of
  // their own, which edits change. Of very many triangles some tell enough, evenly taken.
  void find_crossings() {
    SmallVector<Crossing, 2 * most_crossings> all;
    visit_two_parts(a_, b_, ab_, 0, [&](const Triangle& part, const Triangle& other) {
      all.push_back({part.index(), other.index()});
      return Real{0};
    });
    std::ranges::sort(all.span(), {}, [](const Crossing& its) { return std::pair(its.of_a, its.of_b); });
    Vec3 sum{0, 0, 0};
    SmallVector<Vec3, most_directions> apart;
    const auto add = [&](const Vec3& front, bool is_turned) {
      const Vec3 outward = is_turned ? -front : front;
      sum += outward;
      const bool is_known =
          std::ranges::any_of(apart.span(), [&](const Vec3& known) { return dot(known, outward) > same_direction; });
      if (!is_known && apart.size() < most_directions) {
        apart.push_back(outward);
      }
    };
    const std::size_t stride = all.size() / most_crossings + 1;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& [of_a, of_b] = all[i];
      if (a_.is_solid()) {
        add(a_.part(of_a).normal(), a_.is_turned(of_a));
      }
      if (b_.is_solid()) {
        add(-(ab_.rotation * b_.part(of_b).normal()), b_.is_turned(of_b));
      }
      if (i % stride == 0) {
        crossings_.push_back(all[i]);
      }
    }
    outward_.push_back(sum);
    for (const Vec3& direction : apart.span()) {
      outward_.push_back(direction);
    }
  }

  // A way after which the triangles that cross have passed each other.
  [[nodiscard]] Real first_along(const Vec3& direction) const {
    const Vec3 unit = normalized_or_zero(direction), local = ab_.rotation.undo(unit);
    Real first = 0;
    for (const Crossing& crossing : crossings_.span()) {
      first = std::max(first, -least_along(a_.corners(crossing.of_a), -unit) -
                                  least_along(b_.corners(crossing.of_b), local) - dot(unit, ab_.position));
    }
    return first;
  }
  [[nodiscard]] static Vec3 normalized_or_zero(const Vec3& direction) {
    const std::optional<UnitVec3> unit = UnitVec3::make(direction);
    return unit ? unit->vec() : Vec3{0, 0, 0};
  }

  // The best of the six ways along the axes after which the boxes are apart.
  void try_boxes() {
    const Aabb box = a_.aabb(Pose::identity()), around = b_.aabb(ab_);
    Vec3 best{0, 0, 1};
    Real least = infinity;
    const auto take = [&](const Vec3& direction, Real length) {
      if (length < least) {
        least = length;
        best = direction;
      }
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 along{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      take(along, box.high[axis] - around.low[axis]);
      take(-along, around.high[axis] - box.low[axis]);
    }
    try_along(best, infinity);
  }

  // From a place of b in a to the nearest surface of a; of a in b, the other way round.
  void try_from(const Vec3& place) {
    if (a_.is_solid() && a_.contains(place)) {
      const Vec3 way = nearest_on_surface(a_, place).point - place;
      try_along(way, norm(way));
    } else {
      const Vec3 local = ab_.undo(place), way = local - nearest_on_surface(b_, local).point;
      try_along(ab_.rotation * way, norm(way));
    }
  }

  // `first`: where the end is first looked for; without end from where both have passed each other.
  WayOut try_along(const Vec3& direction, Real first) {
    const std::optional<UnitVec3> unit = UnitVec3::make(direction);
    if (!unit) {
      return best_;
    }
    const WayOut way = exit_.along(*unit, first, best_.length);
    if (way.length < best_.length) {
      best_ = way;
    }
    return way;
  }

  // Along the shortest move that leaves all that was touched about the best way.
  void refine() {
    LeavingMoves moves;
    moves.add(best_);
    for (int turn = 0; turn < most_turns; ++turn) {
      const Vec3 move = moves.shortest();
      if (!(norm(move) < (1 - settled_share) * best_.length)) {
        return;
      }
      moves.add(try_along(move, (1 + settled_share) * norm(move)));
    }
  }

  // A point of one that is inside of the other takes as far as the surface. Around a point that is inside of both there
  // is a ball of each: they are parted after both radii.
  void raise_lower() {
    const Vec3 of_a = best_.point, of_b = best_.point - best_.length * best_.direction;
    if (a_.is_solid()) {
      lower_ = std::max(lower_, depth_of_point(a_, of_b));
      raise_lower_by_corner(b_, a_, ab_, ab_.rotation.undo(best_.direction));
    }
    if (b_.is_solid()) {
      lower_ = std::max(lower_, depth_of_point(b_, ab_.undo(of_a)));
      raise_lower_by_corner(a_, b_, ab_.inverse(), -best_.direction);
    }
    if (a_.is_solid() && b_.is_solid()) {
      climb(0.5 * (of_a + of_b));
    }
  }

  // The corner of `of` that is last on the way out; of several the least by its coordinates.
  template <class Of, class In>
  void raise_lower_by_corner(const Of& of, const In& in, const Pose& to_in, const Vec3& direction) {
    Vec3 lowest{infinity, 0, 0};
    Real limit = infinity;
    of.visit_below(direction, limit, [&](const Triangle& part, std::uint32_t) {
      for (const Vec3& corner : part.corners()) {
        const Real height = dot(corner, direction);
        if (std::tuple(height, corner.x, corner.y, corner.z) < std::tuple(limit, lowest.x, lowest.y, lowest.z)) {
          limit = height;
          lowest = corner;
        }
      }
    });
    lower_ = std::max(lower_, depth_of_point(in, to_in * lowest));
  }

  // Away from both surfaces, as long as that makes the sum of both balls larger.
  void climb(Vec3 place) {
    Real before = 0;
    for (int step = 0; step < most_climbs && !is_settled(); ++step) {
      const Vec3 local = ab_.undo(place);
      if (!a_.contains(place) || !b_.contains(local)) {
        return;
      }
      const PointOnSurface of_a = nearest_on_surface(a_, place), of_b = nearest_on_surface(b_, local);
      const Real sum = of_a.distance + of_b.distance;
      lower_ = std::max(lower_, sum);
      if (sum <= before) {
        return;
      }
      before = sum;
      const Vec3 up = normalized_or_zero(place - of_a.point) + normalized_or_zero(ab_.rotation * (local - of_b.point));
      place += 0.25 * (best_.length - sum) * up;
    }
  }

  const A& a_;
  const B& b_;
  const Pose& ab_;
  SolidPairExit<A, B> exit_;
  SmallVector<Crossing, most_crossings> crossings_;
  SmallVector<Vec3, most_directions + 1> outward_;
  WayOut best_{{0, 0, 1}, infinity, {0, 0, 0}, {0, 0, 1}, no_index};
  Real lower_ = -infinity;
};

template <Enclosing A, Enclosing B>
[[nodiscard]] std::optional<SolidDepth> solid_pair_depth(const A& a, const B& b, const Pose& ab,
                                                         const QuerySettings& settings) {
  return SolidPairDepthSearch<A, B>(a, b, ab, settings).find();
}

}  // namespace abut
