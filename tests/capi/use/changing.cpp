// SPDX-License-Identifier: Apache-2.0
// Geometries that change: another shape, other options, sensors and materials.
#include "support.hpp"

namespace {

using namespace abut_test;

// A box on a floor.
struct Standing {
  Standing() {
    floor = universe.add(slab, at(0, 0, -1), ABUT_MOTION_STATIC);
    part = universe.add_part(at(0, 0, 0.99));
    block = universe.add_geometry(part, cube);
  }
  // The letters of the events of a step.
  std::string step() {
    universe.step();
    return letters_of(universe.events());
  }

  Shape slab = make_box(4, 4, 1);
  Shape cube = make_box(1, 1, 1);
  Universe universe;
  abut_geometry_id floor{}, block{};
  abut_part_id part{};
};

TEST(SetShape, EndsContactsAndBeginsNewOnes) {
  Standing scene;
  EXPECT_EQ(scene.step(), "b");
  EXPECT_EQ(scene.step(), "p");
  const std::vector<std::uint64_t> values(4, 7);
  ASSERT_TRUE(succeeded(abut_contacts_set_user_data(scene.universe, values.data(), 4)));
  const Shape ball = make_sphere(1.0);
  ASSERT_TRUE(succeeded(abut_geometry_set_shape(scene.universe, scene.block, ball)));
  EXPECT_EQ(scene.universe.contacts().size(), 4U) << "those of the last step stay until the next one";
  EXPECT_EQ(scene.step(), "eb");
  ASSERT_EQ(scene.universe.contacts().size(), 1U);
  EXPECT_EQ(scene.universe.contacts().at(0).age, 0U);
  EXPECT_EQ(scene.universe.contacts().at(0).user_data, 0U);
  EXPECT_EQ(scene.step(), "p");
  EXPECT_EQ(scene.universe.contacts().at(0).age, 1U);
}

// A box for a box has the same features, but they are others.
TEST(SetShape, NothingLivesOnInAShapeOfTheSameKind) {
  Standing scene;
  EXPECT_EQ(scene.step(), "b");
  const Shape other = make_box(0.5, 0.5, 1);
  ASSERT_TRUE(succeeded(abut_geometry_set_shape(scene.universe, scene.block, other)));
  EXPECT_EQ(scene.step(), "eb");
  ASSERT_EQ(scene.universe.contacts().size(), 4U);
  for (const abut_contact& contact : scene.universe.contacts()) {
    EXPECT_EQ(contact.age, 0U);
    EXPECT_NEAR(std::abs(contact.point_b.x), 0.5, 1e-12);
  }
}

TEST(SetShape, EndsWhatANarrowerShapeDoesNotReach) {
  Standing scene;
  EXPECT_EQ(scene.step(), "b");
  const Shape crumb = make_sphere(0.25);
  ASSERT_TRUE(succeeded(abut_geometry_set_shape(scene.universe, scene.block, crumb)));
  EXPECT_EQ(scene.step(), "e");
  ASSERT_TRUE(succeeded(abut_geometry_set_shape(scene.universe, scene.block, scene.cube)));
  EXPECT_EQ(scene.step(), "b");
}

TEST(SetShape, IsDescribedAndKeptAlive) {
  Standing scene;
  {
    const Shape ball = make_sphere(0.75);
    const std::array<abut_geometry_id, 2> ids{scene.block, scene.floor};
    const std::array<const abut_shape*, 2> shapes{ball, ball};
    abut_revision before{}, after{};
    ASSERT_TRUE(succeeded(abut_universe_revision(scene.universe, &before)));
    ASSERT_TRUE(succeeded(abut_geometries_set_shapes(scene.universe, ids.data(), shapes.data(), 2)));
    ASSERT_TRUE(succeeded(abut_universe_revision(scene.universe, &after)));
    EXPECT_GT(after.geometries, before.geometries);
    EXPECT_EQ(scene.universe.describe(scene.floor).shape, ball);
  }
  const abut_geometry_info info = scene.universe.describe(scene.block);
  EXPECT_STREQ(abut_shape_kind_name(info.kind), "sphere");
  double radius = 0;
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_shape_parameters(info.shape, &radius, 1, &count))) << "the universe owns it";
  EXPECT_EQ(radius, 0.75);
}

TEST(SetOptions, ReplacesThemAll) {
  Standing scene;
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_SENSOR;
  options.pose = at(0, 0, 0.25);
  options.tolerance = 0.125;
  options.user_data = 11;
  options.layers = 12;
  options.mask = 13;
  options.exclusion = 14;
  options.label = 15;
  options.tag = 63;
  options.material = 17;
  options.parking = ABUT_PARKING_LONG_TERM;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(scene.universe, scene.block, &options)));
  const abut_geometry_info info = scene.universe.describe(scene.block);
  EXPECT_EQ(info.flags, abut_geometry_flags{ABUT_GEOMETRY_SENSOR});
  EXPECT_EQ(info.local.position.z, 0.25);
  EXPECT_NEAR(info.pose.position.z, 1.24, 1e-12);
  EXPECT_EQ(info.tolerance, 0.125);
  EXPECT_EQ(info.user_data, 11U);
  EXPECT_EQ(info.layers, 12U);
  EXPECT_EQ(info.mask, 13U);
  EXPECT_EQ(info.exclusion, 14U);
  EXPECT_EQ(info.label, 15U);
  EXPECT_EQ(info.tag, 63U);
  EXPECT_EQ(info.material, 17U);
  EXPECT_EQ(info.parking, abut_parking{ABUT_PARKING_LONG_TERM});
  EXPECT_EQ(info.reserved, 0U);
  EXPECT_TRUE(info.part == scene.part);
}

TEST(SetOptions, TakesEffectAtTheNextStep) {
  Standing scene;
  EXPECT_EQ(scene.step(), "b");
  abut_geometry_options options = default_geometry_options();
  options.pose = at(0, 0, 0.005);
  ASSERT_TRUE(succeeded(abut_geometry_set_options(scene.universe, scene.block, &options)));
  EXPECT_EQ(scene.step(), "p");
  EXPECT_NEAR(scene.universe.contacts().at(0).distance, -0.005, 1e-12);
  EXPECT_EQ(scene.universe.contacts().at(0).age, 1U) << "it is still the same shape";
  options.tolerance = 0.0625;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(scene.universe, scene.block, &options)));
  EXPECT_EQ(scene.step(), "e") << "the dead band is wider than the overlap";
}

TEST(Sensors, AreFlaggedInContactsAndEvents) {
  for (const bool is_first : {true, false}) {
    Standing scene;
    abut_geometry_options options = default_geometry_options();
    options.flags = ABUT_GEOMETRY_SENSOR;
    ASSERT_TRUE(succeeded(abut_geometry_set_options(scene.universe, is_first ? scene.floor : scene.block, &options)));
    for (const char* letters : {"b", "p"}) {
      EXPECT_EQ(scene.step(), letters);
      EXPECT_EQ(scene.universe.events().at(0).flags, abut_event_flags{ABUT_EVENT_SENSOR});
      ASSERT_EQ(scene.universe.contacts().size(), 4U);
      for (const abut_contact& contact : scene.universe.contacts())
        EXPECT_EQ(contact.flags, abut_contact_flags{ABUT_CONTACT_SENSOR});
    }
    scene.universe.move(scene.part, at(0, 0, 5));
    EXPECT_EQ(scene.step(), "e");
    EXPECT_EQ(scene.universe.events().at(0).flags, abut_event_flags{ABUT_EVENT_SENSOR});
  }
  Standing scene;
  EXPECT_EQ(scene.step(), "b");
  EXPECT_EQ(scene.universe.events().at(0).flags, 0U);
  EXPECT_EQ(scene.universe.contacts().at(0).flags, 0U);
}

TEST(Materials, AreThoseOfTheGeometries) {
  Standing scene;
  abut_geometry_options options = default_geometry_options();
  options.material = 3;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(scene.universe, scene.floor, &options)));
  options.material = 0xFFFFFFFF;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(scene.universe, scene.block, &options)));
  scene.step();
  ASSERT_EQ(scene.universe.contacts().size(), 4U);
  for (const abut_contact& contact : scene.universe.contacts()) {
    EXPECT_EQ(contact.material_a, 3U);
    EXPECT_EQ(contact.material_b, 0xFFFFFFFFU);
  }
}

}  // namespace
