// Candidate pairs as runs of equal kinds, which is how the narrow phase takes them.
module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>
export module abut.universe.pairs;
import abut.any_shape;
import abut.broadphase;
import abut.dispatch;
import abut.math;
import abut.universe.options;

export namespace abut {

// What happened to the pairs of two kinds in the last step.
struct KindTally {
  std::uint64_t candidates = 0, touching = 0, contacts = 0;
};

class PairRuns {
 public:
  static constexpr std::size_t run_count = shape_kind_count * shape_kind_count;
  static constexpr std::uint32_t no_job = 0xffffffff;

  PairRuns();

  // A run for each pair of kinds that occurs and has an algorithm. `kinds` and `tolerances` are by
  // number of box. Keeps the order of the pairs within a run.
  void arrange(std::span<const ProxyPair> pairs, std::span<const std::uint8_t> kinds, std::span<const Real> tolerances,
               ToleranceMode mode);

  // The run of two kinds, by their places in the registry, row not above column.
  [[nodiscard]] static constexpr std::size_t run_of(std::size_t row, std::size_t column) {
    return row * shape_kind_count + column;
  }
  [[nodiscard]] std::span<const PairJob> jobs() const [[clang::lifetimebound]] { return jobs_; }
  [[nodiscard]] std::span<const PairJob> jobs_of_run(std::size_t run) const [[clang::lifetimebound]] {
    return std::span(jobs_).subspan(starts_[run], starts_[run + 1] - starts_[run]);
  }
  [[nodiscard]] std::size_t start_of_run(std::size_t run) const { return starts_[run]; }
  // Of a pair in the order in which `arrange` got them; no_job for two kinds without an algorithm.
  [[nodiscard]] inline std::uint32_t job_of(std::size_t pair) const { return job_of_pair_[pair]; }
  [[nodiscard]] std::uint64_t unsupported() const { return unsupported_; }
  // Candidates of a run, with those that have no algorithm.
  [[nodiscard]] std::uint64_t candidates_of_run(std::size_t run) const { return candidates_[run]; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  std::array<bool, run_count> supported_{};
  std::array<std::uint64_t, run_count> candidates_{};
  std::array<std::size_t, run_count + 1> starts_{};
  std::uint64_t unsupported_ = 0;
  std::vector<PairJob> jobs_;
  std::vector<std::uint32_t> job_of_pair_;
};

}  // namespace abut
