// SPDX-License-Identifier: Apache-2.0
module abut.motion.impacts.relative_motion;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.motion.paths.path;

namespace abut {
namespace {

constexpr Real outward = 1 + 1e-13;

// Without NaN for what is infinitely far and does not turn.
Real times(Real factor, Real reach) { return factor > 0 ? factor * reach : 0; }

// The largest relative speed of the centres.
Real speed_of_centres(const Path& a, const Path& b, const TimeSpan& span) {
  const auto at = [&](Real time) { return norm(b.velocity_at(time) - a.velocity_at(time)); };
  return outward * std::max(at(span.begin), at(span.end));
}

}  // namespace

// With x from the centre of a, and a turning with w: the velocity in its frame is x' - w x x, and the acceleration
// x'' - 2 w x x' - w' x x + w x (w x x).
RelativeBounds relative_bounds(const Path& a, const Path& b, Real radius, const TimeSpan& span) {
  const Real centres = speed_of_centres(a, b, span);
  const Real turning = a.largest_turning(span), speed = centres + times(b.largest_turning(span), radius);
  const Real away = norm(b.centre_at(span.begin) - a.centre_at(span.begin)) + span.length() * centres + radius;
  const Real bend = norm(b.motion().acceleration - a.motion().acceleration) +
                    times(b.largest_turning_acceleration(span), radius) + times(turning, 2 * speed) +
                    times(a.largest_turning_acceleration(span), away);
  return {outward * (speed + times(turning, away)), outward * bend};
}

Real largest_approach(const Path& a, Real radius_a, const Path& b, Real radius_b, const TimeSpan& span) {
  const Real in_world = outward * (speed_of_centres(a, b, span) + times(a.largest_turning(span), radius_a) +
                                   times(b.largest_turning(span), radius_b));
  return std::min({in_world, relative_bounds(a, b, radius_b, span).speed, relative_bounds(b, a, radius_a, span).speed});
}

RelativeBox relative_box(const Path& a, const Pose& frame, const Path& b, const Aabb& box_of_b, const TimeSpan& span) {
  if (!box_of_b.is_bounded()) {
    return {Aabb::everything(), 0, 0};
  }
  const auto at = [&](Real time) { return transformed(box_of_b, relative(a.at(time) * frame, b.at(time))); };
  const Aabb begin = at(span.begin), end = at(span.end);
  const Real bend = relative_bounds(a, b, b.radius_of(box_of_b), span).bend;
  const Real slack = 0.125 * bend * span.length() * span.length();
  Aabb box = begin;
  box.include(end);
  const Real size = std::max(largest_magnitude(box.low), largest_magnitude(box.high)) + norm(b.centre_at(span.begin)) +
                    norm(a.centre_at(span.begin));
  return {box.inflated(slack + noise_of(size)), largest_magnitude(end.centre() - begin.centre()), slack};
}

}  // namespace abut
