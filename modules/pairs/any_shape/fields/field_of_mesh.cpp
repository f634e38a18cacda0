// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape.field_of_mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.registry;
import abut.shapes.distance_field;
import abut.trees.samples.field_sampling;
import abut.trees.samples.sparse_blocks;
import abut.triangles.buffers;

namespace abut {
namespace {

constexpr Real border_cells = 3;  // around the box of the triangles

Fault check_options(const FieldOptions& options) {
  if (Fault fault = check_not_negative("options.spacing", options.spacing)) {
    return fault;
  }
  return check_not_negative("options.band", options.band);
}

}  // namespace

Result<ShapeHandle> make_field_of_mesh(std::span<const Real> xyz, std::span<const std::uint32_t> triangles,
                                       const FieldOptions& options) {
  if (Fault fault = check_triangles("a distance field of a mesh", xyz, triangles)) {
    return *fault;
  }
  if (Fault fault = check_options(options)) {
    return *fault;
  }
  std::vector<Vec3> vertices(xyz.size() / 3);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
  }
  Aabb box = Aabb::empty();
  for (const std::uint32_t index : triangles) {
    box.include(vertices[index]);
  }
  const Vec3 size = box.high - box.low;
  constexpr Real usual_cells = 64, most_cells = 65000, most_samples = 4e9;
  const Real spacing = options.spacing > 0 ? options.spacing : largest_magnitude(size) / usual_cells;
  const auto samples_along = [&](Real side) { return std::ceil(side / spacing) + 2 * border_cells + 1; };
  if (!(spacing > 0)) {
    return Error{Errc::zero_vector, "the triangles have no extent; a distance field needs a solid"};
  }
  if (!(largest_magnitude(size) <= most_cells * spacing) ||
      samples_along(size.x) * samples_along(size.y) * samples_along(size.z) > most_samples) {
    return error_about(Errc::out_of_range, "options.spacing", spacing,
                       "so large that the grid has at most 65000 cells along an axis and 4e9 in all");
  }
  const GridPlace samples{static_cast<std::uint32_t>(samples_along(size.x)),
                          static_cast<std::uint32_t>(samples_along(size.y)),
                          static_cast<std::uint32_t>(samples_along(size.z))};
  // No distance is longer. Values are kept as single numbers.
  constexpr Real most_far = 1e38;
  const Real diagonal =
      spacing * norm({static_cast<Real>(samples.x), static_cast<Real>(samples.y), static_cast<Real>(samples.z)});
  if (!(diagonal <= most_far)) {
    return error_about(Errc::out_of_range, "the diagonal of the grid", diagonal, "at most 1e38");
  }
  const Real border = border_cells * spacing;
  const Vec3 origin = box.low - Vec3{border, border, border};
  SparseBlocks blocks = sample_distances({vertices, triangles}, {samples, origin, spacing}, options.band * spacing,
                                         options.is_smooth ? 1 : 0);
  const auto is_inside = [](float value) { return value < 0; };
  if (std::ranges::none_of(blocks.values(), is_inside) && std::ranges::none_of(blocks.corners(), is_inside)) {
    return Error{Errc::invalid_argument,
                 "triangles enclose no sample; they must be counter-clockwise seen from outside, and spacing small"};
  }
  const std::array<Real, 11> parameters{static_cast<Real>(samples.x),
                                        static_cast<Real>(samples.y),
                                        static_cast<Real>(samples.z),
                                        spacing,
                                        spacing,
                                        spacing,
                                        origin.x,
                                        origin.y,
                                        origin.z,
                                        options.is_inside_out ? 1.0 : 0.0,
                                        options.is_smooth ? 1.0 : 0.0};
  return DistanceField::make(parameters, std::move(blocks)).transform([](DistanceField field) {
    return ShapeHandle(AnyShape(std::move(field)));
  });
}

std::optional<FieldReport> field_report_of(const AnyShape& shape) {
  return std::visit(
      []<class S>(const S& its) -> std::optional<FieldReport> {
        if constexpr (requires { its.far_error(); }) {
          return FieldReport{its.is_smooth(), its.all_blocks(),    its.held_blocks(), its.near_error(),
                             its.far_error(), its.least_stretch(), its.most_stretch()};
        } else {
          return std::nullopt;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

}  // namespace abut
