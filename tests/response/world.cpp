// SPDX-License-Identifier: Apache-2.0
#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace response_test {

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vector& a) { return std::sqrt(dot(a, a)); }

namespace {

Vector vector_at(const std::vector<double>& numbers, std::size_t place) {
  return {numbers.at(place), numbers.at(place + 1), numbers.at(place + 2)};
}
void append(std::vector<double>& numbers, const Vector& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }
Vector divide(const Vector& a, const Vector& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
Vector turn(const Vector& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}

}  // namespace

Body box(double mass, const Vector& half, const Vector& centre) {
  const double x = half.x * half.x, y = half.y * half.y, z = half.z * half.z;
  return {mass, mass / 3 * Vector{y + z, x + z, x + y}, centre, {}, {}};
}

Vector Answer::linear(std::size_t body) const { return vector_at(velocities, 6 * body); }
Vector Answer::angular(std::size_t body) const { return vector_at(velocities, 6 * body + 3); }
Vector Answer::impulse(std::size_t contact) const { return vector_at(impulses, 3 * contact); }

std::uint32_t World::add(const Body& body) {
  bodies.push_back(body);
  return static_cast<std::uint32_t>(bodies.size() - 1);
}

void World::fall(const Vector& acceleration, double step) {
  for (Body& body : bodies) body.linear = body.linear + step * acceleration;
}

Answer World::solve(const abut_solver_options* options, const Answer* start) const {
  std::vector<double> masses, inertias, centres, free, points, normals, frictions, compliances, offsets, surfaces;
  std::vector<std::uint32_t> sides;
  for (const Body& body : bodies) {
    masses.push_back(body.mass);
    inertias.insert(inertias.end(), {body.inertia.x, 0, 0, 0, body.inertia.y, 0, 0, 0, body.inertia.z});
    append(centres, body.centre);
    append(free, body.linear);
    append(free, body.angular);
  }
  for (const Contact& contact : contacts) {
    sides.insert(sides.end(), {contact.a, contact.b});
    append(points, contact.point);
    append(normals, contact.normal);
    frictions.insert(frictions.end(), {contact.friction, contact.friction});
    compliances.push_back(contact.compliance);
    offsets.push_back(contact.offset);
    append(surfaces, contact.surface);
  }
  abut_contact_problem problem;
  abut_contact_problem_init(&problem, sizeof problem);
  problem.body_count = static_cast<std::uint32_t>(bodies.size());
  problem.contact_count = static_cast<std::uint32_t>(contacts.size());
  problem.masses = masses.data();
  problem.inertias = inertias.data();
  problem.centres = centres.data();
  problem.free_velocities = free.data();
  problem.bodies = sides.data();
  problem.points = points.data();
  problem.normals = normals.data();
  problem.frictions = frictions.data();
  problem.compliances = compliances.data();
  problem.offsets = offsets.data();
  problem.surface_velocities = surfaces.data();
  if (start != nullptr) {
    problem.first_velocities = start->velocities.data();
    problem.first_impulses = start->impulses.data();
  }
  Answer answer;
  answer.velocities.resize(6 * bodies.size());
  answer.impulses.resize(3 * contacts.size());
  answer.status = abut_contact_problem_solve(&problem, options, answer.velocities.data(), answer.impulses.data(),
                                             &answer.residuals);
  return answer;
}

Vector World::relative_velocity(const Contact& contact, const Answer& answer) const {
  const auto at = [&](std::uint32_t body) {
    if (body == ABUT_NO_BODY) return Vector{};
    return answer.linear(body) + cross(answer.angular(body), contact.point - bodies.at(body).centre);
  };
  return at(contact.b) - at(contact.a) + contact.surface;
}

double World::weight(const Contact& contact) const {
  double sum = 0;
  for (const std::uint32_t side : {contact.a, contact.b}) {
    if (side == ABUT_NO_BODY) continue;
    const Body& body = bodies.at(side);
    const Vector arm = contact.point - body.centre;
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      const Vector moment = cross(arm, axis);
      sum += 1 / body.mass + dot(moment, divide(moment, body.inertia));
    }
  }
  return sum / 3;
}

double World::worst_miss(const Answer& answer) const {
  double worst = 0;
  std::vector<Vector> pushes(bodies.size()), moments(bodies.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact& contact = contacts[k];
    const Vector impulse = answer.impulse(k), n = 1 / length(contact.normal) * contact.normal;
    for (const auto& [side, sign] : {std::pair(contact.a, -1.0), std::pair(contact.b, 1.0)}) {
      if (side == ABUT_NO_BODY) continue;
      pushes[side] = pushes[side] + sign * impulse;
      moments[side] = moments[side] + sign * cross(contact.point - bodies[side].centre, impulse);
    }
    const Vector u = relative_velocity(contact, answer);
    const double w = weight(contact), normal = dot(impulse, n);
    const double apart = dot(u, n) + contact.compliance * normal + contact.offset;
    const double normal_miss = std::fabs(normal - std::max(0.0, normal - apart / w)) * w;
    const Vector tangent = impulse - normal * n, slip = u - dot(u, n) * n;
    Vector wanted = tangent - (1 / w) * slip;
    const double limit = contact.friction * std::max(normal, 0.0), size = length(wanted);
    if (size > limit) wanted = (limit / size) * wanted;
    worst = std::max({worst, normal_miss, w * length(tangent - wanted)});
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vector miss = answer.linear(i) - bodies[i].linear - 1 / bodies[i].mass * pushes[i];
    const Vector turn_miss = answer.angular(i) - bodies[i].angular - divide(moments[i], bodies[i].inertia);
    const Vector& inertia = bodies[i].inertia;
    const double gyration = std::sqrt(std::max({inertia.x, inertia.y, inertia.z}) / bodies[i].mass);
    worst = std::max({worst, length(miss), gyration * length(turn_miss)});
  }
  return worst;
}

double World::kinetic_energy(const Answer& answer) const {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vector v = answer.linear(i), w = answer.angular(i), &inertia = bodies[i].inertia;
    sum += 0.5 * bodies[i].mass * dot(v, v);
    sum += 0.5 * (inertia.x * w.x * w.x + inertia.y * w.y * w.y + inertia.z * w.z * w.z);
  }
  return sum;
}

abut_solver_options options_of(double tolerance, std::uint32_t most_rounds, double speed) {
  abut_solver_options options;
  abut_solver_options_init(&options, sizeof options);
  options.tolerance = tolerance;
  options.most_rounds = most_rounds;
  options.speed = speed;
  return options;
}

World stack(const std::vector<double>& masses, double friction) {
  World world;
  for (const double mass : masses) {
    const auto level = static_cast<double>(world.bodies.size());
    const std::uint32_t below = world.bodies.empty() ? ABUT_NO_BODY : static_cast<std::uint32_t>(level) - 1;
    const std::uint32_t body = world.add(box(mass, {0.5, 0.5, 0.5}, {0, 0, 0.5 + level}));
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        world.contacts.push_back({.a = below, .b = body, .point = {x, y, level}, .friction = friction});
      }
    }
  }
  return world;
}

World arch(int wedges, double thickness, double friction) {
  constexpr double radius = 10, depth = 1, density = 2000;
  World world;
  const double part = std::numbers::pi / wedges, inner = radius - thickness / 2, outer = radius + thickness / 2;
  const double area = 0.5 * part * (outer * outer - inner * inner);
  const double middle = 2.0 / 3 * (outer * outer * outer - inner * inner * inner) / (outer * outer - inner * inner) *
                        std::sin(part / 2) / (part / 2);
  for (int i = 0; i < wedges; ++i) {
    const double angle = (i + 0.5) * part;
    // The wedge turns about its y axis only, so only that moment of inertia counts.
    Body wedge = box(area * depth * density, {thickness / 2, depth / 2, radius * part / 2}, {});
    wedge.centre = middle * Vector{std::cos(angle), 0, std::sin(angle)};
    world.add(wedge);
  }
  for (int i = 0; i <= wedges; ++i) {
    const double angle = i * part;
    const std::uint32_t before = i == 0 ? ABUT_NO_BODY : static_cast<std::uint32_t>(i - 1);
    const std::uint32_t after = i == wedges ? ABUT_NO_BODY : static_cast<std::uint32_t>(i);
    for (const double r : {inner, outer}) {
      for (const double y : {-depth / 2, depth / 2}) {
        world.contacts.push_back({.a = before,
                                  .b = after,
                                  .point = turn({r, y, 0}, angle),
                                  .normal = turn({0, 0, 1}, angle),
                                  .friction = friction});
      }
    }
  }
  return world;
}

}  // namespace response_test
