// SPDX-License-Identifier: Apache-2.0
// Pairs to examine as runs of equal kinds, which is how the narrow phase takes them, cut into chunks that
// threads take.
export module abut.detect.pairs.jobs;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.any_shape;
import abut.pairs.pair_job;
import abut.scene.state.options;
import abut.detect.pairs;
import abut.scene.state.places;
import abut.scene.meetings.policies;

export namespace abut {

// What happened to the pairs of two kinds in the last detection.
struct KindTally {
  std::uint64_t candidates = 0, examined = 0, touching = 0, contacts = 0;
  double microseconds = 0;  // of those examined
  bool is_timed = false;

  KindTally& operator+=(const KindTally& more) {
    candidates += more.candidates;
    examined += more.examined;
    touching += more.touching;
    contacts += more.contacts;
    return *this;
  }
};

// The run of two kinds, by their places in the registry, row not above column; behind those, the runs of kinds that
// meet themselves.
inline constexpr std::size_t pair_run_count = shape_kind_count * shape_kind_count;
inline constexpr std::size_t run_count = pair_run_count + shape_kind_count;
[[nodiscard]] inline constexpr std::size_t run_of(std::size_t row, std::size_t column) {
  return row * shape_kind_count + column;
}
[[nodiscard]] inline constexpr std::size_t self_run_of(std::size_t kind) { return pair_run_count + kind; }
[[nodiscard]] inline constexpr bool is_pair_run(std::size_t run) { return run < pair_run_count; }
[[nodiscard]] inline constexpr bool is_self_run(std::size_t run) { return !is_pair_run(run) && run < run_count; }
// Jobs of all kinds that the narrow phase leaves to the impacts.
inline constexpr std::size_t path_run = run_count;
// Jobs of all kinds that it leaves to the element stage.
inline constexpr std::size_t element_run = run_count + 1;
inline constexpr std::size_t job_run_count = run_count + 2;
[[nodiscard]] inline std::size_t run_of(const Pair& pair, std::size_t kind_low, std::size_t kind_high) {
  if (is_self_pair(pair)) {
    return self_run_of(kind_low);
  }
  return kind_low <= kind_high ? run_of(kind_low, kind_high) : run_of(kind_high, kind_low);
}

// Up to which distance two geometries have contacts: negative in a dead band.
[[nodiscard]] inline Real margin_of(ToleranceMode mode, const Policy& policy, const PlaceInfo& low,
                                    const PlaceInfo& high) {
  const Real tolerance = policy.tolerance < 0 ? low.tolerance + high.tolerance : policy.tolerance;
  return mode == ToleranceMode::margin ? tolerance : -tolerance;
}

// Where the contacts of a job lie in the points of its chunk, after reduction and in the world.
struct JobResult {
  std::uint32_t chunk = 0, first = 0, count = 0;
  bool is_touching = false;  // though contacts are not wanted
  bool is_given = false;     // by a back end
};

// Jobs next to each other of one run and one policy, and the contacts that they found.
struct Chunk {
  std::uint32_t run = 0, policy = 0;
  std::uint32_t begin = 0, end = 0;  // jobs
};
// Memory of a chunk that stays from detection to detection.
struct ChunkScratch {
  Manifold points;
  std::vector<LocalPoints> locals;  // of the points, where the universe keeps them
  std::vector<PairResult> results;
  std::vector<std::uint64_t> ids;
  ReduceScratch reduction;
  double microseconds = 0;  // that the jobs of the last detection took, if it measured them
};

class JobList {
 public:
  JobList();

  [[nodiscard]] inline bool is_supported(std::size_t run) const { return supported_[run]; }
  [[nodiscard]] inline bool gains_from_memory(std::size_t run) const { return gains_from_memory_[run]; }

  // Pairs whose job is not no_job become jobs. They are counted first, each in the task that the list of pairs is cut
  // into; then they are arranged, and get the number of their job. Keeps the order of the pairs within a run. O(pairs +
  // tasks * runs).
  void start(std::size_t tasks, const PolicyTable& policies);
  // One count for each run_of_pair.
  [[nodiscard]] inline std::span<std::uint32_t> counts_of(std::size_t task) [[clang::lifetimebound]] {
    return std::span(counts_).subspan(task * run_counts_, run_counts_);
  }
  [[nodiscard]] static inline std::size_t run_of_pair(const Pair& pair) {
    const std::size_t run = pair.is_on_path ? path_run : pair.run;
    return pair.policy * job_run_count + (pair.is_by_elements ? element_run : run);
  }
  void arrange(const Workers& workers, const Cuts& cuts, std::span<Pair> pairs, std::span<const PlaceInfo> infos,
               const PolicyTable& policies, ToleranceMode mode);

  [[nodiscard]] inline std::span<const PairJob> jobs() const [[clang::lifetimebound]] { return jobs_; }
  // The pair of a job, by its place in the list that `arrange` got.
  [[nodiscard]] inline std::uint32_t pair_of(std::size_t job) const { return pair_of_job_[job]; }
  [[nodiscard]] inline std::span<const Chunk> chunks() const [[clang::lifetimebound]] { return chunks_; }
  [[nodiscard]] inline ChunkScratch& scratch(std::size_t chunk) [[clang::lifetimebound]] { return scratch_[chunk]; }
  [[nodiscard]] inline const ChunkScratch& scratch(std::size_t chunk) const [[clang::lifetimebound]] {
    return scratch_[chunk];
  }
  // Memory behind that of the chunks, for results that do not come from one: the number of the first.
  [[nodiscard]] std::size_t add_scratch(std::size_t count);
  // Results are written in the order of the jobs, so that threads write far from each other. They are read in that of
  // the pairs, which asks for them ahead.
  [[nodiscard]] inline JobResult& result(std::size_t job) [[clang::lifetimebound]] { return results_[job]; }
  [[nodiscard]] inline const JobResult& result(std::size_t job) const [[clang::lifetimebound]] { return results_[job]; }
  inline void fetch_result(std::size_t job) const { __builtin_prefetch(&results_[job]); }
  [[nodiscard]] inline std::span<const ContactPoint> found(const JobResult& its) const [[clang::lifetimebound]] {
    return std::span(scratch_[its.chunk].points).subspan(its.first, its.count);
  }
  // Empty, but for universes that keep them.
  [[nodiscard]] inline std::span<const LocalPoints> locals(const JobResult& its) const [[clang::lifetimebound]] {
    const std::span<const LocalPoints> all(scratch_[its.chunk].locals);
    return all.empty() ? all : all.subspan(its.first, its.count);
  }
  // Asks the cache for what `found` will return.
  inline void fetch_found(const JobResult& its) const {
    for (const ContactPoint& point : found(its)) {
      __builtin_prefetch(&point.point_a);
      __builtin_prefetch(&point.id);
    }
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void release_excess();

  std::array<bool, run_count> supported_{}, gains_from_memory_{};
  std::array<std::uint32_t, job_run_count> chunk_sizes_{};
  std::size_t run_counts_ = 0;         // runs of all policies
  std::vector<std::uint32_t> counts_;  // of the jobs of each run, policy by policy, task by task; then where they start
  std::vector<PairJob> jobs_;
  std::vector<std::uint32_t> pair_of_job_;
  std::vector<Chunk> chunks_;
  std::vector<ChunkScratch> scratch_;
  std::vector<JobResult> results_;
};

}  // namespace abut
