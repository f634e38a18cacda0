// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;

namespace {

using abut::Pose;
using abut::Vec3;

// Separation along a direction, from the corners.
double separation_along(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const Vec3& n) {
  return -test::corners_overreach(a, b, n, 0);
}

Vec3 axis_of(const abut::Rotation& r, std::size_t number) { return number == 0 ? r.x : number == 1 ? r.y : r.z; }
Vec3 out_of_face(const abut::Rotation& r, std::size_t number) {
  return number % 2 == 1 ? axis_of(r, number / 2) : -axis_of(r, number / 2);
}

double brute_force(const Vec3& half_a, const Vec3& half_b, const Pose& ab, double* of_faces) {
  const std::vector<Vec3> a = test::corners_of(half_a, Pose::identity()), b = test::corners_of(half_b, ab);
  const std::array<Vec3, 3> axes_a{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const std::array<Vec3, 3> axes_b{ab.rotation.x, ab.rotation.y, ab.rotation.z};
  double best = -abut::infinity;
  const auto try_axis = [&](const Vec3& n) {
    best = std::fmax(best, std::fmax(separation_along(a, b, n), separation_along(a, b, -n)));
  };
  for (int i = 0; i < 3; ++i) {
    try_axis(axes_a[static_cast<std::size_t>(i)]);
    try_axis(axes_b[static_cast<std::size_t>(i)]);
  }
  *of_faces = best;
  for (const Vec3& p : axes_a) {
    for (const Vec3& q : axes_b) {
      const Vec3 n = cross(p, q);
      if (abut::norm(n) > 1e-7) {
        try_axis((1 / abut::norm(n)) * n);
      }
    }
  }
  return best;
}

TEST(BoxSat, FindsTheLargestSeparationOfAllAxes) {
  test::Random random(21);
  int of_edges = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = abut::absolute(random.point(1));
    const Pose ab{random.rotation(), random.point(1.5)};
    const abut::SatResult found = abut::sat_of_boxes(half_a, half_b, ab, 0, abut::infinity);
    double of_faces = 0;
    EXPECT_NEAR(found.separation, brute_force(half_a, half_b, ab, &of_faces), 1e-14);
    EXPECT_NEAR(abut::norm(found.normal), 1, 1e-14);
    EXPECT_NEAR(
        separation_along(test::corners_of(half_a, Pose::identity()), test::corners_of(half_b, ab), found.normal),
        found.separation, 1e-14);
    EXPECT_EQ(found.axes, 15u);
    const auto [of_a, of_b] = found.features;
    const abut::Rotation &r = ab.rotation, own = abut::Rotation::identity();
    if (found.features.are_edges()) {
      ++of_edges;
      EXPECT_GT(found.separation, of_faces);
      EXPECT_NEAR(dot(found.normal, axis_of(own, of_a.index)), 0, 1e-14);
      EXPECT_NEAR(dot(found.normal, axis_of(r, of_b.index)), 0, 1e-14);
    } else if (of_a.kind == abut::CoreFeature::Kind::face) {
      EXPECT_EQ(found.normal, out_of_face(own, of_a.index));
    } else {
      EXPECT_EQ(found.normal, -out_of_face(r, of_b.index));
    }
  }
  EXPECT_GT(of_edges, 400);
}

TEST(BoxSat, EdgesMustLeadByMoreThanTheNoise) {
  test::Random random(22);
  for (int i = 0; i < 200; ++i) {
    const Pose ab{random.rotation(), random.point(1.5)};
    const abut::SatResult found = abut::sat_of_boxes({1, 1, 1}, {1, 1, 1}, ab, 10, abut::infinity);
    EXPECT_FALSE(found.features.are_edges());
  }
}

TEST(BoxSat, StopsAtAFaceThatSeparatesFarEnough) {
  const Pose ab{abut::Rotation::identity(), {5, 0, 0}};
  EXPECT_EQ(abut::sat_of_boxes({1, 1, 1}, {1, 1, 1}, ab, 0, 2).axes, 6u);
  EXPECT_EQ(abut::sat_of_boxes({1, 1, 1}, {1, 1, 1}, ab, 0, 4).axes, 15u);
  EXPECT_EQ(abut::sat_of_boxes({1, 1, 1}, {1, 1, 1}, ab, 0, 2).separation, 3);
}

TEST(BoxSat, ParallelEdgesSpanNoFace) {
  const Pose ab{abut::Rotation::identity(), {0.5, 0.1, 0.2}};
  const abut::SatResult found = abut::sat_of_boxes({1, 1, 1}, {1, 1, 1}, ab, 0, abut::infinity);
  EXPECT_EQ(found.separation, -1.5);
  EXPECT_EQ(found.normal, (Vec3{1, 0, 0}));
  EXPECT_FALSE(found.features.are_edges());
}

TEST(BoxSat, ConcentricBoxesPartAlongTheirShortestWay) {
  const abut::SatResult found = abut::sat_of_boxes({3, 2, 1}, {3, 2, 1}, Pose::identity(), 0, abut::infinity);
  EXPECT_EQ(found.separation, -2);
  EXPECT_EQ(std::fabs(found.normal.z), 1);
}

}  // namespace
