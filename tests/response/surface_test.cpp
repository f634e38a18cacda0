// SPDX-License-Identifier: Apache-2.0
// Meshes whose vertices are bodies, or follow some. What contacts give to them is judged from outside: by the momentum
// of all, and by the work of the impulses on velocities of points that the test takes from stencils itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr double thickness = 0.02;

unsigned seed_of_test() {
  const char* const given = std::getenv("ABUT_SEED");
  const unsigned seed = given == nullptr ? std::random_device()() : static_cast<unsigned>(std::stoul(given));
  std::printf("ABUT_SEED=%u\n", seed);
  return seed;
}

Shape mesh(const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles) {
  return shape_from([&](abut_shape** out) {
    return abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, out);
  });
}

// Pairs with triangles are told by their elements, from a gap of `reach` on.
void tell_elements(const Scene& scene, double reach) {
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  policy.detail = ABUT_DETAIL_ELEMENTS;
  policy.tolerance = reach;
  policy.contact_distance = thickness;
  require(abut_policy_set(scene.universe(), 0, 0, &policy));
}

std::span<const abut_element_contact> element_contacts(const Scene& scene) {
  const abut_element_contact* first = nullptr;
  std::size_t count = 0;
  require(abut_universe_element_contacts(scene.universe(), &first, &count));
  return {first, count};
}

struct Particles {
  std::vector<double> xyz, velocities;
};
Particles particles_of(const Scene& scene, abut_geometry_id geometry) {
  const double *xyz = nullptr, *velocities = nullptr;
  std::size_t count = 0;
  require(abut_response_particles(scene.response(), geometry, &xyz, &velocities, &count));
  return {{xyz, xyz + 3 * count}, {velocities, velocities + 3 * count}};
}

Vector vector_at(const std::vector<double>& numbers, std::size_t i) {
  return {numbers.at(3 * i), numbers.at(3 * i + 1), numbers.at(3 * i + 2)};
}
Vector vector_of(const abut_vec3& v) { return {v.x, v.y, v.z}; }

// A sheet of n x n squares of a size about the origin, two triangles each.
struct Sheet {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles, pairs;  // pairs: sides and both diagonals of squares

  Sheet(std::uint32_t n, double size, double height) {
    const std::uint32_t side = n + 1;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const std::uint32_t x = i % side, y = i / side;
      xyz.insert(xyz.end(),
                 {size * (x / static_cast<double>(n) - 0.5), size * (y / static_cast<double>(n) - 0.5), height});
      if (x < n) pairs.insert(pairs.end(), {i, i + 1});
      if (y < n) pairs.insert(pairs.end(), {i, i + side});
      if (x == n || y == n) continue;
      triangles.insert(triangles.end(), {i, i + 1, i + side + 1, i, i + side + 1, i + side});
      pairs.insert(pairs.end(), {i, i + side + 1, i + 1, i + side});
    }
  }
  [[nodiscard]] std::size_t count() const { return xyz.size() / 3; }
};

// A mesh whose vertices are bodies.
abut_geometry_id add_cloth(Scene& scene, const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles,
                           const std::vector<double>& masses, const std::vector<double>& velocities = {},
                           abut_geometry_flags flags = 0) {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.motion = ABUT_MOTION_DYNAMIC;
  // Anywhere: vertices are given in the world.
  options.pose = {{3, -2, 1}, {0.8, 0, 0.6, 0}};
  abut_part_id part{};
  require(abut_part_create(scene.universe(), &options, &part));
  const abut_geometry_id cloth = scene.attach(part, mesh(xyz, triangles), {{1, 2, 3}, {0.6, 0.8, 0, 0}}, flags);
  require(abut_response_add_particles(scene.response(), cloth, masses.data(), xyz.data(),
                                      velocities.empty() ? nullptr : velocities.data(), masses.size()));
  return cloth;
}
void tie(const Scene& scene, abut_geometry_id cloth, const std::vector<std::uint32_t>& pairs, double stiffness,
         double damping) {
  const std::size_t count = pairs.size() / 2;
  const std::vector<double> stiff(count, stiffness), damped(count, damping);
  require(
      abut_response_add_springs(scene.response(), cloth, pairs.data(), stiff.data(), damped.data(), nullptr, count));
}

// What impulses at points do to a box, by its closed form: velocities before and after.
struct Box {
  double mass = 1;
  Vector half{0.5, 0.4, 0.3};
  abut_pose pose{};
  abut_velocity before{}, after{};

  void push(const Vector& impulse, const Vector& point) {
    const Vector moment = cross(point - vector_of(pose.position), impulse);
    // Into the frame of the box, where its inertia is diagonal, and back.
    const std::array<Vector, 3> axes = axes_of(pose.orientation);
    const std::array<double, 3> moments{half.y * half.y + half.z * half.z, half.x * half.x + half.z * half.z,
                                        half.x * half.x + half.y * half.y};
    Vector gain{};
    for (std::size_t i = 0; i < 3; ++i) gain = gain + (3 / mass / moments.at(i) * dot(axes.at(i), moment)) * axes.at(i);
    after = {sum(after.linear, 1 / mass * impulse), sum(after.angular, gain)};
  }
  // The mean of the velocities of a point before and after.
  [[nodiscard]] Vector at(const Vector& point) const {
    const Vector arm = point - vector_of(pose.position);
    return 0.5 * (vector_of(before.linear) + cross(vector_of(before.angular), arm) + vector_of(after.linear) +
                  cross(vector_of(after.angular), arm));
  }

 private:
  static abut_vec3 sum(const abut_vec3& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  static std::array<Vector, 3> axes_of(const abut_quat& q) {
    const Vector v{q.x, q.y, q.z};
    const auto turned = [&](const Vector& e) { return e + 2 * q.w * cross(v, e) + 2 * cross(v, cross(v, e)); };
    return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
  }
};

// A mesh without gravity, which is thrown at a box that turns.
struct Thrown {
  Scene scene;
  abut_part_id part{};
  Box box;
  abut_energy before{};

  Thrown(abut_solver solver, std::mt19937& random)
      : scene([&](abut_response_options& its) {
          its.gravity = {0, 0, 0};
          its.solver = solver;
          its.tolerance = 1e-15;
          // Sweeps converge slowly.
          its.most_rounds = solver == ABUT_SOLVER_SWEEPS ? 100'000 : 100;
        }) {
    std::uniform_real_distribution<double> any(-1, 1);
    tell_elements(scene, 0.4);
    scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.4; });
    const abut_quat q{1, 0.1 * any(random), 0.1 * any(random), any(random)};
    const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    box.mass = 1 + 0.5 * any(random);
    box.pose = {{0.1 * any(random), 0.1 * any(random), 0}, {q.w / size, q.x / size, q.y / size, q.z / size}};
    box.before = box.after = {{any(random), any(random), 0}, {any(random), any(random), any(random)}};
    part = scene.body(block(0.5, 0.4, 0.3), box.pose, box.mass, box.before);
  }
  // After a step: what impulses did to the box, and the largest part of their work on the weights `weights_of` gives.
  template <class VelocityOf>
  void expect_laws(const VelocityOf& velocity_of, abut_geometry_id mesh) {
    const std::span<const abut_element_contact> stencils = element_contacts(scene);
    const std::span<const abut_response_contact> contacts = scene.contacts();
    ASSERT_EQ(stencils.size(), contacts.size());
    for (const abut_response_contact& its : contacts)
      box.push((its.geometry_a.slot == mesh.slot ? 1.0 : -1.0) * vector_of(its.impulse), vector_of(its.point));
    double work = 0, size = before.kinetic;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const bool is_mesh_a = contacts[k].geometry_a.slot == mesh.slot;
      // b less a, of which the weights of the stencil have the signs.
      Vector velocity = (is_mesh_a ? 1.0 : -1.0) * box.at(vector_of(contacts[k].point));
      const abut_stencil& stencil = stencils[k].stencil;
      for (std::size_t i = 0; i < 4; ++i) {
        if (stencil.weights[i] != 0 && (i < stencil.of_a) == is_mesh_a)
          velocity = velocity + stencil.weights[i] * velocity_of(stencil.vertices[i]);
      }
      const double one = dot(vector_of(contacts[k].impulse), velocity);
      work += one;
      size += std::fabs(one);
      if (contacts[k].state != ABUT_CONTACT_STATE_OPEN)
        (stencil.kind == ABUT_STENCIL_EDGE_EDGE ? of_edges : of_vertices)++;
    }
    const abut_energy after = scene.energy();
    EXPECT_NEAR(after.kinetic - before.kinetic, work, 1e-14 * size);
    const auto expect_same = [](const abut_vec3& a, const abut_vec3& b) {
      EXPECT_LT(length(vector_of(a) - vector_of(b)), 1e-14 * (1 + length(vector_of(b))));
    };
    expect_same(after.linear_momentum, before.linear_momentum);
    expect_same(after.angular_momentum, before.angular_momentum);
    for (const abut_response_contact& its : contacts)
      EXPECT_TRUE(its.state == ABUT_CONTACT_STATE_OPEN || its.normal_velocity > -its.distance / step - 1e-9);
  }

  static constexpr double step = 0.04;
  static inline std::size_t of_edges = 0, of_vertices = 0;
};

// Momentum is kept to the last digits. The energy that all gain is the work of the impulses, by the weights of the
// stencils. So the ways from velocities to contacts and back are exact transposes.
TEST(Surface, GivesBackByTheWeightsOfItsStencils) {
  std::mt19937 random(seed_of_test());
  std::uniform_real_distribution<double> any(-1, 1);
  Thrown::of_edges = Thrown::of_vertices = 0;
  for (int round = 0; round < 8; ++round) {
    Thrown its(round % 2 == 0 ? ABUT_SOLVER_NEWTON : ABUT_SOLVER_SWEEPS, random);
    Sheet sheet(3, 1.2, 0.6);
    std::vector<double> masses, velocities;
    for (std::size_t i = 0; i < sheet.count(); ++i) {
      sheet.xyz[3 * i + 2] += 0.04 * any(random);
      masses.push_back(std::pow(10, any(random)));
      velocities.insert(velocities.end(), {any(random), any(random), -6 + any(random)});
    }
    const abut_geometry_id cloth = add_cloth(its.scene, sheet.xyz, sheet.triangles, masses, velocities);
    its.before = its.scene.energy();
    its.scene.step(Thrown::step);
    const Particles after = particles_of(its.scene, cloth);
    its.expect_laws([&](std::size_t i) { return 0.5 * (vector_at(velocities, i) + vector_at(after.velocities, i)); },
                    cloth);
    ASSERT_FALSE(::testing::Test::HasFailure()) << round;
  }
  EXPECT_GT(Thrown::of_edges, 0U);
  EXPECT_GT(Thrown::of_vertices, 0U);
}

// The same where each vertex of a sheet is a mean of the corners of a tetrahedron of particles.
TEST(Surface, GivesToItsCarrierByBarycentricWeights) {
  std::mt19937 random(seed_of_test());
  std::uniform_real_distribution<double> any(-1, 1);
  Thrown::of_edges = Thrown::of_vertices = 0;
  for (int round = 0; round < 8; ++round) {
    Thrown its(round % 2 == 0 ? ABUT_SOLVER_NEWTON : ABUT_SOLVER_SWEEPS, random);
    const std::vector<double> corners{-1, -1, 0.6, 2, -1, 0.5, -1, 2, 0.6, 0, 0, 1.6};
    std::vector<double> masses, velocities;
    for (std::size_t i = 0; i < 4; ++i) {
      masses.push_back(std::pow(10, any(random)));
      velocities.insert(velocities.end(), {any(random), any(random), -6 + any(random)});
    }
    const Shape points =
        shape_from([&](abut_shape** out) { return abut_particles_create(corners.data(), 4, 0.01, out); });
    const abut_part_id part = its.scene.place(points, {{7, 8, 9}, no_turn}, ABUT_MOTION_DYNAMIC);
    abut_geometry_id carrier{};
    std::size_t found = 0;
    require(abut_part_geometries(its.scene.universe(), part, &carrier, 1, &found));
    require(abut_response_add_particles(its.scene.response(), carrier, masses.data(), corners.data(), velocities.data(),
                                        4));
    const Sheet sheet(3, 1.2, 0);
    const abut_geometry_id skin = its.scene.attach(part, mesh(sheet.xyz, sheet.triangles), {{1, 1, 1}, no_turn});
    std::vector<std::uint32_t> numbers;
    std::vector<double> weights;
    for (std::size_t i = 0; i < sheet.count(); ++i) {
      numbers.insert(numbers.end(), {0, 1, 2, 3});
      const double up = 0.01 * any(random), second = (1 + sheet.xyz[3 * i]) / 3, third = (1 + sheet.xyz[3 * i + 1]) / 3;
      weights.insert(weights.end(), {1 - up - second - third, second, third, up});
    }
    require(
        abut_response_map_vertices(its.scene.response(), skin, carrier, numbers.data(), weights.data(), sheet.count()));
    its.before = its.scene.energy();
    its.scene.step(Thrown::step);
    const Particles after = particles_of(its.scene, carrier);
    const auto mean_of = [&](const std::vector<double>& vectors, std::size_t vertex) {
      Vector out{};
      for (std::size_t i = 0; i < 4; ++i) out = out + weights[4 * vertex + i] * vector_at(vectors, i);
      return out;
    };
    its.expect_laws([&](std::size_t i) { return 0.5 * (mean_of(velocities, i) + mean_of(after.velocities, i)); }, skin);
    // The mesh has gone with them.
    const double* xyz = nullptr;
    std::size_t count = 0;
    require(abut_geometry_vertices(its.scene.universe(), skin, &xyz, &count));
    ASSERT_EQ(count, sheet.count());
    for (std::size_t i = 0; i < count; ++i) {
      const Vector place = mean_of(after.xyz, i) - Vector{8, 9, 10};
      EXPECT_LT(length(place - vector_at({xyz, xyz + 3 * count}, i)), 1e-13) << i;
    }
    ASSERT_FALSE(::testing::Test::HasFailure()) << round;
  }
  EXPECT_GT(Thrown::of_edges, 0U);
  EXPECT_GT(Thrown::of_vertices, 0U);
}

// A mesh that meets itself: two triangles of one mesh fly at each other, by faces and by edges.
TEST(Surface, MeetsItself) {
  for (const bool is_by_edges : {false, true}) {
    Scene scene([](abut_response_options& its) {
      its.gravity = {0, 0, 0};
      its.tolerance = 1e-13;
    });
    tell_elements(scene, 0.3);
    std::vector<double> xyz{-1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, 0.2, 1, 0, 1.2, 0, 1, 1.2};
    if (is_by_edges) xyz = {-1, 0, 0, 1, 0, 0, 0, 0, -1, 0, -1, 0.2, 0, 1, 0.2, 0, 0, 1.2};
    const std::vector<double> down{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -4, 0, 0, -4, 0, 0, -4};
    add_cloth(scene, xyz, {0, 1, 2, 3, 4, 5}, {1, 2, 3, 2, 1, 4}, down, ABUT_GEOMETRY_SELF_PAIRS);
    const abut_energy before = scene.energy();
    scene.step(0.1);
    ASSERT_EQ(scene.contacts().size(), 1U);
    EXPECT_EQ(element_contacts(scene)[0].stencil.kind, is_by_edges ? ABUT_STENCIL_EDGE_EDGE : ABUT_STENCIL_VERTEX_FACE);
    // They come as near as their thickness.
    EXPECT_NEAR(scene.contacts()[0].normal_velocity, -(0.2 - thickness) / 0.1, 1e-11);
    const abut_energy after = scene.energy();
    EXPECT_NEAR(after.linear_momentum.z, before.linear_momentum.z, 1e-12);
    EXPECT_NEAR(after.angular_momentum.x, before.angular_momentum.x, 1e-12);
    EXPECT_NEAR(after.angular_momentum.y, before.angular_momentum.y, 1e-12);
    EXPECT_LT(after.kinetic, before.kinetic);
  }
}

// How deep points of the triangles lie in a box that is centred at the origin; negative: above.
double depth_in(const Vector& half, const std::vector<double>& xyz, const std::vector<std::uint32_t>& triangles) {
  constexpr int cells = 24;
  double deepest = -1e9;
  for (std::size_t first = 0; first < triangles.size(); first += 3) {
    const Vector a = vector_at(xyz, triangles[first]), b = vector_at(xyz, triangles[first + 1]),
                 c = vector_at(xyz, triangles[first + 2]);
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; i + j <= cells; ++j) {
        const Vector p = a + i / static_cast<double>(cells) * (b - a) + j / static_cast<double>(cells) * (c - a);
        deepest =
            std::max(deepest, std::min({half.x - std::fabs(p.x), half.y - std::fabs(p.y), half.z - std::fabs(p.z)}));
      }
    }
  }
  return deepest;
}

// All corners of the two triangles lie beside the box, so that only faces and edges hold them.
TEST(Surface, TwoTrianglesRestOnABox) {
  Scene scene;
  tell_elements(scene, 0.1);
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.6; });
  const Vector half{0.25, 0.25, 0.25};
  scene.place(block(half.x, half.y, half.z), {{0, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  const Sheet sheet(1, 1.2, 0.5);
  const abut_geometry_id cloth = add_cloth(scene, sheet.xyz, sheet.triangles, {0.1, 0.1, 0.1, 0.1});
  tie(scene, cloth, sheet.pairs, 500, 0.5);
  for (int i = 0; i < 600; ++i) {
    scene.step(5e-3);
    ASSERT_LT(depth_in(half, particles_of(scene, cloth).xyz, sheet.triangles), -0.9 * thickness) << i;
  }
  // Two triangles swing about their common edge, which implicit steps damp.
  scene.step(2e-2, 1500);
  EXPECT_LT(depth_in(half, particles_of(scene, cloth).xyz, sheet.triangles), -0.9 * thickness);
  EXPECT_LT(scene.energy().kinetic, 1e-8);
  double force = 0;
  for (const abut_response_contact& contact : scene.contacts())
    force += (contact.geometry_a.slot == cloth.slot ? -1 : 1) * contact.force.z;
  EXPECT_NEAR(force, 0.4 * gravity, 1e-4);
}

// A cube of six tetrahedra stands on a box that none of its corners meets. A sheet that is finer than its lower face
// follows them.
TEST(Surface, CarriesASoftCube) {
  Scene scene;
  tell_elements(scene, 0.1);
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.6; });
  const Vector half{0.15, 0.15, 0.25};
  scene.place(block(half.x, half.y, half.z), {{0, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  std::vector<double> corners;
  for (std::uint32_t i = 0; i < 8; ++i)
    corners.insert(corners.end(), {0.5 * (i % 2) - 0.25, 0.5 * (i / 2 % 2) - 0.25, 0.3 + 0.5 * (i / 4)});
  const Shape points =
      shape_from([&](abut_shape** out) { return abut_particles_create(corners.data(), 8, 0.01, out); });
  const abut_part_id part = scene.place(points, {{0, 0, 0}, no_turn}, ABUT_MOTION_DYNAMIC);
  abut_geometry_id carrier{};
  std::size_t found = 0;
  require(abut_part_geometries(scene.universe(), part, &carrier, 1, &found));
  const std::vector<double> masses(8, 0.1);
  require(abut_response_add_particles(scene.response(), carrier, masses.data(), corners.data(), nullptr, 8));
  abut_elastic_options elastic;
  abut_elastic_options_init(&elastic, sizeof elastic);
  elastic.young = 1e4;
  elastic.damping = 0.01;
  const std::array<std::uint32_t, 24> tetrahedra{0, 1, 3, 7, 0, 1, 5, 7, 0, 2, 3, 7,
                                                 0, 2, 6, 7, 0, 4, 5, 7, 0, 4, 6, 7};
  require(abut_response_add_tetrahedra(scene.response(), carrier, tetrahedra.data(), 6, &elastic));
  const Sheet sheet(4, 1, 0);
  const abut_geometry_id skin = scene.attach(part, mesh(sheet.xyz, sheet.triangles), {{0, 0, 0}, no_turn});
  std::vector<std::uint32_t> numbers;
  std::vector<double> weights;
  for (std::size_t i = 0; i < sheet.count(); ++i) {
    const double u = sheet.xyz[3 * i] + 0.5, v = sheet.xyz[3 * i + 1] + 0.5;
    numbers.insert(numbers.end(), {0, 1, 2, 3});
    weights.insert(weights.end(), {1 - std::max(u, v), std::max(u - v, 0.0), std::max(v - u, 0.0), std::min(u, v)});
  }
  require(abut_response_map_vertices(scene.response(), skin, carrier, numbers.data(), weights.data(), sheet.count()));
  for (int i = 0; i < 300; ++i) {
    scene.step(5e-3);
    const double* xyz = nullptr;
    std::size_t count = 0;
    require(abut_geometry_vertices(scene.universe(), skin, &xyz, &count));
    ASSERT_LT(depth_in(half, {xyz, xyz + 3 * count}, sheet.triangles), -0.9 * thickness) << i;
  }
  EXPECT_LT(scene.energy().kinetic, 1e-8);
  double force = 0;
  for (const abut_response_contact& contact : scene.contacts()) {
    EXPECT_NE(contact.geometry_a.slot, carrier.slot);
    EXPECT_NE(contact.geometry_b.slot, carrier.slot);
    force += (contact.geometry_a.slot == skin.slot ? -1 : 1) * contact.force.z;
  }
  EXPECT_NEAR(force, 0.8 * gravity, 1e-5);
}

// A ball has no elements: its contacts with triangles push their corners.
TEST(Surface, LiesOverABall) {
  constexpr double radius = 0.5;
  Scene scene({}, 0.02);
  tell_elements(scene, 0.1);
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.8; });
  scene.place(ball(radius), {{0, 0, 0}, no_turn}, ABUT_MOTION_STATIC);
  const Sheet sheet(4, 1.2, 0.6);
  const abut_geometry_id cloth = add_cloth(scene, sheet.xyz, sheet.triangles, std::vector<double>(sheet.count(), 0.01));
  tie(scene, cloth, sheet.pairs, 100, 0.05);
  double last = total_energy(scene);
  for (int i = 0; i < 200; ++i) {
    scene.step(5e-3);
    const double now = total_energy(scene);
    ASSERT_LE(now, last + 1e-6) << i;
    last = now;
    for (const abut_response_island& island : scene.islands()) ASSERT_EQ(island.residuals.is_converged, 1U) << i;
  }
  const std::vector<double> at = particles_of(scene, cloth).xyz;
  double nearest = 1, lowest = 1;
  for (std::size_t i = 0; i < sheet.count(); ++i) {
    nearest = std::min(nearest, length(vector_at(at, i)));
    lowest = std::min(lowest, at[3 * i + 2]);
  }
  EXPECT_GT(nearest, radius + 0.9 * thickness);
  EXPECT_LT(lowest, 0.4);
}

}  // namespace
