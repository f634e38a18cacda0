// SPDX-License-Identifier: Apache-2.0
// Whether two convex cores are within a reach of each other. The first axis that parts them by more ends the search,
// and so does the first point of both that is as near. Gaps of the size of rounding are none.
export module abut.narrow.overlap.convex_overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.overlap.convex_side;

export namespace abut {

// What counts as an overlap of a surface with fronts: a triangle from either side, or as contacts have it only what
// reaches before it.
enum class Fronts : std::uint8_t { ignored, respected };

// Only fronts leave an answer to contacts: of a shape that reaches through one from behind, or around its border.
enum class Met : std::uint8_t { no, yes, left_to_contacts };

// b is placed by ab in the frame of a. `reach`: not negative.
[[nodiscard]] bool are_cores_within(const ConvexSide& a, const ConvexSide& b, const Pose& ab, Real reach);
// The same of cores that closed forms know, where these tell.
[[nodiscard]] std::optional<bool> are_forms_within(const FormOfCore& a, const FormOfCore& b, const Pose& ab,
                                                   Real reach);
// A core and a triangle in its frame.
[[nodiscard]] bool is_core_within(const ConvexSide& core, const TriangleCorners& triangle, Real reach);
// Two triangles of one frame.
[[nodiscard]] bool are_triangles_within(const TriangleCorners& a, const TriangleCorners& b, Real reach);

}  // namespace abut
