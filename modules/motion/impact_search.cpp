// SPDX-License-Identifier: Apache-2.0
module abut.motion.impact_search;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.convex_impact;
import abut.motion.convex_part;
import abut.motion.path;
import abut.motion.time_of_impact;

namespace abut {
namespace {

// A triangle with one side that is met from behind is not met at all. Nor is one that overlaps at the begin of a span:
// before that it was met from behind, and at the start the contacts have told so already.
bool lets_through(const ConvexPart& part, const Pose& pose, const Vec3& outward, bool is_start) {
  const auto front = part.only_front();
  return front && (is_start || dot(pose.rotation * *front, outward) <= 0);
}

}  // namespace

void meet_parts(const MovingPair& pair, const TimeSpan& span, std::uint32_t child_a, std::uint32_t child_b,
                Search& search) {
  const MovingPart &a = pair.a, &b = pair.b;
  Impact impact = convex_impact(pair, {span.begin, std::min(span.end, search.best.end())});
  if (impact.state == ImpactState::touches || impact.state == ImpactState::starts_together) {
    const bool overlaps = impact.contact.lower <= search.settings.margin && impact.state != ImpactState::touches;
    const bool is_start = overlaps || impact.upper == search.begin;
    if (lets_through(a.part, a.at(impact.upper), impact.contact.normal, is_start) ||
        lets_through(b.part, b.at(impact.upper), -impact.contact.normal, is_start)) {
      impact.state = ImpactState::apart;
    } else if (impact.upper > search.begin) {
      impact.state = ImpactState::touches;
    }
  }
  search.add(Outcome::ok, impact, child_a, child_b);
}

}  // namespace abut
