// SPDX-License-Identifier: Apache-2.0
// The region in which two supporting faces meet: both are projected along the contact normal, the
// projections are intersected, and each corner is lifted back onto both faces. The construction is the
// same for both sides, so swapping them gives the same points.
export module abut.narrow.points.clip;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// A corner of the common region: a point on each face and what it is on each side.
struct ClipPoint {
  Vec3 point_a, point_b;
  Feature feature_a, feature_b;
};
using ClipPoints = SmallVector<ClipPoint, 24>;

// Segments closer to parallel than this share a stretch, not a crossing.
inline constexpr Real parallel_sine = 1e-3;

// Both faces in one frame, `normal` of length one from a to b. At least one point on each side; a vertex
// shares no region with anything.
// A face that stands so steep to the normal that lifting onto it has no meaning takes part with its
// outer edge. Closest points that the corners miss come out as well. Nothing comes out when the
// projections miss each other. `wants_closest`: unless the closest points are known to lie beside a face.
void clip_faces(const Face& a, const Face& b, const Vec3& normal, ClipPoints& out, bool wants_closest = true);

}  // namespace abut
