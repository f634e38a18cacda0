module abut.universe.jobs;
import abut.any_shape;
import abut.core.standard;
import abut.dispatch;
import abut.math;
import abut.registry;
import abut.universe.options;
import abut.universe.pairs;
import abut.universe.policies;

namespace abut {

JobList::JobList() {
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      supported_[run_of(row, column)] = abut::is_supported(row, column);
      gains_from_memory_[run_of(row, column)] = pair_kernels(row, column).gains_from_memory;
    }
  }
}

// A counting sort by policy and run. The kernels expect the kind that comes first in the registry first.
void JobList::arrange(std::span<Pair> pairs, std::span<const PlaceInfo> infos, const PolicyTable& policies, ToleranceMode mode) {
  starts_.assign(policies.size() * run_count + 1, 0);
  const auto run_of_pair = [](const Pair& pair) { return pair.policy * run_count + pair.run; };
  for (const Pair& pair : pairs) {
    starts_[run_of_pair(pair) + 1] += pair.job != no_job ? 1 : 0;
  }
  chunks_.clear();
  for (std::size_t run = 0; run + 1 < starts_.size(); ++run) {
    starts_[run + 1] += starts_[run];
    for (std::uint32_t begin = starts_[run]; begin < starts_[run + 1]; begin += chunk_size) {
      const std::uint32_t end = std::min<std::uint32_t>(begin + chunk_size, starts_[run + 1]);
      chunks_.push_back({static_cast<std::uint32_t>(run % run_count), static_cast<std::uint32_t>(run / run_count), begin, end});
    }
  }
  jobs_.resize(starts_.back());
  pair_of_job_.resize(jobs_.size());
  results_.resize(pairs.size());
  if (scratch_.size() < chunks_.size()) {
    scratch_.resize(chunks_.size());
  }
  const Real sign = mode == ToleranceMode::margin ? 1 : -1;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Pair& pair = pairs[i];
    if (pair.job == no_job) {
      continue;
    }
    const PlaceInfo &low = infos[pair.low], &high = infos[pair.high];
    const Real tolerance = policies.at(pair.policy).tolerance;
    const Real margin = sign * (tolerance < 0 ? low.tolerance + high.tolerance : tolerance);
    pair.job = starts_[run_of_pair(pair)]++;
    jobs_[pair.job] = low.kind <= high.kind ? PairJob{pair.low, pair.high, margin, pair.memory}
                                           : PairJob{pair.high, pair.low, margin, pair.memory};
    pair_of_job_[pair.job] = static_cast<std::uint32_t>(i);
  }
}

std::size_t JobList::bytes() const {
  std::size_t scratch = scratch_.capacity() * sizeof(ChunkScratch);
  for (const ChunkScratch& its : scratch_) {
    scratch += its.points.capacity() * sizeof(ContactPoint) + its.results.capacity() * sizeof(PairResult) +
               its.ids.capacity() * sizeof(std::uint64_t);
  }
  return scratch + starts_.capacity() * sizeof(std::uint32_t) + jobs_.capacity() * sizeof(PairJob) +
         pair_of_job_.capacity() * sizeof(std::uint32_t) + chunks_.capacity() * sizeof(Chunk) + results_.capacity() * sizeof(JobResult);
}

}  // namespace abut
