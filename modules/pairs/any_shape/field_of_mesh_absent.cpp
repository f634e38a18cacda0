// SPDX-License-Identifier: Apache-2.0
// Builds without distance fields.
module abut.pairs.any_shape.field_of_mesh;
import abut.capability;
import abut.core.standard;
import abut.core;

namespace abut {

Result<ShapeHandle> make_field_of_mesh(std::span<const Real> /*xyz*/, std::span<const std::uint32_t> /*triangles*/,
                                       const FieldOptions& /*options*/) {
  return Error{Errc::unsupported, "this build of abut has no shape named distance_field"};
}

std::optional<FieldReport> field_report_of(const AnyShape& /*shape*/) { return std::nullopt; }

}  // namespace abut
