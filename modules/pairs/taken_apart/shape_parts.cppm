// SPDX-License-Identifier: Apache-2.0
// A shape as what it is made of: children, triangles, balls, or itself as one convex part.
export module abut.pairs.taken_apart.shape_parts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.shape_handle;
export import abut.pairs.taken_apart.convex_part;

export namespace abut {

// What the class of a shape is.
struct ShapeTraits {
  bool is_half_space, is_assembly, has_only_distances, has_parts, is_surface;
};
[[nodiscard]] const ShapeTraits& traits_of(const AnyShape& shape);

// Called with a part, its place in the shape, and its number where it is a child of its own.
using VisitPart = std::function<void(const ConvexPart& part, const Pose& place, std::uint32_t child)>;

// Visits the convex parts near a box in the frame of the shape. Parts live as long as their visit.
void visit_parts(const AnyShape& shape, const Aabb& near, const VisitPart& visit);

// Called with a child of a composite, its pose in the composite, and its number.
using VisitChild = std::function<void(const AnyShape& shape, const Pose& pose, std::uint32_t child)>;

// Visits the children of a composite near a box in its frame.
void visit_children(const AnyShape& shape, const Aabb& near, const VisitChild& visit);

}  // namespace abut
