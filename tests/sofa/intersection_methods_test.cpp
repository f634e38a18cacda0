// SPDX-License-Identifier: Apache-2.0
// Intersection methods of SOFA and their data, by the names that docs/sofa.md gives for them.
#include <algorithm>
#include <cmath>

#include "worlds.hpp"

namespace {

using namespace sofa_names;

// A square, and a tip an eighth above the face under it.
struct SquareAndTip {
  Elements a = elements_of(square()), b = elements_of(tip(0.5, -0.5, 0.125));
};
// Two squares above each other, turned so that edges pass over edges and no corner over a corner.
struct TwoSquares {
  Elements a = elements_of(square()),
           b = elements_of(
               mesh_of({0.3, -0.9, 0.125, 1.3, 0.1, 0.125, 0.3, 1.1, 0.125, -0.7, 0.1, 0.125}, {0, 1, 2, 0, 2, 3}));
};

abut_policy by_elements(double alarm) {
  auto policy = filled_by(abut_policy_init);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = alarm;
  return policy;
}

TEST(IntersectionMethods, DiscreteIntersection) {
  const Elements ground = elements_of(square());
  const auto options = filled_by(abut_elements_options_init);
  for (const double z : {0.125, -0.125}) {
    const auto crossings = found(abut_elements_crossings, ground, elements_of(tip(0.5, -0.5, z)), options);
    EXPECT_EQ(crossings.size(), z < 0 ? 2U : 0U);
    for (const abut_crossing& its : crossings) EXPECT_EQ(its.point.z, 0);
  }
  // Shapes with an inside have contacts.
  World world;
  world.add(ball(0.5), at(0, 0, 0));
  world.add(block(0.5), at(0.9, 0, 0));
  const abut_contact* contacts = nullptr;
  std::size_t count = 0;
  world.step();
  require(abut_universe_contacts(world.get(), &contacts, &count));
  ASSERT_EQ(count, 1U);
  EXPECT_NEAR(contacts[0].distance, -0.1, 1e-12);
}

// A vertex above a face, and one above a diagonal: once each.
TEST(IntersectionMethods, MinProximityIntersection) {
  const SquareAndTip pair;
  auto stencils = closest(pair.a, pair.b, within(0.25, ABUT_CLOSEST_ALL));
  EXPECT_EQ(count_of(stencils, ABUT_STENCIL_VERTEX_FACE), 1U);
  // The tip is also that near an edge of the other face.
  stencils = closest(pair.a, elements_of(tip(0.5, 0.4375, 0.125)), within(0.25, ABUT_CLOSEST_ALL));
  EXPECT_EQ(count_of(stencils, ABUT_STENCIL_VERTEX_FACE), 1U);
  EXPECT_EQ(count_of(stencils, ABUT_STENCIL_VERTEX_EDGE), 1U);
  EXPECT_GT(count_of(closest(TwoSquares().a, TwoSquares().b, within(0.25, ABUT_CLOSEST_ALL)), ABUT_STENCIL_EDGE_EDGE),
            0U);
}

// Of each vertex the nearest feature only, and no pairs of edges.
TEST(IntersectionMethods, NewProximityIntersection) {
  const SquareAndTip pair;
  const auto stencils = closest(pair.a, elements_of(tip(0.5, 0.4375, 0.125)), within(0.25, ABUT_CLOSEST_OF_VERTICES));
  ASSERT_EQ(stencils.size(), 1U);
  EXPECT_EQ(stencils[0].kind, abut_stencil_kind{ABUT_STENCIL_VERTEX_FACE});
  const TwoSquares squares;
  EXPECT_EQ(count_of(closest(squares.a, squares.b, within(0.25, ABUT_CLOSEST_OF_VERTICES)), ABUT_STENCIL_EDGE_EDGE),
            0U);
}

// Flat on flat has vertices; edges of a flat sheet fold nowhere, so pairs of them are left out inside of it.
TEST(IntersectionMethods, LocalMinDistance) {
  const Elements top = elements_of(mesh_of({-0.3, -0.5, 0.125, 0.3, -0.5, 0.125, 0.1, 0.5, 0.125}, {0, 1, 2}));
  const Elements ground = elements_of(square());
  const auto stencils = closest(ground, top, within(0.25, ABUT_CLOSEST_LOCAL_MINIMA));
  EXPECT_EQ(stencils.size(), 3U);
  EXPECT_EQ(count_of(stencils, ABUT_STENCIL_EDGE_EDGE), 0U);
  EXPECT_GT(count_of(closest(ground, top, within(0.25, ABUT_CLOSEST_ALL)), ABUT_STENCIL_EDGE_EDGE), 0U);
}

// The least of the fifteen pairs of two triangles.
TEST(IntersectionMethods, ProximityIntersection) {
  const Elements a = elements_of(mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2})),
                 b = elements_of(tip(0.25, 0.25, 0.125));
  const auto stencils = closest(a, b, within(2, ABUT_CLOSEST_OF_FACES));
  ASSERT_EQ(stencils.size(), 1U);
  EXPECT_EQ(stencils[0].distance, 0.125);
  EXPECT_GT(closest(a, b, within(2, ABUT_CLOSEST_ALL)).size(), 1U);
}

TEST(IntersectionMethods, ContinuousIntersection) {
  const SquareAndTip pair;
  std::vector<double> start{0.5, -0.5, 0.125, 0.8, -0.5, 1.125, 0.5, -0.2, 1.125}, end = start;
  for (std::size_t i = 2; i < end.size(); i += 3) end[i] -= 0.5;
  require(abut_elements_set_vertices(pair.b.get(), start.data(), end.data(), 3));
  const auto touches = found(abut_elements_first_touches, pair.a, pair.b, within(0));
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_NEAR(touches[0].toi, 0.25, 1e-9);
}

// Both sides of a step are outside of the ground: only the way between passes through it.
TEST(IntersectionMethods, CCDTightInclusionIntersection) {
  World world;
  auto policy = filled_by(abut_policy_init);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = 0;
  require(abut_policy_set(world.get(), 0, 0, &policy));
  world.add(square(), at(0, 0, 0), 0, ABUT_MOTION_STATIC);
  auto options = filled_by(abut_geometry_options_init);
  options.flags = ABUT_GEOMETRY_FAST;
  const abut_part_id body = world.part(at(0.5, -0.5, 1));
  world.put(body, tip(0, 0, 0), options);
  world.step();
  EXPECT_TRUE(world.element_contacts().empty());
  world.move(body, at(0.5, -0.5, -3));
  world.step();
  double first = 1;
  for (const abut_element_contact& its : world.element_contacts()) first = std::min(first, its.stencil.toi);
  EXPECT_NEAR(first, 0.25, 1e-9);
}

TEST(IntersectionMethods, AlarmDistance) {
  for (const double tolerance : {0.12, 0.13}) {
    World world;
    abut_policy policy = by_elements(0);
    policy.tolerance = tolerance;
    require(abut_policy_set(world.get(), 0, 0, &policy));
    world.add(square(), at(0, 0, 0));
    world.add(tip(0.5, -0.5, 0.125), at(0, 0, 0));
    world.step();
    EXPECT_EQ(world.element_contacts().size(), tolerance < 0.125 ? 0U : 1U);
  }
}

TEST(IntersectionMethods, ContactDistance) {
  World world;
  abut_policy policy = by_elements(0.25);
  policy.contact_distance = 0.0625;
  require(abut_policy_set(world.get(), 0, 0, &policy));
  world.add(square(), at(0, 0, 0));
  world.add(tip(0.5, -0.5, 0.125), at(0, 0, 0));
  world.step();
  ASSERT_EQ(world.element_contacts().size(), 1U);
  EXPECT_EQ(world.element_contacts()[0].gap, 0.0625);
}

TEST(IntersectionMethods, UseLineLine) {
  const TwoSquares squares;
  auto options = within(0.25, ABUT_CLOSEST_ALL);
  options.kinds = 1U << ABUT_STENCIL_EDGE_EDGE;
  const auto lines = closest(squares.a, squares.b, options);
  EXPECT_EQ(count_of(lines, ABUT_STENCIL_EDGE_EDGE), lines.size());
  EXPECT_GT(lines.size(), 0U);
  options.kinds = ~(1U << ABUT_STENCIL_EDGE_EDGE) & 15U;
  const auto others = closest(squares.a, squares.b, options);
  EXPECT_EQ(count_of(others, ABUT_STENCIL_EDGE_EDGE), 0U);
  options.kinds = 0;
  EXPECT_EQ(closest(squares.a, squares.b, options).size(), lines.size() + others.size());
}

TEST(IntersectionMethods, UseSphereTriangle) {
  World world;
  auto options = filled_by(abut_geometry_options_init);
  options.label = 1;
  world.put(world.part(at(0, 0, 0.25)), ball(0.5), options);
  options.label = 2;
  world.put(world.part(at(0, 0, 0)), square(), options);
  EXPECT_EQ(world.step().size(), 1U);
  const abut_collidable spheres{ABUT_COLLIDABLE_LABEL, 1, 0}, triangles{ABUT_COLLIDABLE_LABEL, 2, 0};
  require(abut_rule_set(world.get(), &spheres, &triangles, ABUT_RULE_DISABLE));
  EXPECT_TRUE(world.step().empty());
}

// A triangle that lies aslant above the ground: its lowest corner alone, unless cones are wide.
TEST(IntersectionMethods, AngleCone) {
  const Elements ground = elements_of(square()),
                 aslant = elements_of(mesh_of({0, -0.5, 0.1, 0.5, -0.5, 0.15, 0.5, -0.1, 0.2}, {0, 1, 2}));
  auto options = within(0.25, ABUT_CLOSEST_LOCAL_MINIMA);
  options.cone_angle = 0;
  EXPECT_EQ(closest(ground, aslant, options).size(), 1U);
  options.cone_angle = 0.5;
  EXPECT_EQ(closest(ground, aslant, options).size(), 3U);
}

// The corner (0.5, 0, 0.15) points down, and an edge leads from it to a corner that is a bit lower. The slope of its
// faces lets it see the ground all the same.
TEST(IntersectionMethods, ConeFactor) {
  const Elements ground = elements_of(square()),
                 above = elements_of(mesh_of({-0.5, 0, 0.14, 0.5, 0, 0.15, 0.9, 0.5, 1.1, 0.9, -0.5, 1.1},
                                             {0, 1, 2, 1, 3, 2, 0, 3, 1}));
  auto options = within(0.2, ABUT_CLOSEST_LOCAL_MINIMA);
  options.cone_factor = 0;
  EXPECT_EQ(closest(ground, above, options).size(), 1U);
  options.cone_factor = 0.5;
  EXPECT_EQ(closest(ground, above, options).size(), 2U);
}

// Without cones the rim counts as well.
TEST(IntersectionMethods, FilterIntersection) {
  const TwoSquares squares;
  EXPECT_GT(closest(squares.a, squares.b, within(0.25, ABUT_CLOSEST_FEATURES)).size(),
            closest(squares.a, squares.b, within(0.25, ABUT_CLOSEST_LOCAL_MINIMA)).size());
}

TEST(IntersectionMethods, ContinuousCollisionType) {
  const SquareAndTip pair;
  const std::vector<double> start{0.5, -0.5, 0.125, 0.8, -0.5, 1.125, 0.5, -0.2, 1.125};
  // None: nothing moves.
  require(abut_elements_set_vertices(pair.b.get(), start.data(), nullptr, 3));
  EXPECT_TRUE(found(abut_elements_first_touches, pair.a, pair.b, within(0)).empty());
  // Inertia: on by a velocity. FreeMotion: to free positions.
  constexpr double dt = 0.5, velocity = -1;
  std::vector<double> end = start;
  for (std::size_t i = 2; i < end.size(); i += 3) end[i] += dt * velocity;
  require(abut_elements_set_vertices(pair.b.get(), start.data(), end.data(), 3));
  EXPECT_EQ(found(abut_elements_first_touches, pair.a, pair.b, within(0)).size(), 1U);
}

TEST(IntersectionMethods, Tolerance) {
  const SquareAndTip pair;
  const std::vector<double> start{0.5, -0.5, 0.125, 0.8, -0.5, 1.125, 0.5, -0.2, 1.125};
  std::vector<double> end = start;
  for (std::size_t i = 2; i < end.size(); i += 3) end[i] -= 0.5;
  require(abut_elements_set_vertices(pair.b.get(), start.data(), end.data(), 3));
  for (const double tolerance : {1e-3, 1e-9}) {
    auto options = within(0.0625);
    options.tolerance = tolerance;
    const auto touches = found(abut_elements_first_touches, pair.a, pair.b, options);
    ASSERT_EQ(touches.size(), 1U);
    EXPECT_LE(touches[0].toi, 0.125);
    EXPECT_NEAR(touches[0].toi, 0.125, 2 * tolerance / 0.5);
  }
}

// A vertex above the diagonal of two triangles is told once, by the edge that both share.
TEST(IntersectionMethods, FLAGPOINTS) {
  const Elements ground = elements_of(square()), above = elements_of(tip(0.25, 0.25, 0.125));
  auto options = within(0.15, ABUT_CLOSEST_FEATURES);
  std::array<abut_stencil, 8> stencils{};
  std::size_t count = 0;
  require(abut_elements_closest(ground.get(), above.get(), &options, stencils.data(), stencils.size(), &count));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(stencils[0].kind, abut_stencil_kind{ABUT_STENCIL_VERTEX_EDGE});
}

TEST(IntersectionMethods, FindIntersector) {
  const auto kind = [](const char* name) { return abut_shape_kind_by_name(name); };
  std::uint32_t is_supported = 0;
  require(abut_pair_support(kind("sphere"), kind("mesh"), ABUT_QUERY_CONTACTS, &is_supported));
  EXPECT_EQ(is_supported, 1U);
  require(abut_pair_support(kind("plane"), kind("plane"), ABUT_QUERY_CONTACTS, &is_supported));
  EXPECT_EQ(is_supported, 0U);
}

// The same with the sides swapped.
TEST(IntersectionMethods, MirrorIntersector) {
  const Shape box = block(0.5), sphere = ball(0.5);
  const abut_pose origin = at(0, 0, 0), beside = at(1.5, 0.25, 0);
  abut_distance one{}, other{};
  require(abut_pair_distance(box.get(), &origin, sphere.get(), &beside, nullptr, &one));
  require(abut_pair_distance(sphere.get(), &beside, box.get(), &origin, nullptr, &other));
  EXPECT_EQ(one.distance, other.distance);
  EXPECT_EQ(one.normal.x, -other.normal.x);
  EXPECT_EQ(one.point_a.x, other.point_b.x);
}

}  // namespace
