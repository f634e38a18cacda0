// SPDX-License-Identifier: Apache-2.0
// The narrow phase of a detection: from jobs to the points of each, reduced and in the world.
export module abut.detect.pairs.manifolds;
import abut.capability;
import abut.core.standard;
import abut.core.workers;
import abut.detect.backend;
import abut.detect.pairs.jobs;
import abut.detect.pairs;
import abut.detect.pairs.sides;
import abut.narrow.manifold;
import abut.scene.state.options;
import abut.scene.state.places;
import abut.scene.meetings.policies;

export namespace abut {

// Jobs run in runs of equal kinds, each pair in the frame of its first shape. What they find stays with them. Reduction
// prefers what the pair had before: `histories` are those of the contacts of the detection before. `sides` has started,
// and `backend` has run: jobs that it answered get its contacts in place of those of a kernel.
void find_manifolds(const Workers& workers, const UniverseOptions& options, const PolicyTable& policies,
                    const Places& places, std::span<const ContactHistory> histories, bool is_timed, PairStore& pairs,
                    const BackendStage& backend, SideStage& sides, JobList& jobs);

// Brings to the front those with a distance that is wanted, reduced as the options say, and counts them. A reduction
// prefers what the pair had before: `history` hands over the contacts of the detection before, and is asked for a
// reduction alone.
template <class IsWanted, class History>
[[nodiscard]] std::size_t keep_best(std::span<ContactPoint> found, const UniverseOptions& options, Detail detail,
                                    const SurfacesOf& surfaces_of, ChunkScratch& scratch, IsWanted&& is_wanted,
                                    History&& history) {
  const auto kept = static_cast<std::size_t>(std::partition(found.begin(), found.end(), is_wanted) - found.begin());
  scratch.ids.clear();
  if (options.max_contacts != 0 && kept > options.max_contacts) {
    for (const ContactHistory& its : history()) {
      scratch.ids.push_back(its.id);
    }
  }
  std::size_t left =
      reduce_children(found.first(kept), options.max_contacts, scratch.ids, scratch.reduction, surfaces_of);
  left = options.max_pair_contacts == 0 ? left : cap(found.first(left), options.max_pair_contacts);
  return detail == Detail::point ? std::min<std::size_t>(left, 1) : left;
}

}  // namespace abut
