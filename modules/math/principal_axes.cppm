// SPDX-License-Identifier: Apache-2.0
// The shape of a cloud of points: in which directions, and how far, it extends.
export module abut.math.principal_axes;
import abut.core.standard;
import abut.math.vec3;

export namespace abut {

struct PrincipalAxes {
  Vec3 mean;
  Vec3 first, second, third;  // orthonormal and right-handed, by falling spread
};

// Eigenvectors of the covariance of at least one finite point. O(n).
[[nodiscard]] PrincipalAxes principal_axes(std::span<const Vec3> points);

}  // namespace abut
