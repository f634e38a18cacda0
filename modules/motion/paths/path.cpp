// SPDX-License-Identifier: Apache-2.0
module abut.motion.paths.path;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.math.turn;

namespace abut {
namespace {

// More than all that rounding takes from a bound: relative, and of the sine of an angle.
constexpr Real outward = 1 + 1e-14, rounding_of_sine = 1e-15;

Fault check_vector(std::string_view name, const Vec3& vector) {
  return check_all_finite(name, std::array{vector.x, vector.y, vector.z});
}

Fault check_motion(const Motion& motion) {
  Fault fault = check_vector("velocity", motion.velocity);
  fault = fault ? fault : check_vector("angular_velocity", motion.angular_velocity);
  fault = fault ? fault : check_vector("acceleration", motion.acceleration);
  return fault ? fault : check_vector("angular_acceleration", motion.angular_acceleration);
}

Fault check_revolutions(const Motion& motion, Real duration) {
  const Real angle = duration * (norm(motion.angular_velocity) + 0.5 * duration * norm(motion.angular_acceleration));
  const Real revolutions = angle / (2 * std::numbers::pi);
  if (!(revolutions <= most_revolutions)) {
    return error_about(Errc::out_of_range, "revolutions", revolutions, "at most 16 within the duration");
  }
  return std::nullopt;
}

Fault check_way(const Motion& motion, Real duration) {
  const Real way = duration * (norm(motion.velocity) + 0.5 * duration * norm(motion.acceleration));
  if (!(way <= largest_coordinate)) {
    return error_about(Errc::out_of_range, "way", way, "at most 1e70 within the duration");
  }
  return std::nullopt;
}

// Most are zero, and roots take long.
Real length_of(const Vec3& v) { return v == Vec3{0, 0, 0} ? 0 : norm(v); }

Real larger(Real a, Real b) { return a > b ? a : b; }
Real smaller(Real a, Real b) { return a < b ? a : b; }

// Without NaN for the infinite reach of what does not turn.
Real times(Real factor, Real reach) { return factor > 0 ? factor * reach : 0; }

// One axis of a swept box. All is relative to the centre at the begin of the span.
struct SweptSide {
  Real begin, end;    // of the side of the box
  Real centre_end;    // of the way of the centre
  Real centre_least;  // the least of its way
  Real drop;          // how far a straight way may be above the way of the centre
  Real turned;        // how far turning may lead from the straight way
  Real radius;
};

// The largest of three lower bounds: by straight ways, by the turned body at the centre, and by the ball around it.
Real lower_bound_of(const SweptSide& side) {
  const Real by_lines = smaller(side.begin, side.end) - side.drop - side.turned;
  const Real by_centre = side.centre_least + smaller(side.begin, side.end - side.centre_end) - side.turned;
  return larger(larger(by_lines, by_centre), side.centre_least - side.radius);
}

// The least of speed * t + acceleration * t^2 / 2 for t from 0 to `length`.
Real least_of_parabola(Real speed, Real acceleration, Real length) {
  const Real end = length * (speed + 0.5 * length * acceleration);
  const Real apex = acceleration > 0 ? -speed / acceleration : 0;
  const bool has_apex = apex > 0 && apex < length;
  return smaller(smaller(0, end), has_apex ? 0.5 * speed * apex : 0);
}

Real finite_or_zero(Real value) { return std::isfinite(value) ? std::fabs(value) : 0; }
Real magnitude_of(const Vec3& v) {
  return larger(larger(finite_or_zero(v.x), finite_or_zero(v.y)), finite_or_zero(v.z));
}

}  // namespace

Path::Path(const Pose& start, const Vec3& centre, const Motion& motion, Real duration)
    : start_(start),
      centre_(centre),
      arm_at_start_(start.rotation * centre),
      centre_at_start_(start.position + arm_at_start_),
      motion_(motion),
      duration_(duration) {
  const auto axis = UnitVec3::make(motion.angular_velocity), change = UnitVec3::make(motion.angular_acceleration);
  turns_ = axis || change;
  acceleration_ = length_of(motion.acceleration);
  angular_speed_ = length_of(motion.angular_velocity);
  angular_acceleration_ = length_of(motion.angular_acceleration);
  has_fixed_axis_ = !axis || !change || norm(cross(axis->vec(), change->vec())) <= 4 * epsilon;
  if (turns_ && has_fixed_axis_) {
    axis_ = axis ? axis->vec() : change->vec();
  }
}

Result<Path> Path::along(const Pose& start, const Vec3& centre, const Motion& motion, Real duration) {
  Fault fault = check_motion(motion);
  fault = fault ? fault : check_vector("centre", centre);
  fault = fault ? fault : check_positive("duration", duration);
  fault = fault ? fault : check_way(motion, duration);
  fault = fault ? fault : check_revolutions(motion, duration);
  if (fault) {
    return *std::move(fault);
  }
  return Path(start, centre, motion, duration);
}

Result<Path> Path::between(const Pose& start, const Pose& end, const Vec3& centre, Real duration) {
  if (Fault fault = check_positive("duration", duration)) {
    return *std::move(fault);
  }
  const Real rate = 1 / duration;
  const Vec3 turn = turn_between(quaternion_of(start.rotation), quaternion_of(end.rotation));
  return along(start, centre, {rate * (end * centre - start * centre), rate * turn}, duration);
}

Pose Path::at(Real time) const {
  if (!turns_ || time == 0) {
    return {start_.rotation, start_.position + shift_at(time)};
  }
  const Vec3 turn = time * (motion_.angular_velocity + (0.5 * time) * motion_.angular_acceleration);
  const Rotation rotation = rotation_by(turn) * start_.rotation;
  return {rotation, start_.position + (shift_at(time) + (arm_at_start_ - rotation * centre_))};
}

Path Path::seen_from(const Vec3& origin, const Vec3& velocity, const Vec3& acceleration) const {
  Path seen = *this;
  seen.start_.position = start_.position - origin;
  seen.centre_at_start_ = seen.start_.position + arm_at_start_;
  seen.motion_.velocity = motion_.velocity - velocity;
  seen.motion_.acceleration = motion_.acceleration - acceleration;
  seen.acceleration_ = length_of(seen.motion_.acceleration);
  return seen;
}

Real Path::radius_of(const Aabb& local) const {
  return local.is_bounded() ? outward * norm(maximum(absolute(local.low - centre_), absolute(local.high - centre_)))
                            : infinity;
}

Reach Path::reach_of(const Aabb& local) const {
  const Real radius = radius_of(local);
  if (!turns_ || !has_fixed_axis_ || !(radius < infinity)) {
    return {radius, radius};
  }
  const Vec3 axis = start_.rotation.undo(axis_);
  Real from_axis = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 at{(corner & 1) != 0 ? local.high.x : local.low.x, (corner & 2) != 0 ? local.high.y : local.low.y,
                  (corner & 4) != 0 ? local.high.z : local.low.z};
    from_axis = larger(from_axis, squared_norm(cross(axis, at - centre_)));
  }
  return {radius, smaller(radius, outward * (std::sqrt(from_axis) + rounding_of(radius)))};
}

// The turn vector moves by |angular_velocity + t angular_acceleration|, which is convex in t. The body turns no faster,
// since the derivative of the exponential map has a norm of at most 1.
Real Path::largest_turning(const TimeSpan& span) const {
  if (!(angular_acceleration_ > 0)) {
    return outward * angular_speed_;
  }
  const auto at = [&](Real time) { return norm(motion_.angular_velocity + time * motion_.angular_acceleration); };
  return outward * larger(at(span.begin), at(span.end));
}

// Of a point at distance 1 from the axis. Around a fixed axis it is the one of a circle. Else the axis turns as well.
// The derivative of the exponential map is the mean of the rotations on the way. That of each is at most its share of
// the square of the speed: half of it on average.
Real Path::largest_turning_acceleration(const TimeSpan& span) const {
  const Real speed = largest_turning(span);
  return outward * (angular_acceleration_ + (has_fixed_axis_ ? 1 : 1.5) * speed * speed);
}

Real Path::share_across(const Vec3& direction) const {
  return has_fixed_axis_ ? smaller(1, norm(cross(direction, axis_)) + rounding_of_sine) : 1;
}

Real Path::largest_speed(const TimeSpan& span, Real radius) const {
  const Real centre = larger(norm(velocity_at(span.begin)), norm(velocity_at(span.end)));
  return outward * (centre + times(largest_turning(span), radius));
}

Real Path::largest_speed_along(const Vec3& direction, const TimeSpan& span, const Reach& reach) const {
  const Real begin = dot(direction, velocity_at(span.begin)), end = dot(direction, velocity_at(span.end));
  const Real rounding = rounding_of(larger(norm(velocity_at(span.begin)), norm(velocity_at(span.end))));
  return larger(begin, end) + rounding +
         outward * times(largest_turning(span) * share_across(direction), reach.from_axis);
}

Real Path::largest_acceleration_along(const Vec3& direction, const TimeSpan& span, const Reach& reach) const {
  const Real of_centre = dot(direction, motion_.acceleration) + rounding_of(acceleration_);
  if (!turns_) {
    return of_centre;
  }
  const Real of_turn = largest_turning_acceleration(span) * share_across(direction);
  return of_centre + outward * times(of_turn, reach.from_axis);
}

Real Path::largest_deviation(const TimeSpan& span, Real radius) const {
  const Real of_turn = times(largest_turning_acceleration(span), radius);
  return outward * 0.125 * span.length() * span.length() * (acceleration_ + of_turn);
}

Aabb Path::swept_box(const Aabb& at_begin, const Aabb& at_end, const TimeSpan& span, Real radius) const {
  const Vec3 centre = centre_at(span.begin), speed = velocity_at(span.begin), way = centre_at(span.end) - centre;
  const Real length = span.length(), eighth = 0.125 * length * length;
  const Real of_turn = outward * eighth * times(largest_turning_acceleration(span), radius);
  const Real size = larger(larger(magnitude_of(at_begin.low), magnitude_of(at_begin.high)),
                           larger(magnitude_of(at_end.low), magnitude_of(at_end.high))) +
                    magnitude_of(centre) + magnitude_of(way) + length * magnitude_of(speed) +
                    eighth * magnitude_of(motion_.acceleration);
  const auto lower = [&](int axis, Real sign, Real begin, Real end) {
    const Real acceleration = sign * motion_.acceleration[axis];
    return lower_bound_of({sign * (begin - centre[axis]), sign * (end - centre[axis]), sign * way[axis],
                           least_of_parabola(sign * speed[axis], acceleration, length),
                           eighth * larger(acceleration, 0),
                           of_turn * share_across(axis == 0   ? Vec3{1, 0, 0}
                                                  : axis == 1 ? Vec3{0, 1, 0}
                                                              : Vec3{0, 0, 1}),
                           radius});
  };
  const Vec3 low{lower(0, 1, at_begin.low.x, at_end.low.x), lower(1, 1, at_begin.low.y, at_end.low.y),
                 lower(2, 1, at_begin.low.z, at_end.low.z)};
  const Vec3 high{lower(0, -1, at_begin.high.x, at_end.high.x), lower(1, -1, at_begin.high.y, at_end.high.y),
                  lower(2, -1, at_begin.high.z, at_end.high.z)};
  return Aabb{centre + low, centre - high}.inflated(noise_of(size));
}

}  // namespace abut
