// SPDX-License-Identifier: Apache-2.0
// Fast geometries that touch, part and touch again within a step.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "moving.hpp"

namespace {

using namespace abut_test;

// A rod that stands upright in a plane at the start, and turns: its ends touch in turn.
struct Propeller {
  double half = 1, radius = 0.1, height = 0.8, turn;  // the turn within the step
  Shape rod = make_capsule(radius, half);
  Moving moving() const { return {at(0, 0, height), {{0, 0, 0}, {turn, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}; }
  // So far from upright an end is `radius` above the plane.
  double leaning() const { return std::acos((height - radius) / half); }
  std::vector<double> times() const {
    std::vector<double> all;
    for (double angle = std::numbers::pi - leaning(); angle < turn; angle += std::numbers::pi) {
      all.push_back(angle / turn);
    }
    return all;
  }
};

TEST(FastAgain, FindsEachTouchOfAPropeller) {
  ABUT_NEEDS_MOTION();
  for (const double turn : {1.0, 3.0, 7.0, 16.0, 60.0}) {
    for (const abut_vec3& up : {abut_vec3{0, 0, 1}, abut_vec3{0, 0, -1}}) {
      SCOPED_TRACE(testing::Message() << "turn " << turn << ", up " << up.z);
      const Propeller propeller{.turn = turn};
      Universe universe;
      if (up.z > 0) universe.add(make_plane(up, 0), identity, ABUT_MOTION_STATIC);
      add_moving(universe, propeller.rod, propeller.moving(), ABUT_GEOMETRY_FAST);
      if (up.z < 0) universe.add(make_box(9, 9, 0.5), at(0, 0, -0.5), ABUT_MOTION_STATIC);
      require(abut_universe_step(universe, 1));
      const auto impacts = impacts_of(universe);
      const auto contacts = universe.contacts();
      std::vector<double> times = propeller.times();
      times.resize(std::min<std::size_t>(times.size(), 8));
      ASSERT_EQ(impacts.size(), times.size()) << "no more than eight are found";
      std::size_t next = 1;
      std::vector<std::uint64_t> ids{contacts.at(0).id};
      EXPECT_EQ(contacts.at(0).toi, 0) << "it stands in the plane at the start";
      for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_LE(impacts[i].lower, times[i] + 1e-9);
        EXPECT_GE(impacts[i].upper, times[i] - 1e-9);
        EXPECT_EQ(impacts[i].first_contact, next);
        ASSERT_EQ(impacts[i].contact_count, 1U);
        const abut_contact contact = contacts.at(next++);
        EXPECT_EQ(contact.toi, impacts[i].lower);
        EXPECT_EQ(contact.flags, std::uint32_t{ABUT_CONTACT_SPECULATIVE});
        EXPECT_TRUE(succeeded(abut_contact_validate(&contact)));
        ids.push_back(contact.id);
        // Carried back: the point on the rod is at the end that will touch, and the other lies in the plane.
        const bool is_upper = i % 2 == 0;
        const abut_vec3 on_rod = up.z > 0 ? contact.point_b : contact.point_a;
        const abut_vec3 on_plane = up.z > 0 ? contact.point_a : contact.point_b;
        EXPECT_NEAR(on_plane.z, 0, 1e-5);
        EXPECT_NEAR(on_rod.z, propeller.height + (is_upper ? 1.07 : -1.07), 1e-5);
      }
      EXPECT_EQ(next, contacts.size());
      std::sort(ids.begin(), ids.end());
      EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << "no two contacts of a pair have one id";
    }
  }
}

// What does not turn touches again where the other has gaps.
TEST(FastAgain, TouchesTheNextPostOfOneBody) {
  ABUT_NEEDS_MOTION();
  const Shape post = make_box(0.05, 1, 1), ball = make_sphere(0.1);
  const Shape fence = make_composite({post, post, post}, {at(1, 0, 0), at(2, 0, 0), at(3, 0, 0)});
  for (const std::uint32_t most : {0U, 2U}) {
    abut_universe_options options = default_universe_options();
    options.max_pair_contacts = most;
    Universe universe(&options);
    universe.add(fence, identity, ABUT_MOTION_STATIC);
    add_moving(universe, ball, {identity, {{4, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, ABUT_GEOMETRY_FAST);
    require(abut_universe_step(universe, 1));
    const auto impacts = impacts_of(universe);
    ASSERT_EQ(impacts.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(impacts[i].lower, (static_cast<double>(i) + 0.85) / 4, 1e-9);
      EXPECT_EQ(impacts[i].contact_count, most == 0 || i < most ? 1U : 0U) << "a pair has no more in all";
    }
    for (const abut_contact& contact : universe.contacts()) {
      EXPECT_NEAR(contact.distance, 4 * contact.toi, 1e-5) << "the way that is left at the start";
    }
  }
}

// It starts in the plane, leaves it, and is held up where its other end comes down.
TEST(FastAgain, AdvancesToATouchThatFollowsTheOneAtTheStart) {
  ABUT_NEEDS_MOTION();
  const Propeller propeller{.turn = 5};
  Universe universe;
  universe.add(make_plane({0, 0, 1}, 0), identity, ABUT_MOTION_STATIC);
  add_moving(universe, propeller.rod, propeller.moving(), ABUT_GEOMETRY_FAST);
  abut_step_impact first{};
  require(abut_universe_advance_to_first_impact(universe, 1, &first));
  EXPECT_NEAR(first.lower, propeller.times().at(0), 1e-9);
}

}  // namespace
