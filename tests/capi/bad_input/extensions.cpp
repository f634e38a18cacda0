// SPDX-License-Identifier: Apache-2.0
// Names of extension libraries that are none.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::size_t longest = 63;

using Call = abut_status (*)(const abut_universe*, const char*);

void expect_names_checked(Call call) {
  const Scene scene;
  EXPECT_TRUE(refused(call(nullptr, "picking"), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(call(scene.universe, nullptr), ABUT_NULL_ARGUMENT, {"name", "null"}));
  for (const std::string& bad :
       {std::string(), std::string("a b"), std::string("a\"b"), std::string("a\nb"), std::string("\xc3\xa4")}) {
    EXPECT_TRUE(
        refused(call(scene.universe, bad.c_str()), ABUT_INVALID_ARGUMENT, {"name", std::to_string(bad.size())}));
  }
  const std::string too_long(longest + 1, 'a');
  EXPECT_TRUE(refused(call(scene.universe, too_long.c_str()), ABUT_INVALID_ARGUMENT, {"name", "64"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseAttach, RefusesNullAndNamesThatAreNone) {
  expect_names_checked(abut_universe_attach);
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_universe_attach(scene.universe, std::string(longest, 'a').c_str())));
}

TEST(UniverseDetach, RefusesNullAndNamesThatAreNone) { expect_names_checked(abut_universe_detach); }

TEST(UniverseDetach, RefusesNamesThatAreNotAttached) {
  const Scene scene;
  require(abut_universe_attach(scene.universe, "picking"));
  EXPECT_TRUE(refused(abut_universe_detach(scene.universe, "pick"), ABUT_UNKNOWN_VALUE, {"name", "pick"}));
  require(abut_universe_detach(scene.universe, "picking"));
  EXPECT_TRUE(refused(abut_universe_detach(scene.universe, "picking"), ABUT_UNKNOWN_VALUE, {"name", "picking"}));
}

}  // namespace
