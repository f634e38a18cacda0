// SPDX-License-Identifier: Apache-2.0
// A rod through a flat sheet of many triangles. The edges between them change nothing: the rod leaves the sheet through
// the nearer of its ends. Near a border of the sheet the way over that is shorter, and may be found or not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.surface.surfaces;
import abut.shapes.capsule;
import abut.shapes.height_field;
import abut.shapes.mesh;
import abut.shapes.segment;

namespace {

using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr std::uint32_t cells = 8;
constexpr Real side = 8;
constexpr Real above = 0.6, below = 0.4;  // how far a rod reaches beyond the sheet

abut::Mesh flat_mesh() {
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      vertices.insert(vertices.end(), {side * i / cells, side * j / cells, 0});
      if (i < cells && j < cells) {
        const std::uint32_t at = j * (cells + 1) + i, next = at + cells + 1;
        indices.insert(indices.end(), {at, at + 1, next + 1, at, next + 1, next});
      }
    }
  }
  return test::made<abut::Mesh>(std::vector<Real>{0}, vertices, indices);
}

// Upright, so that its ends are `above` and `below` the sheet.
Pose upright_at(Real x, Real y) { return {abut::Rotation::identity(), {x, y, 0.5 * (above - below)}}; }

template <class Surface, class Rod>
void expect_depths(const Surface& surface, const Rod& rod, Real radius, Real deepest) {
  test::Random random(20);
  for (int i = 0; i < 2000; ++i) {
    // Every other rod stands within a millionth of an edge.
    const auto place = [&] {
      const Real any = random.uniform(0, side);
      return i % 2 == 0 ? any : std::clamp(std::round(any) + random.uniform(-1e-6, 1e-6), 1e-9, side - 1e-9);
    };
    const Real x = place(), y = i % 4 == 1 ? x : place();
    const Real to_border = std::min({x, y, side - x, side - y});
    const Real most = deepest + radius, least = std::min(deepest, to_border) + radius;
    const auto expect_depth = [&](Real distance, Real margin) {
      EXPECT_LE(-distance, most + 1e-9) << x << " " << y << " margin " << margin;
      EXPECT_GE(-distance, least - 1e-9) << x << " " << y << " margin " << margin;
    };
    for (const Real margin : {0.0, 0.25, 3.0}) {
      abut::Manifold contacts;
      ASSERT_EQ(parts_contacts(surface, rod, upright_at(x, y), {.margin = margin}, contacts), abut::Outcome::ok);
      ASSERT_FALSE(contacts.empty()) << x << " " << y << " margin " << margin;
      expect_depth(std::ranges::min(contacts, {}, &abut::ContactPoint::distance).distance, margin);
    }
    abut::Distance distance{};
    ASSERT_EQ(parts_distance(surface, rod, upright_at(x, y), {}, distance), abut::Outcome::ok);
    abut::Manifold contacts;
    ASSERT_EQ(parts_contacts(surface, rod, upright_at(x, y), {}, contacts), abut::Outcome::ok);
    // Found along two ways, which round differently.
    EXPECT_NEAR(distance.distance, std::ranges::min(contacts, {}, &abut::ContactPoint::distance).distance, 1e-12);
  }
}

constexpr Real half = 0.5 * (above + below);

TEST(PartingWay, OfARodThroughAMeshKnowsNoEdges) {
  expect_depths(flat_mesh(), test::made<abut::Segment>(std::vector<Real>{half}), 0, below);
}

TEST(PartingWay, OfARoundRodThroughAMeshKnowsNoEdges) {
  expect_depths(flat_mesh(), test::made<abut::Capsule>(std::vector<Real>{0.05, half}), 0.05, below);
}

TEST(PartingWay, OfARodThroughAHeightFieldLeadsUp) {
  const std::vector<Real> heights((cells + 1) * (cells + 1), 0);
  const auto field = test::made<abut::HeightField>(
      std::vector<Real>{cells + 1, cells + 1, side / cells, side / cells, 0}, heights, std::vector<std::uint32_t>{});
  expect_depths(field, test::made<abut::Segment>(std::vector<Real>{half}), 0, below);
}

}  // namespace
