// SPDX-License-Identifier: Apache-2.0
// Contacts of one body with several surfaces that meet along a seam. To each surface its border is a border; where
// another one goes on from it, a contact there is none of the whole.
export module abut.pairs.registry.seams;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold.reduce;
import abut.pairs.registry;

export namespace abut {

// By place in the registry.
[[nodiscard]] bool is_surface_kind(std::size_t kind);
[[nodiscard]] inline bool is_surface(const AnyShape& shape) { return is_surface_kind(shape.index()); }

// Which sides of a contact of two shapes are surfaces. Of a composite it is the child that tells.
[[nodiscard]] SurfaceSides surfaces_of(const AnyShape& a, const AnyShape& b, const ContactPoint& contact);

// A surface that a body touches, and the contacts of both. Poses and contacts are in one frame.
struct Seam {
  Frozen<AnyShape> surface;
  Pose pose;
  bool is_b;  // the surface is side b of its contacts
  std::vector<ContactPoint> contacts;
};

// Takes out the contacts whose normals belong to no face of their surface, where another surface goes on past them.
// Where that has no contact that is as deep, they turn to their face instead. `size`: of the body. O(contacts *
// surfaces).
void leave_out_at_seams(std::span<Seam> seams, Real size);

// The same for the contacts from `first` on of a composite, which lies at a pose, with each child of the other side.
// `is_b`: the composite is side b.
void settle_seams(const AnyShape& composite, const Pose& pose, bool is_b, const AnyShape& other, std::size_t first,
                  Manifold& out);

}  // namespace abut
