// SPDX-License-Identifier: Apache-2.0
// Two coarse sheets through each other are equally deep whatever the margin is, and whichever comes first.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.two_surfaces;
import abut.shapes.height_field;
import abut.shapes.mesh;

namespace {

using abut::HeightField;
using abut::Mesh;
using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr int scenes = 2000;

Vec3 unit(const Vec3& v) { return (1 / norm(v)) * v; }

// Squares of a length of one, two triangles each.
struct Squares {
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices;

  [[nodiscard]] Mesh mesh() const { return test::made<Mesh>(std::vector<Real>{0}, vertices, indices); }
  // The same triangles the other way round.
  [[nodiscard]] Mesh backward() const {
    std::vector<std::uint32_t> turned;
    for (std::size_t at = indices.size(); at > 0; at -= 3) {
      turned.insert(turned.end(), {indices[at - 2], indices[at - 1], indices[at - 3]});
    }
    return test::made<Mesh>(std::vector<Real>{0}, vertices, turned);
  }
};
Squares random_squares(test::Random& random) {
  const auto squares = static_cast<std::uint32_t>(random.uniform(1, 4));
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t j = 0; j <= squares; ++j) {
    for (std::uint32_t i = 0; i <= squares; ++i) {
      vertices.insert(vertices.end(), {i - 0.5 * squares, j - 0.5 * squares, random.uniform(-0.3, 0.3)});
      if (i < squares && j < squares) {
        const std::uint32_t at = j * (squares + 1) + i, next = at + squares + 1;
        indices.insert(indices.end(), {at, at + 1, next + 1, at, next + 1, next});
      }
    }
  }
  return {vertices, indices};
}
Mesh random_sheet(test::Random& random) { return random_squares(random).mesh(); }

template <class Sheet>
Real deepest(const Sheet& a, const Sheet& b, const Pose& ab, Real margin) {
  abut::Manifold contacts;
  EXPECT_EQ(surfaces_contacts(a, b, ab, {.margin = margin}, contacts), abut::Outcome::ok);
  return contacts.empty() ? 0 : std::min(std::ranges::min(contacts, {}, &abut::ContactPoint::distance).distance, 0.0);
}

template <class Sheet>
Real depth(const Sheet& a, const Sheet& b, const Pose& ab) {
  abut::Distance found{};
  EXPECT_EQ(surfaces_distance(a, b, ab, {}, found), abut::Outcome::ok);
  return std::min(found.distance, 0.0);
}

// How many scenes differ, and by how much at most.
struct Differences {
  int count = 0;
  Real largest = 0;

  void add(Real difference) {
    count += difference > 1e-9 ? 1 : 0;
    largest = std::max(largest, difference);
  }
};

TEST(TwoSheets, AreAsDeepInAnyOrderAndWithAnyMargin) {
  test::Random random(41);
  int through = 0;
  Differences by_order, by_margin;
  for (int i = 0; i < scenes; ++i) {
    const Mesh a = random_sheet(random), b = random_sheet(random);
    const Pose ab{random.rotation(), random.point(1)};
    const Real of_both = depth(a, b, ab);
    through += of_both < -1e-9 ? 1 : 0;
    by_order.add(std::fabs(depth(b, a, ab.inverse()) - of_both));
    by_margin.add(std::fabs(deepest(a, b, ab, 0.4) - deepest(a, b, ab, 0)));
  }
  EXPECT_GT(through, scenes / 4);
  EXPECT_EQ(by_order.count, 0) << by_order.largest;
  EXPECT_EQ(by_margin.count, 0) << by_margin.largest;
}

TEST(TwoSheets, AreAsDeepWithTrianglesInAnyOrder) {
  constexpr std::uint64_t seed = 42;
  test::Random random(seed);
  Differences by_triangles;
  for (int i = 0; i < scenes; ++i) {
    const Squares a = random_squares(random), b = random_squares(random);
    const Pose ab{random.rotation(), random.point(1)};
    by_triangles.add(std::fabs(depth(a.mesh(), b.mesh(), ab) - depth(a.backward(), b.backward(), ab)));
  }
  EXPECT_EQ(by_triangles.count, 0) << by_triangles.largest << ", seed " << seed;
}

// A narrow strip stands in a floor, near a border. The shortest way out is level: over the border, along an edge of the
// floor. No face and no single triangle shows it.
TEST(TwoSheets, LeaveAlongAnEdge) {
  constexpr Real narrow = 0.0123;
  const HeightField floor = test::made<HeightField>({5, 3, 1.22, 1.457}, std::vector<Real>(15, 0.0));
  std::vector<Real> heights(15, 0.0);
  heights[2] = std::numeric_limits<Real>::quiet_NaN();
  const HeightField strip = test::made<HeightField>({3, 5, narrow, 1.31}, heights);
  const Vec3 x = unit({0.258, 0.117, 0.959}), z = unit(cross(x, {0.927, 0.247, -0.28})), y = cross(z, x);
  const Pose ab{{x, y, z}, {0.1022, -0.0936, 0.6432}};
  // Where a long side of the strip passes the floor.
  const Vec3 begin = ab * Vec3{2 * narrow, 0, 0}, through = begin - (begin.z / y.z) * y;
  EXPECT_NEAR(deepest(floor, strip, ab, 0), -through.y, 1e-9);
  EXPECT_NEAR(deepest(strip, floor, ab.inverse(), 0), -through.y, 1e-9);
}

}  // namespace
