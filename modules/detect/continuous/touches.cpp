// SPDX-License-Identifier: Apache-2.0
module abut.detect.continuous.touches;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.taken_apart.convex_part;
import abut.motion.paths.path;
import abut.motion.impacts.relative_motion;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;

namespace abut {
namespace {

// A shape on its path.
struct [[gsl::Pointer]] Mover {
  const Path& path;
  Real size;    // the largest side of its box; infinite for a plane
  Real radius;  // around the centre; turning moves no ball around a point of its core
  bool is_convex;
};

Mover mover_of(const MovingShape& its) {
  const auto part = ConvexPart::of(its.shape);
  const Real radius = its.path.radius_of(its.box.inflated(part ? -part->radius() : 0));
  const Real size = its.box.is_bounded() ? largest_magnitude(its.box.high - its.box.low) : infinity;
  return {its.path, size, radius, part.has_value()};
}

// How far turning moves a point of a body at most.
Real turned_way(const Mover& its, const TimeSpan& span) {
  return its.path.turns() ? span.length() * its.path.largest_turning(span) * its.radius : 0;
}

// Two convex bodies that only move on straight lines overlap during one stretch of time. With what bends the ways of
// their points, they part by no more than twice that bend.
bool may_part_and_meet(const Mover& a, const Mover& b, Real parted, const TimeSpan& span) {
  const Real bend =
      a.path.largest_deviation(span, 0) + b.path.largest_deviation(span, 0) + turned_way(a, span) + turned_way(b, span);
  return !(a.is_convex && b.is_convex && 2 * bend < parted);
}

// How far apart two are with certainty, so that nothing but the approach brings them nearer. An overlap of convex
// bodies counts as well: it takes as long to leave.
Real certain_gap(const Distance& found, bool are_convex) {
  return are_convex ? found.distance : std::max<Real>(found.distance, 0);
}

// The first of some times, one soon after the other, at which they are apart by so much. Most part at once, and may
// meet again soon: what leaves one wall in a corner is at the next one. So the first times follow each other sooner.
std::optional<Real> time_of_parting(const PathPair& pair, Real wanted, Real approach, bool are_convex, Real begin) {
  constexpr Real first_share = 1. / 64;
  Real time = begin, shortest = first_share * shortest_parting;
  for (;;) {
    Distance found{};
    if (pair_distance(pair.a.shape, pair.b.shape, pair.a.path.at(time), pair.b.path.at(time), {}, found) !=
        Outcome::ok) {
      return std::nullopt;
    }
    if (found.lower > wanted) {
      return time;
    }
    const Real wait = (wanted - certain_gap(found, are_convex)) / approach;
    time += std::max(wait, shortest);
    shortest = std::min(2 * shortest, shortest_parting);
    if (!(time < 1)) {
      return std::nullopt;
    }
  }
}

}  // namespace

Outcome find_touch(const PathPair& pair, Real begin, Impact& out) {
  const Outcome outcome =
      time_of_impact(pair.a, pair.b, {.margin = pair.margin, .begin = begin, .wants_depth = false}, out);
  if (out.is_seen_free) {
    out.state = ImpactState::apart;
  }
  // They were apart before.
  if (out.state == ImpactState::starts_together && begin > 0) {
    out.state = ImpactState::touches;
  }
  return outcome;
}

std::optional<Impact> find_touch_after(const PathPair& pair, Real time) {
  const Mover a = mover_of(pair.a), b = mover_of(pair.b);
  const Real parted = share_of_parting * std::min(a.size, b.size);
  const TimeSpan rest{time, 1};
  if (!(parted > 0 && parted < infinity) || !may_part_and_meet(a, b, parted, rest)) {
    return std::nullopt;
  }
  const Real approach = largest_approach(a.path, a.radius, b.path, b.radius, rest);
  if (rest.length() * approach < 2 * parted) {
    return std::nullopt;
  }
  const auto begin = time_of_parting(pair, pair.margin + parted, approach, a.is_convex && b.is_convex, time);
  Impact impact;
  if (!begin || find_touch(pair, *begin, impact) != Outcome::ok || impact.state == ImpactState::apart) {
    return std::nullopt;
  }
  return impact;
}

}  // namespace abut
