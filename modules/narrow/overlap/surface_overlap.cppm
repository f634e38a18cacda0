// SPDX-License-Identifier: Apache-2.0
// Whether a surface overlaps another shape: the first triangle that does ends the search.
export module abut.narrow.overlap.surface_overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.overlap.convex_side;
import abut.narrow.overlap.surface_side;

export namespace abut {

// What counts as an overlap of a surface with fronts: a triangle from either side, or as contacts have it only what
// reaches before it.
enum class Fronts : std::uint8_t { ignored, respected };

// Only fronts leave an answer to contacts: of a shape that reaches through one from behind, or around its border.
enum class Met : std::uint8_t { no, yes, left_to_contacts };

// Whether a triangle of a surface is within `reach` of a convex core, or the core is inside. The core is placed by ab
// in the frame of the surface. `reach`: not negative.
[[nodiscard]] Met meets(const SurfaceSide& surface, ConvexSide& core, const Pose& ab, Real reach, Fronts fronts);

// The same of two surfaces.
[[nodiscard]] Met meets(const SurfaceSide& a, const SurfaceSide& b, const Pose& ab, Real reach, Fronts fronts);

}  // namespace abut
