// SPDX-License-Identifier: Apache-2.0
// Contact managers, responses, groups and the mouse of SOFA, by the names that docs/sofa.md gives for them.
#include <abut/picking.h>
#include <abut/response.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "../response/scene.hpp"
#include "worlds.hpp"

namespace {

using response_test::ball;
using response_test::block;
using response_test::gravity;
using response_test::no_turn;
using response_test::require;
using response_test::Scene;
using response_test::Shape;
using response_test::shape_from;

// A block of 2 kg on the ground, pushed along x by a gravity of 3 m/s^2.
struct Slope {
  Scene scene{[](abut_response_options& its) { its.gravity = {3, 0, -gravity}; }};
  abut_part_id floor = scene.floor();
  abut_part_id part = scene.body(block(0.5, 0.5, 0.1), {{0, 0, 0.1}, no_turn}, 2);

  [[nodiscard]] abut_response* response() const { return scene.response(); }
  // After half a second.
  double speed() {
    scene.step(1e-2, 50);
    return scene.velocity(part).linear.x;
  }
  [[nodiscard]] double height() const { return scene.pose(part).position.z; }
};
// Of sliding friction after half a second.
double sliding_speed(double mu) { return 0.5 * (3 - mu * gravity); }

abut_geometry_id geometry_of(const Scene& scene, abut_part_id part) {
  abut_geometry_id out{};
  std::size_t count = 0;
  require(abut_part_geometries(scene.universe(), part, &out, 1, &count));
  return out;
}

TEST(ContactManagers, CollisionResponse) {
  Slope slope;
  abut_response* own = nullptr;
  require(abut_response_create(slope.scene.universe(), nullptr, &own));
  abut_response_destroy(own);
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "none", nullptr, nullptr));
  EXPECT_NEAR(slope.speed(), 1.5, 1e-9);
}

TEST(ContactManagers, ResponseParams) {
  Slope slope;
  std::uint32_t rule = 0;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "friction", "mu=0.1", &rule));
  EXPECT_NEAR(slope.speed(), sliding_speed(0.1), 1e-6);
  require(abut_response_set_rule_parameters(slope.response(), rule, "mu=9"));
  EXPECT_NEAR(slope.speed(), 0, 1e-6);
}

TEST(ContactManagers, RuleBasedContactManager) {
  Slope slope;
  require(abut_response_set_variable(slope.response(), "rough", "0.1"));
  const abut_response_side part{ABUT_RESPONSE_SIDE_PART, slope.part.slot, slope.part.generation};
  require(abut_response_add_rule(slope.response(), nullptr, &part, "friction", "mu=$rough$", nullptr));
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "none", nullptr, nullptr));
  EXPECT_NEAR(slope.speed(), sliding_speed(0.1), 1e-6);
}

TEST(ContactManagers, ContactResponse) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "friction", "mu=9", nullptr));
  require(
      abut_response_set_geometry_kind(slope.response(), geometry_of(slope.scene, slope.part), "friction", "mu=0.1"));
  EXPECT_NEAR(slope.speed(), sliding_speed(0.1), 1e-6);
}

TEST(ContactManagers, ContactStiffness) {
  Slope slope;
  slope.scene.material([](abut_contact_material& its) {
    its.compliance = 1e-5;
    its.damping = 1e3;
  });
  slope.speed();
  EXPECT_NEAR(slope.height(), 0.1 - 2 * gravity / 4e5, 2e-5) << "four contacts bear the weight";
}

TEST(ContactManagers, ContactFriction) {
  Slope slope;
  slope.scene.material([](abut_contact_material& its) { its.friction_primary = its.friction_secondary = 0.1; });
  EXPECT_NEAR(slope.speed(), sliding_speed(0.1), 1e-6);
}

TEST(ContactManagers, ContactRestitution) {
  Scene scene([](abut_response_options& its) { its.flags = ABUT_RESPONSE_IMPACTS; }, 1e-6);
  scene.material([](abut_contact_material& its) { its.restitution = 0.5; });
  const abut_part_id part = scene.place(ball(0.5), {{0, 0, 1.5}, no_turn}, ABUT_MOTION_DYNAMIC);
  const abut_part_id floor = scene.floor();
  auto options = sofa_names::filled_by(abut_geometry_options_init);
  options.flags = ABUT_GEOMETRY_FAST;
  options.tolerance = 1e-6;
  for (const abut_part_id its : {part, floor})
    require(abut_geometry_set_options(scene.universe(), geometry_of(scene, its), &options));
  require(abut_response_add_bodies(scene.response(), &part, 1, nullptr));
  const double fall = std::sqrt(2 / gravity);
  scene.step(1e-2, static_cast<int>(fall / 1e-2) + 1);
  const double since = (static_cast<int>(fall / 1e-2) + 1) * 1e-2 - fall;
  EXPECT_NEAR(scene.velocity(part).linear.z, 0.5 * gravity * fall - gravity * since, 1e-4);
}

TEST(ContactManagers, ContactListener) {
  Slope slope;
  std::vector<abut_response_event> heard;
  const abut_response_listener listener = [](void* context, const abut_response_object* object) {
    static_cast<std::vector<abut_response_event>*>(context)->push_back(object->event);
  };
  require(abut_response_set_listener(slope.response(), listener, &heard));
  slope.scene.step(1e-2, 3);
  EXPECT_EQ(heard, (std::vector<abut_response_event>{ABUT_RESPONSE_EVENT_BEGIN, ABUT_RESPONSE_EVENT_PERSIST,
                                                     ABUT_RESPONSE_EVENT_PERSIST}));
}

TEST(ContactManagers, KeepAlive) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "stick", nullptr, nullptr));
  EXPECT_NEAR(slope.speed(), 0, 1e-6);
  require(abut_response_clear_rules(slope.response()));
  EXPECT_NEAR(slope.speed(), 0, 1e-6) << "the bonds stay";
  require(abut_response_release(slope.response(), geometry_of(slope.scene, slope.floor),
                                geometry_of(slope.scene, slope.part)));
  EXPECT_GT(slope.speed(), 1);
}

TEST(ContactResponses, PenalityContactForceField) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "penalty", "k=1e5&d=1e3", nullptr));
  EXPECT_NEAR(slope.speed(), 1.5, 1e-4) << "no friction";
  EXPECT_NEAR(slope.height(), 0.1 - 2 * gravity / 4e5, 2e-5);
}

TEST(ContactResponses, FrictionContactConstraint) {
  for (const bool holds : {true, false}) {
    Slope slope;
    require(
        abut_response_add_rule(slope.response(), nullptr, nullptr, "friction", holds ? "mu=0.31" : "mu=0.3", nullptr));
    EXPECT_NEAR(slope.speed(), holds ? 0 : sliding_speed(0.3), 1e-6) << "3 / 9.81 is 0.3058";
  }
}

TEST(ContactResponses, LagrangianMultiplier) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "friction", "mu=0", nullptr));
  EXPECT_NEAR(slope.speed(), 1.5, 1e-9);
  EXPECT_NEAR(slope.height(), 0.1, 2e-5);
}

TEST(ContactResponses, AugmentedLagrangianResponseConstraint) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "augmented", "mu=1&epsilon=0.1", nullptr));
  EXPECT_NEAR(slope.speed(), 0, 1e-4);
  EXPECT_NEAR(slope.height(), 0.1, 1e-3);
}

TEST(ContactResponses, StickContactForceField) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "stick", "k=1e4&d=1e3", nullptr));
  EXPECT_NEAR(slope.speed(), 0, 1e-3);
  EXPECT_NEAR(slope.height(), 0.1 - 2 * gravity / 4e4, 5e-5);
}

// Bonds also pull: the block hangs below its ground once gravity is turned around, until one of them breaks.
TEST(ContactResponses, StickContactConstraint) {
  for (const char* parameters : {"", "break=2"}) {
    Slope slope;
    require(abut_response_add_rule(slope.response(), nullptr, nullptr, "stick", parameters, nullptr));
    slope.speed();
    auto options = sofa_names::filled_by(abut_response_options_init);
    options.gravity = {0, 0, gravity};
    require(abut_response_set_options(slope.response(), &options));
    slope.speed();
    EXPECT_EQ(slope.height() > 0.5, *parameters != 0);
  }
}

TEST(ContactResponses, PersistentFrictionContact) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "slide", "mu=0.31", nullptr));
  EXPECT_NEAR(slope.speed(), 0, 1e-6);
}

TEST(ContactResponses, Nullptr) {
  Slope slope;
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "none", nullptr, nullptr));
  EXPECT_NEAR(slope.speed(), 1.5, 1e-9);
  EXPECT_NEAR(slope.height(), 0.1 - 0.5 * gravity * 0.25, 0.1) << "it falls";
}

TEST(ContactResponses, ContactFactory) {
  Slope slope;
  const abut_contact_law_callback smooth = [](void* context, const abut_contact*, const abut_vec3*, double,
                                              abut_contact_law* law) {
    ++*static_cast<int*>(context);
    law->friction_primary = law->friction_secondary = 0.1;
    return std::uint32_t{1};
  };
  int calls = 0;
  require(abut_response_add_kind(slope.response(), "mine", smooth, &calls));
  require(abut_response_add_rule(slope.response(), nullptr, nullptr, "mine", nullptr, nullptr));
  EXPECT_NEAR(slope.speed(), sliding_speed(0.1), 1e-6);
  EXPECT_GE(calls, 50);
}

// Each ray of a batch and what it meets first.
TEST(ContactResponses, RayContact) {
  Slope slope;
  require(abut_universe_refresh(slope.scene.universe()));
  const std::array<abut_ray, 2> rays{abut_ray{{0, 0, 5}, {0, 0, -1}, 10}, abut_ray{{0, 0, 5}, {0, 0, 1}, 10}};
  std::array<abut_query_hit, 2> hits{};
  require(abut_universe_cast_rays(slope.scene.universe(), rays.data(), rays.size(), nullptr, hits.data()));
  EXPECT_EQ(hits[0].geometry.slot, geometry_of(slope.scene, slope.part).slot);
  EXPECT_NEAR(hits[0].distance, 4.8, 1e-12);
  EXPECT_EQ(hits[1].geometry.slot, 0U);
}

// A mass of 2 kg that falls by 3 m/s on a wall.
TEST(ContactResponses, GenericConstraintSolver) {
  const double mass = 2, inertia[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, centre[3] = {0, 0, 0};
  const double free_velocity[6] = {0, 0, -3, 0, 0, 0}, normal[3] = {0, 0, 1};
  const std::uint32_t sides[2] = {ABUT_NO_BODY, 0};
  auto problem = sofa_names::filled_by(abut_contact_problem_init);
  problem.body_count = problem.contact_count = 1;
  problem.masses = &mass;
  problem.inertias = inertia;
  problem.centres = problem.points = centre;
  problem.free_velocities = free_velocity;
  problem.bodies = sides;
  problem.normals = normal;
  std::array<double, 6> velocity{};
  std::array<double, 3> impulse{};
  abut_residuals residuals{};
  require(abut_contact_problem_solve(&problem, nullptr, velocity.data(), impulse.data(), &residuals));
  EXPECT_NEAR(impulse[2], 6, 1e-7);
  EXPECT_NEAR(velocity[2], 0, 1e-7);
}

TEST(ContactResponses, FreeMotionAnimationLoop) {
  Slope slope;
  for (int i = 0; i < 10; ++i) require(abut_response_step(slope.response(), 1e-2));
  EXPECT_NEAR(slope.scene.velocity(slope.part).linear.x, 0.3, 1e-9);
  EXPECT_NEAR(slope.scene.velocity(slope.part).linear.z, 0, 1e-7);
}

TEST(CollisionGroups, CollisionGroupManager) {
  Scene scene;
  scene.floor();
  for (const double x : {0.0, 0.999, 5.0}) scene.body(ball(0.5), {{x, 0, 0.5}, no_turn}, 1);
  require(abut_universe_follow_islands(scene.universe(), 1));
  require(abut_universe_step(scene.universe(), 0.01));
  const abut_island* islands = nullptr;
  std::size_t count = 0;
  require(abut_universe_islands(scene.universe(), &islands, &count));
  ASSERT_EQ(count, 2U) << "the floor joins nobody";
  EXPECT_EQ(islands[0].part_count, 2U);
  EXPECT_EQ(islands[1].part_count, 1U);
}

TEST(CollisionGroups, SolverMerger) {
  Scene scene;
  auto options = sofa_names::filled_by(abut_body_options_init);
  for (const abut_integrator its : {ABUT_INTEGRATOR_EULER, ABUT_INTEGRATOR_IMPLICIT}) {
    options.integrator = its;
    const double x = its == abut_integrator{ABUT_INTEGRATOR_EULER} ? 0 : 0.999;
    const abut_part_id part = scene.place(ball(0.5), {{x, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
    require(abut_response_add_bodies(scene.response(), &part, 1, &options));
  }
  scene.step(1e-2);
  ASSERT_EQ(scene.islands().size(), 1U);
  EXPECT_EQ(scene.islands()[0].integrator, abut_integrator{ABUT_INTEGRATOR_IMPLICIT});
}

// What lies under the mouse, and a link that draws it along.
TEST(Mouse, MouseInteractor) {
  Scene scene;
  scene.body(ball(0.5), {{0, 0, 0}, no_turn}, 1);
  abut_picker* picker = nullptr;
  require(abut_picker_create(scene.universe(), &picker));
  auto camera = sofa_names::filled_by(abut_camera_init);
  const abut_vec3 eye{0, 0, 5}, target{0, 0, 0}, up{0, 1, 0};
  require(abut_camera_look_at(&camera, &eye, &target, &up));
  abut_pick pick{};
  require(abut_picker_pick_pixel(picker, &camera, 320, 240, 2, nullptr, &pick));
  EXPECT_EQ(pick.geometry.slot, 1U);
  EXPECT_NEAR(pick.distance, 4.5, 1e-3);
  abut_picker_destroy(picker);
}

TEST(Mouse, AttachBodyPerformer) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  auto link = sofa_names::filled_by(abut_link_options_init);
  link.b = scene.body(ball(0.5), {{0, 0, 0}, no_turn}, 1);
  link.stiffness = 100;
  link.damping = 20;
  std::uint64_t mouse = 0;
  require(abut_response_add_link(scene.response(), &link, &mouse));
  const abut_vec3 there{1, 0, 0};
  require(abut_response_move_link(scene.response(), mouse, &there));
  scene.step(1e-2, 300);
  EXPECT_NEAR(scene.pose(link.b).position.x, 1, 1e-3);
}

TEST(Mouse, ConstraintAttachBodyPerformer) {
  Scene scene([](abut_response_options& its) { its.gravity = {0, 0, 0}; });
  auto link = sofa_names::filled_by(abut_link_options_init);
  link.b = scene.body(ball(0.5), {{0, 0, 0}, no_turn}, 1);
  link.stiffness = 0;  // rigid
  std::uint64_t mouse = 0;
  require(abut_response_add_link(scene.response(), &link, &mouse));
  const abut_vec3 there{0.01, 0, 0};
  require(abut_response_move_link(scene.response(), mouse, &there));
  scene.step(1e-2, 2);
  EXPECT_NEAR(scene.pose(link.b).position.x, 0.01, 1e-6);
}

// One particle is held, the other one falls.
TEST(Mouse, FixParticlePerformer) {
  Scene scene;
  const std::vector<double> places{0, 0, 1, 1, 0, 1}, masses{0, 1};
  const Shape grains =
      shape_from([&](abut_shape** out) { return abut_particles_create(places.data(), masses.size(), 0.1, out); });
  const abut_part_id part = scene.place(grains, {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  const abut_geometry_id geometry = geometry_of(scene, part);
  require(abut_response_add_particles(scene.response(), geometry, masses.data(), places.data(), nullptr, 2));
  scene.step(1e-2, 10);
  const double *xyz = nullptr, *velocities = nullptr;
  std::size_t count = 0;
  require(abut_response_particles(scene.response(), geometry, &xyz, &velocities, &count));
  EXPECT_EQ(xyz[2], 1);
  EXPECT_LT(xyz[5], 0.99);
}

// The triangle that a ray meets is taken away, and then the ray meets nothing.
TEST(Mouse, RemovePrimitivePerformer) {
  sofa_names::World world;
  const abut_geometry_id mesh = world.add(sofa_names::square(), sofa_names::at(0, 0, 0));
  const abut_ray ray{{0.5, -0.5, 1}, {0, 0, -1}, 10};
  abut_query_hit hit{};
  std::size_t count = 0;
  require(abut_universe_refresh(world.get()));
  require(abut_universe_cast_ray(world.get(), &ray, nullptr, ABUT_HIT_NEAREST, &hit, 1, &count));
  ASSERT_EQ(count, 1U);
  require(abut_geometry_remove_triangles(world.get(), mesh, &hit.feature.index, 1));
  require(abut_universe_refresh(world.get()));
  require(abut_universe_cast_ray(world.get(), &ray, nullptr, ABUT_HIT_NEAREST, &hit, 1, &count));
  EXPECT_EQ(count, 0U);
}

}  // namespace
