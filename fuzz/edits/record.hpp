// SPDX-License-Identifier: Apache-2.0
// Bytes as a shape that is edited: any bytes are valid, those that are missing are zero.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace edit_fuzzing {

inline constexpr std::size_t record_size = 16, most_edits = 60;

// One edit; of the first record, how the shape is made.
struct Record {
  std::array<std::uint8_t, record_size> bytes{};

  [[nodiscard]] std::size_t pick(std::size_t byte, std::size_t count) const { return bytes.at(byte) % count; }
  // From -1 to 1, in steps of an eighth: flat parts and equal heights come up.
  [[nodiscard]] double number(std::size_t byte) const { return (static_cast<double>(bytes.at(byte) % 17) - 8) / 8; }
};

[[nodiscard]] std::vector<Record> read_records(std::span<const std::uint8_t> bytes);

// Plays the edits on a shape that a geometry has. Empty, or what is wrong.
struct Counts {
  std::size_t edits = 0, refused = 0, rays = 0, distances = 0, touches = 0, excused = 0;
};
[[nodiscard]] std::string finding_of(std::span<const std::uint8_t> bytes, Counts& counts);

}  // namespace edit_fuzzing
