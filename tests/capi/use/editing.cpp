// SPDX-License-Identifier: Apache-2.0
// Shapes that change while geometries have them: what becomes of contacts, of other holders and of those who sleep.
#include <cmath>

#include "sleep_room.hpp"

namespace {

using namespace abut_test;

std::vector<double> parameters_of(const abut_shape* shape) {
  std::vector<double> parameters(16);
  std::size_t count = 0;
  require(abut_shape_parameters(shape, parameters.data(), parameters.size(), &count));
  parameters.resize(count);
  return parameters;
}

testing::AssertionResult resize(abut_universe* universe, abut_geometry_id geometry,
                                const std::vector<double>& parameters) {
  return succeeded(abut_geometry_set_parameters(universe, geometry, parameters.data(), parameters.size()));
}

std::uint64_t geometry_revision(const abut_universe* universe) {
  abut_revision revision{};
  require(abut_universe_revision(universe, &revision));
  return revision.geometries;
}

abut_universe_options contact_events() {
  abut_universe_options options = default_universe_options();
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
  return options;
}

// A cube of side 2 that stands on a floor at z = 0.
struct Standing {
  Standing() {
    universe.add(make_box(4, 4, 1), at(0, 0, -1), ABUT_MOTION_STATIC);
    part = universe.add_part(at(0, 0, 1));
    cube = universe.add_geometry(part, make_box(1, 1, 1));
  }
  std::string step() {
    universe.step();
    return letters_of(universe.events());
  }

  abut_universe_options options = contact_events();
  Universe universe{&options};
  abut_part_id part{};
  abut_geometry_id cube{};
};

TEST(SetParameters, KeepsContactsWhoseFeaturesSurvive) {
  Standing scene;
  EXPECT_EQ(scene.step(), "bbcbcbcbc");
  const std::vector<std::uint64_t> values{7, 8, 9, 10};
  ASSERT_TRUE(succeeded(abut_contacts_set_user_data(scene.universe, values.data(), values.size())));
  const std::vector<abut_contact> before = scene.universe.contacts();
  ASSERT_TRUE(resize(scene.universe, scene.cube, {0.5, 0.75, 1}));
  EXPECT_EQ(scene.universe.contacts().size(), 4U) << "those of the last step stay until the next one";
  EXPECT_EQ(scene.step(), "ppcpcpcpc") << "a resize ends no contact that still touches";
  const std::vector<abut_contact> after = scene.universe.contacts();
  ASSERT_EQ(after.size(), 4U);
  for (const abut_contact& contact : after) {
    const auto same =
        std::find_if(before.begin(), before.end(), [&](const abut_contact& each) { return each.id == contact.id; });
    ASSERT_NE(same, before.end());
    EXPECT_EQ(contact.age, 1U);
    EXPECT_EQ(contact.user_data, values.at(static_cast<std::size_t>(same - before.begin())));
    EXPECT_EQ(std::abs(contact.point_b.x), 0.5);
    EXPECT_EQ(std::abs(contact.point_b.y), 0.75);
  }
}

TEST(SetParameters, EndsWhatNoLongerTouches) {
  Standing scene;
  scene.step();
  ASSERT_TRUE(resize(scene.universe, scene.cube, {1, 1, 0.5}));
  EXPECT_EQ(scene.step(),
            "eececec"
            "ec");
  ASSERT_TRUE(resize(scene.universe, scene.cube, {1, 1, 1.5}));
  EXPECT_EQ(scene.step(), "bbcbcbcbc");
  EXPECT_NEAR(scene.universe.contacts().at(0).distance, -0.5, 1e-12);
}

TEST(SetParameters, IsSeenByQueriesAfterARefresh) {
  Standing scene;
  scene.step();
  ASSERT_TRUE(resize(scene.universe, scene.cube, {1, 1, 3}));
  require(abut_universe_refresh(scene.universe));
  const abut_ray ray{{0, 0, 10}, {0, 0, -1}, 20};
  abut_query_hit hit{};
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_cast_ray(scene.universe, &ray, nullptr, ABUT_HIT_NEAREST, &hit, 1, &count)));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(hit.distance, 6);
}

TEST(SetParameters, MovesTheRevision) {
  Standing scene;
  const std::uint64_t before = geometry_revision(scene.universe);
  ASSERT_TRUE(resize(scene.universe, scene.cube, {1, 2, 3}));
  EXPECT_GT(geometry_revision(scene.universe), before);
}

TEST(SetParameters, LeavesOtherHoldersAsTheyWere) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const Shape two = make_composite({ball, ball}, {identity, at(3, 0, 0)});
  const abut_geometry_id one = universe.add(ball, at(0, 0, 0)), other = universe.add(ball, at(10, 0, 0));
  const abut_geometry_id both = universe.add(two, at(20, 0, 0));
  ASSERT_TRUE(resize(universe, one, {0.25}));
  EXPECT_EQ(parameters_of(universe.describe(one).shape), std::vector{0.25});
  EXPECT_EQ(parameters_of(ball), std::vector{1.0});
  EXPECT_EQ(universe.describe(other).shape, ball);
  abut_aabb box{};
  require(abut_shape_aabb(universe.describe(both).shape, &identity, &box));
  EXPECT_EQ(box.minimum.x, -1);
}

// In place also where a composite is a holder besides the handle that the caller has let go.
TEST(SetParameters, LeavesACompositeOfTheShapeAsItWas) {
  Universe universe;
  Shape ball = make_sphere(1.0);
  const Shape two = make_composite({ball, ball}, {identity, at(3, 0, 0)});
  const abut_geometry_id one = universe.add(ball, at(0, 0, 0));
  ball = Shape();
  ASSERT_TRUE(resize(universe, one, {0.25}));
  EXPECT_EQ(parameters_of(universe.describe(one).shape), std::vector{0.25});
  abut_aabb box{};
  require(abut_shape_aabb(two, &identity, &box));
  EXPECT_EQ(box.minimum.x, -1);
}

TEST(SetParameters, KeepsTheHandleThatNobodyElseHolds) {
  Universe universe;
  const abut_geometry_id geometry = universe.add(make_sphere(1.0), identity);
  const abut_shape* const lent = universe.describe(geometry).shape;
  ASSERT_TRUE(resize(universe, geometry, {2}));
  EXPECT_EQ(universe.describe(geometry).shape, lent);
  EXPECT_EQ(parameters_of(lent), std::vector{2.0});
  abut_shape* taken = nullptr;
  ASSERT_TRUE(succeeded(abut_geometry_shape(universe, geometry, &taken)));
  const Shape held(taken);
  EXPECT_EQ(taken, lent);
  ASSERT_TRUE(resize(universe, geometry, {3}));
  EXPECT_NE(universe.describe(geometry).shape, lent);
  EXPECT_EQ(parameters_of(held), std::vector{2.0}) << "whoever holds a shape sees no change";
  EXPECT_EQ(parameters_of(universe.describe(geometry).shape), std::vector{3.0});
}

TEST(SetParameters, GoesForParkedGeometries) {
  for (const abut_parking parking : {ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}) {
    Standing scene;
    scene.step();
    scene.universe.park(scene.cube, parking);
    ASSERT_TRUE(resize(scene.universe, scene.cube, {1, 1, 0.25}));
    EXPECT_EQ(scene.step(),
              "eececec"
              "ec");
    scene.universe.park(scene.cube, ABUT_PARKING_NONE);
    EXPECT_EQ(scene.step(), "") << "it is smaller now";
    scene.universe.park(scene.cube, parking);
    ASSERT_TRUE(resize(scene.universe, scene.cube, {1, 1, 1}));
    scene.universe.park(scene.cube, ABUT_PARKING_NONE);
    EXPECT_EQ(scene.step(), "bbcbcbcbc");
  }
}

TEST(SetParameters, OfABatchTheLastOneCounts) {
  Universe universe;
  const abut_geometry_id one = universe.add(make_box(1, 1, 1), identity),
                         other = universe.add(make_box(1, 1, 1), at(9, 0, 0));
  const std::array ids{one, other, one};
  const std::array<double, 9> sizes{1, 2, 3, 4, 5, 6, 7, 8, 9};
  ASSERT_TRUE(succeeded(abut_geometries_set_parameters(universe, ids.data(), sizes.data(), 3, 3)));
  EXPECT_EQ(parameters_of(universe.describe(one).shape), (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(parameters_of(universe.describe(other).shape), (std::vector<double>{4, 5, 6}));
}

TEST(SetParameters, WakesTheIsland) {
  Room room;
  const auto stack = room.add_stack(3);
  room.step(until_asleep);
  ASSERT_EQ(room.asleep(), 3U);
  ASSERT_TRUE(resize(room.universe, room.boxes[2], {0.4, 0.4, 0.5}));
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
}

TEST(SetHeights, WakesWhatStandsOnTheField) {
  Room room;
  const abut_part_id ground = room.universe.add_part(at(9, 9, 0), ABUT_MOTION_STATIC);
  const abut_geometry_id terrain =
      room.universe.add_geometry(ground, make_of_kind("height_field", {3, 3, 1, 1}, std::vector(9, 0.0)));
  const abut_part_id box = room.add_box(at(10, 10, 0.49));
  room.step(until_asleep);
  ASSERT_TRUE(room.is_asleep(box));
  const double height = 0.005;
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(room.universe, terrain, 0, 0, 1, 1, &height)));
  room.step();
  EXPECT_FALSE(room.is_asleep(box));
}

// Balls that lie on a field of 41 x 41 samples one apart, one on each fourth sample.
struct Field {
  Field() {
    terrain = universe.add(make_of_kind("height_field", {41, 41, 1, 1}, heights), identity, ABUT_MOTION_STATIC);
    const Shape ball = make_sphere(0.5);
    for (int j = 2; j < 40; j += 4) {
      for (int i = 2; i < 40; i += 4) balls.push_back(universe.add(ball, at(i, j, 0.49)));
    }
    universe.step();
  }

  // One sample is as low and one as high as the box of the field for good.
  std::vector<double> heights = [] {
    std::vector<double> flat(41 * 41, 0.0);
    flat.front() = -2;
    flat.back() = 2;
    return flat;
  }();
  Universe universe;
  abut_geometry_id terrain{};
  std::vector<abut_geometry_id> balls;
};

TEST(SetHeights, OnlyPairsNearTheSamplesAreExamined) {
  Field scene;
  EXPECT_EQ(scene.universe.stats().touching_pairs, 100U);
  const std::array lower{-1.0, -1.0, -1.0, -1.0};
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(scene.universe, scene.terrain, 10, 10, 2, 2, lower.data())));
  scene.universe.step();
  EXPECT_EQ(scene.universe.stats().examined_pairs, 1U);
  EXPECT_EQ(scene.universe.stats().touching_pairs, 99U);
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(scene.universe, scene.terrain, 2, 2, 1, 1, lower.data())));
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(scene.universe, scene.terrain, 30, 30, 1, 1, lower.data())));
  scene.universe.step();
  EXPECT_LT(scene.universe.stats().examined_pairs, 99U) << "the box around both";
  EXPECT_EQ(scene.universe.stats().touching_pairs, 97U);
  scene.universe.step();
  EXPECT_EQ(scene.universe.stats().examined_pairs, 0U);
}

TEST(SetHeights, AllPairsAreExaminedWhereTheFieldHasMovedToo) {
  for (const bool is_moved_first : {true, false}) {
    Field scene;
    const auto move = [&] { scene.universe.move(scene.universe.describe(scene.terrain).part, at(0, 0, -0.005)); };
    const double lower = -1;
    if (is_moved_first) move();
    ASSERT_TRUE(succeeded(abut_geometry_set_heights(scene.universe, scene.terrain, 10, 10, 1, 1, &lower)));
    if (!is_moved_first) move();
    scene.universe.step();
    EXPECT_EQ(scene.universe.stats().examined_pairs, 100U);
    EXPECT_NEAR(scene.universe.contacts().at(0).distance, -0.005, 1e-12);
  }
}

// On a slope the box of the field holds the ball still, when the highest sample is no longer as high.
TEST(SetHeights, EndsWhatLayOnAPeakThatIsGone) {
  const double half = std::sqrt(0.5), cosine = std::sqrt(0.5 + 0.5 * half), sine = std::sqrt(0.5 - 0.5 * half);
  std::vector<double> heights(41 * 41, 0.0);
  heights.at(20 * 41 + 20) = 6;
  Universe universe;
  const abut_geometry_id slope = universe.add(make_of_kind("height_field", {41, 41, 1, 1}, heights),
                                              {{0, 0, 0}, {cosine, sine, 0, 0}}, ABUT_MOTION_STATIC);
  universe.add(make_sphere(0.5), at(20, half * (20 - 6.49), half * (20 + 6.49)));
  EXPECT_EQ(universe.step().size(), 1U);
  const double height = 1;
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(universe, slope, 20, 20, 1, 1, &height)));
  EXPECT_TRUE(universe.step().empty());
}

TEST(SetHeights, LeavesOtherHoldersOfTheFieldAsTheyWere) {
  Universe universe;
  const Shape field = make_of_kind("height_field", {3, 3, 1, 1}, std::vector(9, 0.0));
  const abut_geometry_id geometry = universe.add(field, identity, ABUT_MOTION_STATIC);
  const std::array raised{1.0, 2.0};
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(universe, geometry, 1, 2, 2, 1, raised.data())));
  abut_aabb box{};
  require(abut_shape_aabb(field, &identity, &box));
  EXPECT_EQ(box.maximum.z, 0);
  require(abut_shape_aabb(universe.describe(geometry).shape, &identity, &box));
  EXPECT_EQ(box.maximum.z, 2);
}

TEST(SetHeights, OfNoSamplesChangesNoContact) {
  Field scene;
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(scene.universe, scene.terrain, 41, 41, 0, 0, nullptr)));
  ASSERT_TRUE(succeeded(abut_geometry_set_heights(scene.universe, scene.terrain, 5, 5, 3, 0, nullptr)));
  scene.universe.step();
  EXPECT_EQ(scene.universe.stats().touching_pairs, 100U);
}

TEST(SetParticles, MovesThemAndTheirRadii) {
  Universe universe;
  universe.add(make_plane({0, 0, 1}, 0), identity, ABUT_MOTION_STATIC);
  const abut_geometry_id geometry =
      universe.add(make_of_kind("particles", {0}, {0, 0, 1, 0.5, 2, 0, 1, 0.5, 4, 0, 1, 0.5}), identity);
  EXPECT_TRUE(universe.step().empty());
  const std::array<double, 6> xyz{2, 0, 0.25, 4, 0, 1};
  ASSERT_TRUE(succeeded(abut_geometry_set_particles(universe, geometry, 1, xyz.data(), nullptr, 2)));
  std::vector<abut_contact> contacts = universe.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].child_b, 1U);
  EXPECT_NEAR(contacts[0].distance, -0.25, 1e-12);
  const std::array radii{0.125, 2.0};
  ASSERT_TRUE(succeeded(abut_geometry_set_particles(universe, geometry, 1, xyz.data(), radii.data(), 2)));
  contacts = universe.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].child_b, 2U);
  EXPECT_NEAR(contacts[0].distance, -1, 1e-12);
  ASSERT_TRUE(succeeded(abut_geometry_set_particles(universe, geometry, 3, nullptr, nullptr, 0)));
  EXPECT_EQ(universe.step().size(), 1U);
}

}  // namespace
