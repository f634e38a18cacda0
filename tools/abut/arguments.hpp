// SPDX-License-Identifier: Apache-2.0
// The command line.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "abut/abut.h"
#include "command_table.hpp"

namespace cli {

struct Arguments {
  Command command = Command::help;
  std::vector<std::string> operands;  // as many as the table says
  std::optional<Command> about;       // of help: the command that it is asked about
  std::optional<std::uint64_t> steps;
  std::optional<double> dt;
  std::optional<std::uint32_t> threads;
  std::string contacts;        // empty: none
  std::string elements;        // empty: none
  std::string events;          // empty: none
  std::string states;          // empty: none
  std::string motion;          // empty: none
  std::uint32_t width = 1280;  // of a picture
  std::uint32_t height = 720;
  std::optional<abut_vec3> from;
  std::optional<abut_vec3> to;
  std::optional<abut_vec3> up;
  double error_bound = 0;  // of options; 0: the default
  double time_budget = 0;  // of options, in seconds; 0: none
  std::string routes;      // a table of them; empty: that of the library
  std::string build;       // of a report: a folder; empty: that of the sources
  std::string compare;     // empty: no other report
  std::string out;         // empty: the folder that report.py chooses
  bool quick = false;
  bool quiet = false;
  bool json = false;
};

/// Throws BadInput with one sentence about the first argument that makes no sense.
[[nodiscard]] Arguments parse_arguments(std::span<const std::string> words);

}  // namespace cli
