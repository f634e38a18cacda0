// SPDX-License-Identifier: Apache-2.0
// A distance field from triangles.
export module abut.pairs.any_shape.field_of_mesh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.registry;

export namespace abut {

struct FieldOptions {
  Real spacing;  // of the samples; 0: a sixty-fourth of the longest side of the box of the triangles
  Real band;     // how many cells around the surface hold samples of their own
  bool is_inside_out;
};

// Three numbers a vertex and three indices a triangle, counter-clockwise seen from outside. An error in a build without
// such a kind.
[[nodiscard]] Result<AnyShape> make_field_of_mesh(std::span<const Real> xyz, std::span<const std::uint32_t> triangles,
                                                  const FieldOptions& options);

}  // namespace abut
