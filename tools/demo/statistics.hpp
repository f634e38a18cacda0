// SPDX-License-Identifier: Apache-2.0
// Counts and times of all steps, and the table made of them.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "cloth.hpp"
#include "owned.hpp"

namespace demo {

class Statistics {
 public:
  /// Takes the numbers of the last step and the time that the motion and the call took.
  void record(const abut_universe* universe, double motion_microseconds, double step_microseconds);

  /// Takes what the cloth found last in a step, and the time that it took.
  void record_cloth(const Cloth& cloth, double microseconds);

  /// Prints the table on the standard output.
  void print() const;

  [[nodiscard]] const std::vector<abut_step_stats>& steps() const { return steps_; }

 private:
  std::vector<abut_step_stats> steps_;
  std::vector<double> motion_;
  std::vector<double> whole_;
  std::vector<double> cloth_;
  std::vector<double> element_contacts_;
};

}  // namespace demo
