// SPDX-License-Identifier: Apache-2.0
module abut.motion.impacts.whole_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.motion.impacts.convex_impact;
import abut.pairs.taken_apart.convex_part;
import abut.motion.paths.path;
import abut.motion.impacts.relative_motion;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;

namespace abut {
namespace {

// Of the cores of convex shapes: turning moves no ball around a point of the core.
Reach reach_of(const AnyShape& shape, const Carrier& on) {
  const auto part = ConvexPart::of(shape);
  return on.path.reach_of(aabb_of(shape, on.local).inflated(part ? -part->radius() : 0));
}

// Writes the answer that a distance at a time gives by itself. Whether it gives one.
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

// Of a shape on its own; infinite where it has no bounds.
Real extent_of(const AnyShape& shape) {
  const Aabb box = aabb_of(shape, Pose::identity());
  return box.is_bounded() ? largest_magnitude(box.high - box.low) : infinity;
}

Vec3 velocity_of(const Path& path, const Vec3& point, Real time) {
  return path.velocity_at(time) + cross(path.turning_at(time), point - path.centre_at(time));
}

// Steps are as long as the lower bound of the distance proves, and no shorter than a stride. The lower bound may know
// less than the shape, as of what holes leave of a solid, so it tells no touch. Nothing is proven after a stride that
// is longer than the proof.
class [[gsl::Pointer]] DistanceSearch {
 public:
  DistanceSearch(const AnyShape& a [[clang::lifetimebound]], const Carrier& on_a [[clang::lifetimebound]],
                 const AnyShape& b [[clang::lifetimebound]], const Carrier& on_b [[clang::lifetimebound]],
                 const TimeSpan& span, const ImpactSettings& settings)
      : a_(a),
        b_(b),
        on_a_(on_a),
        on_b_(on_b),
        span_(span),
        settings_(settings),
        radius_a_(reach_of(a, on_a).radius),
        radius_b_(reach_of(b, on_b).radius),
        proven_(span.begin) {
    const Real extent = std::min(extent_of(a), extent_of(b)), speed = approach_from(span.begin);
    const Real by_size = extent < infinity && speed > 0 ? extent / (strides_of_shape * speed) : 0;
    stride_ = std::max(by_size, span.length() / most_strides);
  }

  [[nodiscard]] WholeImpact find() {
    Real time = span_.begin, before = time;
    Distance found{};
    while (ask(time, found)) {
      if (touches(found)) {
        look_back(before, time, found);
        return out_;
      }
      const Real speed = approach_from(time), gap = found.lower - settings_.margin - rounding_of(settings_.size);
      const Real certain = !(gap > 0) ? 0 : speed > 0 ? inward * gap / speed : infinity;
      proven_ = is_proven_ ? std::min(time + certain, span_.end) : proven_;
      if (!(speed > 0) || time + certain >= span_.end) {
        out_.impact = proven_ >= span_.end ? apart_until(span_.end, rounds_) : seen_free();
        return out_;
      }
      // Bounds that are near each other come as near to a touch as the tolerance.
      constexpr Real near_share = 0.5;
      const bool are_near = gap > 0 && found.upper - found.lower <= std::max(settings_.tolerance, near_share * gap);
      is_proven_ = is_proven_ && (are_near || certain >= stride_);
      before = time;
      time = std::min(time + (are_near ? certain : std::max(certain, stride_)), span_.end);
      if (!(time > before)) {
        break;
      }
    }
    out_.impact = undecided_from(proven_, span_.end, rounds_);
    return out_;
  }

 private:
  static constexpr Real strides_of_shape = 64, most_strides = 512, inward = 1 - 1e-14;

  [[nodiscard]] Real approach_from(Real time) const {
    return largest_approach(on_a_.path, radius_a_, on_b_.path, radius_b_, {time, span_.end});
  }
  // Whether there is an answer, and a round was left for it.
  [[nodiscard]] bool ask(Real time, Distance& found) {
    if (rounds_ >= settings_.most_rounds) {
      return false;
    }
    ++rounds_;
    out_.outcome = pair_distance(a_, b_, on_a_.at(time), on_b_.at(time), {}, found);
    return out_.outcome == Outcome::ok;
  }
  // An upper bound of infinity says that nothing is there that could be touched.
  [[nodiscard]] bool touches(const Distance& found) const {
    return found.upper < infinity && found.upper <= settings_.margin + settings_.tolerance;
  }
  [[nodiscard]] Impact seen_free() const {
    Impact impact = undecided_from(proven_, span_.end, rounds_);
    impact.is_seen_free = true;
    return impact;
  }
  // From a touch that a stride has led to, toward a time at which there was none.
  void look_back(Real before, Real time, Distance found) {
    Distance between{};
    while (!is_proven_ && (time - before) * approach_from(before) > settings_.tolerance) {
      const Real middle = 0.5 * (before + time);
      if (!(middle > before && middle < time) || !ask(middle, between)) {
        break;
      }
      if (touches(between)) {
        time = middle;
        found = between;
      } else {
        before = middle;
      }
    }
    out_.impact.state = time > span_.begin ? ImpactState::touches : ImpactState::starts_together;
    out_.impact.lower = is_proven_ ? time : std::min(proven_, time);
    out_.impact.upper = time;
    out_.impact.rounds = rounds_;
    out_.impact.contact = found;
  }

  const AnyShape &a_, &b_;
  const Carrier &on_a_, &on_b_;
  TimeSpan span_;
  ImpactSettings settings_;
  Real radius_a_, radius_b_;
  Real proven_;  // they are apart before it
  Real stride_ = 0;
  bool is_proven_ = true;  // up to the time at which the search is
  std::uint32_t rounds_ = 0;
  WholeImpact out_;
};

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
  return DistanceSearch(a, on_a, b, on_b, span, settings).find();
}

}  // namespace abut
