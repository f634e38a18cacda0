// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

import abut.core;

namespace {

using abut::Lazy;

TEST(Lazy, IsNotMadeBeforeItIsAskedFor) {
  const Lazy<int> number;
  EXPECT_FALSE(number.is_made());
  EXPECT_EQ(number.get([] { return 7; }), 7);
  EXPECT_TRUE(number.is_made());
}

TEST(Lazy, LaterMakersAreNotCalled) {
  const Lazy<int> number;
  const int& first = number.get([] { return 7; });
  const int& second = number.get([]() -> int { throw std::logic_error("called again"); });
  EXPECT_EQ(second, 7);
  EXPECT_EQ(&first, &second);
}

TEST(Lazy, CopyMakesItsOwn) {
  const Lazy<std::string> word;
  EXPECT_EQ(word.get([] { return std::string("first"); }), "first");
  const Lazy<std::string> copy = word;
  EXPECT_FALSE(copy.is_made());
  EXPECT_EQ(copy.get([] { return std::string("second"); }), "second");
  EXPECT_EQ(word.get([] { return std::string("third"); }), "first");
}

TEST(Lazy, MovedToMakesItsOwn) {
  Lazy<int> number;
  EXPECT_EQ(number.get([] { return 1; }), 1);
  const Lazy<int> moved(std::move(number));
  EXPECT_FALSE(moved.is_made());
  EXPECT_EQ(moved.get([] { return 2; }), 2);
}

// A maker may run out of memory; whoever asks next tries again.
TEST(Lazy, FailedMakerLeavesItUnmade) {
  const Lazy<int> number;
  const auto fail = []() -> int { throw std::runtime_error("no"); };
  EXPECT_THROW(static_cast<void>(number.get(fail)), std::runtime_error);
  EXPECT_FALSE(number.is_made());
  EXPECT_EQ(number.get([] { return 3; }), 3);
}

TEST(Lazy, ExactlyOneOfManyThreadsMakesIt) {
  constexpr std::size_t thread_count = 8;
  for (int round = 0; round < 50; ++round) {
    const Lazy<std::vector<int>> numbers;
    std::atomic<int> made = 0, wrong = 0;
    std::atomic<std::size_t> waiting = 0;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < thread_count; ++i) {
      threads.emplace_back([&] {
        // All ask at once, as nearly as can be had.
        ++waiting;
        while (waiting < thread_count) {
          std::this_thread::yield();
        }
        const std::vector<int>& got = numbers.get([&] {
          ++made;
          return std::vector<int>{1, 2, 3};
        });
        wrong += got == std::vector<int>{1, 2, 3} ? 0 : 1;
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    EXPECT_EQ(made, 1);
    EXPECT_EQ(wrong, 0);
  }
}

TEST(Lazy, IsMadeAnewAfterItWasForgotten) {
  Lazy<int> number;
  EXPECT_EQ(number.get([] { return 1; }), 1);
  number.forget();
  EXPECT_FALSE(number.is_made());
  EXPECT_EQ(number.get([] { return 2; }), 2);
}

static_assert(!std::is_copy_assignable_v<Lazy<int>>);

}  // namespace
