// SPDX-License-Identifier: Apache-2.0
// Several bodies: what they carry, what they keep, and which of them count.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

void rough(abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; }

struct Tower {
  Scene scene;
  std::vector<abut_part_id> parts;
};

Tower tower(const std::vector<double>& masses) {
  Tower out;
  out.scene.material(rough);
  out.scene.floor();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const double height = 0.5 + static_cast<double>(i);
    out.parts.push_back(out.scene.body(block(0.5, 0.5, 0.5), {{0, 0, height}, no_turn}, masses[i]));
  }
  return out;
}

// Force on the top of the ground, and on each level above it.
std::vector<double> forces_by_level(const Scene& scene, std::size_t levels) {
  std::vector<double> forces(levels);
  for (const abut_response_contact& contact : scene.contacts()) {
    forces.at(static_cast<std::size_t>(std::lround(contact.point.z))) += std::fabs(contact.force.z);
  }
  return forces;
}

TEST(Bodies, CarryWhatLiesOnThem) {
  for (const double heavy : {1.0, 1e4}) {
    std::vector<double> masses;
    for (int i = 0; i < 10; ++i) masses.push_back(std::pow(heavy, i / 9.0));
    Tower its = tower(masses);
    its.scene.step(1e-2, 100);
    const std::vector<double> forces = forces_by_level(its.scene, masses.size());
    double above = 0;
    for (std::size_t i = masses.size(); i-- > 0;) {
      above += masses[i] * gravity;
      EXPECT_NEAR(forces[i], above, 1e-6 * above) << i;
      EXPECT_NEAR(its.scene.pose(its.parts[i]).position.z, 0.5 + static_cast<double>(i), 2e-4);
    }
    ASSERT_EQ(its.scene.islands().size(), 1U);
    EXPECT_EQ(its.scene.islands()[0].body_count, 10U);
    EXPECT_EQ(its.scene.islands()[0].residuals.is_converged, 1U);
  }
}

TEST(Bodies, BeginWithTheImpulsesOfTheStepBefore) {
  Tower its = tower(std::vector<double>(10, 1.0));
  its.scene.step(1e-2);
  const std::uint32_t cold = its.scene.islands()[0].residuals.newton_steps;
  its.scene.step(1e-2, 10);
  const std::uint32_t warm = its.scene.islands()[0].residuals.newton_steps;
  EXPECT_LE(10 * warm, 7 * cold);
}

TEST(Bodies, KeepMomentumWhereTheyMeet) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  scene.material(rough);
  scene.body(ball(0.5), {{0, 0, 0}, no_turn}, 2, {{1, 0, 0}, {0, 3, 1}});
  scene.body(block(0.4, 0.5, 0.6), {{1.2, 0.3, 0.1}, {0.8, 0, 0.6, 0}}, 3, {{-1, 0.1, 0}, {0.5, 0, 0}});
  scene.body(ball(0.3), {{-1, 0.2, 0}, no_turn}, 1, {{2, 0, 0}, {0, 0, 0}});
  const abut_energy before = scene.energy();
  bool has_touched = false;
  for (int i = 0; i < 200; ++i) {
    scene.step(5e-3);
    has_touched = has_touched || !scene.contacts().empty();
    const abut_energy after = scene.energy();
    EXPECT_NEAR(after.linear_momentum.x, before.linear_momentum.x, 1e-12);
    EXPECT_NEAR(after.linear_momentum.y, before.linear_momentum.y, 1e-12);
    EXPECT_NEAR(after.linear_momentum.z, before.linear_momentum.z, 1e-12);
    EXPECT_LE(after.kinetic, before.kinetic * (1 + 1e-9));
  }
  EXPECT_TRUE(has_touched);
}

TEST(Bodies, AreSolvedIslandByIsland) {
  Scene scene;
  scene.floor();
  for (const double x : {0.0, 10.0, 20.0}) {
    scene.body(ball(0.5), {{x, 0, 0.5}, no_turn}, 1);
    scene.body(ball(0.5), {{x, 0, 1.5}, no_turn}, 1);
  }
  scene.step(1e-2);
  ASSERT_EQ(scene.islands().size(), 3U);
  std::map<std::uint32_t, int> contacts;
  for (const abut_response_contact& contact : scene.contacts()) ++contacts[contact.island];
  for (const abut_response_island& island : scene.islands()) {
    EXPECT_EQ(island.body_count, 2U);
    EXPECT_EQ(island.contact_count, 2U);
  }
  EXPECT_EQ(contacts, (std::map<std::uint32_t, int>{{0, 2}, {1, 2}, {2, 2}}));
}

TEST(Bodies, PassThroughSensors) {
  Scene scene;
  const abut_part_id wall = scene.place(ball(1), {{0, 0, -50}, no_turn}, ABUT_MOTION_STATIC);
  scene.attach(wall, block(5, 5, 5), {{0, 0, 45}, no_turn}, ABUT_GEOMETRY_SENSOR);
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 0.4}, no_turn}, 1);
  scene.step(1e-2, 100);
  EXPECT_NEAR(scene.pose(part).position.z, 0.4 - 0.5 * gravity, 1e-9);
  EXPECT_TRUE(scene.contacts().empty());
}

TEST(Bodies, LeaveWhatIsNoneWhereItIs) {
  Scene scene;
  const abut_part_id still = scene.place(ball(0.5), {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  const abut_part_id part = scene.body(ball(0.5), {{0, 0, 1}, no_turn}, 1);
  scene.step(1e-2, 10);
  EXPECT_EQ(scene.pose(still).position.z, 0);
  EXPECT_NEAR(scene.pose(part).position.z, 1, 1e-4);
  require(abut_response_remove_body(scene.response(), part));
  const double height = scene.pose(part).position.z;
  const abut_pose aside{{5, 0, 0}, no_turn};
  require(abut_part_set_pose(scene.universe(), still, &aside));
  scene.step(1e-2, 10);
  EXPECT_EQ(scene.pose(part).position.z, height);
}

TEST(Bodies, EndWithTheirParts) {
  Scene scene;
  const abut_part_id gone = scene.body(ball(0.5), {{0, 0, 3}, no_turn}, 1);
  const abut_part_id part = scene.body(ball(0.5), {{3, 0, 3}, no_turn}, 1);
  scene.step(0.5);
  require(abut_part_destroy(scene.universe(), gone));
  scene.step(0.5);
  EXPECT_NEAR(scene.pose(part).position.z, 3 - 0.5 * gravity, 1e-12);
  abut_mass_properties mass{};
  EXPECT_EQ(abut_response_body(scene.response(), gone, &mass), ABUT_STALE_ID);
}

TEST(Bodies, StandStillWhileTheySleep) {
  Tower its = tower({1, 1});
  abut_sleep sleep;
  abut_sleep_init(&sleep, sizeof sleep);
  for (const abut_part_id part : its.parts) require(abut_part_set_sleep(its.scene.universe(), part, &sleep));
  its.scene.step(1e-2, 40);
  std::uint32_t is_asleep = 0;
  require(abut_part_is_asleep(its.scene.universe(), its.parts[1], &is_asleep));
  ASSERT_EQ(is_asleep, 1U);
  EXPECT_TRUE(its.scene.contacts().empty());
  const double height = its.scene.pose(its.parts[1]).position.z;
  its.scene.step(1e-2, 10);
  EXPECT_EQ(its.scene.pose(its.parts[1]).position.z, height);
  const abut_vec3 push{100, 0, 0};
  require(abut_response_apply_force(its.scene.response(), its.parts[1], &push, nullptr));
  its.scene.step(1e-2);
  EXPECT_GT(its.scene.velocity(its.parts[1]).linear.x, 0.5);
}

TEST(Bodies, MoveTheSameBitsEachTime) {
  const auto run = [] {
    Tower its = tower({3, 1, 2, 5});
    const abut_vec3 push{20, 7, 0};
    require(abut_response_apply_force(its.scene.response(), its.parts[3], &push, nullptr));
    its.scene.step(1e-2, 50);
    std::uint64_t hash = 0;
    require(abut_universe_hash(its.scene.universe(), &hash));
    return std::pair(hash, its.scene.energy().kinetic);
  };
  EXPECT_EQ(run(), run());
}

// Islands are shared among threads, and hold the same bits whoever solves them.
TEST(Bodies, MoveTheSameBitsForAnyNumberOfThreads) {
  const auto run = [](std::uint32_t threads) {
    Scene scene([&](abut_response_options& its) { its.threads = threads; });
    scene.material(rough);
    scene.floor();
    for (int i = 0; i < 12; ++i) {
      const double x = 3 * i;
      scene.body(block(0.5, 0.5, 0.5), {{x, 0, 0.5}, no_turn}, 1 + i % 3, {{0.1 * i, 0, 0}, {0, 0, 0.2}});
      scene.body(ball(0.5), {{x + 0.01 * i, 0, 1.5}, no_turn}, 1, {{0, 0.3, 0}, {}});
    }
    scene.step(1e-2, 50);
    EXPECT_GT(scene.islands().size(), 6U);
    std::uint64_t hash = 0;
    require(abut_universe_hash(scene.universe(), &hash));
    return std::pair(hash, scene.energy().kinetic);
  };
  const auto alone = run(1);
  for (const std::uint32_t threads : {2U, 5U, 256U}) EXPECT_EQ(run(threads), alone) << threads;
}

struct Edits {
  std::size_t calls = 0;
  double friction = 0;
  bool counts = true;
};
std::uint32_t edit(void* context, const abut_contact* contact, abut_contact_material* material) {
  Edits& its = *static_cast<Edits*>(context);
  ++its.calls;
  EXPECT_EQ(contact->normal.z, contact->geometry_a.slot < contact->geometry_b.slot ? 1 : -1);
  EXPECT_EQ(material->friction_primary, 0.5);
  material->friction_primary = material->friction_secondary = its.friction;
  return its.counts ? 1 : 0;
}

// Contacts are edited before they push: here by another friction, and then by none at all.
TEST(Bodies, TakeContactsAsTheyAreEdited) {
  Scene scene([](abut_response_options& its) { its.gravity = {3, 0, -gravity}; });
  scene.material(rough);
  scene.floor();
  const abut_part_id part = scene.body(block(0.5, 0.5, 0.1), {{0, 0, 0.1}, no_turn}, 1);
  Edits edits;
  require(abut_response_set_contact_callback(scene.response(), edit, &edits));
  scene.step(1e-2);
  EXPECT_EQ(edits.calls, scene.contacts().size());
  EXPECT_NEAR(scene.velocity(part).linear.x, 0.03, 1e-9);
  edits.friction = 1;
  scene.step(1e-2);
  EXPECT_NEAR(scene.velocity(part).linear.x, 0, 1e-9);
  edits.counts = false;
  scene.step(1e-2);
  EXPECT_NEAR(scene.velocity(part).linear.z, -gravity * 1e-2, 1e-9);
  EXPECT_TRUE(scene.contacts().empty());
}

// But for what it lifts to move bodies apart: no energy is gained where they may stay as deep as they are.
TEST(Bodies, LoseEnergyWhereTheyFallOnAHeap) {
  constexpr double deep = 1;
  for (const double friction : {0.0, 0.4}) {
    for (const double slop : {1e-5, deep}) {
      Scene scene([&](abut_response_options& its) { its.slop = slop; });
      scene.material([&](abut_contact_material& row) { row.friction_primary = row.friction_secondary = friction; });
      scene.floor();
      drop_twelve(scene);
      const double start = total_energy(scene);
      double last = start;
      for (int i = 0; i < 300; ++i) {
        scene.step(1e-2);
        const double now = total_energy(scene);
        ASSERT_LE(now, last + (slop < deep ? 1e-5 : 1e-11) * start) << friction << " " << i;
        last = now;
      }
      EXPECT_LT(last, 0.5 * start);
    }
  }
}

// The universe that was destroyed first goes with its last response.
TEST(Bodies, KeepTheirUniverse) {
  abut_universe* universe = nullptr;
  require(abut_universe_create(nullptr, &universe));
  abut_response* response = nullptr;
  require(abut_response_create(universe, nullptr, &response));
  abut_universe_destroy(universe);
  EXPECT_EQ(abut_response_step(response, 1e-2), ABUT_OK);
  abut_response_destroy(response);
}

}  // namespace
