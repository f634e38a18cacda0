// SPDX-License-Identifier: Apache-2.0
// Which child of a composite a ray meets.
export module abut.pairs.any_shape.casts.ray_child;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;

export namespace abut {

// The child whose surface a ray crosses at `distance`, which a cast has found; of several within rounding the nearest,
// then the first. 0 for a shape without children. The ray is in the frame of the shape.
[[nodiscard]] std::uint32_t child_on_ray(const AnyShape& shape, const Vec3& origin, const UnitVec3& direction,
                                         Real distance);

}  // namespace abut
