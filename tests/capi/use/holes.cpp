// SPDX-License-Identifier: Apache-2.0
// Holes: cavities in the solids of a composite.
#include <cmath>
#include <random>

#include "hollow_bodies.hpp"

namespace {

using namespace abut_test;

TEST(Holes, AMarbleInACavityTouchesItsWall) {
  const Shape marble = make_sphere(0.25);
  for (const Shape& hole : {sphere_hole(1), cylinder_hole(1, 1, 0), box_hole(1, 1, 1, 0)}) {
    const Shape body = hollow(hole);
    EXPECT_TRUE(contacts_of(body, identity, marble, identity).empty());
    EXPECT_TRUE(contacts_of(body, identity, marble, at(0.7, 0, 0)).empty());
    const auto found = contacts_of(body, identity, marble, at(0.8, 0, 0));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].distance, -0.05, 1e-12);
    EXPECT_NEAR(found[0].normal.x, -1, 1e-12) << "into the cavity";
    EXPECT_NEAR(found[0].point_a.x, 1, 1e-12);
    EXPECT_NEAR(found[0].point_b.x, 1.05, 1e-12);
    EXPECT_EQ(found[0].child_a, 1U) << "the hole";
    abut_distance distance{};
    const abut_pose place = at(0.5, 0, 0);
    ASSERT_TRUE(succeeded(abut_pair_distance(body, &identity, marble, &place, nullptr, &distance)));
    EXPECT_NEAR(distance.distance, 0.25, 1e-12);
  }
}

TEST(Holes, TheSolidIsThereOutside) {
  const Shape marble = make_sphere(0.25);
  for (const Shape& hole : {sphere_hole(1), cylinder_hole(1, 1, 0), box_hole(1, 1, 1, 0)}) {
    const Shape body = hollow(hole);
    const auto found = contacts_of(body, identity, marble, at(2.2, 0.3, 0.1));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].distance, -0.05, 1e-12);
    EXPECT_NEAR(found[0].normal.x, 1, 1e-12);
    EXPECT_EQ(found[0].child_a, 0U) << "the solid";
    EXPECT_TRUE(contacts_of(body, identity, marble, at(2.3, 0.3, 0.1)).empty());
    EXPECT_FALSE(contacts_of(body, identity, marble, at(1.5, 0, 0)).empty()) << "in the material";
  }
}

// Without an inside of their own they overlap the material as a small ball does.
TEST(Holes, APointInTheMaterialLeavesByTheNearerWay) {
  const Shape body = hollow(sphere_hole(1)), point = make_of_kind("point", {}),
              segment = make_of_kind("segment", {0.05});
  const abut_vec3 a{0, 0, 0}, b{0, 0.05, 0}, c{0, 0, 0.05};
  abut_shape* made = nullptr;
  require(abut_triangle_create(&a, &b, &c, &made));
  const Shape triangle(made);
  for (const abut_shape* shape : std::vector<const abut_shape*>{point, segment, triangle}) {
    for (const double x : {0.9, 1.2, 1.8}) {
      const abut_pose place = at(x, 0.01, 0.02);
      abut_distance distance{};
      require(abut_pair_distance(body, &identity, shape, &place, nullptr, &distance));
      EXPECT_NEAR(distance.distance, std::max(x - 2, 1 - x), 0.01);
      EXPECT_EQ(distance.upper, distance.distance);
      EXPECT_EQ(contacts_of(body, identity, shape, place).empty(), x < 1);
      std::uint32_t overlap = 7;
      require(abut_pair_overlaps(body, &identity, shape, &place, nullptr, &overlap));
      EXPECT_EQ(overlap, x < 1 ? 0U : 1U);
    }
  }
}

// The solid lies in the hole. The ball is 0.9 from the walls, and so from all that could be met.
TEST(Holes, WhereNothingIsLeftTheDistanceIsWhatIsProven) {
  const Shape solid = make_box(0.3, 0.3, 0.3), hole = sphere_hole(1), ball = make_sphere(0.1);
  const Shape nothing = make_composite({solid, hole}, {identity, identity});
  abut_distance distance{};
  require(abut_pair_distance(nothing, &identity, ball, &identity, nullptr, &distance));
  EXPECT_TRUE(std::isinf(distance.upper));
  EXPECT_NEAR(distance.lower, 0.9, 1e-9);
  EXPECT_EQ(distance.distance, distance.lower);
  const abut_vec3 &from = distance.point_a, &to = distance.point_b, &along = distance.normal;
  const double apart = (to.x - from.x) * along.x + (to.y - from.y) * along.y + (to.z - from.z) * along.z;
  EXPECT_NEAR(apart, distance.distance, 1e-12);
}

// Existence of contacts of balls: where the signed distance max(to the solid, -to the hole) is below the radius.
// Near the edges of a hole that maximum is only a bound, so those places are left out.
TEST(Holes, ContactsAreWhereTheMaterialIs) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-3, 3);
  const Shape body = hollow(sphere_hole(1), at(0.5, 0, 0));
  int inside = 0, touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const double radius = 0.05 + 0.1 * (i % 5), x = place(random), y = place(random), z = place(random);
    const double to_hole = std::hypot(x - 0.5, y, z) - 1;
    const double out_x = std::max(0.0, std::fabs(x) - 2), out_y = std::max(0.0, std::fabs(y) - 2),
                 out_z = std::max(0.0, std::fabs(z) - 2);
    const double outside = std::hypot(out_x, out_y, out_z);
    const double to_solid = outside > 0 ? outside : std::max({std::fabs(x), std::fabs(y), std::fabs(z)}) - 2;
    const double gap = std::max(to_solid, -to_hole) - radius;
    if (std::fabs(gap) < 1e-9) continue;
    const auto found = contacts_of(body, identity, make_sphere(radius), at(x, y, z));
    EXPECT_EQ(!found.empty(), gap < 0) << x << ' ' << y << ' ' << z << " radius " << radius;
    inside += to_hole < 0 ? 1 : 0;
    touching += gap < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(touching, 5000);
}

TEST(Holes, ARodSlidesThroughATube) {
  const Shape solid = make_of_kind("cylinder", {1, 2});
  const Shape hole = cylinder_hole(0.5, 2, 3);
  const Shape tube = make_composite({solid, hole}, {identity, identity});
  const Shape rod = make_of_kind("cylinder", {0.45, 1.5}), capsule = make_capsule(0.45, 1);
  for (double z = -6; z <= 6; z += 0.125) {
    EXPECT_TRUE(contacts_of(tube, identity, rod, at(0, 0, z)).empty()) << z;
    EXPECT_TRUE(contacts_of(tube, identity, capsule, at(0.04, 0, z)).empty()) << z;
  }
  const auto lying = contacts_of(tube, identity, rod, at(0.06, 0, 0));
  ASSERT_GE(lying.size(), 2U) << "along the wall";
  EXPECT_NEAR(deepest(lying), -0.01, 1e-9);
  for (const abut_contact& contact : lying) EXPECT_LT(contact.normal.x, 0);
}

TEST(Holes, LetOutOnlyThroughTheRemovedFace) {
  const Shape marble = make_sphere(0.25);
  const Shape well = hollow(box_hole(1, 1, 1.5, 16), at(0, 0, 0.5));  // flush with the top of the block
  for (double z = -0.7; z <= 3; z += 0.1) EXPECT_TRUE(contacts_of(well, identity, marble, at(0, 0, z)).empty()) << z;
  for (const double z : {-0.5, 0.5, 1.5}) {
    EXPECT_NEAR(deepest(contacts_of(well, identity, marble, at(0.85, 0, z))), -0.1, 1e-12);
    EXPECT_NEAR(deepest(contacts_of(well, identity, marble, at(0, -0.85, z))), -0.1, 1e-12);
  }
  EXPECT_NEAR(deepest(contacts_of(well, identity, marble, at(0, 0, -0.85))), -0.1, 1e-12);
}

TEST(Holes, ABallThatDoesNotFitRestsOnTheRim) {
  const Shape solid = make_box(3, 3, 0.5);
  const Shape plate = make_composite({solid, cylinder_hole(0.6, 0.5, 3)}, {identity, identity});
  const Shape ball = make_sphere(1);
  // It touches the rim where its centre is 0.8 above the top.
  EXPECT_TRUE(contacts_of(plate, identity, ball, at(0, 0, 1.31)).empty());
  const auto found = contacts_of(plate, identity, ball, at(0, 0, 1.29));
  ASSERT_GE(found.size(), 4U);
  for (const abut_contact& contact : found) {
    EXPECT_NEAR(std::hypot(contact.point_a.x, contact.point_a.y), 0.6, 1e-9);
    EXPECT_NEAR(contact.point_a.z, 0.5, 1e-9);
    EXPECT_NEAR(contact.distance, std::hypot(0.6, 0.79) - 1, 1e-9);
    EXPECT_GT(contact.normal.z, 0.7);
  }
  const Shape small = make_sphere(0.5);
  EXPECT_TRUE(contacts_of(plate, identity, small, at(0, 0, 0.9)).empty()) << "falls through";
}

TEST(Holes, WithoutMaterialBehindThemHaveNoWalls) {
  const Shape marble = make_sphere(0.25);
  const Shape apart = hollow(sphere_hole(1), at(10, 0, 0));
  EXPECT_TRUE(contacts_of(apart, identity, marble, at(10.9, 0, 0)).empty());
  EXPECT_FALSE(contacts_of(apart, identity, marble, identity).empty());
  const Shape gone = hollow(sphere_hole(10));
  EXPECT_TRUE(contacts_of(gone, identity, marble, identity).empty());
  EXPECT_TRUE(contacts_of(gone, identity, marble, at(2, 0, 0)).empty());
}

TEST(Holes, ThatOverlapAreOne) {
  const Shape block = make_box(4, 2, 2);
  const Shape first = sphere_hole(1), second = sphere_hole(1);
  const Shape body = make_composite({block, first, second}, {identity, at(-0.5, 0, 0), at(0.5, 0, 0)});
  const Shape marble = make_sphere(0.4);
  for (double x = -1; x <= 1; x += 0.125) EXPECT_TRUE(contacts_of(body, identity, marble, at(x, 0, 0)).empty()) << x;
  EXPECT_NEAR(deepest(contacts_of(body, identity, marble, at(1.2, 0, 0))), -0.1, 1e-12);
  EXPECT_NEAR(deepest(contacts_of(body, identity, marble, at(-1.2, 0, 0))), -0.1, 1e-12);
}

TEST(Holes, CutTheirOwnCompositeOnly) {
  const Shape block = make_box(2, 2, 2), plug = make_box(0.5, 0.5, 0.5);
  const Shape body = hollow(sphere_hole(1.5));
  const Shape whole = make_composite({body, plug}, {identity, identity});
  const Shape marble = make_sphere(0.25);
  EXPECT_FALSE(contacts_of(whole, identity, marble, identity).empty())
      << "the plug is not in the composite of the hole";
  EXPECT_TRUE(contacts_of(whole, identity, marble, at(1, 0, 0)).empty());
  const Shape outer = make_composite({body, plug, sphere_hole(0.4)}, {identity, identity, at(3, 0, 0)});
  EXPECT_TRUE(contacts_of(outer, identity, make_sphere(0.1), at(1, 0, 0)).empty());
}

TEST(Holes, CarryEveryConvexShape) {
  const Shape body = hollow(sphere_hole(1));
  EXPECT_NEAR(deepest(contacts_of(body, identity, make_box(0.4, 0.3, 0.2), at(0.6, 0, 0))),
              1 - std::hypot(1.0, 0.3, 0.2), 1e-12);
  EXPECT_NEAR(deepest(contacts_of(body, identity, make_capsule(0.25, 0.5), at(0, 0, 0.3))), 1 - 1.05, 1e-12);
  EXPECT_NEAR(deepest(contacts_of(body, identity, make_octahedron(0.5), at(0.6, 0, 0))), 1 - 1.1, 1e-12);
  EXPECT_NEAR(deepest(contacts_of(body, identity, make_of_kind("cylinder", {0.3, 0.4}), at(0, 0, 0.6))),
              1 - std::hypot(1.0, 0.3), 1e-9);
  EXPECT_NEAR(deepest(contacts_of(body, identity, make_of_kind("ellipsoid", {0.3, 0.4, 0.5}), at(0, 0, 0.6))), 1 - 1.1,
              1e-9);
  EXPECT_NEAR(deepest(contacts_of(body, identity, make_of_kind("particles", {0.1}, {0, 0, 0, 0.95, 0, 0}), identity)),
              -0.05, 1e-12);
}

// One outside, one on the outer face, one floating and one at the wall: each is judged by itself.
TEST(Holes, HoldParticlesOneByOne) {
  const Shape body = hollow(sphere_hole(1));
  const Shape dust = make_of_kind("particles", {0.1}, {3, 0, 0, 2.05, 0, 0, 0.2, 0, 0, 0, 0.92, 0});
  const auto found = contacts_of(body, identity, dust, identity);
  ASSERT_EQ(found.size(), 2U);
  for (const abut_contact& contact : found) {
    const bool is_at_wall = contact.child_b == 3;
    EXPECT_TRUE(is_at_wall || contact.child_b == 1);
    EXPECT_EQ(contact.child_a, is_at_wall ? 1U : 0U);
    EXPECT_NEAR(contact.distance, is_at_wall ? -0.02 : -0.05, 1e-12);
  }
}

TEST(Holes, AreSeenByRays) {
  const Shape body = hollow(sphere_hole(1));
  const auto cast = [&](const abut_shape* shape, const abut_ray& ray, abut_ray_hit& hit) {
    std::uint32_t found = 0;
    EXPECT_TRUE(succeeded(abut_shape_cast_ray(shape, &identity, &ray, &hit, &found)));
    return found != 0;
  };
  abut_ray_hit hit{};
  ASSERT_TRUE(cast(body, {{5, 0, 0}, {-1, 0, 0}, 100}, hit));
  EXPECT_NEAR(hit.distance, 3, 1e-12) << "the outside";
  ASSERT_TRUE(cast(body, {{0, 0, 0}, {1, 0, 0}, 100}, hit));
  EXPECT_NEAR(hit.distance, 1, 1e-12) << "the wall from inside";
  EXPECT_NEAR(hit.normal.x, -1, 1e-12);
  ASSERT_TRUE(cast(body, {{1.5, 0, 0}, {-1, 0, 0}, 100}, hit));
  EXPECT_NEAR(hit.distance, 0.5, 1e-12) << "from the material into the cavity";
  const Shape solid = make_box(3, 3, 0.5);
  const Shape plate = make_composite({solid, cylinder_hole(0.6, 0.5, 3)}, {identity, identity});
  EXPECT_FALSE(cast(plate, {{0, 0, 5}, {0, 0, -1}, 100}, hit)) << "through the hole";
  ASSERT_TRUE(cast(plate, {{0, 0, 5}, {0.12, 0, -1}, 100}, hit));
  EXPECT_NEAR(hit.point.x, 0.6, 1e-9) << "past the top, to the wall";
  EXPECT_NEAR(hit.point.z, 0, 1e-9);
}

TEST(Holes, SaySoWhereTheyMeetNothing) {
  std::uint32_t answers = 2;
  for (const char* kind : {"sphere_hole", "cylinder_hole", "box_hole"}) {
    const abut_shape_kind hole = abut_shape_kind_by_name(kind);
    for (const char* other :
         {"sphere", "box", "capsule", "cylinder", "cone", "ellipsoid", "hull", "point", "segment", "triangle",
          "particles", "composite", "mesh", "height_field", "uv_grid", "distance_field"}) {
      ASSERT_TRUE(succeeded(abut_pair_support(hole, abut_shape_kind_by_name(other), ABUT_QUERY_CONTACTS, &answers)));
      EXPECT_EQ(answers, 1U) << kind << " and " << other;
    }
    for (const char* other : {"plane", "sphere_hole", "cylinder_hole", "box_hole"}) {
      ASSERT_TRUE(succeeded(abut_pair_support(hole, abut_shape_kind_by_name(other), ABUT_QUERY_CONTACTS, &answers)));
      EXPECT_EQ(answers, 0U) << kind << " and " << other;
    }
  }
}

TEST(Holes, ParametersThatMakeNoSenseAreRefusedByName) {
  const auto refuses = [](const char* kind, const std::vector<double>& parameters, abut_status status,
                          std::initializer_list<std::string_view> words) {
    expect_kind_refused(kind, parameters, {}, {}, status, words);
  };
  refuses("sphere_hole", {-1}, ABUT_OUT_OF_RANGE, {"radius", "-1"});
  refuses("cylinder_hole", {1, 1, 4}, ABUT_UNKNOWN_VALUE, {"open_ends", "4"});
  refuses("cylinder_hole", {1, 1, 0.5}, ABUT_UNKNOWN_VALUE, {"open_ends", "0.5"});
  refuses("box_hole", {1, 1, 1, 64}, ABUT_UNKNOWN_VALUE, {"open_faces", "64"});
  refuses("box_hole", {1, 1, 1, 5}, ABUT_INVALID_ARGUMENT, {"open_faces", "5", "one axis"});
}

TEST(Holes, InAUniverseHoldAMarbleThatBouncesAbout) {
  // The motion is prescribed: straight on, and reflected at each contact. The marble never gets out.
  const Shape body = hollow(sphere_hole(1));
  const Shape marble = make_sphere(0.2);
  Universe universe;
  universe.add(body, identity, ABUT_MOTION_STATIC);
  abut_part_id part = universe.add_part(identity);
  universe.add_geometry(part, marble);
  abut_vec3 at_now{0, 0, 0}, velocity{0.03, 0.02, 0.011};
  int bounces = 0;
  for (int step = 0; step < 5000; ++step) {
    at_now = {at_now.x + velocity.x, at_now.y + velocity.y, at_now.z + velocity.z};
    const abut_pose pose = at(at_now.x, at_now.y, at_now.z);
    ASSERT_TRUE(succeeded(abut_universe_step(universe, 0)));
    ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
    for (const abut_contact& contact : universe.step()) {
      const abut_vec3& n = contact.normal;
      const double speed = velocity.x * n.x + velocity.y * n.y + velocity.z * n.z;
      if (speed < 0) {
        velocity = {velocity.x - 2 * speed * n.x, velocity.y - 2 * speed * n.y, velocity.z - 2 * speed * n.z};
        ++bounces;
      }
    }
    ASSERT_LT(std::hypot(at_now.x, at_now.y, at_now.z), 0.9) << step;
  }
  EXPECT_GT(bounces, 50);
}

}  // namespace
