// SPDX-License-Identifier: Apache-2.0
// Two shapes alone, and spans.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>
#if __cplusplus >= 202002L
#include <span>
#endif

namespace {

const abut::Pose above = abut::pose({0, 0, 3});

TEST(Pair, HasADistance) {
  const abut::Shape ball = abut::Shape::sphere(1);
  EXPECT_EQ(abut::pair_distance(ball, abut::pose(), ball, above).distance, 1);
  const auto options = abut::QueryOptions().with_algorithm(ABUT_ALGORITHM_GJK_EPA).with_error_bound(1e-6);
  EXPECT_NEAR(abut::pair_distance(ball, abut::pose(), ball, above, options).distance, 1, 1e-6);
  EXPECT_THROW(static_cast<void>(abut::pair_distance(ball, abut::pose(), ball, abut::Pose{})), abut::Error);
}

TEST(Pair, TellsWhichRouteABudgetTakes) {
  const abut::ShapeKind ball = abut::shape_kind("sphere");
  abut::load_routes("# abut routes 1\ndistance sphere sphere auto 0.01 1e-07 0.01\n");
  const auto options = abut::QueryOptions().with_time_budget(1e-3);
  const std::vector<abut::Route> routes = abut::pair_routes(ball, ball, ABUT_QUERY_DISTANCE, options);
  ASSERT_EQ(routes.size(), 1U);
  EXPECT_EQ(routes[0].error_bound, 0.01);
  EXPECT_NE(routes[0].flags & ABUT_ROUTE_CHOSEN, 0U);
  EXPECT_EQ(abut::Policy().with_time_budget(2).time_budget, 2);
  EXPECT_THROW(abut::load_routes("none"), abut::Error);
  abut::load_routes(nullptr);
  EXPECT_FALSE(abut::pair_routes(ball, ball, ABUT_QUERY_CONTACTS).empty());
}

TEST(Pair, RemembersWhereItWas) {
  const abut::Shape hull = abut::Shape::hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  abut::PairMemory memory;
  const abut::Distance cold = abut::pair_distance(hull, abut::pose(), hull, above);
  EXPECT_NEAR(abut::pair_distance(hull, abut::pose(), hull, above, memory).distance, cold.distance, 1e-12);
  std::uint64_t bits = 0;
  for (const std::uint64_t word : memory.opaque) bits |= word;
  EXPECT_NE(bits, 0U);
  const abut::Pose low = abut::pose({0, 0, 0.5});
  abut::PairMemory touching;
  EXPECT_EQ(abut::pair_contacts(hull, abut::pose(), hull, low, touching).size(),
            abut::pair_contacts(hull, abut::pose(), hull, low).size());
}

TEST(Pair, IsAskedAtManyPoses) {
  const abut::Shape ball = abut::Shape::sphere(1);
  const std::vector<abut::Pose> here(20, abut::pose());
  std::vector<abut::Pose> there;
  for (int i = 0; i < 20; ++i) there.push_back(abut::pose({0, 0, 1.0 + i}));
  const std::vector<abut::Distance> answers = abut::pairs_distance(ball, here, ball, there);
  ASSERT_EQ(answers.size(), 20U);
  EXPECT_EQ(answers[19].distance, 18);

  std::vector<abut::Distance> out(20);
  std::vector<abut::PairMemory> memories(20);
  abut::pairs_distance(ball, here, ball, there, out, memories);
  EXPECT_EQ(out[19].distance, 18);
  EXPECT_THROW(
      static_cast<void>(abut::pairs_distance(ball, here, ball, there, abut::Span<abut::Distance>(out.data(), 19))),
      abut::Error);
  there.pop_back();
  try {
    static_cast<void>(abut::pairs_distance(ball, here, ball, there));
    ADD_FAILURE();
  } catch (const abut::Error& error) {
    EXPECT_STREQ(error.what(), "poses_b has 19 elements; it must have 20, as many as poses_a");
    EXPECT_STREQ(error.name(), "ABUT_INVALID_ARGUMENT");
  }
}

TEST(Pair, TellsWhetherTheyOverlap) {
  const abut::Shape box = abut::Shape::box(1, 1, 1), ball = abut::Shape::sphere(1);
  EXPECT_TRUE(abut::pair_overlaps(box, abut::pose(), ball, abut::pose({1.5, 0, 0})));
  EXPECT_FALSE(abut::pair_overlaps(box, abut::pose(), ball, abut::pose({2.5, 0, 0})));
  EXPECT_TRUE(
      abut::pair_overlaps(box, abut::pose(), ball, abut::pose({2.5, 0, 0}), abut::QueryOptions().with_margin(0.5)));
  const std::vector<abut::Shape> first{box, ball}, second{ball, box};
  const std::vector<abut::Pose> here(2, abut::pose()), there{abut::pose({1.5, 0, 0}), abut::pose({2.5, 0, 0})};
  EXPECT_EQ(std::vector<std::uint32_t>(abut::pairs_overlap(first, here, second, there)),
            (std::vector<std::uint32_t>{1, 0}));
  const std::vector<abut::Shape> one{box};
  EXPECT_THROW(static_cast<void>(abut::pairs_overlap(one, here, second, there)), abut::Error);
}

TEST(Pair, HasContacts) {
  const abut::Shape box = abut::Shape::box(1, 1, 1);
  const abut::Pose low = abut::pose({0, 0, 1.75});
  EXPECT_EQ(abut::pair_contacts(box, abut::pose(), box, low).size(), 4U);
  std::array<abut::Contact, 2> few{};
  EXPECT_EQ(abut::pair_contacts(box, abut::pose(), box, low, few), 4U);
  abut::validate(few[1]);
  few[1].distance = 5;
  EXPECT_THROW(abut::validate(few[1]), abut::Error);
}

TEST(Pair, HasAsManyContactsAsThereAre) {
  std::vector<abut::Vec3> centres;
  for (int i = 0; i < 40; ++i) centres.push_back({2.0 * i, 0, 0});
  const abut::Shape many = abut::Shape::particles(centres, 0.5);
  const auto options = abut::QueryOptions().with_max_contacts(0);
  EXPECT_EQ(abut::pair_contacts(many, abut::pose(), abut::Shape::plane({0, 0, 1}, 0), abut::pose(), options).size(),
            40U);
}

TEST(Pair, IsCast) {
  const abut::Shape ball = abut::Shape::sphere(1);
  const auto hit = abut::pair_cast(ball, abut::pose(), {0, 0, 2}, ball, above, {0, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->fraction, 0.5, 1e-9);
  EXPECT_FALSE(abut::pair_cast(ball, abut::pose(), {0, 0, -2}, ball, above, {0, 0, 0}));
}

TEST(Pair, HasContactsAtManyPoses) {
  const abut::Shape box = abut::Shape::box(1, 1, 1);
  const std::vector<abut::Pose> here(3, abut::pose());
  const std::vector<abut::Pose> there{abut::pose({0, 0, 1.75}), abut::pose({0, 0, 9}), abut::pose({0, 1.5, 0})};
  const abut::ContactLists lists = abut::pairs_contacts(box, here, box, there, abut::QueryOptions().with_threads(1));
  ASSERT_EQ(lists.query_count(), 3U);
  EXPECT_EQ(lists.of(0).size(), 4U);
  EXPECT_TRUE(lists.of(1).empty());
  EXPECT_EQ(lists.of(2)[0].distance, -0.5);
  std::vector<abut::PairMemory> memories(3);
  EXPECT_EQ(abut::pairs_contacts(box, here, box, there, memories).offsets, lists.offsets);
  memories.pop_back();
  EXPECT_THROW(static_cast<void>(abut::pairs_contacts(box, here, box, there, memories)), abut::Error);
}

// More than there is room for at first.
TEST(Pair, HasAsManyContactsAtManyPosesAsThereAre) {
  std::vector<abut::Vec3> centres;
  for (int i = 0; i < 40; ++i) centres.push_back({2.0 * i, 0, 0});
  const abut::Shape many = abut::Shape::particles(centres, 0.5);
  const auto options = abut::QueryOptions().with_max_contacts(0);
  const std::vector<abut::Pose> here(3, abut::pose());
  const auto lists = abut::pairs_contacts(many, here, abut::Shape::plane({0, 0, 1}, 0), here, options);
  EXPECT_EQ(lists.all.size(), 120U);
  EXPECT_EQ(lists.of(2).size(), 40U);
}

TEST(Pair, IsCastAtManyPoses) {
  const abut::Shape ball = abut::Shape::sphere(1);
  const std::vector<abut::Pose> here(2, abut::pose()), there(2, above);
  const std::vector<abut::Vec3> ways{{0, 0, 2}, {0, 0, -2}}, still(2);
  const std::vector<abut::CastHit> hits = abut::pairs_cast(ball, here, ways, ball, there, still);
  EXPECT_NEAR(hits[0].fraction, 0.5, 1e-9);
  EXPECT_EQ(hits[1].fraction, std::numeric_limits<double>::infinity());
  std::array<abut::CastHit, 2> out{};
  abut::pairs_cast(ball, here, ways, ball, there, still, out);
  EXPECT_EQ(out[0].fraction, hits[0].fraction);
  EXPECT_THROW(static_cast<void>(abut::pairs_cast(ball, here, {{0, 0, 2}}, ball, there, still)), abut::Error);
}

std::size_t size_of(abut::Span<const double> values) { return values.size(); }

TEST(Span, ViewsAnyRowOfValues) {
  const std::vector<double> vector{1, 2, 3};
  const double array[2] = {1, 2};
  EXPECT_EQ(size_of(vector), 3U);
  EXPECT_EQ(size_of(array), 2U);
  EXPECT_EQ(size_of({1.0, 2.0, 3.0, 4.0}), 4U);
  EXPECT_EQ(size_of({}), 0U);
  double sum = 0;
  for (const double value : abut::Span<const double>(vector)) sum += value;
  EXPECT_EQ(sum, 6);
#if __cplusplus >= 202002L
  const std::span<const double> standard = abut::Span<const double>(vector);
  EXPECT_EQ(standard.data(), vector.data());
  EXPECT_EQ(size_of(standard.subspan(1)), 2U);
#endif
}

}  // namespace
