// SPDX-License-Identifier: Apache-2.0
#include "accuracy_placing.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "accuracy_judge.hpp"
#include "oracle/support.hpp"

namespace bench {
namespace {

using oracle::quad;
using oracle::Quad;
using oracle::Vec;

Vec vec_of(const Point& p) { return {quad(p[0]), quad(p[1]), quad(p[2])}; }

Placement placed(const Vec& position, const Quaternion& turn) {
  return {{static_cast<double>(position.x), static_cast<double>(position.y), static_cast<double>(position.z)}, turn};
}

Quaternion unit(const Quaternion& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

Vec along_an_axis(std::size_t axis, Random& random) {
  std::array<double, 3> n{};
  n.at(axis) = random.below(2) == 0 ? 1 : -1;
  return vec_of(n);
}

Vec inner_point(const oracle::Solid& solid, Random& random) {
  Vec sum;
  for (int i = 0; i < 4; ++i) {
    sum = sum + oracle::support_point(solid, vec_of(random.direction()));
  }
  return sum * quad(0.25);
}

}  // namespace

Vec side_normal(const Solid& solid, Random& random) {
  const Point any = random.direction();
  switch (solid.kind) {
    case Kind::box: return along_an_axis(random.below(3), random);
    case Kind::cylinder:
      return random.below(2) == 0 ? along_an_axis(2, random) : oracle::unit({quad(any[0]), quad(any[1]), 0});
    case Kind::capsule: return oracle::unit({quad(any[0]), quad(any[1]), 0});
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: {
      const auto& [i, j, k] = solid.triangles[random.below(solid.triangles.size())];
      const auto corner = [&solid](int index) { return vec_of(solid.points[static_cast<std::size_t>(index)]); };
      return oracle::unit(oracle::cross(corner(j) - corner(i), corner(k) - corner(i)));
    }
    case Kind::sphere:
    case Kind::cone:
    case Kind::ellipsoid:
    case Kind::plane:
    case Kind::triangle:
    case Kind::mesh:
    case Kind::height_field:
    case Kind::solid_mesh:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::point:
    case Kind::composite: return oracle::unit(vec_of(any));
  }
  return {};
}

Quaternion turn_from(const Vec& u, const Vec& v) {
  const Vec axis = oracle::cross(u, v);
  const double w = 1 + static_cast<double>(oracle::dot(u, v));
  if (w < 1e-6) {
    const Vec across = oracle::perpendicular(u);
    const Quaternion half_turn{0, static_cast<double>(across.x), static_cast<double>(across.y),
                               static_cast<double>(across.z)};
    return unit(product(turn_from(-u, v), half_turn));
  }
  return unit({w, static_cast<double>(axis.x), static_cast<double>(axis.y), static_cast<double>(axis.z)});
}

Quaternion small_turn(double angle, Random& random) {
  const Point axis = random.direction();
  const double sine = std::sin(angle / 2);
  return unit({std::cos(angle / 2), sine * axis[0], sine * axis[1], sine * axis[2]});
}

Placement facing(const oracle::Solid& a, const Placement& pose_a, const oracle::Solid& b, const Quaternion& turn_b,
                 const Vec& n, double gap, double slack) {
  const oracle::Pose at_a = oracle_pose(pose_a);
  oracle::Pose at_b = oracle_pose({{0, 0, 0}, turn_b});
  const Vec on_a = at_a.place(oracle::support_point(a, at_a.rotate_back(n), quad(slack)));
  const Vec on_b = at_b.place(oracle::support_point(b, at_b.rotate_back(-n), quad(slack)));
  at_b.position = on_a - on_b;
  const Quad overlap = oracle::overlap_along(a, at_a, b, at_b, n);
  return placed(at_b.position + n * (overlap + quad(gap)), turn_b);
}

Placement meeting(const oracle::Solid& a, const Placement& pose_a, const oracle::Solid& b, const Quaternion& turn_b,
                  Random& random) {
  const Vec in_a = oracle_pose(pose_a).place(inner_point(a, random));
  const Vec in_b = oracle_pose({{0, 0, 0}, turn_b}).place(inner_point(b, random));
  return placed(in_a - in_b, turn_b);
}

}  // namespace bench
