// SPDX-License-Identifier: Apache-2.0
// The contacts of two geometries on their paths through a step.
//
// If both shapes are convex and one of them has moved, the path yields all contacts, so the narrow phase skips the
// pair. Three tests come first, cheapest first. Along the line between the centres at their closest, most passing pairs
// are apart. Along that line at the start, others are apart for a while; the search for a touch begins after it.
// Contacts at the start yield the touches at the start. Only the remaining pairs need a time of impact.
export module abut.detect.continuous.path_contacts;
import abut.core.standard;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.paths;
import abut.detect.continuous.sweeps;
import abut.math;
import abut.motion.time_of_impact;
import abut.pairs.pair_job;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;

export namespace abut {

struct [[gsl::Pointer]] PathScene {
  const UniverseOptions& options;
  const PolicyTable& policies;
  const Places& places;
  const Paths& paths;
  const Sweeps& sweeps;
  std::span<const ContactHistory> histories;  // of the detection before
};

// The two sides of a job, on their paths.
struct [[gsl::Pointer]] Sides {
  const PairJob& job;
  const Path &a, &b;
  Aabb box_a, box_b;  // of the shapes in their own frames
};

// Of a job whose contacts will follow those that a scratch has.
[[nodiscard]] JobResult empty_result(std::size_t number, const ChunkScratch& scratch);
// The contacts that a job has found at the start go where those of later touches may follow them.
void take_over(std::size_t number, JobList& jobs, JobResult& result);

// The contacts at the start, if there are any, follow those of the result.
void report_start(const PathScene& scene, const Sides& sides, const Pair& pair, Real touching, ChunkScratch& scratch,
                  JobResult& result);
// The contacts at a touch follow those of the result, each point where its body has it at the start. `touch` is the
// number of the touch within the pair. What no contact is found for is a contact of two wholes: none is lost.
void report_touch(const PathScene& scene, const Sides& sides, const Impact& impact, const Pair& pair,
                  std::uint32_t touch, Real touching, ChunkScratch& scratch, JobResult& result);
// The contacts at the start, up to what the motion may close.
void report_speculative(const PathScene& scene, const Sides& sides, const Pair& pair, std::size_t number, Real touching,
                        JobList& jobs, JobResult& result);

}  // namespace abut
