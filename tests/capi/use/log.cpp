// SPDX-License-Identifier: Apache-2.0
// What the log of the host hears.
#include "support.hpp"

namespace {

using namespace abut_test;

struct Heard {
  std::vector<std::pair<abut_log_level, std::string>> all;
};

void hear(void* context, abut_log_level level, const char* message) {
  static_cast<Heard*>(context)->all.emplace_back(level, message);
}

// Takes the log away again, which is that of the process.
class Log : public testing::Test {
 protected:
  void TearDown() override { require(abut_set_log(nullptr, nullptr, ABUT_LOG_NONE)); }
  void listen(abut_log_level most) { require(abut_set_log(hear, &heard, most)); }

  Heard heard;
};

TEST(SetLog, RefusesLevelsThatDoNotExist) {
  for (const abut_log_level level : {3U, 77U, 0xFFFFFFFFU}) {
    EXPECT_TRUE(refused(abut_set_log(hear, nullptr, level), ABUT_UNKNOWN_VALUE, {"most", std::to_string(level)}));
  }
}

TEST(SetLog, NullHearsNothing) {
  EXPECT_TRUE(succeeded(abut_set_log(nullptr, nullptr, ABUT_LOG_WARNING)));
  abut_shape* shape = nullptr;
  EXPECT_TRUE(refused(abut_sphere_create(-1, &shape), ABUT_OUT_OF_RANGE, {"radius"}));
}

TEST_F(Log, HearsWhatWasRefusedWithItsSentence) {
  listen(ABUT_LOG_WARNING);
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_sphere_create(-1, &shape), abut_status{ABUT_OUT_OF_RANGE});
  ASSERT_EQ(heard.all.size(), 1U);
  EXPECT_EQ(heard.all[0].first, abut_log_level{ABUT_LOG_WARNING});
  EXPECT_EQ(heard.all[0].second, abut_last_error_message());
  ASSERT_EQ(abut_sphere_create(1, &shape), abut_status{ABUT_OK});
  abut_shape_release(shape);
  EXPECT_EQ(heard.all.size(), 1U);
}

TEST_F(Log, HearsUpToItsLevel) {
  listen(ABUT_LOG_ERROR);
  EXPECT_EQ(abut_set_last_error(ABUT_STALE_ID, "an id"), abut_status{ABUT_STALE_ID});
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(abut_set_last_error(ABUT_OUT_OF_MEMORY, "no memory"), abut_status{ABUT_OUT_OF_MEMORY});
  ASSERT_EQ(heard.all.size(), 1U);
  EXPECT_EQ(heard.all[0].first, abut_log_level{ABUT_LOG_ERROR});
  listen(ABUT_LOG_NONE);
  EXPECT_EQ(abut_set_last_error(ABUT_INTERNAL, "a defect"), abut_status{ABUT_INTERNAL});
  EXPECT_EQ(heard.all.size(), 1U);
}

void fail_again(void* context, abut_log_level, const char*) {
  ++*static_cast<int*>(context);
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_capsule_create(-5, 1, &shape), abut_status{ABUT_OUT_OF_RANGE});
}

TEST_F(Log, MayFailItselfAndTheMessageStays) {
  int count = 0;
  require(abut_set_log(fail_again, &count, ABUT_LOG_WARNING));
  abut_shape* shape = nullptr;
  EXPECT_TRUE(refused(abut_sphere_create(-1.5, &shape), ABUT_OUT_OF_RANGE, {"-1.5"}));
  EXPECT_EQ(count, 1);
}

TEST_F(Log, HearsOnceWhatIsOddAboutAScene) {
  Universe universe;
  const Shape ball = make_sphere(1);
  for (int i = 0; i < 2; ++i) universe.add(ball, identity, ABUT_MOTION_STATIC);
  universe.step();
  listen(ABUT_LOG_WARNING);
  universe.step();
  universe.step();
  ASSERT_EQ(heard.all.size(), 1U);
  EXPECT_NE(heard.all[0].second.find("no part is dynamic"), std::string::npos);
}

}  // namespace
