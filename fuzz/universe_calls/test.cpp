// SPDX-License-Identifier: Apache-2.0
// The judge refuses wrong answers, sequences keep their records whole, and
// random ones reach what they are meant to.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "play.hpp"

namespace universe_calls {
namespace {

// A wrong answer, made of a right one that has what it needs.
struct Wrong {
  const char* name;
  std::size_t contacts, events;  // at least
  std::function<void(Found&)> change;
};

std::vector<Wrong> wrong_answers() {
  return {
      {"a missing event", 0, 1,
       [](Found& f) {
         f.events.pop_back();
         f.stats.events -= 1;
       }},
      {"an event too many", 0, 1,
       [](Found& f) {
         f.events.push_back(f.events.back());
         f.stats.events += 1;
       }},
      {"events in another order", 0, 2, [](Found& f) { std::swap(f.events.front(), f.events.back()); }},
      {"another kind of event", 0, 1, [](Found& f) { f.events.back().kind = (f.events.back().kind + 1) % 3; }},
      {"an event of another contact", 0, 1, [](Found& f) { f.events.back().contact_id += 1; }},
      {"an event of another pair", 0, 1, [](Found& f) { f.events.back().geometry_b.generation += 1; }},
      {"an event with more contacts", 0, 1, [](Found& f) { f.events.back().contact_count += 1; }},
      {"a missing contact", 1, 0,
       [](Found& f) {
         f.contacts.pop_back();
         f.stats.contacts -= 1;
       }},
      {"a contact twice", 1, 0,
       [](Found& f) {
         f.contacts.push_back(f.contacts.back());
         f.stats.contacts += 1;
       }},
      {"contacts in another order", 9, 0, [](Found& f) { std::ranges::reverse(f.contacts); }},
      {"an older contact", 1, 0, [](Found& f) { f.contacts.back().age += 1; }},
      {"another value", 1, 0, [](Found& f) { f.contacts.back().user_data += 1; }},
      {"a longer normal", 1, 0, [](Found& f) { f.contacts.back().normal.x += 0.5; }},
      {"another distance", 1, 0, [](Found& f) { f.contacts.back().distance -= 0.5; }},
      {"a contact of others", 1, 0, [](Found& f) { f.contacts.back().geometry_a.generation += 1; }},
      {"more touching pairs", 0, 0, [](Found& f) { f.stats.touching_pairs += 1; }},
      {"more parts", 0, 0, [](Found& f) { f.stats.parts += 1; }},
      {"more parked geometries", 0, 0, [](Found& f) { f.stats.parked += 1; }},
  };
}

// All events, so that nothing wrong can hide.
Sequence loud_sequence(std::uint64_t seed) {
  Sequence sequence = random_sequence(seed, 150);
  sequence.setup.bytes.at(3) = 0;
  return sequence;
}

TEST(UniverseCalls, JudgeRefusesWrongAnswers) {
  for (const Wrong& wrong : wrong_answers()) {
    int changed = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      bool is_changed = false;
      std::size_t detections = 0;
      // The first answers are of an empty universe.
      const Tamper tamper = [&](Found& found) {
        ++detections;
        if (detections > 10 && found.contacts.size() >= wrong.contacts && found.events.size() >= wrong.events) {
          wrong.change(found);
          is_changed = true;
        }
      };
      Play play(loud_sequence(seed), tamper);
      const std::optional<std::string> finding = play.run();
      changed += is_changed ? 1 : 0;
      EXPECT_EQ(finding.has_value(), is_changed)
          << wrong.name << ", seed " << seed << ": " << finding.value_or("no finding");
    }
    EXPECT_GT(changed, 3) << wrong.name;
  }
}

TEST(UniverseCalls, RandomSequencesReachEverything) {
  Counts sum;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Play play(random_sequence(seed, 200));
    EXPECT_EQ(play.run(), std::nullopt) << "seed " << seed;
    sum.detections += play.counts().detections;
    sum.contacts += play.counts().contacts;
    sum.events += play.counts().events;
    sum.refusals += play.counts().refusals;
    sum.filtered += play.counts().filtered;
    sum.switched += play.counts().switched;
    sum.sleeps += play.counts().sleeps;
    sum.wakes += play.counts().wakes;
  }
  EXPECT_GT(sum.detections, 500u);
  EXPECT_GT(sum.contacts, 5000u);
  EXPECT_GT(sum.events, 5000u);
  EXPECT_GT(sum.refusals, 100u);
  EXPECT_GT(sum.filtered, 500u);
  EXPECT_GT(sum.switched, 50u);
  EXPECT_GT(sum.sleeps, 20u);
  EXPECT_GT(sum.wakes, 20u);
}

TEST(UniverseCalls, AnyBytesAreASequence) {
  EXPECT_TRUE(read_sequence({}).calls.empty());
  const std::vector<std::uint8_t> bytes(call_size + 5, 200);
  const Sequence sequence = read_sequence(bytes);
  ASSERT_EQ(sequence.calls.size(), 1u);
  EXPECT_EQ(sequence.calls[0].bytes.at(4), 200);
  EXPECT_EQ(sequence.calls[0].bytes.at(5), 0);
  EXPECT_EQ(read_sequence(std::vector<std::uint8_t>(10000 * call_size)).calls.size(), most_calls);
}

TEST(UniverseCalls, MutationsKeepRecordsWhole) {
  const std::vector<std::uint8_t> before = bytes_of(random_sequence(1, 30));
  std::size_t changed = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Sequence one = read_sequence(before), other = one;
    mutate(one, seed, most_calls);
    mutate(other, seed, most_calls);
    EXPECT_EQ(bytes_of(one), bytes_of(other)) << "the same seed, another change";
    EXPECT_EQ(bytes_of(one).size() % call_size, 0u);
    changed += bytes_of(one) != before ? 1 : 0;
    EXPECT_LE(spliced(one, other, seed).calls.size(), one.calls.size() + other.calls.size());
  }
  EXPECT_GT(changed, 180u);
  Sequence long_one = random_sequence(2, 40);
  mutate(long_one, 3, 10);
  EXPECT_LE(long_one.calls.size(), 10u);
}

}  // namespace
}  // namespace universe_calls
