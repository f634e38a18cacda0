// SPDX-License-Identifier: Apache-2.0
// Contact problems for tests, and how far an answer is from the law: by formulas of its own, not those of the library.
#pragma once

#include <abut/response.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace response_test {

inline constexpr double gravity = 9.81;

struct Vector {
  double x = 0, y = 0, z = 0;
};
[[nodiscard]] Vector operator+(const Vector& a, const Vector& b);
[[nodiscard]] Vector operator-(const Vector& a, const Vector& b);
[[nodiscard]] Vector operator*(double s, const Vector& a);
[[nodiscard]] double dot(const Vector& a, const Vector& b);
[[nodiscard]] Vector cross(const Vector& a, const Vector& b);
[[nodiscard]] double length(const Vector& a);

// A body whose principal axes are those of the world.
struct Body {
  double mass = 1;
  Vector inertia{1, 1, 1};
  Vector centre{};
  Vector linear{}, angular{};  // velocities of the free motion
};
[[nodiscard]] Body box(double mass, const Vector& half, const Vector& centre);

struct Contact {
  std::uint32_t a = ABUT_NO_BODY, b = 0;
  Vector point{}, normal{0, 0, 1};
  double friction = 0, compliance = 0, offset = 0;
  Vector surface{};
};

struct Answer {
  abut_status status = ABUT_OK;
  std::vector<double> velocities, impulses;
  abut_residuals residuals{};

  [[nodiscard]] Vector linear(std::size_t body) const;
  [[nodiscard]] Vector angular(std::size_t body) const;
  [[nodiscard]] Vector impulse(std::size_t contact) const;
};

struct World {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;

  std::uint32_t add(const Body& body);
  // Velocities of the free motion gain acceleration * step.
  void fall(const Vector& acceleration, double step);
  [[nodiscard]] Answer solve(const abut_solver_options* options = nullptr, const Answer* start = nullptr) const;
  [[nodiscard]] Vector relative_velocity(const Contact& contact, const Answer& answer) const;
  // Velocity by which the worst body misses its equation of motion, or the worst contact its law. The law is that of
  // Alart and Curnier: a projection on the half-line of normal impulses, and on the disc of friction.
  [[nodiscard]] double worst_miss(const Answer& answer) const;
  [[nodiscard]] double kinetic_energy(const Answer& answer) const;
  [[nodiscard]] double weight(const Contact& contact) const;
};

[[nodiscard]] abut_solver_options options_of(double tolerance, std::uint32_t most_rounds, double speed = 0);

// Ten boxes of 1 m on the ground, four contacts under each; masses from below.
[[nodiscard]] World stack(const std::vector<double>& masses, double friction);
// A half circle of wedges of 1 m depth, radius 10 of the middle line.
[[nodiscard]] World arch(int wedges, double thickness, double friction);

}  // namespace response_test
