// SPDX-License-Identifier: Apache-2.0
// Memories of pairs: no bytes of one change what is true, and the right ones spare the search.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <span>

#include "support.hpp"

namespace {

using namespace abut_test;

class Random {
 public:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  std::uint64_t bits() { return engine_(); }
  abut_quat orientation() {
    std::array<double, 4> q{};
    double square = 0;
    for (double& number : q) {
      number = std::normal_distribution<double>()(engine_);
      square += number * number;
    }
    const double scale = 1 / std::sqrt(square);
    return {scale * q[0], scale * q[1], scale * q[2], scale * q[3]};
  }
  abut_pose pose(double reach) {
    return {{uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)}, orientation()};
  }
  // Either anything, or numbers as small as those of vertices and features are.
  abut_pair_memory memory() {
    abut_pair_memory made{};
    const std::uint64_t style = bits() % 3;
    for (std::uint64_t& part : made.opaque) {
      part = style == 0 ? bits() : style == 1 ? (bits() % 9) | (bits() % 9) << 32 : feature() | feature() << 32;
    }
    return made;
  }

 private:
  // As a memory keeps features of cores: a kind, a direction and a number.
  std::uint64_t feature() { return (bits() % 4) << 24 | (bits() & 1) << 16 | bits() % 12; }

  std::mt19937_64 engine_{20261123};
};

std::vector<Shape> shapes_with_corners(Random& random) {
  std::vector<double> round, flat;
  for (int i = 0; i < 24; ++i) {
    round.insert(round.end(), {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    flat.insert(flat.end(), {random.uniform(-1, 1), random.uniform(-1, 1), 0.25});
  }
  std::vector<Shape> shapes;
  shapes.push_back(make_octahedron(1.0));
  shapes.push_back(make_of_kind("hull", {}, round));
  shapes.push_back(make_of_kind("hull", {}, flat));
  shapes.push_back(make_of_kind("triangle", {0, 0, 0, 1, 0, 0, 0, 1, 0.5}));
  shapes.push_back(make_box(0.5, 1.0, 0.75));
  shapes.push_back(make_capsule(0.25, 0.75));
  shapes.push_back(make_sphere(0.5));
  shapes.push_back(make_of_kind("segment", {0.5}));
  shapes.push_back(make_of_kind("cylinder", {0.5, 0.75}));
  return shapes;
}

abut_distance distance(const Shape& a, const abut_pose& pose_a, const Shape& b, const abut_pose& pose_b) {
  Out<abut_distance> out;
  EXPECT_TRUE(succeeded(abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, out.address())));
  return out.value();
}
abut_distance distance(const Shape& a, const abut_pose& pose_a, const Shape& b, const abut_pose& pose_b,
                       abut_pair_memory& memory) {
  Out<abut_distance> out;
  EXPECT_TRUE(succeeded(abut_pair_distance_with_memory(a, &pose_a, b, &pose_b, nullptr, &memory, out.address())));
  return out.value();
}

// The bits of all numbers of the contacts.
std::vector<std::uint64_t> contacts(const Shape& a, const abut_pose& pose_a, const Shape& b, const abut_pose& pose_b,
                                    abut_pair_memory* memory) {
  std::array<abut_contact, 16> found{};
  std::size_t count = 0;
  const abut_status status =
      memory == nullptr
          ? abut_pair_contacts(a, &pose_a, b, &pose_b, nullptr, found.data(), found.size(), &count)
          : abut_pair_contacts_with_memory(a, &pose_a, b, &pose_b, nullptr, memory, found.data(), found.size(), &count);
  EXPECT_TRUE(succeeded(status));
  std::vector<std::uint64_t> bits;
  for (const abut_contact& contact : std::span(found).first(std::min(count, found.size()))) {
    for (const abut_vec3& v : {contact.point_a, contact.point_b, contact.normal}) {
      bits.insert(bits.end(), {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y),
                               std::bit_cast<std::uint64_t>(v.z)});
    }
    bits.insert(bits.end(), {std::bit_cast<std::uint64_t>(contact.distance), contact.id});
  }
  return bits;
}

// Both are proven within the bound of polytopes, and the witnesses are what the distance says.
void expect_same(const abut_distance& warm, const abut_distance& cold) {
  constexpr double bound = 2e-11, bound_of_curves = 1e-8;
  const double slack = cold.upper - cold.lower > bound ? bound_of_curves : bound;
  EXPECT_NEAR(warm.distance, cold.distance, slack);
  EXPECT_LE(warm.lower, cold.upper + slack);
  EXPECT_LE(cold.lower, warm.upper + slack);
  const abut_vec3 &a = warm.point_a, &b = warm.point_b, &n = warm.normal;
  EXPECT_NEAR((b.x - a.x) * n.x + (b.y - a.y) * n.y + (b.z - a.z) * n.z, warm.distance, slack);
  if (warm.distance > 0.01) {
    EXPECT_NEAR(std::hypot(b.x - a.x, b.y - a.y, b.z - a.z), warm.distance, slack);
  }
}

TEST(PairMemory, OfAnyBytesChangesNoAnswer) {
  Random random;
  const std::vector<Shape> shapes = shapes_with_corners(random);
  for (int i = 0; i < 8000; ++i) {
    const Shape& a = shapes.at(random.bits() % shapes.size());
    const Shape& b = shapes.at(random.bits() % shapes.size());
    const abut_pose pose_a = random.pose(1.5), pose_b = random.pose(1.5);
    abut_pair_memory memory = random.memory();
    expect_same(distance(a, pose_a, b, pose_b, memory), distance(a, pose_a, b, pose_b));
    memory = random.memory();
    EXPECT_EQ(contacts(a, pose_a, b, pose_b, &memory), contacts(a, pose_a, b, pose_b, nullptr));
  }
}

TEST(PairMemory, OfOtherShapesAndPosesChangesNoAnswer) {
  Random random;
  const std::vector<Shape> shapes = shapes_with_corners(random);
  abut_pair_memory memory{};
  for (int i = 0; i < 8000; ++i) {
    const Shape& a = shapes.at(random.bits() % shapes.size());
    const Shape& b = shapes.at(random.bits() % shapes.size());
    const abut_pose pose_a = random.pose(1.5), pose_b = random.pose(1.5);
    expect_same(distance(a, pose_a, b, pose_b, memory), distance(a, pose_a, b, pose_b));
    EXPECT_EQ(contacts(a, pose_a, b, pose_b, &memory), contacts(a, pose_a, b, pose_b, nullptr));
  }
}

TEST(PairMemory, FollowsAPairThatMoves) {
  Random random;
  const std::vector<Shape> shapes = shapes_with_corners(random);
  for (const Shape& b : shapes) {
    abut_pair_memory memory{};
    abut_pose pose = at(0, 0, 0);
    pose.orientation = random.orientation();
    for (int step = 0; step < 200; ++step) {
      pose.position = {4 - 0.03 * step, 0.1 * std::sin(0.3 * step), 0.2};
      expect_same(distance(shapes.at(1), identity, b, pose, memory), distance(shapes.at(1), identity, b, pose));
      EXPECT_EQ(contacts(shapes.at(1), identity, b, pose, &memory), contacts(shapes.at(1), identity, b, pose, nullptr));
    }
  }
}

TEST(PairMemory, SparesTheSearchWhereNothingMoved) {
  Random random;
  const std::vector<Shape> shapes = shapes_with_corners(random);
  const Shape& hull = shapes.at(1);
  const abut_pose there{{3, 0.5, 0.25}, random.orientation()};
  abut_pair_memory memory{};
  const abut_distance cold = distance(hull, identity, hull, there, memory);
  const abut_distance warm = distance(hull, identity, hull, there, memory);
  EXPECT_GT(cold.iterations, 1U);
  EXPECT_EQ(warm.iterations, 1U);
  // The shapes change places in the order of work; the memory is still theirs.
  const abut_pose beside{{-3, -0.5, -0.25}, there.orientation};
  (void)distance(hull, identity, hull, beside, memory);
  EXPECT_EQ(distance(hull, identity, hull, beside, memory).iterations, 1U);
}

TEST(PairMemory, KeepsWhatContactsFollowFrom) {
  Random random;
  const std::vector<Shape> shapes = shapes_with_corners(random);
  const Shape &hull = shapes.at(1), &cylinder = shapes.at(8);
  for (const Shape* other : {&hull, &shapes.at(4), &shapes.at(5), &cylinder}) {
    const abut_pose there{{0.8, 0.1, 0.2}, random.orientation()};
    abut_pair_memory memory{};
    for (int query = 0; query < 2; ++query) {
      EXPECT_FALSE(contacts(hull, identity, *other, there, &memory).empty());
    }
    const abut_pair_memory second = memory;
    EXPECT_NE(std::span(second.opaque)[5], 0U);
    EXPECT_FALSE(contacts(hull, identity, *other, there, &memory).empty());
    EXPECT_TRUE(std::ranges::equal(memory.opaque, second.opaque));
  }
}

TEST(PairMemory, StaysAsItIsWhereItGainsNothing) {
  const Shape ball = make_sphere(1.0);
  const Shape box = make_box(1, 1, 1);
  Random random;
  const abut_pair_memory before = random.memory();
  abut_pair_memory memory = before;
  (void)distance(ball, identity, box, at(4, 0, 0), memory);
  EXPECT_TRUE(std::ranges::equal(memory.opaque, before.opaque));
}

TEST(PairMemory, ServesEachPairOfABatch) {
  Random random;
  const std::vector<Shape> shapes = shapes_with_corners(random);
  std::vector<abut_pose> poses_a(16), poses_b(16);
  for (std::size_t i = 0; i < poses_a.size(); ++i) {
    poses_a[i] = random.pose(1);
    poses_b[i] = random.pose(4);
  }
  std::vector<abut_pair_memory> memories(16), of_singles(16);
  std::vector<abut_distance> found(16);
  for (int repeat = 0; repeat < 2; ++repeat) {
    ASSERT_TRUE(succeeded(abut_pairs_distance_with_memories(shapes.at(0), poses_a.data(), shapes.at(1), poses_b.data(),
                                                            16, nullptr, memories.data(), found.data())));
    for (std::size_t i = 0; i < poses_a.size(); ++i) {
      const abut_distance single = distance(shapes.at(0), poses_a[i], shapes.at(1), poses_b[i], of_singles[i]);
      EXPECT_EQ(found[i].distance, single.distance);
      EXPECT_EQ(found[i].iterations, single.iterations);
      EXPECT_TRUE(std::ranges::equal(memories[i].opaque, of_singles[i].opaque));
    }
  }
}

}  // namespace
