// SPDX-License-Identifier: Apache-2.0
// The command line of the demo.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace demo {

struct Options {
  std::uint32_t steps = 120;
  std::uint32_t bodies = 2000;
  std::uint64_t seed = 1;
  std::uint32_t threads = 0;
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  std::uint32_t every = 0;  // steps from one picture of a film to the next; 0: no film
  std::filesystem::path data = "data";
  std::filesystem::path out = "out";
  bool explain = false;
  bool help = false;
};

/// Throws Failure with one sentence about the first argument that makes no sense. A later option wins.
[[nodiscard]] Options parse_options(std::span<const std::string> arguments);

[[nodiscard]] const char* usage();

}  // namespace demo
