// SPDX-License-Identifier: Apache-2.0
module abut.motion.whole_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.motion.convex_impact;
import abut.motion.convex_part;
import abut.motion.path;
import abut.motion.relative_motion;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace abut {
namespace {

// Of the cores of convex shapes: turning moves no ball around a point of the core.
Reach reach_of(const AnyShape& shape, const Carrier& on) {
  const auto part = ConvexPart::of(shape);
  return on.path.reach_of(aabb_of(shape, on.local).inflated(part ? -part->radius() : 0));
}

// Writes the answer that a distance at a time gives by itself. Whether it gives one. The interval of a distance may be
// wider than the tolerance, as with a distance field. What may be a touch then is one.
bool ends(const Distance& found, Real time, const TimeSpan& span, const ImpactSettings& settings, Impact& out) {
  out.lower = out.upper = time;
  out.contact = found;
  const bool touches =
      found.lower <= settings.margin + 0.5 * settings.tolerance || found.upper <= settings.margin + settings.tolerance;
  if (touches) {
    out.state = time > span.begin ? ImpactState::touches : ImpactState::starts_together;
  }
  return touches;
}

Impact apart_until(Real end, std::uint32_t rounds) { return {ImpactState::apart, end, end, rounds, {}, 0, 0}; }
Impact undecided_from(Real time, Real end, std::uint32_t rounds) {
  return {ImpactState::undecided, time, end, rounds, {}, 0, 0};
}

Vec3 velocity_of(const Path& path, const Vec3& point, Real time) {
  return path.velocity_at(time) + cross(path.turning_at(time), point - path.centre_at(time));
}

}  // namespace

WholeImpact half_space_impact(const AnyShape& half_space, const Carrier& on_a, const AnyShape& b, const Carrier& on_b,
                              const TimeSpan& span, const ImpactSettings& settings) {
  const Reach reach = reach_of(b, on_b);
  WholeImpact out;
  Distance found{}, ahead{};
  const auto distance_at = [&](Real time, Distance& distance) {
    out.outcome = pair_distance(half_space, b, on_a.at(time), on_b.at(time), {}, distance);
    return out.outcome == Outcome::ok;
  };
  const auto gap_of = [&](const Distance& distance) {
    return distance.lower - settings.margin - rounding_of(settings.size);
  };
  if (!distance_at(span.begin, found)) {
    return out;
  }
  Real time = span.begin;
  for (std::uint32_t round = 0; round < settings.most_rounds; ++round) {
    out.impact.rounds = round + 1;
    if (ends(found, time, span, settings, out.impact)) {
      return out;
    }
    const Real gap = gap_of(found);
    if (!(gap > 0)) {
      break;
    }
    const TimeSpan rest{time, span.end};
    const Real bend = on_a.path.turns() ? relative_bounds(on_a.path, on_b.path, reach.radius, rest).bend
                                        : on_b.path.largest_acceleration_along(found.normal, rest, reach) -
                                              dot(found.normal, on_a.path.motion().acceleration) +
                                              rounding_of(norm(on_a.path.motion().acceleration));
    const Real approach =
        dot(found.normal, velocity_of(on_a.path, found.point_a, time) - velocity_of(on_b.path, found.point_b, time));
    const Real to_touch = approach > 0 ? std::max(gap - 0.5 * settings.tolerance, 0.5 * gap) / approach : infinity;
    const Real longest = bend > 0 ? std::sqrt(4 * gap / bend) : infinity;
    const Real next = std::min(time + std::min(to_touch, longest), span.end);
    if (!distance_at(next, ahead)) {
      return out;
    }
    const Real share = free_share(gap, gap_of(ahead), bend, next - time);
    if (share >= 1 && !(next < span.end)) {
      out.impact = apart_until(span.end, out.impact.rounds);
      return out;
    }
    const Real reached = share < 1 ? time + share * (next - time) : next;
    if (!(reached > time)) {
      break;
    }
    time = reached;
    if (share < 1) {
      if (!distance_at(time, found)) {
        return out;
      }
    } else {
      found = ahead;
    }
  }
  out.impact = undecided_from(time, span.end, out.impact.rounds);
  return out;
}

WholeImpact distance_impact(const AnyShape& a, const Carrier& on_a, const AnyShape& b, const Carrier& on_b,
                            const TimeSpan& span, const ImpactSettings& settings) {
  const Real radius_a = reach_of(a, on_a).radius, radius_b = reach_of(b, on_b).radius;
  WholeImpact out;
  Real time = span.begin;
  std::uint32_t round = 0;
  while (round++ < settings.most_rounds) {
    Distance found{};
    out.outcome = pair_distance(a, b, on_a.at(time), on_b.at(time), {}, found);
    if (out.outcome != Outcome::ok) {
      return out;
    }
    out.impact.rounds = round;
    // An upper bound of infinity says that nothing is there that could be touched.
    if (found.upper < infinity && ends(found, time, span, settings, out.impact)) {
      return out;
    }
    const Real speed = largest_approach(on_a.path, radius_a, on_b.path, radius_b, {time, span.end});
    const Real gap = found.lower - settings.margin - rounding_of(settings.size);
    if (speed * (span.end - time) < gap || speed == 0) {
      out.impact = apart_until(span.end, round);
      return out;
    }
    constexpr Real inward = 1 - 1e-14;
    const Real next = time + inward * gap / speed;
    if (!(next > time)) {
      break;
    }
    time = next;
  }
  out.impact = undecided_from(time, span.end, round);
  return out;
}

}  // namespace abut
