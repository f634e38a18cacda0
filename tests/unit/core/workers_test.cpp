// SPDX-License-Identifier: Apache-2.0
// Work that threads share.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#ifdef ABUT_TEST_THREADS
#include <oneapi/tbb/global_control.h>
#endif

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

// Each element is in one task, in order, and no task is much longer than another.
TEST(Workers, CutAListIntoTasks) {
  EXPECT_EQ(Workers(1).cut(100000, 10).tasks(), 1U);
  for (const std::uint32_t threads : {1U, 2U, 5U}) {
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{1}, std::size_t{99}, std::size_t{100}, std::size_t{12345}}) {
      const abut::Cuts cuts = Workers(threads).cut(length, 50);
      ASSERT_GE(cuts.tasks(), 1U);
      std::size_t at = 0;
      for (std::size_t task = 0; task < cuts.tasks(); ++task) {
        EXPECT_EQ(cuts.begin(task), at);
        EXPECT_TRUE(cuts.tasks() == 1 || cuts.end(task) - at >= 50) << length << " cut into " << cuts.tasks();
        EXPECT_LE(cuts.end(task) - at, length / cuts.tasks() + 1);
        at = cuts.end(task);
      }
      EXPECT_EQ(at, length);
    }
  }
}

TEST(Workers, NoneMeansThoseOfTheMachine) {
  EXPECT_GE(Workers(0).threads(), 1U);
  EXPECT_EQ(Workers(1).threads(), 1U);
}

#ifdef ABUT_TEST_THREADS
TEST(Workers, AreAsManyAsTheProcessAllows) {
  EXPECT_EQ(Workers(0).threads(), std::uint32_t{ABUT_TEST_THREADS});
  EXPECT_EQ(Workers(5).threads(), 5U);
  EXPECT_EQ(Workers(1000).threads(), std::uint32_t{ABUT_TEST_THREADS});
  const tbb::global_control fewer(tbb::global_control::max_allowed_parallelism, 3);
  EXPECT_EQ(Workers(5).threads(), 3U);
}

// Every task waits for threads that have not been seen yet, so that nobody can do the work of all.
TEST(Workers, RunOnThatManyThreads) {
  const Workers workers(5);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  const auto count = [&] {
    const std::scoped_lock lock(mutex);
    seen.insert(std::this_thread::get_id());
    return seen.size();
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  workers.for_each(64, [&](std::size_t) {
    while (count() < 5 && std::chrono::steady_clock::now() < end) {
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(seen.size(), 5U);
}
#endif

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
