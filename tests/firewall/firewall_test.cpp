// SPDX-License-Identifier: Apache-2.0
// What becomes of exceptions at the border of the C interface.
#include <gtest/gtest.h>

#include "guard.hpp"

import abut.core;

using namespace abut::capi;

namespace {

abut_status break_an_invariant() {
  ABUT_CHECK(1 + 1 == 3);
  return ABUT_OK;
}

TEST(Guard, PassesStatusAndMessage) {
  EXPECT_EQ(guard([]() -> abut_status {
              set_message("an empty one");
              return ABUT_EMPTY;
            }),
            ABUT_EMPTY);
  EXPECT_STREQ(abut_last_error_message(), "an empty one");
}

TEST(Guard, AnswersOutOfMemory) {
  EXPECT_EQ(guard([]() -> abut_status { throw std::bad_alloc(); }), ABUT_OUT_OF_MEMORY);
  EXPECT_STRNE(abut_last_error_message(), "");
  EXPECT_EQ(guard([]() -> abut_status { throw std::length_error("vector"); }), ABUT_OUT_OF_MEMORY);
}

TEST(Guard, AnswersInternalForAnythingElse) {
  EXPECT_EQ(guard(break_an_invariant), ABUT_INTERNAL);
  EXPECT_NE(std::string(abut_last_error_message()).find("1 + 1 == 3"), std::string::npos) << abut_last_error_message();
  EXPECT_EQ(guard([]() -> abut_status { throw 5; }), ABUT_INTERNAL);
  EXPECT_EQ(guard([]() -> abut_status { throw std::runtime_error("foreign"); }), ABUT_INTERNAL);
}

TEST(Guard, PoisonsAfterADefect) {
  std::atomic<bool> poisoned{false};
  bool ran = false;
  const auto harmless = [&]() -> abut_status {
    ran = true;
    return ABUT_OK;
  };
  EXPECT_EQ(guard(poisoned, harmless), ABUT_OK);
  EXPECT_TRUE(ran);
  EXPECT_EQ(guard(poisoned, break_an_invariant), ABUT_INTERNAL);
  ran = false;
  EXPECT_EQ(guard(poisoned, harmless), ABUT_INTERNAL);
  EXPECT_FALSE(ran);
  EXPECT_STRNE(abut_last_error_message(), "");
}

TEST(Guard, DoesNotPoisonForLackOfMemory) {
  std::atomic<bool> poisoned{false};
  EXPECT_EQ(guard(poisoned, []() -> abut_status { throw std::bad_alloc(); }), ABUT_OUT_OF_MEMORY);
  EXPECT_EQ(guard(poisoned, []() -> abut_status { return ABUT_OK; }), ABUT_OK);
}

TEST(Message, IsCutAtAWholeCharacter) {
  // Two bytes each, so that the last byte that fits would be half of one.
  std::string text;
  while (text.size() < 400) {
    text += "\xc3\xa9";
  }
  set_message(text);
  const std::string kept = abut_last_error_message();
  EXPECT_EQ(kept.size(), 254U);
  EXPECT_EQ(kept, text.substr(0, 254));
}

TEST(Message, MayBeSetFromItself) {
  set_message("the first message");
  EXPECT_EQ(abut_set_last_error(ABUT_NOT_FINITE, abut_last_error_message()), ABUT_NOT_FINITE);
  EXPECT_STREQ(abut_last_error_message(), "the first message");
}

}  // namespace
