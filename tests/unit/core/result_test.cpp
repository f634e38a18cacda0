// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

import abut.core;

namespace {

using abut::Bug;
using abut::Errc;
using abut::Error;
using abut::Result;

Result<int> half_of(int number) {
  if (number % 2 != 0) {
    return Error{Errc::invalid_argument, "odd"};
  }
  return number / 2;
}

TEST(Result, HoldsAValue) {
  Result<int> result = 4;
  EXPECT_TRUE(result.has_value());
  EXPECT_TRUE(static_cast<bool>(result));
  EXPECT_EQ(result.value(), 4);
  result.value() = 5;
  EXPECT_EQ(std::as_const(result).value(), 5);
}

TEST(Result, HoldsAnError) {
  const Result<int> result = Error{Errc::empty, "nothing there"};
  EXPECT_FALSE(result.has_value());
  EXPECT_FALSE(static_cast<bool>(result));
  EXPECT_EQ(result.error().code, Errc::empty);
  EXPECT_EQ(result.error().message, "nothing there");
}

// What is not there is a bug of the caller, never a read of something else.
TEST(Result, WrongSideIsABug) {
  Result<int> good = 1;
  Result<int> bad = Error{Errc::empty, ""};
  EXPECT_THROW(static_cast<void>(good.error()), Bug);
  EXPECT_THROW(static_cast<void>(std::move(good).error()), Bug);
  EXPECT_THROW(static_cast<void>(bad.value()), Bug);
  EXPECT_THROW(static_cast<void>(std::as_const(bad).value()), Bug);
  EXPECT_THROW(static_cast<void>(std::move(bad).value()), Bug);
}

TEST(Result, BugSaysWhere) {
  const Result<int> bad = Error{Errc::empty, ""};
  try {
    static_cast<void>(bad.value());
    FAIL() << "no bug was reported";
  } catch (const Bug& bug) {
    EXPECT_NE(std::string(bug.what()).find("result.cppm"), std::string::npos) << bug.what();
    EXPECT_NE(std::string(bug.what()).find("has_value()"), std::string::npos) << bug.what();
  }
}

TEST(Result, MovesOutWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(9);
  const std::unique_ptr<int> owned = std::move(result).value();
  EXPECT_EQ(*owned, 9);
}

TEST(Result, AndThenGoesOnWithValues) {
  EXPECT_EQ(half_of(12).and_then(half_of).value(), 3);
  EXPECT_EQ(half_of(6).and_then(half_of).error().message, "odd");
}

TEST(Result, AndThenSkipsAfterAnError) {
  bool called = false;
  const Result<int> result = half_of(5).and_then([&](int number) -> Result<int> {
    called = true;
    return number;
  });
  EXPECT_FALSE(called);
  EXPECT_EQ(result.error().code, Errc::invalid_argument);
}

TEST(Result, TransformChangesValuesAndKeepsErrors) {
  const auto word_of = [](int number) { return std::string(static_cast<std::size_t>(number), 'x'); };
  EXPECT_EQ(half_of(6).transform(word_of).value(), "xxx");
  EXPECT_EQ(half_of(7).transform(word_of).error().message, "odd");
}

TEST(ResultOfNothing, SucceedsByDefault) {
  const Result<void> result;
  EXPECT_TRUE(result.has_value());
  EXPECT_TRUE(static_cast<bool>(result));
  EXPECT_THROW(static_cast<void>(result.error()), Bug);
}

TEST(ResultOfNothing, HoldsAnError) {
  Result<void> result = Error{Errc::stale_id, "gone"};
  EXPECT_FALSE(result.has_value());
  EXPECT_EQ(result.error().message, "gone");
  const Error moved = std::move(result).error();
  EXPECT_EQ(moved.code, Errc::stale_id);
}

}  // namespace
