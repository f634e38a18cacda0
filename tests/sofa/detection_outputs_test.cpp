// SPDX-License-Identifier: Apache-2.0
// Detection outputs of SOFA and contact mappers, by the names that docs/sofa.md gives for them.
#include <algorithm>
#include <cmath>
#include <set>

#include "worlds.hpp"

namespace {

using namespace sofa_names;

// Two balls that overlap by a quarter along x.
struct TwoBalls {
  World world;
  abut_geometry_id first = world.add(ball(0.5), at(0, 0, 0)), second = world.add(ball(0.5), at(0.75, 0, 0));
  abut_contact contact = world.step()[0];
};

TEST(DetectionOutputs, DetectionOutput) {
  const TwoBalls balls;
  const abut_contact* contacts = nullptr;
  std::size_t count = 0;
  require(abut_universe_contacts(balls.world.get(), &contacts, &count));
  ASSERT_EQ(count, 1U);
  require(abut_contact_validate(contacts));
}

TEST(DetectionOutputs, Elem) {
  World world;
  world.add(square(), at(0, 0, 0));
  world.add(ball(0.25), at(-0.5, 0.5, 0.2));
  const auto contacts = world.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].feature_a.kind, abut_feature_kind{ABUT_FEATURE_FACE});
  EXPECT_EQ(contacts[0].feature_a.index, 1U);
  EXPECT_EQ(contacts[0].feature_b.kind, abut_feature_kind{ABUT_FEATURE_VERTEX});
}

TEST(DetectionOutputs, Id) {
  World world;
  world.add(block(0.5), at(0, 0, 0), 0, ABUT_MOTION_STATIC);
  const abut_part_id body = world.part(at(0.05, 0.03, 0.9));
  world.put(body, block(0.5));
  std::set<std::uint64_t> before, after;
  for (const abut_contact& its : world.step()) before.insert(its.id);
  world.move(body, at(0.07, 0.04, 0.9));
  for (const abut_contact& its : world.step()) after.insert(its.id);
  EXPECT_EQ(before.size(), 4U);
  EXPECT_EQ(before, after);
}

TEST(DetectionOutputs, Point) {
  const abut_contact its = TwoBalls().contact;
  EXPECT_NEAR(its.point_a.x, 0.5, 1e-12);
  EXPECT_NEAR(its.point_b.x, 0.25, 1e-12);
}

TEST(DetectionOutputs, Normal) {
  const abut_contact its = TwoBalls().contact;
  EXPECT_NEAR(its.normal.x, 1, 1e-12) << "from a to b";
}

// The distance, without the contact distance; the gap of element contacts is less that.
TEST(DetectionOutputs, Value) {
  EXPECT_NEAR(TwoBalls().contact.distance, -0.25, 1e-12);
  World world;
  auto policy = filled_by(abut_policy_init);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = 0.25;
  policy.contact_distance = 0.0625;
  require(abut_policy_set(world.get(), 0, 0, &policy));
  world.add(square(), at(0, 0, 0));
  world.add(tip(0.5, -0.5, 0.125), at(0, 0, 0));
  world.step();
  ASSERT_EQ(world.element_contacts().size(), 1U);
  EXPECT_EQ(world.element_contacts()[0].gap, 0.125 - 0.0625);
}

TEST(DetectionOutputs, DeltaT) {
  World world;
  world.add(block(0.5), at(3, 0, 0), 0, ABUT_MOTION_STATIC);
  auto options = filled_by(abut_geometry_options_init);
  options.flags = ABUT_GEOMETRY_FAST;
  const abut_part_id body = world.part(at(0, 0, 0));
  world.put(body, ball(0.5), options);
  const abut_velocity velocity{{4, 0, 0}, {0, 0, 0}};
  require(abut_part_set_velocity(world.get(), body, &velocity));
  const auto contacts = world.step(1);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].toi, 0.5, 1e-6);
}

// Records of a second form, and records in an array of the caller.
TEST(DetectionOutputs, DetectionOutputVector) {
  World world;
  auto policy = filled_by(abut_policy_init);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = 0.25;
  require(abut_policy_set(world.get(), 0, 0, &policy));
  const Shape ground = square(), above = tip(0.5, -0.5, 0.125);
  world.add(ground, at(0, 0, 0));
  world.add(above, at(0, 0, 0));
  world.step();
  const abut_element_contact* contacts = nullptr;
  std::size_t count = 0;
  require(abut_universe_element_contacts(world.get(), &contacts, &count));
  ASSERT_EQ(count, 1U);
  const auto options = within(0.25);
  std::vector<abut_stencil> mine(1);
  require(abut_elements_closest(elements_of(ground).get(), elements_of(above).get(), &options, mine.data(), mine.size(),
                                &count));
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(mine[0].distance, contacts[0].stencil.distance);
}

TEST(DetectionOutputs, ContactIdentifier) {
  TwoBalls balls;
  const std::uint64_t mine = 42;
  require(abut_contacts_set_user_data(balls.world.get(), &mine, 1));
  const auto contacts = balls.world.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].user_data, 42U);
  EXPECT_EQ(contacts[0].age, 1U);
}

// A force along the normal that goes to vertices by their weights has neither a sum nor a moment.
TEST(DetectionOutputs, BarycentricContactMapper) {
  const std::vector<double> above{0.5, -0.5, 0.125, 0.8, -0.5, 1.125, 0.5, -0.2, 1.125};
  const auto stencils = closest(elements_of(square()), elements_of(mesh_of(above, {0, 1, 2})), within(0.25));
  ASSERT_EQ(stencils.size(), 1U);
  const abut_stencil& its = stencils[0];
  double force = 0, about_x = 0, about_y = 0, way = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double* xyz = (i < its.of_a ? square_xyz : above).data() + std::size_t{3} * its.vertices[i];
    force += its.weights[i];
    about_x += its.weights[i] * xyz[1];
    about_y -= its.weights[i] * xyz[0];
    way += its.weights[i] * xyz[2];
  }
  EXPECT_EQ(its.normal.z, 1);
  EXPECT_NEAR(force, 0, 1e-15);
  EXPECT_NEAR(about_x, 0, 1e-15);
  EXPECT_NEAR(about_y, 0, 1e-15);
  EXPECT_NEAR(way, its.distance, 1e-15);
}

TEST(DetectionOutputs, RigidContactMapper) {
  auto options = filled_by(abut_universe_options_init);
  options.flags = ABUT_UNIVERSE_LOCAL_POINTS;
  World world(options);
  world.add(ball(0.5), at(7, 0, 0));
  world.add(ball(0.5), at(7.75, 0, 0));
  EXPECT_EQ(world.step().size(), 1U);
  const abut_local_points* points = nullptr;
  std::size_t count = 0;
  require(abut_universe_local_points(world.get(), &points, &count));
  ASSERT_EQ(count, 1U);
  EXPECT_NEAR(points[0].a.x, 0.5, 1e-12);
  EXPECT_NEAR(points[0].b.x, -0.5, 1e-12);
}

}  // namespace
