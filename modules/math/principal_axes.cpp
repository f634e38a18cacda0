// SPDX-License-Identifier: Apache-2.0
// The one file that includes Eigen: behind this implementation unit no importer pays for its
// templates, and no consumer of an installed abut needs its headers.
module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <Eigen/Eigenvalues>
#pragma clang diagnostic pop
module abut.math.principal_axes;
import abut.core.standard;
import abut.math.vec3;

namespace abut {

PrincipalAxes principal_axes(std::span<const Vec3> points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double scale = 0;
  for (const Vec3& p : points) {
    mean += Eigen::Vector3d(p.x, p.y, p.z) / static_cast<double>(points.size());
  }
  const Vec3 centre{mean.x(), mean.y(), mean.z()};
  for (const Vec3& p : points) {
    scale = std::max(scale, largest_magnitude(p - centre));
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  if (scale > 0) {
    for (const Vec3& p : points) {
      const Vec3 d = p - centre;
      const Eigen::Vector3d scaled = Eigen::Vector3d(d.x, d.y, d.z) / scale;  // no overflow, no underflow
      covariance += scaled * scaled.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const auto column = [&](int index) {
    const Eigen::Vector3d v = solver.eigenvectors().col(index);
    return Vec3{v.x(), v.y(), v.z()};
  };
  const Vec3 first = column(2), second = column(1);
  return {centre, first, second, cross(first, second)};
}

}  // namespace abut
