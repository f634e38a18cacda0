// SPDX-License-Identifier: Apache-2.0
// Caps of directions in which the support function of a difference D is surely no less than a depth.
//
// There is one around each least depth that is known, and one for each ball inside D. A ball of radius r around m has
// this support function, which is at least d in a cap around m:
//   dot(m, v) + r
export module abut.narrow.cores.direction_cover;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class DirectionCover {
 public:
  static constexpr std::size_t limit = 16;

  inline void add(const Vec3& normal, Real cosine) {
    if (count_ < limit) {
      caps_[count_++] = {normal, cosine, 0};
    }
  }
  // Its cap depends on the depth, which set_depth() tells.
  inline void add_ball(const Vec3& middle, Real radius) {
    ball_radius_ = radius;
    const Real away = norm(middle);
    const Vec3 toward = away > 0 ? (1 / away) * middle : Vec3{0, 0, 1};
    if (count_ < limit) {
      caps_[count_++] = {toward, 1, away > 0 ? away : least_away};
    }
  }
  inline void set_depth(Real depth) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (caps_[i].away > 0) {
        caps_[i].cosine = (depth - ball_radius_) / caps_[i].away;
      }
    }
  }

  // Whether one cap holds all directions within an angle of a normal. `share`: the cosine of the angle.
  [[nodiscard]] [[gnu::always_inline]] inline bool holds(const Vec3& normal, Real share) const {
    const Real share_square = share < 1 ? 1 - share * share : 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Real cosine = dot(caps_[i].normal, normal), beyond = cosine * share - caps_[i].cosine;
      if (cosine > -share && beyond >= 0 && beyond * beyond >= (1 - cosine * cosine) * share_square) {
        return true;
      }
    }
    return false;
  }

 private:
  static constexpr Real least_away = 1e-300;
  struct Cap {
    Vec3 normal;
    Real cosine;
    Real away;  // of the middle of a ball from the origin; of other caps 0
  };
  std::array<Cap, limit> caps_;
  std::size_t count_ = 0;
  Real ball_radius_ = 0;
};

// A box has balls along its longest axis; a hull knows of one ball.
template <Convex S>
[[nodiscard]] inline InnerBalls inner_balls_of(const S& shape) {
  if constexpr (requires { shape.inner_balls(); }) {
    return shape.inner_balls();
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    const Real ball = half.x < half.y ? (half.x < half.z ? half.x : half.z) : (half.y < half.z ? half.y : half.z);
    const Real longest = largest_magnitude(half);
    const Vec3 along = half.x == longest   ? Vec3{longest - ball, 0, 0}
                       : half.y == longest ? Vec3{0, longest - ball, 0}
                                           : Vec3{0, 0, longest - ball};
    return {{0, 0, 0}, along, ball};
  } else if constexpr (requires { shape.facets().inner; }) {
    return {shape.facets().middle, {0, 0, 0}, shape.facets().inner};
  } else {
    return {shape.centre(), {0, 0, 0}, 0};
  }
}

// The balls inside the difference, `noise` smaller than they are.
template <Convex A, Convex B>
inline void add_inner_balls(const A& a, const B& b, const Pose& ab, Real noise, DirectionCover& cover) {
  const InnerBalls balls_a = inner_balls_of(a), balls_b = inner_balls_of(b);
  const Real radius = balls_a.radius + balls_b.radius - noise;
  if (!(radius > 0)) {
    return;
  }
  const Vec3 middle = balls_a.centre - ab * balls_b.centre, half_b = ab.rotation * balls_b.half;
  const bool is_long_a = largest_magnitude(balls_a.half) > 0, is_long_b = largest_magnitude(half_b) > 0;
  for (const Real side_a : {1.0, -1.0}) {
    for (const Real side_b : {1.0, -1.0}) {
      if ((is_long_a || side_a > 0) && (is_long_b || side_b > 0)) {
        cover.add_ball(middle + side_a * balls_a.half + side_b * half_b, radius);
      }
    }
  }
}

}  // namespace abut
