// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

import abut.capability;
import abut.core;

namespace {

using abut::Errc;
using abut::Fault;

constexpr double infinite = std::numeric_limits<double>::infinity();
const double not_a_number = std::fabs(std::numeric_limits<double>::quiet_NaN());

void expect_fault(const Fault& fault, Errc code, const char* message) {
  ASSERT_TRUE(fault.has_value()) << message;
  EXPECT_EQ(fault->code, code);
  EXPECT_EQ(fault->message, message);
}

TEST(Checks, FiniteNumbersWithinReachPass) {
  for (const double value : {0.0, -0.0, 1.0, -1e70, 1e70, std::numeric_limits<double>::denorm_min()}) {
    EXPECT_FALSE(abut::check_finite("x", value).has_value()) << value;
  }
  expect_fault(abut::check_finite("x", infinite), Errc::not_finite, "x is inf; it must be finite");
  expect_fault(abut::check_finite("x", -infinite), Errc::not_finite, "x is -inf; it must be finite");
  expect_fault(abut::check_finite("x", not_a_number), Errc::not_finite, "x is nan; it must be finite");
  expect_fault(abut::check_finite("x", 2e70), Errc::out_of_range, "x is 2e+70; it must be at most 1e70 in magnitude");
  expect_fault(abut::check_finite("x", -2e70), Errc::out_of_range, "x is -2e+70; it must be at most 1e70 in magnitude");
}

TEST(Checks, PositiveExcludesZero) {
  EXPECT_FALSE(abut::check_positive("r", 1e-300).has_value());
  expect_fault(abut::check_positive("r", 0), Errc::out_of_range, "r is 0; it must be positive");
  expect_fault(abut::check_positive("r", -3), Errc::out_of_range, "r is -3; it must be positive");
  expect_fault(abut::check_positive("r", not_a_number), Errc::not_finite, "r is nan; it must be finite");
}

TEST(Checks, NotNegativeIncludesZero) {
  EXPECT_FALSE(abut::check_not_negative("h", 0).has_value());
  EXPECT_FALSE(abut::check_not_negative("h", 2).has_value());
  expect_fault(abut::check_not_negative("h", -0.25), Errc::out_of_range, "h is -0.25; it must be zero or positive");
  expect_fault(abut::check_not_negative("h", infinite), Errc::not_finite, "h is inf; it must be finite");
}

TEST(Checks, ArraysNameTheirFirstBadElement) {
  EXPECT_FALSE(abut::check_all_finite("xyz", std::vector<double>{}).has_value());
  EXPECT_FALSE(abut::check_all_finite("xyz", std::vector{1.0, -1e70, 0.0}).has_value());
  expect_fault(abut::check_all_finite("xyz", std::vector{1.0, not_a_number, infinite}), Errc::not_finite,
               "xyz[1] is nan; it must be finite");
  expect_fault(abut::check_all_finite("xyz", std::vector{1.0, 2.0, 1e80}), Errc::out_of_range,
               "xyz[2] is 1e+80; it must be at most 1e70 in magnitude");
}

TEST(Checks, CountsMustMatch) {
  EXPECT_FALSE(abut::check_count("n", 3, 3).has_value());
  expect_fault(abut::check_count("n", 2, 3), Errc::invalid_argument, "n is 2; it must be 3 for this kind");
  EXPECT_FALSE(abut::check_no_buffers({}, {}).has_value());
  const std::vector<double> reals{1};
  const std::vector<std::uint32_t> indices{1, 2};
  expect_fault(abut::check_no_buffers(reals, {}), Errc::invalid_argument,
               "real_count is 1; it must be 0 for this kind");
  expect_fault(abut::check_no_buffers({}, indices), Errc::invalid_argument,
               "index_count is 2; it must be 0 for this kind");
}

}  // namespace
