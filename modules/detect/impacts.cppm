// SPDX-License-Identifier: Apache-2.0
// The narrow phase of those that look at their path through a step: when they first touch on it, and where.
export module abut.detect.impacts;
import abut.broadphase;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.contacts;
import abut.detect.jobs;
import abut.detect.pairs;
import abut.detect.paths;
import abut.math;
import abut.motion.time_of_impact;
import abut.scene.options;
import abut.scene.places;
import abut.scene.policies;

export namespace abut {

class ImpactStage {
 public:
  struct Scene {
    const UniverseOptions& options;
    const PolicyTable& policies;
    const Places& places;
    const Paths& paths;
    std::span<const ContactHistory> histories;  // of the detection before
  };

  // Pairs that have a job get the contacts of their path instead of those of their present poses:
  // - those that touch at the start of the step: the contacts there;
  // - those that touch later: the contacts there, each point being where its body has it at the start;
  // - those that ask for speculative contacts: the contacts at the start, up to what the motion may close.
  void run(const Workers& workers, const Scene& scene, std::span<const ProxyPair> wanted, std::span<const Pair> pairs,
           JobList& jobs);
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
  // A pair and what its path led to.
  struct Ahead {
    std::uint32_t pair, job;
    bool is_impact = false, is_undecided = false;
    bool is_ahead = false;      // its contacts may lie ahead of a touch
    Real lower = 0, upper = 0;  // of an impact
    Real touching = 0;          // up to this distance its contacts touch
  };
  static void examine(const Scene& scene, const Pair& pair, std::size_t number, JobList& jobs, Ahead& its);

  std::vector<Ahead> ahead_;
  std::vector<StepImpact> impacts_;
};

// Of two places, of which one has a sweeping; the margin is what counts as touching. Not ok where the kinds do not
// meet.
[[nodiscard]] Outcome find_impact(const Places& places, std::uint32_t a, const Path& path_a, std::uint32_t b,
                                  const Path& path_b, Real margin, Impact& out);

}  // namespace abut
