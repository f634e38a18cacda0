// SPDX-License-Identifier: Apache-2.0
// The command line.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace cli {

enum class Command { help, version, shapes, run, explain, explain_pair };

struct Arguments {
  Command command = Command::help;
  std::string scene;
  std::string geometry_a, geometry_b;  // of a pair to explain
  std::optional<std::uint64_t> steps;
  std::optional<double> dt;
  std::optional<std::uint32_t> threads;
  std::string contacts;  // empty: none
  std::string events;    // empty: none
  bool quiet = false;
  bool json = false;
};

/// Throws BadInput with one sentence about the first argument that makes no sense.
[[nodiscard]] Arguments parse_arguments(std::span<const std::string> words);

[[nodiscard]] const char* usage();

}  // namespace cli
