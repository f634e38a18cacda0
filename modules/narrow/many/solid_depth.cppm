// SPDX-License-Identifier: Apache-2.0
// How deep a convex shape is in a solid surface: the least way out that is found, and what no way out is shorter than.
// A way out ends where the shape overlaps nothing. There the surface that is touched tells how to turn the way (after
// Je et al., "PolyDepth: real-time penetration depth computation using iterative contact-space projection", 2012).
export module abut.narrow.many.solid_depth;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.many.solid_exit;
import abut.narrow.many.solid_point;

export namespace abut {

// The true depth lies between `lower` and the length of the way out.
struct SolidDepth {
  WayOut way;
  Real lower;
  Real touching;  // lengths below this are rounding
};

struct BallInside {
  Vec3 centre;
  Real radius;
};
// A ball inside a convex shape.
template <Convex B>
[[nodiscard]] BallInside ball_inside(const B& b) {
  if constexpr (BoxCored<B>) {
    const Vec3 half = b.half();
    return {{0, 0, 0}, b.radius() + std::min(std::min(half.x, half.y), half.z)};
  } else if constexpr (Field<B>) {
    return {b.centre(), b.radius() + std::max(-b.nearest(b.centre()).distance, Real{0})};
  } else if constexpr (Faceted<B>) {
    const auto& facets = b.facets();
    return facets.inner > 0 ? BallInside{facets.middle, b.radius() + facets.inner} : BallInside{b.centre(), b.radius()};
  } else {
    return {b.centre(), b.radius()};
  }
}

// Half-spaces of moves that leave what was touched, and the shortest move in all of them (Hildreth 1957).
class LeavingMoves {
 public:
  void add(const WayOut& way) {
    if (count_ < moves_.size()) {
      moves_[count_++] = {way.normal, way.length * dot(way.normal, way.direction)};
    }
  }
  [[nodiscard]] Vec3 shortest() const {
    constexpr int rounds = 40;
    std::array<Real, most> weights{};
    Vec3 move{0, 0, 0};
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < count_; ++i) {
        const Real weight = std::max(weights[i] + moves_[i].least - dot(moves_[i].normal, move), Real{0});
        move += (weight - weights[i]) * moves_[i].normal;
        weights[i] = weight;
      }
    }
    return move;
  }

 private:
  static constexpr std::size_t most = 8;
  struct Half {
    Vec3 normal;
    Real least;
  };
  std::array<Half, most> moves_{};
  std::size_t count_ = 0;
};

template <Enclosing A, Convex B>
class SolidDepthSearch {
 public:
  SolidDepthSearch(const A& a, const B& b, const Pose& ab, const QuerySettings& settings)
      : a_(a), b_(b), ab_(ab), exit_(a, b, ab, settings) {}

  // Nothing where the shape is outside.
  [[nodiscard]] std::optional<SolidDepth> find() {
    if constexpr (PointCored<B>) {
      if (b_.radius() == 0) {
        return depth_of_lone_point();
      }
    }
    find_overlaps();
    if (outward_.empty() && !is_inside()) {
      return std::nullopt;
    }
    try_from_middle();
    for (const Vec3& direction : outward_.span()) {
      try_along(direction);
    }
    if (!is_settled()) {
      try_along({0, 0, 1});
      if constexpr (!Terrain<A>) {
        for (const Vec3& axis : {Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
          try_along(axis);
        }
      }
    }
    refine();
    raise_lower();
    return SolidDepth{best_, std::min(std::max(lower_, Real{0}), best_.length), exit_.touching()};
  }

 private:
  static constexpr std::size_t most_directions = 12;
  static constexpr int most_turns = 6;
  static constexpr Real same_direction = 0.98, settled_share = 1e-3, same_share = 1e-9;

  // Whether the shape is inside where it overlaps no triangle. What is thin may cross the surface between triangles.
  [[nodiscard]] bool is_inside() const {
    if (exit_.place_inside({0, 0, 0})) {
      return true;
    }
    return std::ranges::any_of(exit_.corners(), [&](const Vec3& corner) {
      return exit_.inside_at(corner) && depth_of_point(a_, corner) > exit_.touching();
    });
  }

  [[nodiscard]] bool is_settled() const {
    return best_.length < infinity && best_.length - lower_ <= settled_share * best_.length + exit_.touching();
  }

  // A point is out as soon as it is on the surface. Behind an edge that bends inward it would be in again.
  [[nodiscard]] std::optional<SolidDepth> depth_of_lone_point() const {
    const Vec3 point = ab_ * b_.centre();
    if (!a_.contains(point)) {
      return std::nullopt;
    }
    const PointOnSurface nearest = nearest_on_surface(a_, point);
    const Vec3 front = a_.part(nearest.part).normal(), outward = a_.is_turned(nearest.part) ? -front : front;
    const Vec3 direction =
        nearest.distance > exit_.touching() ? (1 / nearest.distance) * (nearest.point - point) : outward;
    return SolidDepth{
        {direction, nearest.distance, nearest.point, direction, nearest.part}, nearest.distance, exit_.touching()};
  }

  // Directions out of the triangles that are overlapped, and of all together.
  void find_overlaps() {
    Vec3 sum{0, 0, 0};
    exit_.visit_overlaps([&](const Triangle& part) {
      const Vec3 outward = a_.is_turned(part.index()) ? -part.normal() : part.normal();
      const TriangleCorners& corners = part.corners();
      sum += std::sqrt(squared_norm(cross(corners[1] - corners[0], corners[2] - corners[0]))) * outward;
      const bool is_known =
          std::ranges::any_of(outward_.span(), [&](const Vec3& known) { return dot(known, outward) > same_direction; });
      if (part.has_area() && !is_known && outward_.size() < most_directions) {
        outward_.push_back(outward);
      }
    });
    if (!outward_.empty()) {
      outward_.push_back(sum);
    }
  }

  // Toward the nearest surface from inside, away from it from outside.
  void try_from_middle() {
    const BallInside ball = ball_inside(b_);
    const Vec3 middle = ab_ * ball.centre;
    const PointOnSurface nearest = nearest_on_surface(a_, middle);
    const bool is_inside = a_.contains(middle);
    lower_ = ball.radius + (is_inside ? nearest.distance : -nearest.distance);
    if (nearest.distance > exit_.touching()) {
      try_along(is_inside ? nearest.point - middle : middle - nearest.point);
    } else {
      const Vec3 normal = a_.part(nearest.part).normal();
      try_along(a_.is_turned(nearest.part) ? -normal : normal);
    }
    // Points further down reach deeper, and have less of the shape around them.
    const Vec3 lowest = placed_support(b_, place(b_, ab_), -best_.direction).point;
    for (const Real share : {1.0, 0.5}) {
      if (!is_settled()) {
        raise_lower_at(middle + share * (lowest - middle), ball.radius + share * (b_.radius() - ball.radius));
      }
    }
  }
  // A ball of this radius around the point is in the shape: no shorter way takes it out.
  void raise_lower_at(const Vec3& point, Real radius) { lower_ = std::max(lower_, radius + depth_of_point(a_, point)); }
  // The same down the way that was found in the end.
  void raise_lower() {
    if (is_settled()) {
      return;
    }
    const BallInside ball = ball_inside(b_);
    const Vec3 middle = ab_ * ball.centre, lowest = placed_support(b_, place(b_, ab_), -best_.direction).point;
    for (const Real share : {1.0, 0.75, 0.5, 0.25}) {
      raise_lower_at(middle + share * (lowest - middle), ball.radius + share * (b_.radius() - ball.radius));
    }
  }

  WayOut try_along(const Vec3& direction) {
    const std::optional<UnitVec3> unit = UnitVec3::make(direction);
    if (!unit || is_settled()) {
      return best_;
    }
    const WayOut way = exit_.along(*unit, best_.length);
    if (way.length < best_.length) {
      best_ = way;
      // Where the shape touches in the end, it was deepest before.
      if (!is_settled()) {
        raise_lower_at(best_.point - best_.length * best_.direction, 0);
      }
    }
    return way;
  }

  // Along the shortest move that leaves all that was touched about the best way.
  void refine() {
    LeavingMoves moves;
    moves.add(best_);
    for (int turn = 0; turn < most_turns && !is_settled(); ++turn) {
      const Vec3 move = moves.shortest();
      if (!(norm(move) < (1 - same_share) * best_.length)) {
        return;
      }
      moves.add(try_along(move));
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

template <Enclosing A, Convex B>
[[nodiscard]] std::optional<SolidDepth> solid_depth(const A& a, const B& b, const Pose& ab,
                                                    const QuerySettings& settings) {
  return SolidDepthSearch<A, B>(a, b, ab, settings).find();
}

// The distance along a way out; bounds are those of depths.
[[nodiscard]] inline Distance distance_of(const SolidDepth& depth) {
  const WayOut& way = depth.way;
  return {-way.length,
          -way.length,
          -depth.lower,
          way.point,
          way.point - way.length * way.direction,
          way.direction,
          Algorithm::solid,
          1};
}

}  // namespace abut
