// SPDX-License-Identifier: Apache-2.0
// Fast geometries and shapes that are asked by their distance alone: cavities and distance fields. Where a marble meets
// a wall follows from closed forms. Also at which distance an advance stops.
#include <cmath>
#include <random>

#include "moving.hpp"

namespace {

using namespace abut_test;

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
  abut_vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

 private:
  std::mt19937_64 random_;
};

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Shape make_hollow(const Shape& cavity) {
  return make_composite({make_box(1.3, 1.3, 1.3), cavity}, {identity, identity});
}

// How far a point is from the walls.
struct Cavity {
  const char* name;
  Shape shape;
  double (*clearance)(const abut_vec3& p);
};
std::vector<Cavity> make_cavities() {
  std::vector<Cavity> cavities;
  cavities.push_back(
      {"ball", make_hollow(make_of_kind("sphere_hole", {1})), [](const abut_vec3& p) { return 1 - length(p); }});
  cavities.push_back({"cylinder", make_hollow(make_of_kind("cylinder_hole", {0.9, 1.1, 0})),
                      [](const abut_vec3& p) { return std::min(0.9 - std::hypot(p.x, p.y), 1.1 - std::abs(p.z)); }});
  cavities.push_back({"box", make_hollow(make_of_kind("box_hole", {0.9, 1, 1.1, 0})), [](const abut_vec3& p) {
                        return std::min({0.9 - std::abs(p.x), 1 - std::abs(p.y), 1.1 - std::abs(p.z)});
                      }});
  return cavities;
}

TEST(FastInACavity, FliesUpToTheWall) {
  ABUT_NEEDS_MOTION();
  constexpr std::uint64_t seed = 40;
  SCOPED_TRACE(seed);
  Numbers random(seed);
  const Shape marble = make_sphere(0.1);
  std::size_t stopped = 0;
  for (const Cavity& cavity : make_cavities()) {
    SCOPED_TRACE(cavity.name);
    for (int i = 0; i < 400; ++i) {
      const Moving moving{{random.vector(0.7), no_rotation},
                          {random.vector(i % 2 == 0 ? 90 : 1), {0, 0, 0}},
                          {random.vector(9), {0, 0, 0}}};
      if (cavity.clearance(moving.start.position) < 0.11) continue;
      Universe universe;
      universe.add(cavity.shape, identity, ABUT_MOTION_STATIC);
      const abut_part_id part = add_moving(universe, marble, moving, ABUT_GEOMETRY_FAST);
      abut_step_impact first{};
      require(abut_universe_advance_to_first_impact(universe, 1.0 / 60, &first));
      abut_pose pose{};
      require(abut_part_pose(universe, part, &pose));
      ASSERT_GT(cavity.clearance(pose.position), 0.1 - 1e-9) << i;
      ASSERT_EQ(first.lower < 1, cavity.clearance(pose.position) < 0.1 + 1e-9) << i;
      stopped += first.lower < 1 ? 1 : 0;
      require(abut_universe_step(universe, 1.0 / 60));
      if (first.lower < 1) ASSERT_EQ(universe.contacts().at(0).toi, 0) << i;
    }
  }
  EXPECT_GT(stopped, 200U);
}

TEST(FastInACavity, BouncesOffTheWallAndNeverLeaves) {
  ABUT_NEEDS_MOTION();
  constexpr std::uint64_t seed = 41;
  SCOPED_TRACE(seed);
  Numbers random(seed);
  const Shape marble = make_sphere(0.1), hollow = make_hollow(make_of_kind("sphere_hole", {1}));
  Universe universe;
  universe.add(hollow, identity, ABUT_MOTION_STATIC);
  abut_velocity velocity{random.vector(60), {0, 0, 0}};
  const abut_part_id part = add_moving(
      universe, marble, {{random.vector(0.3), no_rotation}, velocity, {{0, 0, 0}, {0, 0, 0}}}, ABUT_GEOMETRY_FAST);
  int bounces = 0;
  for (int step = 0; step < 100'000; ++step) {
    abut_step_impact first{};
    require(abut_universe_advance_to_first_impact(universe, 1.0 / 60, &first));
    abut_pose pose{};
    require(abut_part_pose(universe, part, &pose));
    const double away = length(pose.position);
    ASSERT_LT(away, 0.9 + 1e-9) << step;
    if (first.geometry_a.slot == 0) continue;
    ASSERT_GT(away, 0.9 - 1e-9) << step;
    const abut_vec3 normal = times(1 / away, pose.position);
    const double speed = dot(velocity.linear, normal);
    ASSERT_GT(speed, 0) << step;
    velocity.linear = sum(velocity.linear, times(-2 * speed, normal));
    require(abut_part_set_velocity(universe, part, &velocity));
    ++bounces;
  }
  EXPECT_GT(bounces, 20'000);
}

TEST(FastInACavity, HasTheContactsOfTheWall) {
  ABUT_NEEDS_MOTION();
  const Shape marble = make_sphere(0.1), hollow = make_hollow(make_of_kind("sphere_hole", {1}));
  Universe universe;
  universe.add(hollow, identity, ABUT_MOTION_STATIC);
  add_moving(universe, marble, {at(0.11, 0, 0), {{51, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}, ABUT_GEOMETRY_FAST);
  require(abut_universe_step(universe, 1.0 / 60));
  const auto impacts = impacts_of(universe);
  ASSERT_EQ(impacts.size(), 1U);
  EXPECT_NEAR(impacts[0].upper, 0.79 / 51 * 60, 1e-9);
  EXPECT_NEAR(impacts[0].lower, impacts[0].upper, 1e-9);
  ASSERT_EQ(universe.contacts().size(), 1U);
  EXPECT_NEAR(universe.contacts()[0].normal.x, -1, 1e-9);
}

// A grid of values, and points between them.
Shape make_field(Numbers& random, double roughness) {
  constexpr int side = 9;
  std::vector<double> values;
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        values.push_back(std::sqrt((i - 4.0) * (i - 4) + (j - 4.0) * (j - 4) + (k - 4.0) * (k - 4)) - 2.6 +
                         random.between(-roughness, roughness));
      }
    }
  }
  return make_of_kind("distance_field", {side, side, side, 1, 1, 1, 0, 0, 0, 0}, values);
}

TEST(FastOverADistanceField, TouchesNothingBeforeItsSurface) {
  ABUT_NEEDS_MOTION();
  constexpr std::uint64_t seed = 42;
  SCOPED_TRACE(seed);
  Numbers random(seed);
  std::size_t touching = 0, apart = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape field = make_field(random, i % 2 == 0 ? 0 : 0.4), ball = make_sphere(random.between(0.2, 2));
    const abut_vec3 aside = random.vector(1), place{4 + 5 * aside.x, 4 + 5 * aside.y, 4 + 5 * aside.z};
    if (distance_of(field, identity, ball, {place, no_rotation}) < 1e-3) continue;
    const Moving moving{{place, no_rotation},
                        {sum(times(-random.between(0, 6), aside), random.vector(1)), {0, 0, 0}},
                        {{0, 0, 0}, {0, 0, 0}}};
    Universe universe;
    universe.add(field, identity, ABUT_MOTION_STATIC);
    add_moving(universe, ball, moving, ABUT_GEOMETRY_FAST);
    require(abut_universe_step(universe, 1));
    const auto impacts = impacts_of(universe);
    const auto gap_at = [&](double t) { return distance_of(field, identity, ball, moving.at(t)); };
    if (!impacts.empty()) {
      EXPECT_LT(gap_at(impacts[0].upper), 1e-6) << i;
      ++touching;
      continue;
    }
    EXPECT_TRUE(universe.contacts().empty()) << i;
    for (int k = 0; k <= 64; ++k) EXPECT_GT(gap_at(k / 64.0), -1e-2) << i;
    ++apart;
  }
  EXPECT_GT(touching, 40U);
  EXPECT_GT(apart, 40U);
}

TEST(AdvanceToFirstImpact, StopsWhereAStepTouches) {
  ABUT_NEEDS_MOTION();
  constexpr std::uint64_t seed = 43;
  SCOPED_TRACE(seed);
  Numbers random(seed);
  const Shape ball = make_sphere(0.5);
  for (int i = 0; i < 200; ++i) {
    const double tolerance = i == 0 ? 0.1 : random.between(0, 0.3), speed = i == 0 ? 4 : random.between(1, 9);
    for (const abut_tolerance_mode mode : {ABUT_TOLERANCE_MARGIN, ABUT_TOLERANCE_DEAD_BAND}) {
      const auto fill = [&](Universe& universe) {
        abut_geometry_options fast = with_flags(ABUT_GEOMETRY_FAST);
        fast.tolerance = tolerance;
        const abut_part_id part = universe.add_part(identity);
        universe.add_geometry(part, ball, fast);
        const abut_velocity velocity{{speed, 0, 0}, {0, 0, 0}};
        require(abut_part_set_velocity(universe, part, &velocity));
        universe.add(ball, at(3, 0, 0), ABUT_MOTION_STATIC, tolerance);
      };
      abut_universe_options options = default_universe_options();
      options.tolerance_mode = mode;
      Universe stepped(&options), advanced(&options);
      fill(stepped);
      fill(advanced);
      require(abut_universe_step(stepped, 1));
      abut_step_impact first{};
      require(abut_universe_advance_to_first_impact(advanced, 1, &first));
      const double expected = (2 - (mode == ABUT_TOLERANCE_MARGIN ? 2 * tolerance : 0)) / speed;
      const auto impacts = impacts_of(stepped);
      ASSERT_EQ(impacts.size(), expected < 1 ? 1U : 0U);
      EXPECT_NEAR(first.lower, std::min(expected, 1.0), 1e-9);
      EXPECT_EQ(first.lower, impacts.empty() ? 1 : impacts[0].lower);
      if (expected < 1) {
        require(abut_universe_step(advanced, 0.01));
        EXPECT_EQ(advanced.contacts().size(), 1U);
      }
    }
  }
}

}  // namespace
