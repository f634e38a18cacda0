// SPDX-License-Identifier: Apache-2.0
// Parts, geometries and steps of a universe.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

namespace {

using namespace abut;

ShapeHandle make(std::string_view kind, const std::vector<Real>& parameters) {
  return ShapeHandle(make_shape(find_kind(kind).value(), parameters, {}, {}).value());
}
ShapeHandle ball(Real radius) { return make("sphere", {radius}); }
ShapeHandle box(Real half) { return make("box", {half, half, half}); }

Placement at(Real x, Real y, Real z) { return {{x, y, z}, {1, 0, 0, 0}}; }

PartId add_part(Universe& universe, const Placement& placement, MotionKind motion = MotionKind::dynamic) {
  const PartOptions options{motion, placement, 0};
  return universe.create_parts(std::span(&options, 1)).value()[0];
}
GeometryId add_geometry(Universe& universe, PartId part, const ShapeHandle& shape,
                        const GeometryOptions& options = {}) {
  return universe.create_geometries(std::span(&part, 1), std::span(&shape, 1), std::span(&options, 1)).value()[0];
}
GeometryId add(Universe& universe, const ShapeHandle& shape, const Placement& placement,
               MotionKind motion = MotionKind::dynamic) {
  return add_geometry(universe, add_part(universe, placement, motion), shape);
}
void place(Universe& universe, PartId part, const Placement& placement) {
  ASSERT_TRUE(universe.set_poses(std::span(&part, 1), std::span(&placement, 1)).has_value());
}
std::size_t contacts_after_step(Universe& universe) {
  EXPECT_TRUE(universe.step(0.01).has_value());
  return universe.contacts().size();
}

TEST(Universe, OverlappingBallsTouchOnce) {
  Universe universe({}, 1);
  const GeometryId a = add(universe, ball(1), at(0, 0, 0));
  const GeometryId b = add(universe, ball(1), at(0, 0, 1.5));
  ASSERT_EQ(contacts_after_step(universe), 1u);
  const Contact& contact = universe.contacts()[0];
  EXPECT_EQ(contact.geometry_a, a);
  EXPECT_EQ(contact.geometry_b, b);
  EXPECT_NEAR(contact.point.distance, -0.5, 1e-12);
  EXPECT_NEAR(contact.point.normal.z, 1, 1e-12);
  EXPECT_NEAR(contact.point.point_a.z, 1, 1e-12);
  EXPECT_NEAR(contact.point.point_b.z, 0.5, 1e-12);
  EXPECT_EQ(universe.stats().touching_pairs, 1u);
  EXPECT_EQ(universe.stats().candidate_pairs, 1u);
  EXPECT_EQ(universe.stats().parts, 2u);
  EXPECT_EQ(universe.stats().moved, 2u);
}

// The pair table knows (sphere, box) only: here the box has the lower slot.
TEST(Universe, LowerSlotIsSideAWhateverTheKinds) {
  Universe universe({}, 1);
  const GeometryId a = add(universe, box(1), at(0, 0, 0));
  const GeometryId b = add(universe, ball(1), at(0, 0, 1.5));
  ASSERT_EQ(contacts_after_step(universe), 1u);
  const Contact& contact = universe.contacts()[0];
  EXPECT_EQ(contact.geometry_a, a);
  EXPECT_EQ(contact.geometry_b, b);
  EXPECT_NEAR(contact.point.normal.z, 1, 1e-12);
  EXPECT_NEAR(contact.point.point_a.z, 1, 1e-12);
  EXPECT_NEAR(contact.point.point_b.z, 0.5, 1e-12);
  EXPECT_NEAR(dot(contact.point.point_b - contact.point.point_a, contact.point.normal), contact.point.distance, 1e-12);
}

TEST(Universe, GeometriesOfOnePartNeverMeet) {
  Universe universe({}, 1);
  const PartId part = add_part(universe, at(0, 0, 0));
  add_geometry(universe, part, ball(1));
  add_geometry(universe, part, ball(1));
  EXPECT_EQ(contacts_after_step(universe), 0u);
  EXPECT_EQ(universe.stats().candidate_pairs, 0u);
}

TEST(Universe, PartsOfWhichNoneIsDynamicNeverMeet) {
  for (const MotionKind a : {MotionKind::dynamic, MotionKind::animated, MotionKind::fixed}) {
    for (const MotionKind b : {MotionKind::dynamic, MotionKind::animated, MotionKind::fixed}) {
      for (const BroadphaseKind broadphase : {BroadphaseKind::brute, BroadphaseKind::tree}) {
        Universe universe({.broadphase = broadphase}, 1);
        add(universe, ball(1), at(0, 0, 0), a);
        add(universe, ball(1), at(0, 0, 1), b);
        const bool meet = a == MotionKind::dynamic || b == MotionKind::dynamic;
        EXPECT_EQ(contacts_after_step(universe), meet ? 1u : 0u);
      }
    }
  }
}

TEST(Universe, GeometriesSitWherePartAndLocalPoseSay) {
  Universe universe({}, 1);
  const Real half_turn = std::sqrt(0.5);
  // A quarter turn about z takes x to y.
  const PartId part = add_part(universe, {{10, 0, 0}, {half_turn, 0, 0, half_turn}});
  const GeometryId geometry =
      add_geometry(universe, part, ball(1), {.local = at(2, 0, 0), .tolerance = 0.25, .user_data = 9});
  add(universe, ball(1), at(10, 3.5, 0));
  const GeometryInfo info = universe.describe(geometry).value();
  EXPECT_EQ(info.part, part);
  EXPECT_EQ(info.options.tolerance, 0.25);
  EXPECT_EQ(info.options.user_data, 9u);
  EXPECT_NEAR(info.world.position.x, 10, 1e-12);
  EXPECT_NEAR(info.world.position.y, 2, 1e-12);
  EXPECT_NEAR(info.world.orientation.z, half_turn, 1e-15);
  ASSERT_EQ(contacts_after_step(universe), 1u);
  EXPECT_NEAR(universe.contacts()[0].point.distance, -0.5, 1e-12);
  place(universe, part, at(0, 0, 0));
  EXPECT_EQ(universe.world_pose(geometry).value().position, (Vec3{2, 0, 0}));
  EXPECT_EQ(contacts_after_step(universe), 0u);
  EXPECT_EQ(universe.stats().moved, 1u);
}

TEST(Universe, DeadBandHidesOverlapsUpToTheSumOfBothTolerances) {
  for (const auto& [depth, reported] : {std::pair{0.00199, false}, std::pair{0.00201, true}}) {
    Universe universe({}, 1);
    add_geometry(universe, add_part(universe, at(0, 0, 0)), ball(1), {.local = {}, .tolerance = 0.0015});
    add_geometry(universe, add_part(universe, at(2 - depth, 0, 0)), ball(1), {.local = {}, .tolerance = 0.0005});
    EXPECT_EQ(contacts_after_step(universe), reported ? 1u : 0u) << depth;
  }
}

TEST(Universe, MarginShowsSeparationsBelowTheSumOfBothTolerances) {
  for (const BroadphaseKind broadphase : {BroadphaseKind::brute, BroadphaseKind::tree}) {
    for (const auto& [separation, reported] : {std::pair{0.00199, true}, std::pair{0.00201, false}}) {
      Universe universe({.broadphase = broadphase, .tolerance_mode = ToleranceMode::margin}, 1);
      add_geometry(universe, add_part(universe, at(0, 0, 0)), ball(1), {.local = {}, .tolerance = 0.0015});
      add_geometry(universe, add_part(universe, at(2 + separation, 0, 0)), ball(1), {.local = {}, .tolerance = 0.0005});
      EXPECT_EQ(contacts_after_step(universe), reported ? 1u : 0u) << separation;
    }
  }
}

TEST(Universe, TouchingCountsWithoutTolerance) {
  for (const ToleranceMode mode : {ToleranceMode::dead_band, ToleranceMode::margin}) {
    Universe universe({.tolerance_mode = mode}, 1);
    add(universe, ball(1), at(0, 0, 0));
    add(universe, ball(1), at(2, 0, 0));
    EXPECT_EQ(contacts_after_step(universe), 1u);
  }
}

TEST(Universe, StaleAndForeignIdsChangeNothing) {
  Universe universe({}, 1), other({}, 2);
  const PartId kept = add_part(universe, at(0, 0, 0)), gone = add_part(universe, at(0, 0, 0));
  const GeometryId geometry = add_geometry(universe, kept, ball(1));
  const PartId foreign = add_part(other, at(0, 0, 0));
  ASSERT_TRUE(universe.destroy_parts(std::span(&gone, 1)).has_value());
  const Revision before = universe.revision();
  for (const PartId bad : {gone, foreign, PartId{}, PartId{99, kept.generation}}) {
    const std::array<PartId, 3> parts{kept, bad, kept};
    const std::array<Placement, 3> poses{at(5, 5, 5), at(0, 0, 0), at(0, 0, 0)};
    const std::vector<ShapeHandle> shapes(3, ball(1));
    const std::string message = "parts[1] is stale or belongs to another universe";
    for (const Error& error :
         {universe.set_poses(parts, poses).error(), universe.create_geometries(parts, shapes, {}).error(),
          universe.destroy_parts(std::span(parts).first(2)).error()}) {
      EXPECT_EQ(error.code, Errc::stale_id);
      EXPECT_EQ(error.message, message);
    }
    EXPECT_EQ(universe.pose(bad).error().code, Errc::stale_id);
    EXPECT_EQ(universe.user_data(bad).error().code, Errc::stale_id);
    EXPECT_EQ(universe.geometries_of(bad).error().code, Errc::stale_id);
  }
  for (const GeometryId bad : {GeometryId{}, GeometryId{geometry.slot, geometry.generation + 1}}) {
    EXPECT_EQ(universe.describe(bad).error().code, Errc::stale_id);
    EXPECT_EQ(universe.world_pose(bad).error().code, Errc::stale_id);
    const std::array<GeometryId, 2> both{geometry, bad};
    EXPECT_EQ(universe.destroy_geometries(both).error().message,
              "geometries[1] is stale or belongs to another universe");
  }
  EXPECT_EQ(universe.pose(kept).value().position, (Vec3{0, 0, 0}));
  EXPECT_EQ(universe.parts(), std::vector{kept});
  EXPECT_EQ(universe.geometries(), std::vector{geometry});
  EXPECT_EQ(universe.revision().geometries, before.geometries);
  EXPECT_EQ(universe.revision().poses, before.poses);
}

TEST(Universe, IdThatOccursTwiceIsStaleTheSecondTime) {
  Universe universe({}, 1);
  const PartId part = add_part(universe, at(0, 0, 0));
  const GeometryId geometry = add_geometry(universe, part, ball(1));
  const std::array<GeometryId, 2> geometries{geometry, geometry};
  EXPECT_EQ(universe.destroy_geometries(geometries).error().code, Errc::stale_id);
  const std::array<PartId, 2> parts{part, part};
  EXPECT_EQ(universe.destroy_parts(parts).error().message, "parts[1] is stale or belongs to another universe");
  EXPECT_TRUE(universe.describe(geometry).has_value());
  EXPECT_TRUE(universe.destroy_geometries(std::span(&geometry, 1)).has_value());
  EXPECT_TRUE(universe.destroy_parts(std::span(&part, 1)).has_value());
}

TEST(Universe, BadNumbersChangeNothing) {
  Universe universe({}, 1);
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_EQ(universe.step(nan).error().code, Errc::not_finite);
  EXPECT_EQ(universe.step(infinity).error().code, Errc::not_finite);
  EXPECT_EQ(universe.step(-1e-9).error().code, Errc::out_of_range);
  EXPECT_TRUE(universe.step(0).has_value());
  const std::array<PartOptions, 2> options{PartOptions{}, PartOptions{.placement = at(nan, 0, 0)}};
  EXPECT_EQ(universe.create_parts(options).error().code, Errc::not_finite);
  EXPECT_TRUE(universe.parts().empty());
  const std::array<PartOptions, 1> stretched{PartOptions{.placement = {{0, 0, 0}, {1, 0, 0, 1}}}};
  EXPECT_EQ(universe.create_parts(stretched).error().code, Errc::not_unit);
  const PartId part = add_part(universe, at(0, 0, 0));
  const ShapeHandle shape = ball(1);
  const GeometryOptions negative{.local = {}, .tolerance = -1};
  EXPECT_EQ(
      universe.create_geometries(std::span(&part, 1), std::span(&shape, 1), std::span(&negative, 1)).error().message,
      "options[0].tolerance is -1; it must be zero or positive");
  EXPECT_TRUE(universe.geometries().empty());
}

TEST(Universe, RevisionGrowsWithEveryChange) {
  Universe universe({}, 1);
  const PartId part = add_part(universe, at(0, 0, 0));
  Revision last = universe.revision();
  const GeometryId first = add_geometry(universe, part, ball(1));
  EXPECT_GT(universe.revision().geometries, last.geometries);
  EXPECT_EQ(universe.revision().poses, last.poses);
  last = universe.revision();
  place(universe, part, at(1, 0, 0));
  EXPECT_GT(universe.revision().poses, last.poses);
  EXPECT_EQ(universe.revision().geometries, last.geometries);
  last = universe.revision();
  const GeometryOptions options{};
  ASSERT_TRUE(universe.set_options(std::span(&first, 1), std::span(&options, 1)).has_value());
  EXPECT_GT(universe.revision().geometries, last.geometries);
  EXPECT_GT(universe.revision().poses, last.poses);
  last = universe.revision();
  ASSERT_TRUE(universe.destroy_geometries(std::span(&first, 1)).has_value());
  EXPECT_GT(universe.revision().geometries, last.geometries);
  add_geometry(universe, part, ball(1));
  last = universe.revision();
  ASSERT_TRUE(universe.destroy_parts(std::span(&part, 1)).has_value());
  EXPECT_GT(universe.revision().geometries, last.geometries);
}

TEST(Universe, DestroyedGeometriesMeetNothing) {
  for (const BroadphaseKind broadphase : {BroadphaseKind::brute, BroadphaseKind::tree}) {
    Universe universe({.broadphase = broadphase}, 1);
    add(universe, ball(1), at(0, 0, 0));
    const PartId part = add_part(universe, at(0, 0, 1));
    const GeometryId geometry = add_geometry(universe, part, ball(1));
    EXPECT_EQ(contacts_after_step(universe), 1u);
    ASSERT_TRUE(universe.destroy_geometries(std::span(&geometry, 1)).has_value());
    EXPECT_EQ(contacts_after_step(universe), 0u);
    EXPECT_TRUE(universe.geometries_of(part).value().empty());
    const GeometryId again = add_geometry(universe, part, ball(1));
    EXPECT_EQ(again.slot, geometry.slot);
    EXPECT_NE(again.generation, geometry.generation);
    EXPECT_EQ(contacts_after_step(universe), 1u);
    place(universe, part, at(0, 0, 1.25));
    ASSERT_TRUE(universe.destroy_parts(std::span(&part, 1)).has_value());
    EXPECT_EQ(contacts_after_step(universe), 0u);
    EXPECT_EQ(universe.geometries().size(), 1u);
  }
}

TEST(Universe, UnsupportedPairsAreCounted) {
  Universe universe({}, 1);
  const std::optional<std::size_t> plane = find_kind("plane");
  if (!plane) {
    GTEST_SKIP() << "this build has no plane";
  }
  add(universe, make("plane", {0, 0, 1, 0}), at(0, 0, 0));
  add(universe, make("plane", {0, 0, 1, 0}), at(0, 0, 0));
  EXPECT_EQ(contacts_after_step(universe), 0u);
  EXPECT_EQ(universe.stats().unsupported_pairs, 1u);
  EXPECT_EQ(universe.stats().candidate_pairs, 0u);
}

// A crowd of all convex kinds of the build that drifts, jumps, comes and goes.
class Crowd {
 public:
  Crowd(const UniverseOptions& options, std::uint32_t number, std::uint32_t seed, std::size_t count)
      : random_(seed), universe_(options, number) {
    for (const std::string_view kind : {"sphere", "box", "capsule"}) {
      if (find_kind(kind)) {
        shapes_.push_back(kind == "sphere" ? ball(0.6)
                          : kind == "box"  ? make(kind, {0.5, 0.4, 0.7})
                                           : make(kind, {0.3, 0.5}));
      }
    }
    if (find_kind("plane")) {
      add(universe_, make("plane", {0, 0, 1, -3}), at(0, 0, 0), MotionKind::fixed);
    }
    for (std::size_t i = 0; i < count; ++i) {
      create();
    }
  }
  void change() {
    for (PartId& part : parts_) {
      const Real dice = uniform(0, 1);
      if (dice < 0.02) {
        ASSERT_TRUE(universe_.destroy_parts(std::span(&part, 1)).has_value());
        part = PartId{};
      } else if (dice < 0.05) {
        place(universe_, part, somewhere());
      } else if (dice < 0.6) {
        Placement placement = universe_.pose(part).value();
        placement.position += Vec3{uniform(-0.05, 0.05), uniform(-0.05, 0.05), uniform(-0.05, 0.05)};
        place(universe_, part, placement);
      }
    }
    const std::size_t before = parts_.size();
    std::erase(parts_, PartId{});
    for (std::size_t i = parts_.size(); i < before; ++i) {
      create();
    }
  }
  Universe& universe() { return universe_; }

 private:
  Real uniform(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(random_); }
  Placement somewhere() {
    const Quat orientation = normalized({uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}).value();
    return {{uniform(-4, 4), uniform(-4, 4), uniform(-4, 4)}, orientation};
  }
  void create() {
    const Real dice = uniform(0, 1);
    const PartId part = add_part(universe_, somewhere(),
                                 dice < 0.7    ? MotionKind::dynamic
                                 : dice < 0.85 ? MotionKind::animated
                                               : MotionKind::fixed);
    const std::size_t geometries = dice < 0.2 ? 2 : 1;
    for (std::size_t i = 0; i < geometries; ++i) {
      const auto kind = static_cast<std::size_t>(uniform(0, static_cast<Real>(shapes_.size()) - 0.001));
      add_geometry(universe_, part, shapes_[kind], {.local = at(uniform(-0.3, 0.3), 0, 0), .tolerance = 0.01});
    }
    parts_.push_back(part);
  }

  std::mt19937 random_;
  Universe universe_;
  std::vector<ShapeHandle> shapes_;
  std::vector<PartId> parts_;
};

bool is_same(const Contact& a, const Contact& b) {
  return a.geometry_a == b.geometry_a && a.geometry_b == b.geometry_b && a.point.point_a == b.point.point_a &&
         a.point.point_b == b.point.point_b && a.point.normal == b.point.normal &&
         a.point.distance == b.point.distance && a.point.id == b.point.id && a.point.feature_a == b.point.feature_a &&
         a.point.feature_b == b.point.feature_b;
}
bool are_same(std::span<const Contact> a, std::span<const Contact> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same);
}

TEST(Universe, BroadPhasesGiveTheSameContacts) {
  for (const ToleranceMode mode : {ToleranceMode::dead_band, ToleranceMode::margin}) {
    constexpr std::uint32_t seed = 5;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Crowd brute({.broadphase = BroadphaseKind::brute, .tolerance_mode = mode}, 1, seed, 150);
    Crowd tree({.broadphase = BroadphaseKind::tree, .tolerance_mode = mode}, 1, seed, 150);
    Crowd automatic({.tolerance_mode = mode}, 1, seed, 150);
    std::size_t touched = 0;
    for (int frame = 0; frame < 40; ++frame) {
      for (Crowd* crowd : {&brute, &tree, &automatic}) {
        crowd->change();
        ASSERT_TRUE(crowd->universe().step(0.01).has_value());
      }
      ASSERT_TRUE(are_same(brute.universe().contacts(), tree.universe().contacts())) << "frame " << frame;
      ASSERT_TRUE(are_same(brute.universe().contacts(), automatic.universe().contacts())) << "frame " << frame;
      ASSERT_EQ(brute.universe().stats().candidate_pairs, tree.universe().stats().candidate_pairs);
      touched += brute.universe().contacts().size();
    }
    EXPECT_GT(touched, 1000u);
  }
}

TEST(Universe, TwoRunsGiveTheSameBits) {
  constexpr std::uint32_t seed = 11;
  Crowd first({}, 3, seed, 200), second({}, 3, seed, 200);
  for (int frame = 0; frame < 10; ++frame) {
    for (Crowd* crowd : {&first, &second}) {
      crowd->change();
      ASSERT_TRUE(crowd->universe().step(0.01).has_value());
    }
    ASSERT_TRUE(are_same(first.universe().contacts(), second.universe().contacts())) << "seed " << seed;
  }
}

TEST(Universe, ContactsAreOrderedBySlotsThenDepth) {
  Crowd crowd({.max_contacts = 0}, 1, 17, 200);
  ASSERT_TRUE(crowd.universe().step(0.01).has_value());
  const std::span<const Contact> contacts = crowd.universe().contacts();
  ASSERT_GT(contacts.size(), 50u);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_LT(contacts[i].geometry_a.slot, contacts[i].geometry_b.slot);
    if (i > 0) {
      const Contact &last = contacts[i - 1], &next = contacts[i];
      const std::pair last_slots{last.geometry_a.slot, last.geometry_b.slot},
          slots{next.geometry_a.slot, next.geometry_b.slot};
      EXPECT_LE(last_slots, slots);
      if (last_slots == slots) {
        EXPECT_LE(last.point.distance, next.point.distance);
      }
    }
  }
}

TEST(Universe, AutomaticBroadPhaseFollowsTheNumberOfGeometries) {
  Universe universe({}, 1);
  std::vector<PartId> parts;
  for (int i = 0; i < 10; ++i) {
    parts.push_back(add_part(universe, at(1.5 * i, 0, 0)));
    add_geometry(universe, parts.back(), ball(1));
  }
  EXPECT_EQ(contacts_after_step(universe), 9u);
  EXPECT_NE(universe.explain().find("broad phase: brute force"), std::string::npos);
  for (int i = 10; i < 700; ++i) {
    parts.push_back(add_part(universe, at(1.5 * i, 0, 0)));
    add_geometry(universe, parts.back(), ball(1));
  }
  EXPECT_EQ(contacts_after_step(universe), 699u);
  EXPECT_NE(universe.explain().find("broad phase: tree"), std::string::npos);
  ASSERT_TRUE(universe.destroy_parts(std::span(parts).subspan(20)).has_value());
  EXPECT_EQ(contacts_after_step(universe), 19u);
  EXPECT_NE(universe.explain().find("broad phase: brute force"), std::string::npos);
}

TEST(Universe, MemoryStaysConstantInSteadySteps) {
  Crowd crowd({}, 1, 23, 300);
  Universe& universe = crowd.universe();
  const std::vector<PartId> parts = universe.parts();
  std::uint64_t bytes = 0;
  for (int frame = 0; frame < 100; ++frame) {
    for (const PartId part : parts) {
      Placement placement = universe.pose(part).value();
      placement.position.x += frame % 2 == 0 ? 0.3 : -0.3;
      place(universe, part, placement);
    }
    ASSERT_TRUE(universe.step(0.01).has_value());
    if (frame == 20) {
      bytes = universe.stats().bytes;
    }
  }
  EXPECT_EQ(universe.stats().bytes, bytes);
}

TEST(Universe, ExplainNamesKindsThatMet) {
  Universe universe({}, 1);
  EXPECT_NE(universe.explain().find("0 geometries"), std::string::npos);
  add(universe, ball(1), at(0, 0, 0));
  add(universe, box(1), at(0, 0, 1.5));
  EXPECT_EQ(contacts_after_step(universe), 1u);
  const std::string text = universe.explain();
  EXPECT_NE(text.find("  sphere - box: 1 candidate, 1 examined, 1 touching, 1 contact; "), std::string::npos) << text;
  EXPECT_NE(text.find("narrow phase"), std::string::npos);
  EXPECT_NE(text.find("tree: another broad phase runs"), std::string::npos);
}

}  // namespace
