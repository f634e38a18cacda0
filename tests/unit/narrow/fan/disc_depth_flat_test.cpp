// SPDX-License-Identifier: Apache-2.0
// Bodies without thickness, and axes along faces and through corners: rounding of the frame must not count.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "../../made.hpp"
#include "../../least_overlap.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.fan.discs.disc_depth_of_pair;
import abut.shapes.box;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.hull;
import abut.shapes.triangle;

namespace {

using abut::Pose;
using abut::Real;
using abut::Rotation;
using abut::Vec3;

constexpr Real error = 1e-10, size = 6;

// The hull of corners and a body of revolution, both in one frame, in which all numbers are small fractions.
struct Case {
  std::vector<Vec3> corners;
  Pose pose;  // of the body of revolution
  test::Solid solid;
};

Real overlap(const Case& c, const Vec3& d) {
  Real reach = -abut::infinity;
  for (const Vec3& corner : c.corners) {
    reach = std::max(reach, dot(corner, d));
  }
  return (reach + c.solid.reach(-c.pose.rotation.undo(d)) - dot(d, c.pose.position)) / norm(d);
}

template <class Polyhedron>
std::optional<abut::ProvenDepth> depth_of(const Polyhedron& polyhedron, const test::Solid& solid, const Pose& pose) {
  const std::vector<Real> parameters{solid.radius, solid.half_height};
  return solid.is_cone ? abut::disc_depth(polyhedron, test::made<abut::Cone>(parameters), pose, size, error)
                       : abut::disc_depth(polyhedron, test::made<abut::Cylinder>(parameters), pose, size, error);
}

// Turns that leave rounding where right angles were.
std::vector<Rotation> turns() {
  std::vector<Rotation> list{Rotation::identity(), Rotation::from({0.6, 0, 0.8, 0}),
                             Rotation::from({0.1, 0.1, 0.7, 0.7}), Rotation::from({0.6, 0.8, 0, 0})};
  test::Random random(31);
  for (int i = 0; i < 3; ++i) {
    list.push_back(random.rotation());
  }
  return list;
}

Real quarter(test::Random& random, int most) { return std::floor(random.uniform(-most, most + 1)) / 4; }

test::Solid small_solid(test::Random& random, bool is_cone) {
  const auto length = [&random] { return (2 + std::floor(random.uniform(0, 7))) / 4; };
  return {length(), length(), is_cone};
}

Pose small_pose(test::Random& random, int number) {
  const std::array<Rotation, 3> onto{Rotation::identity(), Rotation{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
                                     Rotation{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  const Rotation& along = onto.at(static_cast<std::size_t>(number % 3));
  return {along, {quarter(random, 1), quarter(random, 1), quarter(random, 1)}};
}

// Asks for the depth in many common frames; `ask` has the turn and the pose of the body of revolution after it.
template <class Ask>
bool check_in_all_frames(const Case& c, int number, const Ask& ask) {
  const auto overlap_along = [&c](const Vec3& d) { return overlap(c, d); };
  const Real least = test::least_overlap(overlap_along);
  // Of small fractions a depth is far above this, or nothing, which the search comes near to only.
  if (least <= 1e-6) {
    return false;
  }
  for (const Rotation& turn : turns()) {
    const std::optional<abut::ProvenDepth> found = ask(turn);
    EXPECT_TRUE(found) << number << ' ' << least;
    if (found) {
      test::expect_least(*found, least, error, overlap_along, number);
    }
  }
  return true;
}

std::vector<Real> flat(const std::vector<Vec3>& points) {
  std::vector<Real> numbers;
  for (const Vec3& p : points) {
    numbers.insert(numbers.end(), {p.x, p.y, p.z});
  }
  return numbers;
}

// Where only poses are turned, and both by the same: rounding then lies in the pose of one in the frame of the other.
Pose turned_together(const Rotation& turn, const Pose& pose) {
  const Pose common{turn, {0, 0, 0}};
  return common.inverse() * (common * pose);
}

// The same polyhedron in all frames.
template <class Polyhedron>
bool check_turned(const Polyhedron& polyhedron, const Case& c, int number) {
  return check_in_all_frames(
      c, number, [&](const Rotation& turn) { return depth_of(polyhedron, c.solid, turned_together(turn, c.pose)); });
}

std::vector<Vec3> small_polygon(test::Random& random, int count) {
  std::vector<Vec3> corners;
  for (int i = 0; i < count; ++i) {
    corners.push_back({quarter(random, 4), quarter(random, 4), 0});
  }
  return corners;
}

TEST(DiscDepthOfFlatHull, IsTheSameInAllFrames) {
  test::Random random(32);
  int count = 0;
  for (int i = 0; i < 60; ++i) {
    const Case c{small_polygon(random, 3 + i % 3), small_pose(random, i), small_solid(random, i % 2 == 0)};
    const auto hull = test::made<abut::Hull>({}, flat(c.corners));
    if (hull.report().dimension != 2) {
      continue;
    }
    count += check_turned(hull, c, i);
  }
  EXPECT_GT(count, 15);
}

// Turned corners lie in no common plane. The normals of the two sides are opposite but for rounding.
TEST(DiscDepthOfFlatHull, IsTheSameWhereItsCornersAreTurned) {
  test::Random random(33);
  int count = 0;
  for (int i = 0; i < 60; ++i) {
    const Case c{small_polygon(random, 3 + i % 3), small_pose(random, i), small_solid(random, i % 2 == 0)};
    if (test::made<abut::Hull>({}, flat(c.corners)).report().dimension != 2) {
      continue;
    }
    count += check_in_all_frames(c, i, [&](const Rotation& turn) {
      std::vector<Vec3> corners;
      for (const Vec3& corner : c.corners) {
        corners.push_back(turn * corner);
      }
      auto found = depth_of(test::made<abut::Hull>({}, flat(corners)), c.solid, Pose{turn, {0, 0, 0}} * c.pose);
      if (found) {
        found->normal = turn.undo(found->normal);
        found->normal = (1 / norm(found->normal)) * found->normal;
      }
      return found;
    });
  }
  EXPECT_GT(count, 15);
}

TEST(DiscDepthOfFlatTriangle, IsTheSameInAllFrames) {
  test::Random random(34);
  int count = 0;
  for (int i = 0; i < 30; ++i) {
    const Case c{small_polygon(random, 3), small_pose(random, i), small_solid(random, i % 2 == 0)};
    if (test::made<abut::Hull>({}, flat(c.corners)).report().dimension != 2) {
      continue;
    }
    const auto triangle = test::made<abut::FreeTriangle>(flat(c.corners));
    count += check_turned(triangle, c, i);
  }
  EXPECT_GT(count, 8);
}

// Boxes of which none, one, two or all half extents are zero, with corners on the axis too.
TEST(DiscDepthOfFlatBox, IsTheSameInAllFrames) {
  test::Random random(35);
  int count = 0;
  for (int i = 0; i < 24; ++i) {
    const Vec3 half{(i & 1) != 0 ? 0.5 : 0, (i & 2) != 0 ? 0.25 : 0, (i & 4) != 0 ? 0.5 : 0};
    const Case c{test::corners_of(half, Pose::identity()), small_pose(random, i), small_solid(random, i % 2 == 0)};
    const auto box = test::made<abut::Box>({half.x, half.y, half.z});
    count += check_turned(box, c, i);
  }
  EXPECT_GT(count, 12);
}

// A box without width along the axis of a cone, one end on the base: both corners lie on the axis but for rounding.
TEST(DiscDepthOfFlatBox, IsThatOfTheSideWhereItLiesOnTheAxis) {
  const Vec3 half{0, 0, 0.5};
  const Case c{test::corners_of(half, Pose::identity()), {Rotation::identity(), {0, 0, 0.5}}, {1, 1, true}};
  const auto box = test::made<abut::Box>({half.x, half.y, half.z});
  EXPECT_TRUE(check_turned(box, c, 0));
}

// Discs, and cylinders and cones that are discs but for rounding.
TEST(DiscDepthOfThinDiscs, IsTheSameInAllFrames) {
  test::Random random(36);
  int count = 0;
  for (int i = 0; i < 60; ++i) {
    test::Solid disc = small_solid(random, i % 2 == 0);
    disc.half_height = std::array{0.0, 1e-16, 1e-12, 1e-7}.at(static_cast<std::size_t>(i % 4));
    const Case c{small_polygon(random, 3 + i % 3), small_pose(random, i), disc};
    const auto hull = test::made<abut::Hull>({}, flat(c.corners));
    if (hull.report().dimension == 2) {
      count += check_turned(hull, c, i);
    }
  }
  EXPECT_GT(count, 15);
}

// Two of them, which may be left open, but not be wrong.
TEST(DiscDepthOfThinDiscs, OfTwoIsLeastInAllFrames) {
  test::Random random(37);
  int count = 0;
  const auto thin = [&](int number) {
    test::Solid disc = small_solid(random, number % 2 == 0);
    disc.half_height = std::array{0.0, 1e-16, 1e-9, 0.25, 0.5}.at(static_cast<std::size_t>(number % 5));
    return disc;
  };
  for (int i = 0; i < 75; ++i) {
    const test::Solid a = thin(i), b = thin(i / 5);
    const Pose pose = small_pose(random, i);
    const auto overlap_along = [&](const Vec3& d) {
      return (a.reach(d) + b.reach(-pose.rotation.undo(d)) - dot(d, pose.position)) / norm(d);
    };
    const Real least = test::least_overlap(overlap_along);
    if (least <= 1e-6) {
      continue;
    }
    for (const Rotation& turn : turns()) {
      const Pose placed = turned_together(turn, pose);
      const auto found = a.is_cone ? depth_of(test::made<abut::Cone>({a.radius, a.half_height}), b, placed)
                                   : depth_of(test::made<abut::Cylinder>({a.radius, a.half_height}), b, placed);
      if (found) {
        ++count;
        test::expect_least(*found, least, error, overlap_along, i);
      }
    }
  }
  EXPECT_GT(count, 100);
}

// The tip of a flat cone in a corner of a box, on the diagonal: the side all around is nearer than the base.
TEST(DiscDepthOfBox, IsThatOfTheSideWhereACornerLiesOnTheAxis) {
  const Real third = 1 / std::sqrt(Real{3});
  for (int corner = 0; corner < 8; ++corner) {
    const auto part = [&](int bit) { return (corner & bit) != 0 ? third : -third; };
    const Vec3 along{part(1), part(2), part(4)};
    const abut::Tangents across = abut::tangents_of(along);
    const Pose pose{{across.first, -across.second, -along}, (std::sqrt(Real{3}) + 0.15) * along};
    const test::Solid cone{2, 0.25, true};
    const Case c{test::corners_of({1, 1, 1}, Pose::identity()), pose, cone};
    const auto box = test::made<abut::Box>({1, 1, 1});
    const auto hull = test::made<abut::Hull>({}, flat(c.corners));
    EXPECT_TRUE(check_turned(box, c, corner));
    EXPECT_TRUE(check_turned(hull, c, corner));
  }
}

}  // namespace
