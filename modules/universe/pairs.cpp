module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>
module abut.universe.pairs;
import abut.any_shape;
import abut.broadphase;
import abut.dispatch;
import abut.math;
import abut.universe.options;

namespace abut {

PairRuns::PairRuns() {
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      supported_[run_of(row, column)] = is_supported(row, column);
    }
  }
}

// A counting sort by run. The kernels expect the kind that comes first in the registry first.
void PairRuns::arrange(std::span<const ProxyPair> pairs, std::span<const std::uint8_t> kinds, std::span<const Real> tolerances,
                       ToleranceMode mode) {
  const auto run_of_pair = [&](const ProxyPair& pair) {
    const std::size_t low = kinds[pair.low], high = kinds[pair.high];
    return low <= high ? run_of(low, high) : run_of(high, low);
  };
  candidates_.fill(0);
  for (const ProxyPair& pair : pairs) {
    ++candidates_[run_of_pair(pair)];
  }
  unsupported_ = 0;
  std::array<std::size_t, run_count> next{};
  std::size_t job_count = 0;
  for (std::size_t run = 0; run < run_count; ++run) {
    starts_[run] = next[run] = job_count;
    (supported_[run] ? job_count : unsupported_) += candidates_[run];
  }
  starts_[run_count] = job_count;

  const Real sign = mode == ToleranceMode::margin ? 1 : -1;
  jobs_.resize(job_count);
  job_of_pair_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [low, high] = pairs[i];
    const std::size_t run = run_of_pair(pairs[i]);
    if (!supported_[run]) {
      job_of_pair_[i] = no_job;
      continue;
    }
    const Real margin = sign * (tolerances[low] + tolerances[high]);
    jobs_[next[run]] = kinds[low] <= kinds[high] ? PairJob{low, high, margin} : PairJob{high, low, margin};
    job_of_pair_[i] = static_cast<std::uint32_t>(next[run]++);
  }
}

std::size_t PairRuns::bytes() const {
  return jobs_.capacity() * sizeof(PairJob) + job_of_pair_.capacity() * sizeof(std::uint32_t);
}

}  // namespace abut
