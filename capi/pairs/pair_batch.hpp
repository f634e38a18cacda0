// SPDX-License-Identifier: Apache-2.0
// Many pairs of poses of the same two shapes, asked about on several threads. A kernel may fail at the last pair, and
// then nothing must have been written: what threads find goes to the caller when all of it is there.
#ifndef ABUT_CAPI_PAIR_BATCH_HPP
#define ABUT_CAPI_PAIR_BATCH_HPP

#include "pairs/pair_query.hpp"

import abut.core.workers;

namespace abut::capi {

struct [[gsl::Pointer]] PairBatch {
  const abut_shape *a, *b;
  std::span<const abut_pose> poses_a, poses_b;

  [[nodiscard]] std::size_t size() const { return poses_a.size(); }
  [[nodiscard]] PlacedPair at(std::size_t i) const { return {a, b, poses_a[i], poses_b[i]}; }
};

// Shapes that are there and as many poses as the argument `count_name` says, all checked.
[[nodiscard]] abut_status read_batch(const abut_shape* a, const abut_pose* poses_a, const abut_shape* b,
                                     const abut_pose* poses_b, std::string_view count_name, std::size_t count,
                                     PairBatch& pairs);

// For the pair of that number.
[[nodiscard]] [[gnu::cold]] abut_status refuse_pair(std::size_t number, Outcome outcome, const PairBatch& pairs,
                                                    Algorithm algorithm);

// The tasks of a batch. What one of them finds is a `Found`, which is told by reserve() how many pairs it has.
template <class Found>
class BatchTasks {
 public:
  BatchTasks(std::size_t count, std::uint32_t threads)
      : workers_(count < 2 * least_of_task ? 1 : threads),
        cuts_(workers_.cut(count, least_of_task)),
        tasks_(cuts_.tasks()) {}

  // Calls find(number of a pair, found of its task) -> Outcome for each pair. The first pair that fails is the answer.
  template <class Find>
  [[nodiscard]] abut_status run(const PairBatch& pairs, Algorithm algorithm, Find&& find) {
    workers_.for_each(tasks_.size(), [&](std::size_t number) {
      Task& its = tasks_[number];
      its.found.reserve(cuts_.end(number) - cuts_.begin(number));
      its.next = cuts_.begin(number);
      while (its.next < cuts_.end(number) && (its.outcome = find(its.next, its.found)) == Outcome::ok) {
        ++its.next;
      }
    });
    for (const Task& its : tasks_) {
      if (its.outcome != Outcome::ok) {
        return refuse_pair(its.next, its.outcome, pairs, algorithm);
      }
    }
    return ABUT_OK;
  }

  // Calls give(number of the first pair of a task, what it found) for each task: in their order, or on all threads.
  template <class Give>
  void hand_over_in_order(Give&& give) const {
    for (std::size_t number = 0; number < tasks_.size(); ++number) {
      give(cuts_.begin(number), tasks_[number].found);
    }
  }
  template <class Give>
  void hand_over(Give&& give) const {
    workers_.for_each(tasks_.size(), [&](std::size_t number) { give(cuts_.begin(number), tasks_[number].found); });
  }

 private:
  // Below this many pairs a task costs more than it saves.
  static constexpr std::size_t least_of_task = 64;

  struct Task {
    Found found;
    std::size_t next = 0;  // the pair that it is at, or has failed at
    Outcome outcome = Outcome::ok;
  };

  Workers workers_;
  Cuts cuts_;
  std::vector<Task> tasks_;
};

// Answers of one record for each pair: find(number of the pair, record) -> Outcome.
template <class Record, class Find>
[[nodiscard]] abut_status answer_each(const PairBatch& pairs, Algorithm algorithm, std::uint32_t threads,
                                      std::span<Record> out, Find&& find) {
  BatchTasks<std::vector<Record>> tasks(pairs.size(), threads);
  const abut_status status = tasks.run(
      pairs, algorithm, [&](std::size_t i, std::vector<Record>& found) { return find(i, found.emplace_back()); });
  if (status == ABUT_OK) {
    tasks.hand_over([&](std::size_t first, const std::vector<Record>& found) {
      std::ranges::copy(found, out.subspan(first).begin());
    });
  }
  return status;
}

}  // namespace abut::capi

#endif
