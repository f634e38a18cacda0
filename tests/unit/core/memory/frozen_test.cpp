// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <utility>

import abut.core;

namespace {

using abut::Frozen;

TEST(Frozen, HoldsWhatItWasMadeFrom) {
  const Frozen<std::string> word(std::string("rotor"));
  EXPECT_EQ(*word, "rotor");
  EXPECT_EQ(word->size(), 5u);
}

TEST(Frozen, CopiesShareOneValue) {
  const Frozen<std::string> word(std::string("rotor"));
  const Frozen<std::string> copy = word;
  EXPECT_TRUE(word.same_as(copy));
  EXPECT_EQ(&*word, &*copy);
}

TEST(Frozen, EqualValuesMadeApartAreNotTheSame) {
  const Frozen<std::string> one(std::string("rotor")), other(std::string("rotor"));
  EXPECT_EQ(*one, *other);
  EXPECT_FALSE(one.same_as(other));
}

TEST(Frozen, CopyOutlivesItsSource) {
  Frozen<std::string> copy(std::string("short"));
  {
    const Frozen<std::string> source(std::string("long enough to live on the heap"));
    copy = source;
  }
  EXPECT_EQ(*copy, "long enough to live on the heap");
}

// A change means a new value: other holders keep what they have.
TEST(Frozen, AssignmentLeavesOtherCopiesAlone) {
  Frozen<int> first(1);
  const Frozen<int> second = first;
  first = Frozen<int>(2);
  EXPECT_EQ(*first, 2);
  EXPECT_EQ(*second, 1);
}

TEST(Frozen, ValueIsMovedInOnce) {
  struct Counted {
    int copies = 0;
    Counted() = default;
    Counted(const Counted& other) : copies(other.copies + 1) {}
    Counted(Counted&&) = default;
    Counted& operator=(const Counted&) = default;
    Counted& operator=(Counted&&) = default;
    ~Counted() = default;
  };
  const Frozen<Counted> counted{Counted{}};
  const Frozen<Counted> copy = counted;
  EXPECT_EQ(copy->copies, 0);
}

TEST(Frozen, TheOnlyHolderChangesTheValueInPlace) {
  Frozen<std::string> word(std::string("rotor"));
  const std::string* const before = &*word;
  word.own() = "motor";
  EXPECT_EQ(*word, "motor");
  EXPECT_EQ(&*word, before);
}

TEST(Frozen, OneOfSeveralHoldersChangesACopy) {
  Frozen<std::string> word(std::string("rotor"));
  const Frozen<std::string> other = word;
  word.own() = "motor";
  EXPECT_EQ(*word, "motor");
  EXPECT_EQ(*other, "rotor");
  const std::string* const copy = &*word;
  word.own() = "tutor";
  EXPECT_EQ(&*word, copy) << "the copy has one holder";
}

}  // namespace
