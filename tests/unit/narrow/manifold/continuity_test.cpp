// SPDX-License-Identifier: Apache-2.0
// Contacts are continuous in the pose: while the same features touch, a small motion moves the contact polygon by a
// small multiple. So it does the points that a reduction keeps. rim_continuity_test.cpp does the same for cylinders
// and cones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion.hpp"
#include "paths.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.manifold;
import abut.pairs.any_shape;

namespace {

using abut::Vec3;
using test::Body;
using test::Contacts;
using test::have_one_normal;
using test::ids_of;
using test::moved_by;
using test::set_of;
using test::unit;

abut::ShapeHandle made(std::string_view kind, const std::vector<double>& parameters,
                       const std::vector<double>& reals = {}, const std::vector<std::uint32_t>& indices = {}) {
  return abut::make_shape(abut::find_kind(kind).value(), parameters, reals, indices).value();
}

abut::ShapeHandle prism() {
  std::vector<double> points;
  for (int i = 0; i < 7; ++i) {
    for (const double z : {-0.4, 0.4}) {
      const double angle = i * 2 * std::numbers::pi / 7;
      points.insert(points.end(), {0.5 * std::cos(angle), 0.5 * std::sin(angle), z});
    }
  }
  return made("hull", {}, points);
}

abut::ShapeHandle rock() {
  test::Random random(271);
  std::vector<double> points;
  for (int i = 0; i < 40; ++i) {
    const Vec3 p = 0.5 * test::direction(random);
    points.insert(points.end(), {p.x, p.y, p.z});
  }
  return made("hull", {}, points);
}

double height_at(int i, int j) { return 0.02 * std::sin(1.3 * i) * std::cos(0.9 * j); }

abut::ShapeHandle wavy_mesh() {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 10; ++i) {
      points.insert(points.end(), {0.3 * i, 0.3 * j, height_at(i, j)});
    }
  }
  for (std::uint32_t j = 0; j < 10; ++j) {
    for (std::uint32_t i = 0; i < 10; ++i) {
      const std::uint32_t corner = 11 * j + i;
      triangles.insert(triangles.end(), {corner, corner + 1, corner + 12, corner, corner + 12, corner + 11});
    }
  }
  return made("mesh", {0}, points, triangles);
}

abut::ShapeHandle field(bool is_flat) {
  std::vector<double> heights;
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 10; ++i) {
      heights.push_back(is_flat ? 0 : height_at(i, j));
    }
  }
  return made("height_field", {11, 11, 0.3, 0.3}, heights);
}

std::vector<Body> make_bodies() {
  const Vec3 x{1, 0, 0}, z{0, 0, 1}, edge = unit({1, 1, 0}), corner = unit({1, 1, 1});
  std::vector<Body> bodies;
  bodies.push_back({"ball", made("sphere", {0.5}), 0.5, {z}});
  bodies.push_back({"box", made("box", {0.5, 0.4, 0.3}), 0.71, {z, x, edge, corner}});
  bodies.push_back({"capsule", made("capsule", {0.25, 0.5}), 0.75, {z, x}});
  bodies.push_back({"prism", prism(), 0.65, {z, x, corner}});
  bodies.push_back({"rock", rock(), 0.5, {z, x}});
  bodies.push_back({"triangle", made("triangle", {-0.5, -0.4, 0, 0.5, -0.4, 0, 0, 0.6, 0}), 0.65, {z, {0, -1, 0}}});
  return bodies;
}

std::vector<Body> make_curved_bodies() {
  const Vec3 x{1, 0, 0}, z{0, 0, 1};
  std::vector<Body> bodies;
  bodies.push_back({"cylinder", made("cylinder", {0.4, 0.5}), 0.65, {z, x, unit({1, 0, 1})}});
  bodies.push_back({"cone", made("cone", {0.4, 0.5}), 0.65, {-z, z, unit({1, 0, 0.4}), unit({1, 0, -1})}});
  return bodies;
}

std::vector<Body> make_grounds() {
  const std::vector<Vec3> up{{0, 0, 1}};
  std::vector<Body> grounds;
  grounds.push_back({"plane", made("plane", {0, 0, 1, 0}), 0.5, up, true, {0, 0, 0}});
  grounds.push_back({"mesh", wavy_mesh(), 1.5, up, true, {1.5, 1.5, 0}});
  grounds.push_back({"field", field(false), 1.5, up, true, {1.5, 1.5, 0}});
  grounds.push_back({"flat field", field(true), 1.5, up, true, {1.5, 1.5, 0}});
  return grounds;
}

// Over all steps in which the features stay: how far the polygon moves, how far the points move that a reduction
// keeps, with and without the step before.
struct Motion {
  int steps = 0, changes = 0;
  double whole = 0, matched = 0, unmatched = 0;
};

struct Manifolds {
  Contacts whole, matched, unmatched;
};

// How far the points move that a reduction keeps again. The deepest one may be one more than these.
double steady_moved_by(const Contacts& before, const Contacts& now) {
  constexpr std::size_t most = 4;
  const Contacts steady = test::common_to(now, before);
  const bool are_exchanged = steady.size() < std::min({before.size(), now.size(), most});
  return are_exchanged ? moved_by(before, now) : moved_by(test::common_to(before, now), steady);
}

Manifolds contacts_at(const Body& a, const Body& b, const test::Contact& poses, const Contacts& before) {
  Contacts found;
  EXPECT_EQ(abut::pair_contacts(a.shape, b.shape, poses.a, poses.b, {}, found), abut::Outcome::ok);
  Manifolds manifolds{found, found, found};
  manifolds.matched.resize(abut::reduce(manifolds.matched, 4, ids_of(before)));
  manifolds.unmatched.resize(abut::reduce(manifolds.unmatched, 4));
  return manifolds;
}

void follow(const Body& a, const Body& b, test::Contact poses, test::Random& random, Motion& motion) {
  constexpr int steps = 60;
  const test::Path path(b.size, random);
  Manifolds before;
  for (int step = 0; step < steps; ++step) {
    Manifolds now = contacts_at(a, b, poses, before.matched);
    if (!now.whole.empty() && !before.whole.empty()) {
      ++motion.steps;
      if (set_of(ids_of(now.whole)) != set_of(ids_of(before.whole))) {
        ++motion.changes;
      } else if (have_one_normal(now.whole)) {
        motion.whole = std::fmax(motion.whole, moved_by(before.whole, now.whole));
        motion.matched = std::fmax(motion.matched, steady_moved_by(before.matched, now.matched));
        motion.unmatched = std::fmax(motion.unmatched, moved_by(before.unmatched, now.unmatched));
      }
    }
    before = std::move(now);
    poses.b = path.next(poses.b, 6.0 * step / steps);
  }
}

Motion motion_of(const Body& a, const Body& b, std::uint64_t seed) {
  test::Random random(seed);
  Motion motion;
  for (const Vec3& side_a : a.sides) {
    for (const Vec3& side_b : b.sides) {
      for (const double tilt : {0.0, 1e-9, 1e-7, 1e-5, 1e-3, 3.0}) {
        for (const double depth : {5e-4, 5e-3}) {
          if (const auto poses = test::touching(a, side_a, b, side_b, tilt, depth, random)) {
            follow(a, b, *poses, random, motion);
          }
        }
      }
    }
  }
  return motion;
}

// A step moves no polygon by more than a hundred times its length, and no kept point by a millimetre.
double check_pair(const Body& a, const Body& b, std::uint64_t seed) {
  SCOPED_TRACE(std::string(a.name) + " and " + std::string(b.name));
  const Motion motion = motion_of(a, b, seed);
  EXPECT_GT(motion.steps, 100);
  EXPECT_LT(motion.changes, motion.steps / 4) << "most steps must keep the features";
  EXPECT_LE(motion.whole, 100 * test::step_length);
  EXPECT_LE(motion.matched, 100 * test::step_length);
  const std::string name = std::string(a.name) + "_" + std::string(b.name);
  testing::Test::RecordProperty(name, std::to_string(motion.whole / test::step_length));
  return motion.unmatched;
}

TEST(Continuity, OfConvexPairs) {
  const std::vector<Body> bodies = make_bodies();
  double unmatched = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i; j < bodies.size(); ++j) {
      unmatched = std::fmax(unmatched, check_pair(bodies[i], bodies[j], 272 + 100 * i + j));
    }
  }
  EXPECT_GT(unmatched, 1e-3) << "the paths must need a reduction that knows the step before";
}

TEST(Continuity, OfBallsWithCurvedShapes) {
  for (const Body& curved : make_curved_bodies()) {
    (void)check_pair(make_bodies()[0], curved, 273);
  }
}

TEST(Continuity, OfBodiesOnGrounds) {
  const std::vector<Body> bodies = make_bodies();
  const std::vector<Body> grounds = make_grounds();
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    for (std::size_t j = 0; j + 1 < bodies.size(); ++j) {
      (void)check_pair(bodies[j], grounds[i], 274 + 100 * i + j);
    }
  }
}

}  // namespace
