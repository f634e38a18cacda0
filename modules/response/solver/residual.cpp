// SPDX-License-Identifier: Apache-2.0
// What the law is missed by. The natural map of the law with de Saxce's shift: Acary, Bremond, Huber, "On solving
// contact problems with Coulomb friction" (2018), https://inria.hal.science/hal-01630836.
module;

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// Sums of a few numbers of one size are off by less than this part of them.
constexpr double rounding = 1e-15;
// A number and its neighbours are apart by up to half of this part of it.
constexpr double last_digits = 4.5e-16;

[[nodiscard]] double dot(const Row& a, const Row& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// The larger of two, or what is no number.
[[nodiscard]] double larger(double a, double b) { return b <= a ? a : b; }

// Each summand as `size` takes it.
template <class Size>
void sum_elements(const Problem& problem, const std::vector<Row>& velocities, std::vector<Row>& sums,
                  const Size& size) {
  for (const Element& element : problem.elements) {
    const std::size_t rows = 3 * std::size_t{element.count};
    for (std::size_t i = 0; i < rows; ++i) {
      if (element.bodies[i / 3] == no_body) continue;
      double sum = size(element.impulse[i]);
      for (std::size_t j = 0; j < rows; ++j) {
        const std::uint32_t body = element.bodies[j / 3];
        if (body != no_body) sum += size(-element.change[rows * i + j] * velocities[body][j % 3]);
      }
      sums[element.bodies[i / 3]][i % 3] += sum;
    }
  }
}

}  // namespace

Triple relative_velocity(const ContactRows& contact, const std::vector<Row>& velocities) {
  Triple u = contact.drift;
  for (const BodyRows& its : contact.bodies) {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += dot(its.rows[i], velocities[its.body]);
  }
  return u;
}

void add_impulse(const ContactRows& contact, const Triple& impulse, std::vector<Row>& sums) {
  for (const BodyRows& its : contact.bodies) {
    Row& sum = sums[its.body];
    for (std::size_t i = 0; i < impulse.size(); ++i) {
      for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += its.rows[i][j] * impulse[i];
    }
  }
}

// By the factors L D L^T of the inertia.
Row velocity_of_impulse(const BodyMass& body, const Row& impulse) {
  const std::array<double, 9>& m = body.inertia;
  const double l10 = m[3] / m[0], l20 = m[6] / m[0];
  const double d1 = m[4] - l10 * m[3], rest = m[7] - l20 * m[3], l21 = rest / d1;
  const double d2 = m[8] - l20 * m[6] - l21 * rest;
  const double y0 = impulse[3], y1 = impulse[4] - l10 * y0, y2 = impulse[5] - l20 * y0 - l21 * y1;
  const double z = y2 / d2, y = y1 / d1 - l21 * z, x = y0 / m[0] - l10 * y - l20 * z;
  return {impulse[0] / body.mass, impulse[1] / body.mass, impulse[2] / body.mass, x, y, z};
}

Triple diagonal_of(const ContactRows& contact, const std::vector<BodyMass>& bodies) {
  Triple out{};
  for (const BodyRows& its : contact.bodies) {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] += dot(its.rows[i], velocity_of_impulse(bodies[its.body], its.rows[i]));
  }
  return out;
}

double weight_of(const ContactRows& contact, const std::vector<BodyMass>& bodies) {
  const Triple diagonal = diagonal_of(contact, bodies);
  return (diagonal[0] + diagonal[1] + diagonal[2]) / 3;
}

std::vector<Row> velocities_of(const Problem& problem, const std::vector<Triple>& impulses) {
  std::vector<Row> sums(problem.bodies.size()), out = problem.free;
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) add_impulse(problem.contacts[k], impulses[k], sums);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Row change = velocity_of_impulse(problem.bodies[i], sums[i]);
    for (std::size_t j = 0; j < change.size(); ++j) out[i][j] += change[j];
  }
  return out;
}

void add_elements(const Problem& problem, const std::vector<Row>& velocities, std::vector<Row>& sums) {
  sum_elements(problem, velocities, sums, [](double number) { return number; });
}

std::vector<Row> sizes_of(const Problem& problem, const Solution& solution) {
  std::vector<Row> out(problem.bodies.size());
  const auto absolute = [](auto& numbers) {
    for (double& number : numbers) number = std::fabs(number);
  };
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    ContactRows sizes = problem.contacts[k];
    Triple impulse = solution.impulses[k];
    absolute(impulse);
    for (BodyRows& its : sizes.bodies) std::ranges::for_each(its.rows, absolute);
    add_impulse(sizes, impulse, out);
  }
  sum_elements(problem, solution.velocities, out, [](double number) { return std::fabs(number); });
  for (const Element& element : problem.elements) {
    for (std::uint32_t i = 0; i < element.count; ++i) {
      if (element.bodies[i] == no_body) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) out[element.bodies[i]][axis] += element.size;
    }
  }
  return out;
}

Residuals residuals_of(const Problem& problem, const Solution& solution) {
  Residuals out;
  std::vector<Row> pushed(problem.bodies.size());
  const std::vector<Row> size = sizes_of(problem, solution);
  add_elements(problem, solution.velocities, pushed);
  for (std::size_t k = 0; k < problem.contacts.size(); ++k) {
    const ContactRows& contact = problem.contacts[k];
    const Triple& impulse = solution.impulses[k];
    add_impulse(contact, impulse, pushed);
    Triple u = relative_velocity(contact, solution.velocities);
    const bool is_hold = contact.law == Law::hold;
    if (is_hold) {
      for (std::size_t i = 0; i < 2; ++i) u[i] += contact.compliance * impulse[i];
    }
    u[2] += contact.compliance * impulse[2] + contact.friction * norm_of(u[0], u[1]);
    // A hold that yields does work against its largest impulse.
    const double size_of_impulse = norm_of(impulse[0], impulse[1], impulse[2]);
    const bool yields = is_hold && size_of_impulse >= contact.most;
    out.dissipation += std::fabs(u[0] * impulse[0] + u[1] * impulse[1] + u[2] * impulse[2] +
                                 (yields ? size_of_impulse * norm_of(u[0], u[1], u[2]) : 0));
    Triple moved;
    for (std::size_t i = 0; i < u.size(); ++i) moved[i] = impulse[i] - u[i] / contact.weight;
    const Triple nearest = allowed(contact, moved);
    const double missed =
        contact.weight * norm_of(nearest[0] - impulse[0], nearest[1] - impulse[1], nearest[2] - impulse[2]);
    out.contact = larger(out.contact, missed);
    const double unavoidable = is_hold ? rounding * (norm_of(contact.drift[0], contact.drift[1], contact.drift[2]) +
                                                     contact.compliance * size_of_impulse)
                                       : rounding * (std::fabs(contact.offset) + contact.compliance * impulse[2]);
    // Impulses are numbers of so many digits: between very different masses, the next one moves the light body.
    const double left = missed - unavoidable;
    if (!(left <= last_digits * contact.weight * size_of_impulse)) out.excess = larger(out.excess, left);
  }
  for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
    const BodyMass& body = problem.bodies[i];
    Row rest, unavoidable;
    const Row change = velocity_of_impulse(body, pushed[i]);
    for (std::size_t j = 0; j < rest.size(); ++j) {
      rest[j] = solution.velocities[i][j] - problem.free[i][j] - change[j];
      unavoidable[j] = rounding * size[i][j];
    }
    // |rest| in the metric of the mass, over the square root of the mass: turns count by the radius of gyration.
    const auto speed = [&](const Row& v) {
      double turn = 0;
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) turn += v[3 + r] * body.inertia[3 * r + c] * v[3 + c];
      }
      return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + std::max(turn, 0.0) / body.mass);
    };
    const double missed = speed(rest);
    out.motion = larger(out.motion, missed);
    out.excess = larger(out.excess, missed - speed(velocity_of_impulse(body, unavoidable)));
  }
  return out;
}

}  // namespace abut::response
