// SPDX-License-Identifier: Apache-2.0
#include "heap.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace response_test {

namespace {

constexpr double radius = 0.1, half_width = 0.55, step = 0.005, near = 0.01;

// Where a contact was, its impulse goes on.
using Impulses = std::map<std::pair<std::uint32_t, std::uint32_t>, Vector>;

std::vector<Contact> contacts_of(const std::vector<Body>& balls, double friction) {
  std::vector<Contact> out;
  const auto add = [&](std::uint32_t a, std::uint32_t b, const Vector& point, const Vector& normal, double gap) {
    out.push_back({.a = a,
                   .b = b,
                   .point = point,
                   .normal = normal,
                   .friction = friction,
                   .offset = (gap > 0 ? gap : 0.2 * gap) / step});
  };
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    const Vector& x = balls[i].centre;
    for (const auto& [normal, gap] : {std::pair(Vector{0, 0, 1}, x.z - radius),
                                      {{1, 0, 0}, x.x + half_width - radius},
                                      {{-1, 0, 0}, half_width - x.x - radius},
                                      {{0, 1, 0}, x.y + half_width - radius},
                                      {{0, -1, 0}, half_width - x.y - radius}}) {
      if (gap < near) add(ABUT_NO_BODY, i, x - radius * normal, normal, gap);
    }
    for (std::uint32_t j = i + 1; j < balls.size(); ++j) {
      const Vector between = balls[j].centre - x;
      const double distance = length(between);
      if (distance < 2 * radius + near) {
        add(i, j, x + 0.5 * between, 1 / distance * between, distance - 2 * radius);
      }
    }
  }
  return out;
}

// Projected Gauss-Seidel sweeps on balls, whose effective masses along normals and tangents are known in closed form.
void sweep(std::vector<Body>& balls, const std::vector<Contact>& contacts, Impulses& kept) {
  Impulses now;
  const auto push = [&](const Contact& contact, const Vector& impulse) {
    for (const auto& [side, sign] : {std::pair(contact.a, -1.0), std::pair(contact.b, 1.0)}) {
      if (side == ABUT_NO_BODY) continue;
      Body& ball = balls[side];
      ball.linear = ball.linear + sign / ball.mass * impulse;
      ball.angular = ball.angular + sign / ball.inertia.x * cross(contact.point - ball.centre, impulse);
    }
  };
  // Five sides of the pit have no number of their own: the normal tells them apart.
  const auto key = [](const Contact& contact) {
    const int wall = static_cast<int>(contact.normal.x + 2 * contact.normal.y + 3 * contact.normal.z) + 10;
    return std::pair(contact.a == ABUT_NO_BODY ? 1000000U + static_cast<std::uint32_t>(wall) : contact.a, contact.b);
  };
  for (const Contact& contact : contacts) {
    const auto found = kept.find(key(contact));
    const Vector impulse = found == kept.end() ? Vector{} : found->second;
    now[key(contact)] = impulse;
    push(contact, impulse);
  }
  for (int i = 0; i < 30; ++i) {
    for (const Contact& contact : contacts) {
      Vector& impulse = now[key(contact)];
      double lightness = 0;
      Vector u;
      for (const auto& [side, sign] : {std::pair(contact.a, -1.0), std::pair(contact.b, 1.0)}) {
        if (side == ABUT_NO_BODY) continue;
        const Body& ball = balls[side];
        lightness += 1 / ball.mass;
        u = u + sign * (ball.linear + cross(ball.angular, contact.point - ball.centre));
      }
      const Vector& n = contact.normal;
      const double before = dot(impulse, n);
      const double normal = std::max(0.0, before - (dot(u, n) + contact.offset) / lightness);
      // A solid ball is 3.5 times as easily moved along its surface as along the normal.
      Vector tangent = impulse - before * n - 1 / (3.5 * lightness) * (u - dot(u, n) * n);
      const double limit = contact.friction * normal, size = length(tangent);
      if (size > limit) tangent = limit / size * tangent;
      const Vector next = normal * n + tangent;
      push(contact, next - impulse);
      impulse = next;
    }
  }
  kept = std::move(now);
}

}  // namespace

World heap(int balls, double friction, int steps, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  World world;
  for (int i = 0; i < balls; ++i) {
    const double mass = 1 + 0.5 * any(random), moment = 0.4 * mass * radius * radius;
    const int column = i % 5 - 2, row = i / 5 % 5 - 2, layer = i / 25;
    world.add({.mass = mass,
               .inertia = {moment, moment, moment},
               .centre = {0.21 * column + 0.004 * any(random), 0.21 * row + 0.004 * any(random), 0.12 + 0.21 * layer}});
  }
  Impulses kept;
  for (int i = 0; i < steps; ++i) {
    world.fall({0, 0, -gravity}, step);
    sweep(world.bodies, contacts_of(world.bodies, friction), kept);
    for (Body& ball : world.bodies) {
      ball.linear = 0.999 * ball.linear;
      ball.centre = ball.centre + step * ball.linear;
    }
  }
  world.contacts = contacts_of(world.bodies, friction);
  world.fall({0, 0, -gravity}, step);
  return world;
}

}  // namespace response_test
