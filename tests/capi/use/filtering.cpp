// SPDX-License-Identifier: Apache-2.0
// Which pairs are examined, and from which distance on they have contacts.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(Filtering, GeometriesOfOnePartNeverCollide) {
  const Shape block = make_box(1, 1, 1);
  Universe universe;
  const abut_part_id part = universe.add_part(identity);
  for (int i = 0; i < 3; ++i) universe.add_geometry(part, block);
  EXPECT_TRUE(universe.step().empty());
}

TEST(Filtering, GeometriesOfDifferentPartsCollide) {
  const Shape block = make_box(1, 1, 1);
  Universe universe;
  for (int i = 0; i < 3; ++i) universe.add(block, at(0.1 * i, 0, 0));
  universe.step();
  abut_step_stats stats;
  abut_step_stats_init(&stats, sizeof stats);
  ASSERT_TRUE(succeeded(abut_universe_stats(universe, &stats)));
  EXPECT_EQ(stats.touching_pairs, 3U);
}

TEST(Filtering, OneOfTwoPartsMustBeDynamic) {
  constexpr std::array<abut_motion, 3> motions{ABUT_MOTION_DYNAMIC, ABUT_MOTION_ANIMATED, ABUT_MOTION_STATIC};
  const Shape ball = make_sphere(1);
  for (const auto broadphase : {ABUT_BROADPHASE_BRUTE, ABUT_BROADPHASE_TREE}) {
    for (const abut_motion first : motions) {
      for (const abut_motion second : motions) {
        abut_universe_options options;
        abut_universe_options_init(&options, sizeof options);
        options.broadphase = broadphase;
        Universe universe(&options);
        universe.add(ball, identity, first);
        universe.add(ball, at(1, 0, 0), second);
        const bool is_examined = first == ABUT_MOTION_DYNAMIC || second == ABUT_MOTION_DYNAMIC;
        EXPECT_EQ(universe.step().size(), is_examined ? 1U : 0U) << first << " against " << second;
      }
    }
  }
}

// The gap of two unit balls on the X axis and their tolerances, in metres; whether they have a contact.
struct ToleranceCase {
  double gap;
  double tolerance_a;
  double tolerance_b;
  bool is_reported;
};

void check_tolerance(abut_tolerance_mode mode, const std::vector<ToleranceCase>& cases) {
  const Shape ball = make_sphere(1.0);
  for (const auto broadphase : {ABUT_BROADPHASE_BRUTE, ABUT_BROADPHASE_TREE}) {
    for (const ToleranceCase& each : cases) {
      abut_universe_options options;
      abut_universe_options_init(&options, sizeof options);
      options.tolerance_mode = mode;
      options.broadphase = broadphase;
      Universe universe(&options);
      universe.add(ball, at(0, 0, 0), ABUT_MOTION_DYNAMIC, each.tolerance_a);
      universe.add(ball, at(2.0 + each.gap, 0, 0), ABUT_MOTION_DYNAMIC, each.tolerance_b);
      const auto contacts = universe.step();
      EXPECT_EQ(contacts.size(), each.is_reported ? 1U : 0U)
          << "gap " << each.gap << ", tolerances " << each.tolerance_a << " and " << each.tolerance_b;
      if (!contacts.empty())
        EXPECT_NEAR(contacts[0].distance, each.gap, 1e-12) << "the distance stays that of the surfaces";
    }
  }
}

TEST(Tolerance, DeadBandReportsOverlapsThatExceedTheSum) {
  check_tolerance(ABUT_TOLERANCE_DEAD_BAND, {{-0.00199, 0.001, 0.001, false},
                                             {-0.00201, 0.001, 0.001, true},
                                             {-0.00199, 0.0, 0.002, false},
                                             {-0.00201, 0.002, 0.0, true},
                                             {-0.00299, 0.001, 0.002, false},
                                             {-0.00301, 0.001, 0.002, true},
                                             {0.001, 0.001, 0.001, false},
                                             {-1e-9, 0.0, 0.0, true},
                                             {1e-9, 0.0, 0.0, false}});
}

TEST(Tolerance, MarginReportsSeparationsBelowTheSum) {
  check_tolerance(ABUT_TOLERANCE_MARGIN, {{0.00199, 0.001, 0.001, true},
                                          {0.00201, 0.001, 0.001, false},
                                          {0.00199, 0.002, 0.0, true},
                                          {0.00201, 0.0, 0.002, false},
                                          {0.00299, 0.002, 0.001, true},
                                          {0.00301, 0.002, 0.001, false},
                                          {-0.5, 0.001, 0.001, true},
                                          {-1e-9, 0.0, 0.0, true},
                                          {1e-9, 0.0, 0.0, false}});
}

TEST(Tolerance, PairQueriesTakeAMargin) {
  const Shape ball = make_sphere(1.0);
  const abut_pose other = at(2.5, 0, 0);
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  for (const auto& [margin, expected] : {std::pair{0.0, 0U}, std::pair{0.499, 0U}, std::pair{0.501, 1U}}) {
    options.margin = margin;
    std::size_t count = 9;
    ASSERT_TRUE(succeeded(abut_pair_contacts(ball, &identity, ball, &other, &options, nullptr, 0, &count)));
    EXPECT_EQ(count, expected) << margin;
  }
  const abut_pose overlapping = at(1.5, 0, 0);
  for (const auto& [margin, expected] : {std::pair{-0.499, 1U}, std::pair{-0.501, 0U}}) {
    options.margin = margin;
    std::size_t count = 9;
    ASSERT_TRUE(succeeded(abut_pair_contacts(ball, &identity, ball, &overlapping, &options, nullptr, 0, &count)));
    EXPECT_EQ(count, expected) << margin;
  }
}

}  // namespace
