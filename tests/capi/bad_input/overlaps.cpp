// SPDX-License-Identifier: Apache-2.0
// Whether shapes overlap, asked with bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

struct Call {
  Shape a = make_octahedron(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  Out<std::uint32_t> out;

  abut_status ask(const abut_query_options* options) {
    return abut_pair_overlaps(a, &identity, b, &identity, options, out.address());
  }
};

struct Batch {
  Shape a = make_octahedron(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  std::array<const abut_shape*, 2> shapes_a{a, a}, shapes_b{b, b};
  std::array<abut_pose, 2> poses{at(0, 0, 0), at(0.5, 0, 0)};
  OutArray<std::uint32_t> out{2};

  abut_status ask(const abut_query_options* options) {
    return abut_pairs_overlap(shapes_a.data(), poses.data(), shapes_b.data(), poses.data(), 2, options, out.data());
  }
};

TEST(PairOverlaps, RefusesNullPointers) {
  Call call;
  std::uint32_t* const out = call.out.address();
  const abut_pose* const pose = &identity;
  EXPECT_TRUE(
      refused(abut_pair_overlaps(nullptr, pose, call.b, pose, nullptr, out), ABUT_NULL_ARGUMENT, {"a", "null"}));
  EXPECT_TRUE(
      refused(abut_pair_overlaps(call.a, pose, nullptr, pose, nullptr, out), ABUT_NULL_ARGUMENT, {"b", "null"}));
  EXPECT_TRUE(
      refused(abut_pair_overlaps(call.a, pose, call.b, pose, nullptr, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(call.out.is_untouched());
}

TEST(PairOverlaps, RefusesBadOptions) {
  Call call;
  Batch batch;
  expect_non_finite_refused("margin", [&](double margin) {
    abut_query_options options = default_options();
    options.margin = margin;
    EXPECT_TRUE(refused(batch.ask(&options), ABUT_NOT_FINITE, {"margin"}));
    return call.ask(&options);
  });
  for (const abut_algorithm algorithm : {ABUT_ALGORITHM_ANALYTIC, ABUT_ALGORITHM_GJK_EPA, ABUT_ALGORITHM_LIBCCD_MPR}) {
    abut_query_options options = default_options();
    options.algorithm = algorithm;
    EXPECT_TRUE(refused(call.ask(&options), ABUT_UNSUPPORTED, {"algorithm", std::to_string(algorithm)}));
    EXPECT_TRUE(refused(batch.ask(&options), ABUT_UNSUPPORTED, {"algorithm", std::to_string(algorithm)}));
  }
  EXPECT_TRUE(batch.out.is_untouched());
}

TEST(PairOverlaps, RefusesPairsWithoutAnAlgorithm) {
  const Shape plane = make_plane({0, 0, 1}, 0);
  Out<std::uint32_t> out;
  for (const double height : {0.0, 100.0}) {
    const abut_pose there = at(0, 0, height);
    EXPECT_TRUE(refused(abut_pair_overlaps(plane, &identity, plane, &there, nullptr, out.address()), ABUT_UNSUPPORTED,
                        {"plane"}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(PairsOverlap, NamesThePairThatHasNoAlgorithmAndWritesNothing) {
  Batch batch;
  const Shape plane = make_plane({0, 0, 1}, 0);
  batch.shapes_a[1] = batch.shapes_b[1] = plane;
  EXPECT_TRUE(refused(batch.ask(nullptr), ABUT_UNSUPPORTED, {"pair 1", "plane"}));
  EXPECT_TRUE(batch.out.is_untouched());
}

TEST(PairsOverlap, AcceptsNoPairs) {
  EXPECT_TRUE(succeeded(abut_pairs_overlap(nullptr, nullptr, nullptr, nullptr, 0, nullptr, nullptr)));
}

}  // namespace
