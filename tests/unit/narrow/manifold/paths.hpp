// SPDX-License-Identifier: Apache-2.0
// Pairs of bodies that touch and move along smooth random paths in steps of 0.2 micrometres.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;

namespace test {

inline constexpr double step_length = 2e-7;

inline abut::Vec3 unit(const abut::Vec3& v) { return (1 / abut::norm(v)) * v; }

inline abut::Vec3 direction(Random& random) {
  for (;;) {
    const abut::Vec3 v = random.point(1);
    if (const double length = abut::norm(v); length > 0.1 && length < 1) {
      return (1 / length) * v;
    }
  }
}

inline abut::Rotation turned(const abut::Vec3& axis, double angle) {
  const double sine = std::sin(angle / 2);
  return abut::Rotation::from({std::cos(angle / 2), sine * axis.x, sine * axis.y, sine * axis.z});
}

// A rotation that takes one unit vector to another.
inline abut::Rotation taking(const abut::Vec3& from, const abut::Vec3& to) {
  const abut::Vec3 axis = abut::cross(from, to);
  const double sine = abut::norm(axis);
  if (sine > 1e-12) {
    return turned((1 / sine) * axis, std::atan2(sine, abut::dot(from, to)));
  }
  const abut::Vec3 across = abut::tangents_of(from).first;
  return abut::dot(from, to) > 0 ? abut::Rotation::identity() : turned(across, std::numbers::pi);
}

// A shape, the directions that it may turn to the other one, and where it may be touched.
struct Body {
  std::string_view name;
  abut::ShapeHandle shape;
  double size;
  std::vector<abut::Vec3> sides;
  bool is_ground = false;  // turns only its side to the other, and is touched within 0.4 of the middle
  abut::Vec3 middle{0, 0, 0};
};

// Two bodies, b in the direction X from a and in it by a depth.
struct Contact {
  abut::Pose a, b;
};

inline std::optional<Contact> touching(const Body& a, const abut::Vec3& side_a, const Body& b, const abut::Vec3& side_b,
                                       double tilt, double depth, Random& random) {
  const auto facing = [&](const Body& body, const abut::Vec3& side, const abut::Vec3& toward) {
    const double lean = (body.is_ground ? 0.1 : 1) * tilt * random.uniform(0.3, 1);
    return turned(direction(random), lean) * turned({1, 0, 0}, random.uniform(-3, 3)) * taking(side, toward);
  };
  const auto place = [&](const Body& body, const abut::Rotation& rotation) -> abut::Vec3 {
    const abut::Vec3 spot = body.middle + abut::Vec3{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), 0};
    return body.is_ground ? -(rotation * spot) : abut::Vec3{0, random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
  };
  Contact contact{{facing(a, side_a, {1, 0, 0}), {0, 0, 0}}, {facing(b, side_b, {-1, 0, 0}), {0, 0, 0}}};
  contact.a.position = place(a, contact.a.rotation);
  const auto reach = [](const Body& body) { return body.is_ground ? 0.1 : body.size; };
  contact.b.position = place(b, contact.b.rotation) + abut::Vec3{reach(a) + reach(b) + 0.1, 0, 0};
  for (int round = 0; round < 60; ++round) {
    abut::Distance found{};
    if (abut::pair_distance(a.shape, b.shape, contact.a, contact.b, {}, found) != abut::Outcome::ok ||
        found.distance < -0.1) {
      return std::nullopt;
    }
    if (std::fabs(found.distance + depth) < 1e-9) {
      return contact;
    }
    contact.b.position.x -= found.distance + depth;
  }
  return std::nullopt;
}

// A path of a body: no point of it moves by more than 0.2 micrometres per step.
class Path {
 public:
  Path(double size, Random& random) : size_(size), slide_(direction(random)), turn_(direction(random)) {
    for (double& rate : rates_) {
      rate = random.uniform(0.5, 3);
    }
  }
  [[nodiscard]] abut::Pose next(const abut::Pose& pose, double time) const {
    const auto waves = [&](std::size_t i) {
      return abut::Vec3{std::sin(rates_[i] * time), std::sin(rates_[i + 1] * time), std::sin(rates_[i + 2] * time)};
    };
    const abut::Vec3 step = 0.5 * step_length * unit(slide_ + waves(0));
    return {turned(unit(turn_ + waves(3)), 0.5 * step_length / size_) * pose.rotation, pose.position + step};
  }

 private:
  double size_;
  abut::Vec3 slide_, turn_;
  std::array<double, 6> rates_{};
};

}  // namespace test
