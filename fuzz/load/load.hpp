// SPDX-License-Identifier: Apache-2.0
// A universe of given bytes, and what has to hold of it whatever they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace load_fuzzing {

// An input is what follows the head of a saved universe: a checksum would keep every change of a byte out.
[[nodiscard]] std::vector<std::uint8_t> with_head(std::span<const std::uint8_t> body);
[[nodiscard]] std::vector<std::uint8_t> without_head(std::span<const std::uint8_t> bytes);

// Loads, steps, asks and saves. Empty, or what is wrong.
[[nodiscard]] std::string finding_of(std::span<const std::uint8_t> body);
// Whether there is a universe of these bytes.
[[nodiscard]] bool is_loaded(std::span<const std::uint8_t> body);

// Saved universes to begin with, without their heads.
struct Seed {
  std::string name;
  std::vector<std::uint8_t> body;
};
[[nodiscard]] std::vector<Seed> seeds();

}  // namespace load_fuzzing
