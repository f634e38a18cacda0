// SPDX-License-Identifier: Apache-2.0
// What is kept of a pair from one query to the next, and what it still proves after both bodies have moved.
//
// - A pair that was apart keeps a direction and the gap along it. The gap shrinks by no more than b has turned and
//   moved toward a.
// - A pair that overlaps keeps the features whose normal has the least depth, and a ball inside the Minkowski
//   difference. The ball moves along with b and shrinks by what b has turned.
//
// Nothing kept changes an answer. It spares a search whose end it proves.
export module abut.narrow.warm.pair_memory;
import abut.capability.cores.core_feature;
import abut.core.standard;
import abut.math;

export namespace abut {

// All zero it knows nothing. Valid for two shapes in this order, whatever their poses. Numbers are single: rounding is
// taken off where they are stored. A cache line of its own: threads write memories of neighbours at once.
struct alignas(64) PairMemory {
  enum class State : std::uint8_t { nothing, apart, touching, touching_with_ball };
  std::array<float, 3> vector;  // apart: from a to b, about unit; else where the ball would be with the pivot at zero
  float length;                 // apart: the gap with the pivot at zero; else the radius of the ball
  std::array<float, 3> turn_x, turn_y;  // of b, as it was
  float reach;                          // no point of the core of b is further from the pivot
  CoreFeatures features;                // touching: those of the normal
  State state;
  std::uint8_t debts;  // searches that balls have yet to spare to be worth their cost
  std::uint8_t waits;  // searches to go before the next ball is looked for
  bool is_from_b;      // for callers that choose which shape comes first: whether it was the second one
};
static_assert(sizeof(PairMemory) <= 64 && std::is_trivially_copyable_v<PairMemory>);

// Larger than the relative rounding of single precision.
inline constexpr Real single_rounding = 1.5e-7;

[[nodiscard]] inline Vec3 vec3_of(const std::array<float, 3>& v) {
  return {static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2])};
}
[[nodiscard]] inline std::array<float, 3> singles_of(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// No point of b has moved further by turning about its pivot. A difference of two rotations stretches a vector by at
// most the norm of its three columns over the root of two. The first rotation is kept rounded.
[[nodiscard]] inline Real turned_by(const PairMemory& memory, const Rotation& now) {
  const Vec3 x = vec3_of(memory.turn_x), y = vec3_of(memory.turn_y);
  const Real square = squared_norm(now.x - x) + squared_norm(now.y - y) + squared_norm(now.z - cross(x, y));
  return static_cast<Real>(memory.reach) * (std::sqrt(0.5 * square) + 4 * single_rounding);
}

inline void keep_turn(const Rotation& now, Real reach, PairMemory& memory) {
  memory.turn_x = singles_of(now.x);
  memory.turn_y = singles_of(now.y);
  memory.reach = static_cast<float>(reach * (1 + single_rounding));
}

// A lower bound of the gap along the kept direction; `pivot` of b in the frame of a.
[[nodiscard]] inline Real gap_kept(const PairMemory& memory, const Rotation& now, const Vec3& pivot) {
  const Vec3 direction = vec3_of(memory.vector);
  const Real gap =
      static_cast<Real>(memory.length) + dot(direction, pivot) - (1 + 4 * single_rounding) * turned_by(memory, now);
  return gap * (1 - 4 * single_rounding);
}
// `gap`: along the kept direction, measured.
inline void keep_gap(Real gap, const Rotation& now, const Vec3& pivot, Real reach, PairMemory& memory) {
  const Real length = gap - dot(vec3_of(memory.vector), pivot);
  memory.length = static_cast<float>(length - single_rounding * std::fabs(length));
  keep_turn(now, reach, memory);
  memory.state = PairMemory::State::apart;
}

// A ball inside the Minkowski difference of a and b.
struct InnerBall {
  Vec3 centre;
  Real radius;
};
[[nodiscard]] inline InnerBall ball_kept(const PairMemory& memory, const Rotation& now, const Vec3& pivot) {
  return {vec3_of(memory.vector) - pivot, static_cast<Real>(memory.length) - turned_by(memory, now)};
}
inline void keep_ball(const InnerBall& ball, const Rotation& now, const Vec3& pivot, Real reach, PairMemory& memory) {
  const Vec3 with_pivot = ball.centre + pivot;
  memory.vector = singles_of(with_pivot);
  const Real radius = ball.radius - 2 * single_rounding * (largest_magnitude(with_pivot) + ball.radius);
  memory.length = static_cast<float>(radius);
  keep_turn(now, reach, memory);
  memory.state = PairMemory::State::touching_with_ball;
}

// The proof below uses this part of the disc. What it passes over is then deeper by more than rounding.
inline constexpr Real disc_share = 0.9;

// The Minkowski difference contains the origin, a ball, and a facet at `depth` along the unit `normal`. The facet
// contains a disc of radius `clearance` around its point nearest to the origin. True where no other facet is as near:
// - t is the angle between the normal and another direction. The disc reaches depth cos(t) + clearance sin(t) there.
// - That is at least `depth` while tan(t / 2) <= clearance / depth.
// - Beyond that angle the ball has to reach `depth` and `margin`.
[[nodiscard]] inline bool is_least_depth(Real depth, const Vec3& normal, Real clearance, const InnerBall& ball,
                                         Real margin) {
  if (!(clearance > 0 && ball.radius > 0)) {
    return false;
  }
  const Real disc = disc_share * clearance;
  const Real along = dot(ball.centre, normal);
  const Real aside = std::sqrt(std::max(squared_norm(ball.centre) - along * along, Real{0}));
  const Real squares = 1 / (depth * depth + disc * disc);
  const Real cosine = (depth * depth - disc * disc) * squares, sine = 2 * depth * disc * squares;
  // The worst direction at this angle leads away from the ball. Those beyond it are better, unless one of them leads
  // straight away from the ball.
  const bool is_growing = -along * sine - aside * cosine >= 0;
  const Real least = is_growing ? along * cosine - aside * sine : -norm(ball.centre);
  return least + ball.radius >= depth + margin;
}

}  // namespace abut
