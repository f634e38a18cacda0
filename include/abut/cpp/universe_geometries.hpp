// SPDX-License-Identifier: Apache-2.0
// Geometries of a universe: shapes on parts, and how they change.
#ifndef ABUT_CPP_UNIVERSE_GEOMETRIES_HPP
#define ABUT_CPP_UNIVERSE_GEOMETRIES_HPP

#include <abut/abut.h>
#include <abut/cpp/shape.hpp>
#include <abut/cpp/universe_parts.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut {
inline namespace ABUT_ANSWERS {

class UniverseGeometries : public UniverseParts {
 public:
  using UniverseParts::destroy;
  using UniverseParts::poses;
  using UniverseParts::set_user_data;

  Answer<GeometryId> create_geometry(PartId part, const Shape& shape, OptionalRef<abut_geometry_options> options = {}) {
    GeometryId out{};
    return detail::answer(abut_geometry_create(get(), part, shape.get(), options.get(), &out), out);
  }
  // One shape for each part; options are as many, or none.
  Answer<std::vector<GeometryId>> create_geometries(Span<const PartId> parts, Span<const Shape> shapes,
                                                    Span<const abut_geometry_options> options = {}) {
    const std::vector<const abut_shape*> pointers = Shape::pointers_of(shapes);
    std::vector<GeometryId> out(parts.size());
    const abut_status sizes = detail::first_failure(
        detail::expect_as_many("shapes", shapes.size(), "parts", parts.size()),
        detail::expect_as_many("options", options.empty() ? parts.size() : options.size(), "parts", parts.size()));
    return detail::answer(
        sizes != ABUT_OK ? sizes
                         : abut_geometries_create(get(), parts.data(), pointers.data(),
                                                  options.empty() ? nullptr : options.data(), parts.size(), out.data()),
        out);
  }

  Answer<void> destroy(GeometryId geometry) { return detail::answer(abut_geometry_destroy(get(), geometry)); }
  Answer<void> destroy(Span<const GeometryId> geometries) {
    return detail::answer(abut_geometries_destroy(get(), geometries.data(), geometries.size()));
  }

  // All of them are replaced; begin with options_of() to change one.
  Answer<void> set_options(GeometryId geometry, const GeometryOptions& options) {
    return detail::answer(abut_geometry_set_options(get(), geometry, &options));
  }
  Answer<void> set_options(Span<const GeometryId> geometries, Span<const abut_geometry_options> options) {
    const abut_status sizes = detail::expect_as_many("options", options.size(), "geometries", geometries.size());
    return detail::answer(
        sizes != ABUT_OK ? sizes
                         : abut_geometries_set_options(get(), geometries.data(), options.data(), geometries.size()));
  }
  [[nodiscard]] Answer<GeometryOptions> options_of(GeometryId geometry) const {
    GeometryInfo info;
    const abut_status status = abut_geometry_describe(get(), geometry, &info);
    return detail::answer_with(status, [&] { return options_from(info); });
  }
  // The shape in it is borrowed until the geometry is destroyed or changes its shape.
  [[nodiscard]] Answer<GeometryInfo> describe(GeometryId geometry) const {
    GeometryInfo out;
    return detail::answer(abut_geometry_describe(get(), geometry, &out), out);
  }

  Answer<void> set_user_data(GeometryId geometry, std::uint64_t user_data) {
    return detail::answer(abut_geometry_set_user_data(get(), geometry, user_data));
  }
  Answer<void> set_user_data(Span<const GeometryId> geometries, Span<const std::uint64_t> user_data) {
    const abut_status sizes =
        detail::expect_as_many("user_data", user_data.size(), "geometries", geometries.size());
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_geometries_set_user_data(get(), geometries.data(), user_data.data(),
                                                                           geometries.size()));
  }

  Answer<void> set_shape(GeometryId geometry, const Shape& shape) {
    return detail::answer(abut_geometry_set_shape(get(), geometry, shape.get()));
  }
  Answer<void> set_shapes(Span<const GeometryId> geometries, Span<const Shape> shapes) {
    const std::vector<const abut_shape*> pointers = Shape::pointers_of(shapes);
    const abut_status sizes = detail::expect_as_many("shapes", shapes.size(), "geometries", geometries.size());
    return detail::answer(
        sizes != ABUT_OK ? sizes
                         : abut_geometries_set_shapes(get(), geometries.data(), pointers.data(), geometries.size()));
  }
  // While the caller holds it, the next change of the geometry's shape copies it.
  [[nodiscard]] Answer<Shape> shape(GeometryId geometry) const {
    abut_shape* out = nullptr;
    const abut_status status = abut_geometry_shape(get(), geometry, &out);
    return detail::answer_with(status, [&] { return Shape::adopt(out); });
  }

  Answer<void> set_parameters(GeometryId geometry, Span<const double> parameters) {
    return detail::answer(abut_geometry_set_parameters(get(), geometry, parameters.data(), parameters.size()));
  }
  // Geometry by geometry, each as many.
  Answer<void> set_parameters(Span<const GeometryId> geometries, Span<const double> parameters) {
    const std::size_t each = geometries.empty() ? 0 : parameters.size() / geometries.size();
    const abut_status sizes =
        detail::expect_as_many("parameters", parameters.size(), "geometries take", each * geometries.size());
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_geometries_set_parameters(get(), geometries.data(), parameters.data(),
                                                                            each, geometries.size()));
  }
  // Of a rectangle of samples that begins at (column, row): columns * rows numbers, X fastest.
  Answer<void> set_heights(GeometryId geometry, std::uint32_t column, std::uint32_t row, std::uint32_t columns,
                           std::uint32_t rows, Span<const double> heights) {
    const std::uint64_t samples = std::uint64_t{columns} * rows;
    const abut_status sizes = detail::expect_as_many("heights", heights.size(), "columns * rows", samples);
    return detail::answer(sizes != ABUT_OK
                              ? sizes
                              : abut_geometry_set_heights(get(), geometry, column, row, columns, rows, heights.data()));
  }
  // Of a box of samples that begins at (column, row, layer): columns * rows * layers numbers, X fastest, then Y.
  Answer<void> set_field_values(GeometryId geometry, std::uint32_t column, std::uint32_t row, std::uint32_t layer,
                                std::uint32_t columns, std::uint32_t rows, std::uint32_t layers,
                                Span<const double> values) {
    const abut_status sizes = detail::expect_as_many("values", values.size(), "columns * rows * layers",
                                                     detail::product_of(columns, rows, layers));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_geometry_set_field_values(get(), geometry, column, row, layer,
                                                                            columns, rows, layers, values.data()));
  }
  // Points of a lattice over the grid of a distance field, X fastest, then Y; none take the lattice away.
  Answer<void> set_field_lattice(GeometryId geometry, std::uint32_t columns, std::uint32_t rows, std::uint32_t layers,
                                 const Points& points) {
    const abut_status sizes = detail::first_failure(
        detail::expect_whole("points", points),
        detail::expect_as_many("points", points.size(), "columns * rows * layers",
                               detail::product_of(columns, rows, layers)));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_geometry_set_field_lattice(get(), geometry, columns, rows, layers,
                                                                             points.data()));
  }
  // Of the particles from `first` on; radii are as many as centres, or none.
  Answer<void> set_particles(GeometryId geometry, std::size_t first, const Points& centres,
                             Span<const double> radii = {}) {
    const abut_status sizes = detail::first_failure(
        detail::expect_whole("centres", centres),
        detail::expect_as_many("radii", radii.empty() ? centres.size() : radii.size(), "centres", centres.size()));
    return detail::answer(sizes != ABUT_OK
                              ? sizes
                              : abut_geometry_set_particles(get(), geometry, first, centres.data(),
                                                            radii.empty() ? nullptr : radii.data(), centres.size()));
  }
  // Vertices of a mesh, from `first` on.
  Answer<void> set_vertices(GeometryId geometry, std::size_t first, const Points& places) {
    const abut_status sizes = detail::expect_whole("places", places);
    return detail::answer(
        sizes != ABUT_OK ? sizes
                         : abut_geometry_set_vertices(get(), geometry, first, places.data(), places.size()));
  }
  // Those of a list, as many as there are places.
  Answer<void> set_vertices(GeometryId geometry, Span<const std::uint32_t> vertices, const Points& places) {
    const abut_status sizes =
        detail::first_failure(detail::expect_whole("places", places),
                              detail::expect_as_many("vertices", vertices.size(), "places", places.size()));
    return detail::answer(sizes != ABUT_OK ? sizes
                                           : abut_geometry_set_vertices_at(get(), geometry, vertices.data(),
                                                                           places.data(), vertices.size()));
  }
  // Three numbers for each vertex of a mesh, which belong to the universe, until its next call that is not const.
  [[nodiscard]] Answer<Span<const double>> vertices(GeometryId geometry) const& {
    const double* xyz = nullptr;
    std::size_t count = 0;
    const abut_status status = abut_geometry_vertices(get(), geometry, &xyz, &count);
    Span<const double> numbers(xyz, 3 * count);
    return detail::answer(status, numbers);
  }
  Answer<Span<const double>> vertices(GeometryId geometry) const&& = delete;
  // The same numbers for where they move next, to be written. They are there until the geometry advances, goes or gets
  // another shape or mesh.
  [[nodiscard]] Answer<Span<double>> next_vertices(GeometryId geometry) & {
    double* xyz = nullptr;
    std::size_t count = 0;
    const abut_status status = abut_geometry_next_vertices(get(), geometry, &xyz, &count);
    Span<double> numbers(xyz, 3 * count);
    return detail::answer(status, numbers);
  }
  Answer<Span<double>> next_vertices(GeometryId geometry) && = delete;
  // What was written there becomes the vertices: of all these geometries, or of none.
  Answer<void> advance(GeometryId geometry) { return detail::answer(abut_geometry_advance(get(), geometry)); }
  Answer<void> advance(Span<const GeometryId> geometries) {
    return detail::answer(abut_geometries_advance(get(), geometries.data(), geometries.size()));
  }
  // The other triangles of the mesh keep their numbers.
  Answer<void> remove_triangles(GeometryId geometry, Span<const std::uint32_t> triangles) {
    return detail::answer(abut_geometry_remove_triangles(get(), geometry, triangles.data(), triangles.size()));
  }
  // All of a mesh. Contacts live on by the numbers of triangles.
  Answer<void> set_mesh(GeometryId geometry, const Points& vertices, const Triangles& triangles) {
    const abut_status sizes =
        detail::first_failure(detail::expect_whole("vertices", vertices), detail::expect_whole("triangles", triangles));
    return detail::answer(sizes != ABUT_OK
                              ? sizes
                              : abut_geometry_set_mesh(get(), geometry, vertices.data(), vertices.size(),
                                                       triangles.data(), triangles.size()));
  }

  // The one change that a filter may make.
  Answer<void> park(GeometryId geometry, Parking parking) {
    return detail::answer(abut_geometry_park(get(), geometry, parking));
  }
  Answer<void> park(Span<const GeometryId> geometries, Parking parking) {
    return detail::answer(abut_geometries_park(get(), geometries.data(), geometries.size(), parking));
  }

  // In the world.
  Answer<void> poses(Span<const GeometryId> geometries, Span<Pose> out) const {
    const abut_status sizes = detail::expect_as_many("out", out.size(), "geometries", geometries.size());
    return detail::answer(
        sizes != ABUT_OK ? sizes : abut_geometries_poses(get(), geometries.data(), geometries.size(), out.data()));
  }
  [[nodiscard]] Answer<std::vector<Pose>> poses(Span<const GeometryId> geometries) const {
    std::vector<Pose> out(geometries.size());
    return detail::answer(abut_geometries_poses(get(), geometries.data(), geometries.size(), out.data()), out);
  }
  // All of the universe.
  [[nodiscard]] Answer<std::vector<GeometryId>> geometries() const {
    return detail::collect<GeometryId>([this](GeometryId* data, std::size_t capacity, std::size_t* count) {
      return abut_universe_geometries(get(), data, capacity, count);
    });
  }
  // In order of creation.
  [[nodiscard]] Answer<std::vector<GeometryId>> geometries(PartId part) const {
    return detail::collect<GeometryId>([&](GeometryId* data, std::size_t capacity, std::size_t* count) {
      return abut_part_geometries(get(), part, data, capacity, count);
    });
  }

 protected:
  using UniverseParts::UniverseParts;

 private:
  static GeometryOptions options_from(const GeometryInfo& info) {
    return GeometryOptions()
        .with_flags(info.flags)
        .with_pose(info.local)
        .with_tolerance(info.tolerance)
        .with_user_data(info.user_data)
        .with_layers(info.layers)
        .with_mask(info.mask)
        .with_exclusion(info.exclusion)
        .with_label(info.label)
        .with_tag(info.tag)
        .with_material(info.material)
        .with_parking(static_cast<Parking>(info.parking));
  }
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
