// SPDX-License-Identifier: Apache-2.0
#include "load.hpp"

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <memory>

namespace load_fuzzing {
namespace {

constexpr std::size_t head_size = 24;

struct Destroy {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
};
using Universe = std::unique_ptr<abut_universe, Destroy>;

// CRC-32C bit by bit, apart from the library.
std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = ~std::uint32_t{0};
  for (const std::uint8_t byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) {
      sum = (sum & 1U) != 0 ? sum >> 1 ^ 0x82f63b78U : sum >> 1;
    }
  }
  return ~sum;
}

void append(std::vector<std::uint8_t>& bytes, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
  }
}

abut_status load(std::span<const std::uint8_t> bytes, Universe& out) {
  abut_universe* made = nullptr;
  const abut_status status = abut_universe_load(bytes.data(), bytes.size(), &made);
  out.reset(made);
  return status;
}

abut_status save(const abut_universe* universe, std::vector<std::uint8_t>& out) {
  std::size_t size = 0;
  const abut_status status = abut_universe_save(universe, nullptr, 0, &size);
  out.resize(size);
  return status != ABUT_OK ? status : abut_universe_save(universe, out.data(), out.size(), &size);
}

// Calls that look at all of a universe. Each may refuse, none may find a defect.
bool survives_use(abut_universe* universe) {
  const abut_ray ray{{0.1, 0.2, 50}, {0, 0, -1}, 100};
  std::array<abut_query_hit, 4> hits{};
  std::size_t count = 0;
  const abut_vec3 centre{0, 0, 0};
  std::array<abut_finding, 4> findings{};
  std::array<abut_geometry_id, 4> geometries{};
  const std::array statuses{
      abut_universe_cast_ray(universe, &ray, nullptr, ABUT_HIT_ALL, hits.data(), hits.size(), &count),
      abut_universe_at_point(universe, &centre, nullptr, geometries.data(), geometries.size(), &count),
      abut_universe_validate(universe, findings.data(), findings.size(), &count),
      abut_universe_explain(universe, nullptr, 0, &count),
      abut_universe_step(universe, 0.01),
      abut_universe_detect_all(universe),
      abut_universe_step(universe, 0.01)};
  return std::ranges::find(statuses, abut_status{ABUT_INTERNAL}) == statuses.end();
}

}  // namespace

std::vector<std::uint8_t> with_head(std::span<const std::uint8_t> body) {
  std::vector<std::uint8_t> bytes;
  constexpr std::uint64_t mark = 0x696e752d74756261;
  constexpr std::uint32_t version = 6;
  append(bytes, mark, 8);
  append(bytes, version, 4);
  append(bytes, checksum_of(body), 4);
  append(bytes, body.size(), 8);
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

std::vector<std::uint8_t> without_head(std::span<const std::uint8_t> bytes) {
  return {bytes.begin() + head_size, bytes.end()};
}

bool is_loaded(std::span<const std::uint8_t> body) {
  Universe universe;
  return load(with_head(body), universe) == ABUT_OK;
}

std::string finding_of(std::span<const std::uint8_t> body) {
  Universe universe;
  const abut_status status = load(with_head(body), universe);
  if (status != ABUT_OK) {
    const bool is_told = status != ABUT_INTERNAL && !std::string(abut_last_error_message()).empty();
    return is_told
               ? ""
               : std::string("bytes are refused with ") + abut_status_name(status) + ": " + abut_last_error_message();
  }
  // What was read is written as it was read.
  std::vector<std::uint8_t> once, twice;
  Universe again;
  if (save(universe.get(), once) != ABUT_OK || load(once, again) != ABUT_OK || save(again.get(), twice) != ABUT_OK) {
    return std::string("what was loaded cannot be saved and loaded: ") + abut_last_error_message();
  }
  if (once != twice) {
    return "what was loaded and saved is loaded and saved otherwise";
  }
  return survives_use(universe.get()) ? "" : std::string("a call finds a defect: ") + abut_last_error_message();
}

}  // namespace load_fuzzing
