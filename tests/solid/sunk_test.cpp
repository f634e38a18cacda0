// SPDX-License-Identifier: Apache-2.0
// What crosses the surface of a solid mesh: the depth of the whole, not that of one triangle.
#include <algorithm>

#include "solids.hpp"

namespace {

using namespace solid;

TEST(Sunk, ClosedFormsOfBoxes) {
  const ShapePtr hull = mesh(box_surface(2, 3, 4)), ball = sphere(0.5), body = box(0.3, 0.4, 0.5);
  const std::vector<std::array<double, 2>> places{{1.9, 0.6}, {2.0, 0.5}, {2.3, 0.2}, {2.49, 0.01}};
  for (const auto& [x, depth] : places) {
    const abut_distance found = distance(hull, ball, at(x, 0.3, 0.4));
    EXPECT_NEAR(found.distance, -depth, 1e-11);
    EXPECT_NEAR(found.upper, -depth, 1e-11);
    EXPECT_NEAR(found.normal.x, 1, 1e-9);
    const auto met = contacts(hull, ball, at(x, 0.3, 0.4));
    ASSERT_FALSE(met.empty());
    EXPECT_NEAR(least_of(met), -depth, 1e-11);
    for (const abut_contact& contact : met) EXPECT_GT(contact.normal.x, 0.99);
  }
  for (const double x : {1.75, 1.95, 2.2, 2.29}) {
    const abut_distance found = distance(hull, body, at(x, 0, 0));
    EXPECT_NEAR(found.distance, x - 2.3, 1e-11);
    const auto met = contacts(hull, body, at(x, 0, 0));
    EXPECT_GE(met.size(), 1u);
    EXPECT_NEAR(least_of(met), x - 2.3, 1e-11);
  }
  // At a corner the way out of the least face.
  EXPECT_NEAR(distance(hull, ball, at(2.1, 3.1, 4.1)).distance, std::sqrt(0.03) - 0.5, 1e-11);
}

// A segment through the middle of an edge of an octahedron overlaps the faces there by next to nothing, and its middle
// is outside. Its lower end is inside: the faces are as far away as the end is below the edge, over the square root
// of 3.
TEST(Sunk, SegmentThroughAnEdge) {
  const ShapePtr hull = mesh({{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
                              {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}}),
                 needle = made([](abut_shape** shape) { return abut_segment_create(0.5, shape); });
  for (const double aside : {0.0, 1e-10, -1e-10}) {
    for (const double depth : {0.0625, 0.125, 0.25}) {
      const abut_pose pose = at(0.5, aside, 1 - depth);
      const abut_distance found = distance(hull, needle, pose);
      EXPECT_NEAR(found.distance, -depth / std::sqrt(3), 1e-9) << aside;
      EXPECT_LE(-depth / std::sqrt(3), found.upper + 1e-9) << aside;
      EXPECT_NEAR(least_of(contacts(hull, needle, pose)), found.distance, 1e-11) << aside;
    }
  }
}

// It overlaps no face where it comes out, as it lies along it.
TEST(Sunk, SegmentAlongAFaceHasItsEndsOnBoth) {
  const ShapePtr hull = mesh(box_surface(2, 3, 4)),
                 needle = made([](abut_shape** shape) { return abut_segment_create(0.5, shape); });
  for (const double depth : {1e-6, 0.01, 0.25, 1.0}) {
    const auto met = contacts(hull, needle, at(2 - depth, 0.3, 0.2));
    ASSERT_EQ(met.size(), 2u) << depth;
    EXPECT_NEAR(std::abs(met[1].point_b.z - met[0].point_b.z), 1, 1e-11);
    for (const abut_contact& contact : met) {
      EXPECT_NEAR(contact.distance, -depth, 1e-11);
      EXPECT_NEAR(contact.normal.x, 1, 1e-12);
      EXPECT_NEAR(contact.point_a.x, 2, 1e-11);
      EXPECT_NEAR(contact.point_b.x, 2 - depth, 1e-11);
      EXPECT_NEAR(contact.point_b.y, 0.3, 1e-11);
      EXPECT_NEAR(std::abs(contact.point_b.z - 0.2), 0.5, 1e-11);
    }
  }
}

// The distance is 0.1 as long as the body is in the first half of a wall that is 0.4 thick: then it is out on the other
// side sooner.
TEST(Sunk, WallIsLeftOnTheNearerSide) {
  const ShapePtr wall = mesh(box_surface(0.2, 5, 5)), ball = sphere(0.5);
  for (const double x : {-0.15, -0.05, 0.05, 0.15}) {
    const abut_distance found = distance(wall, ball, at(x, 0.3, 0.4));
    EXPECT_NEAR(found.distance, std::abs(x) - 0.7, 1e-11);
    EXPECT_EQ(found.normal.x > 0, x > 0);
  }
}

// Ways of the proven length along directions all around end in an overlap.
void expect_no_shorter_way(const ShapePtr& a, const ShapePtr& b, const abut_pose& pose, const abut_distance& found) {
  const double way = -found.upper * (1 - 1e-6);
  for (int i = 0; i < 60; ++i) {
    const double z = 1 - (2 * i + 1) / 60.0, angle = 2.399963 * i, flat = std::sqrt(1 - z * z);
    const abut_pose moved = at(pose.position.x + way * flat * std::cos(angle),
                               pose.position.y + way * flat * std::sin(angle), pose.position.z + way * z);
    EXPECT_LE(distance(a, b, moved).distance, 1e-9);
  }
}

// Directions all around bound the least depth from above, points of the body inside from below.
void expect_between_samples(const test::Surface& surface, const ShapePtr& solid, const ShapePtr& body,
                            const std::array<double, 3>& half, const std::array<double, 3>& place) {
  const abut_distance found = distance(solid, body, at(place[0], place[1], place[2]));
  SCOPED_TRACE(::testing::Message() << "at " << place[0] << ' ' << place[1] << ' ' << place[2]);
  bool is_any_inside = false;
  for (int corner = 0; corner < 9 && !is_any_inside; ++corner) {
    const auto along = [&](std::size_t axis) {
      const double sign = corner == 8 ? 0 : (corner >> axis & 1) != 0 ? 1 : -1;
      return place[axis] + 0.999 * sign * half[axis];
    };
    is_any_inside = number_around(surface, along(0), along(1), along(2)) > 0.5;
  }
  if (!is_any_inside) return;
  EXPECT_LT(found.distance, 0);
  expect_parted(solid, body, at(place[0], place[1], place[2]), found);
  expect_no_shorter_way(solid, body, at(place[0], place[1], place[2]), found);
}

TEST(Sunk, DepthInATorusLiesInItsInterval) {
  const test::Surface ring = test::torus(2, 0.7, 40, 20);
  const ShapePtr solid = mesh(ring), body = box(0.3, 0.4, 0.2);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 10; ++i) {
    expect_between_samples(ring, solid, body, {0.3, 0.4, 0.2},
                           {2 * share(random), 2 * share(random), 0.7 * share(random)});
  }
}

TEST(Sunk, DepthInADamagedBunnyLiesInItsInterval) {
  const test::Surface bunny = test::damaged(test::read_obj(ABUT_BUNNY), 0.02, 4);
  const ShapePtr solid = mesh(bunny), body = box(0.5, 0.4, 0.6);
  for (const double x : {-3.0, -1.5, 0.5}) {
    expect_between_samples(bunny, solid, body, {0.5, 0.4, 0.6}, {x, 2.5, 0.5});
  }
}

// Where a triangle is wound the wrong way, contacts still lead out of the ring.
TEST(Sunk, TurnedTrianglesPushOut) {
  const test::Surface whole = test::torus(2, 0.7, 60, 30);
  test::Surface surface = whole;
  std::vector<std::size_t> turned;
  for (std::size_t triangle = 7; triangle < whole.triangle_count(); triangle += 101) {
    std::swap(surface.triangles[3 * triangle], surface.triangles[3 * triangle + 1]);
    turned.push_back(triangle);
  }
  ASSERT_GT(turned.size(), 30u);
  const ShapePtr solid = mesh(surface), ball = sphere(0.2);
  for (const std::size_t triangle : turned) {
    std::array<double, 3> centre{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] += whole.corner(triangle, i)[axis] / 3;
    }
    const double around = std::hypot(centre[0], centre[1]), share = 1 - 2 / around;
    const double length = std::hypot(share * around, centre[2]);
    const std::array<double, 3> out{share * centre[0] / length, share * centre[1] / length, centre[2] / length};
    for (const double depth : {0.12, -0.1}) {
      const auto met =
          contacts(solid, ball, at(centre[0] - depth * out[0], centre[1] - depth * out[1], centre[2] - depth * out[2]));
      ASSERT_FALSE(met.empty());
      for (const abut_contact& contact : met) {
        EXPECT_GT(contact.normal.x * out[0] + contact.normal.y * out[1] + contact.normal.z * out[2], 0.5);
      }
    }
  }
}

TEST(Sunk, TwoSolidMeshes) {
  const ShapePtr hull = mesh(box_surface(2, 3, 4)), other = mesh(box_surface(0.3, 0.4, 0.5));
  for (const double x : {1.9, 2.1, 2.25}) {
    const abut_distance found = distance(hull, other, at(x, 0.2, 0.1));
    EXPECT_NEAR(found.distance, x - 2.3, 1e-10);
    EXPECT_NEAR(found.normal.x, 1, 1e-9);
    EXPECT_NEAR(least_of(contacts(hull, other, at(x, 0.2, 0.1))), x - 2.3, 1e-10);
  }
  EXPECT_NEAR(distance(hull, other, at(3, 0.2, 0.1)).distance, 0.7, 1e-12);
  const test::Surface ring = test::torus(2, 0.7, 32, 16);
  const ShapePtr one = mesh(ring), two = mesh(ring);
  for (const double z : {0.5, 1.0, 1.39, 1.5}) {
    const abut_distance found = distance(one, two, at(0.2, 0, z));
    EXPECT_EQ(found.distance < 0, z < 1.4);
    if (found.distance < 0) expect_parted(one, two, at(0.2, 0, z), found);
  }
}

// From grazing to one around the other's tube, and within it.
TEST(Sunk, DepthOfTwoMeshesLiesInItsInterval) {
  const test::Surface ring = test::torus(2, 0.7, 32, 16), small = test::torus(0.5, 0.25, 20, 10);
  const ShapePtr one = mesh(ring), two = mesh(ring), tiny = mesh(small);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1, 1);
  int deep = 0;
  for (int i = 0; i < 16; ++i) {
    const ShapePtr& other = i % 2 == 0 ? two : tiny;
    const abut_pose pose = at(2.5 * share(random), 2.5 * share(random), share(random));
    const abut_distance found = distance(one, other, pose);
    if (found.distance >= 0) continue;
    ++deep;
    expect_parted(one, other, pose, found);
    expect_no_shorter_way(one, other, pose, found);
    // Both bounds are of the same size.
    EXPECT_LT(found.upper, 0.25 * found.distance);
  }
  EXPECT_GE(deep, 8);
}

}  // namespace
