// SPDX-License-Identifier: Apache-2.0
// The children of a composite move together, and so do particles: moved by its depth, none of them overlaps the ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "flat_floors.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::Body;
using property::Random;
using property::ShapePtr;
using property::Vec;

double uniform(Random& random, double low, double high) { return property::between(random, low, high); }

abut_quat any_turn(Random& random) {
  return property::unit(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
}

// Two to four convex bodies, at random.
struct Composite {
  std::vector<const Body*> bodies;
  std::vector<abut_pose> poses;
  ShapePtr shape;
};

Composite random_composite(const std::vector<Body>& bodies, Random& random) {
  Composite made;
  std::vector<const abut_shape*> children;
  const int count = 2 + static_cast<int>(uniform(random, 0, 2.999));
  for (int i = 0; i < count; ++i) {
    made.bodies.push_back(
        &bodies[static_cast<std::size_t>(uniform(random, 0, static_cast<double>(bodies.size()) - 0.001))]);
    children.push_back(made.bodies.back()->shape.get());
    made.poses.push_back({{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}, any_turn(random)});
  }
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_composite_create(children.data(), made.poses.data(), children.size(), &shape), ABUT_OK);
  made.shape = ShapePtr(shape);
  return made;
}

abut_distance distance(const abut_shape* ground, const abut_shape* body, const abut_pose& pose) {
  abut_distance found{};
  EXPECT_EQ(abut_pair_distance(ground, &property::identity, body, &pose, nullptr, &found), ABUT_OK);
  return found;
}
abut_pose moved_by_depth(const abut_pose& pose, const abut_distance& told) {
  return {{pose.position.x - told.distance * told.normal.x, pose.position.y - told.distance * told.normal.y,
           pose.position.z - told.distance * told.normal.z},
          pose.orientation};
}

abut_pose world_of(const abut_pose& parent, const abut_pose& child) {
  const abut_quat &p = parent.orientation, &c = child.orientation;
  const Vec at = property::placed(parent, property::vec(child.position));
  return {{at[0], at[1], at[2]},
          {p.w * c.w - p.x * c.x - p.y * c.y - p.z * c.z, p.w * c.x + p.x * c.w + p.y * c.z - p.z * c.y,
           p.w * c.y - p.x * c.z + p.y * c.w + p.z * c.x, p.w * c.z + p.x * c.y - p.y * c.x + p.z * c.w}};
}
// The lowest and the highest point of each child above the plane z = 0.
struct Heights {
  double low, high;
};
std::vector<Heights> heights_of(const Composite& composite, const abut_pose& pose) {
  std::vector<Heights> all;
  for (std::size_t i = 0; i < composite.bodies.size(); ++i) {
    const abut_pose world = world_of(pose, composite.poses[i]);
    const auto reach = [&](double sign) {
      const Vec along = property::turned_back(world.orientation, {0, 0, sign});
      return composite.bodies[i]->support(along);
    };
    all.push_back({world.position.z - reach(-1), world.position.z + reach(1)});
  }
  return all;
}
// How far all of them go up until none crosses the plane. What is below it by itself crosses it on the way.
double way_up(const std::vector<Heights>& children) {
  double way = 0;
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const Heights& child : children) {
      if (child.low + way < -1e-12 && child.high + way > 1e-12) {
        way = -child.low;
        goes_on = true;
      }
    }
  }
  return way;
}

TEST(SeveralBodies, LeaveAFlatFloorExactly) {
  constexpr std::uint64_t seed = 11;
  Random random(seed);
  const std::vector<Body> bodies = property::convex_bodies(random);
  int deep = 0;
  for (const abut_sides sides : {ABUT_SIDES_FRONT, ABUT_SIDES_BOTH}) {
    property::FlatFloor floor;
    floor.sides = sides;
    floor.cells = 16;
    floor.size = 40;
    const property::Ground ground = property::ground_of(floor, random);
    for (int scene = 0; scene < 300; ++scene) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", sides " << sides << ", scene " << scene);
      const Composite body = random_composite(bodies, random);
      const abut_pose pose{{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -0.5, 1)},
                           any_turn(random)};
      const std::vector<Heights> children = heights_of(body, pose);
      double expected = way_up(children);
      if (sides == ABUT_SIDES_FRONT) {
        // What is mostly behind a front is let through.
        bool are_held = true;
        for (std::size_t i = 0; i < children.size(); ++i) {
          are_held = are_held && world_of(pose, body.poses[i]).position.z > 0.01;
        }
        if (!are_held) {
          continue;
        }
      } else {
        std::vector<Heights> turned;
        for (const Heights& child : children) turned.push_back({-child.high, -child.low});
        expected = std::min(expected, way_up(turned));
      }
      if (expected < 1e-6) {
        continue;
      }
      ++deep;
      const abut_distance found = distance(ground.shape.get(), body.shape.get(), pose);
      EXPECT_NEAR(found.distance, -expected, 2e-9 * (1 + expected));
      EXPECT_LE(found.lower, -expected + 1e-12);
    }
  }
  EXPECT_GT(deep, 200);
}

struct Hills {
  std::string name;
  std::function<double(double, double)> height;
};

std::vector<ShapePtr> grounds_of(const Hills& hills) {
  constexpr std::uint32_t count = 21;
  constexpr double spacing = 0.5, middle = 5;
  std::vector<Vec> vertices;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t j = 0; j < count; ++j) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const double x = spacing * i - middle, y = spacing * j - middle;
      vertices.push_back({x, y, hills.height(x, y)});
      if (i + 1 < count && j + 1 < count) {
        const std::uint32_t a = j * count + i;
        triangles.insert(triangles.end(), {a, a + 1, a + count + 1, a, a + count + 1, a + count});
      }
    }
  }
  std::vector<ShapePtr> grounds;
  for (const abut_sides sides : {ABUT_SIDES_FRONT, ABUT_SIDES_BOTH}) {
    grounds.push_back(property::mesh_of(vertices, triangles, property::FloorKind::mesh, sides));
  }
  // The same ground as a solid: its border leads down to a floor.
  const std::uint32_t low = static_cast<std::uint32_t>(vertices.size());
  std::vector<std::uint32_t> closed = triangles;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    closed.insert(closed.end(), {low + triangles[i], low + triangles[i + 2], low + triangles[i + 1]});
  }
  for (std::uint32_t i = 0; i < low; ++i) {
    vertices.push_back({vertices[i][0], vertices[i][1], -8});
  }
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    const std::uint32_t last = count * (count - 1);
    const auto wall = [&](std::uint32_t from, std::uint32_t to) {
      closed.insert(closed.end(), {from, to, low + to, from, low + to, low + from});
    };
    wall(i + 1, i);
    wall(last + i, last + i + 1);
    wall(count * i, count * (i + 1));
    wall(count * (i + 1) + count - 1, count * i + count - 1);
  }
  grounds.push_back(property::mesh_of(vertices, closed, property::FloorKind::mesh, ABUT_SIDES_SOLID));
  return grounds;
}

// Moved by its depth, nothing of it overlaps.
TEST(SeveralBodies, OverlapNothingAfterTheMove) {
  constexpr std::uint64_t seed = 12;
  Random random(seed);
  const std::vector<Body> bodies = property::convex_bodies(random);
  const std::vector<Hills> all{{"valley", [](double x, double) { return 0.7 * std::fabs(x); }},
                               {"waves", [](double x, double y) { return 0.3 * std::sin(2 * x) * std::cos(1.7 * y); }}};
  int deep = 0, stuck = 0, deep_in_fronts = 0, behind_fronts = 0;
  for (const Hills& hills : all) {
    const std::vector<ShapePtr> grounds = grounds_of(hills);
    for (std::size_t g = 0; g < grounds.size(); ++g) {
      for (int scene = 0; scene < 120; ++scene) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << hills.name << ", ground " << g << ", scene "
                                        << scene);
        const Composite body = random_composite(bodies, random);
        const abut_pose pose{{uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, 0, 1.5)},
                             any_turn(random)};
        const abut_distance found = distance(grounds[g].get(), body.shape.get(), pose);
        if (!(found.distance < -1e-6)) {
          continue;
        }
        ++deep;
        for (std::size_t i = 0; i < body.bodies.size(); ++i) {
          const abut_distance of_child =
              distance(grounds[g].get(), body.bodies[i]->shape.get(), world_of(pose, body.poses[i]));
          EXPECT_LE(found.lower, of_child.upper + 1e-9);
        }
        const abut_distance after = distance(grounds[g].get(), body.shape.get(), moved_by_depth(pose, found));
        // Fronts let through what comes from behind, so the way of one child may lead another one across them.
        const bool has_fronts = g == 0;
        deep_in_fronts += has_fronts ? 1 : 0;
        (has_fronts ? behind_fronts : stuck) += after.distance < -2e-7 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(deep, 300);
  EXPECT_EQ(stuck, 0);
  EXPECT_LE(10 * behind_fronts, deep_in_fronts);
}

struct Cloud {
  std::vector<Vec> places;
  std::vector<double> radii;
  ShapePtr shape;
};

// One in six is a point.
Cloud random_cloud(Random& random, int most, double size) {
  Cloud made;
  const int count = 2 + static_cast<int>(uniform(random, 0, most - 2));
  std::vector<double> xyz;
  for (int i = 0; i < count; ++i) {
    made.places.push_back({uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)});
    made.radii.push_back(std::max(uniform(random, -0.06, 0.3), 0.0));
    xyz.insert(xyz.end(), made.places.back().begin(), made.places.back().end());
  }
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_particles_create_with_radii(xyz.data(), made.radii.data(), made.radii.size(), &shape), ABUT_OK);
  made.shape = ShapePtr(shape);
  return made;
}

TEST(SeveralBodies, ParticlesLeaveAFlatFloorExactly) {
  constexpr std::uint64_t seed = 13;
  Random random(seed);
  int deep = 0, deeper_than_one = 0;
  for (const abut_sides sides : {ABUT_SIDES_FRONT, ABUT_SIDES_BOTH}) {
    property::FlatFloor floor;
    floor.sides = sides;
    floor.cells = 16;
    floor.size = 40;
    const property::Ground ground = property::ground_of(floor, random);
    for (int scene = 0; scene < 300; ++scene) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", sides " << sides << ", scene " << scene);
      const Cloud cloud = random_cloud(random, 12, 0.6);
      const double height = sides == ABUT_SIDES_FRONT ? uniform(random, 0.3, 0.9) : uniform(random, -0.5, 0.8);
      const abut_pose pose{{uniform(random, -1, 1), uniform(random, -1, 1), height}, any_turn(random)};
      std::vector<Heights> balls, turned;
      double lowest = 1, deepest = 0;
      for (std::size_t i = 0; i < cloud.places.size(); ++i) {
        const double z = property::placed(pose, cloud.places[i])[2], radius = cloud.radii[i];
        balls.push_back({z - radius, z + radius});
        turned.push_back({-z - radius, -z + radius});
        lowest = std::min(lowest, z);
        deepest = std::max(deepest, radius - std::fabs(z));
      }
      if (sides == ABUT_SIDES_FRONT && lowest < 0.01) {
        continue;
      }
      const double expected = sides == ABUT_SIDES_FRONT ? way_up(balls) : std::min(way_up(balls), way_up(turned));
      if (expected < 1e-6) {
        continue;
      }
      ++deep;
      deeper_than_one += expected > deepest + 1e-3 ? 1 : 0;
      const abut_distance found = distance(ground.shape.get(), cloud.shape.get(), pose);
      EXPECT_NEAR(found.distance, -expected, 2e-9 * (1 + expected));
      EXPECT_LE(found.lower, -expected + 1e-12);
    }
  }
  EXPECT_GT(deep, 200);
  EXPECT_GT(deeper_than_one, 50);
}

TEST(SeveralBodies, ParticlesOverlapNothingAfterTheMove) {
  constexpr std::uint64_t seed = 14;
  Random random(seed);
  const std::vector<Body> bodies = property::convex_bodies(random);
  const std::vector<Hills> all{{"valley", [](double x, double) { return 0.7 * std::fabs(x); }},
                               {"waves", [](double x, double y) { return 0.3 * std::sin(2 * x) * std::cos(1.7 * y); }}};
  int deep = 0, stuck = 0, deep_in_fronts = 0, behind_fronts = 0;
  for (const Hills& hills : all) {
    const std::vector<ShapePtr> grounds = grounds_of(hills);
    for (std::size_t g = 0; g < grounds.size(); ++g) {
      for (int scene = 0; scene < 150; ++scene) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << hills.name << ", ground " << g << ", scene "
                                        << scene);
        const Cloud cloud = random_cloud(random, 40, g == 0 ? 0.4 : 0.8);
        ShapePtr with_body;
        if (scene % 2 == 1) {
          // Beside a convex body in a composite.
          const std::array children{
              static_cast<const abut_shape*>(cloud.shape.get()),
              static_cast<const abut_shape*>(bodies[static_cast<std::size_t>(scene) % bodies.size()].shape.get())};
          const std::array poses{property::identity,
                                 abut_pose{{uniform(random, -1, 1), uniform(random, -1, 1), 0.3}, any_turn(random)}};
          abut_shape* shape = nullptr;
          ASSERT_EQ(abut_composite_create(children.data(), poses.data(), children.size(), &shape), ABUT_OK);
          with_body.reset(shape);
        }
        const abut_shape* body = with_body ? with_body.get() : cloud.shape.get();
        const double x = uniform(random, -2, 2), y = uniform(random, -2, 2);
        const double z = g == 0 ? hills.height(x, y) + uniform(random, 0.3, 0.8) : uniform(random, 0.4, 1.8);
        const abut_pose pose{{x, y, z}, any_turn(random)};
        const abut_distance found = distance(grounds[g].get(), body, pose);
        if (!(found.distance < -1e-6)) {
          continue;
        }
        const bool has_fronts = g == 0;
        const bool are_above = std::ranges::all_of(cloud.places, [&](const Vec& place) {
          const Vec at = property::placed(pose, place);
          return at[2] > hills.height(at[0], at[1]);
        });
        if (has_fronts && (with_body || !are_above)) {
          continue;
        }
        ++deep;
        const abut_distance after = distance(grounds[g].get(), body, moved_by_depth(pose, found));
        deep_in_fronts += has_fronts ? 1 : 0;
        (has_fronts ? behind_fronts : stuck) += after.distance < -2e-7 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(deep, 300);
  EXPECT_EQ(stuck, 0);
  EXPECT_GT(deep_in_fronts, 20);
  EXPECT_LE(10 * behind_fronts, deep_in_fronts);
}

}  // namespace
