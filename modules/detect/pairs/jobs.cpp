// SPDX-License-Identifier: Apache-2.0
module abut.detect.pairs.jobs;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.two_shapes.runs;
import abut.pairs.routes;
import abut.pairs.table;
import abut.scene.state.options;
import abut.detect.pairs;
import abut.scene.state.places;
import abut.scene.meetings.policies;

namespace abut {
namespace {

// How many jobs make a chunk. More cost threads their balance, fewer cost everyone overhead. A pair of convex shapes
// takes less than a microsecond, one with a surface ten, and one of two surfaces hundreds.
constexpr std::uint32_t of_convex = 64, of_one_with_parts = 16, of_two_with_parts = 2;

std::uint32_t chunk_size_of(Route route) {
  switch (route) {
    case Route::unsupported:
    case Route::none:
    case Route::half_space:
    case Route::convex:
    case Route::hole: return of_convex;
    case Route::half_space_of_parts:
    case Route::parts:
    case Route::hole_and_parts:
    case Route::hole_of_samples:
    case Route::half_space_of_samples:
    case Route::sampled:
    case Route::children: return of_one_with_parts;
    case Route::parts_of_both:
    case Route::scattered:
    case Route::sampled_and_parts:
    case Route::sampled_both: return of_two_with_parts;
  }
}

}  // namespace

JobList::JobList() {
  chunk_sizes_.fill(of_convex);
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      supported_[run_of(row, column)] = abut::is_supported(row, column);
      gains_from_memory_[run_of(row, column)] = abut::gains_from_memory(row, column);
      chunk_sizes_[run_of(row, column)] = chunk_size_of(route_of(row, column));
    }
    supported_[self_run_of(row)] = meets_itself(row);
    chunk_sizes_[self_run_of(row)] = of_two_with_parts;
  }
}

void JobList::start(std::size_t tasks, const PolicyTable& policies) {
  run_counts_ = policies.size() * job_run_count;
  counts_.assign(tasks * run_counts_, 0);
}

// A counting sort by policy and run. The kernels expect the kind that comes first in the registry first.
void JobList::arrange(const Workers& workers, const Cuts& cuts, std::span<Pair> pairs, std::span<const PlaceInfo> infos,
                      const PolicyTable& policies, ToleranceMode mode) {
  chunks_.clear();
  std::uint32_t sum = 0;
  for (std::size_t run = 0; run < run_counts_; ++run) {
    std::uint32_t begin = sum;
    for (std::size_t task = 0; task < cuts.tasks(); ++task) {
      sum += std::exchange(counts_[task * run_counts_ + run], sum);
    }
    const std::uint32_t chunk_size = chunk_sizes_[run % job_run_count];
    for (; begin < sum; begin += chunk_size) {
      const std::uint32_t end = std::min(begin + chunk_size, sum);
      chunks_.push_back({static_cast<std::uint32_t>(run % job_run_count),
                         static_cast<std::uint32_t>(run / job_run_count), begin, end});
    }
  }
  jobs_.resize(sum);
  pair_of_job_.resize(jobs_.size());
  results_.resize(jobs_.size());
  if (scratch_.size() < chunks_.size()) {
    scratch_.resize(chunks_.size());
  }
  release_excess();
  workers.for_each(jobs_.empty() ? 0 : cuts.tasks(), [&](std::size_t task) {
    const std::span<std::uint32_t> starts = counts_of(task);
    const std::span<PairJob> jobs(jobs_);
    const std::span<std::uint32_t> pair_of_job(pair_of_job_);
    for (std::size_t i = cuts.begin(task); i < cuts.end(task); ++i) {
      Pair& pair = pairs[i];
      if (pair.job == no_job) {
        continue;
      }
      const PlaceInfo &low = infos[pair.low], &high = infos[pair.high];
      const Real margin = margin_of(mode, policies.at(pair.policy), low, high);
      pair.job = starts[run_of_pair(pair)]++;
      jobs[pair.job] = low.kind <= high.kind ? PairJob{pair.low, pair.high, margin, pair.memory}
                                             : PairJob{pair.high, pair.low, margin, pair.memory};
      pair_of_job[pair.job] = static_cast<std::uint32_t>(i);
    }
  });
}

std::size_t JobList::add_scratch(std::size_t count) {
  scratch_.resize(std::max(scratch_.size(), chunks_.size() + count));
  return chunks_.size();
}

// What a detection of all pairs needed and those of a few do not.
void JobList::release_excess() {
  constexpr std::size_t least = 256, most_excess = 8;
  if (scratch_.size() <= least || scratch_.size() <= most_excess * chunks_.size()) {
    return;
  }
  scratch_.resize(std::max(least, 2 * chunks_.size()));
  scratch_.shrink_to_fit();
  jobs_.shrink_to_fit();
  pair_of_job_.shrink_to_fit();
  results_.shrink_to_fit();
}

std::size_t JobList::bytes() const {
  std::size_t scratch = scratch_.capacity() * sizeof(ChunkScratch);
  for (const ChunkScratch& its : scratch_) {
    scratch += its.points.capacity() * sizeof(ContactPoint) + its.locals.capacity() * sizeof(LocalPoints) +
               its.results.capacity() * sizeof(PairResult) + its.ids.capacity() * sizeof(std::uint64_t) +
               its.reduction.order.bytes() + its.reduction.spare.capacity() * sizeof(ContactPoint);
  }
  return scratch + counts_.capacity() * sizeof(std::uint32_t) + jobs_.capacity() * sizeof(PairJob) +
         pair_of_job_.capacity() * sizeof(std::uint32_t) + chunks_.capacity() * sizeof(Chunk) +
         results_.capacity() * sizeof(JobResult);
}

}  // namespace abut
