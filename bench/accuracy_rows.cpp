// SPDX-License-Identifier: Apache-2.0
#include "accuracy_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numeric>

#include "accuracy_solids.hpp"
#include "accuracy_survivors.hpp"
#include "statistics.hpp"

namespace bench {
namespace {

// On the wrong side by more than this part of the size is no answer.
constexpr double wrong_side = 1e-6;
// The default bounds of abut, as the header names them.
constexpr double usual_bound = 1e-12, usual_bound_of_curves = 1e-9;
// A repetition asks a cell again until it has taken this long: the clock counts microseconds.
constexpr double least_seconds = 5e-4;

double bound_of(const AbutQuery& asked, const JudgedCell& cell) {
  if (asked.error_bound > 0) {
    return asked.error_bound;
  }
  const bool has_curved = is_curved(cell.solids_a.front().kind) || is_curved(cell.solids_b.front().kind);
  return has_curved ? usual_bound_of_curves : usual_bound;
}

// libccd promises no bounds.
bool is_bounded(const AbutQuery& asked) {
  return asked.algorithm != ABUT_ALGORITHM_LIBCCD_GJK && asked.algorithm != ABUT_ALGORITHM_LIBCCD_MPR;
}

double minus(double value, oracle::Quad truth) { return static_cast<double>(oracle::quad(value) - truth); }

// By the size. A yes or no that is wrong is off by what the pair is apart or deep.
double error_of(Query query, const JudgedCell& cell, double found, std::size_t i) {
  if (query != Query::overlap) {
    return std::fabs(minus(found, cell.truths[i])) / cell.sizes[i];
  }
  const bool is_right = (found < 0) == (cell.truths[i] < 0);
  return is_right ? 0 : std::fabs(static_cast<double>(cell.truths[i])) / cell.sizes[i];
}

Broken broken_by(const AbutQuery& asked, const JudgedCell& cell, std::span<const Answer> answers) {
  Broken broken;
  const std::vector<Interval> intervals = abut_intervals(cell.cell(), asked);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].points == 0) {
      continue;
    }
    const auto& [lower, upper] = intervals[i];
    const double rounding = cell.roundings[i], most = bound_of(asked, cell) * cell.sizes[i] + rounding;
    const bool holds = minus(lower, cell.truths[i]) <= rounding && minus(upper, cell.truths[i]) >= -rounding;
    broken.outside += holds ? 0 : 1;
    if (is_bounded(asked) && is_bounded_and_convex(cell.solids_a.front().kind)) {
      broken.beyond += std::fabs(minus(answers[i].distance, cell.truths[i])) <= most ? 0 : 1;
      broken.wide += upper - lower <= most ? 0 : 1;
    }
  }
  return broken;
}

// `kept`: the numbers of the cases among all that were asked.
void add_errors(Query query, const AbutQuery& asked, const JudgedCell& cell, std::span<const Answer> answers,
                std::span<const std::size_t> kept, Row& row) {
  double most = -1;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const double found = answers[i].distance, error = error_of(query, cell, found, i);
    const bool is_far_off = error > std::max(wrong_side, asked.error_bound);
    const bool is_wrong = (found < 0) != (cell.truths[i] < 0) && is_far_off;
    // Two that overlap by so little may have no contact.
    const bool is_answered = answers[i].points > 0 || (query == Query::contacts && !is_far_off);
    const bool is_first_failure = row.failed.total() == 0;
    if (!is_answered) {
      ++row.failed.none;
    } else if (!std::isfinite(found)) {
      ++row.failed.not_finite;
    } else if (is_wrong) {
      ++row.failed.wrong_side;
    } else {
      row.errors.push_back(error);
      if (row.failed.total() == 0 && error > most) {
        most = error;
        row.worst = kept[i];
      }
      continue;
    }
    if (is_first_failure) {
      row.worst = kept[i];
    }
  }
}

// The first of all cases that is not among those kept.
std::size_t first_missing(std::span<const std::size_t> kept) {
  std::size_t i = 0;
  while (i < kept.size() && kept[i] == i) {
    ++i;
  }
  return i;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Seconds of one round over all cases.
double timed(Contender& contender, std::span<Answer> answers) {
  const double start = processor_seconds();
  double seconds = 0;
  std::size_t rounds = 0;
  for (std::size_t next = 1; seconds < least_seconds; next *= 2) {
    for (std::size_t i = 0; i < next; ++i) {
      contender.answer(answers);
    }
    rounds += next;
    seconds = processor_seconds() - start;
  }
  return seconds / static_cast<double>(rounds);
}

// An entrant that is ready to be timed.
struct Ready {
  Row row;
  std::unique_ptr<Contender> contender;
  std::vector<Answer> answers;
  std::vector<double> times;
};

std::unique_ptr<Contender> made(const Entrant& entrant, Query query, const Cell& cell) {
  // Its routes have no answer for pairs that are apart.
  if (query == Query::distance && !is_bounded(entrant.asked)) {
    return nullptr;
  }
  return entrant.make == nullptr ? make_abut(query, cell, entrant.asked) : entrant.make(query, cell);
}

// Nothing where the library lacks the query, or answers none of the cases.
std::optional<Ready> ready(const Entrant& entrant, Query query, const JudgedCell& all) {
  Ready result;
  result.contender = made(entrant, query, all.cell());
  if (!result.contender) {
    return std::nullopt;
  }
  JudgedCell cell = all;
  std::vector<std::size_t> kept(all.cases.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  if (entrant.make != nullptr) {
    kept = survivors(entrant, query, all.cell());
    cell = all.only(kept);
    result.contender = cell.cases.empty() ? nullptr : made(entrant, query, cell.cell());
  }
  result.row.cases = all.cases.size();
  result.row.failed.ended = all.cases.size() - cell.cases.size();
  result.row.worst = result.row.failed.ended > 0 ? first_missing(kept) : 0;
  result.answers.resize(cell.cases.size());
  if (result.contender) {
    result.contender->answer(result.answers);
    add_errors(query, entrant.asked, cell, result.answers, kept, result.row);
    for (const Answer& answer : result.answers) {
      result.row.points += static_cast<double>(answer.points) / static_cast<double>(result.answers.size());
    }
  }
  if (entrant.make == nullptr && (query == Query::distance || query == Query::depth)) {
    result.row.broken = broken_by(entrant.asked, cell, result.answers);
  }
  return result;
}

constexpr std::array every{Entrant{"abut", nullptr, {}},
                           Entrant{"abut 1e-2", nullptr, {ABUT_ALGORITHM_AUTO, 1e-2}},
                           Entrant{"abut 1e-4", nullptr, {ABUT_ALGORITHM_AUTO, 1e-4}},
                           Entrant{"abut 1e-6", nullptr, {ABUT_ALGORITHM_AUTO, 1e-6}},
                           Entrant{"abut 1e-9", nullptr, {ABUT_ALGORITHM_AUTO, 1e-9}},
                           Entrant{"abut 1e-12", nullptr, {ABUT_ALGORITHM_AUTO, 1e-12}},
                           Entrant{"abut analytic", nullptr, {ABUT_ALGORITHM_ANALYTIC}},
                           Entrant{"abut sat", nullptr, {ABUT_ALGORITHM_SAT}},
                           Entrant{"abut gjk_epa", nullptr, {ABUT_ALGORITHM_GJK_EPA}},
                           Entrant{"abut libccd_gjk", nullptr, {ABUT_ALGORITHM_LIBCCD_GJK}},
                           Entrant{"abut libccd_mpr", nullptr, {ABUT_ALGORITHM_LIBCCD_MPR}},
                           Entrant{"bullet", make_bullet, {}},
                           Entrant{"fcl", make_fcl, {}},
                           Entrant{"ode", make_ode, {}},
                           Entrant{"box3d", make_box3d, {}},
                           Entrant{"jolt", make_jolt, {}},
                           Entrant{"coal", make_coal, {}},
                           Entrant{"libccd_gjk", make_libccd_gjk, {}},
                           Entrant{"libccd_mpr", make_libccd_mpr, {}}};

}  // namespace

std::span<const Entrant> entrants() { return every; }

std::vector<std::size_t> all_entrants() {
  std::vector<std::size_t> all(every.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<std::size_t> entrants_of(std::span<const std::string_view> names) {
  std::vector<std::size_t> list = all_entrants();
  std::erase_if(list, [names](std::size_t i) { return std::ranges::find(names, every[i].name) == names.end(); });
  return list;
}

std::vector<Row> measured(Query query, const JudgedCell& cell, std::size_t repetitions,
                          std::span<const std::size_t> chosen) {
  std::vector<Ready> entered;
  for (const std::size_t i : chosen) {
    if (auto one = ready(entrants()[i], query, cell)) {
      one->row.query = query;
      one->row.entrant = i;
      entered.push_back(std::move(*one));
    }
  }
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    for (Ready& one : entered) {
      if (one.contender) {
        one.times.push_back(timed(*one.contender, one.answers));
      }
    }
  }
  std::vector<Row> rows;
  for (Ready& one : entered) {
    if (!one.times.empty()) {
      one.row.nanoseconds = median(one.times) * 1e9 / static_cast<double>(one.answers.size());
    }
    rows.push_back(std::move(one.row));
  }
  return rows;
}

Row together(std::span<const Row> rows) {
  Row sum = rows.front();
  std::vector<double> times;
  for (const Row& row : rows) {
    if (row.nanoseconds > 0) {
      times.push_back(row.nanoseconds);
    }
  }
  for (const Row& row : rows.subspan(1)) {
    sum.errors.insert(sum.errors.end(), row.errors.begin(), row.errors.end());
    sum.pairs += row.pairs;
    sum.cases += row.cases;
    sum.failed.ended += row.failed.ended;
    sum.failed.none += row.failed.none;
    sum.failed.not_finite += row.failed.not_finite;
    sum.failed.wrong_side += row.failed.wrong_side;
    if (sum.broken && row.broken) {
      sum.broken->outside += row.broken->outside;
      sum.broken->beyond += row.broken->beyond;
      sum.broken->wide += row.broken->wide;
    }
  }
  sum.nanoseconds = times.empty() ? 0 : median(times);
  sum.pair = "all";
  return sum;
}

}  // namespace bench
