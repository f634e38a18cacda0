// SPDX-License-Identifier: Apache-2.0
// Samples of the signed distance from triangles, for a field in sparse blocks. Blocks near the surface get samples,
// each with its exact distance. Of other blocks only the corners are known, exactly as well.
//
// Inside is where the triangles wind around a point by more than one half, so that gaps and flipped triangles do little
// harm. Of closed surfaces the sign is handed on from sample to sample: where the balls of their distances overlap, no
// triangle lies between.
export module abut.trees.samples.field_sampling;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.samples.sparse_blocks;

export namespace abut {

struct [[gsl::Pointer]] SurfaceTriangles {
  std::span<const Vec3> vertices;
  std::span<const std::uint32_t> indices;  // three each, all below the number of vertices
};

struct FieldGrid {
  GridPlace samples;
  Vec3 origin;
  Real spacing;
};

// `band`: samples are held in all blocks with a point that is not further from the surface. `fringe`: how many samples
// beyond their cells blocks have on each side, 0 or 1; what would lie beyond the grid is zero. On as many threads as
// there may be.
[[nodiscard]] SparseBlocks sample_distances(const SurfaceTriangles& surface, const FieldGrid& grid, Real band,
                                            std::uint32_t fringe);

}  // namespace abut
