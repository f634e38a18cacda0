// SPDX-License-Identifier: Apache-2.0
// Distance and contacts of two shapes under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// The three queries of a pair behind one signature, so that each bad input meets all of them.
struct PairCall {
  Shape a = make_sphere(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  abut_pose pose_a = identity;
  abut_pose pose_b = at(1.5, 0.0, 0.0);
  Out<abut_distance> distance;
  OutArray<abut_contact> contacts{8};
  Out<std::size_t> count;

  abut_status ask_distance(const abut_query_options* options) {
    return abut_pair_distance(a, &pose_a, b, &pose_b, options, distance.address());
  }
  abut_status ask_distances(const abut_query_options* options) {
    return abut_pairs_distance(a, &pose_a, b, &pose_b, 1, options, distance.address());
  }
  abut_status ask_contacts(const abut_query_options* options) {
    return abut_pair_contacts(a, &pose_a, b, &pose_b, options, contacts.data(), contacts.size(), count.address());
  }
  bool is_untouched() const { return distance.is_untouched() && contacts.is_untouched() && count.is_untouched(); }
};

using Ask = abut_status (PairCall::*)(const abut_query_options*);

void refuse_bad_options(Ask ask) {
  PairCall call;
  abut_query_options options = default_options();
  for (const abut_algorithm algorithm : {6U, 77U, 0xFFFFFFFFU}) {
    options.algorithm = algorithm;
    EXPECT_TRUE(refused((call.*ask)(&options), ABUT_UNKNOWN_VALUE, {"algorithm", std::to_string(algorithm)}));
  }
  options = default_options();
  options.error_bound = -2.5;
  EXPECT_TRUE(refused((call.*ask)(&options), ABUT_OUT_OF_RANGE, {"error_bound", "-2.5"}));
  EXPECT_TRUE(call.is_untouched());
}

void refuse_non_finite_options(Ask ask) {
  PairCall call;
  abut_query_options options = default_options();
  expect_non_finite_refused("error_bound", [&](double bad) {
    options.error_bound = bad;
    return (call.*ask)(&options);
  });
  options = default_options();
  expect_non_finite_refused("margin", [&](double bad) {
    options.margin = bad;
    return (call.*ask)(&options);
  });
  EXPECT_TRUE(call.is_untouched());
}

void refuse_wrong_struct_size(Ask ask) {
  PairCall call;
  expect_struct_size_checked(default_options(), [&](const abut_query_options* wrong) { return (call.*ask)(wrong); });
  EXPECT_TRUE(call.is_untouched());
  expect_zero_tail_accepted(default_options(), [&](const abut_query_options* later) { return (call.*ask)(later); });
}

void refuse_planes_against_planes(Ask ask) {
  PairCall call;
  call.a = make_plane({0.0, 0.0, 1.0}, 0.0);
  call.b = make_plane({0.0, 0.0, 1.0}, 0.0);
  EXPECT_TRUE(refused((call.*ask)(nullptr), ABUT_UNSUPPORTED, {"plane"}));
  EXPECT_TRUE(call.is_untouched());
}

// The convex algorithms of libccd know no half-spaces, and nobody separates hulls analytically.
void refuse_algorithms_that_the_pair_lacks(Ask ask) {
  PairCall call;
  abut_query_options options = default_options();
  options.algorithm = ABUT_ALGORITHM_ANALYTIC;
  call.a = make_octahedron(1.0);
  call.b = make_octahedron(1.0);
  EXPECT_TRUE(refused((call.*ask)(&options), ABUT_UNSUPPORTED, {"algorithm"}));
  options.algorithm = ABUT_ALGORITHM_LIBCCD_GJK;
  call.a = make_terrain(3, 1.0);
  call.b = make_plane({0.0, 0.0, 1.0}, 0.0);
  EXPECT_TRUE(refused((call.*ask)(&options), ABUT_UNSUPPORTED, {}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(QueryOptionsInit, IgnoresNull) { abut_query_options_init(nullptr, 0); }

TEST(QueryOptionsInit, FillsInTheDefaults) {
  Out<abut_query_options> options;
  abut_query_options_init(options.address(), sizeof(abut_query_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_query_options));
  EXPECT_EQ(options.value().algorithm, abut_algorithm{ABUT_ALGORITHM_AUTO});
  EXPECT_EQ(options.value().error_bound, 0.0);
  EXPECT_EQ(options.value().margin, 0.0);
  EXPECT_EQ(options.value().max_contacts, 4U);
  EXPECT_EQ(options.value().max_pair_contacts, 0U);
  EXPECT_EQ(options.value().threads, 0U);
}

TEST(PairDistance, RefusesNullPointers) {
  PairCall call;
  abut_distance* const out = call.distance.address();
  const abut_pose* const pose = &identity;
  EXPECT_TRUE(
      refused(abut_pair_distance(nullptr, pose, call.b, pose, nullptr, out), ABUT_NULL_ARGUMENT, {"a", "null"}));
  EXPECT_TRUE(
      refused(abut_pair_distance(call.a, pose, nullptr, pose, nullptr, out), ABUT_NULL_ARGUMENT, {"b", "null"}));
  EXPECT_TRUE(
      refused(abut_pair_distance(call.a, pose, call.b, pose, nullptr, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairDistance, RefusesNonFiniteAndOtherBadPoses) {
  PairCall call;
  expect_pose_checked("pose_a", [&](const abut_pose* pose) {
    return abut_pair_distance(call.a, pose, call.b, &identity, nullptr, call.distance.address());
  });
  expect_pose_checked("pose_b", [&](const abut_pose* pose) {
    return abut_pair_distance(call.a, &identity, call.b, pose, nullptr, call.distance.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairDistance, RefusesNonFiniteOptions) { refuse_non_finite_options(&PairCall::ask_distance); }
TEST(PairDistance, RefusesBadOptions) { refuse_bad_options(&PairCall::ask_distance); }
TEST(PairDistance, RefusesWrongStructSize) { refuse_wrong_struct_size(&PairCall::ask_distance); }
TEST(PairDistance, RefusesPlanesAgainstPlanes) { refuse_planes_against_planes(&PairCall::ask_distance); }
TEST(PairDistance, RefusesMissingAlgorithms) { refuse_algorithms_that_the_pair_lacks(&PairCall::ask_distance); }

TEST(PairContacts, RefusesNullPointers) {
  PairCall call;
  abut_contact* const out = call.contacts.data();
  std::size_t* const count = call.count.address();
  const abut_pose* const pose = &identity;
  EXPECT_TRUE(refused(abut_pair_contacts(nullptr, pose, call.b, pose, nullptr, out, 8, count), ABUT_NULL_ARGUMENT,
                      {"a", "null"}));
  EXPECT_TRUE(refused(abut_pair_contacts(call.a, pose, nullptr, pose, nullptr, out, 8, count), ABUT_NULL_ARGUMENT,
                      {"b", "null"}));
  EXPECT_TRUE(refused(abut_pair_contacts(call.a, pose, call.b, pose, nullptr, nullptr, 8, count), ABUT_NULL_ARGUMENT,
                      {"contacts", "null"}));
  EXPECT_TRUE(refused(abut_pair_contacts(call.a, pose, call.b, pose, nullptr, out, 8, nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairContacts, RefusesNonFiniteAndOtherBadPoses) {
  PairCall call;
  expect_pose_checked("pose_a", [&](const abut_pose* pose) {
    return abut_pair_contacts(call.a, pose, call.b, &identity, nullptr, call.contacts.data(), 8, call.count.address());
  });
  expect_pose_checked("pose_b", [&](const abut_pose* pose) {
    return abut_pair_contacts(call.a, &identity, call.b, pose, nullptr, call.contacts.data(), 8, call.count.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairContacts, RefusesNonFiniteOptions) { refuse_non_finite_options(&PairCall::ask_contacts); }
TEST(PairContacts, RefusesBadOptions) { refuse_bad_options(&PairCall::ask_contacts); }
TEST(PairContacts, RefusesWrongStructSize) { refuse_wrong_struct_size(&PairCall::ask_contacts); }
TEST(PairContacts, RefusesPlanesAgainstPlanes) { refuse_planes_against_planes(&PairCall::ask_contacts); }
TEST(PairContacts, RefusesMissingAlgorithms) { refuse_algorithms_that_the_pair_lacks(&PairCall::ask_contacts); }

TEST(PairsDistance, RefusesNullPointers) {
  PairCall call;
  abut_distance* const out = call.distance.address();
  const abut_pose* const pose = &identity;
  EXPECT_TRUE(
      refused(abut_pairs_distance(nullptr, pose, call.b, pose, 1, nullptr, out), ABUT_NULL_ARGUMENT, {"a", "null"}));
  EXPECT_TRUE(refused(abut_pairs_distance(call.a, nullptr, call.b, pose, 1, nullptr, out), ABUT_NULL_ARGUMENT,
                      {"poses_a", "null"}));
  EXPECT_TRUE(
      refused(abut_pairs_distance(call.a, pose, nullptr, pose, 1, nullptr, out), ABUT_NULL_ARGUMENT, {"b", "null"}));
  EXPECT_TRUE(refused(abut_pairs_distance(call.a, pose, call.b, nullptr, 1, nullptr, out), ABUT_NULL_ARGUMENT,
                      {"poses_b", "null"}));
  EXPECT_TRUE(refused(abut_pairs_distance(call.a, pose, call.b, pose, 1, nullptr, nullptr), ABUT_NULL_ARGUMENT,
                      {"out", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairsDistance, RefusesOverflowingCounts) {
  PairCall call;
  expect_overflow_refused(sizeof(abut_pose), "count", [&](std::size_t count) {
    return abut_pairs_distance(call.a, &identity, call.b, &identity, count, nullptr, call.distance.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairsDistance, RefusesNonFiniteAndOtherBadPosesAndWritesNothing) {
  PairCall call;
  OutArray<abut_distance> out(3);
  const std::array<abut_pose, 3> good{at(0, 0, 0), at(1, 0, 0), at(2, 0, 0)};
  for (const BadPose& bad : bad_poses()) {
    auto poses = good;
    poses[2] = bad.pose;
    EXPECT_TRUE(refused(abut_pairs_distance(call.a, poses.data(), call.b, good.data(), 3, nullptr, out.data()),
                        bad.status, {"poses_a", "2", bad.word}));
    EXPECT_TRUE(refused(abut_pairs_distance(call.a, good.data(), call.b, poses.data(), 3, nullptr, out.data()),
                        bad.status, {"poses_b", "2", bad.word}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(PairsDistance, AcceptsNoPairs) {
  PairCall call;
  EXPECT_TRUE(succeeded(abut_pairs_distance(call.a, nullptr, call.b, nullptr, 0, nullptr, nullptr)));
}

TEST(PairsDistance, RefusesNonFiniteOptions) { refuse_non_finite_options(&PairCall::ask_distances); }
TEST(PairsDistance, RefusesBadOptions) { refuse_bad_options(&PairCall::ask_distances); }
TEST(PairsDistance, RefusesWrongStructSize) { refuse_wrong_struct_size(&PairCall::ask_distances); }
TEST(PairsDistance, RefusesPlanesAgainstPlanes) { refuse_planes_against_planes(&PairCall::ask_distances); }
TEST(PairsDistance, RefusesMissingAlgorithms) { refuse_algorithms_that_the_pair_lacks(&PairCall::ask_distances); }

}  // namespace
