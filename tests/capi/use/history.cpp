// SPDX-License-Identifier: Apache-2.0
// What contacts remember from step to step: their age, the caller's value, and which of many points are kept.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "support.hpp"

namespace {

using namespace abut_test;

std::set<std::uint64_t> ids_of(const std::vector<abut_contact>& contacts) {
  std::set<std::uint64_t> ids;
  for (const abut_contact& contact : contacts) ids.insert(contact.id);
  return ids;
}

// Puts the numbers from `first` on, on the contacts of the last step.
void number_contacts(Universe& universe, std::uint64_t first) {
  std::vector<std::uint64_t> values(universe.contacts().size());
  for (std::uint64_t& value : values) value = first++;
  ASSERT_TRUE(succeeded(abut_contacts_set_user_data(universe, values.data(), values.size())));
}

TEST(ContactHistory, AgeCountsTheStepsOfAContact) {
  const Shape floor = make_box(3, 3, 1);
  const Shape block = make_box(1, 1, 1);
  Universe universe;
  universe.add(floor, at(0, 0, 0), ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(0, 0, 1.999));
  universe.add_geometry(part, block);
  for (std::uint32_t age = 0; age < 10; ++age) {
    const abut_pose pose = at(0.001 * age, 0, 1.999);
    ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
    const auto contacts = universe.step();
    ASSERT_EQ(contacts.size(), 4U);
    for (const abut_contact& contact : contacts) EXPECT_EQ(contact.age, age);
  }
  const abut_pose away = at(0, 0, 3);
  ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &away)));
  EXPECT_TRUE(universe.step().empty());
  const abut_pose back = at(0, 0, 1.999);
  ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &back)));
  for (const abut_contact& contact : universe.step()) EXPECT_EQ(contact.age, 0U) << "a step without it ends a contact";
}

TEST(ContactHistory, UserDataStaysWithItsContact) {
  const Shape block = make_box(1, 1, 1);
  const Shape ball = make_sphere(1);
  Universe universe;
  universe.add(block, at(0, 0, 0), ABUT_MOTION_STATIC);
  universe.add(block, at(0.3, 0.2, 1.99));
  universe.add(ball, at(0.1, 0, 3.95));
  const abut_part_id visitor = universe.add_part(at(9, 0, 0));
  universe.add_geometry(visitor, ball);
  ASSERT_EQ(universe.step().size(), 5U);
  number_contacts(universe, 100);
  std::map<std::uint64_t, std::uint64_t> given;
  for (const abut_contact& contact : universe.contacts())
    given[contact.id ^ contact.geometry_b.slot] = contact.user_data;
  // A pair in between the others comes and goes.
  for (const double x : {0.0, 9.0, 0.0}) {
    const abut_pose pose = at(x, -1.9, 0);
    ASSERT_TRUE(succeeded(abut_part_set_pose(universe, visitor, &pose)));
    const auto contacts = universe.step();
    EXPECT_EQ(contacts.size(), x == 0.0 ? 6U : 5U);
    for (const abut_contact& contact : contacts) {
      const auto known = given.find(contact.id ^ contact.geometry_b.slot);
      const bool is_old = known != given.end() && contact.geometry_b.slot != 4;
      EXPECT_EQ(contact.user_data, is_old ? known->second : 0U);
      EXPECT_EQ(contact.age > 0, is_old);
    }
  }
}

TEST(ContactHistory, EndsWithAGeometry) {
  const Shape ball = make_sphere(1);
  Universe universe;
  universe.add(ball, at(0, 0, 0), ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(1.9, 0, 0));
  const abut_geometry_id first = universe.add_geometry(part, ball);
  ASSERT_EQ(universe.step().size(), 1U);
  number_contacts(universe, 7);
  ASSERT_EQ(universe.step().front().user_data, 7U);
  ASSERT_TRUE(succeeded(abut_geometry_destroy(universe, first)));
  const abut_geometry_id second = universe.add_geometry(part, ball);
  ASSERT_EQ(second.slot, first.slot) << "the slot is used again";
  const auto contacts = universe.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts.front().user_data, 0U);
  EXPECT_EQ(contacts.front().age, 0U);
}

TEST(ContactHistory, UserDataIsOneValuePerContact) {
  const Shape ball = make_sphere(1);
  Universe universe;
  universe.add(ball, at(0, 0, 0));
  universe.add(ball, at(1.9, 0, 0));
  ASSERT_EQ(universe.step().size(), 1U);
  const std::array<std::uint64_t, 2> values{1, 2};
  EXPECT_TRUE(refused(abut_contacts_set_user_data(universe, values.data(), 2), ABUT_INVALID_ARGUMENT, {"count"}));
  EXPECT_TRUE(refused(abut_contacts_set_user_data(universe, nullptr, 1), ABUT_NULL_ARGUMENT, {"user_data"}));
  EXPECT_EQ(universe.contacts().front().user_data, 0U);
  EXPECT_TRUE(succeeded(abut_contacts_set_user_data(universe, values.data(), 1)));
  EXPECT_EQ(universe.contacts().front().user_data, 1U);
}

// Two plates with many corners rest on each other and shake: the four points that hold them stay the same. The deepest
// one may be one more.
TEST(ContactHistory, KeptPointsDoNotFlicker) {
  std::vector<double> points;
  for (int i = 0; i < 12; ++i) {
    for (const double z : {-0.1, 0.1}) points.insert(points.end(), {std::cos(i * 0.5236), std::sin(i * 0.5236), z});
  }
  abut_shape* made = nullptr;
  ASSERT_TRUE(succeeded(abut_hull_create(points.data(), points.size() / 3, &made)));
  const Shape plate(made);
  const Shape slab = make_box(4, 4, 1);
  Universe universe;
  universe.add(slab, at(0, 0, -1), ABUT_MOTION_STATIC);
  const abut_part_id part = universe.add_part(at(0, 0, 0.099));
  universe.add_geometry(part, plate);
  const auto first = ids_of(universe.step());
  ASSERT_EQ(first.size(), 4U);
  for (int step = 0; step < 200; ++step) {
    const double x = 1e-7 * std::sin(1.7 * step), y = 1e-7 * std::cos(2.3 * step);
    const abut_pose pose{{x, y, 0.099}, {1, x, y, 0}};
    ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
    const auto now = ids_of(universe.step());
    EXPECT_TRUE(std::ranges::includes(now, first)) << "step " << step;
    EXPECT_LE(now.size(), first.size() + 1);
  }
}

}  // namespace
