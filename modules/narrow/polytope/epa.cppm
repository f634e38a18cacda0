// SPDX-License-Identifier: Apache-2.0
// Depth and direction of least overlap of two convex cores by the expanding polytope algorithm (van den Bergen,
// "Proximity queries and penetration depth computation on 3D game objects", 2001). An incremental convex hull grows:
// its least face is pushed out until it lies on the boundary.
//
// The polytope lies inside the Minkowski difference, so its least face distance bounds the depth from below. The
// support in any direction bounds it from above. Both bounds are reported.
//
// A polytope alone comes nearer to a round surface by a constant factor per vertex. It proves nothing where many
// directions are as good. There Newton's method finds a least depth d among nearby directions. It comes with a cap of
// directions in which nothing is less. A direction v outside all caps with a depth below d has d v beyond a face of the
// polytope:
//   angle between v and the normal of the face <= acos(distance of the face / d).
// A face all of whose such directions lie in a cap needs no vertex. When no face is left, d is the depth.
export module abut.narrow.polytope.epa;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;

export namespace abut {

struct EpaResult {
  Real depth;         // not negative for cores that overlap
  Real lower, upper;  // the depth lies between them
  Vec3 normal;        // unit: moving b along it by the depth parts the cores
  Vec3 point_a, point_b;
  std::uint32_t iterations;
};

[[nodiscard]] EpaResult epa(const Difference& cores, Real error, const Simplex& start);

// The depth and the normal alone. Nothing where the depth is surely no less than `most`, which mostly shows sooner.
struct LeastOverlap {
  Real depth;
  Vec3 normal;
};
[[nodiscard]] std::optional<LeastOverlap> least_overlap_below(Real most, const Difference& cores, Real error);

}  // namespace abut
