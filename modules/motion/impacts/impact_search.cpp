// SPDX-License-Identifier: Apache-2.0
module abut.motion.impacts.impact_search;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.impacts.convex_impact;
import abut.pairs.taken_apart.convex_part;
import abut.motion.paths.path;
import abut.motion.time_of_impact;

namespace abut {
namespace {

// How far two parts that touch may reach beyond the plane between them.
Real slack_of_planes(const MovingPair& pair) {
  constexpr Real error_of_curves = 1.4e-10;
  const ConvexPart &a = pair.a.part, &b = pair.b.part;
  const bool are_curved = a.is_curved() || b.is_curved();
  return 2 * pair.settings.tolerance + (are_curved ? 8 * error_of_curves * (a.extent() + b.extent()) : 0);
}

// When the search goes on after a touch with a one-sided triangle that does not stop the parts; nothing where it does.
// `front_at`: the direction in which the triangle faces the other part at a time, from a to b.
//  - A part that is in front at the begin of the span, within rounding, is stopped where it approaches. Else no touch
//    counts before the gap opens, such as one with an edge that the part slides over.
//  - A part that reaches behind the triangle, and only touches it, is stopped by a touch from the front.
//  - A part that overlaps the triangle was met from behind before, or at the start the contacts have told already.
template <class FrontAt>
std::optional<Real> end_of_passage(const MovingPair& pair, const FrontAt& front_at, const Impact& touch,
                                   const TimeSpan& span) {
  const Vec3 front = front_at(span.begin), &normal = touch.contact.normal;
  const bool is_at_begin = touch.upper <= span.begin, is_undecided = touch.state == ImpactState::undecided;
  if (!(squared_norm(front) > 0)) {
    return is_undecided ? std::nullopt : std::optional(span.end);
  }
  const Real slack = slack_of_planes(pair), gap = gap_along_at(pair, front, span.begin);
  if (std::fabs(gap) <= slack || (is_undecided && gap > 0)) {
    const auto parted = parting_time(pair, front, span);
    if (parted && *parted >= (is_undecided ? span.end : touch.upper)) {
      return parted;
    }
    if (is_at_begin) {
      return std::nullopt;
    }
  }
  if (is_undecided) {
    return std::nullopt;
  }
  if (is_at_begin) {
    if (!(squared_norm(normal) > 0 && gap_along_at(pair, normal, span.begin) >= -slack)) {
      return span.end;
    }
    if (const auto parted = parting_time(pair, normal, span)) {
      return parted;
    }
  }
  return dot(front_at(touch.upper), normal) > 0 ? std::nullopt : std::optional(span.end);
}

std::optional<Real> end_of_passage(const MovingPair& pair, const Impact& touch, const TimeSpan& span) {
  std::optional<Real> end;
  if (const auto front = pair.a.part.only_front()) {
    end = end_of_passage(pair, [&](Real time) { return pair.a.at(time).rotation * *front; }, touch, span);
  }
  if (const auto front = pair.b.part.only_front(); front && !end) {
    end = end_of_passage(pair, [&](Real time) { return -(pair.b.at(time).rotation * *front); }, touch, span);
  }
  return end;
}

// The first touch that stops the parts.
Impact stopping_impact(const MovingPair& pair, const TimeSpan& span) {
  constexpr int most_passages = 16;
  TimeSpan rest = span;
  Impact impact = convex_impact(pair, rest);
  for (int passage = 0; passage < most_passages && impact.state != ImpactState::apart; ++passage) {
    const std::optional<Real> next = end_of_passage(pair, impact, rest);
    if (!next) {
      break;
    }
    const std::uint32_t rounds = impact.rounds;
    rest.begin = *next;
    impact = rest.begin < rest.end ? convex_impact(pair, rest)
                                   : Impact{.state = ImpactState::apart, .lower = rest.end, .upper = rest.end};
    impact.rounds += rounds;
  }
  return impact;
}

}  // namespace

void meet_parts(const MovingPair& pair, const TimeSpan& span, std::uint32_t child_a, std::uint32_t child_b,
                Search& search) {
  Impact impact = stopping_impact(pair, {span.begin, std::min(span.end, search.best.end())});
  if (impact.state == ImpactState::starts_together && impact.upper > search.begin) {
    impact.state = ImpactState::touches;
  }
  search.add(Outcome::ok, impact, child_a, child_b);
}

}  // namespace abut
