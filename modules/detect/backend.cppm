// SPDX-License-Identifier: Apache-2.0
// Pairs that a detector of the caller answers in place of the narrow phase.
export module abut.detect.backend;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.sides;
import abut.math;
import abut.scene.state.options;
import abut.scene.state.places;

export namespace abut {

// A pair that a back end is asked about; a is the geometry of the lower slot.
struct BackendPair {
  GeometryId a, b;
  Real margin;
};

struct [[gsl::Pointer]] Backend {
  // Of two kinds by their places in the registry.
  std::function<bool(std::size_t, std::size_t)> accepts;
  // Answers BackendStage::pairs by BackendStage::answer; it may leave any of them.
  std::function<void()> find;
};

class [[gsl::Pointer]] BackendStage {
 public:
  // An empty `find` is no back end.
  void set(Backend backend);
  [[nodiscard]] bool is_on() const { return static_cast<bool>(find_); }
  // Asks about the jobs of pairs of kinds that the back end accepts, in the order of the pairs. Jobs of other stages,
  // of pairs that meet themselves and of those that keep sides are not among them.
  void run(const Places& places, std::span<const Pair> pairs, const SideStage& sides, const JobList& jobs);

  // While `run` asks.
  [[nodiscard]] bool is_asking() const { return is_asking_; }
  [[nodiscard]] std::span<const BackendPair> pairs() const [[clang::lifetimebound]] { return asked_; }
  // In the world, from a to b. Numbers contacts without an id, and those with equal ones, apart.
  [[nodiscard]] Fault answer(std::size_t pair, std::span<const ContactPoint> contacts);

  // Of the last run.
  [[nodiscard]] std::size_t asked() const { return asked_.size(); }
  [[nodiscard]] std::size_t answered() const { return answered_; }
  // Whether a job has its answer, in the world, from the lower place to the higher one.
  [[nodiscard]] bool has(std::size_t job) const { return job < of_job_.size() && of_job_[job].is_given; }
  [[nodiscard]] std::span<const ContactPoint> of(std::size_t job) const [[clang::lifetimebound]] {
    return std::span(points_).subspan(of_job_[job].first, of_job_[job].count);
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  // Contacts of a job.
  struct Given {
    std::size_t first = 0, count = 0;
    bool is_given = false;
  };

  std::function<void()> find_;
  std::array<bool, pair_run_count> accepted_{};
  bool is_asking_ = false;
  std::size_t answered_ = 0;
  std::vector<BackendPair> asked_;
  std::vector<std::uint32_t> jobs_;  // of the pairs that are asked about
  std::vector<Given> of_job_;        // empty without a back end
  Manifold points_;
};

}  // namespace abut
