// SPDX-License-Identifier: Apache-2.0
// Shapes that move and turn, under bad input.
#include <cmath>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Two shapes, each with two poses and two movements; the first of both is the one of a single question.
struct ImpactCall {
  Shape a = make_sphere(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  std::array<abut_pose, 2> poses_a{at(0, 0, 0), at(1, 0, 0)}, poses_b{at(5, 0, 0), at(6, 0, 0)};
  std::array<abut_movement, 2> movements_a{}, movements_b{};
  double duration = 1;
  Out<abut_impact> one;
  OutArray<abut_impact> both{2};

  ImpactCall() { movements_b[0].velocity = movements_b[1].velocity = {-9, 0, 0}; }
  abut_status ask(const abut_impact_options* options = nullptr) {
    return abut_pair_time_of_impact(a, poses_a.data(), movements_a.data(), b, poses_b.data(), movements_b.data(),
                                    duration, options, one.address());
  }
  abut_status ask_all(const abut_impact_options* options = nullptr, std::size_t count = 2) {
    return abut_pairs_time_of_impact(a, poses_a.data(), movements_a.data(), b, poses_b.data(), movements_b.data(),
                                     count, duration, options, both.data());
  }
  bool is_untouched() const { return one.is_untouched() && both.is_untouched(); }
};

abut_impact_options default_impact_options() {
  abut_impact_options options;
  abut_impact_options_init(&options, sizeof options);
  return options;
}

void refuses_null(abut_status status, std::string_view name) {
  EXPECT_TRUE(refused(status, ABUT_NULL_ARGUMENT, {name, "null"}));
}

TEST(PairsTimeOfImpact, RefusesNonFiniteMovementsByTheirNumber) {
  for (const BadVector& bad : non_finite_vectors()) {
    ImpactCall call;
    call.movements_a[1].angular_velocity = bad.vector;
    EXPECT_TRUE(refused(call.ask_all(), ABUT_NOT_FINITE, {"movements_a[1].angular_velocity", bad.word}));
    EXPECT_TRUE(call.is_untouched());
  }
}

TEST(PairTimeOfImpact, RefusesDurationsAndTurnsOutOfRange) {
  ImpactCall call;
  for (const double duration : {0.0, -1.0}) {
    call.duration = duration;
    EXPECT_TRUE(refused(call.ask(), ABUT_OUT_OF_RANGE, {"duration", duration < 0 ? "-1" : "0"}));
    EXPECT_TRUE(refused(call.ask_all(), ABUT_OUT_OF_RANGE, {"duration"}));
  }
  call.duration = 1;
  call.movements_a[0].angular_velocity = {0, 0, 128 * std::atan(1.0) * 2};
  EXPECT_TRUE(refused(call.ask(), ABUT_OUT_OF_RANGE, {"movement_a.revolutions is 32", "16"}));
  EXPECT_TRUE(refused(call.ask_all(), ABUT_OUT_OF_RANGE, {"movements_a[0].revolutions is 32", "16"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairTimeOfImpact, RefusesBadOptions) {
  ImpactCall call;
  abut_impact_options options = default_impact_options();
  options.margin = -0.5;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"options.margin", "-0.5"}));
  options = default_impact_options();
  options.tolerance = -1;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"options.tolerance", "-1"}));
  options = default_impact_options();
  options.most_rounds = 0;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"options.most_rounds", "0"}));
  options = default_impact_options();
  options.reserved = 1;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_INVALID_ARGUMENT, {"options.reserved"}));
  options = default_impact_options();
  options.threads = 4096;
  EXPECT_TRUE(refused(call.ask_all(&options), ABUT_OUT_OF_RANGE, {"options.threads", "4096"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairTimeOfImpact, RefusesPlaneAgainstPlane) {
  ImpactCall call;
  call.a = make_plane({0.0, 0.0, 1.0}, 0.0);
  call.b = make_plane({1.0, 0.0, 0.0}, 0.0);
  EXPECT_TRUE(refused(call.ask(), ABUT_UNSUPPORTED, {"plane and plane"}));
  EXPECT_TRUE(refused(call.ask_all(), ABUT_UNSUPPORTED, {"pair 0", "plane and plane"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(MovementBetween, RefusesNullAndNonFinite) {
  const abut_pose start = at(0, 0, 0), end = at(1, 0, 0);
  const abut_vec3 centre{0, 0, 0};
  Out<abut_movement> out;
  refuses_null(abut_movement_between(nullptr, &end, &centre, 1, out.address()), "start");
  refuses_null(abut_movement_between(&start, nullptr, &centre, 1, out.address()), "end");
  refuses_null(abut_movement_between(&start, &end, nullptr, 1, out.address()), "centre");
  refuses_null(abut_movement_between(&start, &end, &centre, 1, nullptr), "out");
  for (const BadPose& bad : bad_poses()) {
    EXPECT_TRUE(
        refused(abut_movement_between(&start, &bad.pose, &centre, 1, out.address()), bad.status, {"end", bad.word}));
  }
  for (const BadNumber& bad : non_finite_numbers) {
    EXPECT_TRUE(refused(abut_movement_between(&start, &end, &centre, bad.value, out.address()), ABUT_NOT_FINITE,
                        {"duration", bad.word}));
  }
  EXPECT_TRUE(refused(abut_movement_between(&start, &end, &centre, 0, out.address()), ABUT_OUT_OF_RANGE, {"duration"}));
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
