// SPDX-License-Identifier: Apache-2.0
// The filter of the caller: asked last, once for each pair, in order, and again only when it is told to.
#include "support.hpp"

namespace {

using namespace abut_test;

// Remembers what it was asked; leaves out a pair of slots; parks a geometry when it is asked first.
struct Filter {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asked;
  std::pair<std::uint32_t, std::uint32_t> left_out{0, 0};
  Universe* universe = nullptr;
  abut_geometry_id to_park{};
  abut_parking parking = ABUT_PARKING_NONE;
};

std::uint32_t ask(void* context, const abut_universe*, abut_geometry_id a, abut_geometry_id b) {
  auto& filter = *static_cast<Filter*>(context);
  if (filter.asked.empty() && filter.to_park.slot != 0) filter.universe->park(filter.to_park, filter.parking);
  filter.asked.emplace_back(a.slot, b.slot);
  return filter.asked.back() != filter.left_out ? 1 : 0;
}

// A row of balls, each of which touches the next one and the one after that.
struct Row {
  explicit Row(int count) {
    for (int i = 0; i < count; ++i) {
      parts.push_back(universe.add_part(at(0.9 * i, 0, 0)));
      geometries.push_back(universe.add_geometry(parts.back(), ball));
    }
    filter.universe = &universe;
    EXPECT_TRUE(succeeded(abut_universe_set_filter(universe, ask, &filter)));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asked_in_a_step() {
    filter.asked.clear();
    universe.step();
    return filter.asked;
  }

  Shape ball = make_sphere(1.0);
  Universe universe;
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
  Filter filter;
};

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

TEST(Filter, IsAskedOnceForEachPairInOrder) {
  Row row(4);
  const Pairs all{{1, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 4}};
  EXPECT_EQ(row.asked_in_a_step(), all);
  EXPECT_EQ(row.asked_in_a_step(), Pairs{}) << "answers are kept";
  row.universe.move(row.parts.at(1), at(0.95, 0, 0));
  EXPECT_EQ(row.asked_in_a_step(), Pairs{}) << "also when a pair moves";
  ASSERT_TRUE(succeeded(abut_universe_refilter(row.universe)));
  EXPECT_EQ(row.asked_in_a_step(), all);
  row.universe.move(row.parts.at(3), at(50, 0, 0));
  EXPECT_EQ(row.asked_in_a_step(), Pairs{});
  row.universe.move(row.parts.at(3), at(2.7, 0, 0));
  EXPECT_EQ(row.asked_in_a_step(), (Pairs{{2, 4}, {3, 4}})) << "pairs that come near are new";
}

TEST(Filter, IsAskedLast) {
  Row row(4);
  abut_geometry_options options = default_geometry_options();
  options.exclusion = 1;
  for (const std::size_t i : {1U, 2U}) {
    ASSERT_TRUE(succeeded(abut_geometry_set_options(row.universe, row.geometries.at(i), &options)));
  }
  const abut_collidable first{ABUT_COLLIDABLE_GEOMETRY, row.geometries[0].slot, row.geometries[0].generation};
  ASSERT_TRUE(succeeded(abut_rule_set(row.universe, &first, &anything, ABUT_RULE_DISABLE)));
  EXPECT_EQ(row.asked_in_a_step(), (Pairs{{2, 4}, {3, 4}}));
}

TEST(Filter, LeavesAPairOut) {
  Row row(4);
  row.filter.left_out = {2, 3};
  EXPECT_EQ(row.universe.step().size(), 4U);
  EXPECT_EQ(row.universe.stats().filtered_pairs, 1U);
  row.filter.left_out = {0, 0};
  EXPECT_EQ(row.universe.step().size(), 4U) << "until it is asked again";
  ASSERT_TRUE(succeeded(abut_universe_refilter(row.universe)));
  EXPECT_EQ(row.universe.step().size(), 5U);
  row.filter.left_out = {3, 4};
  ASSERT_TRUE(succeeded(abut_universe_refilter(row.universe)));
  EXPECT_EQ(row.universe.step().size(), 4U);
  ASSERT_EQ(row.universe.events().size(), 5U);
  EXPECT_EQ(row.universe.events().back().kind, abut_event_kind{ABUT_EVENT_END});
  ASSERT_TRUE(succeeded(abut_universe_set_filter(row.universe, nullptr, nullptr)));
  EXPECT_EQ(row.universe.step().size(), 5U) << "without a filter all are kept";
}

TEST(Filter, IsAskedAgainAboutAGeometryThatChanges) {
  Row row(4);
  row.universe.step();
  const Shape block = make_box(1, 1, 1);
  ASSERT_TRUE(succeeded(abut_geometry_set_shape(row.universe, row.geometries.at(0), block)));
  EXPECT_EQ(row.asked_in_a_step(), (Pairs{{1, 2}, {1, 3}}));
}

TEST(Filter, AnotherFilterIsAskedAboutEverything) {
  Row row(3);
  row.universe.step();
  Filter other;
  other.left_out = {1, 2};
  ASSERT_TRUE(succeeded(abut_universe_set_filter(row.universe, ask, &other)));
  EXPECT_EQ(row.universe.step().size(), 2U);
  EXPECT_EQ(other.asked.size(), 3U);
}

std::uint32_t ask_by_pointers(void* context, const abut_universe* universe, const abut_geometry_id* a,
                              const abut_geometry_id* b) {
  return ask(context, universe, *a, *b);
}

TEST(Filter, IsAskedTheSameByPointers) {
  Row row(3);
  row.filter.left_out = {1, 2};
  ASSERT_TRUE(succeeded(abut_universe_set_pointer_filter(row.universe, ask_by_pointers, &row.filter)));
  EXPECT_EQ(row.universe.step().size(), 2U);
  EXPECT_EQ(row.filter.asked, (Pairs{{1, 2}, {1, 3}, {2, 3}})) << "it took the place of the other filter";
  ASSERT_TRUE(succeeded(abut_universe_set_pointer_filter(row.universe, nullptr, nullptr)));
  EXPECT_EQ(row.universe.step().size(), 3U) << "without a filter all are kept";
}

TEST(Filter, MayParkWhichHappensAfterTheStep) {
  for (const abut_parking parking : {ABUT_PARKING_SHORT_TERM, ABUT_PARKING_LONG_TERM}) {
    Row row(3);
    row.filter.to_park = row.geometries.at(1);
    row.filter.parking = parking;
    EXPECT_EQ(row.universe.step().size(), 3U) << "the step goes on as if nothing had been parked";
    EXPECT_EQ(row.universe.describe(row.geometries.at(1)).parking, parking);
    EXPECT_EQ(row.universe.step().size(), 1U);
    ASSERT_EQ(row.universe.events().size(), 3U);
    EXPECT_EQ(row.universe.events().at(0).kind, abut_event_kind{ABUT_EVENT_END});
    EXPECT_EQ(row.universe.stats().parked, 1U);
  }
}

TEST(Filter, MayBringBack) {
  Row row(3);
  row.universe.park(row.geometries.at(2), ABUT_PARKING_LONG_TERM);
  row.filter.to_park = row.geometries.at(2);
  row.filter.parking = ABUT_PARKING_NONE;
  EXPECT_EQ(row.universe.step().size(), 1U);
  EXPECT_EQ(row.universe.step().size(), 3U);
}

}  // namespace
