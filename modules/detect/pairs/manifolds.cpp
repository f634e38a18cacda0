// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs.manifolds;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.backend;
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
  bool is_given = false;  // by a back end: in the world, from the lower place to the higher one
};

// Jobs of a chunk next to each other.
struct JobRange {
  std::uint32_t chunk, begin, end;
};

// Keeps of the points of a job what is reported, reduced and moved to the world. Jobs come in the order of kinds, so
// that whatever it reads of its pair is far away in memory: only reductions, which are rare, look there.
void finish_job(const FoundPoints& points, const UniverseOptions& options, Detail detail, const Places& places,
                std::span<const ContactHistory> histories, std::span<const Pair> pairs, JobList& jobs) {
  JobResult& result = jobs.result(points.job);
  result = {.chunk = points.chunk, .is_given = points.is_given};
  if (points.count == 0) {
    return;
  }
  ChunkScratch& scratch = jobs.scratch(points.chunk);
  const PairJob& its = jobs.jobs()[points.job];
  const std::span<ContactPoint> found = std::span(scratch.points).subspan(points.first, points.count);
  const auto reported = [&](const ContactPoint& contact) { return is_reported(contact.distance, its.margin); };
  if (detail == Detail::touch) {
    result.is_touching = std::ranges::any_of(found, reported);
    return;
  }
  const bool is_swapped = its.a > its.b;
  const std::uint32_t low = is_swapped ? its.b : its.a, high = is_swapped ? its.a : its.b;
  const AnyShape &first = *places.shapes[points.is_given ? low : its.a],
                 &second = *places.shapes[points.is_given ? high : its.b];
  const auto surfaces = [&](const ContactPoint& contact) { return surfaces_of(first, second, contact); };
  const std::size_t left = keep_best(found, options, detail, surfaces, scratch, reported, [&] {
    const Pair& pair = pairs[jobs.pair_of(points.job)];
    return histories.subspan(pair.first_before, pair.count_before);
  });
  for (ContactPoint& contact : found.first(points.is_given ? 0 : left)) {
    move_by(contact, places.worlds[its.a], is_swapped);
  }
  if (options.keeps_local_points) {
    const Pose &a = places.worlds[low], &b = places.worlds[high];
    scratch.locals.resize(scratch.points.size());
    for (std::size_t i = 0; i < left; ++i) {
      scratch.locals[points.first + i] = {a.undo(found[i].point_a), b.undo(found[i].point_b)};
    }
  }
  result.first = static_cast<std::uint32_t>(points.first);
  result.count = static_cast<std::uint32_t>(left);
}

// What pairs that remember sides touch depends on these.
bool has_sides(const JobRange& range, const SideStage& sides) {
  bool has_any = false;
  for (std::uint32_t job = range.begin; job < range.end; ++job) {
    has_any = has_any || sides.has(job);
  }
  return has_any;
}

// Of jobs whose contacts nobody wants.
void find_touches(const JobRange& range, const Places& places, JobList& jobs) {
  Manifold& scratch = jobs.scratch(range.chunk).points;
  for (std::uint32_t job = range.begin; job < range.end; ++job) {
    const PairJob& its = jobs.jobs()[job];
    bool is_touching = false;
    const Outcome outcome =
        pair_overlaps(*places.shapes[its.a], *places.shapes[its.b], places.worlds[its.a], places.worlds[its.b],
                      its.margin, OverlapRule::of_contacts, scratch, is_touching);
    jobs.result(job) = {.chunk = range.chunk, .is_touching = outcome == Outcome::ok && is_touching};
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

void find_in_range(const JobRange& range, const UniverseOptions& options, const PolicyTable& policies,
                   const Places& places, std::span<const ContactHistory> histories, PairStore& pairs, SideStage& sides,
                   JobList& jobs) {
  const Chunk& chunk = jobs.chunks()[range.chunk];
  const Policy& policy = policies.at(chunk.policy);
  if (policy.detail == Detail::touch && !is_self_run(chunk.run) && !has_sides(range, sides)) {
    find_touches(range, places, jobs);
    return;
  }
  ChunkScratch& scratch = jobs.scratch(range.chunk);
  const std::span<const PairJob> its_jobs = jobs.jobs().subspan(range.begin, range.end - range.begin);
  const QuerySettings settings = settings_of(policy, chunk.run, options.welds);
  scratch.results.resize(its_jobs.size());
  const auto run = [&](std::span<const PairJob> some, const QuerySettings& its, std::span<PairResult> results) {
    if (is_self_run(chunk.run)) {
      self_contacts_of_run(places.shapes, some, its, scratch.points, results);
    } else {
      const RunKinds kinds{chunk.run / shape_kind_count, chunk.run % shape_kind_count};
      contacts_of_run(kinds, places.shapes, places.worlds, some, its, pairs.memories(), scratch.points, results);
    }
  };
  std::size_t begin = scratch.points.size();
  run(its_jobs, settings, scratch.results);
  for (std::size_t i = 0; i < its_jobs.size(); ++i) {
    std::size_t end = scratch.results[i].contacts_end;
    const std::size_t next = end;
    if (scratch.results[i].outcome != Outcome::ok) {
      // The pair does not have the algorithm of the policy, or that gave up.
      begin = scratch.points.size();
      run(its_jobs.subspan(i, 1), QuerySettings{.welds = options.welds}, std::span(scratch.results).subspan(i, 1));
      end = scratch.points.size();
    }
    if (const std::size_t job = range.begin + i; sides.has(job)) [[unlikely]] {
      QuerySettings of_job = settings;
      of_job.margin = its_jobs[i].margin;
      const std::size_t first = scratch.points.size();
      if (sides.find(job, its_jobs[i], places, of_job, scratch.points)) {
        begin = first;
        end = scratch.points.size();
      }
    }
    finish_job({range.begin + i, range.chunk, begin, end - begin}, options, policy.detail, places, histories,
               pairs.all(), jobs);
    begin = next;
  }
}

// What a back end has answered goes the way of what a kernel finds from here on.
void take_answer(std::uint32_t chunk, std::uint32_t job, const UniverseOptions& options, const PolicyTable& policies,
                 const Places& places, std::span<const ContactHistory> histories, std::span<const Pair> pairs,
                 const BackendStage& backend, JobList& jobs) {
  Manifold& points = jobs.scratch(chunk).points;
  const std::span<const ContactPoint> its = backend.of(job);
  const std::size_t first = points.size();
  points.insert(points.end(), its.begin(), its.end());
  finish_job({job, chunk, first, its.size(), true}, options, policies.at(jobs.chunks()[chunk].policy).detail, places,
             histories, pairs, jobs);
}

void find_in_chunk(std::uint32_t number, const UniverseOptions& options, const PolicyTable& policies,
                   const Places& places, std::span<const ContactHistory> histories, PairStore& pairs,
                   const BackendStage& backend, SideStage& sides, JobList& jobs) {
  const Chunk& chunk = jobs.chunks()[number];
  jobs.scratch(number).points.clear();
  if (chunk.run >= path_run) {
    for (std::uint32_t job = chunk.begin; job < chunk.end; ++job) {
      jobs.result(job) = {.chunk = number};
    }
    return;
  }
  for (std::uint32_t begin = chunk.begin, end = begin; begin < chunk.end; begin = end) {
    while (end < chunk.end && !backend.has(end)) {
      ++end;
    }
    if (begin < end) {
      find_in_range({number, begin, end}, options, policies, places, histories, pairs, sides, jobs);
    }
    if (end < chunk.end) {
      take_answer(number, end++, options, policies, places, histories, pairs.all(), backend, jobs);
    }
  }
}

}  // namespace

void find_manifolds(const Workers& workers, const UniverseOptions& options, const PolicyTable& policies,
                    const Places& places, std::span<const ContactHistory> histories, bool is_timed, PairStore& pairs,
                    const BackendStage& backend, SideStage& sides, JobList& jobs) {
  workers.for_each(jobs.chunks().size(), [&](std::size_t chunk) {
    Stopwatch watch(is_timed);
    find_in_chunk(static_cast<std::uint32_t>(chunk), options, policies, places, histories, pairs, backend, sides, jobs);
    jobs.scratch(chunk).microseconds = watch.lap();
  });
}

}  // namespace abut
