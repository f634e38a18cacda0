// SPDX-License-Identifier: Apache-2.0
// Particles as bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

struct Grains {
  Scene scene;
  abut_part_id floor = scene.floor();
  abut_part_id part{};
  abut_geometry_id geometry{};

  // The part lies anywhere, because places are those of the world.
  explicit Grains(std::size_t count) {
    const std::vector<double> any(3 * count);
    const Shape shape =
        shape_from([&](abut_shape** out) { return abut_particles_create(any.data(), count, 0.1, out); });
    part = scene.place(shape, {{5, 6, 7}, {0.8, 0, 0.6, 0}}, ABUT_MOTION_DYNAMIC);
    std::size_t found = 0;
    require(abut_part_geometries(scene.universe(), part, &geometry, 1, &found));
  }
  void add(const std::vector<double>& masses, const std::vector<double>& xyz,
           const std::vector<double>& velocities = {}) const {
    require(abut_response_add_particles(scene.response(), geometry, masses.data(), xyz.data(),
                                        velocities.empty() ? nullptr : velocities.data(), masses.size()));
  }
  [[nodiscard]] std::vector<double> places() const {
    const double *xyz = nullptr, *velocities = nullptr;
    std::size_t count = 0;
    require(abut_response_particles(scene.response(), geometry, &xyz, &velocities, &count));
    return {xyz, xyz + 3 * count};
  }
};

TEST(Particles, FallSlideAndRest) {
  Grains its(4);
  its.scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.2; });
  // One falls freely, one slides, one is held, one is stopped by friction within a step, as nothing rolls.
  its.add({1, 2, 0, 3}, {0, 0, 50, 1, 0, 0.1, 2, 0, 3, 3, 0, 0.1}, {1, 0, 0, 0, 1, 0, 0, 0, 9, 0.01, 0, 0});
  const abut_energy before = its.scene.energy();
  EXPECT_NEAR(before.kinetic, 0.5 + 1 + 1.5e-4, 1e-12);
  EXPECT_NEAR(before.potential, gravity * (50 + 0.2 + 0.3), 1e-9);
  its.scene.step(1e-2, 40);
  const std::vector<double> at = its.places();
  EXPECT_NEAR(at[0], 0.4, 1e-12);
  EXPECT_NEAR(at[2], 50 - 0.5 * gravity * 0.16, 1e-10);
  // Particles do not roll: v t - mu g t^2 / 2, by implicit steps.
  EXPECT_NEAR(at[4], 0.4 - 0.5 * 0.2 * gravity * (0.16 + 0.004), 1e-6);
  EXPECT_EQ(at[8], 3);
  EXPECT_NEAR(at[9], 3, 1e-9);
  EXPECT_NEAR(at[11], 0.1, 1e-9);
  ASSERT_EQ(its.scene.contacts().size(), 2U);
  for (const abut_response_contact& contact : its.scene.contacts())
    EXPECT_NEAR(std::fabs(contact.force.z), (contact.point.x < 2 ? 2 : 3) * gravity, 1e-6);
}

// Contacts and bodies of both sorts in one island; what one receives the other loses.
TEST(Particles, PushBodies) {
  Grains its(1);
  its.scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.5; });
  const abut_part_id plate = its.scene.body(block(0.5, 0.5, 0.1), {{0, 0, 0.1}, no_turn}, 2);
  its.add({4}, {0.3, 0, 0.3});
  its.scene.step(1e-2, 100);
  EXPECT_NEAR(its.places()[2], 0.3, 1e-4);
  EXPECT_NEAR(its.scene.pose(plate).position.z, 0.1, 1e-4);
  double on_ground = 0;
  for (const abut_response_contact& contact : its.scene.contacts()) {
    if (contact.point.z < 0.1) on_ground += std::fabs(contact.force.z);
  }
  EXPECT_NEAR(on_ground, 6 * gravity, 1e-5);
  ASSERT_EQ(its.scene.islands().size(), 1U);
  EXPECT_EQ(its.scene.islands()[0].body_count, 2U);
}

TEST(Particles, EndWithTheirGeometry) {
  Grains its(2);
  its.add({1, 1}, {0, 0, 5, 1, 0, 5});
  its.scene.step(1e-2);
  require(abut_geometry_destroy(its.scene.universe(), its.geometry));
  its.scene.step(1e-2);
  EXPECT_EQ(abut_response_remove_particles(its.scene.response(), its.geometry), ABUT_STALE_ID);
  Grains other(2);
  other.add({1, 1}, {0, 0, 5, 1, 0, 5});
  require(abut_response_remove_particles(other.scene.response(), other.geometry));
  const double *xyz = nullptr, *velocities = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(abut_response_particles(other.scene.response(), other.geometry, &xyz, &velocities, &count), ABUT_STALE_ID);
}

TEST(Particles, RefuseWhatTheyCannotBe) {
  Grains its(2);
  abut_response* const response = its.scene.response();
  const std::vector<double> masses{1, 1}, places{0, 0, 5, 1, 0, 5};
  const auto refused = [&](const std::vector<double>& m, const std::vector<double>& x, abut_status status,
                           const char* named) {
    EXPECT_EQ(abut_response_add_particles(response, its.geometry, m.data(), x.data(), nullptr, m.size()), status);
    EXPECT_NE(std::string(abut_last_error_message()).find(named), std::string::npos) << abut_last_error_message();
  };
  refused({1, -1}, places, ABUT_OUT_OF_RANGE, "masses[1]");
  refused({1, std::nan("")}, places, ABUT_NOT_FINITE, "masses[1]");
  refused({1, 1e-40}, places, ABUT_OUT_OF_RANGE, "masses[1]");
  refused(masses, {0, 0, 5, 1, 0, HUGE_VAL}, ABUT_NOT_FINITE, "xyz[5]");
  refused({1, 1, 1}, {0, 0, 5, 1, 0, 5, 2, 0, 5}, ABUT_INDEX_OUT_OF_RANGE, "");
  EXPECT_EQ(abut_response_add_particles(response, its.geometry, nullptr, places.data(), nullptr, 2),
            ABUT_NULL_ARGUMENT);
  EXPECT_EQ(abut_response_add_particles(response, its.geometry, masses.data(), nullptr, nullptr, 2),
            ABUT_NULL_ARGUMENT);
  abut_geometry_id ground{};
  std::size_t found = 0;
  require(abut_part_geometries(its.scene.universe(), its.floor, &ground, 1, &found));
  EXPECT_EQ(abut_response_add_particles(response, ground, masses.data(), places.data(), nullptr, 2), ABUT_UNSUPPORTED);
  its.add(masses, places);
  abut_response_options options;
  abut_response_options_init(&options, sizeof options);
  options.flags = ABUT_RESPONSE_IMPACTS;
  require(abut_response_set_options(response, &options));
  EXPECT_EQ(abut_response_step(response, 1e-2), ABUT_UNSUPPORTED);
}

}  // namespace
