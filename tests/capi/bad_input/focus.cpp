// SPDX-License-Identifier: Apache-2.0
// The focus under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// With a focus that has made its geometry near: whatever is refused leaves that as it is.
struct FocusedScene : Scene {
  FocusedScene() {
    abut_focus focus = default_focus();
    focus.near_tag = 7;
    focus.far_tag = 0;
    focus.near_distance = focus.far_distance = 0.2;
    EXPECT_TRUE(succeeded(abut_universe_set_focus(universe, &focus, &centre, 1)));
    universe.step();
    EXPECT_EQ(universe.describe(geometry).tag, 7U);
    before = snapshot(universe);
  }
  bool keeps_its_focus() {
    if (snapshot(universe) != before) return false;
    universe.move(part, at(-5, 0, 0));
    universe.step();
    const bool is_far = universe.describe(geometry).tag == 0;
    universe.move(part, at(0, 0, 0));
    universe.step();
    before = snapshot(universe);
    return is_far && universe.describe(geometry).tag == 7;
  }

  abut_vec3 centre{-1.1, 0, 0};
  std::vector<unsigned char> before;
};

TEST(FocusInit, IgnoresNull) { abut_focus_init(nullptr, 0); }

TEST(FocusInit, FillsInTheDefaults) {
  Out<abut_focus> focus;
  abut_focus_init(focus.address(), sizeof(abut_focus));
  EXPECT_EQ(focus.value().struct_size, sizeof(abut_focus));
  EXPECT_EQ(focus.value().near_tag, 0U);
  EXPECT_EQ(focus.value().far_tag, 1U);
  EXPECT_EQ(focus.value().reserved, 0U);
  EXPECT_EQ(focus.value().near_distance, 0.0);
  EXPECT_EQ(focus.value().far_distance, 0.0);
}

TEST(UniverseSetFocus, RefusesTagsThatAreNoneOrTheSame) {
  FocusedScene scene;
  for (const std::uint32_t tag : {64U, 77U, 0xFFFFFFFFU}) {
    abut_focus focus = default_focus();
    focus.near_tag = tag;
    EXPECT_TRUE(refused(abut_universe_set_focus(scene.universe, &focus, &scene.centre, 1), ABUT_OUT_OF_RANGE,
                        {"focus.near_tag", std::to_string(tag)}));
    focus = default_focus();
    focus.far_tag = tag;
    EXPECT_TRUE(refused(abut_universe_set_focus(scene.universe, &focus, &scene.centre, 1), ABUT_OUT_OF_RANGE,
                        {"focus.far_tag", std::to_string(tag)}));
  }
  abut_focus focus = default_focus();
  focus.near_tag = focus.far_tag = 9;
  EXPECT_TRUE(refused(abut_universe_set_focus(scene.universe, &focus, &scene.centre, 1), ABUT_INVALID_ARGUMENT,
                      {"far_tag", "9"}));
  EXPECT_TRUE(scene.keeps_its_focus());
}

TEST(UniverseSetFocus, RefusesNonFiniteAndOtherBadNumbers) {
  FocusedScene scene;
  expect_non_finite_refused("focus.near_distance", [&](double bad) {
    abut_focus focus = default_focus();
    focus.near_distance = bad;
    focus.far_distance = 9;
    return abut_universe_set_focus(scene.universe, &focus, &scene.centre, 1);
  });
  expect_non_finite_refused("focus.far_distance", [&](double bad) {
    abut_focus focus = default_focus();
    focus.far_distance = bad;
    return abut_universe_set_focus(scene.universe, &focus, &scene.centre, 1);
  });
  for (const BadVector& bad : non_finite_vectors()) {
    const std::array<abut_vec3, 2> centres{scene.centre, bad.vector};
    const abut_focus focus = default_focus();
    EXPECT_TRUE(refused(abut_universe_set_focus(scene.universe, &focus, centres.data(), 2), ABUT_NOT_FINITE,
                        {"centres[1]", bad.word}));
  }
  abut_focus focus = default_focus();
  focus.near_distance = -2.5;
  EXPECT_TRUE(refused(abut_universe_set_focus(scene.universe, &focus, nullptr, 0), ABUT_OUT_OF_RANGE,
                      {"near_distance", "-2.5"}));
  focus.near_distance = 2.5;
  focus.far_distance = 2.25;
  EXPECT_TRUE(refused(abut_universe_set_focus(scene.universe, &focus, nullptr, 0), ABUT_OUT_OF_RANGE,
                      {"far_distance", "2.25", "2.5"}));
  focus = default_focus();
  focus.reserved = 7;
  EXPECT_TRUE(
      refused(abut_universe_set_focus(scene.universe, &focus, nullptr, 0), ABUT_INVALID_ARGUMENT, {"reserved", "7"}));
  EXPECT_TRUE(scene.keeps_its_focus());
}

}  // namespace
