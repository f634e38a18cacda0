// SPDX-License-Identifier: Apache-2.0
// The region that two polygons of three or four corners share, all corners at once. Its corners are corners of either
// inside the other, and crossings of an edge of each.
//
// Only a region beyond doubt is found. A corner may lie on the line of an edge within rounding. Then cutting edge by
// edge keeps all answers about it in agreement.
export module abut.narrow.points.small_polygons;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.narrow.points.clip;
import abut.narrow.points.lift;

export namespace abut {

[[nodiscard]] inline bool are_small(const Face& a, const Face& b) {
  return a.vertices.size() <= 4 && b.vertices.size() <= 4;
}

// Of small polygons that both look along the normal. False, with nothing found, where there is doubt.
[[nodiscard]] bool clip_small_polygons(const Face& a, const Face& b, const Projection& projection, ClipPoints& out);

}  // namespace abut
