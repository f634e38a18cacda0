// SPDX-License-Identifier: Apache-2.0
// Policies under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<std::uint32_t, 3> unknown_tags{64, 77, 0xFFFFFFFF};

TEST(PolicyInit, IgnoresNull) { abut_policy_init(nullptr, 0); }

TEST(PolicyInit, FillsInTheDefaults) {
  Out<abut_policy> policy;
  abut_policy_init(policy.address(), sizeof(abut_policy));
  EXPECT_EQ(policy.value().struct_size, sizeof(abut_policy));
  EXPECT_EQ(policy.value().algorithm, abut_algorithm{ABUT_ALGORITHM_AUTO});
  EXPECT_EQ(policy.value().detail, abut_detail{ABUT_DETAIL_MANIFOLD});
  EXPECT_EQ(policy.value().period, 1U);
  EXPECT_EQ(policy.value().tolerance, -1.0);
  EXPECT_EQ(policy.value().error_bound, 0.0);
  EXPECT_EQ(policy.value().method, abut_closest_method{ABUT_CLOSEST_FEATURES});
  EXPECT_EQ(policy.value().kinds, 0U);
  EXPECT_EQ(policy.value().flags, 0U);
  EXPECT_EQ(policy.value().reserved, 0U);
  EXPECT_EQ(policy.value().contact_distance, 0.0);
  EXPECT_EQ(policy.value().rest_distance, 0.0);
  EXPECT_EQ(policy.value().cone_angle, 0.0);
  EXPECT_EQ(policy.value().cone_factor, 0.5);
}

TEST(PolicySet, RefusesTagsThatAreNone) {
  const Scene scene;
  abut_policy policy = default_policy();
  policy.period = 5;
  for (const std::uint32_t tag : unknown_tags) {
    EXPECT_TRUE(
        refused(abut_policy_set(scene.universe, tag, 1, &policy), ABUT_OUT_OF_RANGE, {"tag_a", std::to_string(tag)}));
    EXPECT_TRUE(
        refused(abut_policy_set(scene.universe, 0, tag, &policy), ABUT_OUT_OF_RANGE, {"tag_b", std::to_string(tag)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PolicySet, RefusesUnknownValues) {
  const Scene scene;
  for (const std::uint32_t value : {6U, 77U, 0xFFFFFFFFU}) {
    abut_policy policy = default_policy();
    policy.algorithm = value;
    EXPECT_TRUE(refused(abut_policy_set(scene.universe, 0, 1, &policy), ABUT_UNKNOWN_VALUE,
                        {"algorithm", std::to_string(value)}));
    policy = default_policy();
    policy.detail = value;
    EXPECT_TRUE(
        refused(abut_policy_set(scene.universe, 0, 1, &policy), ABUT_UNKNOWN_VALUE, {"detail", std::to_string(value)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PolicySet, RefusesElementsWithoutAMargin) {
  const Scene scene;
  abut_policy policy = default_policy();
  policy.detail = ABUT_DETAIL_ELEMENTS;
  EXPECT_TRUE(refused(abut_policy_set(scene.universe, 0, 1, &policy), ABUT_UNSUPPORTED,
                      {"policy.detail", "4", "ABUT_TOLERANCE_MARGIN"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PolicySet, RefusesKindsThatAreNone) {
  const Scene scene;
  abut_policy policy = default_policy();
  policy.kinds = 16;
  EXPECT_TRUE(refused(abut_policy_set(scene.universe, 0, 1, &policy), ABUT_UNKNOWN_VALUE, {"policy.kinds", "16"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PolicySet, RefusesAPeriodOfZero) {
  const Scene scene;
  abut_policy policy = default_policy();
  policy.period = 0;
  EXPECT_TRUE(refused(abut_policy_set(scene.universe, 0, 1, &policy), ABUT_OUT_OF_RANGE, {"period", "0", "1"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PolicyGet, RefusesTagsThatAreNone) {
  const Scene scene;
  Out<abut_policy> out(default_policy());
  for (const std::uint32_t tag : unknown_tags) {
    EXPECT_TRUE(refused(abut_policy_get(scene.universe, tag, 1, out.address()), ABUT_OUT_OF_RANGE,
                        {"tag_a", std::to_string(tag)}));
    EXPECT_TRUE(refused(abut_policy_get(scene.universe, 0, tag, out.address()), ABUT_OUT_OF_RANGE,
                        {"tag_b", std::to_string(tag)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(PolicyGet, AcceptsLaterStructWithZeroTail) {
  const Scene scene;
  Grown<abut_policy> later{default_policy(), {}};
  later.known.struct_size = sizeof(later);
  later.known.period = 9;
  EXPECT_TRUE(succeeded(abut_policy_get(scene.universe, 0, 1, &later.known)));
  EXPECT_EQ(later.known.struct_size, sizeof(later));
  EXPECT_EQ(later.known.period, 1U);
}

}  // namespace
