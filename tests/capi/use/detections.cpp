// SPDX-License-Identifier: Apache-2.0
// Detections of some pairs and of some regions: together with a full one they find what a full one would have found
// from the start. CI-3 of the specification.
#include <cmath>

#include "bad_values.hpp"
#include "box_world.hpp"

namespace {

using namespace abut_test;

constexpr std::uint64_t seed = 20250116;

// All points are kept: of many equally good ones a reduced manifold prefers those of the step before.
abut_universe_options options_of(abut_broadphase broadphase) {
  abut_universe_options options = default_universe_options();
  options.broadphase = broadphase;
  options.max_contacts = 0;
  return options;
}

// A contact without what it remembers, with the slots of its geometries for their ids.
using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t, std::array<double, 10>>;

Key key_of(const abut_contact& c) {
  return {c.geometry_a.slot,
          c.geometry_b.slot,
          c.id,
          {c.distance, c.point_a.x, c.point_a.y, c.point_a.z, c.point_b.x, c.point_b.y, c.point_b.z, c.normal.x,
           c.normal.y, c.normal.z}};
}

std::vector<Key> keys_of(const std::vector<abut_contact>& contacts) {
  std::vector<Key> keys;
  for (const abut_contact& contact : contacts) keys.push_back(key_of(contact));
  return keys;
}

using Slots = std::pair<std::uint32_t, std::uint32_t>;

std::map<Slots, std::vector<Key>> by_pair(const std::vector<abut_contact>& contacts) {
  std::map<Slots, std::vector<Key>> pairs;
  for (const abut_contact& contact : contacts) {
    pairs[{contact.geometry_a.slot, contact.geometry_b.slot}].push_back(key_of(contact));
  }
  return pairs;
}

// What begins was not there, and what persists or ends was.
struct Grammar {
  std::set<Touch> living;

  void read(const std::vector<abut_event>& events) {
    for (const Change& change : changes_of(events)) {
      if (change.kind == ABUT_EVENT_BEGIN) {
        EXPECT_TRUE(living.insert(change.touch).second) << "began twice";
      } else {
        EXPECT_TRUE(living.contains(change.touch)) << "was not there";
      }
      if (change.kind == ABUT_EVENT_END) living.erase(change.touch);
    }
  }
};

// One world detects everything in each round, the other one some of it, and everything in some rounds only.
class PartialDetection : public testing::TestWithParam<abut_broadphase> {
 protected:
  PartialDetection() : full(options_of(GetParam()), seed, 40), partial(options_of(GetParam()), seed, 40) {}

  void detect_some_pairs() {
    std::vector<abut_geometry_id> a, b;
    for (int i = 0; i < 60; ++i) {
      a.push_back(partial.random_geometry());
      b.push_back(partial.random_geometry());
      full.random_geometry();
      full.random_geometry();
    }
    const auto before = by_pair(partial.universe().contacts());
    ASSERT_TRUE(succeeded(abut_universe_detect_pairs(partial.universe(), a.data(), b.data(), a.size())));
    const auto all = by_pair(full.universe().contacts());
    auto found = by_pair(partial.universe().contacts());
    std::set<Slots> given;
    for (std::size_t i = 0; i < a.size(); ++i) given.insert(std::minmax(a.at(i).slot, b.at(i).slot));
    for (const Slots& pair : given) {
      const auto expected = all.find(pair);
      ASSERT_EQ(found[pair], expected == all.end() ? std::vector<Key>{} : expected->second)
          << "a given pair is as of now";
      if (expected != all.end()) ++given_that_touch;
      found.erase(pair);
    }
    for (const auto& [pair, keys] : found) {
      if (keys.empty()) continue;
      const auto was = before.find(pair);
      ASSERT_TRUE(was != before.end() && was->second == keys) << "any other pair is as it was";
    }
  }

  void detect_a_region() {
    const double low = partial.number(-2.5, 1.5);
    full.number(0, 1);
    const abut_aabb region{{low, -infinity, -1}, {low + 1, infinity, 0.5}};
    ASSERT_TRUE(succeeded(abut_universe_detect_region(partial.universe(), &region)));
    // A contact is in it with both of its points: deep in a thin box one of them may be outside the other box.
    const auto is_in = [&](const Key& key) {
      const auto& [distance, a_x, a_y, a_z, b_x, b_y, b_z, x, y, z] = std::get<3>(key);
      return std::min(a_x, b_x) >= region.minimum.x && std::max(a_x, b_x) <= region.maximum.x &&
             std::min(a_z, b_z) >= region.minimum.z && std::max(a_z, b_z) <= region.maximum.z;
    };
    const auto found = by_pair(partial.universe().contacts());
    for (const auto& [pair, keys] : by_pair(full.universe().contacts())) {
      if (std::any_of(keys.begin(), keys.end(), is_in)) {
        const auto its = found.find(pair);
        ASSERT_TRUE(its != found.end() && its->second == keys) << "what touches in the region is as of now";
        ++touching_in_region;
      }
    }
  }

  BoxWorld full, partial;
  std::size_t given_that_touch = 0, touching_in_region = 0;
};

TEST_P(PartialDetection, FindsWhatAFullOneFinds) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Grammar grammar;
  std::size_t contacts = 0;
  for (int round = 0; round < 1000; ++round) {
    full.universe().step();
    if (round % 4 == 0) {
      detect_some_pairs();
    } else if (round % 4 == 1) {
      detect_a_region();
    } else if (round % 4 == 3) {
      ASSERT_TRUE(succeeded(round % 8 == 3 ? abut_universe_detect_changed(partial.universe())
                                           : abut_universe_detect_all(partial.universe())));
      ASSERT_EQ(keys_of(partial.universe().contacts()), keys_of(full.universe().contacts())) << "round " << round;
      contacts += full.universe().contacts().size();
    }
    if (round % 4 != 2) grammar.read(partial.universe().events());
    if (round % 4 == 3) {
      const auto touching = partial.touching();
      ASSERT_EQ(grammar.living, std::set<Touch>(touching.begin(), touching.end()));
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
    full.foretell();
    partial.foretell();
    full.edit();
    partial.edit();
  }
  EXPECT_GT(contacts, 8000U) << "the scene must have something to compare";
  EXPECT_GT(given_that_touch, 30U);
  EXPECT_GT(touching_in_region, 250U);
}

INSTANTIATE_TEST_SUITE_P(, PartialDetection, testing::ValuesIn(broadphases));

// An edited universe and one that was made in its final state have the same first step, bit by bit.
TEST(Detections, DoNotDependOnTheWayToAScene) {
  const Shape cube = make_box(0.5, 0.4, 0.3);
  Universe edited, made;
  std::vector<abut_part_id> parts;
  for (int i = 0; i < 40; ++i) {
    const auto where = [&](double shift) {
      return at(std::fmod(0.37 * i + shift, 2.0), std::fmod(0.71 * i, 2.0), std::fmod(0.53 * i, 2.0));
    };
    parts.push_back(edited.add_part(where(0.9)));
    const abut_geometry_id geometry = edited.add_geometry(parts.back(), cube);
    edited.park(geometry, ABUT_PARKING_LONG_TERM);
    ASSERT_TRUE(succeeded(abut_universe_refresh(edited)));
    edited.park(geometry, ABUT_PARKING_NONE);
    edited.move(parts.back(), where(0));
    made.add(cube, where(0));
  }
  edited.step();
  made.step();
  EXPECT_GT(made.contacts().size(), 100U);
  EXPECT_EQ(edited.hash(), made.hash());
  EXPECT_EQ(edited.events().size(), made.events().size());
}

TEST(Detections, OfAPairInEitherOrder) {
  for (const bool is_swapped : {false, true}) {
    Universe universe;
    const Shape ball = make_sphere(1.0);
    const abut_geometry_id a = universe.add(ball, identity), b = universe.add(ball, at(1, 0, 0));
    universe.add(ball, at(0, 1, 0));
    ASSERT_TRUE(succeeded(abut_universe_detect_pairs(universe, is_swapped ? &b : &a, is_swapped ? &a : &b, 1)));
    ASSERT_EQ(universe.contacts().size(), 1U);
    EXPECT_TRUE(universe.contacts().at(0).geometry_a == a && universe.contacts().at(0).geometry_b == b);
    ASSERT_TRUE(succeeded(abut_universe_detect_changed(universe)));
    EXPECT_EQ(universe.contacts().size(), 3U);
    EXPECT_EQ(universe.stats().examined_pairs, 2U) << "the one that was found is kept";
  }
}

TEST(Detections, PassOverPairsThatCannotMeet) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id a = universe.add_geometry(part, ball), b = universe.add_geometry(part, ball);
  const abut_geometry_id far = universe.add(ball, at(9, 0, 0));
  const std::array<abut_geometry_id, 3> first{a, a, a}, second{a, b, far};
  ASSERT_TRUE(succeeded(abut_universe_detect_pairs(universe, first.data(), second.data(), 3)));
  EXPECT_TRUE(universe.contacts().empty());
  EXPECT_TRUE(universe.events().empty());
}

// Others keep their contacts as old as they are, without an event.
TEST(Detections, LeaveOthersAsTheyAre) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const abut_geometry_id a = universe.add(ball, identity);
  const abut_part_id part = universe.add_part(at(1, 0, 0));
  const abut_geometry_id b = universe.add_geometry(part, ball);
  universe.step();
  universe.step();
  ASSERT_EQ(universe.contacts().at(0).age, 1U);
  universe.move(part, at(1.5, 0, 0));
  const abut_aabb elsewhere{{50, 50, 50}, {51, 51, 51}};
  ASSERT_TRUE(succeeded(abut_universe_detect_region(universe, &elsewhere)));
  ASSERT_EQ(universe.contacts().size(), 1U);
  EXPECT_EQ(universe.contacts().at(0).age, 1U);
  EXPECT_EQ(universe.contacts().at(0).distance, -1.0);
  EXPECT_TRUE(universe.events().empty());
  ASSERT_TRUE(succeeded(abut_universe_detect_pairs(universe, &a, &b, 1)));
  EXPECT_EQ(universe.contacts().at(0).age, 2U);
  EXPECT_EQ(universe.contacts().at(0).distance, -0.5);
  EXPECT_EQ(universe.events().size(), 1U);
  universe.move(part, at(9, 0, 0));
  ASSERT_TRUE(succeeded(abut_universe_detect_region(universe, &elsewhere)));
  EXPECT_TRUE(universe.contacts().empty()) << "what is not near ends all the same";
  ASSERT_EQ(universe.events().size(), 1U);
  EXPECT_EQ(universe.events().at(0).kind, abut_event_kind{ABUT_EVENT_END});
}

TEST(Detections, RefreshFindsNothingAndForgetsNothing) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  universe.add(ball, identity);
  const abut_part_id part = universe.add_part(at(1, 0, 0));
  universe.add_geometry(part, ball);
  universe.step();
  const std::uint64_t hash = universe.hash();
  universe.move(part, at(9, 0, 0));
  ASSERT_TRUE(succeeded(abut_universe_refresh(universe)));
  EXPECT_EQ(universe.hash(), hash) << "contacts are those of the last step";
  EXPECT_TRUE(universe.step().empty());
  ASSERT_EQ(universe.events().size(), 1U);
  EXPECT_EQ(universe.events().at(0).kind, abut_event_kind{ABUT_EVENT_END});
}

TEST(Detections, OfAllFindsEveryPairAnew) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  for (int i = 0; i < 5; ++i) universe.add(ball, at(0.1 * i, 0, 0));
  universe.step();
  universe.step();
  EXPECT_EQ(universe.stats().kept_pairs, 10U);
  EXPECT_EQ(universe.stats().examined_pairs, 0U);
  const auto kept = keys_of(universe.contacts());
  ASSERT_TRUE(succeeded(abut_universe_detect_all(universe)));
  EXPECT_EQ(universe.stats().examined_pairs, 10U);
  EXPECT_EQ(keys_of(universe.contacts()), kept);
  EXPECT_EQ(universe.contacts().at(0).age, 2U);
}

}  // namespace
