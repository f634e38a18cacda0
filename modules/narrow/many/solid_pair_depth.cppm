// SPDX-License-Identifier: Apache-2.0
// How deep two surfaces are in each other, of which one or both are solid. The least way out that is found is an upper
// bound, as with a convex shape. Corners of one that lie deep in the other give a lower one.
export module abut.narrow.many.solid_pair_depth;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.many.solid_depth;
import abut.narrow.many.solid_point;

export namespace abut {

template <Enclosing A, Enclosing B>
class SolidPairDepthSearch {
 public:
  SolidPairDepthSearch(const A& a, const B& b, const Pose& ab, const QuerySettings& settings)
      : a_(a), b_(b), ab_(ab), exit_(a, b, ab, settings) {}

  // Nothing where both are outside of each other.
  [[nodiscard]] std::optional<SolidDepth> find() {
    find_overlaps();
    const std::optional<Vec3> inside = outward_.empty() ? exit_.place_inside({0, 0, 0}) : std::nullopt;
    if (outward_.empty() && !inside) {
      return std::nullopt;
    }
    try_boxes();
    if (inside) {
      try_from(*inside);
    }
    for (const Vec3& direction : outward_.span()) {
      try_along(direction);
    }
    refine();
    raise_lower();
    return SolidDepth{best_, std::min(std::max(lower_, Real{0}), best_.length)};
  }

 private:
  static constexpr std::size_t most_directions = 4, most_places = 12;
  static constexpr int most_turns = 3;
  static constexpr Real same_direction = 0.9, settled_share = 1e-6;

  [[nodiscard]] bool is_settled() const {
    return best_.length - lower_ <= settled_share * best_.length + exit_.touching();
  }

  // Directions out of the triangles of a solid that are overlapped: of all together, then of those that differ.
  void find_overlaps() {
    Vec3 sum{0, 0, 0};
    SmallVector<Vec3, most_directions> apart;
    exit_.visit_overlaps([&](const Triangle& part, const Triangle& other) {
      const bool is_of_a = a_.is_solid();
      const Triangle& of_solid = is_of_a ? part : other;
      const bool is_turned = is_of_a ? a_.is_turned(part.index()) : b_.is_turned(other.index());
      const Vec3 front = is_of_a ? of_solid.normal() : -(ab_.rotation * of_solid.normal());
      const Vec3 outward = is_turned ? -front : front;
      sum += outward;
      if (is_of_a && b_.is_solid()) {
        const Vec3 toward = -(ab_.rotation * other.normal());
        sum += b_.is_turned(other.index()) ? -toward : toward;
      }
      const bool is_known =
          std::ranges::any_of(apart.span(), [&](const Vec3& known) { return dot(known, outward) > same_direction; });
      if (!is_known && apart.size() < most_directions) {
        apart.push_back(outward);
      }
    });
    if (!apart.empty()) {
      outward_.push_back(sum);
      for (const Vec3& direction : apart.span()) {
        outward_.push_back(direction);
      }
    }
  }

  // The six ways along the axes after which the boxes are apart.
  void try_boxes() {
    const Aabb box = a_.aabb(Pose::identity()), around = b_.aabb(ab_);
    const auto take = [&](const Vec3& direction, Real length) {
      if (length < best_.length) {
        const Vec3 middle = around.centre() + length * direction;
        best_ = {direction, length, middle, direction, no_index};
      }
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 along{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      take(along, box.high[axis] - around.low[axis]);
      take(-along, around.high[axis] - box.low[axis]);
    }
    if (best_.length < infinity) {
      const Vec3 direction = best_.direction;
      best_.length = (1 + 1e-12) * best_.length;
      try_along(direction);
    }
  }

  // From a place of b in a to the nearest surface of a; of a in b, the other way round.
  void try_from(const Vec3& place) {
    if (a_.is_solid() && a_.contains(place)) {
      try_along(nearest_on_surface(a_, place).point - place);
    } else {
      const Vec3 local = ab_.undo(place);
      try_along(ab_.rotation * (local - nearest_on_surface(b_, local).point));
    }
  }

  WayOut try_along(const Vec3& direction) {
    const std::optional<UnitVec3> unit = UnitVec3::make(direction);
    if (!unit) {
      return best_;
    }
    const WayOut way = exit_.along(*unit, best_.length);
    if (way.length < best_.length) {
      best_ = way;
    }
    return way;
  }

  void refine() {
    LeavingMoves moves;
    moves.add(best_);
    for (int turn = 0; turn < most_turns; ++turn) {
      const Vec3 move = moves.shortest();
      if (!(norm(move) < (1 - settled_share) * best_.length)) {
        return;
      }
      moves.add(try_along(move));
    }
  }

  // Corners that are last on the way out, of either in the other. A point that is inside takes as far as the surface.
  void raise_lower() {
    const Vec3 d = best_.direction;
    if (a_.is_solid()) {
      raise_lower_by(b_, a_, ab_, a_.aabb(ab_.inverse()), ab_.rotation.undo(d));
    }
    if (b_.is_solid()) {
      raise_lower_by(a_, b_, ab_.inverse(), b_.aabb(ab_), -d);
    }
  }
  template <class Of, class In>
  void raise_lower_by(const Of& of, const In& in, const Pose& to_in, const Aabb& near, const Vec3& direction) {
    struct Place {
      Real height;
      Vec3 point;
    };
    SmallVector<Place, most_places> lowest;
    Aabb query = near;
    of.visit_parts(query, [&](const Triangle& part, std::uint32_t) {
      const Vec3 corner = part.support(-direction).point;
      const Place place{dot(corner, direction), corner};
      if (lowest.size() < most_places) {
        lowest.push_back(place);
        return;
      }
      Place* const highest = &*std::max_element(lowest.span().begin(), lowest.span().end(),
                                                [](const Place& a, const Place& b) { return a.height < b.height; });
      const bool is_listed = std::ranges::any_of(lowest.span(), [&](const Place& l) { return l.point == corner; });
      *highest = place.height < highest->height && !is_listed ? place : *highest;
    });
    for (const Place& place : lowest.span()) {
      lower_ = std::max(lower_, depth_of_point(in, to_in * place.point));
    }
  }

  const A& a_;
  const B& b_;
  const Pose& ab_;
  SolidExit<A, B> exit_;
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
