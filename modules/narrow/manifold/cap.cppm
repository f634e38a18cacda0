// SPDX-License-Identifier: Apache-2.0
// Caps the contacts of one pair whose shapes have many parts. Each normal of a ball in a mesh is a patch of its own.
export module abut.narrow.manifold.cap;
import abut.capability;
import abut.core.standard;

export namespace abut {

// Reorders the contacts of one pair so that the ones to keep come first, deepest first, and returns how many: no more
// than `most`, or all where that is 0. The deepest one stays. Contacts whose normals agree (cosine at least 0.98) form
// a cluster. The deepest of each cluster comes next; where there are too many clusters, those whose normals lie
// furthest from each other stay. Any room that is left goes to the contacts furthest from those kept. The order of the
// input does not matter.
//
// Furthest-point sampling (Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985): no choice of as
// many comes nearer to all others by more than a factor of two. Time: contacts times clusters, of which there are a few
// hundred at most, and contacts times `most`.
[[nodiscard]] std::size_t cap(std::span<ContactPoint> contacts, std::size_t most);

}  // namespace abut
