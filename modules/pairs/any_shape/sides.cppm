// SPDX-License-Identifier: Apache-2.0
// Which sides of a surface stop other shapes, by the parameters of its kind.
export module abut.pairs.any_shape.sides;
import abut.capability;
import abut.core.standard;
import abut.pairs.any_shape;

export namespace abut {

enum class SurfaceSides {
  none,    // no surface of triangles with sides
  both,    // a sheet
  front,   // stops what comes from its front
  solid,   // of what its triangles enclose
  ground,  // of all below it
};
[[nodiscard]] SurfaceSides sides_of(const AnyShape& shape);

// Triangles as a sheet of both sides; nothing in a build without such a kind.
[[nodiscard]] std::optional<ShapeHandle> make_sheet(const Triangles& triangles);

}  // namespace abut
