// SPDX-License-Identifier: Apache-2.0
// The stage from boxes to jobs: which pairs there are, and which of them are examined.
export module abut.detect.pairs.selection;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.math;
import abut.scene.meetings;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;
import abut.scene.state.space;

export namespace abut {

// What a detection covers of the pairs that have changed.
enum class Coverage : std::uint8_t { changed, everything, pairs, region };
struct [[gsl::Pointer]] Scope {
  Coverage coverage = Coverage::changed;
  std::span<const ProxyPair> pairs = {};  // in order
  CompactAabb region = {};
  Real dt = 0;
  std::uint64_t step = 0;  // the number of the detection, for policies with a period
};

// The geometries that meet themselves, by their places in order, among the pairs that the broad phase has found.
void add_self_pairs(std::span<const std::uint32_t> places, const Space& space, std::vector<ProxyPair>& near);

// Whether the policy that a pair has asks for elements, and both sides have some.
[[nodiscard]] bool asks_for_elements(const Pair& pair, const Places& places, const PolicyTable& policies);
// Gives a pair the policy of its tags.
void assign_policy(Pair& pair, const Places& places, const PolicyTable& policies);

class Selection {
 public:
  // Brings all pairs up to date with what has happened. Those that are stale, covered by the scope and due by their
  // policy become jobs.
  void run(const Workers& workers, const Scope& scope, ToleranceMode mode, const Places& places,
           std::span<const Patch> patches, const Meetings& meetings, PairStore& pairs, JobList& jobs);
  [[nodiscard]] std::size_t bytes() const;

 private:
  // What one task finds.
  struct Task {
    std::vector<Pair> lost;
    std::vector<std::uint32_t> without_memory;  // by their place among the pairs
  };
  std::vector<Task> tasks_;
};

}  // namespace abut
