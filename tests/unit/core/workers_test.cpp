// Work that threads share.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

import abut.core;

namespace {

using abut::Workers;

TEST(Workers, CallEachTaskOnce) {
  for (const std::uint32_t threads : {1U, 2U, 5U}) {
    const Workers workers(threads);
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{1000}}) {
      std::vector<std::atomic<int>> calls(count);
      workers.for_each(count, [&](std::size_t i) { ++calls[i]; });
      for (const std::atomic<int>& number : calls) {
        EXPECT_EQ(number.load(), 1) << threads << " threads, " << count << " tasks";
      }
    }
  }
}

TEST(Workers, NoneMeansThoseOfTheMachine) {
  EXPECT_GE(Workers(0).threads(), 1U);
  EXPECT_EQ(Workers(1).threads(), 1U);
}

TEST(Workers, HandOnWhatATaskThrows) {
  for (const std::uint32_t threads : {1U, 3U}) {
    const Workers workers(threads);
    const auto run = [&] {
      workers.for_each(100, [](std::size_t i) {
        if (i == 57) throw std::runtime_error("57");
      });
    };
    EXPECT_THROW(run(), std::runtime_error) << threads << " threads";
    std::atomic<int> calls = 0;
    workers.for_each(100, [&](std::size_t) { ++calls; });
    EXPECT_EQ(calls.load(), 100) << "after the throw, " << threads << " threads";
  }
}

TEST(Workers, CanBeMovedAndNested) {
  Workers first(3);
  const Workers workers = std::move(first);
  std::atomic<int> calls = 0;
  workers.for_each(8, [&](std::size_t) { workers.for_each(8, [&](std::size_t) { ++calls; }); });
  EXPECT_EQ(calls.load(), 64);
}

}  // namespace
