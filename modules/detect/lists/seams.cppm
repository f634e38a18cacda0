// SPDX-License-Identifier: Apache-2.0
// Bodies that lie across the seam of two parts: what one geometry takes for its border, another one goes on from.
export module abut.detect.lists.seams;
import abut.core.standard;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;

export namespace abut {

// What the stage asks besides jobs.
struct [[gsl::Pointer]] SeamScene {
  const UniverseOptions& options;
  const PolicyTable& policies;
  const Places& places;
  std::span<const ContactHistory> histories;
  std::span<const Pair> pairs;
};

class SeamStage {
 public:
  // Takes contacts at seams out of the results of jobs, or welds them. Parts that are dynamic have none with each
  // other. Pairs that this detection did not examine stay as they are, and so do those that a back end answered.
  // O(touching jobs with a part), and O(n log n) of them where there is more than one part. Parts are surfaces; where
  // the universe welds, convex shapes too.
  void run(const SeamScene& scene, JobList& jobs);
  [[nodiscard]] std::size_t bytes() const { return sides_.capacity() * sizeof(Side); }

 private:
  // A job that found contacts of a body with a part.
  struct Side {
    std::uint32_t body, part, job;
  };
  void find_sides(const SeamScene& scene, const JobList& jobs);

  std::vector<Side> sides_;
};

}  // namespace abut
