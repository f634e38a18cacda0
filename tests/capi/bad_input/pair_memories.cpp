// SPDX-License-Identifier: Apache-2.0
// Queries of a pair with a memory under bad input: a call that fails leaves the memory as it is.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

struct Call {
  Shape a = make_octahedron(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  Out<abut_pair_memory> memory;
  Out<abut_distance> distance;
  OutArray<abut_contact> contacts{8};
  Out<std::size_t> count;

  bool is_untouched() const {
    return memory.is_untouched() && distance.is_untouched() && contacts.is_untouched() && count.is_untouched();
  }
};

TEST(PairDistanceWithMemory, RefusesNullPointers) {
  Call call;
  abut_pair_memory* const memory = call.memory.address();
  abut_distance* const out = call.distance.address();
  const abut_pose* const pose = &identity;
  const auto ask = [&](const abut_shape* a, const abut_pose* pose_a, const abut_shape* b, const abut_pose* pose_b,
                       abut_pair_memory* of_pair, abut_distance* to) {
    return abut_pair_distance_with_memory(a, pose_a, b, pose_b, nullptr, of_pair, to);
  };
  EXPECT_TRUE(refused(ask(nullptr, pose, call.b, pose, memory, out), ABUT_NULL_ARGUMENT, {"a", "null"}));
  EXPECT_TRUE(refused(ask(call.a, nullptr, call.b, pose, memory, out), ABUT_NULL_ARGUMENT, {"pose_a", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, nullptr, pose, memory, out), ABUT_NULL_ARGUMENT, {"b", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, call.b, nullptr, memory, out), ABUT_NULL_ARGUMENT, {"pose_b", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, call.b, pose, nullptr, out), ABUT_NULL_ARGUMENT, {"memory", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, call.b, pose, memory, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairDistanceWithMemory, RefusesMissingAlgorithms) {
  Call call;
  abut_query_options options = default_options();
  options.algorithm = ABUT_ALGORITHM_ANALYTIC;
  EXPECT_TRUE(refused(abut_pair_distance_with_memory(call.a, &identity, call.b, &identity, &options,
                                                     call.memory.address(), call.distance.address()),
                      ABUT_UNSUPPORTED, {"algorithm"}));
  EXPECT_TRUE(call.is_untouched());
}

}  // namespace
