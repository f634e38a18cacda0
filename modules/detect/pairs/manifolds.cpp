// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs.manifolds;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.sides;
import abut.detect.pairs.stopwatch;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.two_shapes.overlap;
import abut.pairs.any_shape;
import abut.pairs.composites.seams;
import abut.pairs.composites.self_contacts;
import abut.pairs.two_shapes.runs;
import abut.pairs.pair_job;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.pairs.two_shapes.measured_routes;
import abut.scene.meetings.policies;

namespace abut {
namespace {

// Without a tolerance touching counts; otherwise an overlap has to exceed the dead band, or a
// separation to be below the margin.
bool is_reported(Real distance, Real margin) { return margin == 0 ? distance <= 0 : distance < margin; }

// Points of a job among those of its chunk.
struct FoundPoints {
  std::size_t job;
  std::uint32_t chunk;
  std::size_t first, count;
};

// Keeps of the points of a job what is reported, reduced and moved to the world. Jobs come in the order of kinds, so
// that whatever it reads of its pair is far away in memory: only reductions, which are rare, look there.
void finish_job(const FoundPoints& points, const UniverseOptions& options, Detail detail, const Places& places,
                std::span<const ContactHistory> histories, std::span<const Pair> pairs, JobList& jobs) {
  if (points.count == 0) {
    jobs.result(points.job) = {points.chunk, 0, 0};
    return;
  }
  ChunkScratch& scratch = jobs.scratch(points.chunk);
  const PairJob& its = jobs.jobs()[points.job];
  const std::span<ContactPoint> found = std::span(scratch.points).subspan(points.first, points.count);
  const auto reported = [&](const ContactPoint& contact) { return is_reported(contact.distance, its.margin); };
  if (detail == Detail::touch) {
    jobs.result(points.job) = {points.chunk, 0, 0, std::ranges::any_of(found, reported)};
    return;
  }
  const auto surfaces = [&](const ContactPoint& contact) {
    return surfaces_of(*places.shapes[its.a], *places.shapes[its.b], contact);
  };
  const std::size_t left = keep_best(found, options, detail, surfaces, scratch, reported, [&] {
    const Pair& pair = pairs[jobs.pair_of(points.job)];
    return histories.subspan(pair.first_before, pair.count_before);
  });
  const bool is_swapped = its.a > its.b;
  for (ContactPoint& contact : found.first(left)) {
    move_by(contact, places.worlds[its.a], is_swapped);
  }
  if (options.keeps_local_points) {
    const Pose &a = places.worlds[is_swapped ? its.b : its.a], &b = places.worlds[is_swapped ? its.a : its.b];
    scratch.locals.resize(scratch.points.size());
    for (std::size_t i = 0; i < left; ++i) {
      scratch.locals[points.first + i] = {a.undo(found[i].point_a), b.undo(found[i].point_b)};
    }
  }
  jobs.result(points.job) = {points.chunk, static_cast<std::uint32_t>(points.first), static_cast<std::uint32_t>(left)};
}

// What pairs that remember sides touch depends on these.
bool has_sides(const Chunk& chunk, const SideStage& sides) {
  bool has_any = false;
  for (std::uint32_t job = chunk.begin; job < chunk.end; ++job) {
    has_any = has_any || sides.has(job);
  }
  return has_any;
}

// Of a chunk whose contacts nobody wants.
void find_touches(std::size_t number, const Places& places, JobList& jobs) {
  const Chunk& chunk = jobs.chunks()[number];
  Manifold& scratch = jobs.scratch(number).points;
  for (std::uint32_t job = chunk.begin; job < chunk.end; ++job) {
    const PairJob& its = jobs.jobs()[job];
    bool is_touching = false;
    const Outcome outcome =
        pair_overlaps(*places.shapes[its.a], *places.shapes[its.b], places.worlds[its.a], places.worlds[its.b],
                      its.margin, OverlapRule::of_contacts, scratch, is_touching);
    jobs.result(job) = {static_cast<std::uint32_t>(number), 0, 0, outcome == Outcome::ok && is_touching};
  }
  scratch.clear();
}

// What a policy asks of the pairs of a run. A time budget chooses for all of them at once.
QuerySettings settings_of(const Policy& policy, std::size_t run, bool welds) {
  QuerySettings settings{.algorithm = policy.algorithm, .error_bound = policy.error_bound, .welds = welds};
  if (policy.time_budget > 0 && is_pair_run(run)) [[unlikely]] {
    take_route(Question::contacts, run / shape_kind_count, run % shape_kind_count, policy.time_budget, settings);
  }
  return settings;
}

void find_in_chunk(std::size_t number, const UniverseOptions& options, const PolicyTable& policies,
                   const Places& places, std::span<const ContactHistory> histories, PairStore& pairs, SideStage& sides,
                   JobList& jobs) {
  const Chunk& chunk = jobs.chunks()[number];
  ChunkScratch& scratch = jobs.scratch(number);
  const std::span<const PairJob> its_jobs = jobs.jobs().subspan(chunk.begin, chunk.end - chunk.begin);
  const Policy& policy = policies.at(chunk.policy);
  const QuerySettings settings = settings_of(policy, chunk.run, options.welds);
  scratch.points.clear();
  if (chunk.run >= path_run) {
    for (std::uint32_t job = chunk.begin; job < chunk.end; ++job) {
      jobs.result(job) = {static_cast<std::uint32_t>(number), 0, 0};
    }
    return;
  }
  if (policy.detail == Detail::touch && !is_self_run(chunk.run) && !has_sides(chunk, sides)) {
    find_touches(number, places, jobs);
    return;
  }
  scratch.results.resize(its_jobs.size());
  const auto run = [&](std::span<const PairJob> some, const QuerySettings& its, std::span<PairResult> results) {
    if (is_self_run(chunk.run)) {
      self_contacts_of_run(places.shapes, some, its, scratch.points, results);
    } else {
      const RunKinds kinds{chunk.run / shape_kind_count, chunk.run % shape_kind_count};
      contacts_of_run(kinds, places.shapes, places.worlds, some, its, pairs.memories(), scratch.points, results);
    }
  };
  run(its_jobs, settings, scratch.results);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < its_jobs.size(); ++i) {
    std::size_t end = scratch.results[i].contacts_end;
    const std::size_t next = end;
    if (scratch.results[i].outcome != Outcome::ok) {
      // The pair does not have the algorithm of the policy, or that gave up.
      begin = scratch.points.size();
      run(its_jobs.subspan(i, 1), QuerySettings{.welds = options.welds}, std::span(scratch.results).subspan(i, 1));
      end = scratch.points.size();
    }
    if (const std::size_t job = chunk.begin + i; sides.has(job)) [[unlikely]] {
      QuerySettings of_job = settings;
      of_job.margin = its_jobs[i].margin;
      const std::size_t first = scratch.points.size();
      if (sides.find(job, its_jobs[i], places, of_job, scratch.points)) {
        begin = first;
        end = scratch.points.size();
      }
    }
    finish_job({chunk.begin + i, static_cast<std::uint32_t>(number), begin, end - begin}, options, policy.detail,
               places, histories, pairs.all(), jobs);
    begin = next;
  }
}

}  // namespace

void find_manifolds(const Workers& workers, const UniverseOptions& options, const PolicyTable& policies,
                    const Places& places, std::span<const ContactHistory> histories, bool is_timed, PairStore& pairs,
                    SideStage& sides, JobList& jobs) {
  workers.for_each(jobs.chunks().size(), [&](std::size_t chunk) {
    Stopwatch watch(is_timed);
    find_in_chunk(chunk, options, policies, places, histories, pairs, sides, jobs);
    jobs.scratch(chunk).microseconds = watch.lap();
  });
}

}  // namespace abut
