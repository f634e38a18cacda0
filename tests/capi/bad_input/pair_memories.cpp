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

TEST(PairDistanceWithMemory, RefusesNonFiniteAndOtherBadPoses) {
  Call call;
  expect_pose_checked("pose_a", [&](const abut_pose* pose) {
    return abut_pair_distance_with_memory(call.a, pose, call.b, &identity, nullptr, call.memory.address(),
                                          call.distance.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairDistanceWithMemory, RefusesWrongStructSize) {
  Call call;
  expect_struct_size_checked(default_options(), [&](const abut_query_options* wrong) {
    return abut_pair_distance_with_memory(call.a, &identity, call.b, &identity, wrong, call.memory.address(),
                                          call.distance.address());
  });
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

TEST(PairsDistanceWithMemories, RefusesNullPointers) {
  Call call;
  abut_pair_memory* const memory = call.memory.address();
  abut_distance* const out = call.distance.address();
  const abut_pose* const pose = &identity;
  const auto ask = [&](const abut_shape* a, const abut_pose* poses_a, const abut_shape* b, const abut_pose* poses_b,
                       abut_pair_memory* memories, abut_distance* to) {
    return abut_pairs_distance_with_memories(a, poses_a, b, poses_b, 1, nullptr, memories, to);
  };
  EXPECT_TRUE(refused(ask(nullptr, pose, call.b, pose, memory, out), ABUT_NULL_ARGUMENT, {"a", "null"}));
  EXPECT_TRUE(refused(ask(call.a, nullptr, call.b, pose, memory, out), ABUT_NULL_ARGUMENT, {"poses_a", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, nullptr, pose, memory, out), ABUT_NULL_ARGUMENT, {"b", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, call.b, nullptr, memory, out), ABUT_NULL_ARGUMENT, {"poses_b", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, call.b, pose, nullptr, out), ABUT_NULL_ARGUMENT, {"memories", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, call.b, pose, memory, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairsDistanceWithMemories, RefusesNonFiniteAndOtherBadPosesAndWritesNothing) {
  Call call;
  OutArray<abut_distance> out(2);
  OutArray<abut_pair_memory> memories(2);
  const std::array<abut_pose, 2> good{at(0, 0, 0), at(4, 0, 0)};
  for (const BadPose& bad : bad_poses()) {
    auto poses = good;
    poses[1] = bad.pose;
    EXPECT_TRUE(refused(abut_pairs_distance_with_memories(call.a, good.data(), call.b, poses.data(), 2, nullptr,
                                                          memories.data(), out.data()),
                        bad.status, {"poses_b", "1", bad.word}));
  }
  EXPECT_TRUE(out.is_untouched() && memories.is_untouched());
}

TEST(PairsDistanceWithMemories, RefusesOverflowingCounts) {
  Call call;
  expect_overflow_refused(sizeof(abut_pose), "count", [&](std::size_t count) {
    return abut_pairs_distance_with_memories(call.a, &identity, call.b, &identity, count, nullptr,
                                             call.memory.address(), call.distance.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairsDistanceWithMemories, RefusesWrongStructSize) {
  Call call;
  expect_struct_size_checked(default_options(), [&](const abut_query_options* wrong) {
    return abut_pairs_distance_with_memories(call.a, &identity, call.b, &identity, 1, wrong, call.memory.address(),
                                             call.distance.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairContactsWithMemory, RefusesNullPointers) {
  Call call;
  abut_pair_memory* const memory = call.memory.address();
  abut_contact* const out = call.contacts.data();
  std::size_t* const count = call.count.address();
  const abut_pose* const pose = &identity;
  const auto ask = [&](const abut_shape* a, const abut_pose* pose_a, abut_pair_memory* of_pair, abut_contact* to,
                       std::size_t* many) {
    return abut_pair_contacts_with_memory(a, pose_a, call.b, pose, nullptr, of_pair, to, 8, many);
  };
  EXPECT_TRUE(refused(ask(nullptr, pose, memory, out, count), ABUT_NULL_ARGUMENT, {"a", "null"}));
  EXPECT_TRUE(refused(ask(call.a, nullptr, memory, out, count), ABUT_NULL_ARGUMENT, {"pose_a", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, nullptr, out, count), ABUT_NULL_ARGUMENT, {"memory", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, memory, nullptr, count), ABUT_NULL_ARGUMENT, {"contacts", "null"}));
  EXPECT_TRUE(refused(ask(call.a, pose, memory, out, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairContactsWithMemory, RefusesNonFiniteAndOtherBadPoses) {
  Call call;
  expect_pose_checked("pose_b", [&](const abut_pose* pose) {
    return abut_pair_contacts_with_memory(call.a, &identity, call.b, pose, nullptr, call.memory.address(),
                                          call.contacts.data(), 8, call.count.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(PairContactsWithMemory, RefusesWrongStructSize) {
  Call call;
  expect_struct_size_checked(default_options(), [&](const abut_query_options* wrong) {
    return abut_pair_contacts_with_memory(call.a, &identity, call.b, &identity, wrong, call.memory.address(),
                                          call.contacts.data(), 8, call.count.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

}  // namespace
