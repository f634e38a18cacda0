// SPDX-License-Identifier: Apache-2.0
// A shape of any kind of this build, and what can be asked of one and of two.
export module abut.pairs.any_shape;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.capability;
export import abut.pairs.shape_handle;

export namespace abut {

// Place of a kind or form in the registry; nothing for a number that is no kind of this build.
[[nodiscard]] std::optional<std::size_t> find_kind(std::uint32_t kind);
[[nodiscard]] std::optional<std::size_t> find_kind(std::string_view name);
// Of a shape: that of its form, where it has one. In pairs it is of its class.
[[nodiscard]] std::size_t kind_of(const AnyShape& shape);
[[nodiscard]] std::size_t kind_in_pairs(std::size_t place);
[[nodiscard]] std::size_t kind_in_pairs(const AnyShape& shape);
// Its number in the C interface.
[[nodiscard]] std::uint32_t kind_number(std::size_t place);
[[nodiscard]] std::string_view kind_name(std::size_t place);
[[nodiscard]] std::size_t kind_parameter_count(std::size_t place);
[[nodiscard]] std::string_view kind_parameter_name(std::size_t place, std::size_t index);

// A shape of the kind at a place from checked numbers.
[[nodiscard]] Result<ShapeHandle> make_shape(std::size_t place, std::span<const Real> parameters,
                                             std::span<const Real> reals, std::span<const std::uint32_t> indices);
// Any shape, for a place that is vacant.
[[nodiscard]] ShapeHandle sample_shape();

// Shapes, each at a pose of its own, as one; an error in a build without such a kind.
struct PlacedShape {
  ShapeHandle shape;
  Pose pose;
  std::uint32_t material = 0;  // 0: that of the geometry
};
[[nodiscard]] Result<ShapeHandle> make_composite(std::span<const PlacedShape> children);

[[nodiscard]] Aabb aabb_of(const AnyShape& shape, const Pose& pose);
[[nodiscard]] std::vector<Real> parameters_of(const AnyShape& shape);
[[nodiscard]] std::optional<RayHit> cast_ray(const AnyShape& shape, const Vec3& origin, const UnitVec3& direction,
                                             Real max_distance);
// Of the children of a composite, by their numbers; none where no child has one of its own.
[[nodiscard]] std::span<const std::uint32_t> materials_of_children(const AnyShape& shape [[clang::lifetimebound]]);
// Whether holes take something away from it.
[[nodiscard]] bool has_holes(const AnyShape& shape);
// Whether a shape holds a point of its own frame, or comes within `reach` of it.
[[nodiscard]] bool holds(const AnyShape& shape, const Vec3& point, Real reach);
// Nothing for shapes without a surface of plane triangles.
[[nodiscard]] std::optional<Triangles> triangles_of(const AnyShape& shape);
// Of the kind at a place.
[[nodiscard]] bool has_triangles(std::size_t place);
// The same without a copy, of shapes that hold their triangles; empty for others.
struct [[gsl::Pointer]] HeldTriangles {
  std::span<const Vec3> vertices{};
  std::span<const std::uint32_t> indices{};  // three per triangle
};
[[nodiscard]] HeldTriangles held_triangles(const AnyShape& shape [[clang::lifetimebound]]);

// Makes what queries of a shape, or of the children of a composite, make when they first need it.
void prepare(const AnyShape& shape, const Workers& workers);

// What making a shape of points left of them, and how far a given point is from the shape at most. Nothing for kinds
// that keep what they are given.
struct BuildReport {
  std::uint32_t dimension;
  std::size_t point_count, vertex_count, edge_count, face_count;
  Real error;
};
[[nodiscard]] std::optional<BuildReport> build_report_of(const AnyShape& shape);

// Why the pair of kinds at two places is answered the way it is, in words.
struct [[gsl::Pointer]] RouteDescription {
  std::string_view algorithm;
  std::string_view reason;
};
[[nodiscard]] RouteDescription describe_route(std::size_t place_a, std::size_t place_b);
// Whether the kind at a place has contacts with itself, and how.
[[nodiscard]] bool meets_itself(std::size_t place);
[[nodiscard]] RouteDescription describe_self(std::size_t place);
[[nodiscard]] bool is_supported(std::size_t place_a, std::size_t place_b);

// Whether work starts from b: by kind, else by pose, else by form. A first coordinate that differs by rounding, as of
// shapes that stand on each other, tells nothing.
[[nodiscard]] bool starts_from_b(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b);

// Queries on two placed shapes. Results are in the world, and written when the outcome is ok. The order of work depends
// on the shapes and poses alone, so that swapping them changes no bit but the sides.
[[nodiscard]] Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, Distance& out);
[[nodiscard]] Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, Manifold& out);

// The same, b being placed by ab in the frame of a. Results are in the frame of a.
[[nodiscard]] inline Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& ab,
                                           const QuerySettings& settings, Distance& out) {
  return pair_distance(a, b, Pose::identity(), ab, settings, out);
}
[[nodiscard]] inline Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& ab,
                                           const QuerySettings& settings, Manifold& out) {
  return pair_contacts(a, b, Pose::identity(), ab, settings, out);
}

}  // namespace abut
