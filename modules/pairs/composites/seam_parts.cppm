// SPDX-License-Identifier: Apache-2.0
// What is asked of a part at a seam: a surface, a convex shape or a half-space that others lie beside. Points and
// directions are in its frame.
export module abut.pairs.composites.seam_parts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.shape_handle;

export namespace abut {

// By place in the registry.
[[nodiscard]] bool is_surface_kind(std::size_t kind);
[[nodiscard]] bool is_surface(const AnyShape& shape);
// Convex shapes and half-spaces, which are welded where somebody asks for it.
[[nodiscard]] bool is_weldable_kind(std::size_t kind);
[[nodiscard]] bool is_weldable(const AnyShape& shape);

// By place in the registry.
[[nodiscard]] inline bool is_part_at_seams(std::size_t kind, bool is_welded) {
  return is_surface_kind(kind) || (is_welded && is_weldable_kind(kind));
}

// A part that a body touches, and the contacts of both. Poses and contacts are in one frame.
struct Seam {
  ShapeHandle part;
  Pose pose;
  bool is_b;  // the part is side b of its contacts
  Manifold contacts;
  Real margin = 0;  // of the pair
  Manifold added = {};
};

// Half of the longest side of the box around a shape.
[[nodiscard]] Real half_size_of(const AnyShape& shape);

// How far a shape reaches along a direction. Of shapes that are neither convex nor half-spaces: no further than that.
[[nodiscard]] Real reach_along(const AnyShape& shape, const Vec3& direction);

// Whether a part goes on from a point that may be its own, and rises there over the plane across a normal. `size`: of
// the smaller one of what meets.
[[nodiscard]] bool goes_on_at(const AnyShape& part, const Vec3& point, const Vec3& normal, Real size);

// Whether a part holds a point, up to cracks.
[[nodiscard]] bool holds_at(const AnyShape& part, const Vec3& point, Real size);

// Whether a point is one of the surface of a part, up to rounding.
[[nodiscard]] bool lies_on(const AnyShape& part, const Vec3& point, Real size);

// Whether a normal is that of a triangle that holds a point.
[[nodiscard]] bool has_face_at(const AnyShape& surface, const Vec3& point, const Vec3& normal, Real size);

// Unit normals of flat faces out of a part: of triangles, the one that holds the point and leans least from a
// direction.
[[nodiscard]] std::vector<Vec3> faces_of(const AnyShape& part, const Vec3& point, const Vec3& direction, Real size);

// What lies behind a plane, as a shape; nothing in a build without such a kind.
[[nodiscard]] std::optional<AnyShape> half_space_under(const Vec3& normal, Real height);
// The face that looks along a direction; the whole shape where it has none.
[[nodiscard]] Feature face_along(const AnyShape& part, const Vec3& direction);

}  // namespace abut
