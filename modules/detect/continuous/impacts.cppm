// SPDX-License-Identifier: Apache-2.0
// The narrow phase of those that look at their path through a step: when they touch on it, and where.
export module abut.detect.continuous.impacts;
import abut.core.standard;
import abut.core.workers;
import abut.detect.lists.contacts;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
export import abut.detect.continuous.path_contacts;
import abut.detect.paths;
import abut.detect.continuous.touches;
import abut.math;
import abut.motion.time_of_impact;
import abut.scene.state.options;
import abut.scene.state.places;

export namespace abut {

class ImpactStage {
 public:
  // Before the selection, with the numbers of the wanted pairs: marks those that need no contacts of present poses.
  void start(std::span<const std::uint32_t> wanted, const Paths& paths, const Places& places, std::span<Pair> pairs);
  // Those that have a job get the contacts of their path instead of those of their present poses:
  // - those that touch at the start of the step: the contacts there;
  // - those that touch later: the contacts of each touch, in order of time, each point where its body has it at the
  //   start;
  // - those that ask for speculative contacts: the contacts at the start, up to what the motion may close.
  void run(const Workers& workers, const PathScene& scene, std::span<Pair> pairs, JobList& jobs);
  void clear() {
    ahead_.clear();
    impacts_.clear();
  }
  // Marks the contacts, once they are in the list of the step, and writes the impacts down.
  void mark(std::span<const Pair> pairs, ContactList& contacts);

  // Of the last step, in order of time.
  [[nodiscard]] std::span<const StepImpact> all() const [[clang::lifetimebound]] { return impacts_; }
  void restore(std::vector<StepImpact> impacts) { impacts_ = std::move(impacts); }
  // Pairs whose paths were looked at.
  [[nodiscard]] std::uint64_t examined() const { return ahead_.size(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Touch {
    Real lower, upper;
    std::uint32_t contact_count;
    bool is_undecided;
  };
  // A pair and what its path led to.
  struct Ahead {
    std::uint32_t pair, job = no_job;
    bool is_told_by_path = false, is_speculative = false;
    std::uint32_t count_at_start = 0;  // of contacts that do not lie ahead; those of the touches follow them
    std::uint32_t touch_count = 0;
    std::uint32_t first_touch = 0;  // of those of its block
    Real touching = 0;              // up to this distance its contacts touch
  };
  // Pairs next to each other that one task takes: their points, and their touches.
  struct [[gsl::Pointer]] Block {
    std::size_t number;  // of the scratch
    std::vector<Touch>& touches;
  };
  void fetch(const PathScene& scene, std::span<const Pair> pairs, const JobList& jobs, std::size_t number) const;
  static void add_touch(const PathScene& scene, const Sides& sides, const Impact& impact, const Pair& pair,
                        const Block& block, JobList& jobs, Ahead& its);
  static void follow(const PathScene& scene, const Sides& sides, const Pair& pair, Real time, const Block& block,
                     JobList& jobs, Ahead& its);
  static void examine(const PathScene& scene, const Pair& pair, const Block& block, JobList& jobs, Ahead& its);

  std::vector<Ahead> ahead_;
  std::vector<std::vector<Touch>> touches_;  // by block
  std::vector<StepImpact> impacts_;
};

}  // namespace abut
