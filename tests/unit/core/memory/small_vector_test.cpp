// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <random>
#include <span>
#include <utility>
#include <vector>

import abut.core;

namespace {

using Small = abut::SmallVector<int, 4>;

std::vector<int> all_of(const Small& numbers) { return {numbers.span().begin(), numbers.span().end()}; }

TEST(SmallVector, BeginsEmpty) {
  const Small numbers;
  EXPECT_TRUE(numbers.empty());
  EXPECT_EQ(numbers.size(), 0u);
  EXPECT_TRUE(numbers.span().empty());
}

TEST(SmallVector, FirstElementsLieInside) {
  Small numbers;
  for (int i = 0; i < 4; ++i) {
    numbers.push_back(10 + i);
  }
  EXPECT_EQ(all_of(numbers), (std::vector{10, 11, 12, 13}));
  const std::span<const std::byte> inside = std::as_bytes(std::span(&numbers, 1));
  const std::byte* first = std::as_bytes(numbers.span()).data();
  EXPECT_TRUE(std::greater_equal<>()(first, inside.data()) && std::less_equal<>()(first, &inside.back()));
}

TEST(SmallVector, MoreElementsStayOneSpan) {
  Small numbers;
  std::vector<int> expected;
  for (int i = 0; i < 50; ++i) {
    numbers.push_back(i * i);
    expected.push_back(i * i);
    ASSERT_EQ(all_of(numbers), expected);
    ASSERT_EQ(numbers.size(), expected.size());
    ASSERT_FALSE(numbers.empty());
    ASSERT_EQ(numbers[expected.size() - 1], i * i);
  }
}

TEST(SmallVector, ElementsCanBeChanged) {
  Small numbers;
  for (int i = 0; i < 6; ++i) {
    numbers.push_back(i);
    numbers[static_cast<std::size_t>(i)] += 100;
  }
  numbers.span()[0] = -1;
  EXPECT_EQ(all_of(numbers), (std::vector{-1, 101, 102, 103, 104, 105}));
  EXPECT_EQ(std::as_const(numbers)[5], 105);
}

// Pushing an element of its own must read it before anything moves.
TEST(SmallVector, TakesElementsOfItsOwn) {
  Small numbers;
  numbers.push_back(1);
  for (std::size_t i = 0; i < 40; ++i) {
    numbers.push_back(numbers[i]);
  }
  EXPECT_EQ(all_of(numbers), std::vector<int>(41, 1));
}

TEST(SmallVector, CopyIsApartFromItsSource) {
  for (const int count : {3, 9}) {
    Small numbers;
    for (int i = 0; i < count; ++i) {
      numbers.push_back(i);
    }
    Small copy = numbers;
    copy[0] = 77;
    copy.push_back(78);
    EXPECT_EQ(numbers.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(numbers[0], 0);
    EXPECT_EQ(copy[0], 77);
    EXPECT_EQ(copy[static_cast<std::size_t>(count)], 78);
  }
}

TEST(SmallVector, IsLikeAVectorWhateverIsDone) {
  std::mt19937 random(21);
  Small numbers;
  std::vector<int> expected;
  for (int i = 0; i < 5000; ++i) {
    if (random() % 9 == 0) {
      numbers.clear();
      expected.clear();
    } else if (const bool counts = random() % 2 == 0; random() % 3 == 0) {
      numbers.push_back_if(i, counts);
      if (counts) {
        expected.push_back(i);
      }
    } else {
      numbers.push_back(i);
      expected.push_back(i);
    }
    ASSERT_EQ(all_of(numbers), expected);
    ASSERT_EQ(numbers.empty(), expected.empty());
  }
}

}  // namespace
