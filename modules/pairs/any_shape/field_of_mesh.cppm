// SPDX-License-Identifier: Apache-2.0
// A distance field from triangles.
export module abut.pairs.any_shape.field_of_mesh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.shape_handle;

export namespace abut {

struct FieldOptions {
  Real spacing;  // of the samples; 0: a sixty-fourth of the longest side of the box of the triangles
  Real band;     // how many cells around the surface hold samples of their own
  bool is_inside_out;
  bool is_smooth;  // tri-quadratic between samples
};

// Three numbers a vertex and three indices a triangle, counter-clockwise seen from outside. An error in a build without
// such a kind.
[[nodiscard]] Result<ShapeHandle> make_field_of_mesh(std::span<const Real> xyz,
                                                     std::span<const std::uint32_t> triangles,
                                                     const FieldOptions& options);

// What is known of a distance field as a whole; of other shapes nothing.
struct FieldReport {
  bool is_smooth;
  std::size_t blocks, held_blocks;
  Real near_error, far_error;  // of values, where blocks hold samples and elsewhere
  Real least_stretch, most_stretch;
};
[[nodiscard]] std::optional<FieldReport> field_report_of(const AnyShape& shape);

}  // namespace abut
