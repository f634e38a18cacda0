// SPDX-License-Identifier: Apache-2.0
// What one library, asked in one way, answered to the cases of a cell, and in what time.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "abut_queries.hpp"
#include "accuracy_scenes.hpp"

namespace bench {

struct Entrant {
  std::string_view name;
  std::unique_ptr<Contender> (*make)(Query query, const Cell& cell) = nullptr;  // null: abut, asked as below
  AbutQuery asked{};
};

// In the order of all tables. The first are abut with its default bound and with others, the coarsest first.
[[nodiscard]] std::span<const Entrant> entrants();
// The numbers of all entrants, and of those with the given names.
[[nodiscard]] std::vector<std::size_t> all_entrants();
[[nodiscard]] std::vector<std::size_t> entrants_of(std::span<const std::string_view> names);
inline constexpr std::size_t first_bound = 1, bound_count = 5;

// Of abut only: answers that break what it says about them, each beyond the rounding of coordinates.
struct Broken {
  std::size_t outside = 0;  // the true distance lies outside of [lower, upper]
  std::size_t beyond = 0;   // off by more than the error bound
  std::size_t wide = 0;     // upper - lower is larger than the error bound
};

// Cases without an answer that counts.
struct Failures {
  std::size_t ended = 0;       // the process ended, or no answer came in time
  std::size_t none = 0;        // the library said that it has no answer
  std::size_t not_finite = 0;  // no finite number
  std::size_t wrong_side = 0;  // apart for overlapping or the other way round, by more than 1e-6 of the size

  [[nodiscard]] std::size_t total() const { return ended + none + not_finite + wrong_side; }
};

struct Row {
  Query query = Query::distance;
  Condition condition = Condition::ordinary;
  std::string pair;
  std::size_t entrant = 0;
  double nanoseconds = 0;      // per query; 0 where every case ended the process
  std::vector<double> errors;  // relative to the size, of the answers that did not fail
  std::size_t pairs = 1, cases = 0;
  Failures failed;
  std::size_t worst = 0;  // of the cases: the first that failed, or else the one of the largest error
  std::optional<Broken> broken;
  double points = 0;  // of contacts: how many there are, on the average of all answers
};

// One row for each of the chosen entrants that has the query; question, condition and pair are left to the caller. The
// repetitions of all are interleaved.
[[nodiscard]] std::vector<Row> measured(Query query, const JudgedCell& cell, std::size_t repetitions,
                                        std::span<const std::size_t> chosen);

// The rows of all pairs as one: the median of their times, and all errors together. They are of one question, one
// condition and one entrant.
[[nodiscard]] Row together(std::span<const Row> rows);

}  // namespace bench
