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

TEST(UniverseCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_universe_create(nullptr, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
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
    options.flags = value & ~1U;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"flags", std::to_string(value & ~1U)}));
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

TEST(UniverseCreate, RefusesNonFiniteOrigin) {
  Out<abut_universe*> out;
  for (const BadVector& bad : non_finite_vectors()) {
    abut_universe_options options = default_universe_options();
    options.origin = bad.vector;
    EXPECT_TRUE(refused(abut_universe_create(&options, out.address()), ABUT_NOT_FINITE, {"origin", bad.word}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseCreate, RefusesWrongStructSize) {
  Out<abut_universe*> out;
  expect_struct_size_checked(default_universe_options(), [&](const abut_universe_options* wrong) {
    return abut_universe_create(wrong, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseCreate, AcceptsLaterOptionsWithZeroTail) {
  abut_universe* universe = nullptr;
  expect_zero_tail_accepted(default_universe_options(),
                            [&](const abut_universe_options* later) { return abut_universe_create(later, &universe); });
  abut_universe_destroy(universe);
}

TEST(UniverseDestroy, IgnoresNull) { abut_universe_destroy(nullptr); }

TEST(UniverseStep, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_universe_step(nullptr, 0.0), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

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

TEST(UniverseParts, RefusesNullPointers) {
  const Scene scene;
  OutArray<abut_part_id> parts(4);
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_parts(nullptr, parts.data(), 4, count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_parts(scene.universe, nullptr, 4, count.address()), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_parts(scene.universe, parts.data(), 4, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(parts.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(UniverseGeometries, RefusesNullPointers) {
  const Scene scene;
  OutArray<abut_geometry_id> geometries(4);
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_geometries(nullptr, geometries.data(), 4, count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_geometries(scene.universe, nullptr, 4, count.address()), ABUT_NULL_ARGUMENT,
                      {"geometries", "null"}));
  EXPECT_TRUE(refused(abut_universe_geometries(scene.universe, geometries.data(), 4, nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(geometries.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(UniverseRevision, RefusesNullPointers) {
  const Scene scene;
  Out<abut_revision> out;
  EXPECT_TRUE(refused(abut_universe_revision(nullptr, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_revision(scene.universe, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseCounters, RefusesNullPointers) {
  const Scene scene;
  Out<const std::uint64_t*> geometries;
  Out<const std::uint64_t*> poses;
  EXPECT_TRUE(refused(abut_universe_counters(nullptr, geometries.address(), poses.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_counters(scene.universe, nullptr, poses.address()), ABUT_NULL_ARGUMENT,
                      {"geometries", "null"}));
  EXPECT_TRUE(refused(abut_universe_counters(scene.universe, geometries.address(), nullptr), ABUT_NULL_ARGUMENT,
                      {"poses", "null"}));
  EXPECT_TRUE(geometries.is_untouched());
  EXPECT_TRUE(poses.is_untouched());
}

TEST(UniverseChanges, RefusesNullPointersAndOverflow) {
  const Scene scene;
  const abut_revision since{};
  Out<std::size_t> count;
  Out<std::uint32_t> is_known;
  OutArray<abut_geometry_id> changed(4);
  EXPECT_TRUE(refused(abut_universe_changes(nullptr, &since, changed.data(), 4, count.address(), is_known.address()),
                      ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_changes(scene.universe, nullptr, changed.data(), 4, count.address(), is_known.address()),
              ABUT_NULL_ARGUMENT, {"since", "null"}));
  EXPECT_TRUE(refused(abut_universe_changes(scene.universe, &since, nullptr, 4, count.address(), is_known.address()),
                      ABUT_NULL_ARGUMENT, {"geometries", "null"}));
  EXPECT_TRUE(refused(abut_universe_changes(scene.universe, &since, changed.data(), 4, nullptr, is_known.address()),
                      ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(refused(abut_universe_changes(scene.universe, &since, changed.data(), 4, count.address(), nullptr),
                      ABUT_NULL_ARGUMENT, {"is_known", "null"}));
  EXPECT_TRUE(refused(abut_universe_changes(scene.universe, &since, changed.data(), ~std::size_t{0}, count.address(),
                                            is_known.address()),
                      ABUT_SIZE_OVERFLOW, {"capacity"}));
  EXPECT_TRUE(count.is_untouched());
  EXPECT_TRUE(is_known.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseContacts, RefusesNullPointers) {
  const Scene scene;
  Out<const abut_contact*> contacts;
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_contacts(nullptr, contacts.address(), count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_contacts(scene.universe, nullptr, count.address()), ABUT_NULL_ARGUMENT,
                      {"contacts", "null"}));
  EXPECT_TRUE(refused(abut_universe_contacts(scene.universe, contacts.address(), nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(contacts.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(ContactsSetUserData, RefusesNullPointers) {
  const Scene scene;
  const std::uint64_t value = 7;
  EXPECT_TRUE(refused(abut_contacts_set_user_data(nullptr, &value, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_contacts_set_user_data(scene.universe, nullptr, 1), ABUT_NULL_ARGUMENT, {"user_data", "null"}));
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

TEST(UniverseStats, RefusesNullPointers) {
  const Scene scene;
  abut_step_stats good;
  abut_step_stats_init(&good, sizeof good);
  Out<abut_step_stats> out(good);
  EXPECT_TRUE(refused(abut_universe_stats(nullptr, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_stats(scene.universe, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseStats, RefusesWrongStructSize) {
  const Scene scene;
  abut_step_stats good;
  abut_step_stats_init(&good, sizeof good);
  expect_size_of_out_struct_checked(good,
                                    [&](abut_step_stats* out) { return abut_universe_stats(scene.universe, out); });
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

TEST(UniverseExplain, RefusesNullPointers) {
  const Scene scene;
  OutArray<char> text(64);
  Out<std::size_t> needed;
  EXPECT_TRUE(refused(abut_universe_explain(nullptr, text.data(), 64, needed.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_explain(scene.universe, nullptr, 64, needed.address()), ABUT_NULL_ARGUMENT,
                      {"text", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_explain(scene.universe, text.data(), 64, nullptr), ABUT_NULL_ARGUMENT, {"needed", "null"}));
  EXPECT_TRUE(text.is_untouched());
  EXPECT_TRUE(needed.is_untouched());
}

TEST(UniverseExplainJson, RefusesNullPointers) {
  const Scene scene;
  OutArray<char> text(64);
  Out<std::size_t> needed;
  EXPECT_TRUE(refused(abut_universe_explain_json(nullptr, text.data(), 64, needed.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_explain_json(scene.universe, nullptr, 64, needed.address()), ABUT_NULL_ARGUMENT,
                      {"text", "null"}));
  EXPECT_TRUE(refused(abut_universe_explain_json(scene.universe, text.data(), 64, nullptr), ABUT_NULL_ARGUMENT,
                      {"needed", "null"}));
  EXPECT_TRUE(text.is_untouched());
  EXPECT_TRUE(needed.is_untouched());
}

TEST(LayoutCount, IsNotZero) { EXPECT_GT(abut_layout_count(), 0U); }

TEST(LayoutAt, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_layout_at(0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(LayoutAt, RefusesIndexPastTheEnd) {
  Out<abut_layout_entry> out;
  for (const std::size_t index : {abut_layout_count(), size_max}) {
    EXPECT_TRUE(
        refused(abut_layout_at(index, out.address()), ABUT_INDEX_OUT_OF_RANGE, {"index", std::to_string(index)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
