// SPDX-License-Identifier: Apache-2.0
// Counts and times of all steps, as a table or as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "world.hpp"

namespace cli {

/// Keeps no steps, so that a run may have any number of them.
class Measure {
 public:
  void add(double value);
  [[nodiscard]] double minimum() const { return minimum_; }
  [[nodiscard]] double mean() const { return count_ > 0.0 ? total_ / count_ : 0.0; }
  [[nodiscard]] double maximum() const { return maximum_; }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] double total() const { return total_; }

 private:
  double count_ = 0.0;
  double minimum_ = 0.0;
  double maximum_ = 0.0;
  double last_ = 0.0;
  double total_ = 0.0;
};

class Summary {
 public:
  /// Adds the last step of a world, which took so long as a whole.
  void add(const World& world, double milliseconds);

  [[nodiscard]] std::string table(const World& world) const;
  [[nodiscard]] std::string json(const World& world) const;

 private:
  std::uint64_t steps_ = 0;
  std::array<Measure, 9> counts_;
  Measure elements_;
  std::array<Measure, 6> milliseconds_;
};

}  // namespace cli
