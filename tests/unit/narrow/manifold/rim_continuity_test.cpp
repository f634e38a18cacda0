// SPDX-License-Identifier: Apache-2.0
// Cylinders and cones that rest on a face, lean on it or lie on their side: a motion of 0.2 micrometres moves what
// holds them, and the points that a reduction keeps, by a small multiple, however little they lean.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

using abut::ContactPoint;
using abut::Feature;
using abut::FeatureKind;
using abut::Vec3;
using test::Body;
using test::Contacts;

const Vec3 x{1, 0, 0}, z{0, 0, 1};

abut::ShapeHandle made(std::string_view kind, const std::vector<double>& parameters,
                       const std::vector<double>& reals = {}, const std::vector<std::uint32_t>& indices = {}) {
  return abut::make_shape(abut::find_kind(kind).value(), parameters, reals, indices).value();
}

std::vector<Body> bodies_with_rims() {
  const double slope = std::hypot(0.4, 1.0);
  std::vector<Body> bodies;
  bodies.push_back({"standing cylinder", made("cylinder", {0.4, 0.5}), 0.65, {z}});
  bodies.push_back({"lying cylinder", made("cylinder", {0.4, 0.5}), 0.65, {x}});
  bodies.push_back({"standing cone", made("cone", {0.4, 0.5}), 0.65, {-z}});
  bodies.push_back({"lying cone", made("cone", {0.4, 0.5}), 0.65, {{1 / slope, 0, 0.4 / slope}}});
  bodies.push_back({"coin", made("cylinder", {0.5, 0.05}), 0.51, {z}});
  return bodies;
}

std::vector<Body> grounds() {
  const std::vector<Vec3> up{z};
  std::vector<Body> grounds;
  grounds.push_back({"plane", made("plane", {0, 0, 1, 0}), 0.5, up, true, {0, 0, 0}});
  grounds.push_back({"wide box", made("box", {2, 2, 0.5}), 2.9, up});
  grounds.push_back({"narrow box", made("box", {0.35, 0.3, 0.5}), 0.7, up});
  grounds.push_back({"cap", made("cylinder", {0.6, 0.4}), 0.73, up});
  grounds.push_back({"equal cap", made("cylinder", {0.4, 0.4}), 0.57, up});
  grounds.push_back({"mesh",
                     made("mesh", {0}, {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0}, {0, 1, 2, 0, 2, 3}),
                     1.5,
                     up,
                     true,
                     {0, 0, 0}});
  grounds.push_back(
      {"one face", made("mesh", {0}, {-3, -3, 0, 3, -3, 0, 0, 4, 0}, {0, 1, 2}), 1.5, up, true, {0, 0, 0}});
  return grounds;
}

// No feature holds the deepest point of a rim that rests on its face: it runs around the rim as the body leans.
bool is_running(const ContactPoint& contact) {
  const auto is_wide = [](const Feature& f) { return f.kind == FeatureKind::whole || f.kind == FeatureKind::face; };
  const auto is_whole = [](const Feature& f) { return f.kind == FeatureKind::whole; };
  return (is_whole(contact.feature_a) && is_wide(contact.feature_b)) ||
         (is_wide(contact.feature_a) && is_whole(contact.feature_b));
}

Contacts held_of(Contacts contacts) {
  std::erase_if(contacts, is_running);
  return contacts;
}

// Over all steps: how far the polygon of what holds the body moves, and how far any kept point moves. The deepest
// one, which runs, does not count.
struct Motion {
  int steps = 0, changes = 0, exchanges = 0, running = 0;
  double polygon = 0, kept = 0;
  bool is_deepest_kept = true;
};

// How far points with one number move.
double kept_moved_by(const Contacts& before, const Contacts& now) {
  double most = 0;
  for (const ContactPoint& contact : now) {
    const auto same = std::ranges::find(before, contact.id, &ContactPoint::id);
    if (same != before.end()) {
      most = std::fmax(most, abut::norm(contact.point_b - same->point_b));
    }
  }
  return most;
}

bool are_same(const Contacts& before, const Contacts& now) {
  return test::set_of(test::ids_of(now)) == test::set_of(test::ids_of(before));
}

// The deepest point may be one more than those that hold a body.
constexpr std::size_t most_kept = 4;

void follow(const Body& ground, const Body& body, test::Contact poses, test::Random& random, Motion& motion) {
  constexpr int steps = 60;
  const test::Path path(body.size, random);
  Contacts held_before, kept_before;
  std::vector<std::uint64_t> ids_before;
  for (int step = 0; step < steps; ++step) {
    Contacts found;
    ASSERT_EQ(abut::pair_contacts(ground.shape, body.shape, poses.a, poses.b, {}, found), abut::Outcome::ok);
    motion.running += std::ranges::any_of(found, is_running) ? 1 : 0;
    const double deepest = found.empty() ? 0 : std::ranges::min_element(found, {}, &ContactPoint::distance)->distance;
    Contacts held = held_of(found), kept = std::move(found);
    kept.resize(abut::reduce(kept, most_kept, ids_before));
    ids_before = test::ids_of(kept);
    motion.is_deepest_kept = motion.is_deepest_kept && (kept.empty() || kept.front().distance == deepest);
    kept = held_of(std::move(kept));
    if (!held.empty() && !held_before.empty()) {
      ++motion.steps;
      if (!are_same(held_before, held)) {
        ++motion.changes;
      } else if (test::have_one_normal(held)) {
        motion.polygon = std::fmax(motion.polygon, test::moved_by(held_before, held));
      }
      motion.exchanges +=
          test::common_to(kept_before, kept).size() < std::min({kept_before.size(), kept.size(), most_kept}) ? 1 : 0;
      motion.kept = std::fmax(motion.kept, kept_moved_by(kept_before, kept));
    }
    held_before = std::move(held);
    kept_before = std::move(kept);
    poses.b = path.next(poses.b, 6.0 * step / steps);
  }
}

Motion motion_of(const Body& ground, const Body& body, std::uint64_t seed) {
  test::Random random(seed);
  Motion motion;
  for (const double tilt : {0.0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
    for (const double depth : {1e-5, 5e-4, 5e-3}) {
      for (int path = 0; path < 3; ++path) {
        if (const auto poses = test::touching(ground, ground.sides[0], body, body.sides[0], tilt, depth, random)) {
          follow(ground, body, *poses, random, motion);
        }
      }
    }
  }
  return motion;
}

// A rim that leans more than a thousandth stands on its edge. The point there runs a thousand times as far as the rim
// turns.
constexpr double most_moved = 1500 * test::step_length;

TEST(RimContinuity, OfBodiesThatStandLeanAndLie) {
  std::uint64_t seed = 500;
  int running = 0;
  for (const Body& body : bodies_with_rims()) {
    for (const Body& ground : grounds()) {
      SCOPED_TRACE(std::string(body.name) + " on " + std::string(ground.name));
      const Motion motion = motion_of(ground, body, ++seed);
      EXPECT_GT(motion.steps, 4000);
      EXPECT_LT(motion.changes, motion.steps / 50) << "most steps must keep the features";
      EXPECT_LT(motion.exchanges, motion.steps / 50) << "and the points that are kept";
      EXPECT_LE(motion.polygon, most_moved);
      EXPECT_LE(motion.kept, most_moved);
      EXPECT_TRUE(motion.is_deepest_kept);
      const std::string name = std::string(body.name) + " on " + std::string(ground.name);
      testing::Test::RecordProperty(name, std::to_string(motion.kept / test::step_length));
      running += motion.running;
    }
  }
  EXPECT_GT(running, 10000) << "deepest points that run around must be among them";
}

}  // namespace
