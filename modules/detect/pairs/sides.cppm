// SPDX-License-Identifier: Apache-2.0
// The pairs that remember from which side of a surface a body came.
export module abut.detect.pairs.sides;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.pairs.surfaces.kept_sides;
import abut.pairs.pair_job;
import abut.scene.state.options;
import abut.scene.state.places;

export namespace abut {

// Between detections: what each pair remembers. Within one: the jobs of such pairs, which threads ask one by one.
class SideStage {
 public:
  // The jobs of pairs of which a geometry keeps sides. `is_used`: whether there is such a geometry. O(jobs) then.
  void start(bool is_used, const Places& places, const JobList& jobs);
  // Whether a job may have other contacts than those of the pair alone.
  [[nodiscard]] bool has(std::size_t job) const { return job < case_of_job_.size() && case_of_job_[job] != no_index; }
  // Where the contacts of a job are others, adds them to `out`, in the frame of its first shape.
  [[nodiscard]] bool find(std::size_t job, const PairJob& its, const Places& places, const QuerySettings& settings,
                          Manifold& out);
  // After all jobs: what the pairs remember. Those that were not examined remember what they did.
  void settle(const Places& places, std::span<const Pair> pairs);

  // Between detections.
  template <class Archive, class Self>
  static void transfer(Archive& archive, Self& self) {
    archive(self.kept_);
  }
  // Of a list that was read: whether it is of surfaces and bodies that are there, in order.
  [[nodiscard]] bool is_right(const Places& places) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::uint32_t no_index = 0xffffffff;
  struct Kept {
    std::uint32_t low, high;                        // places, as in a pair
    std::uint32_t generation_low, generation_high;  // of the ids that live there
    std::vector<SidesOfChildren> memories;
  };
  struct Case {
    std::uint32_t low, high;
    KeptSide side;
  };
  void add_case(const PairJob& its, std::size_t job, const Places& places);
  [[nodiscard]] static bool is_same(const Kept& kept, const Places& places);

  std::vector<Kept> kept_;  // in order of their places
  std::vector<Case> cases_;
  std::vector<std::uint32_t> case_of_job_;  // empty where no geometry keeps sides
};

}  // namespace abut
