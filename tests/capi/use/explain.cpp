// SPDX-License-Identifier: Apache-2.0
// The plan in words.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

std::string explain(const abut_universe* universe) {
  std::size_t needed = 0;
  EXPECT_TRUE(succeeded(abut_universe_explain(universe, nullptr, 0, &needed)));
  std::string text(needed, '?');
  EXPECT_TRUE(succeeded(abut_universe_explain(universe, text.data(), text.size(), &needed)));
  EXPECT_EQ(needed, text.size());
  EXPECT_EQ(text.back(), '\0');
  text.pop_back();
  EXPECT_EQ(text.find('\0'), std::string::npos);
  return text;
}

TEST(Explain, NamesTheKindsOfThePairsAndWhatWasLeftOut) {
  Universe universe;
  const auto shapes = make_one_of_each_kind();
  for (const Shape& shape : shapes) universe.add(shape, identity);
  universe.add(make_plane({0, 1, 0}, 0), identity);
  universe.step();
  const std::string text = explain(universe);
  for (const std::string_view word : {"sphere", "box", "capsule", "plane", "hull", "mesh", "height_field"}) {
    EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
  }
  EXPECT_NE(text.find("unsupported"), std::string::npos) << "the plane against the other\n" << text;
  EXPECT_NE(text.find("GJK"), std::string::npos) << text;
  EXPECT_NE(text.find("left out"), std::string::npos) << text;
}

TEST(Explain, WorksOnAnEmptyUniverse) {
  const Universe universe;
  EXPECT_FALSE(explain(universe).empty());
}

TEST(Explain, CutsTheTextAndTerminatesIt) {
  const Scene scene;
  const std::string whole = explain(scene.universe);
  for (const std::size_t capacity :
       {std::size_t{1}, std::size_t{2}, std::size_t{17}, whole.size(), whole.size() + 1, whole.size() + 9}) {
    OutArray<char> text(whole.size() + 16);
    std::size_t needed = 0;
    ASSERT_TRUE(succeeded(abut_universe_explain(scene.universe, text.data(), capacity, &needed)));
    EXPECT_EQ(needed, whole.size() + 1);
    const std::size_t length = std::min(capacity - 1, whole.size());
    for (std::size_t i = 0; i < length; ++i) ASSERT_EQ(text[i], whole.at(i)) << i << " of " << capacity;
    EXPECT_EQ(text[length], '\0') << capacity;
    EXPECT_TRUE(text.is_untouched_from(length + 1)) << capacity;
  }
}

TEST(Explain, OfTheStepAreCounts) {
  const Scene scene;
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  ASSERT_TRUE(succeeded(abut_universe_stats(scene.universe, &stats)));
  EXPECT_EQ(stats.parts, 2U);
  EXPECT_EQ(stats.geometries, 2U);
  EXPECT_EQ(stats.candidate_pairs, 1U);
  EXPECT_EQ(stats.touching_pairs, 1U);
  EXPECT_EQ(stats.contacts, 1U);
  EXPECT_EQ(stats.unsupported_pairs, 0U);
  EXPECT_GT(stats.bytes, 0U);
  EXPECT_GE(stats.narrowphase_microseconds, 0.0);
}

TEST(Explain, StatisticsAreZeroBeforeTheFirstStep) {
  Universe universe;
  const Shape ball = make_sphere(1);
  universe.add(ball, identity);
  universe.add(ball, identity);
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  ASSERT_TRUE(succeeded(abut_universe_stats(universe, &stats)));
  EXPECT_EQ(stats.candidate_pairs, 0U);
  EXPECT_EQ(stats.contacts, 0U);
}

}  // namespace
