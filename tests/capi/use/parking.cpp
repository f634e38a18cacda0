// SPDX-License-Identifier: Apache-2.0
// Parked geometries take no part in anything: VX-07 of the specification.
#include "support.hpp"

namespace {

using namespace abut_test;

class ParkingOfBroadphase : public testing::TestWithParam<std::tuple<abut_broadphase, abut_parking>> {
 protected:
  ParkingOfBroadphase()
      : parking(std::get<1>(GetParam())), universe_options(make_options()), universe(&universe_options) {
    first = universe.add(ball, identity);
    part = universe.add_part(at(1, 0, 0));
    second = universe.add_geometry(part, ball);
  }
  static abut_universe_options make_options() {
    abut_universe_options options = default_universe_options();
    options.broadphase = std::get<0>(GetParam());
    return options;
  }
  // The number of contacts of a step and the letters of its events.
  std::string step() {
    const std::string contacts = std::to_string(universe.step().size());
    return contacts + letters_of(universe.events());
  }

  abut_parking parking;
  abut_universe_options universe_options;
  Shape ball = make_sphere(1.0);
  Universe universe;
  abut_geometry_id first{}, second{};
  abut_part_id part{};
};

TEST_P(ParkingOfBroadphase, EndsContactsAndComingBackBeginsThem) {
  EXPECT_EQ(step(), "1b");
  universe.park(second, parking);
  EXPECT_EQ(step(), "0e");
  EXPECT_EQ(step(), "0") << "nothing while it is parked";
  EXPECT_EQ(universe.stats().parked, 1U);
  EXPECT_EQ(universe.stats().candidate_pairs, 0U);
  universe.park(second, ABUT_PARKING_NONE);
  EXPECT_EQ(step(), "1b");
  EXPECT_EQ(universe.contacts().at(0).age, 0U);
  EXPECT_EQ(universe.stats().parked, 0U);
  EXPECT_EQ(step(), "1p");
}

TEST_P(ParkingOfBroadphase, TwiceChangesNothing) {
  EXPECT_EQ(step(), "1b");
  abut_revision before{}, after{};
  universe.park(second, parking);
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &before)));
  universe.park(second, parking);
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &after)));
  EXPECT_EQ(before.geometries, after.geometries);
  EXPECT_EQ(step(), "0e");
  EXPECT_EQ(universe.stats().parked, 1U);
  universe.park(first, ABUT_PARKING_NONE);
  EXPECT_EQ(step(), "0") << "one that is not parked";
}

TEST_P(ParkingOfBroadphase, ChangesBetweenShortAndLongTerm) {
  const abut_parking other = parking == ABUT_PARKING_SHORT_TERM ? ABUT_PARKING_LONG_TERM : ABUT_PARKING_SHORT_TERM;
  EXPECT_EQ(step(), "1b");
  universe.park(second, parking);
  universe.park(second, other);
  EXPECT_EQ(step(), "0e");
  universe.park(second, parking);
  EXPECT_EQ(step(), "0");
  EXPECT_EQ(universe.describe(second).parking, parking);
  EXPECT_EQ(universe.stats().parked, 1U);
  universe.park(second, other);
  universe.park(second, ABUT_PARKING_NONE);
  EXPECT_EQ(step(), "1b");
}

TEST_P(ParkingOfBroadphase, MovesAndChangesItsShapeMeanwhile) {
  universe.park(second, parking);
  EXPECT_EQ(step(), "0");
  universe.move(part, at(9, 0, 0));
  EXPECT_EQ(step(), "0");
  EXPECT_EQ(universe.describe(second).pose.position.x, 9.0);
  universe.move(part, at(3, 0, 0));
  EXPECT_EQ(step(), "0");
  const Shape large = make_sphere(2.5);
  ASSERT_TRUE(succeeded(abut_geometry_set_shape(universe, second, large)));
  EXPECT_EQ(step(), "0");
  universe.park(second, ABUT_PARKING_NONE);
  EXPECT_EQ(step(), "1b");
  EXPECT_NEAR(universe.contacts().at(0).distance, -0.5, 1e-12) << "at the new pose with the new shape";
}

TEST_P(ParkingOfBroadphase, AtCreationAndAsAnOption) {
  abut_geometry_options options = default_geometry_options();
  options.parking = parking;
  const abut_geometry_id third = universe.add_geometry(universe.add_part(at(0, 1, 0)), ball, options);
  EXPECT_EQ(step(), "1b");
  EXPECT_EQ(universe.stats().parked, 1U);
  EXPECT_EQ(universe.describe(third).parking, parking);
  options.parking = ABUT_PARKING_NONE;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(universe, third, &options)));
  EXPECT_EQ(step(), "3pbb");
  options.parking = parking;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(universe, third, &options)));
  EXPECT_EQ(step(), "1pee");
}

TEST_P(ParkingOfBroadphase, DestroyedWhileParked) {
  EXPECT_EQ(step(), "1b");
  universe.park(second, parking);
  ASSERT_TRUE(succeeded(abut_geometry_destroy(universe, second)));
  EXPECT_EQ(step(), "0e");
  EXPECT_EQ(universe.stats().parked, 0U);
  second = universe.add_geometry(part, ball);
  EXPECT_EQ(step(), "1b") << "what takes its slot is not parked";
}

TEST_P(ParkingOfBroadphase, LeavesTheRestOfThePart) {
  const abut_geometry_id third = universe.add_geometry(part, ball);
  EXPECT_EQ(step(), "2bb");
  universe.park(third, parking);
  EXPECT_EQ(step(), "1pe");
  universe.move(part, at(1.5, 0, 0));
  EXPECT_EQ(step(), "1p");
  EXPECT_NEAR(universe.contacts().at(0).distance, -0.5, 1e-12);
}

// Trees near a vehicle: most of a pool is parked, one after the other is placed and comes back.
TEST_P(ParkingOfBroadphase, APoolOfThem) {
  std::vector<std::pair<abut_part_id, abut_geometry_id>> pool;
  for (int i = 0; i < 50; ++i) {
    const abut_part_id owner = universe.add_part(at(100.0 + i, 0, 0), ABUT_MOTION_STATIC);
    pool.emplace_back(owner, universe.add_geometry(owner, ball));
    universe.park(pool.back().second, parking);
  }
  EXPECT_EQ(step(), "1b");
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    const auto& [owner, geometry] = pool.at(i % pool.size());
    universe.move(owner, at(-1.5, 0, 0));
    universe.park(geometry, ABUT_PARKING_NONE);
    // The one before has the lower slot, but for the last of the pool.
    EXPECT_EQ(step(), i == 0 ? "2pb" : (i % pool.size() == 0 ? "2pbe" : "2peb")) << i;
    universe.park(geometry, parking);
    if (i == 100) bytes = universe.stats().bytes;
  }
  EXPECT_EQ(step(), "1pe");
  EXPECT_EQ(universe.stats().parked, 50U);
  EXPECT_EQ(universe.stats().bytes, bytes) << "memory does not grow";
}

INSTANTIATE_TEST_SUITE_P(, ParkingOfBroadphase,
                         testing::Combine(testing::ValuesIn(broadphases),
                                          testing::Values(ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM)));

}  // namespace
