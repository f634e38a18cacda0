// SPDX-License-Identifier: Apache-2.0
// Reduces a manifold to the few points that hold a body as well as all of them.
export module abut.narrow.manifold.reduce;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// Depths that differ by less than this share of the extent of a patch are the same from step to step.
inline constexpr Real tied_depth = 1e-5;
// The deepest point of a rim that rests on its face runs around it from step to step. It is none of the points that
// hold the patch where others are less deep by no more than this share of the extent: the corners of its polygon are,
// up to the lean at which it rests.
inline constexpr Real running_depth = 1e-4;
// Points that were kept before stay while they span this share of the area that others could.
inline constexpr Real tied_area = 0.95;

// Which sides of a pair are surfaces, so that what they touch may fall apart into regions. A contact of two convex
// shapes has one.
struct SurfaceSides {
  bool a = false, b = false;
};

// Reorders contacts so that the ones to keep come first, deepest first, and returns how many. Points whose normals
// agree (cosine at least 0.98), of one region of a surface, form a patch; each patch keeps at most `most` points: the
// deepest one, and those that span the largest area with it. 0 keeps all and only sorts. The answer depends on nothing
// but the contacts, and no contact is deeper than the first one.
[[nodiscard]] std::size_t reduce(std::span<ContactPoint> contacts, std::size_t most, SurfaceSides surfaces = {});

// The same from step to step. `before` holds the ids of the points that the last reduction of this pair kept. They win
// ties of depth and of area, so that a body that hardly moves stands on the same points. The deepest contact of a patch
// is always kept: it is one more where it is none of them, unless `most` is 1.
[[nodiscard]] std::size_t reduce(std::span<ContactPoint> contacts, std::size_t most,
                                 std::span<const std::uint64_t> before, SurfaceSides surfaces = {});

}  // namespace abut
