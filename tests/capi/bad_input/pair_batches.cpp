// SPDX-License-Identifier: Apache-2.0
// Batches of contacts and of casts of two shapes under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// What both functions of contacts take.
struct Call {
  const abut_shape* a;
  const abut_pose* poses_a;
  const abut_shape* b;
  const abut_pose* poses_b;
  std::size_t pair_count;
  const abut_query_options* options;
  abut_pair_memory* memories;
  std::uint64_t* offsets;
  abut_contact* contacts;
  std::size_t capacity;
  std::size_t* count;
};
using Ask = abut_status (*)(const Call&);

abut_status ask_cold(const Call& call) {
  return abut_pairs_contacts(call.a, call.poses_a, call.b, call.poses_b, call.pair_count, call.options, call.offsets,
                             call.contacts, call.capacity, call.count);
}
abut_status ask_warm(const Call& call) {
  return abut_pairs_contacts_with_memories(call.a, call.poses_a, call.b, call.poses_b, call.pair_count, call.options,
                                           call.memories, call.offsets, call.contacts, call.capacity, call.count);
}

struct Room {
  Shape a = make_octahedron(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  std::array<abut_pose, 2> poses{at(0, 0, 0), at(0.5, 0, 0)};
  OutArray<abut_pair_memory> memories{2};
  OutArray<std::uint64_t> offsets{3};
  OutArray<abut_contact> contacts{16};
  Out<std::size_t> count;

  Call call() {
    return {a,
            poses.data(),
            b,
            poses.data(),
            poses.size(),
            nullptr,
            memories.data(),
            offsets.data(),
            contacts.data(),
            contacts.size(),
            count.address()};
  }
  bool is_untouched() const {
    return memories.is_untouched() && offsets.is_untouched() && contacts.is_untouched() && count.is_untouched();
  }
};

void refuse_null(Ask ask) {
  Room room;
  const auto refuses = [&](auto Call::* argument, std::string_view name) {
    Call call = room.call();
    call.*argument = nullptr;
    EXPECT_TRUE(refused(ask(call), ABUT_NULL_ARGUMENT, {name, "null"}));
  };
  refuses(&Call::a, "a");
  refuses(&Call::poses_a, "poses_a");
  refuses(&Call::b, "b");
  refuses(&Call::poses_b, "poses_b");
  refuses(&Call::offsets, "offsets");
  refuses(&Call::contacts, "contacts");
  refuses(&Call::count, "count");
  EXPECT_TRUE(room.is_untouched());
}

void refuse_bad_poses(Ask ask) {
  Room room;
  for (const BadPose& bad : bad_poses()) {
    auto poses = room.poses;
    poses[1] = bad.pose;
    Call call = room.call();
    call.poses_a = poses.data();
    EXPECT_TRUE(refused(ask(call), bad.status, {"poses_a[1]", bad.word}));
    call = room.call();
    call.poses_b = poses.data();
    EXPECT_TRUE(refused(ask(call), bad.status, {"poses_b[1]", bad.word}));
  }
  EXPECT_TRUE(room.is_untouched());
}

void refuse_bad_options(Ask ask) {
  Room room;
  Call call = room.call();
  abut_query_options options = default_options();
  call.options = &options;
  options.algorithm = 77;
  EXPECT_TRUE(refused(ask(call), ABUT_UNKNOWN_VALUE, {"options.algorithm", "77"}));
  options = default_options();
  options.threads = 1025;
  EXPECT_TRUE(refused(ask(call), ABUT_OUT_OF_RANGE, {"options.threads", "1025", "1024"}));
  options = default_options();
  options.flags = 6;
  EXPECT_TRUE(refused(ask(call), ABUT_UNKNOWN_VALUE, {"options.flags", "6"}));
  if (abut_has_feature("threads") == 0) {
    options = default_options();
    options.threads = 2;
    EXPECT_TRUE(refused(ask(call), ABUT_UNSUPPORTED, {"options.threads", "2"}));
  }
  options = default_options();
  expect_non_finite_refused("margin", [&](double bad) {
    options.margin = bad;
    return ask(call);
  });
  EXPECT_TRUE(room.is_untouched());
}

void refuse_wrong_struct_size(Ask ask) {
  Room room;
  Call call = room.call();
  const auto with = [&](const abut_query_options* options) {
    call.options = options;
    return ask(call);
  };
  expect_struct_size_checked(default_options(), with);
  EXPECT_TRUE(room.is_untouched());
  expect_zero_tail_accepted(default_options(), with);
}

void refuse_overflowing_counts(Ask ask) {
  Room room;
  expect_overflow_refused(sizeof(abut_pose), "pair_count", [&](std::size_t count) {
    Call call = room.call();
    call.pair_count = count;
    return ask(call);
  });
  expect_overflow_refused(sizeof(abut_contact), "capacity", [&](std::size_t count) {
    Call call = room.call();
    call.capacity = count;
    return ask(call);
  });
  EXPECT_TRUE(room.is_untouched());
}

void refuse_plane_against_plane(Ask ask) {
  Room room;
  room.a = make_plane({0.0, 0.0, 1.0}, 0.0);
  room.b = make_plane({1.0, 0.0, 0.0}, 0.0);
  EXPECT_TRUE(refused(ask(room.call()), ABUT_UNSUPPORTED, {"pair 0", "plane and plane"}));
  EXPECT_TRUE(room.is_untouched());
}

void accept_no_pairs(Ask ask) {
  Room room;
  Call call = room.call();
  call.poses_a = call.poses_b = nullptr;
  call.memories = nullptr;
  call.contacts = nullptr;
  call.pair_count = call.capacity = 0;
  EXPECT_TRUE(succeeded(ask(call)));
  EXPECT_EQ(room.offsets[0], 0U);
  EXPECT_TRUE(room.offsets.is_untouched_from(1));
  EXPECT_EQ(room.count.value(), 0U);
}

TEST(PairsContacts, RefusesNull) { refuse_null(ask_cold); }
TEST(PairsContacts, RefusesNonFiniteAndOtherBadPoses) { refuse_bad_poses(ask_cold); }
TEST(PairsContacts, RefusesBadOptions) { refuse_bad_options(ask_cold); }
TEST(PairsContacts, RefusesWrongStructSize) { refuse_wrong_struct_size(ask_cold); }
TEST(PairsContacts, RefusesOverflowingCounts) { refuse_overflowing_counts(ask_cold); }
TEST(PairsContacts, RefusesPlaneAgainstPlane) { refuse_plane_against_plane(ask_cold); }
TEST(PairsContacts, AcceptsNoPairs) { accept_no_pairs(ask_cold); }

TEST(PairsContactsWithMemories, RefusesNull) {
  refuse_null(ask_warm);
  Room room;
  Call call = room.call();
  call.memories = nullptr;
  EXPECT_TRUE(refused(ask_warm(call), ABUT_NULL_ARGUMENT, {"memories", "null"}));
  EXPECT_TRUE(room.is_untouched());
}
TEST(PairsContactsWithMemories, RefusesNonFiniteAndOtherBadPoses) { refuse_bad_poses(ask_warm); }
TEST(PairsContactsWithMemories, RefusesBadOptions) { refuse_bad_options(ask_warm); }
TEST(PairsContactsWithMemories, RefusesWrongStructSize) { refuse_wrong_struct_size(ask_warm); }
TEST(PairsContactsWithMemories, RefusesOverflowingCounts) { refuse_overflowing_counts(ask_warm); }
TEST(PairsContactsWithMemories, RefusesPlaneAgainstPlane) { refuse_plane_against_plane(ask_warm); }
TEST(PairsContactsWithMemories, AcceptsNoPairs) { accept_no_pairs(ask_warm); }

// Two shapes, each with two poses and two displacements.
struct CastCall {
  Shape a = make_sphere(1.0);
  Shape b = make_box(1.0, 1.0, 1.0);
  std::array<abut_pose, 2> poses_a{at(0, 0, 0), at(1, 0, 0)}, poses_b{at(5, 0, 0), at(6, 0, 0)};
  std::array<abut_vec3, 2> ways_a{{{1, 0, 0}, {0, 1, 0}}}, ways_b{{{-9, 0, 0}, {0, 0, 0}}};
  OutArray<abut_cast_hit> hits{2};

  abut_status ask(const abut_query_options* options, std::size_t count = 2) {
    return abut_pairs_cast(a, poses_a.data(), ways_a.data(), b, poses_b.data(), ways_b.data(), count, options,
                           hits.data());
  }
};

TEST(PairsCast, RefusesNull) {
  CastCall call;
  const auto refuses = [](abut_status status, std::string_view name) {
    EXPECT_TRUE(refused(status, ABUT_NULL_ARGUMENT, {name, "null"}));
  };
  const abut_pose* poses = call.poses_a.data();
  const abut_vec3* ways = call.ways_a.data();
  abut_cast_hit* hits = call.hits.data();
  refuses(abut_pairs_cast(nullptr, poses, ways, call.b, poses, ways, 2, nullptr, hits), "a");
  refuses(abut_pairs_cast(call.a, nullptr, ways, call.b, poses, ways, 2, nullptr, hits), "poses_a");
  refuses(abut_pairs_cast(call.a, poses, nullptr, call.b, poses, ways, 2, nullptr, hits), "displacements_a");
  refuses(abut_pairs_cast(call.a, poses, ways, nullptr, poses, ways, 2, nullptr, hits), "b");
  refuses(abut_pairs_cast(call.a, poses, ways, call.b, nullptr, ways, 2, nullptr, hits), "poses_b");
  refuses(abut_pairs_cast(call.a, poses, ways, call.b, poses, nullptr, 2, nullptr, hits), "displacements_b");
  refuses(abut_pairs_cast(call.a, poses, ways, call.b, poses, ways, 2, nullptr, nullptr), "hits");
  EXPECT_TRUE(call.hits.is_untouched());
}

TEST(PairsCast, RefusesBadOptions) {
  CastCall call;
  abut_query_options options = default_options();
  options.margin = -0.5;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"margin", "-0.5"}));
  options = default_options();
  options.threads = 4096;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_OUT_OF_RANGE, {"options.threads", "4096"}));
  options = default_options();
  options.algorithm = ABUT_ALGORITHM_SAT;
  EXPECT_TRUE(refused(call.ask(&options), ABUT_UNSUPPORTED, {"algorithm"}));
  EXPECT_TRUE(call.hits.is_untouched());
}

TEST(PairsCast, RefusesPlaneAgainstPlane) {
  CastCall call;
  call.a = make_plane({0.0, 0.0, 1.0}, 0.0);
  call.b = make_plane({1.0, 0.0, 0.0}, 0.0);
  EXPECT_TRUE(refused(call.ask(nullptr), ABUT_UNSUPPORTED, {"pair 0", "plane and plane"}));
  EXPECT_TRUE(call.hits.is_untouched());
}

TEST(PairsCast, AcceptsNoPairs) {
  CastCall call;
  EXPECT_TRUE(succeeded(abut_pairs_cast(call.a, nullptr, nullptr, call.b, nullptr, nullptr, 0, nullptr, nullptr)));
}

}  // namespace
