// SPDX-License-Identifier: Apache-2.0
// Batches of pairs answer with the bits of single questions, for any number of threads and any room.
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <span>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr std::size_t pair_count = 200;
constexpr std::uint64_t seed = 20261124;

template <class Value>
bool have_same_bits(const Value& a, const Value& b) {
  using Bytes = std::array<unsigned char, sizeof(Value)>;
  return std::bit_cast<Bytes>(a) == std::bit_cast<Bytes>(b);
}

template <class Value>
bool have_same_bits(std::span<const Value> a, std::span<const Value> b) {
  return std::ranges::equal(a, b, [](const Value& one, const Value& other) { return have_same_bits(one, other); });
}

std::vector<Shape> all_kinds() {
  std::vector<Shape> shapes = make_one_of_each_kind();
  shapes.push_back(make_of_kind("cylinder", {0.5, 0.75}));
  shapes.push_back(make_of_kind("cone", {0.5, 0.75}));
  shapes.push_back(make_of_kind("ellipsoid", {1, 0.75, 0.5}));
  shapes.push_back(make_of_kind("triangle", {0, 0, 0, 1, 0, 0, 0, 1, 0.5}));
  shapes.push_back(make_of_kind("particles", {0.25}, {0, 0, 0, 1, 0, 0, 0, 1, 0.5}));
  shapes.push_back(make_composite({shapes.at(0), shapes.at(1)}, {at(1, 0, 0), at(-1, 0, 0)}));
  return shapes;
}

// Poses about the origin, at which most pairs of shapes meet and some do not.
struct Poses {
  std::vector<abut_pose> a, b;
  std::vector<abut_vec3> ways_a, ways_b;
};

Poses random_poses() {
  std::mt19937_64 engine(seed);
  const auto uniform = [&](double reach) { return std::uniform_real_distribution<double>(-reach, reach)(engine); };
  const auto vector = [&](double reach) { return abut_vec3{uniform(reach), uniform(reach), uniform(reach)}; };
  const auto pose = [&](double reach) {
    std::array<double, 4> turn{uniform(1), uniform(1), uniform(1), 1.5 + uniform(1)};
    const double size = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
    return abut_pose{vector(reach), {turn[3] / size, turn[0] / size, turn[1] / size, turn[2] / size}};
  };
  Poses poses;
  for (std::size_t i = 0; i < pair_count; ++i) {
    poses.a.push_back(pose(0.5));
    poses.b.push_back(pose(2));
    poses.ways_a.push_back(vector(3));
    poses.ways_b.push_back(vector(1));
  }
  return poses;
}

abut_query_options options_of(std::uint32_t threads) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.threads = threads_of_build(threads);
  return options;
}

// Contacts of many pairs, pair after pair.
struct Lists {
  std::vector<std::uint64_t> offsets;
  std::vector<abut_contact> contacts;
};

bool are_supported(const Shape& a, const Shape& b) {
  std::uint32_t answer = 0;
  EXPECT_TRUE(succeeded(abut_pair_support(abut_shape_kind_of(a), abut_shape_kind_of(b), ABUT_QUERY_CONTACTS, &answer)));
  return answer == 1;
}

Lists contacts_one_by_one(const Shape& a, const Shape& b, const Poses& poses) {
  Lists lists{{0}, {}};
  for (std::size_t i = 0; i < pair_count; ++i) {
    std::vector<abut_contact> found(512);
    std::size_t count = 0;
    EXPECT_TRUE(
        succeeded(abut_pair_contacts(a, &poses.a[i], b, &poses.b[i], nullptr, found.data(), found.size(), &count)));
    EXPECT_LE(count, found.size());
    lists.contacts.insert(lists.contacts.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
    lists.offsets.push_back(lists.contacts.size());
  }
  return lists;
}

Lists contacts_of_batch(const Shape& a, const Shape& b, const Poses& poses, std::uint32_t threads,
                        std::span<abut_pair_memory> memories = {}) {
  const abut_query_options options = options_of(threads);
  const auto ask = [&](std::uint64_t* offsets, abut_contact* contacts, std::size_t capacity, std::size_t* count) {
    return memories.empty()
               ? abut_pairs_contacts(a, poses.a.data(), b, poses.b.data(), pair_count, &options, offsets, contacts,
                                     capacity, count)
               : abut_pairs_contacts_with_memories(a, poses.a.data(), b, poses.b.data(), pair_count, &options,
                                                   memories.data(), offsets, contacts, capacity, count);
  };
  Lists lists{std::vector<std::uint64_t>(pair_count + 1), {}};
  std::size_t count = 0;
  EXPECT_TRUE(succeeded(ask(lists.offsets.data(), nullptr, 0, &count)));
  EXPECT_EQ(lists.offsets.back(), count);
  lists.contacts.resize(count);
  EXPECT_TRUE(succeeded(ask(lists.offsets.data(), lists.contacts.data(), count, &count)));
  EXPECT_EQ(lists.contacts.size(), count);
  return lists;
}

TEST(PairBatches, HaveTheContactsOfEachPair) {
  const Poses poses = random_poses();
  const std::vector<Shape> shapes = all_kinds();
  std::size_t all_contacts = 0, all_pairs = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      if (!are_supported(a, b)) continue;
      const Lists expected = contacts_one_by_one(a, b, poses);
      for (const std::uint32_t threads : {1U, 3U, 0U}) {
        const Lists found = contacts_of_batch(a, b, poses, threads);
        EXPECT_EQ(found.offsets, expected.offsets) << "seed " << seed;
        EXPECT_TRUE(have_same_bits<abut_contact>(found.contacts, expected.contacts)) << "seed " << seed;
      }
      all_contacts += expected.contacts.size();
      ++all_pairs;
    }
  }
  EXPECT_GT(all_pairs, 160U);
  EXPECT_GT(all_contacts, 100 * all_pairs);
}

TEST(PairBatches, HaveTheSameContactsWithMemories) {
  const Poses poses = random_poses();
  const Shape hull = make_octahedron(1.0);
  const Shape box = make_box(0.5, 1.0, 0.75);
  const Lists expected = contacts_one_by_one(hull, box, poses);
  for (const std::uint32_t threads : {1U, 3U}) {
    std::vector<abut_pair_memory> memories(pair_count), of_singles(pair_count);
    const Lists found = contacts_of_batch(hull, box, poses, threads, memories);
    EXPECT_EQ(found.offsets, expected.offsets) << "seed " << seed;
    EXPECT_TRUE(have_same_bits<abut_contact>(found.contacts, expected.contacts)) << "seed " << seed;
    for (std::size_t i = 0; i < pair_count; ++i) {
      for (int query = 0; query < 2; ++query) {
        std::size_t count = 0;
        EXPECT_TRUE(succeeded(abut_pair_contacts_with_memory(hull, &poses.a[i], box, &poses.b[i], nullptr,
                                                             &of_singles[i], nullptr, 0, &count)));
      }
    }
    EXPECT_TRUE(have_same_bits<abut_pair_memory>(memories, of_singles)) << "seed " << seed;
    EXPECT_FALSE(have_same_bits<abut_pair_memory>(memories, std::vector<abut_pair_memory>(pair_count)));
  }
}

TEST(PairBatches, HaveTheDistanceOfEachPair) {
  const Poses poses = random_poses();
  const Shape hull = make_octahedron(1.0);
  const Shape cylinder = make_of_kind("cylinder", {0.5, 0.75});
  std::vector<abut_distance> expected(pair_count), found(pair_count);
  for (std::size_t i = 0; i < pair_count; ++i) {
    EXPECT_TRUE(succeeded(abut_pair_distance(hull, &poses.a[i], cylinder, &poses.b[i], nullptr, &expected[i])));
  }
  for (const std::uint32_t threads : {1U, 3U, 0U}) {
    const abut_query_options options = options_of(threads);
    EXPECT_TRUE(succeeded(
        abut_pairs_distance(hull, poses.a.data(), cylinder, poses.b.data(), pair_count, &options, found.data())));
    EXPECT_TRUE(have_same_bits<abut_distance>(found, expected)) << "seed " << seed;
  }
}

TEST(PairBatches, WriteAsManyContactsAsFit) {
  const Poses poses = random_poses();
  const Shape box = make_box(0.5, 1.0, 0.75);
  const Lists all = contacts_of_batch(box, box, poses, 1);
  ASSERT_GT(all.contacts.size(), 100U);
  for (const std::uint32_t threads : {1U, 3U}) {
    const abut_query_options options = options_of(threads);
    for (const std::size_t room : {std::size_t{0}, std::size_t{1}, std::size_t{99}, all.contacts.size() - 1}) {
      OutArray<abut_contact> some(all.contacts.size());
      std::vector<std::uint64_t> offsets(pair_count + 1);
      std::size_t count = 0;
      ASSERT_TRUE(succeeded(abut_pairs_contacts(box, poses.a.data(), box, poses.b.data(), pair_count, &options,
                                                offsets.data(), some.data(), room, &count)));
      EXPECT_EQ(count, all.contacts.size());
      EXPECT_EQ(offsets, all.offsets);
      EXPECT_TRUE(some.is_untouched_from(room));
      for (std::size_t i = 0; i < room; ++i) EXPECT_TRUE(have_same_bits(some[i], all.contacts[i])) << i;
    }
  }
}

TEST(PairBatches, CastEachPair) {
  const Poses poses = random_poses();
  const std::vector<Shape> shapes = all_kinds();
  std::size_t touches = 0, misses = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      std::vector<abut_cast_hit> expected(pair_count), found(pair_count);
      std::vector<std::uint32_t> are_found(pair_count);
      abut_status status = ABUT_OK;
      for (std::size_t i = 0; status == ABUT_OK && i < pair_count; ++i) {
        status = abut_pair_cast(a, &poses.a[i], &poses.ways_a[i], b, &poses.b[i], &poses.ways_b[i], nullptr,
                                &expected[i], &are_found[i]);
        if (are_found[i] == 0) expected[i].fraction = HUGE_VAL;
        (are_found[i] == 0 ? misses : touches) += 1;
      }
      for (const std::uint32_t threads : {1U, 3U}) {
        const abut_query_options options = options_of(threads);
        EXPECT_EQ(abut_pairs_cast(a, poses.a.data(), poses.ways_a.data(), b, poses.b.data(), poses.ways_b.data(),
                                  pair_count, &options, found.data()),
                  status);
        EXPECT_TRUE(status != ABUT_OK || have_same_bits<abut_cast_hit>(found, expected)) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(touches, 10000U);
  EXPECT_GT(misses, 1000U);
}

// Of several pairs that have no answer the first one is named, whichever thread came upon one first.
TEST(PairBatches, NameTheFirstPairThatFails) {
  if (abut_has_feature("libccd") == 0) GTEST_SKIP() << "this build is without libccd";
  const Shape ball = make_sphere(1.0);
  std::vector<abut_pose> a(pair_count, identity), b(pair_count, at(1, 0, 0));
  b[150] = b[90] = b.back() = at(9, 0, 0);
  for (const std::uint32_t threads : {1U, 3U}) {
    abut_query_options options = options_of(threads);
    options.algorithm = ABUT_ALGORITHM_LIBCCD_MPR;
    OutArray<abut_distance> distances(pair_count);
    EXPECT_TRUE(refused(abut_pairs_distance(ball, a.data(), ball, b.data(), pair_count, &options, distances.data()),
                        ABUT_UNSUPPORTED, {"pair 90:", "apart"}));
    EXPECT_TRUE(distances.is_untouched());
  }
}

}  // namespace
