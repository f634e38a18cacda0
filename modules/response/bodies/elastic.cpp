// SPDX-License-Identifier: Apache-2.0
// Corotational tetrahedra: Etzmuss, Keckeisen, Strasser, "A fast finite element solution for cloth modelling" (2003),
// and Mueller, Gross, "Interactive virtual materials" (2004). The force is the exact derivative of the energy, as the
// turn is that of the polar decomposition; the stiffness leaves out how the turn changes, so that it is semidefinite.
module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <Eigen/LU>
#include <Eigen/SVD>
#pragma clang diagnostic pop

#include <abut/abut.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

module abut.response;

namespace abut::response {

namespace {

using Small = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

[[nodiscard]] Vector point_of(const abut_vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] abut_vec3 vector_of(const Vector& v) { return {v.x(), v.y(), v.z()}; }

[[nodiscard]] Small edges_of(const std::array<abut_vec3, 4>& places) {
  Small out;
  for (int i = 0; i < 3; ++i) out.col(i) = point_of(places[static_cast<std::size_t>(i) + 1]) - point_of(places[0]);
  return out;
}

void put(std::array<double, 144>& matrix, std::size_t count, std::size_t row, std::size_t column, const Small& block) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      matrix[(3 * row + i) * 3 * count + 3 * column + j] =
          block(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
}

// Between two nodes, of a block that both have.
[[nodiscard]] std::array<double, 144> between_two(const Small& block) {
  std::array<double, 144> out{};
  for (const std::size_t i : {0U, 1U}) {
    for (const std::size_t j : {0U, 1U}) put(out, 2, i, j, i == j ? block : Small(-block));
  }
  return out;
}

struct Direction {
  Vector along = Vector::Zero();  // unit; zero where both ends lie at one place
  double length = 0;
};
[[nodiscard]] Direction direction_of(const std::array<abut_vec3, 4>& places) {
  const Vector apart = point_of(places[1]) - point_of(places[0]);
  const double length = apart.norm();
  return {.along = length > 0 ? Vector(apart / length) : Vector::Zero(), .length = length};
}

}  // namespace

std::optional<Tetrahedron> tetrahedron_of(const std::array<std::uint32_t, 4>& nodes,
                                          const std::array<abut_vec3, 4>& corners, double young, double poisson,
                                          double damping) {
  const Small edges = edges_of(corners);
  const double size = edges.cwiseAbs().maxCoeff(), six_volumes = edges.determinant();
  constexpr double flat = 1e-12;
  if (!(std::fabs(six_volumes) > flat * size * size * size)) return std::nullopt;
  Tetrahedron out{.nodes = nodes,
                  .inverse = {},
                  .volume = std::fabs(six_volumes) / 6,
                  .shear = young / (2 * (1 + poisson)),
                  .lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
                  .damping = damping};
  const Small inverse = edges.inverse();
  for (std::size_t i = 0; i < 9; ++i)
    out.inverse[i] = inverse(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
  return out;
}

// Across its axis a spring that is longer than at rest is stiff by its pull. A shorter one would push aside: that part
// is left out.
ElasticForce force_of(const Spring& spring, const std::array<abut_vec3, 4>& places) {
  const auto [along, length] = direction_of(places);
  const double longer = length - spring.rest;
  const Vector pull = spring.stiffness * longer * along;
  const Small axis = along * along.transpose();
  const double across = length > spring.rest ? spring.stiffness * longer / length : 0;
  ElasticForce out{.count = 2,
                   .energy = 0.5 * spring.stiffness * longer * longer,
                   .forces = {vector_of(pull), vector_of(-pull)},
                   .stiffness = between_two(spring.stiffness * axis + across * (Small::Identity() - axis))};
  return out;
}

std::array<double, 144> viscosity_of(const Spring& spring, const std::array<abut_vec3, 4>& places) {
  const Vector along = direction_of(places).along;
  return between_two(spring.damping * along * along.transpose());
}

ElasticForce force_of(const Tetrahedron& element, const std::array<abut_vec3, 4>& places) {
  const Small inverse = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(element.inverse.data());
  const Small gradient = edges_of(places) * inverse;
  const Eigen::JacobiSVD<Small> parts(gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Small left = parts.matrixU();
  // The least stretch changes sides where the element is inside out.
  if ((left * parts.matrixV().transpose()).determinant() < 0) left.col(2) = -left.col(2);
  const Small turn = left * parts.matrixV().transpose();
  Small strain = turn.transpose() * gradient;
  strain = 0.5 * (strain + strain.transpose().eval()) - Small::Identity();
  const double trace = strain.trace();
  const Small stress = turn * (2 * element.shear * strain + element.lame * trace * Small::Identity());
  const Small pulls = -element.volume * stress * inverse.transpose();
  ElasticForce out{
      .count = 4,
      .energy = element.volume * (element.shear * strain.squaredNorm() + 0.5 * element.lame * trace * trace),
      .forces = {vector_of(-pulls.rowwise().sum()), vector_of(pulls.col(0)), vector_of(pulls.col(1)),
                 vector_of(pulls.col(2))},
      .stiffness = {}};
  // How fast each node moves what it holds, turned.
  std::array<Vector, 4> slopes;
  slopes[0] = -(turn * inverse.transpose()).rowwise().sum();
  for (int i = 0; i < 3; ++i) slopes[static_cast<std::size_t>(i) + 1] = turn * inverse.row(i).transpose();
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const Small block = element.lame * slopes[i] * slopes[j].transpose() +
                          element.shear * slopes[i].dot(slopes[j]) * Small::Identity() +
                          element.shear * slopes[j] * slopes[i].transpose();
      put(out.stiffness, 4, i, j, element.volume * block);
    }
  }
  return out;
}

std::array<double, 144> viscosity_of(const Tetrahedron& element, const ElasticForce& force) {
  std::array<double, 144> out = force.stiffness;
  for (double& number : out) number *= element.damping;
  return out;
}

}  // namespace abut::response
