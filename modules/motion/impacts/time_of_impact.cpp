// SPDX-License-Identifier: Apache-2.0
// Shapes are taken apart: composites into children, surfaces into triangles, many balls into balls. Each two convex
// parts whose boxes may meet are asked by themselves, up to the first touch found so far.
module abut.motion.time_of_impact;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.motion.impacts.best_impact;
import abut.motion.impacts.convex_impact;
import abut.motion.impacts.impact_search;
import abut.motion.impacts.moving_surfaces;
import abut.motion.paths.path;
import abut.motion.impacts.relative_motion;
import abut.motion.impacts.whole_impact;
import abut.pairs.any_shape;
import abut.pairs.any_shape.casts.starting_touch;
import abut.pairs.taken_apart.shape_parts;

namespace abut {
namespace {

bool is_asked_as_a_whole(const AnyShape& shape) { return has_holes(shape) || traits_of(shape).has_only_distances; }

// a is made of parts; b may be. Time is halved until the box around the way of b is not much larger than b.
void meet_in_span(const Subject& a, const Subject& b, const TimeSpan& given, int depth, Search& search) {
  constexpr int most_halvings = 12;
  const TimeSpan span{given.begin, std::min(given.end, search.best.end())};
  if (!(span.begin < span.end)) {
    return;
  }
  const Real slack = search.slack();
  const RelativeBox way = relative_box(a.on.path, a.on.local, b.on.path, b.box, span);
  const Aabb near_a = way.box.inflated(slack);
  if (!aabb_of(a.shape, Pose::identity()).overlaps(near_a)) {
    return;
  }
  const Real extent = largest_magnitude(b.box.high - b.box.low);
  if (depth < most_halvings && (way.slack > 0.125 * extent || way.drift > extent)) {
    const Real middle = 0.5 * (span.begin + span.end);
    meet_in_span(a, b, {span.begin, middle}, depth + 1, search);
    meet_in_span(a, b, {middle, given.end}, depth + 1, search);
    return;
  }
  const auto whole_b = traits_of(b.shape).has_parts ? std::nullopt : ConvexPart::of(b.shape);
  const ConvexPart none = ConvexPart::of(Ball(0));
  MovingPair pair{moving_part(none, a.on.path, a.on.local), moving_part(whole_b.value_or(none), b.on.path, b.on.local),
                  search.settings};
  const auto meet_part = [&](const ConvexPart& part, const Pose& place, std::uint32_t child) {
    const Pose local = a.on.local * place;
    pair.a = moving_part(part, a.on.path, local);
    const std::uint32_t child_a = a.child + child;
    if (whole_b) {
      meet_parts(pair, span, child_a, b.child, search);
      return;
    }
    const Aabb near_b = relative_box(b.on.path, b.on.local, a.on.path, part.aabb(local), span).box.inflated(slack);
    const auto meet_both = [&](const ConvexPart& part_b, const Pose& place_b, std::uint32_t child_b) {
      pair.b = moving_part(part_b, b.on.path, b.on.local * place_b);
      meet_parts(pair, span, child_a, b.child + child_b, search);
    };
    visit_parts(b.shape, near_b, std::ref(meet_both));
  };
  visit_parts(a.shape, near_a, std::ref(meet_part));
}

void meet(const Subject& a, const Subject& b, Search& search);

// The same with the sides exchanged.
void meet_turned_over(const Subject& a, const Subject& b, Search& search) {
  search.is_turned_over = !search.is_turned_over;
  meet(b, a, search);
  search.is_turned_over = !search.is_turned_over;
}

// Of solids that no hole cuts.
void meet_children(const Subject& a, const Subject& b, Search& search) {
  const TimeSpan span = search.span();
  const Aabb way = relative_box(a.on.path, a.on.local, b.on.path, b.box, span).box.inflated(search.slack());
  const auto meet_child = [&](const AnyShape& shape, const Pose& pose, std::uint32_t child) {
    const Pose local = a.on.local * pose;
    meet({shape, {a.on.path, local}, child, aabb_of(shape, local)}, b, search);
  };
  visit_children(a.shape, way, std::ref(meet_child));
}

// Which of two shapes is taken apart first, or asked as what it is: the higher one.
int rank_of(const AnyShape& shape) {
  const ShapeTraits& traits = traits_of(shape);
  return traits.is_assembly ? 3 : traits.is_half_space ? 2 : traits.has_parts ? 1 : 0;
}

void meet(const Subject& a, const Subject& b, Search& search) {
  const TimeSpan span = search.span();
  const auto add = [&](const WholeImpact& found) { search.add(found.outcome, found.impact, a.child, b.child); };
  if (!is_supported(kind_in_pairs(a.shape), kind_in_pairs(b.shape))) {
    add({Outcome::unsupported, {}});
  } else if (is_asked_as_a_whole(a.shape) || is_asked_as_a_whole(b.shape)) {
    add(distance_impact(a.shape, a.on, b.shape, b.on, span, search.settings));
  } else if (rank_of(a.shape) < rank_of(b.shape)) {
    meet_turned_over(a, b, search);
  } else if (traits_of(a.shape).is_assembly) {
    search.has_answer = true;
    meet_children(a, b, search);
  } else if (traits_of(a.shape).is_half_space) {
    add(half_space_impact(a.shape, a.on, b.shape, b.on, span, search.settings));
  } else if (traits_of(a.shape).is_surface && traits_of(b.shape).is_surface) {
    search.has_answer = true;
    meet_surfaces(a, b, span, search);
  } else if (traits_of(a.shape).has_parts) {
    search.has_answer = true;
    meet_in_span(a, b, span, 0, search);
  } else {
    const auto part_a = ConvexPart::of(a.shape), part_b = ConvexPart::of(b.shape);
    meet_parts({moving_part(*part_a, a.on.path, a.on.local, a.box), moving_part(*part_b, b.on.path, b.on.local, b.box),
                search.settings},
               span, a.child, b.child, search);
  }
}

// Shapes whose contacts at the start say more than a distance: which of their parts overlap, and on which side.
bool is_made_of_parts(const AnyShape& shape) { return traits_of(shape).has_parts || traits_of(shape).is_assembly; }

// How fast b parts from a at a contact, relative to how fast both move there.
Real parting_speed(const Subject& a, const Subject& b, const ContactPoint& contact, Real time) {
  const auto velocity_of = [&](const Path& path, const Vec3& point) {
    return path.velocity_at(time) + cross(path.turning_at(time), point - path.centre_at(time));
  };
  const Vec3 of_a = velocity_of(a.on.path, contact.point_a), of_b = velocity_of(b.on.path, contact.point_b);
  const Real speed = norm(of_a) + norm(of_b);
  return speed > 0 ? dot(contact.normal, of_b - of_a) / speed : 0;
}

bool is_still(const Subject& its) { return its.on.path.motion() == Motion{}; }

Outcome meet_at_start(const Subject& a, const Subject& b, const Search& search, StartingTouch& out) {
  const ImpactSettings& its = search.settings;
  const StartSettings settings{{.margin = its.margin}, its.tolerance, its.tolerance, is_still(a) && is_still(b)};
  return find_starting_touch(
      a.shape, b.shape, a.on.at(search.begin), b.on.at(search.begin), settings,
      [&](const ContactPoint& contact) { return parting_speed(a, b, contact, search.begin); }, out);
}

Impact impact_at_start(const ContactPoint& its, Real begin, std::uint32_t rounds) {
  const Distance contact{its.distance, its.distance, its.distance,         its.point_a,
                         its.point_b,  its.normal,   Algorithm::automatic, 0};
  return {ImpactState::starts_together, begin, begin, rounds, contact, its.child_a, its.child_b};
}

// Without the motion of a, and around where it starts: so that no digits are lost to what both have in common.
struct OwnFrame {
  Path a, b;
  Vec3 origin;
};
OwnFrame own_frame(const Path& a, const Path& b) {
  const Vec3 origin = a.start().position;
  const Motion& motion = a.motion();
  return {a.seen_from(origin, motion.velocity, motion.acceleration),
          b.seen_from(origin, motion.velocity, motion.acceleration), origin};
}

Real finite_or_zero(Real reach) { return reach < infinity ? reach : 0; }

ImpactSettings settings_of(const Subject& a, const Subject& b, const ImpactOptions& options) {
  const auto radius_of = [](const Subject& its) { return finite_or_zero(its.on.path.radius_of(its.box)); };
  const Path &path_a = a.on.path, &path_b = b.on.path;
  const Real sizes = radius_of(a) + radius_of(b), duration = path_b.duration();
  const Real way = duration * path_b.largest_speed(path_b.whole(), 0);
  const Real arms =
      norm(path_a.centre_at(0) - path_a.start().position) + norm(path_b.centre_at(0) - path_b.start().position);
  const Real size = sizes + arms + norm(path_b.centre_at(0) - path_a.centre_at(0)) + way;
  constexpr Real usual = 1e-12, least = 8;
  const Real wanted = options.tolerance > 0 ? options.tolerance : usual * sizes;
  return {size, std::max(wanted, least * rounding_of(size)), options.margin, options.most_rounds};
}

// The order of the two is that of the work.
Outcome impact_in_order(const MovingShape& moving_a, const MovingShape& moving_b, const ImpactOptions& options,
                        Impact& out) {
  const OwnFrame frame = own_frame(moving_a.path, moving_b.path);
  const Subject a{moving_a.shape, {frame.a, Pose::identity()}, 0, moving_a.box},
      b{moving_b.shape, {frame.b, Pose::identity()}, 0, moving_b.box};
  Search search{settings_of(a, b, options), options.begin, BestImpact(frame.a.duration())};
  const bool is_whole = is_asked_as_a_whole(a.shape) || is_asked_as_a_whole(b.shape);
  StartingTouch start;
  if (!is_whole && (is_made_of_parts(a.shape) || is_made_of_parts(b.shape))) {
    const Aabb near_a = aabb_of(a.shape, a.on.at(options.begin)).inflated(search.slack());
    if (near_a.overlaps(aabb_of(b.shape, b.on.at(options.begin)))) {
      search.outcome = meet_at_start(a, b, search, start);
    }
  }
  if (search.outcome == Outcome::ok && !start.stops) {
    meet(a, b, search);
  }
  if (start.contact && (start.stops || search.best.is_at_start())) {
    const Impact impact = impact_at_start(*start.contact, options.begin, search.best.result().rounds);
    search.best = BestImpact(frame.a.duration());
    search.add(Outcome::ok, impact, impact.child_a, impact.child_b);
  }
  if (search.outcome != Outcome::ok && !search.has_answer) {
    return search.outcome;
  }
  out = search.best.result();
  // A search for a touch knows no depth.
  const bool is_met = out.state == ImpactState::touches || out.state == ImpactState::starts_together;
  if (options.wants_depth && is_met && squared_norm(out.contact.normal) == 0) {
    const Outcome outcome = pair_distance(a.shape, b.shape, a.on.at(out.upper), b.on.at(out.upper), {}, out.contact);
    if (outcome != Outcome::ok) {
      return outcome;
    }
  }
  move_by(out.contact, frame.origin + moving_a.path.shift_at(out.upper));
  return Outcome::ok;
}

}  // namespace

Outcome time_of_impact(const MovingShape& a, const MovingShape& b, const ImpactOptions& options, Impact& out) {
  if (starts_from_b(a.shape, b.shape, a.path.start(), b.path.start())) {
    const Outcome outcome = impact_in_order(b, a, options, out);
    if (outcome == Outcome::ok) {
      turn_over(out);
    }
    return outcome;
  }
  return impact_in_order(a, b, options, out);
}

}  // namespace abut
