// SPDX-License-Identifier: Apache-2.0
// Pipelines, broad phases and narrow phases of SOFA, by the names that docs/sofa.md gives for them.
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "worlds.hpp"

namespace {

using namespace sofa_names;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

std::uint32_t threads_of_build(std::uint32_t wanted) { return abut_has_feature("threads") != 0 ? wanted : 1; }

// Balls of radius 0.5 in a crowd that moves: which of them touch, by their centres, step by step.
void expect_pairs_of_balls(const abut_universe_options& options) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 8), way(-0.5, 0.5);
  World world(options);
  std::vector<abut_vec3> centres;
  std::vector<abut_part_id> parts;
  const Shape shape = ball(0.5);
  for (int i = 0; i < 150; ++i) {
    centres.push_back({place(random), place(random), place(random)});
    parts.push_back(world.part({centres.back(), {1, 0, 0, 0}}));
    world.put(parts.back(), shape);
  }
  for (int step = 0; step < 3; ++step) {
    Pairs wanted, got;
    for (std::uint32_t i = 0; i < centres.size(); ++i) {
      for (std::uint32_t j = i + 1; j < centres.size(); ++j) {
        const double x = centres[i].x - centres[j].x, y = centres[i].y - centres[j].y, z = centres[i].z - centres[j].z;
        if (x * x + y * y + z * z < 1) wanted.emplace(i + 1, j + 1);
      }
    }
    for (const abut_contact& its : world.step()) got.emplace(its.geometry_a.slot, its.geometry_b.slot);
    EXPECT_EQ(got, wanted) << "seed 1, step " << step;
    EXPECT_GT(wanted.size(), 20U);
    for (std::size_t i = 0; i < centres.size(); ++i) {
      centres[i] = {centres[i].x + way(random), centres[i].y + way(random), centres[i].z + way(random)};
      world.move(parts[i], {centres[i], {1, 0, 0, 0}});
    }
  }
}

// A sheet in folds, that comes near itself.
Elements folds(std::uint32_t side) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double along = 4.0 * i / (side - 1), fold = along - 2 * static_cast<int>(along / 2);
      const double shift = 0.1 * std::sin(7 * i + 3 * j) / side;  // so that layers do not lie corner on corner
      xyz.insert(xyz.end(), {0.06 * along, double(j) / (side - 1) + shift, fold < 1 ? fold : 2 - fold});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t a = i * side + j, b = a + side;
        triangles.insert(triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
      }
    }
  }
  return elements_of(mesh_of(xyz, triangles));
}

TEST(Pipelines, CollisionPipeline) {
  World world;
  world.add(ball(0.5), at(0, 0, 0));
  world.add(ball(0.5), at(0.75, 0, 0));
  require(abut_universe_step(world.get(), 0.01));
  const abut_contact* contacts = nullptr;
  std::size_t count = 0;
  require(abut_universe_contacts(world.get(), &contacts, &count));
  EXPECT_EQ(count, 1U);
}

// Rigid bodies by contacts, cloth by its elements, in one universe; and both meet.
TEST(Pipelines, CompositeCollisionPipeline) {
  World world;
  auto policy = filled_by(abut_policy_init);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = 0.25;
  auto rigid = filled_by(abut_geometry_options_init), cloth = rigid;
  cloth.tag = 1;
  require(abut_policy_set(world.get(), cloth.tag, cloth.tag, &policy));
  world.put(world.part(at(0, 0, 0)), square(), cloth);
  world.put(world.part(at(0, 0, 0)), tip(0.5, -0.5, 0.125), cloth);
  world.put(world.part(at(-0.5, 0.5, 0.2)), ball(0.25), rigid);
  const auto contacts = world.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].geometry_b.slot, 3U);
  EXPECT_EQ(world.element_contacts().size(), 1U);
}

TEST(Pipelines, ParallelDetection) {
  std::set<std::uint64_t> hashes;
  for (const std::uint32_t threads : {1U, 2U}) {
    auto options = filled_by(abut_universe_options_init);
    options.threads = threads_of_build(threads);
    World world(options);
    for (int i = 0; i < 50; ++i) world.add(ball(0.5), at(0.75 * i, 0, 0));
    EXPECT_EQ(world.step().size(), 49U);
    hashes.insert(world.hash());
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST(Pipelines, Verbose) {
  World world;
  world.add(ball(0.5), at(0, 0, 0));
  world.add(ball(0.5), at(0.75, 0, 0));
  world.step();
  std::array<char, 8192> text{};
  std::size_t needed = 0;
  require(abut_universe_explain(world.get(), text.data(), text.size(), &needed));
  EXPECT_NE(std::string(text.data()).find("sphere"), std::string::npos);
}

// Detection without a response, as often as wanted.
TEST(Pipelines, ComputeCollisionDetection) {
  World world;
  world.add(ball(0.5), at(0, 0, 0));
  world.add(ball(0.5), at(0.75, 0, 0));
  require(abut_universe_detect_all(world.get()));
  const std::uint64_t hash = world.hash();
  require(abut_universe_detect_all(world.get()));
  EXPECT_EQ(world.stats().examined_pairs, 1U);
  EXPECT_NE(hash, 0U);
}

// Several universes know nothing of each other.
TEST(Pipelines, SetInstance) {
  std::array<abut_universe*, 2> universes{};
  for (abut_universe*& its : universes) {
    require(abut_universe_create(nullptr, &its));
    abut_part_id part{};
    require(abut_part_create(its, nullptr, &part));
    abut_geometry_id geometry{};
    require(abut_geometry_create(its, part, ball(0.5).get(), nullptr, &geometry));
    require(abut_universe_step(its, 0.01));
  }
  for (abut_universe* its : universes) {
    std::size_t count = 0;
    require(abut_universe_geometries(its, nullptr, 0, &count));
    EXPECT_EQ(count, 1U);
    abut_universe_destroy(its);
  }
}

TEST(Pipelines, SceneCheckCollisionResponse) {
  World world;
  for (const double x : {0, 5}) world.add(ball(0.5), at(x, 0, 0), 0, ABUT_MOTION_STATIC);
  std::array<abut_finding, 4> findings{};
  std::size_t count = 0;
  require(abut_universe_validate(world.get(), findings.data(), findings.size(), &count));
  ASSERT_EQ(count, 1U);
  EXPECT_EQ(findings[0].code, abut_finding_code{ABUT_FINDING_NOTHING_MOVES});
}

TEST(BroadPhases, BruteForceBroadPhase) {
  auto options = filled_by(abut_universe_options_init);
  options.broadphase = ABUT_BROADPHASE_BRUTE;
  expect_pairs_of_balls(options);
}

TEST(BroadPhases, ParallelBruteForceBroadPhase) {
  auto options = filled_by(abut_universe_options_init);
  options.broadphase = ABUT_BROADPHASE_BRUTE;
  options.threads = threads_of_build(2);
  expect_pairs_of_balls(options);
}

TEST(BroadPhases, Box) {
  World world;
  for (int i = 0; i < 4; ++i) world.add(ball(0.5), at(10 * (i / 2) + 0.75 * (i % 2), 0, 0));
  const abut_aabb region{{-1, -1, -1}, {2, 1, 1}};
  require(abut_universe_detect_region(world.get(), &region));
  const auto contacts = list(abut_universe_contacts, static_cast<const abut_universe*>(world.get()));
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].geometry_a.slot, 1U);
}

TEST(BroadPhases, IncrSAP) {
  auto options = filled_by(abut_universe_options_init);
  options.broadphase = ABUT_BROADPHASE_SWEEP_AND_PRUNE;
  expect_pairs_of_balls(options);
}

TEST(BroadPhases, DirectSAP) {
  auto options = filled_by(abut_universe_options_init);
  options.broadphase = ABUT_BROADPHASE_AUTO;
  expect_pairs_of_balls(options);
}

// What comes within reach is among the candidates.
TEST(NarrowPhases, BVHNarrowPhase) {
  const Elements sheet = folds(13);
  std::size_t count = 0;
  const auto options = within(0.05);
  require(abut_elements_candidates(sheet.get(), nullptr, &options, nullptr, 0, &count));
  std::vector<abut_element_pair> pairs(count);
  require(abut_elements_candidates(sheet.get(), nullptr, &options, pairs.data(), pairs.size(), &count));
  Pairs candidates;
  for (const abut_element_pair& its : pairs) {
    if (its.kind == ABUT_ELEMENT_PAIR_VERTEX_FACE) EXPECT_TRUE(candidates.emplace(its.a, its.b).second);
  }
  const auto near = closest(sheet, nothing(), options);
  EXPECT_GT(count_of(near, ABUT_STENCIL_VERTEX_FACE), 10U);
  for (const abut_stencil& its : near) {
    if (its.kind == ABUT_STENCIL_VERTEX_FACE) EXPECT_TRUE(candidates.contains({its.element_a, its.element_b}));
  }
}

TEST(NarrowPhases, ParallelBVHNarrowPhase) {
  const Elements sheet = folds(40);
  std::vector<std::vector<abut_stencil>> answers;
  for (const std::uint32_t threads : {1U, 2U}) {
    auto options = within(0.05);
    options.threads = threads_of_build(threads);
    answers.push_back(closest(sheet, nothing(), options));
  }
  ASSERT_EQ(answers[0].size(), answers[1].size());
  EXPECT_FALSE(answers[0].empty());
  EXPECT_EQ(std::memcmp(answers[0].data(), answers[1].data(), answers[0].size() * sizeof(abut_stencil)), 0);
}

// How deep a corner is in a solid mesh.
TEST(NarrowPhases, RayTraceNarrowPhase) {
  auto options = filled_by(abut_mesh_options_init);
  options.sides = ABUT_SIDES_SOLID;
  const Shape solid = make(abut_mesh_create, corner_xyz.data(), std::size_t{4}, corner_triangles.data(), std::size_t{4},
                           static_cast<const abut_mesh_options*>(&options));
  const abut_pose below = at(0, 0, 0), above = at(0.125, 0.125, -0.9375);
  std::array<abut_contact, 16> contacts{};
  std::size_t count = 0;
  require(
      abut_pair_contacts(solid.get(), &below, solid.get(), &above, nullptr, contacts.data(), contacts.size(), &count));
  ASSERT_GT(count, 0U);
  EXPECT_NEAR(contacts[0].distance, -0.0625, 1e-9);
  EXPECT_NEAR(contacts[0].normal.z, -1, 1e-9);
}

// A detector that says of each pair that it touches at the origin, a tenth deep; and abut, once it is taken away.
TEST(NarrowPhases, BulletCollisionDetection) {
  World world;
  world.add(ball(0.5), at(0, 0, 0));
  world.add(ball(0.5), at(0.75, 0, 0));
  const abut_backend_find find = [](void*, abut_universe* universe, const abut_backend_pair* pairs, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(pairs[i].pose_b.position.x, 0.75);
      abut_backend_contact contact{};
      contact.point_b.x = -0.1;
      contact.normal.x = 1;
      require(abut_backend_answer(universe, i, &contact, 1));
    }
  };
  require(abut_backend_set(world.get(), nullptr, find, nullptr));
  ASSERT_EQ(world.step().size(), 1U);
  EXPECT_EQ(world.step()[0].distance, -0.1);
  require(abut_backend_set(world.get(), nullptr, nullptr, nullptr));
  EXPECT_EQ(world.step()[0].distance, -0.25);
}

}  // namespace
