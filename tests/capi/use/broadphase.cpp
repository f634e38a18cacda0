// SPDX-License-Identifier: Apache-2.0
// Whole scenes: both broad phases find the same contacts, whatever happens to the scene.
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <tuple>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::uint64_t seed = 20240611;

// The same scene under two broad phases. Both universes are told the same, so their ids have equal slots.
class Twins {
 public:
  explicit Twins(std::uint64_t random_seed) : random_(random_seed) {
    universes_.push_back(make_universe(ABUT_BROADPHASE_BRUTE));
    universes_.push_back(make_universe(ABUT_BROADPHASE_TREE));
    shapes_ = make_one_of_each_kind();
  }

  void add() {
    const auto kind = static_cast<std::size_t>(random_() % shapes_.size());
    // Terrain stands still: plane and height field.
    const bool is_terrain = kind == 3 || kind == 6;
    add(kind, is_terrain ? at(number(-8, 8), number(-8, 8), -6) : pose(),
        is_terrain ? ABUT_MOTION_STATIC : (random_() % 4 == 0 ? ABUT_MOTION_ANIMATED : ABUT_MOTION_DYNAMIC));
  }

  void remove() {
    if (ids_.empty()) return;
    const auto index = static_cast<std::ptrdiff_t>(random_() % ids_.size());
    for (std::size_t twin = 0; twin < 2; ++twin) {
      EXPECT_TRUE(
          succeeded(abut_part_destroy(*universes_.at(twin), ids_.at(static_cast<std::size_t>(index)).at(twin))));
    }
    ids_.erase(ids_.begin() + index);
  }

  void move() {
    for (const auto& pair : ids_) {
      if (random_() % 3 == 0) continue;
      abut_pose moved{};
      EXPECT_TRUE(succeeded(abut_part_pose(*universes_[0], pair[0], &moved)));
      moved.position.x += number(-0.4, 0.4);
      moved.position.y += number(-0.4, 0.4);
      moved.position.z += number(-0.4, 0.4);
      if (random_() % 50 == 0) moved = pose();  // a teleport
      for (std::size_t twin = 0; twin < 2; ++twin) {
        EXPECT_TRUE(succeeded(abut_part_set_pose(*universes_.at(twin), pair.at(twin), &moved)));
      }
    }
  }

  std::size_t step_and_compare() {
    std::array<std::set<Key>, 2> found;
    for (std::size_t twin = 0; twin < 2; ++twin) {
      for (const abut_contact& c : universes_.at(twin)->step()) {
        found.at(twin).insert(
            {c.geometry_a.slot, c.geometry_b.slot, c.id, c.distance, c.point_a.x, c.point_b.y, c.normal.z});
      }
    }
    EXPECT_EQ(found[0], found[1]);
    return found[0].size();
  }

 private:
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t, double, double, double, double>;

  static std::unique_ptr<Universe> make_universe(abut_broadphase broadphase) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.broadphase = broadphase;
    return std::make_unique<Universe>(&options);
  }

  void add(std::size_t kind, const abut_pose& where, abut_motion motion) {
    std::array<abut_part_id, 2> pair{};
    for (std::size_t twin = 0; twin < 2; ++twin) {
      pair.at(twin) = universes_.at(twin)->add_part(where, motion);
      universes_.at(twin)->add_geometry(pair.at(twin), shapes_.at(kind));
    }
    ids_.push_back(pair);
  }

  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
  }

  abut_pose pose() {
    const double half = number(0, std::numbers::pi);
    const double turn = number(0, 2 * std::numbers::pi);
    return {{number(-5, 5), number(-5, 5), number(-5, 5)},
            {std::cos(half), std::sin(half) * std::cos(turn), std::sin(half) * std::sin(turn), 0.0}};
  }

  std::mt19937_64 random_;
  std::vector<std::unique_ptr<Universe>> universes_;
  std::vector<Shape> shapes_;
  std::vector<std::array<abut_part_id, 2>> ids_;
};

TEST(Broadphase, TreeFindsWhatBruteForceFinds) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Twins twins(seed);
  for (int i = 0; i < 60; ++i) twins.add();
  std::size_t contacts = 0;
  for (int step = 0; step < 100; ++step) {
    contacts += twins.step_and_compare();
    ASSERT_FALSE(testing::Test::HasFailure()) << "step " << step;
    twins.move();
    if (step % 3 == 0) twins.remove();
    if (step % 3 == 1) twins.add();
  }
  EXPECT_GT(contacts, 1000U) << "the scene must have something to compare";
}

TEST(Broadphase, PlanesMeetEverythingHoweverFar) {
  for (const auto broadphase : {ABUT_BROADPHASE_AUTO, ABUT_BROADPHASE_BRUTE, ABUT_BROADPHASE_TREE}) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.broadphase = broadphase;
    Universe universe(&options);
    const Shape floor = make_plane({0, 0, 1}, 0);
    const Shape ball = make_sphere(1);
    universe.add(floor, identity, ABUT_MOTION_STATIC);
    universe.add(ball, at(0, 0, 0.5));
    universe.add(ball, at(1e7, -1e7, 0.5));
    universe.add(ball, at(0, 0, -1e6));
    universe.add(ball, at(5, 5, 1.5));
    const auto contacts = universe.step();
    ASSERT_EQ(contacts.size(), 3U);
    EXPECT_NEAR(contacts[0].distance, -0.5, 1e-12);
    EXPECT_NEAR(contacts[1].distance, -0.5, 1e-8);
    EXPECT_NEAR(contacts[2].distance, -1000001.0, 1e-6);
  }
}

TEST(Broadphase, ASceneOfAllKindsSteps) {
  const auto shapes = make_one_of_each_kind();
  for (const auto broadphase : {ABUT_BROADPHASE_BRUTE, ABUT_BROADPHASE_TREE}) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.broadphase = broadphase;
    Universe universe(&options);
    for (const Shape& shape : shapes) universe.add(shape, at(0.1, 0.2, 0.05));
    universe.add(make_plane({0, 1, 0}, 0), identity);
    const auto contacts = universe.step();
    EXPECT_FALSE(contacts.empty());
    abut_step_stats stats;
    abut_step_stats_init(&stats, sizeof stats);
    ASSERT_TRUE(succeeded(abut_universe_stats(universe, &stats)));
    EXPECT_EQ(stats.unsupported_pairs, 1U) << "the plane against the other";
    EXPECT_EQ(stats.contacts, contacts.size());
  }
}

TEST(Broadphase, TheOriginChangesNoContact) {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.origin = {1e7, 1e7, -1e7};
  Universe far_away(&options);
  Universe near;
  const Shape block = make_box(1, 1, 1);
  for (Universe* universe : {&far_away, &near}) {
    universe->add(block, at(1e7, 1e7, -1e7));
    universe->add(block, at(1e7 + 1.5, 1e7 + 0.5, -1e7));
  }
  const auto a = far_away.step();
  const auto b = near.step();
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  EXPECT_EQ(a[0].distance, b[0].distance);
}

}  // namespace
