// SPDX-License-Identifier: Apache-2.0
// The tolerance of contacts for every kind of shape, rule by rule: VX-09 of the specification. Balls of given gaps are
// in filtering.cpp.
#include <cmath>
#include <numbers>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr double one_millimetre = 0.001;

abut_universe_options options_of(abut_tolerance_mode mode, abut_broadphase broadphase = ABUT_BROADPHASE_AUTO) {
  abut_universe_options options;
  abut_universe_options_init(&options, sizeof options);
  options.tolerance_mode = mode;
  options.broadphase = broadphase;
  return options;
}

// A shape whose lowest point is `height` below its origin.
struct Body {
  std::string name;
  Shape shape;
  double height;
};

Shape make(const std::string& kind, const std::vector<double>& parameters) {
  abut_shape_desc desc;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind.c_str());
  desc.parameters = parameters.data();
  desc.parameter_count = parameters.size();
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(abut_shape_create(&desc, &shape))) << kind;
  return Shape(shape);
}

std::vector<Body> make_bodies() {
  std::vector<Body> bodies;
  bodies.push_back({"sphere", make_sphere(0.5), 0.5});
  bodies.push_back({"box", make_box(0.3, 0.4, 0.5), 0.5});
  bodies.push_back({"capsule", make_capsule(0.25, 0.5), 0.75});
  bodies.push_back({"octahedron", make_octahedron(0.5), 0.5});
  bodies.push_back({"cylinder", make("cylinder", {0.4, 0.5}), 0.5});
  bodies.push_back({"cone", make("cone", {0.4, 0.5}), 0.5});
  bodies.push_back({"ellipsoid", make("ellipsoid", {0.3, 0.4, 0.5}), 0.5});
  return bodies;
}

// Grounds whose surface is z = 0 around (2, 2).
std::vector<Body> make_grounds() {
  std::vector<Body> grounds;
  grounds.push_back({"plane", make_plane({0, 0, 1}, 0), 0});
  grounds.push_back({"mesh", make_square_mesh(4), 0});
  grounds.push_back({"terrain", make_terrain(12, 1), 0});
  grounds.push_back({"slab", make("box", {9, 9, 1}), 1});
  return grounds;
}

// The contacts of a body that hangs `gap` above a ground, in either order of creation.
std::vector<abut_contact> contacts_at(const Body& ground, double tolerance_of_ground, const Body& body,
                                      double tolerance_of_body, double gap, const abut_universe_options& options,
                                      bool is_ground_first) {
  Universe universe(&options);
  const auto add_ground = [&] {
    universe.add(ground.shape, at(0, 0, -ground.height), ABUT_MOTION_STATIC, tolerance_of_ground);
  };
  if (is_ground_first) add_ground();
  universe.add(body.shape, at(2.3, 2.1, body.height + gap), ABUT_MOTION_DYNAMIC, tolerance_of_body);
  if (!is_ground_first) add_ground();
  return universe.step();
}

struct Limit {
  abut_tolerance_mode mode;
  double tolerance_of_ground;
  double tolerance_of_body;
  double reported_below;  // the gap from which on nothing is reported
};

// Every pair has contacts a hair below the limit and none a hair above it.
void check_limit(const Limit& limit) {
  constexpr double hair = 1e-6;
  const auto bodies = make_bodies();
  for (const Body& ground : make_grounds()) {
    for (const Body& body : bodies) {
      for (const auto broadphase : {ABUT_BROADPHASE_BRUTE, ABUT_BROADPHASE_TREE}) {
        for (const bool is_ground_first : {true, false}) {
          const auto contacts = [&](double gap) {
            return contacts_at(ground, limit.tolerance_of_ground, body, limit.tolerance_of_body, gap,
                               options_of(limit.mode, broadphase), is_ground_first);
          };
          SCOPED_TRACE(body.name + " on " + ground.name);
          const auto below = contacts(limit.reported_below - hair);
          ASSERT_FALSE(below.empty());
          EXPECT_NEAR(below.front().distance, limit.reported_below - hair, 1e-9)
              << "the distance stays that of the surfaces";
          EXPECT_TRUE(contacts(limit.reported_below + hair).empty());
        }
      }
    }
  }
}

TEST(ToleranceOfEveryKind, DeadBandAsksForAnOverlapThatExceedsTheSum) {
  check_limit({ABUT_TOLERANCE_DEAD_BAND, one_millimetre, one_millimetre, -2 * one_millimetre});
}

TEST(ToleranceOfEveryKind, MarginAsksForASeparationBelowTheSum) {
  check_limit({ABUT_TOLERANCE_MARGIN, one_millimetre, one_millimetre, 2 * one_millimetre});
}

TEST(ToleranceOfEveryKind, TheSumCountsWhoeverHasIt) {
  for (const auto& [ground, body] : {std::pair{0.003, 0.0}, std::pair{0.0, 0.003}, std::pair{0.0029, 0.0001}}) {
    check_limit({ABUT_TOLERANCE_DEAD_BAND, ground, body, -0.003});
    check_limit({ABUT_TOLERANCE_MARGIN, ground, body, 0.003});
  }
}

TEST(ToleranceOfEveryKind, WithoutToleranceBothModesReportWhatTouches) {
  check_limit({ABUT_TOLERANCE_DEAD_BAND, 0, 0, 0});
  check_limit({ABUT_TOLERANCE_MARGIN, 0, 0, 0});
}

// Depths, gaps and tolerances that are exact in binary: the limit itself is out.
TEST(Tolerance, TheLimitItselfIsOut) {
  const Shape block = make_box(1, 1, 1);
  constexpr double sum = 0.0078125;
  for (const auto mode : {ABUT_TOLERANCE_DEAD_BAND, ABUT_TOLERANCE_MARGIN}) {
    const double limit = mode == ABUT_TOLERANCE_MARGIN ? sum : -sum;
    for (const double beside : {0.0, -0x1p-40}) {
      const abut_universe_options options = options_of(mode);
      Universe universe(&options);
      universe.add(block, at(0, 0, 0), ABUT_MOTION_STATIC, sum / 2);
      universe.add(block, at(0, 0, 2 + limit + beside), ABUT_MOTION_DYNAMIC, sum / 2);
      EXPECT_EQ(universe.step().size(), beside < 0 ? 4U : 0U);
    }
  }
}

// Touching without tolerance counts, also when the two touch exactly.
TEST(Tolerance, TouchingCountsWithoutTolerance) {
  const Shape block = make_box(1, 1, 1);
  for (const auto mode : {ABUT_TOLERANCE_DEAD_BAND, ABUT_TOLERANCE_MARGIN}) {
    const abut_universe_options options = options_of(mode);
    Universe universe(&options);
    universe.add(block, at(0, 0, 0), ABUT_MOTION_STATIC);
    universe.add(block, at(0, 0, 2));
    EXPECT_EQ(universe.step().size(), 4U);
  }
}

// Each point of a manifold is judged by itself: of a box that leans over an edge only the corners count that are within
// the tolerance.
TEST(Tolerance, IsThatOfEachPoint) {
  const Shape slab = make_box(9, 9, 1);
  const Shape block = make_box(1, 1, 1);
  constexpr double lean = 0.001;  // the corners of one side are 1 mm higher than those of the other, to 1e-6
  const abut_pose pose{{0, 0, 2}, {std::cos(lean / 4), 0, std::sin(lean / 4), 0}};
  for (const auto& [mode, tolerance, expected] :
       {std::tuple{ABUT_TOLERANCE_MARGIN, 0.0002, 2U}, std::tuple{ABUT_TOLERANCE_MARGIN, 0.0006, 4U},
        std::tuple{ABUT_TOLERANCE_DEAD_BAND, 0.0002, 2U}, std::tuple{ABUT_TOLERANCE_DEAD_BAND, 0.0006, 0U}}) {
    const abut_universe_options options = options_of(mode);
    Universe universe(&options);
    universe.add(slab, identity, ABUT_MOTION_STATIC, tolerance);
    universe.add(block, pose);
    EXPECT_EQ(universe.step().size(), expected) << tolerance;
  }
}

// A pair within the sum of two tolerances is a candidate, from whatever side it comes.
TEST(Tolerance, MarginReachesAllSides) {
  const Shape ball = make_sphere(1);
  for (const auto broadphase : {ABUT_BROADPHASE_BRUTE, ABUT_BROADPHASE_TREE}) {
    for (int i = 0; i < 24; ++i) {
      const double angle = i * std::numbers::pi / 12;
      for (const double gap : {0.299, 0.301}) {
        const abut_universe_options options = options_of(ABUT_TOLERANCE_MARGIN, broadphase);
        Universe universe(&options);
        universe.add(ball, identity, ABUT_MOTION_DYNAMIC, 0.25);
        universe.add(ball, at((2 + gap) * std::cos(angle), (2 + gap) * std::sin(angle), 0), ABUT_MOTION_DYNAMIC, 0.05);
        EXPECT_EQ(universe.step().size(), gap < 0.3 ? 1U : 0U) << "angle " << angle;
      }
    }
  }
}

// A body that sinks in and comes out again: one contact appears and one goes, both at the limit.
TEST(Tolerance, IsTheSameOnTheWayInAndOut) {
  const Shape ball = make_sphere(1);
  for (const auto mode : {ABUT_TOLERANCE_DEAD_BAND, ABUT_TOLERANCE_MARGIN}) {
    const abut_universe_options options = options_of(mode);
    Universe universe(&options);
    universe.add(ball, identity, ABUT_MOTION_STATIC, one_millimetre);
    const abut_part_id part = universe.add_part(at(0, 0, 3));
    universe.add_geometry(part, ball, one_millimetre);
    const double limit = mode == ABUT_TOLERANCE_MARGIN ? 2 * one_millimetre : -2 * one_millimetre;
    for (int i = 0; i <= 80; ++i) {
      const double gap = 1e-4 * (std::abs(i - 40) - 21.5) * 2;  // from 3.7 mm apart to 4.3 mm deep, and back
      const abut_pose pose = at(0, 0, 2 + gap);
      ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
      EXPECT_EQ(universe.step().size(), gap < limit ? 1U : 0U) << "gap " << gap;
    }
  }
}

// Parts of a composite have their own tolerances.
TEST(Tolerance, BelongsToTheGeometry) {
  const Shape ball = make_sphere(1);
  const abut_universe_options options = options_of(ABUT_TOLERANCE_MARGIN);
  Universe universe(&options);
  const abut_part_id pair = universe.add_part(identity);
  const abut_geometry_id near = universe.add_geometry(pair, ball, 0.0);
  const abut_geometry_id tolerant = universe.add_geometry(pair, ball, 0.01);
  const abut_geometry_id other = universe.add(ball, at(2.005, 0, 0));
  const auto contacts = universe.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_TRUE(contacts.front().geometry_a == tolerant && contacts.front().geometry_b == other);
  EXPECT_FALSE(contacts.front().geometry_a == near);
}

}  // namespace
