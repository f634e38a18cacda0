// SPDX-License-Identifier: Apache-2.0
#include "call.hpp"

#include <algorithm>
#include <utility>

namespace universe_calls {
namespace {

using enum Operation;

// How often each operation comes up in random bytes. An operation that is added takes entries of others, so that the
// others keep their bytes.
constexpr std::array<std::pair<Operation, int>, 33> weights{{
    {create_part, 8},
    {destroy_part, 1},
    {destroy_parts, 1},
    {place, 10},
    {set_velocity, 2},
    {place_all, 3},
    {set_motion, 2},
    {create_geometry, 5},
    {set_parameters, 3},
    {create_geometries, 6},
    {destroy_geometry, 2},
    {destroy_geometries, 1},
    {set_options, 6},
    {set_shape, 2},
    {set_samples, 1},
    {park, 5},
    {park_all, 2},
    {set_rule, 3},
    {clear_rules, 1},
    {set_sleep, 1},
    {set_filter, 1},
    {refilter, 1},
    {set_policy, 2},
    {set_focus, 2},
    {set_sleep, 2},
    {step, 11},
    {follow_islands, 1},
    {detect_all, 2},
    {detect_pairs, 4},
    {detect_region, 4},
    {refresh, 1},
    {mark_contacts, 2},
    {bad, 5},
}};

constexpr std::size_t weight_sum = [] {
  std::size_t sum = 0;
  for (const auto& [operation, weight] : weights) {
    sum += static_cast<std::size_t>(weight);
  }
  return sum;
}();

constexpr std::array<Operation, weight_sum> operations = [] {
  std::array<Operation, weight_sum> all{};
  std::size_t at = 0;
  for (const auto& [operation, weight] : weights) {
    for (int i = 0; i < weight; ++i) {
      all.at(at++) = operation;
    }
  }
  return all;
}();

constexpr std::array<std::string_view, 32> names{"create_part",
                                                 "destroy_part",
                                                 "destroy_parts",
                                                 "place",
                                                 "place_all",
                                                 "set_motion",
                                                 "create_geometry",
                                                 "create_geometries",
                                                 "destroy_geometry",
                                                 "destroy_geometries",
                                                 "set_options",
                                                 "set_shape",
                                                 "park",
                                                 "park_all",
                                                 "set_rule",
                                                 "clear_rules",
                                                 "set_sleep",
                                                 "set_filter",
                                                 "refilter",
                                                 "set_policy",
                                                 "set_focus",
                                                 "step",
                                                 "detect_all",
                                                 "detect_pairs",
                                                 "detect_region",
                                                 "refresh",
                                                 "mark_contacts",
                                                 "set_parameters",
                                                 "set_samples",
                                                 "set_velocity",
                                                 "follow_islands",
                                                 "bad"};

}  // namespace

std::uint64_t Random::bits() {
  state_ += 0x9e3779b97f4a7c15;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

Operation Call::operation() const { return operations.at(bytes[0] % weight_sum); }

int Call::number(std::size_t byte, int low, int high) const {
  return low + static_cast<int>(bytes.at(byte)) % (high - low + 1);
}

Sequence read_sequence(std::span<const std::uint8_t> bytes) {
  Sequence sequence;
  const auto record = [&](std::size_t index) {
    Call call;
    for (std::size_t i = 0; i < call_size && index * call_size + i < bytes.size(); ++i) {
      call.bytes.at(i) = bytes[index * call_size + i];
    }
    return call;
  };
  sequence.setup = record(0);
  const std::size_t records = (bytes.size() + call_size - 1) / call_size;
  for (std::size_t i = 1; i < std::min(records, most_calls + 1); ++i) {
    sequence.calls.push_back(record(i));
  }
  return sequence;
}

std::vector<std::uint8_t> bytes_of(const Sequence& sequence) {
  std::vector<std::uint8_t> bytes(sequence.setup.bytes.begin(), sequence.setup.bytes.end());
  for (const Call& call : sequence.calls) {
    bytes.insert(bytes.end(), call.bytes.begin(), call.bytes.end());
  }
  return bytes;
}

Sequence random_sequence(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<std::uint8_t> bytes((count + 1) * call_size);
  std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random.bits() & 0xff); });
  return read_sequence(bytes);
}

std::string_view name_of(Operation operation) { return names.at(static_cast<std::size_t>(operation)); }

}  // namespace universe_calls
