// SPDX-License-Identifier: Apache-2.0
// A distance tells by which route it was found.
#include "hollow_bodies.hpp"

namespace {

using namespace abut_test;

abut_algorithm route_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b) {
  abut_distance found{};
  EXPECT_TRUE(succeeded(abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &found)));
  return found.algorithm;
}

Shape mesh_of(const std::vector<double>& points, const std::vector<std::uint32_t>& triangles, abut_sides sides) {
  auto options = filled_by(abut_mesh_options_init);
  options.sides = sides;
  abut_shape* mesh = nullptr;
  EXPECT_TRUE(succeeded(
      abut_mesh_create(points.data(), points.size() / 3, triangles.data(), triangles.size() / 3, &options, &mesh)));
  return Shape(mesh);
}

TEST(Routes, AreToldOfSurfaces) {
  const Shape ball = make_sphere(0.5);
  EXPECT_EQ(route_of(make_square_mesh(5), identity, ball, at(0.3, 0.2, 0.4)), ABUT_ALGORITHM_FLAT_GROUND);
  // A valley along Y.
  const Shape valley = mesh_of({-2, -2, 1, 0, -2, 0, 2, -2, 1, -2, 2, 1, 0, 2, 0, 2, 2, 1},
                               {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}, ABUT_SIDES_BOTH);
  EXPECT_EQ(route_of(valley, identity, ball, at(0.01, 0.2, 0.5)), ABUT_ALGORITHM_SEPARATING_TRANSLATION);
  const Shape wedge =
      mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, ABUT_SIDES_SOLID);
  EXPECT_EQ(route_of(wedge, identity, ball, at(0.2, 0.2, 0.2)), ABUT_ALGORITHM_SOLID);
}

TEST(Routes, AreToldOfConvexShapesFieldsAndHoles) {
  const Shape ball = make_sphere(0.5);
  EXPECT_EQ(route_of(ball, identity, ball, at(0.3, 0.2, 0.4)), ABUT_ALGORITHM_ANALYTIC);
  EXPECT_EQ(route_of(make_octahedron(0.5), identity, make_octahedron(0.5), at(2, 0.2, 0.4)), ABUT_ALGORITHM_GJK_EPA);
  const Shape field = make_of_kind("distance_field", {2, 2, 2, 1, 1, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 1, 1, 1});
  EXPECT_EQ(route_of(field, identity, ball, at(0.5, 0.5, 0.8)), ABUT_ALGORITHM_FIELD);
  EXPECT_EQ(route_of(sphere_hole(1), identity, make_octahedron(0.1), at(0.8, 0, 0)), ABUT_ALGORITHM_HOLE);
  const Shape block =
      make_composite({make_box(1, 1, 0.6), make_of_kind("cylinder_hole", {0.5, 0.7, 3})}, {identity, identity});
  EXPECT_EQ(route_of(block, identity, make_of_kind("cylinder", {0.45, 0.3}), at(0.055, 0, 0)), ABUT_ALGORITHM_HOLE);
}

TEST(Routes, AreToldOfRims) {
  const Shape box = make_box(0.5, 0.5, 0.5), cylinder = make_of_kind("cylinder", {0.5, 0.5});
  EXPECT_EQ(route_of(box, identity, cylinder, {{0.6, 0.5, 0.7}, {0.8, 0.6, 0, 0}}), ABUT_ALGORITHM_RIMS);
}

// A child that the algorithm does not know may be the nearest.
TEST(Routes, OfCompositesAreAnsweredForAllChildrenOrNone) {
  const Shape both = make_composite({make_sphere(0.5), make_octahedron(0.5)}, {at(-1, 0, 0), at(1, 0, 0)});
  const Shape ball = make_sphere(0.2);
  const abut_pose place = at(0.4, 0, 0);
  auto options = filled_by(abut_query_options_init);
  abut_distance found{};
  options.algorithm = ABUT_ALGORITHM_GJK_EPA;
  ASSERT_EQ(abut_pair_distance(both, &identity, ball, &place, &options, &found), ABUT_OK);
  EXPECT_NEAR(found.distance, -0.1, 1e-9);
  options.algorithm = ABUT_ALGORITHM_ANALYTIC;
  EXPECT_EQ(abut_pair_distance(both, &identity, ball, &place, &options, &found), ABUT_UNSUPPORTED);
  abut_contact contacts[8];
  std::size_t count = 0;
  EXPECT_EQ(abut_pair_contacts(both, &identity, ball, &place, &options, contacts, 8, &count), ABUT_UNSUPPORTED);
}

}  // namespace
