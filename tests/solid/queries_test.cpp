// SPDX-License-Identifier: Apache-2.0
// Points, rays, casts and universes with solid meshes.
#include "solids.hpp"

namespace {

using namespace solid;

ShapePtr point() {
  return made([](abut_shape** out) { return abut_point_create(out); });
}

// Exterior points next to the edges of a watertight tetrahedron, where normals of faces tell the wrong side.
TEST(Queries, PointsBesideTheEdgesOfATetrahedronAreOutside) {
  const test::Surface surface{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.4, 0.4, 0.05}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  const ShapePtr solid = mesh(surface), probe = point();
  for (const double beyond : {1e-1, 1e-3, 1e-6}) {
    for (const double tilt : {-0.1, 0.0, 0.1}) {
      const abut_distance found = distance(solid, probe, at(0.5 + beyond, 0.5 + beyond, tilt * beyond));
      EXPECT_GT(found.distance, 0);
      EXPECT_NEAR(found.normal.x, std::sqrt(0.5), 0.2);
      EXPECT_GT(distance(solid, probe, at(1 + beyond, tilt * beyond, tilt * beyond)).distance, 0);
    }
  }
  EXPECT_NEAR(distance(solid, probe, at(0.3, 0.3, 0.01)).distance, -0.01, 1e-12);
}

TEST(Queries, SideIsThatOfAllSolidAngles) {
  const test::Surface bunny = test::damaged(test::read_obj(ABUT_BUNNY), 0.02, 8);
  const ShapePtr solid = mesh(bunny), probe = point();
  std::mt19937 random(17);
  std::uniform_real_distribution<double> share(-1, 1);
  int inside = 0;
  for (int i = 0; i < 40; ++i) {
    const double x = 5 * share(random), y = 4.5 + 5 * share(random), z = 4 * share(random);
    const double number = number_around(bunny, x, y, z);
    if (std::abs(number - 0.5) > 1e-6) {
      EXPECT_EQ(distance(solid, probe, at(x, y, z)).distance < 0, number > 0.5) << x << ' ' << y << ' ' << z;
      inside += number > 0.5;
    }
  }
  EXPECT_GT(inside, 2);
}

TEST(Queries, CastThatStartsInsideTouchesAtOnce) {
  const ShapePtr hull = mesh(box_surface(2, 3, 4)), ball = sphere(0.5);
  const abut_pose here = at(0, 0, 0), inside = at(0.5, 0, 0), before = at(-5, 0, 0);
  const abut_vec3 still{0, 0, 0}, right{10, 0, 0};
  abut_cast_hit hit{};
  std::uint32_t is_hit = 0;
  ASSERT_EQ(abut_pair_cast(hull.get(), &here, &still, ball.get(), &inside, &right, nullptr, &hit, &is_hit), ABUT_OK);
  ASSERT_NE(is_hit, 0u);
  EXPECT_EQ(hit.fraction, 0);
  EXPECT_NEAR(hit.contact.distance, -2, 1e-11);
  ASSERT_EQ(abut_pair_cast(hull.get(), &here, &still, ball.get(), &before, &right, nullptr, &hit, &is_hit), ABUT_OK);
  ASSERT_NE(is_hit, 0u);
  EXPECT_NEAR(hit.fraction, 0.25, 1e-9);
}

struct World {
  World() { EXPECT_EQ(abut_universe_create(nullptr, &universe), ABUT_OK); }
  ~World() { abut_universe_destroy(universe); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add(const ShapePtr& shape, abut_motion motion, const abut_pose& pose) const {
    abut_part_options options;
    abut_part_options_init(&options, sizeof options);
    options.motion = motion;
    options.pose = pose;
    abut_part_id part{};
    EXPECT_EQ(abut_part_create(universe, &options, &part), ABUT_OK) << abut_last_error_message();
    abut_geometry_id geometry{};
    EXPECT_EQ(abut_geometry_create(universe, part, shape.get(), nullptr, &geometry), ABUT_OK);
  }
  abut_universe* universe = nullptr;
};

TEST(Queries, UniversesFollow) {
  const World world;
  const ShapePtr hull = mesh(box_surface(2, 3, 4)), ball = sphere(0.5), small = sphere(0.1);
  world.add(hull, ABUT_MOTION_STATIC, at(0, 0, 0));
  world.add(ball, ABUT_MOTION_DYNAMIC, at(0.5, 0, 0));
  ASSERT_EQ(abut_universe_step(world.universe, 0), ABUT_OK);
  const abut_contact* met = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(abut_universe_contacts(world.universe, &met, &count), ABUT_OK);
  ASSERT_EQ(count, 1u);
  EXPECT_NEAR(met[0].distance, -2, 1e-11);
  std::array<abut_geometry_id, 4> found{};
  const abut_vec3 in_wall{1.5, 2, 3}, outside{2.5, 2, 3};
  ASSERT_EQ(abut_universe_at_point(world.universe, &in_wall, nullptr, found.data(), found.size(), &count), ABUT_OK);
  EXPECT_EQ(count, 1u);
  ASSERT_EQ(abut_universe_at_point(world.universe, &outside, nullptr, found.data(), found.size(), &count), ABUT_OK);
  EXPECT_EQ(count, 0u);
  const abut_pose there = at(-1.2, 1, 1);
  ASSERT_EQ(abut_universe_overlaps(world.universe, small.get(), &there, nullptr, 0, found.data(), found.size(), &count),
            ABUT_OK);
  EXPECT_EQ(count, 1u);
}

}  // namespace
