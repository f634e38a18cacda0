// SPDX-License-Identifier: Apache-2.0
// Events: every touch is one begin, then a persist in each step, then one end, whatever happens to the scene.
#include "box_world.hpp"

namespace {

using namespace abut_test;

constexpr std::uint64_t seed = 20250114;

abut_universe_options options_of(abut_broadphase broadphase,
                                 abut_event_bits events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST) {
  abut_universe_options options = default_universe_options();
  options.broadphase = broadphase;
  options.events = events;
  return options;
}

class EventsOfBroadphase : public testing::TestWithParam<abut_broadphase> {};

TEST_P(EventsOfBroadphase, AreThoseOfAModel) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  BoxWorld world(options_of(GetParam()), seed, 40);
  std::map<abut_event_kind, std::size_t> seen;
  for (int step = 0; step < 1000; ++step) {
    const std::vector<Change> expected = world.foretell();
    const auto contacts = world.universe().step();
    ASSERT_EQ(changes_of(world.universe().events()), expected) << "step " << step;
    const std::vector<Touch> touching = world.touching();
    ASSERT_EQ(touches_of(contacts), std::set<Touch>(touching.begin(), touching.end())) << "step " << step;
    ASSERT_EQ(world.universe().stats().events, expected.size());
    ASSERT_EQ(world.universe().stats().touching_pairs, touching.size());
    for (const Change& change : expected) ++seen[change.kind];
    world.edit();
  }
  EXPECT_GT(seen[ABUT_EVENT_BEGIN], 500U) << "the scene must have something to compare";
  EXPECT_GT(seen[ABUT_EVENT_END], 500U);
  EXPECT_GT(seen[ABUT_EVENT_PERSIST], 2000U);
}

// The same of contacts, against nothing but the grammar and the list of contacts.
TEST_P(EventsOfBroadphase, OfContactsFollowTheGrammar) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  BoxWorld world(options_of(GetParam(), ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS), seed + 1, 30);
  std::set<std::pair<Touch, std::uint64_t>> living;
  for (int step = 0; step < 100; ++step) {
    const auto contacts = world.universe().step();
    for (const abut_event& event : world.universe().events()) {
      if ((event.flags & ABUT_EVENT_CONTACT) == 0) {
        EXPECT_EQ(event.contact_id, 0U);
        continue;
      }
      const std::pair key{Touch{event.geometry_a, event.geometry_b}, event.contact_id};
      if (event.kind == ABUT_EVENT_BEGIN) {
        EXPECT_TRUE(living.insert(key).second) << "began twice";
      } else {
        EXPECT_TRUE(living.contains(key)) << "was not there";
      }
      if (event.kind == ABUT_EVENT_END) {
        living.erase(key);
        EXPECT_EQ(event.contact_count, 0U);
      } else {
        ASSERT_EQ(event.contact_count, 1U);
        ASSERT_LT(event.first_contact, contacts.size());
        const abut_contact& contact = contacts.at(event.first_contact);
        EXPECT_EQ(contact.id, event.contact_id);
        EXPECT_TRUE(contact.geometry_a == event.geometry_a && contact.geometry_b == event.geometry_b);
        EXPECT_EQ(contact.age == 0, event.kind == ABUT_EVENT_BEGIN);
      }
    }
    std::set<std::pair<Touch, std::uint64_t>> present;
    for (const abut_contact& contact : contacts) present.insert({{contact.geometry_a, contact.geometry_b}, contact.id});
    ASSERT_EQ(present, living) << "step " << step;
    world.edit();
    ASSERT_FALSE(testing::Test::HasFailure()) << "step " << step;
  }
}

INSTANTIATE_TEST_SUITE_P(, EventsOfBroadphase, testing::ValuesIn(broadphases));

// Two balls that overlap.
struct Two {
  explicit Two(abut_event_bits events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST) : universe(make_options(events)) {
    first = universe.add(ball, identity);
    part = universe.add_part(at(1, 0, 0));
    second = universe.add_geometry(part, ball);
  }
  static const abut_universe_options* make_options(abut_event_bits events) {
    static abut_universe_options options;
    options = options_of(ABUT_BROADPHASE_AUTO, events);
    return &options;
  }
  // The letters of the events of a step.
  std::string step() {
    universe.step();
    return letters_of(universe.events());
  }

  Shape ball = make_sphere(1.0);
  Universe universe;
  abut_geometry_id first{}, second{};
  abut_part_id part{};
};

TEST(Events, OfALifeOfAPair) {
  Two two;
  EXPECT_EQ(two.step(), "b");
  const abut_event begin = two.universe.events().at(0);
  EXPECT_TRUE(begin.geometry_a == two.first && begin.geometry_b == two.second);
  EXPECT_EQ(begin.first_contact, 0U);
  EXPECT_EQ(begin.contact_count, 1U);
  EXPECT_EQ(two.step(), "p");
  EXPECT_EQ(two.step(), "p");
  two.universe.move(two.part, at(3, 0, 0));
  EXPECT_EQ(two.step(), "e");
  EXPECT_EQ(two.universe.events().at(0).contact_count, 0U);
  EXPECT_EQ(two.step(), "");
}

TEST(Events, AreThoseThatWereAskedFor) {
  for (const auto& [bits, letters] : std::initializer_list<std::pair<abut_event_bits, std::array<std::string, 3>>>{
           {0, {"", "", ""}},
           {ABUT_EVENTS_PAIRS, {"b", "", "e"}},
           {ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST, {"b", "p", "e"}},
           {ABUT_EVENTS_CONTACTS, {"bc", "", "ec"}},
           {ABUT_EVENTS_CONTACTS | ABUT_EVENTS_PERSIST, {"bc", "pc", "ec"}},
           {ABUT_EVENTS_PAIRS | ABUT_EVENTS_CONTACTS | ABUT_EVENTS_PERSIST, {"bbc", "ppc", "eec"}}}) {
    Two two(bits);
    EXPECT_EQ(two.step(), letters[0]) << bits;
    EXPECT_EQ(two.step(), letters[1]) << bits;
    two.universe.move(two.part, at(3, 0, 0));
    EXPECT_EQ(two.step(), letters[2]) << bits;
  }
}

TEST(Events, EndWithADestroyedGeometry) {
  Two two;
  EXPECT_EQ(two.step(), "b");
  ASSERT_TRUE(succeeded(abut_geometry_destroy(two.universe, two.second)));
  EXPECT_EQ(two.step(), "e");
  EXPECT_TRUE(two.universe.events().at(0).geometry_b == two.second) << "an end names what is gone";
}

// Whoever has the slots before the next step: none takes over the touch of another.
TEST(Events, ANewGeometryInAnOldSlotBeginsAnew) {
  Two two;
  EXPECT_EQ(two.step(), "b");
  ASSERT_TRUE(succeeded(abut_geometry_destroy(two.universe, two.second)));
  const abut_geometry_id third = two.universe.add_geometry(two.part, two.ball);
  ASSERT_EQ(third.slot, two.second.slot) << "the slot is used again";
  EXPECT_EQ(two.step(), "eb");
  EXPECT_TRUE(two.universe.events().at(0).geometry_b == two.second);
  EXPECT_TRUE(two.universe.events().at(1).geometry_b == third);
  ASSERT_TRUE(succeeded(abut_geometry_destroy(two.universe, third)));
  ASSERT_TRUE(succeeded(abut_geometry_destroy(two.universe, two.universe.add_geometry(two.part, two.ball))));
  const abut_geometry_id last = two.universe.add_geometry(two.part, two.ball);
  EXPECT_EQ(two.step(), "eb") << "one that came and went between two steps was never seen";
  EXPECT_TRUE(two.universe.events().at(0).geometry_b == third);
  EXPECT_TRUE(two.universe.events().at(1).geometry_b == last);
}

TEST(Events, OfAPairThatIsOnlyBoxes) {
  Two two;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_BOX;
  ASSERT_TRUE(succeeded(abut_policy_set(two.universe, 0, 0, &policy)));
  two.universe.move(two.part, at(1.9, 1.9, 0));  // the balls are apart, their boxes are not
  EXPECT_EQ(two.step(), "b");
  EXPECT_EQ(two.universe.events().at(0).contact_count, 0U);
  EXPECT_TRUE(two.universe.contacts().empty());
  EXPECT_EQ(two.step(), "p");
  two.universe.move(two.part, at(2.1, 1.9, 0));
  EXPECT_EQ(two.step(), "e");
}

TEST(Events, AreBorrowedUntilTheNextStep) {
  Two two;
  two.step();
  const abut_event *first = nullptr, *again = nullptr;
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_universe_events(two.universe, &first, &count)));
  ASSERT_TRUE(succeeded(abut_universe_events(two.universe, &again, &count)));
  EXPECT_EQ(first, again);
  EXPECT_EQ(count, 1U);
}

}  // namespace
