// SPDX-License-Identifier: Apache-2.0
// Ground that is flat around a convex body is a half-space, however it is cut into triangles. Truths are heights of the
// body over a plane, from support functions in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "flat_floors.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using namespace property;

// ---- answers ----

// Where the body begins and ends over the plane, seen from the plane.
struct Heights {
  double low, high;
};
Heights heights_over(const Ground& ground, const abut_pose& at, const Body& body, const abut_pose& pose) {
  const Vec n = turned(at.orientation, ground.normal);
  const double offset = ground.offset + dot(n, vec(at.position));
  const double middle = dot(n, vec(pose.position)) - offset;
  const Vec local = turned_back(pose.orientation, n);
  return {middle - body.support(times(-1, local)), middle + body.support(local)};
}

abut_distance distance_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b) {
  abut_distance found{};
  EXPECT_EQ(abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &found), ABUT_OK);
  return found;
}

std::vector<abut_contact> contacts_of(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b,
                                      const abut_pose& pose_b, double margin = 0, std::uint32_t most = 0) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.max_contacts = most;
  options.margin = margin;
  std::vector<abut_contact> found(256);
  std::size_t count = 0;
  EXPECT_EQ(abut_pair_contacts(a, &pose_a, b, &pose_b, &options, found.data(), found.size(), &count), ABUT_OK);
  EXPECT_LE(count, found.size());
  found.resize(std::min(count, found.size()));
  return found;
}

std::set<std::uint64_t> ids_of(const std::vector<abut_contact>& contacts) {
  std::set<std::uint64_t> ids;
  for (const abut_contact& contact : contacts) ids.insert(contact.id);
  return ids;
}

// A pose of a body that crosses the ground near its middle, or is up to 0.1 apart from it.
abut_pose pose_across(const Ground& ground, const FlatFloor& floor, const abut_pose& at, const Body& body,
                      Random& random) {
  const bool is_field = floor.kind == FloorKind::height_field;
  const double side = is_field ? floor.size : 0;
  Vec place{side + between(random, -1.5, 1.5), side + between(random, -1.5, 1.5), 0};
  if (is_field) {
    place[2] = -(ground.normal[0] * place[0] + ground.normal[1] * place[1]) / ground.normal[2];
  } else {
    place = placed(floor.frame, place);
  }
  abut_pose pose{{0, 0, 0}, random_orientation(random)};
  const Vec n = turned(at.orientation, ground.normal), on_ground = placed(at, place);
  const Vec local = turned_back(pose.orientation, n);
  const double below = body.support(times(-1, local)), above = body.support(local);
  // A front holds what has not passed it with its core, and what is rounded with its middle.
  const double lowest = floor.sides == ABUT_SIDES_BOTH ? -above : body.radius > 0 ? 0 : -above + 0.05 * (above + below);
  const double height = between(random, lowest, below + 0.1);
  const Vec centre = plus(on_ground, times(height, n));
  pose.position = {centre[0], centre[1], centre[2]};
  return pose;
}

struct Judged {
  int poses = 0, wrong_depths = 0, wrong_normals = 0, open_intervals = 0, still_overlapping = 0, wrong_contacts = 0;
  double worst = 0;
};

void judge(const FlatFloor& floor, const Ground& ground, const Body& body, Random& random, int rounds, Judged& out) {
  for (int round = 0; round < rounds; ++round) {
    const abut_pose at{{between(random, -1, 1), between(random, -1, 1), 0}, random_orientation(random)};
    const abut_pose pose = pose_across(ground, floor, at, body, random);
    const auto [low, high] = heights_over(ground, at, body, pose);
    const double front = -low, back = high;
    const double truth = floor.sides == ABUT_SIDES_BOTH ? std::min(front, back) : front;
    if (std::abs(front - back) < 1e-5 || std::abs(truth) < 1e-7) continue;
    const Vec n = turned(at.orientation, ground.normal);
    const Vec out_of = floor.sides == ABUT_SIDES_BOTH && back < front ? times(-1, n) : n;
    const abut_distance found = distance_of(ground.shape.get(), at, body.shape.get(), pose);
    // Apart, searches on curved bodies end by their bound.
    const double tolerance = floor.as_float ? ground.blur : truth > 0 ? 1e-9 : 1e-8;
    ++out.poses;
    const double error = std::abs(found.distance + truth);
    out.worst = std::max(out.worst, error);
    out.wrong_depths += error > tolerance ? 1 : 0;
    const double turn = length(plus(vec(found.normal), times(-1, out_of)));
    out.wrong_normals += turn > (truth < 0 ? 1e-4 : floor.as_float ? 2e-6 : 1e-9) ? 1 : 0;
    out.open_intervals += found.lower <= -truth + ground.blur && found.upper >= -truth - ground.blur &&
                                  found.upper - found.lower < (floor.as_float ? 2e-6 : tolerance)
                              ? 0
                              : 1;
    abut_pose moved = pose;
    const Vec there = plus(vec(pose.position), times(-found.distance, vec(found.normal)));
    moved.position = {there[0], there[1], there[2]};
    const auto [moved_low, moved_high] = heights_over(ground, at, body, moved);
    out.still_overlapping += moved_low < -tolerance && moved_high > tolerance ? 1 : 0;
    const std::vector<abut_contact> contacts = contacts_of(ground.shape.get(), at, body.shape.get(), pose);
    double deepest = 0;
    for (const abut_contact& contact : contacts) {
      deepest = std::min(deepest, contact.distance);
      const double over = dot(n, vec(contact.point_a)) - ground.offset - dot(n, vec(at.position));
      if (length(plus(vec(contact.normal), times(-1, out_of))) > (floor.as_float ? 2e-6 : 1e-9) ||
          std::abs(over) > tolerance + 1e-9) {
        ++out.wrong_contacts;
      }
    }
    out.wrong_contacts += std::abs(deepest - std::min(found.distance, 0.0)) > tolerance ? 1 : 0;
  }
}

TEST(FlatGround, DepthAndContactsAreThoseOfAHalfSpace) {
  constexpr std::uint64_t seed = 20261128;
  Random random(seed);
  const std::vector<Body> all = convex_bodies(random);
  for (const FlatFloor& floor : flat_floors(random)) {
    const Ground ground = ground_of(floor, random);
    for (const Body& body : all) {
      SCOPED_TRACE(text_of(floor) + ", " + body.name + ", seed " + std::to_string(seed));
      Judged judged;
      judge(floor, ground, body, random, 40, judged);
      EXPECT_GT(judged.poses, 20);
      EXPECT_EQ(judged.wrong_depths, 0) << "worst " << judged.worst;
      EXPECT_EQ(judged.wrong_normals, 0);
      EXPECT_EQ(judged.open_intervals, 0);
      EXPECT_EQ(judged.still_overlapping, 0);
      EXPECT_EQ(judged.wrong_contacts, 0);
    }
  }
}

TEST(FlatGround, AHundredThousandTrianglesAreOneFloor) {
  constexpr std::uint64_t seed = 3;
  Random random(seed);
  const std::vector<Body> all = convex_bodies(random);
  FlatFloor floor{FloorKind::mesh, ABUT_SIDES_BOTH, 224, 6};
  floor.frame = {{0.1, 0.2, 0.3}, unit(1, 0.2, 0.1, 0.3)};
  const Ground ground = ground_of(floor, random);
  for (const Body& body : all) {
    SCOPED_TRACE(body.name);
    Judged judged;
    judge(floor, ground, body, random, 4, judged);
    EXPECT_EQ(judged.wrong_depths, 0) << "worst " << judged.worst;
    EXPECT_EQ(judged.still_overlapping, 0);
    EXPECT_EQ(judged.wrong_contacts, 0);
  }
}

// ---- contacts of known places ----

abut_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

Ground flat_mesh(std::uint32_t cells, abut_sides sides = ABUT_SIDES_BOTH, FloorKind kind = FloorKind::mesh) {
  Random random(1);
  FlatFloor floor{kind, sides, cells, 4};
  return ground_of(floor, random);
}

TEST(FlatGround, OneTouchIsOneContact) {
  const Body round = ball(0.5), lying = capsule("capsule", 0.25, 1), cube = box("box", 0.5, 0.4, 0.3);
  const abut_quat on_its_side = unit(1, 1, 0, 0);
  for (const std::uint32_t cells : {1u, 8u, 32u}) {
    for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
      const Ground ground = flat_mesh(cells, sides);
      // Over a vertex, an edge, a diagonal and a face.
      for (const Vec& place : {Vec{0, 0, 0}, Vec{0.5, 0, 0}, Vec{0.5, 0.5, 0}, Vec{0.31, 0.17, 0}}) {
        SCOPED_TRACE(testing::Message() << cells << " cells at " << place[0] << ", " << place[1]);
        const auto count = [&](const Body& body, const abut_pose& pose) {
          return contacts_of(ground.shape.get(), identity, body.shape.get(), pose).size();
        };
        EXPECT_EQ(count(round, at(place[0], place[1], 0.49)), 1u);
        EXPECT_EQ(count(lying, {{place[0], place[1], 0.24}, on_its_side}), 2u);
        EXPECT_EQ(count(cube, at(place[0], place[1], 0.29)), 4u);
      }
    }
  }
}

// A prism with eight corners at its lower end: four contacts are kept, however the floor is cut.
TEST(FlatGround, FinerFloorKeepsAsManyContacts) {
  std::vector<Vec> points;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::acos(-1.0) / 4;
    for (const double z : {-0.5, 0.5}) points.push_back({std::cos(angle), std::sin(angle), z});
  }
  const Body prism = hull("prism", points);
  for (const std::uint32_t cells : {1u, 4u, 16u, 64u}) {
    const Ground ground = flat_mesh(cells);
    const abut_pose pose = at(0.21, 0.13, 0.49);
    EXPECT_EQ(contacts_of(ground.shape.get(), identity, prism.shape.get(), pose).size(), 8u) << cells << " cells";
    EXPECT_EQ(contacts_of(ground.shape.get(), identity, prism.shape.get(), pose, 0, 4).size(), 4u) << cells << " cells";
    EXPECT_EQ(contacts_of(ground.shape.get(), identity, prism.shape.get(), pose, 0, 1).size(), 1u) << cells << " cells";
  }
}

TEST(FlatGround, FinerFloorHasTheSameContacts) {
  constexpr std::uint64_t seed = 5;
  Random random(seed);
  const std::vector<Body> all = convex_bodies(random);
  const Ground coarse = flat_mesh(1), fine = flat_mesh(40), grid = flat_mesh(24, ABUT_SIDES_BOTH, FloorKind::uv_grid);
  for (const Body& body : all) {
    for (int round = 0; round < 30; ++round) {
      const abut_pose pose{{between(random, -1, 1), between(random, -1, 1), between(random, -0.4, 0.6)},
                           random_orientation(random)};
      SCOPED_TRACE(body.name + ", round " + std::to_string(round) + ", seed " + std::to_string(seed));
      const double margin = round % 3 == 0 ? 0.2 : 0;
      const auto expected = contacts_of(coarse.shape.get(), identity, body.shape.get(), pose, margin);
      for (const Ground* ground : {&fine, &grid}) {
        const auto found = contacts_of(ground->shape.get(), identity, body.shape.get(), pose, margin);
        ASSERT_EQ(found.size(), expected.size());
        for (const abut_contact& contact : found) {
          EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [&](const abut_contact& other) {
            return length(plus(vec(contact.point_b), times(-1, vec(other.point_b)))) < 1e-9 &&
                   std::abs(contact.distance - other.distance) < 1e-9 && contact.id == other.id;
          }));
        }
      }
    }
  }
}

// Within a margin a ball that is apart has a contact, beyond it none; its distance is the gap.
TEST(FlatGround, MarginsReachOverTheGap) {
  const Body round = ball(0.5);
  for (const std::uint32_t cells : {1u, 20u}) {
    const Ground ground = flat_mesh(cells);
    for (const double gap : {0.0, 1e-12, 0.01, 0.09}) {
      for (const double side : {1.0, -1.0}) {
        const abut_pose pose = at(0.21, 0.13, side * (0.5 + gap));
        const auto near = contacts_of(ground.shape.get(), identity, round.shape.get(), pose, 0.1);
        ASSERT_EQ(near.size(), 1u) << gap;
        EXPECT_NEAR(near[0].distance, gap, 1e-12);
        EXPECT_NEAR(near[0].normal.z, side, 1e-12);
        EXPECT_EQ(contacts_of(ground.shape.get(), identity, round.shape.get(), pose, gap - 0.005).size(), 0u);
        EXPECT_NEAR(distance_of(ground.shape.get(), identity, round.shape.get(), pose).distance, gap, 1e-12);
      }
    }
  }
}

TEST(FlatGround, IdsStayUnderJitterAndWhileSliding) {
  constexpr std::uint64_t seed = 11;
  Random random(seed);
  const Body round = ball(0.5), lying = capsule("capsule", 0.25, 0.7), cube = box("box", 0.5, 0.4, 0.3);
  const Ground mesh = flat_mesh(16), grid = flat_mesh(16, ABUT_SIDES_FRONT, FloorKind::uv_grid);
  const ShapePtr field = field_of(17, 0.5, std::vector<double>(17 * 17, 0.0), ABUT_BELOW_OPEN);
  const abut_pose corner{{-4, -4, 0}, {1, 0, 0, 0}};
  struct Resting {
    const Body* body;
    double height;
    abut_quat orientation;
  };
  const Resting resting[] = {
      {&round, 0.49, {1, 0, 0, 0}}, {&lying, 0.24, unit(1, 1, 0, 0)}, {&cube, 0.29, {1, 0, 0, 0}}};
  for (const auto& [ground, pose_a] :
       {std::pair{mesh.shape.get(), identity}, std::pair{grid.shape.get(), identity}, std::pair{field.get(), corner}}) {
    for (const Resting& its : resting) {
      SCOPED_TRACE(its.body->name + ", seed " + std::to_string(seed));
      const auto ids_at = [&](double x, double y, double z) {
        const abut_pose pose{{x, y, z}, its.orientation};
        return ids_of(contacts_of(ground, pose_a, its.body->shape.get(), pose, 0, 4));
      };
      const std::set<std::uint64_t> first = ids_at(0, 0, its.height);
      EXPECT_FALSE(first.empty());
      int changes = 0;
      for (int step = 0; step < 100; ++step) {
        const auto jitter = [&] { return between(random, -1e-13, 1e-13); };
        changes += ids_at(jitter(), jitter(), its.height + jitter()) != first ? 1 : 0;
        changes += ids_at(0.013 * step, 0.007 * step, its.height) != first ? 1 : 0;
      }
      EXPECT_EQ(changes, 0);
    }
  }
}

// The vertices of a mesh as they come from files in which each triangle has its own.
TEST(FlatGround, TrianglesNeedNotShareVertices) {
  std::vector<Vec> vertices;
  std::vector<std::uint32_t> triangles;
  for (int j = -8; j < 8; ++j) {
    for (int i = -8; i < 8; ++i) {
      const Vec a{0.5 * i, 0.5 * j, 0}, b{0.5 * i + 0.5, 0.5 * j, 0}, c{0.5 * i, 0.5 * j + 0.5, 0},
          d{0.5 * i + 0.5, 0.5 * j + 0.5, 0};
      vertices.insert(vertices.end(), {a, b, d, a, d, c});
    }
  }
  for (std::uint32_t i = 0; i < vertices.size(); ++i) triangles.push_back(i);
  const ShapePtr floor = mesh_of(vertices, triangles, FloorKind::mesh, ABUT_SIDES_BOTH);
  const Body leaning = capsule("capsule", 0.5, 1);
  const double half = std::acos(-1.0) / 8;
  const abut_pose pose{{0.21, 0.13, 0.35}, {std::cos(half), std::sin(half), 0, 0}};
  EXPECT_NEAR(distance_of(floor.get(), identity, leaning.shape.get(), pose).distance, -(0.5 + std::sqrt(0.5) - 0.35),
              1e-9);
}

// Ground with a hole, a step or a border near the body is none of a half-space: what reaches past it has its own
// answer.
TEST(FlatGround, BordersHolesAndStepsEndIt) {
  std::vector<double> heights(9 * 9, 0.0);
  heights[4 * 9 + 4] = std::numeric_limits<double>::quiet_NaN();
  const ShapePtr holed = field_of(9, 0.5, heights, ABUT_BELOW_OPEN);
  const Body round = ball(0.2);
  // In the middle of the hole a ball falls through; over the ground it is held.
  EXPECT_GT(distance_of(holed.get(), identity, round.shape.get(), at(2, 2, 0.1)).distance, 0);
  EXPECT_NEAR(distance_of(holed.get(), identity, round.shape.get(), at(0.8, 0.8, 0.1)).distance, -0.1, 1e-12);
  // Beside a border it leaves sideways.
  const Ground ground = flat_mesh(16);
  const Body rod = box("rod", 0.05, 0.05, 1);
  EXPECT_NEAR(distance_of(ground.shape.get(), identity, rod.shape.get(), at(3.97, 0, 0)).distance, -0.08, 1e-9);
}

// ---- literals ----

TEST(FlatGround, LeaningCapsuleOnATwoSidedFloor) {
  const Body leaning = capsule("capsule", 0.5, 1);
  const double half = std::acos(-1.0) / 8;
  const abut_pose pose{{0.21, 0.13, 0.35}, {std::cos(half), std::sin(half), 0, 0}};
  for (const std::uint32_t cells : {1u, 2u, 10u, 20u}) {
    Random random(1);
    FlatFloor floor{FloorKind::mesh, ABUT_SIDES_BOTH, cells, 5};
    const Ground ground = ground_of(floor, random);
    const abut_distance found = distance_of(ground.shape.get(), identity, leaning.shape.get(), pose);
    EXPECT_NEAR(found.distance, -(0.5 + std::sqrt(0.5) - 0.35), 1e-9) << cells << " cells";
    EXPECT_LE(found.lower, found.distance);
    EXPECT_GE(found.upper, found.distance);
  }
}

TEST(FlatGround, ThinPlateOverSeveralCellsOfAField) {
  const ShapePtr field = field_of(5, 1, std::vector<double>(25, 0.0), ABUT_BELOW_OPEN);
  const Body plate = box("plate", 1, 0.75, 0.01);
  const abut_pose pose{{2.2, 1.7, 0.06}, unit(0.6, -0.9, 2.7, -0.2)};
  EXPECT_NEAR(distance_of(field.get(), identity, plate.shape.get(), pose).distance, -0.4784706, 1e-7);
}

// Of a solid the way out is up, as long as none of its other faces is as near.
TEST(FlatGround, SolidsPushOutOfTheNearestFlatFace) {
  const std::vector<Vec> corners{{-2, -2, -2}, {2, -2, -2}, {-2, 2, -2}, {2, 2, -2},
                                 {-2, -2, 0},  {2, -2, 0},  {-2, 2, 0},  {2, 2, 0}};
  const ShapePtr block = mesh_of(corners, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                           1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6},
                                 FloorKind::mesh, ABUT_SIDES_SOLID);
  const ShapePtr field = field_of(9, 0.5, std::vector<double>(81, 0.0), ABUT_BELOW_SOLID);
  const Body round = ball(0.3), cube = box("box", 0.3, 0.2, 0.1);
  for (const double height : {0.2, 0.0, -0.25, -0.5}) {
    for (const auto& [shape, pose_a] :
         {std::pair{block.get(), identity}, std::pair{field.get(), abut_pose{{-2, -2, 0}, {1, 0, 0, 0}}}}) {
      const auto depth = [&](const Body& body) {
        return distance_of(shape, pose_a, body.shape.get(), at(0.21, 0.13, height)).distance;
      };
      EXPECT_NEAR(depth(round), height - 0.3, 1e-9);
      if (height < 0.1) EXPECT_NEAR(depth(cube), height - 0.1, 1e-9);
    }
  }
}

}  // namespace
