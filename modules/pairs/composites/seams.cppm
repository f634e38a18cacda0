// SPDX-License-Identifier: Apache-2.0
// Contacts of one body with several parts that meet along a seam. To each surface its border is a border; where
// another one goes on from it, a contact there is none of the whole. Convex parts are welded where somebody asks for
// it.
export module abut.pairs.composites.seams;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold.reduce;
import abut.pairs.shape_handle;
export import abut.pairs.composites.seam_parts;
export import abut.pairs.composites.welds;

export namespace abut {

// Which sides of a contact of two shapes are surfaces. Of a composite it is the child that tells.
[[nodiscard]] SurfaceSides surfaces_of(const AnyShape& a, const AnyShape& b, const ContactPoint& contact);

// Takes out the contacts whose normals belong to no face of their surface, where another surface goes on past them.
// Where that has no contact that is as deep, they turn to their face instead. `size`: of the body. O(contacts *
// surfaces).
void leave_out_at_seams(std::span<Seam> seams, Real size);

// The same, or where a part is convex a weld.
void settle_at_seams(std::span<Seam> seams, const BodyAtSeams& body, Real size);

// A composite or another shape as a side of its contacts.
struct [[gsl::Pointer]] PlacedSide {
  const AnyShape& shape;
  Pose pose;
  bool is_b;
};
// The same for the contacts from `first` on of a composite with each child of the other side. Settings tell whether its
// convex children are welded.
void settle_seams(const PlacedSide& composite, const PlacedSide& other, const QuerySettings& settings,
                  std::size_t first, Manifold& out);

}  // namespace abut
