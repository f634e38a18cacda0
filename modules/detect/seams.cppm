// SPDX-License-Identifier: Apache-2.0
// Bodies that lie across the seam of two surfaces: what one geometry takes for its border, another one goes on from.
export module abut.detect.seams;
import abut.core.standard;
import abut.detect.jobs;
import abut.scene.places;

export namespace abut {

class SeamStage {
 public:
  // Takes contacts at seams out of the results of jobs. Surfaces that are dynamic have none with each other. Pairs that
  // this detection did not examine stay as they are. O(touching jobs with a surface), and O(n log n) of them where
  // there is more than one surface.
  void run(const Places& places, JobList& jobs);
  [[nodiscard]] std::size_t bytes() const { return sides_.capacity() * sizeof(Side); }

 private:
  // A job that found contacts of a body with a surface.
  struct Side {
    std::uint32_t body, surface, job;
  };
  void find_sides(const Places& places, const JobList& jobs);

  std::vector<Side> sides_;
};

}  // namespace abut
