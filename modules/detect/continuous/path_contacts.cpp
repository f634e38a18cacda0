// SPDX-License-Identifier: Apache-2.0
module abut.detect.continuous.path_contacts;
import abut.capability;
import abut.core.standard;
import abut.detect.pairs.jobs;
import abut.detect.pairs.manifolds;
import abut.detect.pairs;
import abut.detect.paths;
import abut.math;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.pairs.two_shapes.runs;
import abut.pairs.composites.seams;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.pairs.two_shapes.measured_routes;
import abut.scene.meetings.policies;

namespace abut {
namespace {

// Points as far apart as this, by the size of the pair, belong to a touch.
constexpr Real depth_of_touch = 1e-6;

// Where the bodies are when the contacts are found, and where they are at the start.
struct Moment {
  Pose a, b;
  Real time;
};

Moment moment_at(const Sides& sides, Real time) { return {sides.a.at(time), sides.b.at(time), time}; }

Real size_of(const Sides& sides) {
  const auto size = [](const Aabb& box) { return box.is_bounded() ? largest_magnitude(box.high - box.low) : 0; };
  return size(sides.box_a) + size(sides.box_b);
}

// Appends the contacts of a moment, in the frame of the first side. The algorithm of a policy may not have the pair.
void find_points(const PathScene& scene, const Sides& sides, const Moment& moment, const Policy& policy, Real margin,
                 Manifold& points) {
  const AnyShape &a = *scene.places.shapes[sides.job.a], &b = *scene.places.shapes[sides.job.b];
  const std::size_t before = points.size();
  const bool welds = scene.options.welds;
  QuerySettings wanted{
      .algorithm = policy.algorithm, .error_bound = policy.error_bound, .margin = margin, .welds = welds};
  if (policy.time_budget > 0) {
    take_route(Question::contacts, kind_in_pairs(a), kind_in_pairs(b), policy.time_budget, wanted);
  }
  if (contacts_in_frame(a, b, relative(moment.a, moment.b), wanted, points) != Outcome::ok) {
    points.resize(before);
    const QuerySettings any{.margin = margin, .welds = welds};
    static_cast<void>(contacts_in_frame(a, b, relative(moment.a, moment.b), any, points));
  }
}

// A contact of two bodies as wholes, in the frame of the first side.
void add_point(Distance found, const Moment& moment, Manifold& points) {
  points.push_back({.point_a = moment.a.undo(found.point_a),
                    .point_b = moment.a.undo(found.point_b),
                    .normal = moment.a.rotation.undo(found.normal),
                    .distance = found.distance,
                    .feature_a = {},
                    .feature_b = {},
                    .id = contact_id({}, {})});
}

// From the frame of the first side to the world, each point where its body has it at the start. Returns the points in
// the frames of their bodies.
LocalPoints carry_back(ContactPoint& contact, const Sides& sides, const Moment& moment, bool is_swapped) {
  move_by(contact, moment.a, is_swapped);
  const Pose &low = is_swapped ? moment.b : moment.a, &high = is_swapped ? moment.a : moment.b;
  const LocalPoints local{low.undo(contact.point_a), high.undo(contact.point_b)};
  if (moment.time > 0) {
    contact.point_a = (is_swapped ? sides.b : sides.a).start() * local.a;
    contact.point_b = (is_swapped ? sides.a : sides.b).start() * local.b;
    contact.distance = dot(contact.point_b - contact.point_a, contact.normal);
  }
  return local;
}

// How much of a distance along a normal, which leads from a to b, the motion may close.
Real closing_along(const Vec3& normal, const Sides& sides) {
  const auto speed = [&](const Path& path, const Aabb& box, const Vec3& direction) {
    return path.largest_speed_along(direction, path.whole(), path.reach_of(box));
  };
  return speed(sides.a, sides.box_a, normal) + speed(sides.b, sides.box_b, -normal);
}

// What the motion may close at most, whatever the direction.
Real closing(const Sides& sides) {
  const auto speed = [&](const Path& path, const Aabb& box) {
    return path.largest_speed(path.whole(), path.radius_of(box));
  };
  return speed(sides.a, sides.box_a) + speed(sides.b, sides.box_b);
}

// What of the contacts behind those of a result is reported; it goes on with them. What a pair may have at most it has
// in all.
template <class IsWanted>
void finish(const PathScene& scene, const Sides& sides, const Moment& moment, const Pair& pair, IsWanted&& is_wanted,
            ChunkScratch& scratch, JobResult& result) {
  const std::size_t first = result.first + result.count;
  const std::span<ContactPoint> found = std::span(scratch.points).subspan(first);
  const Detail detail = scene.policies.at(pair.policy).detail;
  if (detail == Detail::touch) {
    result.is_touching = result.is_touching || std::ranges::any_of(found, is_wanted);
    scratch.points.resize(first);
    return;
  }
  const auto surfaces = [&](const ContactPoint& contact) {
    return surfaces_of(*scene.places.shapes[sides.job.a], *scene.places.shapes[sides.job.b], contact);
  };
  std::size_t left = keep_best(found, scene.options, detail, surfaces, scratch, is_wanted,
                               [&] { return scene.histories.subspan(pair.first_before, pair.count_before); });
  const std::size_t most = detail == Detail::point ? 1 : scene.options.max_pair_contacts;
  left = most == 0 ? left : std::min<std::size_t>(left, most - std::min<std::size_t>(most, result.count));
  scratch.points.resize(first + left);
  const bool keeps_locals = scene.options.keeps_local_points;
  scratch.locals.resize(keeps_locals ? scratch.points.size() : 0);
  for (std::size_t i = first; i < scratch.points.size(); ++i) {
    const LocalPoints local = carry_back(scratch.points[i], sides, moment, sides.job.a > sides.job.b);
    if (keeps_locals) {
      scratch.locals[i] = local;
    }
  }
  result.count += static_cast<std::uint32_t>(left);
}

// Contacts of one touch are none of another, though the same features meet.
void tell_apart(std::span<ContactPoint> contacts, std::uint32_t touch) {
  for (ContactPoint& contact : contacts) {
    contact.id = touch == 0 ? contact.id : contact_id_of_part(contact.id, touch);
  }
}

}  // namespace

JobResult empty_result(std::size_t number, const ChunkScratch& scratch) {
  return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(scratch.points.size()), 0};
}

void take_over(std::size_t number, JobList& jobs, JobResult& result) {
  ChunkScratch& scratch = jobs.scratch(number);
  const JobResult before = result;
  result = empty_result(number, scratch);
  for (const ContactPoint& contact : jobs.found(before)) {
    scratch.points.push_back(contact);
  }
  const std::span<const LocalPoints> locals = jobs.locals(before);
  scratch.locals.insert(scratch.locals.end(), locals.begin(), locals.end());
  scratch.locals.resize(scratch.points.size());
  result.count = before.count;
  result.is_touching = before.is_touching;
}

void report_start(const PathScene& scene, const Sides& sides, const Pair& pair, Real touching, ChunkScratch& scratch,
                  JobResult& result) {
  const Moment moment = moment_at(sides, 0);
  const std::size_t first = scratch.points.size();
  find_points(scene, sides, moment, scene.policies.at(pair.policy), touching, scratch.points);
  if (scratch.points.size() > first) {
    finish(scene, sides, moment, pair, [](const ContactPoint&) { return true; }, scratch, result);
  }
}

void report_touch(const PathScene& scene, const Sides& sides, const Impact& impact, const Pair& pair,
                  std::uint32_t touch, Real touching, ChunkScratch& scratch, JobResult& result) {
  const AnyShape &a = *scene.places.shapes[sides.job.a], &b = *scene.places.shapes[sides.job.b];
  const std::size_t first = scratch.points.size();
  const bool is_undecided = impact.state == ImpactState::undecided;
  const bool is_ahead = impact.state == ImpactState::touches;
  const Moment moment = moment_at(sides, is_undecided ? impact.lower : is_ahead ? impact.upper : 0);
  if (!is_undecided) {
    const bool is_apart = is_ahead || impact.contact.distance > touching;
    const Real margin = touching + (is_apart ? depth_of_touch * size_of(sides) : 0);
    find_points(scene, sides, moment, scene.policies.at(pair.policy), margin, scratch.points);
  }
  if (scratch.points.size() == first) {
    Distance found = impact.contact;
    if (squared_norm(found.normal) > 0 || pair_distance(a, b, moment.a, moment.b, {}, found) == Outcome::ok) {
      add_point(found, moment, scratch.points);
    }
  }
  tell_apart(std::span(scratch.points).subspan(first), touch);
  finish(scene, sides, moment, pair, [](const ContactPoint&) { return true; }, scratch, result);
}

void report_speculative(const PathScene& scene, const Sides& sides, const Pair& pair, std::size_t number, Real touching,
                        JobList& jobs, JobResult& result) {
  const Real most = closing(sides);
  if (!std::isfinite(most)) {
    return;
  }
  ChunkScratch& scratch = jobs.scratch(number);
  result = empty_result(number, scratch);
  const Moment moment = moment_at(sides, 0);
  find_points(scene, sides, moment, scene.policies.at(pair.policy), touching + most, scratch.points);
  const auto is_within = [&](const ContactPoint& contact) {
    const Vec3 normal = moment.a.rotation * contact.normal;
    return contact.distance - touching <= std::max<Real>(closing_along(normal, sides), 0);
  };
  finish(scene, sides, moment, pair, is_within, scratch, result);
}

}  // namespace abut
