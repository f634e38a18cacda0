// SPDX-License-Identifier: Apache-2.0
// Version, names and messages under bad input.
#include <thread>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(StatusName, NamesEveryStatusAndNothingElse) {
  constexpr std::array<std::string_view, 18> names{"ABUT_OK",
                                                   "ABUT_INVALID_ARGUMENT",
                                                   "ABUT_NULL_ARGUMENT",
                                                   "ABUT_NOT_FINITE",
                                                   "ABUT_OUT_OF_RANGE",
                                                   "ABUT_ZERO_VECTOR",
                                                   "ABUT_NOT_UNIT",
                                                   "ABUT_INDEX_OUT_OF_RANGE",
                                                   "ABUT_SIZE_OVERFLOW",
                                                   "ABUT_EMPTY",
                                                   "ABUT_STALE_ID",
                                                   "ABUT_WRONG_STRUCT_SIZE",
                                                   "ABUT_UNKNOWN_VALUE",
                                                   "ABUT_UNSUPPORTED",
                                                   "ABUT_NOT_CONVERGED",
                                                   "ABUT_OUT_OF_MEMORY",
                                                   "ABUT_INTERNAL",
                                                   "ABUT_BUSY"};
  for (std::size_t status = 0; status < names.size(); ++status) {
    EXPECT_EQ(abut_status_name(static_cast<abut_status>(status)), names.at(status));
  }
  for (const abut_status none :
       {-1, 18, 1000, std::numeric_limits<abut_status>::min(), std::numeric_limits<abut_status>::max()}) {
    EXPECT_STREQ(abut_status_name(none), "unknown") << none;
  }
}

TEST(LastErrorMessage, StaysUntilTheNextFailure) {
  abut_shape* shape = nullptr;
  ASSERT_NE(abut_sphere_create(-1.0, &shape), ABUT_OK);
  const std::string first = abut_last_error_message();
  EXPECT_NE(first, "");
  EXPECT_EQ(abut_last_error_message(), first) << "asking does not clear it";
  const Shape ball = make_sphere(1.0);
  EXPECT_EQ(abut_last_error_message(), first) << "nor does a success";
  ASSERT_NE(abut_sphere_create(-2.0, &shape), ABUT_OK);
  EXPECT_NE(abut_last_error_message(), first);
}

TEST(LastErrorMessage, IsOfItsThread) {
  abut_shape* shape = nullptr;
  ASSERT_NE(abut_sphere_create(-1.0, &shape), ABUT_OK);
  std::string elsewhere = "not asked";
  std::thread([&] { elsewhere = abut_last_error_message(); }).join();
  EXPECT_EQ(elsewhere, "");
  EXPECT_STRNE(abut_last_error_message(), "");
}

TEST(SetLastError, SetsTheMessageAndAnswersTheStatus) {
  EXPECT_TRUE(refused(abut_set_last_error(ABUT_UNSUPPORTED, "no such ray"), ABUT_UNSUPPORTED, {"no such ray"}));
  EXPECT_EQ(abut_set_last_error(ABUT_EMPTY, nullptr), abut_status{ABUT_EMPTY});
  EXPECT_STREQ(abut_last_error_message(), "");
}

TEST(SetLastError, CutsLongMessages) {
  const std::string endless(100000, 'x');
  EXPECT_EQ(abut_set_last_error(ABUT_EMPTY, endless.c_str()), abut_status{ABUT_EMPTY});
  const std::string message = abut_last_error_message();
  EXPECT_GE(message.size(), 64U);
  EXPECT_LT(message.size(), endless.size());
  EXPECT_EQ(message, endless.substr(0, message.size()));
}

TEST(VersionString, IsThatOfTheHeader) {
  const std::string expected = std::to_string(ABUT_VERSION_MAJOR) + "." + std::to_string(ABUT_VERSION_MINOR) + "." +
                               std::to_string(ABUT_VERSION_PATCH);
  EXPECT_EQ(abut_version_string(), expected);
}

TEST(CheckVersion, AcceptsTheHeader) {
  EXPECT_TRUE(succeeded(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR)));
}

TEST(CheckVersion, RefusesOtherVersions) {
  EXPECT_TRUE(refused(abut_check_version(ABUT_VERSION_MAJOR + 1, 0), ABUT_UNSUPPORTED, {"1"}));
  EXPECT_TRUE(refused(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR + 7), ABUT_UNSUPPORTED,
                      {std::to_string(ABUT_VERSION_MINOR + 7)}));
  EXPECT_TRUE(refused(abut_check_version(0xFFFFFFFFU, 0xFFFFFFFFU), ABUT_UNSUPPORTED, {"4294967295"}));
}

TEST(CheckVersion, RefusesEarlierMinorsBeforeTheFirstMajor) {
  static_assert(ABUT_VERSION_MAJOR == 0);
  EXPECT_TRUE(refused(abut_check_version(0, ABUT_VERSION_MINOR - 1), ABUT_UNSUPPORTED,
                      {"0." + std::to_string(ABUT_VERSION_MINOR - 1), abut_version_string()}));
}

TEST(HasFeature, DeniesNullAndUnknownNames) {
  EXPECT_EQ(abut_has_feature(nullptr), 0U);
  EXPECT_EQ(abut_has_feature(""), 0U);
  EXPECT_EQ(abut_has_feature("teleport"), 0U);
  EXPECT_EQ(abut_has_feature("hul"), 0U);
}

}  // namespace
