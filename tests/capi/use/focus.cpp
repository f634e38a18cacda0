// SPDX-License-Identifier: Apache-2.0
// The focus: tags by distance from centres, and what contacts make of a switch. FW-2 of the specification.
#include <cmath>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr std::uint32_t near_tag = 1, far_tag = 2;

abut_focus focus_of(double near_distance, double far_distance) {
  return make_focus(near_tag, far_tag, near_distance, far_distance);
}

abut_geometry_options tagged(std::uint32_t tag) {
  abut_geometry_options options = default_geometry_options();
  options.tag = tag;
  return options;
}

// Boxes that sink, slightly turned, into a slab: the first deeper than the tolerance of the far policy, the second not.
// Pairs of near ones have all contacts, those of far ones the deepest, seldom.
struct Resting {
  static constexpr double far_tolerance = 0.005;

  explicit Resting(std::uint32_t period = 1) {
    universe.add_geometry(universe.add_part(at(0, 0, -1), ABUT_MOTION_STATIC), slab);
    deep = universe.add_geometry(universe.add_part({{0, 0, 0.99}, tilt}), cube, tagged(near_tag));
    shallow = universe.add_geometry(universe.add_part({{5, 0, 0.999}, tilt}), cube, tagged(near_tag));
    abut_policy policy = default_policy();
    policy.detail = ABUT_DETAIL_POINT;
    policy.tolerance = far_tolerance;
    policy.period = period;
    EXPECT_TRUE(succeeded(abut_policy_set(universe, 0, far_tag, &policy)));
  }
  void focus(double x) {
    const abut_focus focus = focus_of(4, 8);
    const abut_vec3 centre{x, 0, 0};
    EXPECT_TRUE(succeeded(abut_universe_set_focus(universe, &focus, &centre, 1)));
  }
  std::vector<abut_contact> step_of(abut_geometry_id geometry) {
    std::vector<abut_contact> contacts = universe.step();
    std::erase_if(contacts, [&](const abut_contact& contact) { return contact.geometry_b.slot != geometry.slot; });
    return contacts;
  }

  static constexpr double half_angle = 1e-3;
  abut_quat tilt{std::cos(half_angle), 0, std::sin(half_angle), 0};
  Shape slab = make_box(20, 20, 1);
  Shape cube = make_box(1, 1, 1);
  Universe universe;
  abut_geometry_id deep{}, shallow{};
};

constexpr double nearby = 2, away = 40;

void expect_on_surfaces(const abut_contact& contact, const abut_geometry_info& cube) {
  EXPECT_NEAR(contact.point_a.z, 0, 1e-14) << "the top of the slab";
  const double s = std::sin(2 * Resting::half_angle), c = std::cos(2 * Resting::half_angle);
  const double x = contact.point_b.x - cube.pose.position.x, z = contact.point_b.z - cube.pose.position.z;
  EXPECT_NEAR(s * x + c * z, -1, 1e-14) << "the bottom of the cube";
  EXPECT_NEAR(contact.point_b.z - contact.point_a.z, contact.distance, 1e-14);
}

bool is_same_place(const abut_contact& a, const abut_contact& b) {
  return a.id == b.id && a.distance == b.distance && a.point_a.x == b.point_a.x && a.point_a.y == b.point_a.y &&
         a.point_b.x == b.point_b.x && a.point_b.z == b.point_b.z && a.normal.z == b.normal.z;
}

TEST(Focus, SwitchesWithoutPopping) {
  for (const std::uint32_t period : {1U, 50U}) {
    Resting scene(period);
    scene.focus(nearby);
    const auto full = scene.step_of(scene.deep);
    ASSERT_EQ(full.size(), 4U);
    std::vector<std::uint64_t> values(scene.universe.contacts().size());
    for (std::size_t i = 0; i < values.size(); ++i) values.at(i) = 100 + i;
    ASSERT_TRUE(succeeded(abut_contacts_set_user_data(scene.universe, values.data(), values.size())));
    for (const abut_contact& contact : full) expect_on_surfaces(contact, scene.universe.describe(scene.deep));

    scene.focus(away);
    const auto coarse = scene.step_of(scene.deep);
    ASSERT_EQ(coarse.size(), 1U) << "at once, with a period of " << period;
    EXPECT_EQ(scene.universe.describe(scene.deep).tag, far_tag);
    EXPECT_TRUE(is_same_place(coarse[0], full[0])) << "the deepest stays where it was";
    EXPECT_EQ(coarse[0].user_data, 100U);
    EXPECT_EQ(coarse[0].age, full[0].age + 1);
    expect_on_surfaces(coarse[0], scene.universe.describe(scene.deep));

    scene.focus(nearby);
    const auto again = scene.step_of(scene.deep);
    ASSERT_EQ(again.size(), 4U) << "at once";
    EXPECT_EQ(scene.universe.describe(scene.deep).tag, near_tag);
    for (std::size_t i = 0; i < again.size(); ++i) {
      EXPECT_TRUE(is_same_place(again[i], full[i])) << i;
      EXPECT_EQ(again[i].user_data, i == 0 ? 100U : 0U) << "what stayed has its value, what began anew has none";
      EXPECT_EQ(again[i].age, i == 0 ? full[0].age + 2 : 0U);
      expect_on_surfaces(again[i], scene.universe.describe(scene.deep));
    }
  }
}

// What a coarse policy leaves out is not deeper than its tolerance.
TEST(Focus, DropsNoMoreThanTheTolerance) {
  Resting scene;
  scene.focus(nearby);
  const auto full = scene.step_of(scene.shallow);
  ASSERT_FALSE(full.empty());
  EXPECT_GT(full[0].distance, -Resting::far_tolerance);
  scene.focus(away);
  EXPECT_TRUE(scene.step_of(scene.shallow).empty());
  EXPECT_EQ(scene.universe.contacts().size(), 1U);
  scene.focus(nearby);
  EXPECT_EQ(scene.step_of(scene.shallow).size(), full.size());
}

TEST(Focus, TellsOfASwitchByEventsOfContactsOnly) {
  Resting scene;
  scene.focus(nearby);
  scene.universe.park(scene.shallow, ABUT_PARKING_LONG_TERM);
  scene.universe.step();
  EXPECT_EQ(letters_of(scene.universe.events()), "b");
  for (const double x : {away, nearby, away}) {
    scene.focus(x);
    scene.universe.step();
    EXPECT_EQ(letters_of(scene.universe.events()), "p") << "the pair touches all the time";
  }
}

// The face of the first cube towards the centre is at about 1.
TEST(Focus, StandsTremblingOfACentre) {
  Resting scene;
  scene.focus(nearby);
  scene.universe.step();
  for (int i = 0; i < 20; ++i) {
    scene.focus(i % 2 == 0 ? 8.999 : 4.999);
    const auto contacts = scene.step_of(scene.deep);
    ASSERT_EQ(contacts.size(), 4U) << i;
    ASSERT_EQ(scene.universe.stats().examined_pairs, 0U) << "nothing is found anew";
  }
  scene.focus(9.01);
  EXPECT_EQ(scene.step_of(scene.deep).size(), 1U);
  for (int i = 0; i < 20; ++i) {
    scene.focus(i % 2 == 0 ? 8.999 : 5.01);
    ASSERT_EQ(scene.step_of(scene.deep).size(), 1U) << i;
  }
  scene.focus(4.99);
  EXPECT_EQ(scene.step_of(scene.deep).size(), 4U);
}

std::uint32_t count_asked(void* context, const abut_universe*, abut_geometry_id, abut_geometry_id) {
  ++*static_cast<int*>(context);
  return 1;
}

TEST(Focus, DoesNotAskTheFilterAgain) {
  Resting scene;
  int asked = 0;
  ASSERT_TRUE(succeeded(abut_universe_set_filter(scene.universe, count_asked, &asked)));
  for (const double x : {nearby, away, nearby}) {
    scene.focus(x);
    scene.universe.step();
    EXPECT_EQ(asked, 2) << "once for each pair";
  }
}

TEST(Focus, LeavesOtherTagsAndParkedOnesAlone) {
  Universe universe;
  const Shape cube = make_box(0.5, 0.5, 0.5);
  const abut_geometry_id other = universe.add_geometry(universe.add_part(identity), cube, tagged(9));
  const abut_geometry_id shown = universe.add_geometry(universe.add_part(identity), cube, tagged(near_tag));
  const abut_geometry_id parked = universe.add_geometry(universe.add_part(identity), cube, tagged(near_tag));
  const auto tags = [&] {
    return std::array{universe.describe(other).tag, universe.describe(shown).tag, universe.describe(parked).tag};
  };
  const abut_focus focus = focus_of(1, 2);
  const abut_vec3 centre{30, 0, 0};
  for (const abut_parking parking : {ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}) {
    ASSERT_TRUE(succeeded(abut_universe_set_focus(universe, nullptr, nullptr, 0)));
    ASSERT_TRUE(succeeded(abut_geometry_set_options(universe, parked, std::array{tagged(near_tag)}.data())));
    universe.step();
    universe.park(parked, parking);
    ASSERT_TRUE(succeeded(abut_universe_set_focus(universe, &focus, &centre, 1)));
    universe.step();
    EXPECT_EQ(tags(), (std::array{9U, far_tag, near_tag}));
    universe.park(parked, ABUT_PARKING_NONE);
    universe.step();
    EXPECT_EQ(tags(), (std::array{9U, far_tag, far_tag})) << "when it comes back";
  }
  ASSERT_TRUE(succeeded(abut_universe_set_focus(universe, nullptr, nullptr, 0)));
  ASSERT_TRUE(succeeded(abut_geometry_set_options(universe, shown, std::array{tagged(near_tag)}.data())));
  universe.step();
  EXPECT_EQ(tags(), (std::array{9U, near_tag, far_tag})) << "without a focus tags are what the caller makes them";
}

TEST(Focus, OfMovingCentresAllocatesNothing) {
  Resting scene;
  std::uint64_t bytes = 0;
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 40; ++i) {
      scene.focus(i);
      scene.universe.step();
    }
    if (round > 1) EXPECT_EQ(scene.universe.stats().bytes, bytes) << "round " << round;
    bytes = scene.universe.stats().bytes;
  }
}

std::string explain(const abut_universe* universe,
                    abut_status (*ask)(const abut_universe*, char*, std::size_t, std::size_t*)) {
  std::size_t needed = 0;
  EXPECT_TRUE(succeeded(ask(universe, nullptr, 0, &needed)));
  std::string text(needed, '?');
  EXPECT_TRUE(succeeded(ask(universe, text.data(), text.size(), &needed)));
  return text;
}

TEST(Focus, IsPartOfThePlan) {
  Resting scene;
  scene.universe.step();
  const auto says = [&](std::string_view words) {
    const std::string text = explain(scene.universe, abut_universe_explain);
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  };
  says("  focus: none set\n");
  EXPECT_EQ(explain(scene.universe, abut_universe_explain_json).find("\"focus\": {"), std::string::npos);
  scene.focus(-4.5);
  scene.universe.step();
  says("\nfocus: 1 centre; 1 geometry near (tag 1, within 4), 1 far (tag 2, beyond 8)\n");
  EXPECT_EQ(explain(scene.universe, abut_universe_explain).find("focus: none"), std::string::npos);
  const std::string json = explain(scene.universe, abut_universe_explain_json);
  EXPECT_NE(json.find(R"("focus": {"centres": 1, "near_tag": 1, "far_tag": 2, "near_distance": 4, "far_distance": 8, )"
                      R"("near": 1, "far": 1})"),
            std::string::npos)
      << json;
}

}  // namespace
