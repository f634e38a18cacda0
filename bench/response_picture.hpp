// SPDX-License-Identifier: Apache-2.0
// Errors of moving bodies as a table and as a picture.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct Measured {
  std::string trial, error_name, engine, effort;
  double milliseconds = 0;  // a step
  double error = 0;
};

void write_table(const std::filesystem::path& path, const std::vector<Measured>& all);
// A panel for each trial: error over milliseconds a step, both logarithmic.
void draw_errors(const std::filesystem::path& path, const std::vector<Measured>& all);

}  // namespace bench
