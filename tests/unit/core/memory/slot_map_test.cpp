// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

import abut.core;

namespace {

struct Word;
using Words = abut::SlotMap<std::string, Word>;
using WordId = abut::Id<Word>;

TEST(SlotMap, FindsWhatWasInserted) {
  Words words(5);
  const WordId one = words.insert("one"), two = words.insert("two");
  EXPECT_NE(one, two);
  EXPECT_FALSE(one.is_null());
  ASSERT_TRUE(words.contains(one));
  ASSERT_TRUE(words.contains(two));
  EXPECT_EQ(words.at(one), "one");
  EXPECT_EQ(std::as_const(words).at(two), "two");
  EXPECT_EQ(words.size(), 2u);
  words.at(one) = "ONE";
  EXPECT_EQ(words.at(one), "ONE");
}

TEST(SlotMap, NullAndUnknownSlotsAreNotThere) {
  Words words(0);
  EXPECT_FALSE(words.contains({}));
  EXPECT_FALSE(words.contains({1, 0}));
  static_cast<void>(words.insert("one"));
  EXPECT_FALSE(words.contains({}));
  EXPECT_FALSE(words.contains({0, 0}));
  EXPECT_FALSE(words.contains({2, 0}));
  EXPECT_FALSE(words.contains({std::numeric_limits<std::uint32_t>::max(), 0}));
}

TEST(SlotMap, ErasedIdIsStaleEvenWhenItsSlotIsTakenAgain) {
  Words words(5);
  const WordId gone = words.insert("gone");
  EXPECT_TRUE(words.erase(gone));
  EXPECT_FALSE(words.contains(gone));
  EXPECT_EQ(words.size(), 0u);
  const WordId next = words.insert("next");
  EXPECT_EQ(next.slot, gone.slot);  // slots are used again, so that their number stays bounded
  EXPECT_FALSE(words.contains(gone));
  EXPECT_EQ(words.at(next), "next");
}

TEST(SlotMap, EraseTellsWhetherThereWasSomething) {
  Words words(5);
  const WordId word = words.insert("word");
  EXPECT_FALSE(words.erase({}));
  EXPECT_FALSE(words.erase({word.slot, word.generation + 1}));
  EXPECT_EQ(words.size(), 1u);
  EXPECT_TRUE(words.erase(word));
  EXPECT_FALSE(words.erase(word));
  EXPECT_EQ(words.size(), 0u);
}

TEST(SlotMap, IdsOfMapsThatStartElsewhereAreStale) {
  Words here(100), there(200);
  const WordId foreign = there.insert("there");
  const WordId own = here.insert("here");
  EXPECT_EQ(own.slot, foreign.slot);
  EXPECT_FALSE(here.contains(foreign));
  EXPECT_FALSE(here.erase(foreign));
  EXPECT_TRUE(here.contains(own));
}

TEST(SlotMap, GenerationsWrapAround) {
  Words words(std::numeric_limits<std::uint32_t>::max());
  const WordId last = words.insert("last");
  EXPECT_TRUE(words.erase(last));
  const WordId first = words.insert("first");
  EXPECT_EQ(first.slot, last.slot);
  EXPECT_FALSE(words.contains(last));
  EXPECT_EQ(words.at(first), "first");
}

TEST(SlotMap, IdAtSlotIsOfTheOneWhoLivesThere) {
  Words words(5);
  const WordId one = words.insert("one"), two = words.insert("two");
  EXPECT_EQ(words.id_at_slot(one.slot), one);
  EXPECT_EQ(words.id_at_slot(two.slot), two);
  EXPECT_TRUE(words.id_at_slot(0).is_null());
  EXPECT_TRUE(words.id_at_slot(3).is_null());
  words.erase(one);
  EXPECT_TRUE(words.id_at_slot(one.slot).is_null());
  const WordId again = words.insert("again");
  EXPECT_EQ(words.id_at_slot(again.slot), again);
}

// A value may hold on to much memory, such as a shape, and its slot may stay free for long.
TEST(SlotMap, ErasedValueIsDestroyedAtOnce) {
  struct Guest {
    explicit Guest(std::size_t& room) : inside(room) { ++inside; }
    Guest(Guest&& other) noexcept : inside(other.inside) { ++inside; }
    Guest(const Guest&) = delete;
    Guest& operator=(const Guest&) = delete;
    Guest& operator=(Guest&&) = delete;
    ~Guest() { --inside; }
    std::size_t& inside;
  };
  std::size_t inside = 0;
  abut::SlotMap<Guest, Word> guests(0);
  const WordId first = guests.insert(Guest(inside)), second = guests.insert(Guest(inside));
  EXPECT_EQ(inside, 2u);
  guests.erase(first);
  EXPECT_EQ(inside, 1u);
  EXPECT_EQ(guests.slot_count(), 2u);
  guests.erase(second);
  EXPECT_EQ(inside, 0u);
}

TEST(SlotMap, IsLikeAMapWhateverIsDone) {
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Words words(seed * 1000);
    std::map<WordId, std::string> expected;  // its order is by slot, since each slot holds one
    std::vector<WordId> gone;
    std::size_t most = 0;
    for (int i = 0; i < 3000; ++i) {
      if (expected.empty() || random() % 100 < 52) {
        const WordId id = words.insert(std::to_string(i));
        ASSERT_TRUE(expected.emplace(id, std::to_string(i)).second);
      } else {
        const auto victim = std::next(expected.begin(), static_cast<std::ptrdiff_t>(random() % expected.size()));
        ASSERT_TRUE(words.erase(victim->first));
        gone.push_back(victim->first);
        expected.erase(victim);
      }
      most = std::max(most, expected.size());
      ASSERT_EQ(words.size(), expected.size());
    }
    std::vector<std::pair<WordId, std::string>> visited;
    words.for_each([&](WordId id, const std::string& word) { visited.emplace_back(id, word); });
    EXPECT_EQ(visited, (std::vector<std::pair<WordId, std::string>>(expected.begin(), expected.end())));
    for (const auto& [id, word] : expected) {
      EXPECT_EQ(words.at(id), word);
    }
    for (const WordId& id : gone) {
      EXPECT_FALSE(words.contains(id));
    }
    // A free slot is taken before a new one is made.
    EXPECT_EQ(words.slot_count(), most);
    EXPECT_GE(words.bytes(), words.size() * sizeof(std::string));
  }
}

}  // namespace
