// SPDX-License-Identifier: Apache-2.0
// What lies inside of a solid mesh and does not meet its surface.
#include "solids.hpp"

namespace {

using namespace solid;

TEST(Contained, BallInABoxIsAsDeepAsTheNearestFaceTells) {
  const ShapePtr hull = mesh(box_surface(2, 3, 4)), ball = sphere(0.5);
  const std::vector<std::array<double, 4>> places{{0, 0, 0, 2.5}, {1.2, 0.3, 0.4, 1.3}, {0.1, 0.2, -3.6, 0.9}};
  for (const auto& [x, y, z, depth] : places) {
    const abut_distance found = distance(hull, ball, at(x, y, z));
    EXPECT_NEAR(found.distance, -depth, 1e-12);
    // Bounds are told with the tolerance of a search, below 4e-12 of the size.
    EXPECT_NEAR(found.lower, -depth, 4e-12);
    EXPECT_NEAR(found.upper, -depth, 4e-12);
    const auto met = contacts(hull, ball, at(x, y, z));
    ASSERT_EQ(met.size(), 1u);
    EXPECT_NEAR(met[0].distance, -depth, 1e-12);
  }
}

TEST(Contained, BoxInABoxIsPushedOutOfTheNearestFace) {
  const ShapePtr hull = mesh(box_surface(2, 3, 4)), body = box(0.3, 0.4, 0.5);
  const ShapePtr body_mesh = mesh(box_surface(0.3, 0.4, 0.5)),
                 sheet = mesh(box_surface(0.3, 0.4, 0.5), ABUT_SIDES_BOTH);
  for (const ShapePtr* inner : {&body, &body_mesh, &sheet}) {
    const abut_distance found = distance(hull, *inner, at(0.1, 0.2, -0.3));
    EXPECT_NEAR(found.distance, -2.2, 1e-11);
    EXPECT_NEAR(found.normal.x, 1, 1e-12);
    EXPECT_GT(-found.upper, 1.7);
    expect_parted(hull, *inner, at(0.1, 0.2, -0.3), found);
    ASSERT_EQ(contacts(hull, *inner, at(0.1, 0.2, -0.3)).size(), 4u);
  }
  // Seen from the other side: it is the solid that surrounds that decides.
  const abut_distance back = distance(body_mesh, hull, at(-0.1, -0.2, 0.3));
  EXPECT_NEAR(back.distance, -2.2, 1e-11);
  EXPECT_NEAR(back.normal.x, -1, 1e-12);
}

TEST(Contained, DeclarationDecides) {
  const ShapePtr ball = sphere(0.5);
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
    const ShapePtr sheet = mesh(box_surface(2, 3, 4), sides);
    EXPECT_NEAR(distance(sheet, ball, at(0, 0, 0)).distance, 1.5, 1e-12);
    EXPECT_TRUE(contacts(sheet, ball, at(0, 0, 0)).empty());
  }
}

// A cavity is outside, although the box is around it.
TEST(Contained, CavityIsOutside) {
  test::Surface hollow = box_surface(2, 2, 2);
  const test::Surface cavity = box_surface(1, 1, 1);
  for (std::size_t i = 0; i < cavity.triangles.size(); i += 3) {
    hollow.triangles.insert(hollow.triangles.end(),
                            {cavity.triangles[i] + 8, cavity.triangles[i + 2] + 8, cavity.triangles[i + 1] + 8});
  }
  hollow.xyz.insert(hollow.xyz.end(), cavity.xyz.begin(), cavity.xyz.end());
  const ShapePtr shell = mesh(hollow), ball = sphere(0.25);
  EXPECT_NEAR(distance(shell, ball, at(0.2, 0, 0)).distance, 0.55, 1e-12);
  EXPECT_NEAR(distance(shell, ball, at(1.2, 0, 0)).distance, -0.45, 1e-12);  // back into the cavity
  EXPECT_NEAR(distance(shell, ball, at(1.7, 0, 0)).distance, -0.55, 1e-12);
}

TEST(Contained, BallInTheBunnyHasAnHonestDepth) {
  const test::Surface bunny = test::read_obj(ABUT_BUNNY);
  ASSERT_EQ(bunny.triangle_count(), 3674u);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const double damage : {0.0, 0.01, 0.03}) {
    const test::Surface surface = damage > 0 ? test::damaged(bunny, damage, 9) : bunny;
    const ShapePtr solid = mesh(surface), ball = sphere(0.3);
    int inside = 0;
    for (int i = 0; i < 12; ++i) {
      const double x = -0.6 + 3.5 * share(random), y = 4 + 4 * share(random), z = 3 * share(random);
      const double number = number_around(surface, x, y, z);
      const abut_distance found = distance(solid, ball, at(x, y, z));
      SCOPED_TRACE(::testing::Message() << "damage " << damage << " at " << x << ' ' << y << ' ' << z << ": "
                                        << number);
      if (number > 0.5) {
        ++inside;
        EXPECT_LE(found.distance, -0.3 + 1e-9);
        EXPECT_LE(found.upper, -0.3 + 1e-9);  // at least as deep as the ball is around a point inside
        EXPECT_FALSE(contacts(solid, ball, at(x, y, z)).empty());
        expect_parted(solid, ball, at(x, y, z), found);
      } else {
        EXPECT_GE(found.distance, -0.3 - 0.3);
      }
    }
    EXPECT_GT(inside, 2);
  }
}

// A ball is exact where the surface about the nearest point is convex: depths do not depend on the size of the whole.
TEST(Contained, SizeDoesNotMatter) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3}) {
    const ShapePtr hull = mesh(scaled(box_surface(2, 3, 4), scale)), ball = sphere(0.5 * scale);
    const abut_distance found = distance(hull, ball, at(1.2 * scale, 0.3 * scale, 0.4 * scale));
    EXPECT_NEAR(found.distance, -1.3 * scale, 1e-11 * scale);
    EXPECT_NEAR(distance(hull, ball, at(2.6 * scale, 0.3 * scale, 0.4 * scale)).distance, 0.1 * scale, 1e-11 * scale);
  }
}

}  // namespace
