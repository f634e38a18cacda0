// SPDX-License-Identifier: Apache-2.0
// All axes of a triangle at once against the axes one by one, and against the corners under the normal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.fan.features;
import abut.narrow.fan.sat;
import abut.narrow.fan.triangle_sat;
import abut.shapes.box;

namespace {

using abut::Pose;
using abut::Triangle;
using abut::Vec3;

constexpr double noise = 1e-13, tolerance = 1e-13;

Triangle random_triangle(test::Random& random) { return {random.point(1), random.point(1), random.point(1), 0, false}; }

std::vector<Vec3> corners_of(const Triangle& triangle, const Pose& pose) {
  std::vector<Vec3> corners;
  for (const Vec3& corner : triangle.corners()) {
    corners.push_back(pose * corner);
  }
  return corners;
}

// From the last corner of a to the first one of b.
double gap_along(const Vec3& n, const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double of_a = -abut::infinity, of_b = abut::infinity;
  for (const Vec3& corner : a) {
    of_a = std::fmax(of_a, dot(n, corner));
  }
  for (const Vec3& corner : b) {
    of_b = std::fmin(of_b, dot(n, corner));
  }
  return of_b - of_a;
}

// Whether the answer is that of the axes one by one, holds for the corners and belongs to its features.
template <class B>
void expect_right(const Triangle& a, const B& b, const Pose& ab, const std::vector<Vec3>& corners_b) {
  const auto found = abut::triangle_sat(a, b, ab, noise);
  const auto one_by_one = abut::sat(a, b, ab, noise);
  ASSERT_TRUE(found.has_value() && one_by_one.has_value());
  EXPECT_NEAR(found->separation, one_by_one->separation, noise + tolerance);
  EXPECT_EQ(found->axes, one_by_one->axes);
  EXPECT_NEAR(gap_along(found->normal, corners_of(a, Pose::identity()), corners_b), found->separation, tolerance);
  ASSERT_TRUE(found->features.are_known());
  const Vec3 of_features = abut::normal_of(a, b, ab, found->features);
  const double sign = found->features.are_edges() && dot(of_features, found->normal) < 0 ? -1 : 1;
  EXPECT_LT(norm(sign * of_features - found->normal), tolerance);
}

TEST(TriangleSat, OfABoxIsThatOfItsAxesOneByOne) {
  test::Random random(901);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 half = abut::absolute(random.point(1)) + Vec3{0.01, 0.01, 0.01};
    const Pose ab{random.rotation(), random.point(1.5)};
    expect_right(random_triangle(random), test::made<abut::Box>({half.x, half.y, half.z}), ab,
                 test::corners_of(half, ab));
  }
}

TEST(TriangleSat, OfTwoTrianglesIsThatOfTheirAxesOneByOne) {
  test::Random random(902);
  for (int i = 0; i < 3000; ++i) {
    const Triangle b = random_triangle(random);
    const Pose ab{random.rotation(), random.point(1)};
    expect_right(random_triangle(random), b, ab, corners_of(b, ab));
  }
}

// Edges along the axes of the box have no axis across both.
TEST(TriangleSat, ParallelEdgesAreLeftOut) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, false};
  const auto box = test::made<abut::Box>({0.5, 0.25, 0.125});
  const Pose ab{abut::Rotation::identity(), {0.25, 0.25, 0.0625}};
  const auto found = abut::triangle_sat(triangle, box, ab, noise);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->separation, -0.0625);
  EXPECT_EQ(found->normal, (Vec3{0, 0, 1}));
}

TEST(TriangleSat, NearlyParallelEdgesAreLeftToOthers) {
  const Triangle triangle{{0, 0, 0}, {1, 1e-6, 0}, {0, 1, 0}, 0, false};
  const auto box = test::made<abut::Box>({0.5, 0.25, 0.125});
  EXPECT_FALSE(abut::triangle_sat(triangle, box, Pose::identity(), noise).has_value());
}

TEST(TriangleSat, ATriangleWithoutAreaStillHasEdges) {
  test::Random random(903);
  for (int i = 0; i < 300; ++i) {
    const Vec3 start = random.point(1), along = random.point(1);
    const Triangle segment{start, start + 0.5 * along, start + along, 0, false};
    const Vec3 half = abut::absolute(random.point(1)) + Vec3{0.01, 0.01, 0.01};
    const auto box = test::made<abut::Box>({half.x, half.y, half.z});
    const Pose ab{random.rotation(), random.point(1)};
    const auto found = abut::triangle_sat(segment, box, ab, noise);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(gap_along(found->normal, corners_of(segment, Pose::identity()), test::corners_of(half, ab)),
                found->separation, tolerance);
  }
}

}  // namespace
