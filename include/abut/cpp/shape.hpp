// SPDX-License-Identifier: Apache-2.0
// Shapes: immutable values that copies share. docs/shapes.md describes every kind.
#ifndef ABUT_CPP_SHAPE_HPP
#define ABUT_CPP_SHAPE_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/options.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

// The kind of that name, such as "cone"; 0 if this build has none.
[[nodiscard]] inline ShapeKind shape_kind(const std::string& name) { return abut_shape_kind_by_name(name.c_str()); }

// All kinds of this build.
[[nodiscard]] inline std::vector<ShapeKind> shape_kinds() {
  std::vector<ShapeKind> kinds(abut_shape_kind_count());
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = abut_shape_kind_at(i);
  return kinds;
}

// Empty for a number that is no kind.
[[nodiscard]] inline std::string name_of(ShapeKind kind) {
  const char* name = abut_shape_kind_name(kind);
  return name == nullptr ? std::string() : std::string(name);
}

[[nodiscard]] inline std::vector<std::string> parameter_names(ShapeKind kind) {
  std::vector<std::string> names(abut_shape_kind_parameter_count(kind));
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = abut_shape_kind_parameter_name(kind, i);
  return names;
}

// Whether two kinds answer a query.
[[nodiscard]] inline Answer<bool> pair_support(ShapeKind a, ShapeKind b, Query query) {
  std::uint32_t out = 0;
  return detail::answer_bool(abut_pair_support(a, b, query, &out), out);
}

class Shape {
 public:
  // Holds no shape; calls that need one answer ABUT_NULL_ARGUMENT.
  Shape() noexcept = default;
  Shape(const Shape& other) noexcept : shape_(other.shape_) { abut_shape_retain(shape_); }
  Shape(Shape&& other) noexcept : shape_(std::exchange(other.shape_, nullptr)) {}
  Shape& operator=(Shape other) noexcept {
    std::swap(shape_, other.shape_);
    return *this;
  }
  ~Shape() { abut_shape_release(shape_); }

  // Takes over a reference that the caller holds.
  [[nodiscard]] static Shape adopt(abut_shape* shape) noexcept { return Shape(shape); }
  // Takes a reference of its own.
  [[nodiscard]] static Shape share(abut_shape* shape) noexcept {
    abut_shape_retain(shape);
    return Shape(shape);
  }

  [[nodiscard]] static Answer<Shape> sphere(double radius) {
    return made([&](abut_shape** out) { return abut_sphere_create(radius, out); });
  }
  [[nodiscard]] static Answer<Shape> box(double half_x, double half_y, double half_z) {
    return made([&](abut_shape** out) { return abut_box_create(half_x, half_y, half_z, out); });
  }
  // Capsules, cylinders, cones and segments lie along local Z.
  [[nodiscard]] static Answer<Shape> capsule(double radius, double half_height) {
    return made([&](abut_shape** out) { return abut_capsule_create(radius, half_height, out); });
  }
  [[nodiscard]] static Answer<Shape> cylinder(double radius, double half_height) {
    return made([&](abut_shape** out) { return abut_cylinder_create(radius, half_height, out); });
  }
  [[nodiscard]] static Answer<Shape> cone(double radius, double half_height) {
    return made([&](abut_shape** out) { return abut_cone_create(radius, half_height, out); });
  }
  [[nodiscard]] static Answer<Shape> ellipsoid(double radius_x, double radius_y, double radius_z) {
    return made([&](abut_shape** out) { return abut_ellipsoid_create(radius_x, radius_y, radius_z, out); });
  }
  [[nodiscard]] static Answer<Shape> point() { return made(abut_point_create); }
  [[nodiscard]] static Answer<Shape> segment(double half_length) {
    return made([&](abut_shape** out) { return abut_segment_create(half_length, out); });
  }
  [[nodiscard]] static Answer<Shape> triangle(Vec3 a, Vec3 b, Vec3 c) {
    return made([&](abut_shape** out) { return abut_triangle_create(&a, &b, &c, out); });
  }
  // The half-space below: dot(normal, p) <= offset.
  [[nodiscard]] static Answer<Shape> plane(Vec3 normal, double offset) {
    return made([&](abut_shape** out) { return abut_plane_create(&normal, offset, out); });
  }
  [[nodiscard]] static Answer<Shape> hull(const Points& points) {
    const abut_status whole = detail::expect_whole("points", points);
    return made([&](abut_shape** out) {
      return whole != ABUT_OK ? whole : abut_hull_create(points.data(), points.size(), out);
    });
  }
  // Options say how many corners a face has. Faces of four are given as plain numbers.
  [[nodiscard]] static Answer<Shape> mesh(const Points& vertices, const Triangles& triangles,
                                          OptionalRef<abut_mesh_options> options = {}) {
    const std::size_t width = corners_of(options);
    const abut_status whole = expect_whole_faces(vertices, triangles, width);
    return made([&](abut_shape** out) {
      return whole != ABUT_OK ? whole
                              : abut_mesh_create(vertices.data(), vertices.size(), triangles.data(),
                                                 triangles.number_count() / width, options.get(), out);
    });
  }
  // What is unusual about such a mesh, before it is made.
  [[nodiscard]] static Answer<MeshReport> describe_mesh(const Points& vertices, const Triangles& triangles,
                                                        OptionalRef<abut_mesh_options> options = {}) {
    MeshReport out;
    const std::size_t width = corners_of(options);
    const abut_status whole = expect_whole_faces(vertices, triangles, width);
    return detail::answer(whole != ABUT_OK
                              ? whole
                              : abut_mesh_describe(vertices.data(), vertices.size(), triangles.data(),
                                                   triangles.number_count() / width, options.get(), &out),
                          out);
  }
  // A mesh whose tree is made by a grid of cells.
  [[nodiscard]] static Answer<Shape> uv_grid(const Points& vertices, const Triangles& triangles,
                                             OptionalRef<abut_uv_grid_options> options = {}) {
    const std::size_t width = corners_of(options);
    const abut_status whole = expect_whole_faces(vertices, triangles, width);
    return made([&](abut_shape** out) {
      return whole != ABUT_OK ? whole
                              : abut_uv_grid_create(vertices.data(), vertices.size(), triangles.data(),
                                                    triangles.number_count() / width, options.get(), out);
    });
  }
  // `heights` holds columns * rows numbers or NaN, X fastest.
  [[nodiscard]] static Answer<Shape> height_field(std::uint32_t columns, std::uint32_t rows, double spacing_x,
                                                  double spacing_y, Span<const double> heights,
                                                  Diagonal diagonal = ABUT_DIAGONAL_RISING,
                                                  abut_below below = ABUT_BELOW_OPEN) {
    abut_height_field_desc desc;
    abut_height_field_desc_init(&desc, sizeof desc);
    desc.columns = columns;
    desc.rows = rows;
    desc.spacing_x = spacing_x;
    desc.spacing_y = spacing_y;
    desc.heights = heights.data();
    desc.diagonal = diagonal;
    desc.below = below;
    const abut_status sizes = expect_samples(heights.size(), std::uint64_t{columns} * rows);
    return made([&](abut_shape** out) { return sizes != ABUT_OK ? sizes : abut_height_field_create(&desc, out); });
  }
  // A solid from its signed distance on a grid. `values` holds columns * rows * layers numbers, X fastest, then Y.
  // Inside out it is a container.
  [[nodiscard]] static Answer<Shape> distance_field(std::uint32_t columns, std::uint32_t rows, std::uint32_t layers,
                                                    const Vec3& spacing, const Vec3& origin, Span<const double> values,
                                                    bool is_inside_out = false,
                                                    Interpolation interpolation = ABUT_INTERPOLATION_LINEAR) {
    abut_distance_field_desc desc;
    abut_distance_field_desc_init(&desc, sizeof desc);
    desc.columns = columns;
    desc.rows = rows;
    desc.layers = layers;
    desc.spacing = spacing;
    desc.origin = origin;
    desc.values = values.data();
    desc.is_inside_out = is_inside_out ? 1 : 0;
    desc.interpolation = interpolation;
    const abut_status sizes = detail::expect_as_many("values", values.size(), "columns * rows * layers",
                                                     detail::product_of(columns, rows, layers));
    return made([&](abut_shape** out) { return sizes != ABUT_OK ? sizes : abut_distance_field_create(&desc, out); });
  }
  // The solid within a mesh; see abut_distance_field_options for spacing and band.
  [[nodiscard]] static Answer<Shape> distance_field_from_mesh(const Points& vertices, const Triangles& triangles,
                                                              double spacing = 0, double band = 3,
                                                              bool is_inside_out = false,
                                                              Interpolation interpolation = ABUT_INTERPOLATION_LINEAR) {
    abut_distance_field_options options;
    abut_distance_field_options_init(&options, sizeof options);
    options.spacing = spacing;
    options.band = band;
    options.is_inside_out = is_inside_out ? 1 : 0;
    options.interpolation = interpolation;
    const abut_status whole = detail::first_failure(detail::expect_whole("vertices", vertices),
                                                    detail::expect_whole("triangles", triangles));
    return made([&](abut_shape** out) {
      return whole != ABUT_OK ? whole
                              : abut_distance_field_from_mesh(vertices.data(), vertices.size(), triangles.data(),
                                                              triangles.size(), &options, out);
    });
  }
  [[nodiscard]] static Answer<Shape> particles(const Points& centres, double radius) {
    const abut_status whole = detail::expect_whole("centres", centres);
    return made([&](abut_shape** out) {
      return whole != ABUT_OK ? whole : abut_particles_create(centres.data(), centres.size(), radius, out);
    });
  }
  // Balls with radii of their own, as many as centres.
  [[nodiscard]] static Answer<Shape> particles_with_radii(const Points& centres, Span<const double> radii) {
    const abut_status sizes =
        detail::first_failure(detail::expect_whole("centres", centres),
                              detail::expect_as_many("radii", radii.size(), "centres", centres.size()));
    return made([&](abut_shape** out) {
      return sizes != ABUT_OK
                 ? sizes
                 : abut_particles_create_with_radii(centres.data(), radii.data(), centres.size(), out);
    });
  }
  // Holes take material from the composite that they are children of. An open end or face has no wall.
  [[nodiscard]] static Answer<Shape> sphere_hole(double radius) {
    return made([&](abut_shape** out) { return abut_sphere_hole_create(radius, out); });
  }
  [[nodiscard]] static Answer<Shape> cylinder_hole(double radius, double half_height, abut_open_ends open_ends = 0) {
    return made([&](abut_shape** out) { return abut_cylinder_hole_create(radius, half_height, open_ends, out); });
  }
  [[nodiscard]] static Answer<Shape> box_hole(double half_x, double half_y, double half_z,
                                              abut_open_faces open_faces = 0) {
    return made([&](abut_shape** out) { return abut_box_hole_create(half_x, half_y, half_z, open_faces, out); });
  }
  // Each child has a pose; materials are as many as children, or none.
  [[nodiscard]] static Answer<Shape> composite(Span<const Shape> children, Span<const Pose> poses,
                                               Span<const std::uint32_t> materials = {}) {
    const std::vector<const abut_shape*> pointers = pointers_of(children);
    const abut_status sizes = detail::first_failure(
        detail::expect_as_many("poses", poses.size(), "children", children.size()),
        detail::expect_as_many("materials", materials.empty() ? children.size() : materials.size(), "children",
                               children.size()));
    return made([&](abut_shape** out) {
      if (sizes != ABUT_OK) return sizes;
      return materials.empty() ? abut_composite_create(pointers.data(), poses.data(), pointers.size(), out)
                               : abut_composite_create_with_materials(pointers.data(), poses.data(), materials.data(),
                                                                      pointers.size(), out);
    });
  }
  // Any kind, from its parameters and buffers.
  [[nodiscard]] static Answer<Shape> create(ShapeKind kind, Span<const double> parameters,
                                            Span<const double> reals = {}, Span<const std::uint32_t> indices = {}) {
    abut_shape_desc desc;
    abut_shape_desc_init(&desc, sizeof desc);
    desc.kind = kind;
    desc.parameters = parameters.data();
    desc.parameter_count = parameters.size();
    desc.reals = reals.data();
    desc.real_count = reals.size();
    desc.indices = indices.data();
    desc.index_count = indices.size();
    return made([&](abut_shape** out) { return abut_shape_create(&desc, out); });
  }
  [[nodiscard]] static Answer<Shape> create(const std::string& kind, Span<const double> parameters,
                                            Span<const double> reals = {}, Span<const std::uint32_t> indices = {}) {
    const ShapeKind number = shape_kind(kind);
    if (number != 0) return create(number, parameters, reals, indices);
    const std::string message = "kind is \"" + kind + "\"; this build of abut has no shape of that name";
    return made([&](abut_shape**) { return abut_set_last_error(ABUT_UNKNOWN_VALUE, message.c_str()); });
  }

  [[nodiscard]] abut_shape* get() const noexcept { return shape_; }
  // Gives the reference to the caller.
  [[nodiscard]] abut_shape* release() noexcept { return std::exchange(shape_, nullptr); }
  explicit operator bool() const noexcept { return shape_ != nullptr; }
  // Whether both are the same object, not whether they are equal solids.
  friend bool operator==(const Shape& a, const Shape& b) noexcept { return a.shape_ == b.shape_; }
  friend bool operator!=(const Shape& a, const Shape& b) noexcept { return a.shape_ != b.shape_; }

  [[nodiscard]] ShapeKind kind() const noexcept { return abut_shape_kind_of(shape_); }
  [[nodiscard]] Answer<std::vector<double>> parameters() const {
    return detail::collect<double>([this](double* data, std::size_t capacity, std::size_t* count) {
      return abut_shape_parameters(shape_, data, capacity, count);
    });
  }
  [[nodiscard]] Answer<Aabb> aabb(const Pose& pose) const {
    Aabb out{};
    return detail::answer(abut_shape_aabb(shape_, &pose, &out), out);
  }
  // Makes what queries would make when they first need it, such as the tree of a mesh. 0: on as many threads as may be.
  Answer<void> prepare(std::uint32_t threads = 0) const {
    return detail::answer(abut_shape_prepare(shape_, threads));
  }
  // The surface of a mesh, height field, hull, box or distance field.
  [[nodiscard]] Answer<TriangleMesh> triangles() const {
    TriangleMesh mesh;
    std::size_t vertices = 0, faces = 0;
    abut_status status = abut_shape_triangles(shape_, nullptr, 0, &vertices, nullptr, 0, &faces);
    if (status == ABUT_OK && vertices > 0 && faces > 0) {
      mesh.vertices.resize(vertices);
      mesh.triangles.resize(faces);
      status = abut_shape_triangles(shape_, &mesh.vertices.data()->x, vertices, &vertices,
                                    mesh.triangles.data()->data(), faces, &faces);
    }
    return detail::answer(status, mesh);
  }
  // Of a composite, by their numbers; child_shape gives the shape of each.
  [[nodiscard]] Answer<std::vector<CompositeChild>> children() const {
    return detail::collect<CompositeChild>([this](CompositeChild* data, std::size_t capacity, std::size_t* count) {
      return abut_composite_children(shape_, data, capacity, count);
    });
  }
  [[nodiscard]] Answer<Shape> child_shape(std::uint32_t child) const {
    return made([&](abut_shape** out) { return abut_composite_child_shape(shape_, child, out); });
  }
  [[nodiscard]] Answer<std::optional<RayHit>> cast_ray(const Pose& pose, const Ray& ray) const {
    RayHit hit{};
    std::uint32_t found = 0;
    return detail::answer_if_found(abut_shape_cast_ray(shape_, &pose, &ray, &hit, &found), found, hit);
  }
  // What a hull has left of its points.
  // How far values of a distance field may be off, and how much of it holds samples.
  [[nodiscard]] Answer<DistanceFieldReport> describe_distance_field() const {
    DistanceFieldReport out;
    return detail::answer(abut_distance_field_describe(shape_, &out), out);
  }
  [[nodiscard]] Answer<HullReport> describe_hull() const {
    HullReport out;
    return detail::answer(abut_hull_describe(shape_, &out), out);
  }

  // As the C interface takes them.
  [[nodiscard]] static std::vector<const abut_shape*> pointers_of(Span<const Shape> shapes) {
    std::vector<const abut_shape*> pointers;
    pointers.reserve(shapes.size());
    for (const Shape& shape : shapes) pointers.push_back(shape.get());
    return pointers;
  }

 private:
  explicit Shape(abut_shape* shape) noexcept : shape_(shape) {}

  template <class Make>
  static Answer<Shape> made(Make&& make) {
    abut_shape* out = nullptr;
    const abut_status status = make(&out);
    return detail::answer_with(status, [&] { return adopt(out); });
  }

  // Others than these are refused before a face is read.
  template <class Options>
  static std::size_t corners_of(const OptionalRef<Options>& options) {
    return options.get() != nullptr && options.get()->corners == 4 ? 4 : 3;
  }
  static abut_status expect_whole_faces(const Points& vertices, const Triangles& triangles, std::size_t width) {
    return detail::first_failure(detail::expect_whole("vertices", vertices),
                                 detail::expect_whole("triangles", triangles, width));
  }

  static abut_status expect_samples(std::uint64_t given, std::uint64_t expected) {
    if (given == expected) return ABUT_OK;
    const std::string message = "heights has " + std::to_string(given) + " numbers; it must have " +
                                std::to_string(expected) + ", columns * rows";
    return abut_set_last_error(ABUT_INVALID_ARGUMENT, message.c_str());
  }

  abut_shape* shape_ = nullptr;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
