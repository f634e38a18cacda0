// SPDX-License-Identifier: Apache-2.0
// Trees of oriented boxes and of balls over triangles, against all triangles, while these move and go.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability.parts.item_tree;
import abut.math;
import abut.trees.boxes.bvh;
import abut.trees.boxes.volume_tree;

namespace {

using abut::Aabb;
using abut::Vec3;
using Corners = std::array<Vec3, 3>;

// Triangles of which some have gone.
struct Soup {
  std::vector<std::optional<Corners>> triangles;

  auto corners_of() const {
    return [this](std::uint32_t item) { return triangles[item]; };
  }
};

enum class Form { scattered, sheet, needles, one_place };

Corners random_triangle(Form form, test::Random& random) {
  const Vec3 at = form == Form::one_place ? Vec3{1, 2, 3} : random.point(10);
  switch (form) {
    case Form::scattered: return {at, at + random.point(1), at + random.point(1)};
    case Form::sheet: {
      const auto place = [](const Vec3& p) { return Vec3{p.x, p.x + 0.5 * p.y, p.y}; };
      return {place(at), place(at + random.point(1)), place(at + random.point(1))};
    }
    case Form::needles: {
      const Vec3 along = random.point(4);
      return {at, at + along, at + 0.5 * along + random.point(1e-6)};
    }
    case Form::one_place: return {at, at, at};
  }
  return {};
}

double lowest_of(const Corners& corners, const Vec3& direction) {
  return std::min({dot(direction, corners[0]), dot(direction, corners[1]), dot(direction, corners[2])});
}

// Whether a ray meets a triangle within a limit, by Cramer's rule.
std::optional<double> ray_to(const Corners& c, const Vec3& origin, const Vec3& direction) {
  const Vec3 u = c[1] - c[0], v = c[2] - c[0], n = cross(u, v), away = origin - c[0];
  const double d = -dot(direction, n);
  const Vec3 moment = cross(away, direction);
  if (d == 0) {
    return std::nullopt;
  }
  const double t = dot(away, n) / d, a = dot(v, moment) / d, b = -dot(u, moment) / d;
  return t >= 0 && a >= 0 && b >= 0 && a + b <= 1 ? std::optional(t) : std::nullopt;
}

// Whether a triangle and a box overlap for sure: a corner, or a point of an edge or the face, is in the box.
bool has_point_in(const Corners& c, const Aabb& box) {
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; i + j <= 16; ++j) {
      const Vec3 p = c[0] + (i / 16.0) * (c[1] - c[0]) + (j / 16.0) * (c[2] - c[0]);
      if (box.overlaps({p, p})) return true;
    }
  }
  return false;
}

template <class Tree>
std::multiset<std::uint32_t> overlaps_of(const Tree& tree, const Aabb& box) {
  std::multiset<std::uint32_t> visited;
  tree.visit_overlaps(box, [&](std::uint32_t item) { visited.insert(item); });
  return visited;
}

template <class Tree>
void expect_right(const Tree& tree, const Soup& soup, test::Random& random) {
  std::size_t present = 0;
  for (const auto& triangle : soup.triangles) present += triangle ? 1 : 0;
  // Each triangle is in all volumes above it.
  std::set<std::uint32_t> found;
  tree.for_each_above([&](const auto& volume, std::uint32_t item) {
    ASSERT_TRUE(soup.triangles[item].has_value());
    found.insert(item);
    for (const Vec3& corner : *soup.triangles[item]) ASSERT_TRUE(volume.holds(corner)) << item;
  });
  EXPECT_EQ(found.size(), present);
  EXPECT_EQ(overlaps_of(tree, Aabb::everything()).size(), present);
  for (int i = 0; i < 20; ++i) {
    const Vec3 centre = random.point(11), half{random.uniform(0, 3), random.uniform(0, 3), random.uniform(0, 3)};
    const Aabb box{centre - half, centre + half};
    const auto visited = overlaps_of(tree, box);
    const Vec3 direction = random.point(1), origin = random.point(15);
    double nearest = std::numeric_limits<double>::infinity(), lowest = nearest;
    for (std::uint32_t item = 0; item < soup.triangles.size(); ++item) {
      const auto& corners = soup.triangles[item];
      EXPECT_LE(visited.count(item), corners ? 1U : 0U);
      if (!corners) continue;
      if (has_point_in(*corners, box)) EXPECT_EQ(visited.count(item), 1U) << item;
      nearest = std::min(nearest, ray_to(*corners, origin, direction).value_or(nearest));
      lowest = std::min(lowest, lowest_of(*corners, direction));
    }
    double limit = std::numeric_limits<double>::infinity();
    tree.visit_ray(origin, direction, limit, [&](std::uint32_t item) {
      limit = std::min(limit, ray_to(*soup.triangles[item], origin, direction).value_or(limit));
    });
    EXPECT_EQ(limit, nearest);
    limit = std::numeric_limits<double>::infinity();
    tree.visit_below(direction, limit,
                     [&](std::uint32_t item) { limit = std::min(limit, lowest_of(*soup.triangles[item], direction)); });
    EXPECT_EQ(limit, lowest);
    if (present > 0) EXPECT_TRUE(soup.triangles[tree.item_near(origin)].has_value());
  }
}

static_assert(abut::ItemTree<abut::Bvh>);

template <class Tree>
class VolumeTrees : public testing::Test {};
using Kinds = testing::Types<abut::OrientedBoxTree, abut::SphereTree>;
TYPED_TEST_SUITE(VolumeTrees, Kinds);

TYPED_TEST(VolumeTrees, MeetWhatAllTrianglesTell) {
  test::Random random(20261124);
  for (const Form form : {Form::scattered, Form::sheet, Form::needles, Form::one_place}) {
    for (const std::size_t count : {1u, 2u, 4u, 5u, 37u, 300u}) {
      SCOPED_TRACE(count);
      Soup soup;
      for (std::size_t i = 0; i < count; ++i) {
        soup.triangles.push_back(i % 11 == 10 ? std::nullopt : std::optional(random_triangle(form, random)));
      }
      expect_right(TypeParam(count, soup.corners_of()), soup, random);
    }
  }
}

TYPED_TEST(VolumeTrees, OfNothingMeetNothing) {
  const TypeParam tree;
  EXPECT_TRUE(overlaps_of(tree, Aabb::everything()).empty());
  double limit = 10;
  tree.visit_ray({0, 0, 0}, {0, 0, 1}, limit, [&](std::uint32_t) { FAIL(); });
  tree.visit_below({0, 0, 1}, limit, [&](std::uint32_t) { FAIL(); });
}

TYPED_TEST(VolumeTrees, FollowTrianglesThatMoveAndGo) {
  constexpr unsigned seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  test::Random random(seed);
  Soup soup;
  for (std::size_t i = 0; i < 200; ++i) soup.triangles.emplace_back(random_triangle(Form::scattered, random));
  TypeParam tree(soup.triangles.size(), soup.corners_of());
  tree.make_room();
  for (int round = 0; round < 30; ++round) {
    for (int edit = 0; edit < 12; ++edit) {
      const auto item = static_cast<std::uint32_t>(random.uniform(0, 199.99));
      if (!soup.triangles[item]) continue;
      soup.triangles[item] =
          edit % 3 == 0 ? std::nullopt
                        : std::optional(random_triangle(edit % 3 == 1 ? Form::scattered : Form::needles, random));
      tree.touch(item);
      tree.touch(item);
    }
    tree.settle(soup.corners_of());
    expect_right(tree, soup, random);
  }
}

TYPED_TEST(VolumeTrees, AreWornWhereTrianglesHaveScattered) {
  test::Random random(3);
  Soup soup;
  for (std::size_t i = 0; i < 500; ++i) soup.triangles.emplace_back(random_triangle(Form::scattered, random));
  TypeParam tree(soup.triangles.size(), soup.corners_of());
  tree.make_room();
  const auto move_all = [&](double share) {
    for (std::uint32_t item = 0; item < 500; ++item) {
      for (Vec3& corner : *soup.triangles[item]) corner += share * Vec3{1, 2, 3};
      if (share == 0) soup.triangles[item] = random_triangle(Form::scattered, random);
      tree.touch(item);
    }
    tree.settle(soup.corners_of());
  };
  move_all(1);
  EXPECT_FALSE(tree.is_worn()) << "a move of all changes no form";
  move_all(0);
  EXPECT_TRUE(tree.is_worn());
}

// A query meets few of many: at most these on the mean of a wavy sheet of 20,000 triangles.
TYPED_TEST(VolumeTrees, PassOverWhatIsFar) {
  test::Random random(5);
  Soup soup;
  const auto point = [](int i, int j) { return Vec3{0.1 * i, 0.1 * j, 0.3 * std::sin(0.2 * i) * std::cos(0.3 * j)}; };
  for (int j = 0; j < 100; ++j) {
    for (int i = 0; i < 100; ++i) {
      soup.triangles.emplace_back(Corners{point(i, j), point(i + 1, j), point(i + 1, j + 1)});
      soup.triangles.emplace_back(Corners{point(i, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  const TypeParam tree(soup.triangles.size(), soup.corners_of());
  std::size_t visited = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 centre{random.uniform(1, 9), random.uniform(1, 9), 0};
    visited += overlaps_of(tree, {centre - Vec3{0.2, 0.2, 0.4}, centre + Vec3{0.2, 0.2, 0.4}}).size();
  }
  // The box covers 32 triangles, and touches those around it.
  EXPECT_LE(visited / 200, 150U);
}

}  // namespace
