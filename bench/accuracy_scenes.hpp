// SPDX-License-Identifier: Apache-2.0
// Pairs of placed solids under conditions from ordinary to extreme, with what their signed distances are.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "accuracy_judge.hpp"
#include "pairs.hpp"

namespace bench {

enum class Condition : std::uint8_t { ordinary, thin, size_ratio, far, parallel, touching };

inline constexpr std::array all_conditions{Condition::ordinary, Condition::thin,     Condition::size_ratio,
                                           Condition::far,      Condition::parallel, Condition::touching};

[[nodiscard]] std::string_view condition_name(Condition condition);
[[nodiscard]] std::string_view condition_title(Condition condition);

struct JudgedCell {
  std::vector<Solid> solids_a, solids_b;
  std::vector<Case> cases;
  std::vector<oracle::Quad> truths;  // one for each case
  std::vector<double> sizes;         // sum of the diameters of both; of a cast by the length of the motion
  std::vector<double> roundings;     // what coordinates of both relative to each other may be off by

  void add(const Case& one, oracle::Quad truth);
  [[nodiscard]] Cell cell() const { return {solids_a, solids_b, cases}; }
  [[nodiscard]] JudgedCell only(const std::vector<std::size_t>& chosen) const;
};

class AccuracyScenes {
 public:
  // Nothing where the oracle has no answer, or where the condition makes no sense for the pair. Of a ray, `b` is a
  // point.
  [[nodiscard]] std::optional<JudgedCell> make(Query query, Condition condition, Kind a, Kind b, std::size_t count);

 private:
  using Name = std::tuple<Query, Condition, Kind, Kind, std::size_t>;

  enum class Form : std::uint8_t { ordinary, thin, of_two_sizes };
  struct Pool {
    std::vector<Solid> solids;
    std::vector<Judge> judges;
  };

  [[nodiscard]] std::optional<JudgedCell> judged(Query query, Condition condition, Kind a, Kind b, std::size_t count);
  // As many apart as overlapping.
  [[nodiscard]] std::optional<JudgedCell> make_overlaps(Condition condition, Kind a, Kind b, std::size_t count);
  [[nodiscard]] static Form form_of(Condition condition);
  Pool& pool(Form form, Kind kind);

  std::map<std::pair<Form, Kind>, Pool> pools_;
  std::map<Name, std::optional<JudgedCell>> made_;  // the oracle takes its time
};

}  // namespace bench
