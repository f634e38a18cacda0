// SPDX-License-Identifier: Apache-2.0
module;
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
module abut.fuzz;

namespace abut::fuzz {
namespace {

// The array and the place in it of a number of the layout.
template <class R>
auto& number_in(R& record, std::size_t index) {
  if (index < 8) {
    return record.a[index];
  }
  if (index < 16) {
    return record.b[index - 8];
  }
  if (index < 20) {
    return record.rotation[index - 16];
  }
  return index < 23 ? record.position[index - 20] : record.extra[index - 23];
}

}  // namespace

Real number_at(const Record& record, std::size_t index) { return number_in(record, index); }
void set_number(Record& record, std::size_t index, Real value) { number_in(record, index) = value; }

Record read_record(std::span<const std::uint8_t> bytes) {
  const auto byte = [&](std::size_t index) { return index < bytes.size() ? bytes[index] : std::uint8_t{0}; };
  Record record{.version = byte(0), .flags = byte(1)};
  for (std::size_t i = 0; i < number_count; ++i) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      bits |= std::uint64_t{byte(2 + 8 * i + k)} << (8 * k);
    }
    set_number(record, i, std::bit_cast<Real>(bits));
  }
  return record;
}

std::array<std::uint8_t, record_size> bytes_of(const Record& record) {
  std::array<std::uint8_t, record_size> bytes{record.version, record.flags};
  for (std::size_t i = 0; i < number_count; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(number_at(record, i));
    for (std::size_t k = 0; k < 8; ++k) {
      bytes[2 + 8 * i + k] = static_cast<std::uint8_t>((bits >> (8 * k)) & 0xff);
    }
  }
  return bytes;
}

Record random_record(std::uint64_t seed) {
  Random random(seed);
  Record record{.flags = static_cast<std::uint8_t>(random.bits() & 0xff)};
  // Mostly sizes and offsets near one, at times some orders of magnitude apart.
  const Real spread = random.below(4) == 0 ? 6 : 1;
  for (std::size_t i = 0; i < number_count; ++i) {
    const bool is_rotation = i >= 16 && i < 20;
    const Real magnitude = is_rotation ? 1 : std::exp2(random.between(-spread, spread));
    set_number(record, i, magnitude * random.between(-1, 1));
  }
  if (random.below(2) == 0) {
    record.extra = {};
  }
  return record;
}

}  // namespace abut::fuzz
