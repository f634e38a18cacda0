// SPDX-License-Identifier: Apache-2.0
// Contact response: a ball on the ground, and one on top of it.
#include <abut/response.hpp>
#include <gtest/gtest.h>

namespace {

TEST(ContactProblem, CarriesAStackOfTwo) {
  abut::ContactProblem problem;
  constexpr std::array<double, 9> inertia{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const abut::Velocity falling{{0, 0, -0.1}, {0, 0, 0}};
  const std::uint32_t lower = problem.add_body(1, inertia, {0, 0, 1}, falling);
  const std::uint32_t upper = problem.add_body(100, inertia, {0, 0, 3}, falling);
  abut::ProblemContact contact;
  contact.b = lower;
  contact.friction = 0.5;
  problem.add_contact(contact);
  contact.a = lower;
  contact.b = upper;
  contact.point = {0, 0, 2};
  problem.add_contact(contact);
  const abut::ContactSolution solution =
      problem.solve(abut::SolverOptions().with_tolerance(1e-10).with_most_rounds(50));
  EXPECT_EQ(solution.residuals.is_converged, 1U);
  EXPECT_NEAR(solution.impulses[0].z, 10.1, 1e-8);
  EXPECT_NEAR(solution.impulses[1].z, 10, 1e-8);
  EXPECT_NEAR(solution.velocities[1].linear.z, 0, 1e-10);
  EXPECT_EQ(problem.solve(abut::SolverOptions().with_speed(1), &solution).residuals.rounds, 0U);
  contact.b = 7;
  problem.add_contact(contact);
  EXPECT_THROW(static_cast<void>(problem.solve()), abut::Error);
}

TEST(Response, CarriesABallOnTheGround) {
  abut::Universe universe(abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN));
  const abut::GeometryOptions touching = abut::GeometryOptions().with_tolerance(1e-3);
  const abut::PartId ground = universe.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC));
  universe.create_geometry(ground, abut::Shape::plane({0, 0, 1}, 0), touching);
  const abut::Shape ball = abut::Shape::sphere(0.5);
  const abut::PartId part = universe.create_part(abut::PartOptions().with_pose(abut::pose({0, 0, 0.5})));
  universe.create_geometry(part, ball, touching);
  abut::Response response(universe, abut::ResponseOptions().with_slop(1e-6).with_most_rounds(20).with_tolerance(1e-10));
  const double mass = abut::mass_properties(ball, 500).mass;
  response.add_body(part, abut::BodyOptions().with_density(500));
  EXPECT_EQ(response.body(part).mass, mass);
  response.step(0.01);
  ASSERT_EQ(response.contacts().size(), 1U);
  EXPECT_NEAR(response.contacts()[0].force.z, mass * 9.81, 1e-6 * mass);
  EXPECT_EQ(response.islands()[0].residuals.is_converged, 1U);
  EXPECT_NEAR(response.energy().potential, mass * 9.81 * 0.5, 1e-3);
  response.set_options(abut::ResponseOptions().with_gravity({0, 0, 0}));
  response.apply_force(part, {0, 0, mass});
  response.apply_force(part, {mass, 0, 0}, {0, 0, 0.5});
  response.apply_torque(part, {0, 0, 1});
  response.step(1);
  EXPECT_NEAR(universe.velocity(part).velocity.linear.z, 1, 1e-9);
  EXPECT_NEAR(universe.velocity(part).velocity.linear.x, 1, 1e-9);
  abut::MassProperties given = response.body(part);
  given.mass = 3;
  const std::vector<abut::PartId> parts{part};
  response.add_bodies(parts, abut::BodyOptions().with_mass(given));
  EXPECT_EQ(response.body(part).mass, 3);
  response.set_contact_callback([](const abut::Contact&, abut_contact_material&) -> bool { throw 7; });
  universe.set_pose(part, abut::pose({0, 0, 0.5}));
  EXPECT_THROW(response.step(0.01), int);
  response.set_contact_callback({});
  response.remove_body(part);
  EXPECT_THROW(response.remove_body(part), abut::Error);
}

TEST(Response, HangsParticlesOnSprings) {
  abut::Universe universe(abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN));
  const std::vector<double> corners{0, 0, 5, 1, 0, 5, 0, 1, 5, 0, 0, 4};
  const abut::PartId part = universe.create_part(abut::PartOptions());
  const abut::GeometryId geometry = universe.create_geometry(part, abut::Shape::particles(corners, 0.1));
  abut::Response response(universe);
  response.add_particles(geometry, std::vector<double>{0, 0, 0, 2}, corners);
  const std::vector<std::uint32_t> pair{0, 3};
  response.add_springs(geometry, pair, std::vector<double>{100}, std::vector<double>{30});
  for (int i = 0; i < 400; ++i) response.step(0.02);
  EXPECT_NEAR(response.particles(geometry).first[11], 4 - 2 * 9.81 / 100, 1e-9);
  response.add_tetrahedra(geometry, std::vector<std::uint32_t>{0, 1, 2, 3},
                          abut::ElasticOptions().with_young(1e4).with_poisson(0.2).with_damping(0.01));
  response.step(0.02);
  EXPECT_EQ(response.islands()[0].residuals.is_converged, 1U);
  EXPECT_THROW(response.add_springs(geometry, pair, std::vector<double>{1, 2}), abut::Error);
  EXPECT_THROW(response.add_tetrahedra(geometry, std::vector<std::uint32_t>{0, 1, 2}), abut::Error);
}

TEST(Response, LetsAMeshFollowParticles) {
  abut::Universe universe(abut::UniverseOptions().with_tolerance_mode(ABUT_TOLERANCE_MARGIN));
  const std::vector<double> corners{0, 0, 5, 1, 0, 5, 0, 1, 5, 0, 0, 6};
  const abut::PartId part = universe.create_part(abut::PartOptions());
  const abut::GeometryId soft = universe.create_geometry(part, abut::Shape::particles(corners, 0.1));
  const std::vector<std::uint32_t> face{0, 1, 2}, numbers{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  const abut::GeometryId skin = universe.create_geometry(part, abut::Shape::mesh(corners, face));
  abut::Response response(universe);
  response.add_particles(soft, std::vector<double>(4, 1), corners);
  const std::vector<double> weights{0.25, 0.25, 0.25, 0.25, 0.5, 0.5, 0, 0, 0, 0, 0, 1};
  response.map_vertices(skin, soft, numbers, weights);
  response.step(0.1);
  EXPECT_NEAR(universe.vertices(skin)[2], 5.25 - 0.5 * 9.81 * 0.01, 1e-12);
  EXPECT_THROW(response.map_vertices(skin, soft, numbers, std::vector<double>{1, 0, 0, 0}), abut::Error);
  response.remove_particles(skin);
}

}  // namespace
