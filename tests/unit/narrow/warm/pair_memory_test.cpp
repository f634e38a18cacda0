// SPDX-License-Identifier: Apache-2.0
// What is remembered of a pair spares a search and changes no bit of its answer, however the bodies move.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.convex;
import abut.narrow.warm.convex_memory;
import abut.narrow.warm.proof;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.ellipsoid;
import abut.shapes.hull;
import abut.shapes.sphere;

namespace {

using abut::Box;
using abut::Capsule;
using abut::Cylinder;
using abut::Hull;
using abut::Manifold;
using abut::PairMemory;
using abut::Pose;
using abut::QuerySettings;
using abut::Rotation;
using abut::Vec3;

Hull random_hull(test::Random& random, std::size_t count, double size) {
  const Vec3 axes{random.uniform(0.4, 0.8), random.uniform(0.4, 0.8), random.uniform(0.4, 0.8)};
  std::vector<double> xyz;
  while (xyz.size() < 3 * count) {
    const Vec3 p = random.point(1);
    if (const double length = norm(p); length > 0.1 && length < 1) {
      const double scale = size * random.uniform(0.98, 1.02) / length;
      xyz.insert(xyz.end(), {scale * axes.x * p.x, scale * axes.y * p.y, scale * axes.z * p.z});
    }
  }
  return test::made<Hull>({}, xyz);
}
Hull box_hull(const Vec3& half) {
  std::vector<double> xyz;
  for (const Vec3& p : test::corners_of(half, Pose::identity())) {
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
  }
  return test::made<Hull>({}, xyz);
}
template <class S>
S random_solid(test::Random& random, double size) {
  std::vector<double> parameters;
  for (std::size_t i = 0; i < S::parameter_names.size(); ++i) {
    parameters.push_back(size * random.uniform(0.3, 0.7));
  }
  return test::made<S>(parameters);
}

void append_bits(const Vec3& v, std::vector<std::uint64_t>& out) {
  for (const double value : {v.x, v.y, v.z}) {
    out.push_back(std::bit_cast<std::uint64_t>(value));
  }
}
std::uint64_t bits_of(const abut::Feature& feature) {
  return static_cast<std::uint64_t>(feature.kind) << 32 | feature.index;
}
std::vector<std::uint64_t> bits_of(const Manifold& contacts) {
  std::vector<std::uint64_t> bits;
  for (const abut::ContactPoint& contact : contacts) {
    append_bits(contact.point_a, bits);
    append_bits(contact.point_b, bits);
    append_bits(contact.normal, bits);
    bits.insert(bits.end(), {std::bit_cast<std::uint64_t>(contact.distance), contact.id, bits_of(contact.feature_a),
                             bits_of(contact.feature_b)});
  }
  return bits;
}

Rotation turn(test::Random& random, double angle) {
  const Vec3 axis = random.point(1);
  const double s = std::sin(angle / 2) / norm(axis);
  return Rotation::from({std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z});
}

struct Tally {
  std::size_t touching = 0, apart = 0, spared = 0;
};

// Whether what was remembered proves the answer at a pose.
template <class A, class B>
bool is_spared(const A& a, const B& b, const Pose& ab, PairMemory memory) {
  const double size = abut::core_size(a, b, ab), error = abut::error_of(a, b, size, {});
  if (memory.state == PairMemory::State::apart) {
    return abut::is_still_apart(a, b, ab, size, error, a.radius() + b.radius(), memory);
  }
  if constexpr (abut::are_featured<A, B>) {
    abut::CoreSeparation core{};
    if (memory.state >= PairMemory::State::touching &&
        abut::overlap_along(a, b, ab, size, error, memory.features, core)) {
      const abut::Face face_a = a.supporting_face(core.normal), face_b = abut::placed_face(b, ab, -core.normal);
      return abut::is_still_least(a, b, ab, size, error, core, face_a, face_b, memory);
    }
  }
  return false;
}

template <class A, class B>
void expect_same(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, PairMemory& memory,
                 Tally& tally) {
  Manifold cold, warm;
  tally.spared += is_spared(a, b, ab, memory) ? 1 : 0;
  ASSERT_EQ(abut::convex_contacts(a, b, ab, settings, cold), abut::Outcome::ok);
  ASSERT_EQ(abut::convex_contacts(a, b, ab, settings, memory, warm), abut::Outcome::ok);
  ASSERT_EQ(bits_of(cold), bits_of(warm));
  (cold.empty() ? tally.apart : tally.touching) += 1;
}

// Along paths of steps of one length, which lead in and out of each other, with a leap now and then.
template <class MakeA, class MakeB>
Tally expect_same_on_paths(const MakeA& make_a, const MakeB& make_b, std::uint64_t seed, double scale_b = 1) {
  test::Random random(seed);
  Tally tally;
  for (int path = 0; path < 60; ++path) {
    const auto a = make_a(random);
    const auto b = make_b(random);
    const double step = std::pow(10, random.uniform(-5, -1)) * scale_b;
    const auto start = [&] { return Pose{random.rotation(), random.point(1.2 * (scale_b < 1 ? 0.6 : 1))}; };
    Pose ab = start();
    QuerySettings settings;
    settings.margin = path % 4 == 0 ? random.uniform(-0.02, 0.05) * scale_b : 0;
    Vec3 way = random.point(step);
    PairMemory memory{};
    for (int i = 0; i < 40; ++i) {
      expect_same(a, b, ab, settings, memory, tally);
      if (testing::Test::HasFatalFailure()) {
        ADD_FAILURE() << "path " << path << " step " << i;
        return tally;
      }
      if (random.uniform(0, 1) < 0.02) {
        ab = start();
      }
      way = way + random.point(0.3 * step);
      ab = {turn(random, random.uniform(0, 1) * step / scale_b) * ab.rotation, ab.position + way};
    }
  }
  return tally;
}

template <class S>
auto any_of(double size = 1) {
  return [size](test::Random& random) { return random_solid<S>(random, size); };
}
auto any_hull(std::size_t count, double size = 1) {
  return [count, size](test::Random& random) { return random_hull(random, count, size); };
}

void expect_tried(const Tally& tally) {
  EXPECT_GT(tally.touching, 300u);
  EXPECT_GT(tally.apart, 300u);
  EXPECT_GT(tally.spared, 900u);
}

TEST(PairMemory, ChangesNoBitBetweenHulls) { expect_tried(expect_same_on_paths(any_hull(32), any_hull(32), 901)); }
TEST(PairMemory, ChangesNoBitBetweenABoxAndAHull) {
  expect_tried(expect_same_on_paths(any_of<Box>(), any_hull(32), 902));
}
TEST(PairMemory, ChangesNoBitBetweenAHullAndABox) {
  expect_tried(expect_same_on_paths(any_hull(20), any_of<Box>(), 903));
}
TEST(PairMemory, ChangesNoBitBetweenManyCorneredHulls) {
  expect_tried(expect_same_on_paths(any_hull(200), any_hull(100), 904));
}
TEST(PairMemory, ChangesNoBitBetweenCylinders) {
  expect_tried(expect_same_on_paths(any_of<Cylinder>(), any_of<Cylinder>(), 905));
}
TEST(PairMemory, ChangesNoBitBetweenABoxAndACylinder) {
  expect_tried(expect_same_on_paths(any_of<Box>(), any_of<Cylinder>(), 906));
}
TEST(PairMemory, ChangesNoBitBetweenAHullAndACylinder) {
  expect_tried(expect_same_on_paths(any_hull(24), any_of<Cylinder>(), 907));
}

TEST(PairMemory, ChangesNoBitBetweenOtherSolids) {
  expect_same_on_paths(any_of<Capsule>(), any_hull(24), 908);
  expect_same_on_paths(any_of<abut::Sphere>(), any_hull(24), 909);
  expect_same_on_paths(any_of<abut::Cone>(), any_hull(24), 910);
  expect_same_on_paths(any_of<Cylinder>(), any_of<abut::Cone>(), 911);
  expect_same_on_paths(any_of<abut::Ellipsoid>(), any_of<Cylinder>(), 912);
  expect_same_on_paths(any_of<Box>(), any_of<Box>(), 913);
}

TEST(PairMemory, ChangesNoBitBetweenAGiantAndASpeck) {
  expect_same_on_paths(any_hull(24, 1), any_hull(24, 1e-6), 914, 1e-6);
  expect_same_on_paths(any_of<Box>(1), any_hull(24, 1e-3), 915, 1e-3);
  expect_same_on_paths(any_of<Cylinder>(1), any_hull(24, 1e-3), 916, 1e-3);
}

// Faces that lie on each other are as deep as each other within rounding: which one counts is the search's to say.
TEST(PairMemory, ChangesNoBitBetweenParallelFaces) {
  test::Random random(917);
  const Hull hull = box_hull({1, 0.8, 0.5});
  const Box box = test::made<Box>({0.6, 0.7, 0.4});
  const Cylinder cylinder = test::made<Cylinder>({0.5, 0.4});
  Tally tally;
  for (int i = 0; i < 200; ++i) {
    PairMemory of_hulls{}, of_box{}, of_cylinder{};
    const double tilt = i % 2 == 0 ? 0 : std::pow(10, random.uniform(-17, -2));
    const double angle = i % 3 == 0 ? 0 : random.uniform(0, 3);
    const Rotation up = Rotation::from({std::cos(angle), 0, 0, std::sin(angle)});
    for (int k = 0; k < 6; ++k) {
      const Rotation r = turn(random, tilt) * up;
      const Vec3 beside{random.uniform(-1, 1), random.uniform(-1, 1), 0};
      const double depth = std::pow(10, random.uniform(-14, -1));
      expect_same(hull, hull, {r, beside + Vec3{0, 0, 1 - depth}}, {}, of_hulls, tally);
      expect_same(box, hull, {r, beside + Vec3{0, 0, 0.9 - depth}}, {}, of_box, tally);
      expect_same(hull, cylinder, {r, beside + Vec3{0, 0, 0.9 - depth}}, {}, of_cylinder, tally);
      ASSERT_FALSE(HasFatalFailure()) << i << " " << k << " tilt " << tilt << " depth " << depth;
    }
  }
  EXPECT_GT(tally.touching, 1000u);
}

// What was left by one pose is no harm at any other one.
TEST(PairMemory, OfOnePoseServesAllPoses) {
  test::Random random(918);
  const Hull a = random_hull(random, 32, 1), b = random_hull(random, 32, 1);
  const Cylinder cylinder = test::made<Cylinder>({0.5, 0.6});
  Tally tally;
  for (int i = 0; i < 300; ++i) {
    PairMemory of_hulls{}, of_cylinder{};
    Pose from{random.rotation(), random.point(1)};
    for (int k = 0; k < 3; ++k) {
      expect_same(a, b, from, {}, of_hulls, tally);
      expect_same(a, cylinder, from, {}, of_cylinder, tally);
    }
    for (int k = 0; k < 12; ++k) {
      PairMemory hulls = of_hulls, with_cylinder = of_cylinder;
      // Any turn, about any point, near or far.
      const Rotation r = turn(random, std::pow(10, random.uniform(-4, 0.5)));
      const Vec3 about = random.point(k % 4 == 0 ? 1 : 1e6);
      const Vec3 carried = k % 2 == 0 ? about - r * about : Vec3{0, 0, 0};
      const Pose near{r * from.rotation, from.position + carried + 1e-3 * random.point(1)};
      const Pose to = k % 3 == 0 ? Pose{random.rotation(), random.point(1)} : near;
      expect_same(a, b, to, {}, hulls, tally);
      expect_same(a, cylinder, to, {}, with_cylinder, tally);
      ASSERT_FALSE(HasFatalFailure()) << i << " " << k;
    }
  }
  EXPECT_GT(tally.touching, 2000u);
  EXPECT_GT(tally.spared, 1000u);
}

// The proof itself: the hull of a disc and a ball, against its support in many directions.
TEST(PairMemory, DiscAndBallHoldTheDepth) {
  test::Random random(919);
  std::size_t proven = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 normal = random.rotation().z, centre = random.point(1);
    const double depth = std::pow(10, random.uniform(-3, 0)), clearance = random.uniform(0, 1),
                 radius = random.uniform(0, 1.5);
    if (!abut::is_least_depth(depth, normal, clearance, {centre, radius}, 0)) {
      continue;
    }
    ++proven;
    for (int k = 0; k < 20; ++k) {
      const Vec3 n = random.rotation().z;
      const double along = dot(n, normal), aside = std::sqrt(std::fmax(0, 1 - along * along));
      EXPECT_GE(std::fmax(depth * along + clearance * aside, dot(centre, n) + radius), depth * (1 - 1e-12));
    }
  }
  EXPECT_GT(proven, 1000u);
}

}  // namespace
