// SPDX-License-Identifier: Apache-2.0
// The region that two polygons of three or four corners share, all corners at once. Its corners are corners of either
// inside the other, and crossings of an edge of each.
//
// Only a region beyond doubt is found. A corner may lie on the line of an edge within rounding. Then cutting edge by
// edge keeps all answers about it in agreement.
//
// Triangles, boxes and hulls hand over a face of three or four corners, one corner for each lane.
export module abut.narrow.points.small_polygons;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.points.clip;
import abut.narrow.points.lift;

export namespace abut {

// Of small polygons that both look along the normal. False, with nothing found, where there is doubt.
[[nodiscard]] bool clip_small_polygons(const FewCorners& a, const FewCorners& b, const Projection& projection,
                                       ClipPoints& out);

// What contacts of small polygons are made from, beside the polygons.
struct ContactsWanted {
  Vec3 normal;              // unit, from a to b
  Real deepest;             // the distance along it that the contacts are to reach, within `blur`
  Real radius_a, radius_b;  // of the shapes around the polygons
  Real margin;              // the largest distance
  Real blur;
  bool closest_count;  // whether the deepest is one of them
};
// Appends the contacts of the region that two polygons share, in the frame of both, and returns their least distance;
// infinity where there are none. Nothing, with nothing appended, where there is doubt, or where the region misses the
// closest points that count.
[[nodiscard]] std::optional<Real> append_contacts_of(const FewCorners& a, const FewCorners& b,
                                                     const ContactsWanted& wanted, Manifold& out);

}  // namespace abut
