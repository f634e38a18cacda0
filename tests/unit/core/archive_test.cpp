// SPDX-License-Identifier: Apache-2.0
// Values as bytes and back.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

import abut.core;
import abut.core.archive;

namespace {

using namespace abut;

enum class Colour : std::uint16_t { red = 7, green = 0x1234 };

struct Inner {
  double real;
  std::array<float, 2> pair;

  friend bool operator==(const Inner&, const Inner&) = default;
};
struct Outer {
  Colour colour;
  bool is_set;
  Inner inner;
  std::vector<std::uint8_t> list;
  std::optional<std::int32_t> perhaps;

  friend bool operator==(const Outer&, const Outer&) = default;
};

std::vector<std::uint8_t> written(const auto&... values) {
  ByteWriter out;
  out(values...);
  return {out.bytes().begin(), out.bytes().end()};
}

TEST(Archive, BeginsWithTheLowestByte) {
  EXPECT_EQ(written(std::uint32_t{0x01020304}), (std::vector<std::uint8_t>{4, 3, 2, 1}));
  EXPECT_EQ(written(Colour::green, true), (std::vector<std::uint8_t>{0x34, 0x12, 1}));
  EXPECT_EQ(written(1.0), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0xf0, 0x3f}));
}

TEST(Archive, ReadsWhatWasWritten) {
  const Outer given{Colour::green, true, {-0.1, {1.5F, -2}}, {1, 2, 3}, -7};
  const std::map<std::uint32_t, double> rows{{3, 0.5}, {9, std::numeric_limits<double>::infinity()}};
  const std::vector<std::uint8_t> bytes = written(given, rows);
  ByteReader in(bytes);
  Outer found{};
  std::map<std::uint32_t, double> found_rows;
  in(found, found_rows);
  EXPECT_FALSE(in.has_failed());
  EXPECT_TRUE(in.is_at_end());
  EXPECT_EQ(found, given);
  EXPECT_EQ(found_rows, rows);
}

TEST(Archive, EveryEndTooEarlyIsAFault) {
  const std::vector<std::uint8_t> bytes = written(Outer{Colour::red, false, {1, {2, 3}}, {4, 5}, 6});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ByteReader in(std::span(bytes).first(size));
    Outer found{};
    in(found);
    EXPECT_TRUE(in.has_failed()) << size;
  }
}

TEST(Archive, AListLongerThanTheBytesAsksForNoMemory) {
  const std::vector<std::uint8_t> bytes = written(std::numeric_limits<std::uint64_t>::max(), 1.0);
  ByteReader in(bytes);
  std::vector<double> found;
  in(found);
  ASSERT_TRUE(in.has_failed());
  EXPECT_NE(in.fault()->message.find("longer than the bytes"), std::string_view::npos);
  EXPECT_EQ(found.capacity(), 0U);
}

TEST(Archive, RefusesWhatIsNeitherYesNorNoAndRowsThatAreThereTwice) {
  bool is_set = false;
  ByteReader of_flag(written(std::uint8_t{2}));
  of_flag(is_set);
  EXPECT_TRUE(of_flag.has_failed());
  std::map<std::uint8_t, std::uint8_t> rows;
  ByteReader of_rows(written(std::uint64_t{2}, std::uint8_t{1}, std::uint8_t{5}, std::uint8_t{1}, std::uint8_t{6}));
  of_rows(rows);
  EXPECT_TRUE(of_rows.has_failed());
}

// The check value of the catalogue of CRC algorithms.
TEST(Archive, TheChecksumIsCastagnolis) {
  constexpr std::array<std::uint8_t, 9> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(checksum_of(digits), 0xe3069283U);
  EXPECT_EQ(checksum_of({}), 0U);
}

}  // namespace
