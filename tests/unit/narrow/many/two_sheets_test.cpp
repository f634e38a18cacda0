// SPDX-License-Identifier: Apache-2.0
// Two coarse sheets through each other are equally deep whatever the margin is, and whichever comes first. The ways out
// that are tried do not always hold the shortest: two scenes differ by their order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.many.two_surfaces;
import abut.shapes.mesh;

namespace {

using abut::Mesh;
using abut::Pose;
using abut::Real;

constexpr int scenes = 2000;

// Squares of a length of one, two triangles each.
Mesh random_sheet(test::Random& random) {
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
  return test::made<Mesh>(std::vector<Real>{0}, vertices, indices);
}

Real deepest(const Mesh& a, const Mesh& b, const Pose& ab, Real margin) {
  abut::Manifold contacts;
  EXPECT_EQ(surfaces_contacts(a, b, ab, {.margin = margin}, contacts), abut::Outcome::ok);
  return contacts.empty() ? 0 : std::min(std::ranges::min(contacts, {}, &abut::ContactPoint::distance).distance, 0.0);
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
    const Real depth = deepest(a, b, ab, 0);
    through += depth < -1e-9 ? 1 : 0;
    by_order.add(std::fabs(deepest(b, a, ab.inverse(), 0) - depth));
    by_margin.add(std::fabs(deepest(a, b, ab, 0.4) - depth));
  }
  EXPECT_GT(through, scenes / 4);
  EXPECT_LE(by_order.count, 2);
  EXPECT_LE(by_order.largest, 0.06);
  EXPECT_EQ(by_margin.count, 0);
}

}  // namespace
