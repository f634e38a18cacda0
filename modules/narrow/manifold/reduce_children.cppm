// SPDX-License-Identifier: Apache-2.0
// Reduces contacts of composites and particles: each pair of children is a manifold of its own.
export module abut.narrow.manifold.reduce_children;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.places_in_order;
import abut.narrow.manifold.reduce;

export namespace abut {

// Memory that stays from reduction to reduction.
struct ReduceScratch {
  PlacesInOrder order;
  Manifold spare;
};

// Which sides of a contact are surfaces, as its children tell.
using SurfacesOf = std::function<SurfaceSides(const ContactPoint&)>;

// Reduces each pair of children by itself, without or with the ids that were kept before. What is kept comes first, the
// deepest first.
[[nodiscard]] std::size_t reduce_children(std::span<ContactPoint> contacts, std::size_t most,
                                          const SurfacesOf& surfaces_of);
[[nodiscard]] std::size_t reduce_children(std::span<ContactPoint> contacts, std::size_t most,
                                          std::span<const std::uint64_t> before, ReduceScratch& scratch,
                                          const SurfacesOf& surfaces_of);

}  // namespace abut
