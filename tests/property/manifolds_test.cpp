// SPDX-License-Identifier: Apache-2.0
// Manifolds of random convex pairs: points on the surfaces, unique ids, the deepest one kept, the same contacts after
// a motion that is rounding, mirrored contacts after a swap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "manifold.hpp"
#include "scenes.hpp"
#include "shortfall.hpp"
#include "surface_residual.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::between;
using property::contacts_of;
using property::Manifold;
using property::Random;
using property::SolidSubject;
using property::Subject;

constexpr abut_quat upright{1, 0, 0, 0};

std::vector<double> random_points(Random& random, std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < 3 * count; ++i) numbers.push_back(between(random, -1, 1));
  return numbers;
}

// Some of the points once more, up to a billionth beside.
std::vector<double> points_twice(Random& random) {
  std::vector<double> numbers = random_points(random, 4 + random() % 5);
  const double apart = std::pow(10, between(random, -16, -8));
  const std::size_t count = numbers.size() / 3;
  for (std::size_t repeat = 0; repeat < 1 + random() % 3; ++repeat) {
    const std::size_t of = 3 * (random() % count);
    for (std::size_t i = 0; i < 3; ++i) numbers.push_back(numbers[of + i] + between(random, -apart, apart));
  }
  return numbers;
}

// A length of the order of one, now and then a thousandth or a millionth of that.
double length(Random& random) {
  const double scale = random() % 4 == 0 ? (random() % 2 == 0 ? 1e-3 : 1e-6) : 1;
  return scale * between(random, 0.1, 1);
}

SolidSubject random_solid(const std::string& kind, Random& random) {
  if (kind == "sliver hull") return property::make_solid("hull", kind, points_twice(random));
  std::vector<double> numbers;
  if (kind == "hull") numbers = random_points(random, 4 + random() % 9);
  if (kind == "triangle") numbers = random_points(random, 3);
  if (kind == "segment" || kind == "sphere") numbers = {length(random)};
  if (kind == "capsule" || kind == "cylinder" || kind == "cone") numbers = {length(random), length(random)};
  if (kind == "box" || kind == "ellipsoid") numbers = {length(random), length(random), length(random)};
  return property::make_solid(kind, kind, numbers);
}

const std::vector<std::string> kinds{"point",    "segment", "triangle", "sphere",      "capsule",  "box",
                                     "cylinder", "cone",    "hull",     "sliver hull", "ellipsoid"};

struct Pair {
  SolidSubject a, b;
  abut_pose pose_a, pose_b;
};

std::string text_of(const Pair& pair) {
  return pair.a.subject.kind + " " + property::text_of(pair.pose_a) + " / " + pair.b.subject.kind + " " +
         property::text_of(pair.pose_b);
}

std::optional<abut_distance> distance_of(const Pair& pair) {
  abut_distance distance;
  const abut_status status = abut_pair_distance(pair.a.subject.shape.get(), &pair.pose_a, pair.b.subject.shape.get(),
                                                &pair.pose_b, nullptr, &distance);
  return status == ABUT_OK ? std::optional(distance) : std::nullopt;
}

// Overlapping by a little or by much, in random poses.
Pair random_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair{random_solid(kind_a, random), random_solid(kind_b, random), {}, {}};
  pair.pose_a = {{0, 0, 0}, property::random_orientation(random)};
  pair.pose_b = {property::moved({0, 0, 0}, property::random_direction(random), between(random, 0, 1)),
                 property::random_orientation(random)};
  if (const auto found = distance_of(pair); found && (found->distance > 0 || random() % 2 == 0)) {
    const double depth = std::min(pair.a.subject.small, pair.b.subject.small) * between(random, 1e-3, 0.3);
    pair.pose_b.position = property::moved(pair.pose_b.position, found->normal, -found->distance - depth);
  }
  return pair;
}

Manifold contacts(const Pair& pair, std::uint32_t most = 0) {
  return contacts_of(pair.a.subject, pair.pose_a, pair.b.subject, pair.pose_b, 0, most);
}

// Every pair of the kinds, so often.
void for_pairs(const std::vector<std::string>& firsts, const std::vector<std::string>& seconds, int rounds,
               std::uint64_t seed, const std::function<void(const Pair&)>& check) {
  for (const std::string& a : firsts) {
    for (const std::string& b : seconds) {
      SCOPED_TRACE(a + " / " + b + ", seed " + std::to_string(seed));
      Random random(seed++);
      for (int round = 0; round < rounds; ++round) check(random_pair(a, b, random));
    }
  }
}

void expect_on_surface(const Pair& pair) {
  const double size = pair.a.subject.size + pair.b.subject.size;
  const Manifold found = contacts(pair);
  ASSERT_EQ(found.status, ABUT_OK);
  for (const abut_contact& contact : found.contacts) {
    EXPECT_NEAR(property::surface_residual(pair.a, pair.pose_a, contact.point_a), 0, 1e-9 * size) << text_of(pair);
    EXPECT_NEAR(property::surface_residual(pair.b, pair.pose_b, contact.point_b), 0, 1e-9 * size) << text_of(pair);
  }
}

TEST(Manifolds, PointsLieOnBothSurfaces) { for_pairs(kinds, kinds, 60, 7000, expect_on_surface); }

// By 45 degrees the surface lies radius * sqrt(2) under the upper end of the axis: the overlap there is 0.2536 deep.
TEST(Manifolds, PointsOfALeaningCapsuleLieOnIt) {
  const double angle = std::acos(-1.0) / 4;
  const abut_quat turned{std::cos(angle / 2), std::sin(angle / 2), 0, 0};
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 5);
  const Pair pair{property::make_solid("box", "box", {5, 5, 5}),
                  property::make_solid("capsule", "capsule", {0.5, 0.5}),
                  {{0, 0, 0}, upright},
                  {{0, 0, 5.1}, turned}};
  for (const Manifold& found : {contacts(pair), contacts_of(plane, pair.pose_a, pair.b.subject, pair.pose_b, 0, 0)}) {
    ASSERT_EQ(found.contacts.size(), 2u);
    EXPECT_NEAR(found.contacts[0].distance, 0.1 - 0.5 * std::sqrt(0.5) - 0.5, 1e-14);
    EXPECT_NEAR(found.contacts[1].distance, 0.1 + 0.5 * std::sqrt(0.5) - 0.5 * std::sqrt(2), 1e-14);
    for (const abut_contact& contact : found.contacts) {
      EXPECT_NEAR(property::surface_residual(pair.b, pair.pose_b, contact.point_b), 0, 1e-14);
      EXPECT_EQ(contact.point_a.z, 5);
    }
  }
}

// The upper end of a capsule that stands has nothing under it but the ball around the lower end.
TEST(Manifolds, AStandingCapsuleTouchesWithItsLowerEnd) {
  const Pair pair{property::make_solid("box", "box", {5, 5, 5}),
                  property::make_solid("capsule", "capsule", {0.5, 0.2}),
                  {{0, 0, 0}, upright},
                  {{0, 0, 4.9}, {std::cos(0.1), std::sin(0.1), 0, 0}}};
  const Subject plane = property::make_plane("plane", {0, 0, 1}, 5);
  EXPECT_EQ(contacts(pair).contacts.size(), 1u);
  EXPECT_EQ(contacts_of(plane, pair.pose_a, pair.b.subject, pair.pose_b, 0, 0).contacts.size(), 1u);
}

void expect_own_ids(const Manifold& found, const std::string& where) {
  ASSERT_EQ(found.status, ABUT_OK);
  std::set<std::uint64_t> ids;
  for (const abut_contact& contact : found.contacts) EXPECT_TRUE(ids.insert(contact.id).second) << where;
}

TEST(Manifolds, ContactsHaveIdsOfTheirOwn) {
  const std::vector<std::string> rims{"cylinder", "cone", "hull", "sliver hull"};
  for_pairs(rims, rims, 800, 7300, [](const Pair& pair) { expect_own_ids(contacts(pair), text_of(pair)); });
}

// Two such discs lean on each other flatly: the side of one crosses the rim of the other twice within a sixteenth.
TEST(Manifolds, ContactsOfTwoFlatConesHaveIdsOfTheirOwn) {
  const std::vector<double> numbers{0.10169506618342827, 1e-6};
  const Pair pair{property::make_solid("cone", "cone", numbers),
                  property::make_solid("cone", "cone", numbers),
                  {{0, 0, 0}, {0.5, 0.5, 0.5, 0.5}},
                  {{0.05509526110465288, 0.10720886252695368, 0.019470354999786256},
                   {-0.6823572440788832, -0.040087349919034836, -0.18591702069027174, 0.7058444993390495}}};
  const Manifold found = contacts(pair);
  EXPECT_EQ(found.contacts.size(), 2u);
  expect_own_ids(found, text_of(pair));
}

Subject composite_of(const std::vector<std::string>& parts, Random& random) {
  std::vector<Subject> children;
  std::vector<const abut_shape*> shapes;
  std::vector<abut_pose> poses;
  for (const std::string& kind : parts) {
    children.push_back(std::move(random_solid(kind, random).subject));
    shapes.push_back(children.back().shape.get());
    poses.push_back({property::moved({0, 0, 0}, property::random_direction(random), between(random, 0, 0.5)),
                     property::random_orientation(random)});
  }
  abut_shape* made = nullptr;
  EXPECT_EQ(abut_composite_create(shapes.data(), poses.data(), shapes.size(), &made), ABUT_OK);
  Subject composite;
  composite.kind = "composite";
  composite.shape = property::ShapePtr(made);
  return composite;
}

TEST(Manifolds, ContactsOfCompositesHaveIdsOfTheirOwn) {
  Random random(7400);
  for (int round = 0; round < 1000; ++round) {
    const Subject a = composite_of({"cone", "cylinder", "cone"}, random),
                  b = composite_of({"cylinder", "cone"}, random);
    const abut_pose pose_a{{0, 0, 0}, property::random_orientation(random)};
    const abut_pose pose_b{property::moved({0, 0, 0}, property::random_direction(random), between(random, 0, 1)),
                           property::random_orientation(random)};
    expect_own_ids(contacts_of(a, pose_a, b, pose_b, 0, 0), "seed 7400, round " + std::to_string(round));
  }
}

TEST(Manifolds, ReductionKeepsTheDeepestExactly) {
  for_pairs(kinds, kinds, 40, 7500, [](const Pair& pair) {
    const Manifold all = contacts(pair);
    for (const std::uint32_t most : {1u, 2u, 3u, 4u, 5u, 8u}) {
      const Manifold kept = contacts(pair, most);
      ASSERT_EQ(kept.contacts.empty(), all.contacts.empty()) << text_of(pair);
      ASSERT_LE(kept.contacts.size(), most) << text_of(pair);
      if (!all.contacts.empty()) {
        EXPECT_EQ(kept.contacts[0].distance, all.contacts[0].distance) << text_of(pair) << " most " << most;
      }
    }
  });
}

// A disc that leans by less than a thousandth rests on its face: between the corners of the rim it is deepest by a
// little.
TEST(Manifolds, ReductionKeepsTheDeepestPointOfARim) {
  Random random(7600);
  for (int round = 0; round < 2000; ++round) {
    const double lean = std::pow(10, between(random, -9, -3));
    const abut_vec3 across = property::random_direction(random);
    const Pair pair{property::make_solid("box", "box", {2, 0.3, 0.5}),
                    property::make_solid("cylinder", "cylinder", {0.4, 0.5}),
                    {{0, 0, 0}, upright},
                    {{between(random, -0.2, 0.2), between(random, -0.2, 0.2), 0.999}, property::about(across, lean)}};
    const Manifold all = contacts(pair);
    for (const std::uint32_t most : {1u, 2u, 3u, 4u, 8u}) {
      const Manifold kept = contacts(pair, most);
      ASSERT_EQ(kept.contacts.size(), std::min<std::size_t>(most, all.contacts.size())) << text_of(pair);
      EXPECT_EQ(kept.contacts[0].distance, all.contacts[0].distance) << text_of(pair) << " most " << most;
    }
  }
}

std::vector<std::uint64_t> ids_of(const Manifold& manifold) {
  std::vector<std::uint64_t> ids;
  for (const abut_contact& contact : manifold.contacts) ids.push_back(contact.id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

abut_vec3 jittered(const abut_vec3& p, double by, Random& random) {
  return {p.x + between(random, -by, by), p.y + between(random, -by, by), p.z + between(random, -by, by)};
}

// In how many of six tries a motion by this share of the smaller shape changes the ids.
int changes_of(const Pair& pair, double share, Random& random) {
  const double by = share * std::min(pair.a.subject.size, pair.b.subject.size);
  const std::vector<std::uint64_t> ids = ids_of(contacts(pair));
  int changes = 0;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const abut_pose pose{jittered(pair.pose_b.position, by, random), pair.pose_b.orientation};
    changes += ids_of(contacts_of(pair.a.subject, pair.pose_a, pair.b.subject, pose, 0, 0)) == ids ? 0 : 1;
  }
  return changes;
}

// A vertex of the hull lies over an edge of the face of the box: in it or beside it by rounding.
TEST(Manifolds, AVertexOverAnEdgeTouchesTheSameWayAfterRounding) {
  const double norm = std::sqrt(0.3 * 0.3 + 0.3 * 0.3 + 0.7 * 0.7 + 0.7 * 0.7);
  const Pair pair{property::make_solid("hull", "hull", {0, -.1, -.5, -.1, .6, -.4, .2, -.7, .8, -.3, .9, .6}),
                  property::make_solid("box", "box", {.5, .6, .7}),
                  {{0, 0, 0}, upright},
                  {{-.6, -.1, -.3}, {-.3 / norm, .3 / norm, -.7 / norm, -.7 / norm}}};
  Random random(7700);
  EXPECT_EQ(contacts(pair).contacts.size(), 2u);
  for (int round = 0; round < 100; ++round) EXPECT_EQ(changes_of(pair, 1e-15, random), 0);
}

// Straight above each other, with edges on edges: every corner of one is a corner of the other.
TEST(Manifolds, StackedBoxesTouchTheSameWayAfterRounding) {
  const Pair pair{property::make_solid("box", "box", {.5, .6, .7}),
                  property::make_solid("box", "box", {.5, .6, .7}),
                  {{0, 0, 0}, upright},
                  {{0, 0, 1.39}, upright}};
  Random random(7750);
  EXPECT_EQ(contacts(pair).contacts.size(), 4u);
  for (int round = 0; round < 100; ++round) EXPECT_EQ(changes_of(pair, 1e-15, random), 0);
}

// Discs a millionth as thick as wide may meet at their rims. There the error of the normal is larger than what tells
// side from end.
bool is_thin(const Subject& subject) { return subject.small < 0.05 * subject.size; }

// Rims that are deepest on a rim, edges that cross: which face of an edge is looked at must not follow from rounding.
TEST(Manifolds, StayTheSameAfterRounding) {
  const std::vector<std::string> solids{"box", "hull", "capsule", "cylinder", "cone"};
  std::uint64_t seed = 7800;
  for (const std::string& a : solids) {
    for (const std::string& b : solids) {
      Random random(seed++);
      int pairs = 0, changed = 0;
      for (int round = 0; round < 200; ++round) {
        const Pair pair = random_pair(a, b, random);
        if (is_thin(pair.a.subject) || is_thin(pair.b.subject) || contacts(pair).contacts.empty()) continue;
        ++pairs;
        changed += changes_of(pair, 1e-15, random) > 0 ? 1 : 0;
      }
      EXPECT_EQ(changed, 0) << a << " / " << b << ", of " << pairs << ", seed " << seed - 1;
    }
  }
}

Pair swapped(Pair pair) {
  std::swap(pair.a, pair.b);
  std::swap(pair.pose_a, pair.pose_b);
  return pair;
}

void expect_mirrored(Pair pair) {
  const std::string where = text_of(pair);
  const Manifold there = contacts(pair);
  const Manifold back = contacts(swapped(std::move(pair)));
  ASSERT_EQ(there.contacts.size(), back.contacts.size()) << where;
  ASSERT_FALSE(there.contacts.empty()) << where;
  const abut_vec3 &n = there.contacts[0].normal, &m = back.contacts[0].normal;
  EXPECT_EQ(n.x, -m.x) << where;
  EXPECT_EQ(n.y, -m.y) << where;
  EXPECT_EQ(n.z, -m.z) << where;
}

TEST(Manifolds, SwapNegatesTheNormalOfATieBetweenShapesThatDiffer) {
  const abut_pose at{{1, 2, 3}, upright}, turned{{1, 2, 3}, {0, 1, 0, 0}};
  const auto box = [](double x) { return property::make_solid("box", "box", {x, 1, 1}); };
  expect_mirrored({box(1), box(1), at, turned});
  expect_mirrored({box(1), box(1), at, {{1, 2, 3 + 1e-300}, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}});
  expect_mirrored({box(1), box(2), at, at});
  // Both hulls have the same box around them.
  const auto hull = [](double top) {
    return property::make_solid("hull", "hull", {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, top, 0, 1, -top, 0, 1});
  };
  expect_mirrored({hull(0.5), hull(0.25), at, at});
}

// No order can be told from the other: swapping changes nothing at all.
TEST(Manifolds, EqualShapesAtOnePoseHaveOneAnswer) {
  const abut_pose at{{0, 0, 0}, upright};
  const Pair pair{property::make_solid("box", "box", {1, 1, 1}), property::make_solid("box", "box", {1, 1, 1}), at, at};
  const Manifold there = contacts(pair), back = contacts_of(pair.b.subject, at, pair.a.subject, at, 0, 0);
  ASSERT_FALSE(there.contacts.empty());
  EXPECT_EQ(there.contacts[0].normal.x, back.contacts[0].normal.x);
  EXPECT_EQ(ids_of(there), ids_of(back));
}

}  // namespace
