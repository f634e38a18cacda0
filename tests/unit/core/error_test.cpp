// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

import abut.core;

namespace {

using abut::Errc;
using abut::Error;
using abut::error_about;
using abut::to_text;

TEST(ErrorText, NamesArgumentValueAndExpectation) {
  const Error error = error_about(Errc::out_of_range, "radius", -1.0, "positive");
  EXPECT_EQ(error.code, Errc::out_of_range);
  EXPECT_EQ(error.message, "radius is -1; it must be positive");
}

TEST(ErrorText, TakesCountsToo) {
  const Error error =
      error_about(Errc::invalid_argument, "real_count", std::uint64_t{18446744073709551615u}, "a multiple of 3");
  EXPECT_EQ(error.message, "real_count is 18446744073709551615; it must be a multiple of 3");
}

TEST(ErrorText, ShortNumbersStayShort) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(2.0), "2");
  EXPECT_EQ(to_text(-0.5), "-0.5");
  EXPECT_EQ(to_text(1e70), "1e+70");
}

TEST(ErrorText, SpellsWhatIsNoNumber) {
  EXPECT_EQ(to_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(to_text(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(to_text(std::fabs(std::numeric_limits<double>::quiet_NaN())), "nan");
}

TEST(ErrorText, ExtremeNumbersFit) {
  for (const double value : {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest(),
                             -std::numeric_limits<double>::denorm_min(), -2.2250738585072014e-308}) {
    const std::string text = to_text(value);
    EXPECT_LE(text.size(), 24u);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
  }
}

TEST(ErrorText, ReadsBackAsTheSameNumber) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 2000; ++i) {
    const double mantissa = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
    const double value = std::ldexp(mantissa, static_cast<int>(random() % 600) - 300);
    const std::string text = to_text(value);
    EXPECT_LE(text.size(), 24u);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
  }
}

// The numbers are part of the C interface and never change.
TEST(ErrorCode, NumbersAreThoseOfTheInterface) {
  EXPECT_EQ(static_cast<std::int32_t>(Errc::invalid_argument), 1);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::not_finite), 3);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::out_of_range), 4);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::zero_vector), 5);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::index_out_of_range), 7);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::empty), 9);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::unknown_value), 12);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::internal), 16);
  EXPECT_EQ(static_cast<std::int32_t>(Errc::busy), 17);
}

}  // namespace
