// SPDX-License-Identifier: Apache-2.0
// Errors of moving bodies as a table and as JSON.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct ErrorAt {
  double time = 0, error = 0;
};

struct Measured {
  std::string trial, error_name, engine, effort;
  double milliseconds = 0;  // a step
  double error = 0;
  std::vector<ErrorAt> course;  // the error over time, thinned out
};

void write_table(const std::filesystem::path& path, const std::vector<Measured>& all);
void write_json(const std::filesystem::path& path, const std::vector<Measured>& all);

}  // namespace bench
