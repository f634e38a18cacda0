// SPDX-License-Identifier: Apache-2.0
// Sequences of calls from any bytes. A call is a record of 16 bytes, the first
// record says how the universes are made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace universe_calls {

// Numbers that depend on the seed alone: SplitMix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }

 private:
  std::uint64_t state_;
};

enum class Operation : std::uint8_t {
  create_part,
  destroy_part,
  destroy_parts,
  place,
  place_all,
  set_motion,
  create_geometry,
  create_geometries,
  destroy_geometry,
  destroy_geometries,
  set_options,
  set_shape,
  park,
  park_all,
  set_rule,
  clear_rules,
  set_sleep,
  set_filter,
  refilter,
  set_policy,
  set_focus,
  step,
  detect_all,
  detect_pairs,
  detect_region,
  refresh,
  mark_contacts,
  set_parameters,
  set_samples,
  set_velocity,
  follow_islands,
  bad,
};

inline constexpr std::size_t call_size = 16;
// Further calls of an input are not looked at.
inline constexpr std::size_t most_calls = 400;

// What the bytes of a call mean depends on its operation.
struct Call {
  std::array<std::uint8_t, call_size> bytes{};

  Operation operation() const;
  // Which of the things that live, or which of some values.
  std::size_t pick(std::size_t byte, std::size_t count) const { return count == 0 ? 0 : bytes.at(byte) % count; }
  int number(std::size_t byte, int low, int high) const;
  bool has(std::size_t byte, unsigned bit) const { return ((bytes.at(byte) >> bit) & 1u) != 0; }
};

struct Sequence {
  Call setup;
  std::vector<Call> calls;
};

// Missing bytes of the last record are zero.
Sequence read_sequence(std::span<const std::uint8_t> bytes);
std::vector<std::uint8_t> bytes_of(const Sequence& sequence);
Sequence random_sequence(std::uint64_t seed, std::size_t count);
std::string_view name_of(Operation operation);

// One change that keeps records whole: insert, delete, repeat, swap, take over
// from another place, or change a byte.
void mutate(Sequence& sequence, std::uint64_t seed, std::size_t most);
// The beginning of one and the end of another.
Sequence spliced(const Sequence& one, const Sequence& other, std::uint64_t seed);

}  // namespace universe_calls
