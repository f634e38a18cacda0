// SPDX-License-Identifier: Apache-2.0
// The narrow phase of a detection: from jobs to the points of each, reduced and in the world.
export module abut.detect.manifolds;
import abut.core.standard;
import abut.core.workers;
import abut.detect.jobs;
import abut.detect.pairs;
import abut.scene.options;
import abut.scene.places;
import abut.scene.policies;

export namespace abut {

// Jobs run in runs of equal kinds, each pair in the frame of its first shape. What they find stays with them. Reduction
// prefers what the pair had before: `histories` are those of the contacts of the detection before.
void find_manifolds(const Workers& workers, const UniverseOptions& options, const PolicyTable& policies,
                    const Places& places, std::span<const ContactHistory> histories, bool is_timed, PairStore& pairs,
                    JobList& jobs);

}  // namespace abut
