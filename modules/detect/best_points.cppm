// SPDX-License-Identifier: Apache-2.0
// Which points of a pair become its contacts.
export module abut.detect.best_points;
import abut.core.standard;
import abut.detect.jobs;
import abut.narrow.manifold;
import abut.scene.options;
import abut.capability;

export namespace abut {

// Brings to the front those with a distance that is wanted, reduced as the options say, and counts them. A reduction
// prefers what the pair had before: `history` hands over the contacts of the detection before, and is asked for a
// reduction alone.
template <class IsWanted, class History>
[[nodiscard]] std::size_t keep_best(std::span<ContactPoint> found, const UniverseOptions& options, Detail detail,
                                    ChunkScratch& scratch, IsWanted&& is_wanted, History&& history) {
  const auto kept = static_cast<std::size_t>(std::partition(found.begin(), found.end(), is_wanted) - found.begin());
  scratch.ids.clear();
  if (options.max_contacts != 0 && kept > options.max_contacts) {
    for (const ContactHistory& its : history()) {
      scratch.ids.push_back(its.id);
    }
  }
  std::size_t left = reduce_children(found.first(kept), options.max_contacts, scratch.ids, scratch.reduction);
  left = options.max_pair_contacts == 0 ? left : cap(found.first(left), options.max_pair_contacts);
  return detail == Detail::point ? std::min<std::size_t>(left, 1) : left;
}

}  // namespace abut
