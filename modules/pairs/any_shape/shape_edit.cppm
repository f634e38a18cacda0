// SPDX-License-Identifier: Apache-2.0
// Changes of shapes that are in use, in three steps: whether an edit is right, memory for it, and the change itself.
export module abut.pairs.any_shape.shape_edit;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;

export namespace abut {

// What is wrong with an edit of a shape; unsupported where shapes of its kind do not take it.
[[nodiscard]] Fault check_edit(const AnyShape& shape, const Edit& edit);

// Makes the shape and its data those of this holder alone, by a copy where there are other holders. Gets the memory
// that the edit takes. Nobody sees a change.
void own_shape(ShapeHandle& shape, const Edit& edit);

// After both: needs no memory. Answers with a box in the frame of the shape, outside of which nothing meets anything
// else.
Aabb apply_edit(ShapeHandle& shape, const Edit& edit);

// All vertices of a mesh at once, in the same three steps. The last one exchanges them with `next`, which are as many.
[[nodiscard]] Fault check_next_vertices(const AnyShape& shape, std::span<const Vec3> next);
void own_vertices(ShapeHandle& shape);
[[nodiscard]] Aabb exchange_vertices(ShapeHandle& shape, std::vector<Vec3>& next);

}  // namespace abut
