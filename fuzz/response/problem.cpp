// SPDX-License-Identifier: Apache-2.0
#include "problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace response_fuzzing {

namespace {

using response_test::Body;
using response_test::Contact;
using response_test::Vector;

// Bytes that ran out are zeros.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes.begin(), bytes.end()) {}

  std::uint8_t byte() { return place_ < bytes_.size() ? bytes_[place_++] : std::uint8_t{0}; }

  // From -most to most, finely near zero: a sign, and a size.
  double number(double most) {
    const unsigned sign = byte();
    return (sign % 2 == 0 ? 1 : -1) * size(most);
  }
  // 0, or a size down to a part of 1e-12 of the most.
  double size(double most) {
    const unsigned code = byte();
    return code == 0 ? 0 : most * std::pow(10.0, -12.0 * (code - 1) / 254.0);
  }
  // From 1 / most to most.
  double ratio(double most) { return std::pow(most, byte() / 127.5 - 1); }
  Vector vector(double most) { return {number(most), number(most), number(most)}; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

// One number of the problem becomes one that is not accepted.
void spoil(Reader& from, Problem& problem) {
  constexpr double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300};
  const double number = bad[from.byte() % 3];
  Body& body = problem.world.bodies[from.byte() % problem.world.bodies.size()];
  double* places[] = {&body.mass, &body.inertia.y, &body.centre.x, &body.linear.z, &body.angular.x};
  *places[from.byte() % 5] = number;
  problem.is_valid = false;
}

}  // namespace

Problem problem_of(std::span<const std::uint8_t> bytes) {
  Reader from(bytes);
  Problem out;
  const unsigned kind = from.byte();
  const std::size_t bodies = 1 + from.byte() % 6U, contacts = from.byte() % 13U;
  out.options = response_test::options_of(1e-9, 1 + from.byte() % 100U);
  // Problems of one size, and those of masses, arms and stiffness far apart.
  const double spread = kind % 2 == 0 ? 10 : 1e6, arms = kind % 2 == 0 ? 1 : 1e3;
  for (std::size_t i = 0; i < bodies; ++i) {
    Body body;
    body.mass = from.ratio(spread);
    const double gyration = from.ratio(arms) * from.ratio(arms);
    body.inertia = body.mass * gyration * Vector{from.ratio(2), from.ratio(2), from.ratio(2)};
    body.centre = from.vector(arms);
    body.linear = from.vector(100);
    body.angular = from.vector(100);
    out.world.add(body);
  }
  for (std::size_t k = 0; k < contacts; ++k) {
    Contact contact;
    contact.b = static_cast<std::uint32_t>(from.byte() % bodies);
    const std::size_t other = from.byte() % (bodies + 1);
    contact.a = other == bodies || other == contact.b ? ABUT_NO_BODY : static_cast<std::uint32_t>(other);
    contact.point = from.vector(arms);
    contact.normal = from.vector(1);
    if (length(contact.normal) == 0) contact.normal = {0, 0, 1};
    contact.friction = kind % 16 == 1 ? from.size(1e6) : from.size(2);
    contact.compliance = kind % 8 < 4 ? 0 : from.size(spread);
    contact.offset = kind % 32 < 16 ? 0 : from.number(100);
    contact.surface = kind % 64 < 32 ? Vector{} : from.vector(10);
    out.world.contacts.push_back(contact);
  }
  if (kind >= 250) spoil(from, out);
  return out;
}

}  // namespace response_fuzzing
