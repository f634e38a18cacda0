// SPDX-License-Identifier: Apache-2.0
// How a body moves within a step, and how fast and how far its points do at most.
export module abut.motion.paths.path;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Along the axes of the world, by the unit of time; angles in radians.
struct Motion {
  Vec3 velocity{0, 0, 0}, angular_velocity{0, 0, 0};
  Vec3 acceleration{0, 0, 0}, angular_acceleration{0, 0, 0};

  friend constexpr bool operator==(const Motion&, const Motion&) = default;
};

struct TimeSpan {
  Real begin, end;

  [[nodiscard]] inline constexpr Real length() const { return end - begin; }
};

// How far the points of a body are from its centre at most, and from the axis through its centre around which it turns.
struct Reach {
  Real radius, from_axis;
};

// A path may turn a body no further than this.
inline constexpr Real most_revolutions = 16;

// After a time t the centre of the body is where velocity * t + acceleration * t^2 / 2 has brought it. The body has
// turned by the rotation whose axis times angle is angular_velocity * t + angular_acceleration * t^2 / 2. Where both
// have one direction, that is a turn around a fixed axis with the given speed and acceleration.
//
// Bounds hold for the path as it is computed: they are rounded outward.
class Path {
 public:
  // `centre` is a point of the body, in its frame. Faults name the members of Motion, or `duration`.
  [[nodiscard]] static Result<Path> along(const Pose& start, const Vec3& centre, const Motion& motion, Real duration);
  // The centre moves on a straight line. The body turns around a fixed axis, by the shorter way. Both speeds are
  // constant. It ends at `end` within rounding.
  [[nodiscard]] static Result<Path> between(const Pose& start, const Pose& end, const Vec3& centre, Real duration);
  [[nodiscard]] static Path at_rest(const Pose& pose, Real duration) { return {pose, {0, 0, 0}, {}, duration}; }

  [[nodiscard]] const Motion& motion() const [[clang::lifetimebound]] { return motion_; }
  [[nodiscard]] const Pose& start() const [[clang::lifetimebound]] { return start_; }
  [[nodiscard]] Real duration() const { return duration_; }
  [[nodiscard]] TimeSpan whole() const { return {0, duration_}; }
  [[nodiscard]] bool turns() const { return turns_; }

  // Exactly the start at time 0.
  [[nodiscard]] Pose at(Real time) const;
  // How far the centre has moved.
  [[nodiscard]] Vec3 shift_at(Real time) const {
    return time * (motion_.velocity + (0.5 * time) * motion_.acceleration);
  }
  [[nodiscard]] Vec3 centre_at(Real time) const { return centre_at_start_ + shift_at(time); }
  // The velocity of the centre.
  [[nodiscard]] Vec3 velocity_at(Real time) const { return motion_.velocity + time * motion_.acceleration; }

  // The same seen from an origin that moves, and does not turn.
  [[nodiscard]] Path seen_from(const Vec3& origin, const Vec3& velocity, const Vec3& acceleration) const;

  // How fast the body turns at time, as an axis times radians; an estimate where the axis turns as well.
  [[nodiscard]] Vec3 turning_at(Real time) const {
    return motion_.angular_velocity + time * motion_.angular_acceleration;
  }
  // The largest speed of a point at distance 1 from the axis, and the largest acceleration.
  [[nodiscard]] Real largest_turning(const TimeSpan& span) const;
  [[nodiscard]] Real largest_turning_acceleration(const TimeSpan& span) const;

  // Of a body within a box in its own frame. Infinite for a box that is.
  [[nodiscard]] Reach reach_of(const Aabb& local) const;
  // From the centre alone.
  [[nodiscard]] Real radius_of(const Aabb& local) const;

  // The largest speed of a point up to `radius` from the centre.
  [[nodiscard]] Real largest_speed(const TimeSpan& span, Real radius) const;
  // The largest and the least speed of a point along a unit vector.
  [[nodiscard]] Real largest_speed_along(const Vec3& direction, const TimeSpan& span, const Reach& reach) const;
  // The largest part of the acceleration of a point along a unit vector; negative where all points are slowed down.
  [[nodiscard]] Real largest_acceleration_along(const Vec3& direction, const TimeSpan& span, const Reach& reach) const;
  // Think of a second point that moves straight, at constant speed, between the same ends of the span. A point up to
  // `radius` from the centre is no further from it than this: an eighth of the acceleration times the square of the
  // time.
  [[nodiscard]] Real largest_deviation(const TimeSpan& span, Real radius) const;

  // A box that contains the body at all times of a span. It needs the boxes of the body in the world at both ends of
  // the span, and how far its points are from the centre. Boxes may be infinite.
  [[nodiscard]] Aabb swept_box(const Aabb& at_begin, const Aabb& at_end, const TimeSpan& span, Real radius) const;

 private:
  Path(const Pose& start, const Vec3& centre, const Motion& motion, Real duration);

  // How much of a turn can be seen along a unit vector.
  [[nodiscard]] Real share_across(const Vec3& direction) const;

  Pose start_;
  Vec3 centre_;        // in the frame of the body
  Vec3 arm_at_start_;  // from the origin of the body to its centre, in the world
  Vec3 centre_at_start_;
  Motion motion_;
  Real duration_;
  Vec3 axis_{0, 0, 0};                                                    // of a turn whose axis is fixed
  Real acceleration_ = 0, angular_speed_ = 0, angular_acceleration_ = 0;  // lengths of those of the motion
  bool turns_ = false, has_fixed_axis_ = true;
};

}  // namespace abut
