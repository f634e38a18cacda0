// SPDX-License-Identifier: Apache-2.0
// The universe as a whole under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(UniverseOptionsInit, IgnoresNull) { abut_universe_options_init(nullptr, 0); }

TEST(UniverseOptionsInit, FillsInTheDefaults) {
  Out<abut_universe_options> options;
  abut_universe_options_init(options.address(), sizeof(abut_universe_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_universe_options));
  EXPECT_EQ(options.value().broadphase, abut_broadphase{ABUT_BROADPHASE_AUTO});
  EXPECT_EQ(options.value().tolerance_mode, abut_tolerance_mode{ABUT_TOLERANCE_DEAD_BAND});
  EXPECT_EQ(options.value().max_contacts, 4U);
  EXPECT_EQ(options.value().origin.x, 0.0);
  EXPECT_EQ(options.value().origin.y, 0.0);
  EXPECT_EQ(options.value().origin.z, 0.0);
  EXPECT_EQ(options.value().threads, 1U);
  EXPECT_EQ(options.value().events, abut_event_bits{ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST});
}

TEST(UniverseCreate, RefusesUnknownValues) {
  Out<abut_universe*> out;
  for (const std::uint32_t value : {77U, 0xFFFFFFFFU}) {
    abut_universe_options options = default_universe_options();
    options.broadphase = value;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"broadphase", std::to_string(value)}));
    options = default_universe_options();
    options.tolerance_mode = value;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"tolerance_mode", std::to_string(value)}));
    options = default_universe_options();
    options.events = value & ~7U;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"events", std::to_string(value & ~7U)}));
    options = default_universe_options();
    options.flags = value & ~3U;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"flags", std::to_string(value & ~3U)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseCreate, RefusesMoreThreadsThanAnyMachineHas) {
  Out<abut_universe*> out;
  for (const std::uint32_t value : {1025U, 0xFFFFFFFFU}) {
    abut_universe_options options = default_universe_options();
    options.threads = value;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_OUT_OF_RANGE,
                        {"options.threads", std::to_string(value), "1024"}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseCreate, AcceptsLaterOptionsWithZeroTail) {
  abut_universe* universe = nullptr;
  expect_zero_tail_accepted(default_universe_options(),
                            [&](const abut_universe_options* later) { return abut_universe_create(later, &universe); });
  abut_universe_destroy(universe);
}

TEST(UniverseDestroy, IgnoresNull) { abut_universe_destroy(nullptr); }

TEST(UniverseStep, RefusesNonFiniteTime) {
  const Scene scene;
  expect_non_finite_refused("dt", [&](double bad) { return abut_universe_step(scene.universe, bad); });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseStep, RefusesNegativeTime) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, -2.5), ABUT_OUT_OF_RANGE, {"dt", "-2.5"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(ContactsSetUserData, RefusesCountsThatOverflowOrAreNotThatOfTheContacts) {
  const Scene scene;
  const std::vector<std::uint64_t> values(scene.universe.contacts().size() + 1, 7);
  expect_overflow_refused(sizeof(std::uint64_t), "count", [&](std::size_t count) {
    return abut_contacts_set_user_data(scene.universe, values.data(), count);
  });
  EXPECT_TRUE(refused(abut_contacts_set_user_data(scene.universe, values.data(), values.size()), ABUT_INVALID_ARGUMENT,
                      {"count", std::to_string(values.size()), std::to_string(values.size() - 1)}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(StepStatsInit, IgnoresNull) { abut_step_stats_init(nullptr, 0); }

TEST(StepStatsInit, FillsInSizeAndZeroes) {
  Out<abut_step_stats> stats;
  abut_step_stats_init(stats.address(), sizeof(abut_step_stats));
  EXPECT_EQ(stats.value().struct_size, sizeof(abut_step_stats));
  EXPECT_EQ(stats.value().reserved, 0U);
  EXPECT_EQ(stats.value().contacts, 0U);
  EXPECT_EQ(stats.value().contact_microseconds, 0.0);
}

TEST(UniverseStats, AcceptsLaterStructWithZeroTail) {
  const Scene scene;
  Grown<abut_step_stats> later{};
  abut_step_stats_init(&later.known, sizeof later.known);
  later.known.struct_size = sizeof(later);
  EXPECT_TRUE(succeeded(abut_universe_stats(scene.universe, &later.known)));
  EXPECT_EQ(later.known.geometries, 2U);
  EXPECT_EQ(later.known.struct_size, sizeof(later));
}

TEST(LayoutCount, IsNotZero) { EXPECT_GT(abut_layout_count(), 0U); }

TEST(LayoutAt, RefusesIndexPastTheEnd) {
  Out<abut_layout_entry> out;
  for (const std::size_t index : {abut_layout_count(), size_max}) {
    EXPECT_TRUE(
        refused(abut_layout_at(index, out.address()), ABUT_INDEX_OUT_OF_RANGE, {"index", std::to_string(index)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
