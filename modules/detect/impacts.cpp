// SPDX-License-Identifier: Apache-2.0
module abut.detect.impacts;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.best_points;
import abut.detect.contacts;
import abut.detect.jobs;
import abut.detect.pairs;
import abut.detect.paths;
import abut.math;
import abut.motion.time_of_impact;
import abut.narrow.manifold;
import abut.pairs.any_shape;
import abut.pairs.registry;
import abut.pairs.table;
import abut.scene.options;
import abut.scene.places;
import abut.scene.policies;

namespace abut {
namespace {

// Pairs next to each other that one task takes.
constexpr std::size_t pairs_of_block = 4;
// Points as far apart as this, by the size of the pair, belong to a first touch.
constexpr Real depth_of_touch = 1e-6;

// The two sides of a job, on their paths.
struct Sides {
  const PairJob& job;
  Path a, b;
};

// Where the bodies are when the contacts are found, and where they are at the start.
struct Moment {
  Pose a, b;
  Real time;
};

Moment moment_at(const Sides& sides, Real time) { return {sides.a.at(time), sides.b.at(time), time}; }

Real size_of(const AnyShape& a, const AnyShape& b) {
  const auto size = [](const Aabb& box) { return box.is_bounded() ? largest_magnitude(box.high - box.low) : 0; };
  return size(aabb_of(a, Pose::identity())) + size(aabb_of(b, Pose::identity()));
}

// Appends the contacts of a moment, in the frame of the first side. The algorithm of a policy may not have the pair.
void find_points(const Places& places, const Sides& sides, const Moment& moment, const Policy& policy, Real margin,
                 Manifold& points) {
  const AnyShape &a = *places.shapes[sides.job.a], &b = *places.shapes[sides.job.b];
  const auto& kernels = pair_kernels(a.index(), b.index());
  const std::size_t before = points.size();
  const QuerySettings wanted{.algorithm = policy.algorithm, .error_bound = policy.error_bound, .margin = margin};
  if (kernels.contacts_in_frame(a, b, relative(moment.a, moment.b), wanted, nullptr, points) != Outcome::ok) {
    points.resize(before);
    const QuerySettings any{.margin = margin};
    static_cast<void>(kernels.contacts_in_frame(a, b, relative(moment.a, moment.b), any, nullptr, points));
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

// From the frame of the first side to the world, each point where its body has it at the start.
void carry_back(ContactPoint& contact, LocalPoints& local, const Sides& sides, const Moment& moment, bool is_swapped) {
  move_by(contact, moment.a, is_swapped);
  const Pose &low = is_swapped ? moment.b : moment.a, &high = is_swapped ? moment.a : moment.b;
  local = {low.undo(contact.point_a), high.undo(contact.point_b)};
  if (moment.time > 0) {
    contact.point_a = (is_swapped ? sides.b : sides.a).start() * local.a;
    contact.point_b = (is_swapped ? sides.a : sides.b).start() * local.b;
    contact.distance = dot(contact.point_b - contact.point_a, contact.normal);
  }
}

// How much of a distance along a normal, which leads from a to b, the motion may close.
Real closing_along(const Vec3& normal, const Sides& sides, const Places& places) {
  const auto speed = [&](const Path& path, std::uint32_t place, const Vec3& direction) {
    const Reach reach = path.reach_of(aabb_of(*places.shapes[place], Pose::identity()));
    return path.largest_speed_along(direction, path.whole(), reach);
  };
  return speed(sides.a, sides.job.a, normal) + speed(sides.b, sides.job.b, -normal);
}

// What the motion may close at most, whatever the direction.
Real closing(const Sides& sides, const Places& places) {
  const auto speed = [&](const Path& path, std::uint32_t place) {
    const Real radius = path.reach_of(aabb_of(*places.shapes[place], Pose::identity())).radius;
    return path.largest_speed(path.whole(), radius);
  };
  return speed(sides.a, sides.job.a) + speed(sides.b, sides.job.b);
}

// The pair of two places in a list in order; its number, or that of the end.
std::size_t find_pair(std::span<const Pair> pairs, const ProxyPair& wanted) {
  const auto found = std::lower_bound(pairs.begin(), pairs.end(), wanted, [](const Pair& pair, const ProxyPair& its) {
    return std::pair(pair.low, pair.high) < std::pair(its.low, its.high);
  });
  const bool is_found = found != pairs.end() && found->low == wanted.low && found->high == wanted.high;
  return is_found ? static_cast<std::size_t>(found - pairs.begin()) : pairs.size();
}

// What of the contacts of a job is reported.
template <class IsWanted>
void finish(const ImpactStage::Scene& scene, const Sides& sides, const Moment& moment, const Pair& pair,
            std::size_t number, std::size_t first, IsWanted&& is_wanted, ChunkScratch& scratch, JobResult& result) {
  const std::span<ContactPoint> found = std::span(scratch.points).subspan(first);
  const Policy& policy = scene.policies.at(pair.policy);
  const std::size_t left = keep_best(found, scene.options, policy.detail, scratch, is_wanted,
                                     [&] { return scene.histories.subspan(pair.first_before, pair.count_before); });
  scratch.points.resize(first + left);
  scratch.locals.resize(scratch.points.size());
  for (std::size_t i = first; i < scratch.points.size(); ++i) {
    carry_back(scratch.points[i], scratch.locals[i], sides, moment, sides.job.a > sides.job.b);
  }
  result = {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(left)};
}

// The contacts at the first touch, or at the start where they touch there. What no contact is found for is a contact of
// two wholes: none is lost.
void report_touch(const ImpactStage::Scene& scene, const Sides& sides, const Impact& impact, const Pair& pair,
                  std::size_t number, Real touching, JobList& jobs, JobResult& result) {
  ChunkScratch& scratch = jobs.scratch(number);
  const AnyShape &a = *scene.places.shapes[sides.job.a], &b = *scene.places.shapes[sides.job.b];
  const std::size_t first = scratch.points.size();
  const bool is_undecided = impact.state == ImpactState::undecided;
  const bool is_ahead = impact.state == ImpactState::touches;
  const Moment moment = moment_at(sides, is_undecided ? impact.lower : is_ahead ? impact.upper : 0);
  if (is_undecided) {
    Distance distance{};
    if (pair_distance(a, b, moment.a, moment.b, {}, distance) == Outcome::ok) {
      add_point(distance, moment, scratch.points);
    }
  } else {
    const Real margin = touching + (is_ahead ? depth_of_touch * size_of(a, b) : 0);
    find_points(scene.places, sides, moment, scene.policies.at(pair.policy), margin, scratch.points);
    if (scratch.points.size() == first) {
      add_point(impact.contact, moment, scratch.points);
    }
  }
  finish(scene, sides, moment, pair, number, first, [](const ContactPoint&) { return true; }, scratch, result);
}

void report_speculative(const ImpactStage::Scene& scene, const Sides& sides, const Pair& pair, std::size_t number,
                        Real touching, JobList& jobs, JobResult& result) {
  const Real most = closing(sides, scene.places);
  if (!std::isfinite(most)) {
    return;
  }
  ChunkScratch& scratch = jobs.scratch(number);
  const std::size_t first = scratch.points.size();
  const Moment moment = moment_at(sides, 0);
  find_points(scene.places, sides, moment, scene.policies.at(pair.policy), touching + most, scratch.points);
  const auto is_within = [&](const ContactPoint& contact) {
    const Vec3 normal = moment.a.rotation * contact.normal;
    return contact.distance - touching <= std::max<Real>(closing_along(normal, sides, scene.places), 0);
  };
  finish(scene, sides, moment, pair, number, first, is_within, scratch, result);
}

}  // namespace

Outcome find_impact(const Places& places, std::uint32_t a, const Path& path_a, std::uint32_t b, const Path& path_b,
                    Real margin, Impact& out) {
  return time_of_impact(*places.shapes[a], path_a, *places.shapes[b], path_b, {.margin = std::max<Real>(margin, 0)},
                        out);
}

void ImpactStage::examine(const Scene& scene, const Pair& pair, std::size_t number, JobList& jobs, Ahead& its) {
  const PairJob& job = jobs.jobs()[its.job];
  const Places& places = scene.places;
  const auto has = [&](Sweeping sweeping) {
    return places.infos[job.a].sweeping == sweeping || places.infos[job.b].sweeping == sweeping;
  };
  if (!scene.paths.moves(job.a) && !scene.paths.moves(job.b)) {
    return;
  }
  const Sides sides{job, scene.paths.of(job.a), scene.paths.of(job.b)};
  JobResult& result = jobs.result(its.job);
  its.touching = std::max<Real>(job.margin, 0);
  if (!has(Sweeping::impacts)) {
    its.is_ahead = true;
    report_speculative(scene, sides, pair, number, its.touching, jobs, result);
    return;
  }
  const bool begins_here = scene.paths.begins_at_pose(job.a) && scene.paths.begins_at_pose(job.b);
  if (begins_here && result.count > 0) {
    return;
  }
  Impact impact;
  if (find_impact(places, job.a, sides.a, job.b, sides.b, job.margin, impact) != Outcome::ok) {
    return;
  }
  its.lower = impact.lower;
  its.upper = impact.upper;
  its.is_undecided = impact.state == ImpactState::undecided;
  its.is_ahead = its.is_impact = its.is_undecided || impact.state == ImpactState::touches;
  if (impact.state == ImpactState::apart) {
    result = {static_cast<std::uint32_t>(number), 0, 0};
  } else {
    report_touch(scene, sides, impact, pair, number, its.touching, jobs, result);
  }
}

void ImpactStage::run(const Workers& workers, const Scene& scene, std::span<const ProxyPair> wanted,
                      std::span<const Pair> pairs, JobList& jobs) {
  ahead_.clear();
  for (const ProxyPair& its : wanted) {
    const std::size_t at = find_pair(pairs, its);
    if (at < pairs.size() && pairs[at].job != no_job) {
      ahead_.push_back({.pair = static_cast<std::uint32_t>(at), .job = pairs[at].job});
    }
  }
  const std::size_t blocks = (ahead_.size() + pairs_of_block - 1) / pairs_of_block;
  const std::size_t first = jobs.add_scratch(blocks);
  workers.for_each(blocks, [&](std::size_t block) {
    ChunkScratch& scratch = jobs.scratch(first + block);
    scratch.points.clear();
    scratch.locals.clear();
    const std::size_t begin = block * pairs_of_block, end = std::min(begin + pairs_of_block, ahead_.size());
    for (std::size_t i = begin; i < end; ++i) {
      examine(scene, pairs[ahead_[i].pair], first + block, jobs, ahead_[i]);
    }
  });
}

void ImpactStage::mark(std::span<const Pair> pairs, ContactList& contacts) {
  impacts_.clear();
  for (const Ahead& its : ahead_) {
    const Pair& pair = pairs[its.pair];
    if (its.is_ahead) {
      contacts.mark_ahead(pair, its.is_impact ? its.lower : 0, its.touching);
    }
    if (its.is_impact) {
      impacts_.push_back({.geometry_a = {pair.low + 1, pair.generation_low},
                          .geometry_b = {pair.high + 1, pair.generation_high},
                          .lower = its.lower,
                          .upper = its.upper,
                          .is_undecided = its.is_undecided,
                          .first_contact = pair.first_contact,
                          .contact_count = pair.contact_count});
    }
  }
  std::ranges::sort(impacts_, {}, [](const StepImpact& its) {
    return std::tuple(its.lower, its.geometry_a.slot, its.geometry_b.slot);
  });
}

std::size_t ImpactStage::bytes() const {
  return ahead_.capacity() * sizeof(Ahead) + impacts_.capacity() * sizeof(StepImpact);
}

}  // namespace abut
