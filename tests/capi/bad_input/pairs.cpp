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
  EXPECT_EQ(options.value().time_budget, 0.0);
  EXPECT_EQ(options.value().margin, 0.0);
  EXPECT_EQ(options.value().max_contacts, 4U);
  EXPECT_EQ(options.value().max_pair_contacts, 0U);
  EXPECT_EQ(options.value().threads, 0U);
}

TEST(PairDistance, RefusesBadOptions) { refuse_bad_options(&PairCall::ask_distance); }
TEST(PairDistance, RefusesPlanesAgainstPlanes) { refuse_planes_against_planes(&PairCall::ask_distance); }
TEST(PairDistance, RefusesMissingAlgorithms) { refuse_algorithms_that_the_pair_lacks(&PairCall::ask_distance); }

TEST(PairContacts, RefusesBadOptions) { refuse_bad_options(&PairCall::ask_contacts); }
TEST(PairContacts, RefusesPlanesAgainstPlanes) { refuse_planes_against_planes(&PairCall::ask_contacts); }
TEST(PairContacts, RefusesMissingAlgorithms) { refuse_algorithms_that_the_pair_lacks(&PairCall::ask_contacts); }

TEST(PairsDistance, AcceptsNoPairs) {
  PairCall call;
  EXPECT_TRUE(succeeded(abut_pairs_distance(call.a, nullptr, call.b, nullptr, 0, nullptr, nullptr)));
}

TEST(PairsDistance, RefusesBadOptions) { refuse_bad_options(&PairCall::ask_distances); }
TEST(PairsDistance, RefusesPlanesAgainstPlanes) { refuse_planes_against_planes(&PairCall::ask_distances); }
TEST(PairsDistance, RefusesMissingAlgorithms) { refuse_algorithms_that_the_pair_lacks(&PairCall::ask_distances); }

}  // namespace
