// SPDX-License-Identifier: Apache-2.0
// Springs and tetrahedra of particles, by laws: implicit Euler by hand, weights at rest, momentum, and energy that is
// never gained.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

struct Points {
  Scene scene;
  abut_geometry_id geometry{};

  explicit Points(std::size_t count, double radius = 0.05, double fall = 0, double tolerance = 1e-9)
      : scene([&](abut_response_options& its) {
          its.gravity = {0, 0, -fall};
          its.tolerance = tolerance;
        }) {
    const std::vector<double> any(3 * count);
    const Shape shape =
        shape_from([&](abut_shape** out) { return abut_particles_create(any.data(), count, radius, out); });
    const abut_part_id part = scene.place(shape, {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
    std::size_t found = 0;
    require(abut_part_geometries(scene.universe(), part, &geometry, 1, &found));
  }
  void add(const std::vector<double>& masses, const std::vector<double>& xyz,
           const std::vector<double>& velocities = {}) const {
    require(abut_response_add_particles(scene.response(), geometry, masses.data(), xyz.data(),
                                        velocities.empty() ? nullptr : velocities.data(), masses.size()));
  }
  void tie(const std::vector<std::uint32_t>& pairs, double stiffness, double damping = 0, double rest = -1) const {
    const std::size_t count = pairs.size() / 2;
    const std::vector<double> stiff(count, stiffness), damped(count, damping), lengths(count, rest);
    require(abut_response_add_springs(scene.response(), geometry, pairs.data(), stiff.data(), damped.data(),
                                      rest < 0 ? nullptr : lengths.data(), count));
  }
  void fill(const std::vector<std::uint32_t>& tetrahedra, double young, double poisson, double damping) const {
    abut_elastic_options options;
    abut_elastic_options_init(&options, sizeof options);
    options.young = young;
    options.poisson = poisson;
    options.damping = damping;
    require(
        abut_response_add_tetrahedra(scene.response(), geometry, tetrahedra.data(), tetrahedra.size() / 4, &options));
  }
  [[nodiscard]] std::vector<double> places() const { return numbers(false); }
  [[nodiscard]] std::vector<double> velocities() const { return numbers(true); }
  // Steps that never gain energy, of which `part` is rounding.
  void expect_no_gain(double dt, int steps, double part) {
    double last = total_energy(scene);
    const double size = std::max(1.0, std::fabs(last));
    for (int i = 0; i < steps; ++i) {
      scene.step(dt);
      const double now = total_energy(scene);
      ASSERT_LE(now, last + part * size) << "step " << i << " of " << dt;
      last = now;
    }
  }

 private:
  [[nodiscard]] std::vector<double> numbers(bool are_velocities) const {
    const double *xyz = nullptr, *velocities = nullptr;
    std::size_t count = 0;
    require(abut_response_particles(scene.response(), geometry, &xyz, &velocities, &count));
    const double* const first = are_velocities ? velocities : xyz;
    return {first, first + 3 * count};
  }
};

// A cube of n cells a side of size `cell`, each of six tetrahedra about its diagonal.
struct Cube {
  std::vector<double> xyz;
  std::vector<std::uint32_t> tetrahedra;

  Cube(std::uint32_t n, double cell, double height) {
    const std::uint32_t side = n + 1;
    for (std::uint32_t i = 0; i < side * side * side; ++i) {
      xyz.insert(xyz.end(), {cell * (i % side), cell * (i / side % side), height + cell * (i / side / side)});
    }
    const std::array<std::uint32_t, 3> steps{1, side, side * side};
    for (std::uint32_t cell_number = 0; cell_number < n * n * n; ++cell_number) {
      const std::uint32_t first = cell_number % n + side * (cell_number / n % n) + side * side * (cell_number / n / n);
      std::array<std::size_t, 3> order{0, 1, 2};
      do {
        const std::uint32_t a = first + steps.at(order[0]), b = a + steps.at(order[1]), c = b + steps.at(order[2]);
        tetrahedra.insert(tetrahedra.end(), {first, a, b, c});
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
  [[nodiscard]] std::size_t count() const { return xyz.size() / 3; }
};

// Two masses on a line. The distance obeys implicit Euler with the reduced mass.
TEST(Elastic, SpringsGoByImplicitEuler) {
  for (const double stiffness : {1e2, 1e5, 1e9}) {
    for (const double dt : {1e-3, 1e-1}) {
      Points its(2);
      its.add({1, 3}, {0, 0, 5, 1.5, 0, 5}, {0.3, 0, 0, -0.1, 0, 0});
      its.tie({0, 1}, stiffness, 2, 1);
      const double reduced = 0.75;
      double distance = 1.5, speed = -0.4;
      for (int i = 0; i < 40; ++i) {
        speed = (speed - dt * stiffness * (distance - 1) / reduced) /
                (1 + dt * 2 / reduced + dt * dt * stiffness / reduced);
        distance += dt * speed;
        its.scene.step(dt);
        const std::vector<double> at = its.places();
        ASSERT_NEAR(at[3] - at[0], distance, 1e-8) << stiffness << " " << dt << " " << i;
      }
      EXPECT_NEAR(its.scene.energy().linear_momentum.x, 0, 1e-8);
      ASSERT_EQ(its.scene.islands().size(), 1U);
      EXPECT_EQ(its.scene.islands()[0].residuals.is_converged, 1U);
    }
  }
}

// The error at one time halves with the step.
TEST(Elastic, SpringsAreOfOrderOne) {
  const auto error = [](int steps) {
    Points its(2);
    its.add({0, 1}, {0, 0, 0, 1.2, 0, 0});
    its.tie({0, 1}, 9, 0, 1);
    its.scene.step(1.0 / steps, steps);
    return std::fabs(its.places()[3] - (1 + 0.2 * std::cos(3.0)));
  };
  const double coarse = error(200), fine = error(400);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
}

TEST(Elastic, AWeightHangsAsLowAsItsForceSays) {
  for (const double stiffness : {1e2, 1e5, 1e8}) {
    Points its(2, 0.05, gravity);
    its.add({0, 2}, {0, 0, 5, 0, 0, 4});
    its.tie({0, 1}, stiffness, 2 * std::sqrt(2 * stiffness));
    its.scene.step(2e-2, 400);
    EXPECT_NEAR(5 - its.places()[5], 1 + 2 * gravity / stiffness, 1e-9) << stiffness;
    EXPECT_NEAR(its.scene.energy().potential, 2 * gravity * its.places()[5] + 0.5 * 4 * gravity * gravity / stiffness,
                1e-7);
  }
}

// A tetrahedron on a base that is held: along its axis the strain is a stretch, so that the law is linear at any size.
TEST(Elastic, ATetrahedronIsAsStiffAsItsMaterial) {
  constexpr double young = 2e3, poisson = 0.25, mass = 3;
  const double shear = young / 2.5, lame = young * 0.25 / (1.25 * 0.5);
  Points its(4, 0.05, gravity);
  its.add({0, 0, 0, mass}, {0, 0, 5, 1, 0, 5, 0, 1, 5, 0, 0, 6});
  its.fill({0, 1, 2, 3}, young, poisson, 0.1);
  its.scene.step(1e-2, 1500);
  EXPECT_NEAR(6 - its.places()[11], mass * gravity / ((2 * shear + lame) / 6), 1e-9);
  EXPECT_NEAR(its.places()[9], 0, 1e-9);
  // Across, by shear, to the first order; with the corners in the other order.
  Points other(4);
  const abut_vec3 aside{0.01, 0, 0};
  abut_response_options options;
  abut_response_options_init(&options, sizeof options);
  options.gravity = aside;
  require(abut_response_set_options(other.scene.response(), &options));
  other.add({0, 0, 0, mass}, {0, 0, 5, 1, 0, 5, 0, 1, 5, 0, 0, 6});
  other.fill({1, 0, 2, 3}, young, poisson, 0.1);
  other.scene.step(1e-2, 1500);
  EXPECT_NEAR(other.places()[9], mass * aside.x / (shear / 6), 1e-6);
}

TEST(Elastic, NeverGainsEnergy) {
  for (const double stiffness : {1e2, 1e4, 1e6, 1e8}) {
    for (const double dt : {1e-3, 3e-2}) {
      // A dumbbell that spins fast, with a cross on it.
      Points dumbbell(3);
      dumbbell.add({1, 2, 1}, {0, 0, 5, 1, 0, 5, 0, 1, 5}, {0, 4, 1, 0, -4, 2, -3, 0, -5});
      dumbbell.tie({0, 1, 1, 2}, stiffness);
      dumbbell.expect_no_gain(dt, 60, 1e-9);
      const Cube cube(1, 0.5, 5);
      Points jelly(cube.count(), 0.05, 0, 1e-13);
      std::vector<double> velocities(3 * cube.count());
      for (std::size_t i = 0; i < velocities.size(); ++i)
        velocities[i] = 3 * std::sin(1 + 7.0 * static_cast<double>(i));
      jelly.add(std::vector<double>(cube.count(), 0.5), cube.xyz, velocities);
      jelly.fill(cube.tetrahedra, stiffness, 0.3, 0);
      const abut_vec3 before = jelly.scene.energy().linear_momentum;
      jelly.expect_no_gain(dt, 40, 1e-9);
      const abut_vec3 after = jelly.scene.energy().linear_momentum;
      // Forces add up to zero but for the rounding of their impulses.
      const double rounding = 1e-11 + 1e-14 * dt * dt * stiffness;
      EXPECT_NEAR(after.x, before.x, rounding) << stiffness << " " << dt;
      EXPECT_NEAR(after.y, before.y, rounding) << stiffness << " " << dt;
      EXPECT_NEAR(after.z, before.z, rounding) << stiffness << " " << dt;
    }
  }
}

// A turn costs no force: a stiff cube that spins turns by its velocity, and stores no more than what pulls it apart.
TEST(Elastic, ACubeTurnsFreely) {
  constexpr double spin = 3, step = 1e-3;
  const Cube cube(1, 0.5, 5);
  std::vector<double> velocities(3 * cube.count());
  for (std::size_t i = 0; i < cube.count(); ++i) {
    velocities[3 * i] = -spin * (cube.xyz[3 * i + 1] - 0.25);
    velocities[3 * i + 1] = spin * (cube.xyz[3 * i] - 0.25);
  }
  Points its(cube.count());
  its.add(std::vector<double>(cube.count(), 0.5), cube.xyz, velocities);
  its.fill(cube.tetrahedra, 1e5, 0.3, 0);
  const double kinetic = its.scene.energy().kinetic;
  its.scene.step(step, 300);
  const std::vector<double> at = its.places();
  EXPECT_NEAR(std::atan2(at[4] - at[1], at[3] - at[0]), spin * step * 300, 0.01);
  EXPECT_NEAR(std::hypot(at[4] - at[1], at[3] - at[0]), 0.5, 1e-3);
  EXPECT_LT(its.scene.energy().potential, 1e-3 * kinetic);
}

TEST(Elastic, AJellyFallsOnAFloorAndRests) {
  const Cube cube(2, 0.25, 0.5);
  Points its(cube.count(), 0.05, gravity);
  its.scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
  its.scene.floor();
  its.add(std::vector<double>(cube.count(), 0.1), cube.xyz);
  its.fill(cube.tetrahedra, 2e3, 0.3, 0.02);
  its.expect_no_gain(1e-2, 400, 1e-7);
  EXPECT_LT(its.scene.energy().kinetic, 1e-10);
  double force = 0;
  for (const abut_response_contact& contact : its.scene.contacts()) force += std::fabs(contact.force.z);
  EXPECT_NEAR(force, 0.1 * static_cast<double>(cube.count()) * gravity, 1e-4);
}

// Structural and shear springs between 9 x 9 particles.
TEST(Elastic, AClothFallsOnABallAndRests) {
  constexpr std::uint32_t side = 9;
  constexpr double spacing = 0.12;
  Points its(side * side, 0.05, gravity);
  its.scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.8; });
  its.scene.place(ball(0.5), {{0, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  std::vector<double> xyz;
  std::vector<std::uint32_t> pairs;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t x = i % side, y = i / side;
    xyz.insert(xyz.end(), {spacing * (x - 4.0), spacing * (y - 4.0), 0.7});
    if (x + 1 < side) pairs.insert(pairs.end(), {i, i + 1});
    if (y + 1 < side) pairs.insert(pairs.end(), {i, i + side});
    if (x + 1 < side && y + 1 < side) pairs.insert(pairs.end(), {i, i + side + 1, i + 1, i + side});
  }
  its.add(std::vector<double>(side * side, 0.01), xyz);
  its.tie(pairs, 200, 0.05);
  its.expect_no_gain(1e-2, 300, 1e-7);
  EXPECT_LT(its.scene.energy().kinetic, 1e-5);
  const std::vector<double> at = its.places();
  for (std::size_t i = 0; i < at.size(); i += 3) {
    EXPECT_GT(std::sqrt(at[i] * at[i] + at[i + 1] * at[i + 1] + at[i + 2] * at[i + 2]), 0.549) << i / 3;
  }
  EXPECT_GT(at[3 * (side * side / 2) + 2], 0.54);
  EXPECT_LT(at[2], 0.5);
}

TEST(Elastic, IsKeptInBytes) {
  const Cube cube(1, 0.5, 5);
  Points its(cube.count(), 0.05, gravity);
  its.add(std::vector<double>(cube.count(), 0.5), cube.xyz);
  its.fill(cube.tetrahedra, 1e4, 0.3, 0.01);
  its.tie({0, 7}, 30, 1, 0.4);
  its.scene.step(1e-2, 3);
  std::size_t size = 0;
  require(abut_response_save(its.scene.response(), nullptr, 0, &size));
  std::vector<unsigned char> bytes(size);
  require(abut_response_save(its.scene.response(), bytes.data(), size, &size));
  abut_response* loaded = nullptr;
  require(abut_response_load(its.scene.universe(), bytes.data(), size, &loaded));
  std::uint64_t first = 0, second = 1;
  require(abut_response_hash(its.scene.response(), &first));
  require(abut_response_hash(loaded, &second));
  EXPECT_EQ(first, second);
  abut_energy here{}, there{};
  require(abut_response_energy(its.scene.response(), &here));
  require(abut_response_energy(loaded, &there));
  EXPECT_EQ(here.potential, there.potential);
  abut_response_destroy(loaded);
}

TEST(Elastic, IsRefusedWithTheNameOfWhatIsWrong) {
  Points its(4);
  its.add({1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  std::uint64_t before = 0, after = 0;
  require(abut_response_hash(its.scene.response(), &before));
  const std::array<double, 2> good{1, 1}, bad{1, -2};
  const auto expect = [&](abut_status status, abut_status expected, const std::string& words) {
    EXPECT_EQ(status, expected) << words;
    EXPECT_NE(std::string(abut_last_error_message()).find(words), std::string::npos) << abut_last_error_message();
  };
  const auto springs = [&](std::array<std::uint32_t, 4> pairs, const double* stiff, const double* damped) {
    return abut_response_add_springs(its.scene.response(), its.geometry, pairs.data(), stiff, damped, nullptr, 2);
  };
  expect(springs({0, 1, 2, 2}, good.data(), nullptr), ABUT_INVALID_ARGUMENT, "pairs[3] is 2");
  expect(springs({0, 1, 2, 4}, good.data(), nullptr), ABUT_INDEX_OUT_OF_RANGE, "pairs[3] is 4");
  expect(springs({0, 1, 2, 3}, bad.data(), nullptr), ABUT_OUT_OF_RANGE, "stiffnesses[1] is -2");
  expect(springs({0, 1, 2, 3}, good.data(), bad.data()), ABUT_OUT_OF_RANGE, "dampings[1] is -2");
  const std::array<std::uint32_t, 4> flat{0, 1, 2, 3};
  expect(abut_response_add_tetrahedra(its.scene.response(), its.geometry, flat.data(), 1, nullptr),
         ABUT_INVALID_ARGUMENT, "no volume");
  abut_elastic_options options;
  abut_elastic_options_init(&options, sizeof options);
  options.poisson = 0.5;
  expect(abut_response_add_tetrahedra(its.scene.response(), its.geometry, flat.data(), 1, &options), ABUT_OUT_OF_RANGE,
         "options.poisson");
  Points other(2);
  expect(
      abut_response_add_springs(other.scene.response(), other.geometry, flat.data(), good.data(), nullptr, nullptr, 1),
      ABUT_STALE_ID, "geometry.slot");
  require(abut_response_hash(its.scene.response(), &after));
  EXPECT_EQ(before, after);
}

}  // namespace
