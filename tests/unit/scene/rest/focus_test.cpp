// SPDX-License-Identifier: Apache-2.0
// Near and far: the two tags of a focus by the distance of boxes from its centres.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

import abut.math;
import abut.scene.rest.focus;

namespace {

using namespace abut;

constexpr Focus focus{.near_tag = 3, .far_tag = 5, .near_distance = 2, .far_distance = 4};

// A cube of side 2 around a point of the x axis.
CompactAabb box_at(Real x) { return compact(Aabb::around({x, 0, 0}, {1, 1, 1}), {0, 0, 0}); }

FocusCentres around(std::vector<Vec3> centres) {
  FocusCentres all;
  all.set(focus, centres, {0, 0, 0});
  return all;
}

TEST(Focus, KeepsATagBetweenTheTwoDistances) {
  const FocusCentres centres = around({{0, 0, 0}});
  std::uint32_t tag = focus.far_tag;
  // The face towards the centre is at x - 1.
  const std::array<std::pair<Real, std::uint32_t>, 9> way{
      {{9, 5}, {5.5, 5}, {4.5, 5}, {3.5, 5}, {2.9, 3}, {3.5, 3}, {4.9, 3}, {5.1, 5}, {3.1, 5}}};
  for (const auto& [x, expected] : way) {
    tag = centres.tag_of(box_at(x), tag);
    EXPECT_EQ(tag, expected) << "at " << x;
  }
}

TEST(Focus, MeasuresFromTheNearestCentre) {
  const FocusCentres centres = around({{100, 0, 0}, {0, 3.5, 0}, {-100, 0, 0}});
  EXPECT_EQ(centres.tag_of(box_at(0), 5), 5U) << "2.5 from the second";
  EXPECT_EQ(centres.tag_of(box_at(-98), 5), 3U);
  EXPECT_EQ(centres.tag_of(box_at(50), 3), 5U);
  EXPECT_EQ(centres.tag_of(CompactAabb{{-9, -9, -9}, {9, 9, 9}}, 5), 3U) << "a centre inside";
}

TEST(Focus, OfNoCentresIsFarFromEverything) {
  const FocusCentres none = around({});
  EXPECT_EQ(none.tag_of(box_at(0), 3), 5U);
  constexpr float far = std::numeric_limits<float>::infinity();
  const CompactAabb everything{{-far, -far, -far}, {far, far, far}};
  EXPECT_EQ(none.tag_of(everything, 3), 5U);
  EXPECT_EQ(around({{7, 7, 7}}).tag_of(everything, 5), 3U) << "what has no bounds is near to any centre";
}

TEST(Focus, ConcernsItsTwoTagsOnly) {
  const FocusCentres centres = around({});
  EXPECT_TRUE(centres.concerns(3));
  EXPECT_TRUE(centres.concerns(5));
  EXPECT_FALSE(centres.concerns(4));
  EXPECT_FALSE(centres.concerns(0));
}

TEST(Focus, TellsWhetherAnythingHasChanged) {
  FocusCentres centres;
  const std::array<Vec3, 2> two{Vec3{1, 2, 3}, Vec3{4, 5, 6}};
  EXPECT_TRUE(centres.set(focus, two, {0, 0, 0}));
  EXPECT_FALSE(centres.set(focus, two, {0, 0, 0}));
  EXPECT_TRUE(centres.set(focus, std::span(two).first(1), {0, 0, 0}));
  const Vec3 moved{1, 2, 3.5};
  EXPECT_TRUE(centres.set(focus, std::span(&moved, 1), {0, 0, 0}));
  Focus wider = focus;
  wider.far_distance = 4.5;
  EXPECT_TRUE(centres.set(wider, std::span(&moved, 1), {0, 0, 0}));
  EXPECT_FALSE(centres.set(wider, std::span(&moved, 1), {0, 0, 0}));
}

TEST(Focus, AllocatesForMoreCentresOnly) {
  FocusCentres centres;
  const std::vector<Vec3> many(100);
  centres.set(focus, many, {0, 0, 0});
  const std::size_t bytes = centres.bytes();
  EXPECT_GE(bytes, 100 * sizeof(Vec3));
  for (const std::size_t count : {std::size_t{3}, std::size_t{0}, std::size_t{100}}) {
    centres.set(focus, std::span(many).first(count), {1, 1, 1});
    EXPECT_EQ(centres.size(), count);
    EXPECT_EQ(centres.bytes(), bytes);
  }
}

// Boxes are relative to the origin of the universe, centres are not.
TEST(Focus, IsRelativeToTheOrigin) {
  FocusCentres centres;
  const Vec3 origin{1e6, 0, 0}, centre{1e6 + 10, 0, 0};
  centres.set(focus, std::span(&centre, 1), origin);
  const auto box = [&](Real x) { return compact(Aabb::around({1e6 + x, 0, 0}, {1, 1, 1}), origin); };
  EXPECT_EQ(centres.tag_of(box(10), 5), 3U);
  EXPECT_EQ(centres.tag_of(box(0), 3), 5U);
}

TEST(Focus, IsCheckedBeforeItIsTaken) {
  EXPECT_FALSE(check_focus({}).has_value());
  EXPECT_FALSE(check_focus(focus).has_value());
  EXPECT_FALSE(check_focus({.near_distance = 2, .far_distance = 2}).has_value());
  const auto name_of_fault = [](const Focus& wrong) {
    const auto fault = check_focus(wrong);
    return fault ? fault->message.substr(0, fault->message.find(' ')) : "none";
  };
  EXPECT_EQ(name_of_fault({.near_tag = 64}), "near_tag");
  EXPECT_EQ(name_of_fault({.far_tag = 64}), "far_tag");
  EXPECT_EQ(name_of_fault({.near_tag = 1, .far_tag = 1}), "far_tag");
  EXPECT_EQ(name_of_fault({.near_distance = -1, .far_distance = 1}), "near_distance");
  EXPECT_EQ(name_of_fault({.near_distance = 2, .far_distance = 1}), "far_distance");
  EXPECT_EQ(name_of_fault({.far_distance = std::numeric_limits<Real>::infinity()}), "far_distance");
}

}  // namespace
