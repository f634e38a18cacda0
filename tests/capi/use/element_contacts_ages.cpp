// SPDX-License-Identifier: Apache-2.0
// How old element contacts are, their events, and what islands and sleep make of them.
#include "archive_support.hpp"
#include "element_contacts.hpp"

namespace {

using namespace abut_test;

constexpr double reach = 0.08;

struct Watched : Cloths {
  explicit Watched(const abut_policy& policy, abut_event_bits events = ABUT_EVENTS_ELEMENTS | ABUT_EVENTS_PERSIST)
      : Cloths(policy, 1, events) {}

  // Pairs of geometries and ids of contacts, with how often each was told by the kind of event.
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>;
  std::map<Key, std::uint32_t> ages() const {
    std::map<Key, std::uint32_t> out;
    for (const abut_element_contact& its : contacts()) {
      EXPECT_EQ(its.reserved, 0U);
      out[{its.geometry_a.slot, its.geometry_b.slot, its.id}] = its.age;
    }
    return out;
  }
};

// Each contact against what a program would count that looks at ids alone.
TEST(ElementContactAges, AreCountedFromTheirBegin) {
  std::mt19937 random(1);
  Surface mesh = folded_surface(10, 0.02, random);
  Watched cloths(elements_policy(reach));
  cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS);
  cloths.add(mesh, 0, at(0.03, 0, 0));
  cloths.add(mesh, ABUT_GEOMETRY_SELF_PAIRS, at(9, 0, 0));
  std::map<Watched::Key, std::uint32_t> ages;
  std::size_t begun = 0, ended = 0, persisted = 0;
  for (int frame = 0; frame < 14; ++frame) {
    // In some frames nothing moves, in some a pair comes, goes or has another shape.
    if (frame % 3 != 2) cloths.move(0, moved(mesh, 0.01, random));
    if (frame == 4 || frame == 7) cloths.universe().move(cloths.part(1), at(frame == 4 ? 3 : 0.03, 0, 0));
    if (frame == 9) require(abut_geometry_set_shape(cloths.universe(), cloths.geometry(1), shape_of(mesh)));
    if (frame == 11) cloths.universe().park(cloths.geometry(1), ABUT_PARKING_SHORT_TERM);
    cloths.step();
    const auto found = cloths.ages();
    std::map<Watched::Key, std::uint32_t> wanted;
    for (const auto& [key, age] : found) {
      const bool is_reshaped = frame == 9 && std::get<1>(key) == 2;
      const auto before = ages.find(key);
      wanted[key] = before == ages.end() || is_reshaped ? 0 : before->second + 1;
    }
    EXPECT_EQ(found, wanted) << frame;

    std::map<Watched::Key, std::set<abut_event_kind>> told;
    for (const abut_event& its : cloths.universe().events()) {
      EXPECT_EQ(its.flags, abut_event_flags{ABUT_EVENT_ELEMENTS});
      const Watched::Key key{its.geometry_a.slot, its.geometry_b.slot, its.contact_id};
      EXPECT_TRUE(told[key].insert(its.kind).second);
      if (its.kind == ABUT_EVENT_END) continue;
      ASSERT_LT(its.first_contact, cloths.contacts().size());
      EXPECT_EQ(cloths.contacts()[its.first_contact].id, its.contact_id);
      EXPECT_EQ(its.contact_count, 1U);
    }
    for (const auto& [key, age] : found) {
      const bool is_reshaped = frame == 9 && std::get<1>(key) == 2;
      EXPECT_EQ(told[key].count(age == 0 ? ABUT_EVENT_BEGIN : ABUT_EVENT_PERSIST), 1U) << frame;
      EXPECT_EQ(told[key].size(), is_reshaped && ages.count(key) != 0 ? 2U : 1U) << frame;
      begun += age == 0 ? 1 : 0;
      persisted += age == 0 ? 0 : 1;
    }
    for (const auto& [key, age] : ages) {
      const bool is_reshaped = frame == 9 && std::get<1>(key) == 2;
      if (found.count(key) != 0 && !is_reshaped) continue;
      EXPECT_EQ(told[key].count(ABUT_EVENT_END), 1U) << frame;
      ++ended;
    }
    for (const auto& [key, kinds] : told) EXPECT_TRUE(found.count(key) != 0 || ages.count(key) != 0) << frame;
    ages = found;
  }
  EXPECT_GT(begun, 300U);
  EXPECT_GT(ended, 200U);
  EXPECT_GT(persisted, 1000U);
}

// Detections of other pairs make nothing older.
TEST(ElementContactAges, CountDetectionsThatCoverThePair) {
  std::mt19937 random(2);
  const Surface mesh = folded_surface(6, 0.02, random);
  Watched cloths(elements_policy(reach));
  for (int i = 0; i < 3; ++i) cloths.add(mesh, 0, at(0.03 * i, 0, 0));
  cloths.step();
  const abut_geometry_id a = cloths.geometry(0), b = cloths.geometry(1);
  require(abut_universe_detect_pairs(cloths.universe(), &a, &b, 1));
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& [key, age] : cloths.ages()) {
    const auto [slot_a, slot_b, id] = key;
    pairs.insert({slot_a, slot_b});
    EXPECT_EQ(age, slot_a == 1 && slot_b == 2 ? 1U : 0U);
  }
  EXPECT_EQ(pairs.size(), 3U);
  require(abut_universe_detect_all(cloths.universe()));
  for (const auto& [key, age] : cloths.ages()) {
    EXPECT_EQ(age, std::get<0>(key) == 1 && std::get<1>(key) == 2 ? 2U : 1U);
  }
}

// Nor do detections that find other pairs anew.
TEST(ElementContactAges, StayWhereADetectionFindsOtherPairs) {
  std::mt19937 random(4);
  Surface mesh = folded_surface(6, 0.02, random);
  Watched cloths(elements_policy(reach));
  for (int i = 0; i < 3; ++i) cloths.add(mesh, 0, at(0.03 * i, 0, 0));
  cloths.step();
  cloths.move(0, moved(mesh, 0.001, random));
  const abut_geometry_id a = cloths.geometry(0), b = cloths.geometry(1);
  require(abut_universe_detect_pairs(cloths.universe(), &a, &b, 1));
  EXPECT_EQ(cloths.universe().stats().examined_pairs, 1U);
  std::size_t older = 0, others = 0;
  for (const auto& [key, age] : cloths.ages()) {
    const bool is_covered = std::get<0>(key) == 1 && std::get<1>(key) == 2;
    older += is_covered ? age : 0;
    others += is_covered ? 0 : 1;
    EXPECT_TRUE(is_covered || age == 0);
  }
  EXPECT_GT(older, 0U);
  EXPECT_GT(others, 0U);
}

TEST(ElementContactAges, AreSavedAndInTheHash) {
  std::mt19937 random(3);
  const Surface mesh = folded_surface(6, 0.02, random);
  Watched cloths(elements_policy(reach));
  for (int i = 0; i < 2; ++i) cloths.add(mesh, 0, at(0.03 * i, 0, 0));
  std::set<std::uint64_t> hashes;
  for (int step = 0; step < 3; ++step) {
    cloths.step();
    EXPECT_TRUE(hashes.insert(cloths.universe().hash()).second) << "only the ages differ";
    const Owned twin = loaded(saved(cloths.universe()));
    EXPECT_EQ(saved(twin.get()), saved(cloths.universe()));
    const auto of_twin = copy_of(abut_universe_element_contacts, twin.get());
    ASSERT_EQ(of_twin.size(), cloths.contacts().size());
    for (std::size_t i = 0; i < of_twin.size(); ++i) EXPECT_EQ(of_twin[i].age, cloths.contacts()[i].age);
    require(abut_universe_step(twin.get(), 0.01));
    const auto later = copy_of(abut_universe_element_contacts, twin.get());
    for (std::size_t i = 0; i < later.size(); ++i) EXPECT_EQ(later[i].age, cloths.contacts()[i].age + 1);
  }
}

// Only where they are asked for, and after that of their pair.
TEST(ElementContactAges, EventsFollowThatOfThePair) {
  for (const abut_event_bits bits : {abut_event_bits{ABUT_EVENTS_PAIRS}, abut_event_bits{ABUT_EVENTS_CONTACTS},
                                     ABUT_EVENTS_PAIRS | ABUT_EVENTS_CONTACTS | ABUT_EVENTS_ELEMENTS}) {
    Watched cloths(elements_policy(0.125), bits);
    cloths.add(ground);
    cloths.add(tip_at(0, 0, 0.0625));
    cloths.step();
    ASSERT_EQ(cloths.contacts().size(), 1U);
    const auto events = cloths.universe().events();
    ASSERT_EQ(events.size(), bits == ABUT_EVENTS_PAIRS ? 1U : bits == ABUT_EVENTS_CONTACTS ? 0U : 2U);
    if (bits == ABUT_EVENTS_CONTACTS) continue;
    EXPECT_EQ(events[0].flags, 0U);
    EXPECT_EQ(events[0].contact_count, 0U);
    if (events.size() == 1) continue;
    EXPECT_EQ(events[1].flags, abut_event_flags{ABUT_EVENT_ELEMENTS});
    EXPECT_EQ(events[1].contact_id, cloths.contacts()[0].id);
    // A policy of another kind ends them.
    abut_policy manifold = default_policy();
    manifold.tolerance = 0.125;
    cloths.set_policy(manifold);
    cloths.step();
    EXPECT_EQ(cloths.universe().contacts().size(), 1U);
    std::size_t ended = 0;
    for (const abut_event& its : cloths.universe().events()) {
      if ((its.flags & ABUT_EVENT_ELEMENTS) == 0) continue;
      EXPECT_EQ(its.kind, abut_event_kind{ABUT_EVENT_END});
      EXPECT_EQ(its.contact_id, events[1].contact_id);
      ++ended;
    }
    EXPECT_EQ(ended, 1U);
    cloths.step();
    for (const abut_event& its : cloths.universe().events()) EXPECT_EQ(its.flags & ABUT_EVENT_ELEMENTS, 0U);
  }
}

// Chains of sheets are islands; one that parts has one of its own.
TEST(ElementContactAges, IslandsAreOfPairsThatHaveSome) {
  Cloths cloths(elements_policy(0.125));
  for (int i = 0; i < 3; ++i) cloths.add(shifted(ground, 0, 0, 0.1 * i));
  cloths.add(shifted(ground, 0, 0, -0.1), 0, identity, ABUT_MOTION_STATIC);
  require(abut_universe_follow_islands(cloths.universe(), 1));
  cloths.step();
  EXPECT_EQ(copy_of(abut_universe_islands, cloths.universe()).size(), 1U);
  cloths.universe().move(cloths.part(1), at(0, 0, 0.5));
  cloths.step();
  EXPECT_EQ(copy_of(abut_universe_islands, cloths.universe()).size(), 3U);
}

// Its events say that it is one.
TEST(ElementContactAges, ASensorIsConnectedWithNothing) {
  Watched cloths(elements_policy(0.125), ABUT_EVENTS_PAIRS | ABUT_EVENTS_ELEMENTS);
  cloths.add(ground);
  cloths.add(shifted(ground, 0, 0, 0.1), ABUT_GEOMETRY_SENSOR);
  require(abut_universe_follow_islands(cloths.universe(), 1));
  cloths.step();
  EXPECT_FALSE(cloths.contacts().empty());
  EXPECT_EQ(copy_of(abut_universe_islands, cloths.universe()).size(), 2U);
  const auto events = cloths.universe().events();
  ASSERT_EQ(events.size(), 1 + cloths.contacts().size());
  EXPECT_EQ(events[0].flags, abut_event_flags{ABUT_EVENT_SENSOR});
  for (std::size_t i = 1; i < events.size(); ++i) {
    EXPECT_EQ(events[i].flags, abut_event_flags{ABUT_EVENT_SENSOR | ABUT_EVENT_ELEMENTS});
  }
}

// Bodies that touch by elements fall asleep together, and what comes wakes both.
TEST(ElementContactAges, SleepIsOfPairsThatHaveSome) {
  Cloths cloths(elements_policy(0.125));
  for (int i = 0; i < 2; ++i) cloths.add(shifted(ground, 0, 0, 0.1 * i));
  cloths.add(shifted(ground, 0, 0, 5));
  const abut_sleep sleep = [] {
    abut_sleep its = default_sleep();
    its.steps = 3;
    return its;
  }();
  for (std::size_t i = 0; i < 2; ++i) require(abut_part_set_sleep(cloths.universe(), cloths.part(i), &sleep));
  const auto is_asleep = [&](std::size_t which) {
    std::uint32_t asleep = 0;
    require(abut_part_is_asleep(cloths.universe(), cloths.part(which), &asleep));
    return asleep != 0;
  };
  for (int step = 0; step < 3; ++step) {
    // The upper one moves: the lower one, which rests, stays awake with it.
    cloths.universe().move(cloths.part(1), at(step % 2 == 0 ? 0.01 : 0, 0, 0));
    cloths.step();
    EXPECT_FALSE(is_asleep(0));
  }
  for (int step = 0; step < 2; ++step) cloths.step();
  EXPECT_FALSE(is_asleep(0)) << "it waits for the other one";
  for (int step = 0; step < 3; ++step) cloths.step();
  EXPECT_TRUE(is_asleep(0) && is_asleep(1));
  cloths.universe().move(cloths.part(2), at(0, 0, -4.85));
  cloths.step();
  EXPECT_FALSE(is_asleep(1));
  EXPECT_FALSE(is_asleep(0));
}

}  // namespace
