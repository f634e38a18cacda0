// SPDX-License-Identifier: Apache-2.0
// Contacts of one body with parts that lie side by side, where one of them is convex: boxes of a floor, hulls of one
// body, a box beside a mesh. The wall between two parts is a wall to each of them and none of the whole.
//
// A neighbour is searched for at the point of a contact and beside it on the same face or edge. At the foot of a step,
// the wall beside the floor rises over the floor's contact, but not a stride away from it. Contacts that a neighbour
// covers are not turned by a formula. The same kernel computes them again after the body has been moved out of the
// other parts. So regions, features and ids are those of any pair.
export module abut.pairs.composites.welds;
import abut.core.standard;
import abut.math;
import abut.pairs.shape_handle;
import abut.pairs.composites.seam_parts;

export namespace abut {

// In the frame of the seams. A body of any kind.
struct [[gsl::Pointer]] BodyAtSeams {
  const AnyShape& shape;
  Pose pose;
};

// Contacts on the outside of the whole stay. Those that lie where a neighbour goes on past them are taken out. In their
// place `added` gets what the body has with the part after the shortest move out of the rest. It is told as the body
// lies before that move. Where the move does not part the two, the body leaves by the nearest face that leads out of
// all parts. O(contacts * parts), and a query of the pair for each part that loses contacts.
void weld(std::span<Seam> seams, const BodyAtSeams& body);

}  // namespace abut
