// SPDX-License-Identifier: Apache-2.0
// A shape of any kind of this build, and what can be asked of one and of two.
export module abut.pairs.any_shape;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.apart.pair_hint;
export import abut.narrow.warm.pair_memory;
import abut.capability;
import abut.pairs.registry;

export namespace abut {

using ShapeHandle = Frozen<AnyShape>;

// The kinds that pairs tell apart, each with a class of its own. Behind them come forms (see Form).
inline constexpr std::size_t shape_kind_count = Shapes::count, named_kind_count = Shapes::kinds.size();

// Place of a kind or form in the registry; nothing for a number that is no kind of this build.
[[nodiscard]] std::optional<std::size_t> find_kind(std::uint32_t kind);
[[nodiscard]] std::optional<std::size_t> find_kind(std::string_view name);
// Of a shape: that of its form, where it has one. Its index is the place of its class.
[[nodiscard]] std::size_t kind_of(const AnyShape& shape);
[[nodiscard]] std::size_t kind_in_pairs(std::size_t place);
[[nodiscard]] std::string_view kind_name(std::size_t place);
[[nodiscard]] std::size_t kind_parameter_count(std::size_t place);
[[nodiscard]] std::string_view kind_parameter_name(std::size_t place, std::size_t index);

// A shape of the kind at a place from checked numbers.
[[nodiscard]] Result<AnyShape> make_shape(std::size_t place, std::span<const Real> parameters,
                                          std::span<const Real> reals, std::span<const std::uint32_t> indices);

// Shapes, each at a pose of its own, as one; an error in a build without such a kind.
struct PlacedShape {
  ShapeHandle shape;
  Pose pose;
  std::uint32_t material = 0;  // 0: that of the geometry
};
[[nodiscard]] Result<AnyShape> make_composite(std::span<const PlacedShape> children);

[[nodiscard]] Aabb aabb_of(const AnyShape& shape, const Pose& pose);
[[nodiscard]] std::vector<Real> parameters_of(const AnyShape& shape);
[[nodiscard]] std::optional<RayHit> cast_ray(const AnyShape& shape, const Vec3& origin, const UnitVec3& direction,
                                             Real max_distance);
// Of the children of a composite, by their numbers; none where no child has one of its own.
[[nodiscard]] std::span<const std::uint32_t> materials_of_children(const AnyShape& shape [[clang::lifetimebound]]);
// Nothing for shapes without a surface of plane triangles.
[[nodiscard]] std::optional<Triangles> triangles_of(const AnyShape& shape);
// The same without a copy, of shapes that hold their triangles; empty for others.
struct HeldTriangles {
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
struct RouteDescription {
  std::string_view algorithm;
  std::string_view reason;
};
[[nodiscard]] RouteDescription describe_route(std::size_t place_a, std::size_t place_b);
// Whether the kind at a place has contacts with itself, and how.
[[nodiscard]] bool meets_itself(std::size_t place);
[[nodiscard]] RouteDescription describe_self(std::size_t place);
[[nodiscard]] bool is_supported(std::size_t place_a, std::size_t place_b);

// The order of two shapes of one kind whose first coordinates do not tell it: by the rest of their poses, else by their
// form. Shapes alike in all of these are the same one, and no order can be told from the other.
[[nodiscard]] [[gnu::cold]] bool comes_after(const AnyShape& a, const AnyShape& b, const Pose& pose_a,
                                             const Pose& pose_b);

// Whether work starts from b: by kind, else by pose, else by form. A first coordinate that differs by rounding, as of
// shapes that stand on each other, tells nothing.
[[nodiscard]] [[gnu::always_inline]] inline bool starts_from_b(const AnyShape& a, const AnyShape& b, const Pose& pose_a,
                                                               const Pose& pose_b) {
  if (a.index() != b.index()) {
    return b.index() < a.index();
  }
  const Vec3 apart = pose_b.position - pose_a.position;
  if (std::fabs(apart.x) > tie_share * (std::fabs(apart.y) + std::fabs(apart.z))) [[likely]] {
    return apart.x < 0;
  }
  return comes_after(a, b, pose_a, pose_b);
}

// Queries on two placed shapes. Results are in the world, and written when the outcome is ok. The order of work depends
// on the shapes and poses alone, so that swapping them changes no bit but the sides.
[[nodiscard]] inline Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                           const QuerySettings& settings, Distance& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  return pair_kernels(first.index(), second.index())
      .distance(first, second, from_b ? pose_b : pose_a, from_b ? pose_a : pose_b, from_b, settings, out);
}
[[nodiscard]] inline Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                           const QuerySettings& settings, Manifold& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  return pair_kernels(first.index(), second.index())
      .contacts(first, second, from_b ? pose_b : pose_a, from_b ? pose_a : pose_b, from_b, settings, out);
}
// With what earlier calls for the same two shapes in this order have left in `memory`, which begins all zero: the
// answer is the same bit by bit, sooner where the bodies have moved little.
[[nodiscard]] Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, PairMemory& memory, Manifold& out);

// With what the last query for the same two shapes has left in `hint`, and leaving there what this one found. Any hint
// gives the answer of the queries above, within its bound.
[[nodiscard]] Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, PairHint& hint, Distance& out);
[[nodiscard]] Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, PairHint& hint, Manifold& out);

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
