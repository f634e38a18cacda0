// SPDX-License-Identifier: Apache-2.0
// Solid height fields at their sides, at their floor and at holes. They are judged by the same solids as meshes, which
// take another way through the library, and by boxes.
#include "field_scenes.hpp"

namespace {

using namespace solid;

constexpr int scenes = 1500;

struct Scene {
  explicit Scene(std::uint64_t seed)
      : numbers(seed),
        ground(random_ground(numbers)),
        surface(prism_of(ground)),
        field(field_of(ground)),
        same(mesh(surface)),
        body(random_body(numbers)),
        pose(near_surface(surface, body.size, numbers)) {}

  Numbers numbers;
  Ground ground;
  test::Surface surface;
  ShapePtr field, same;
  Body body;
  abut_pose pose;
};

double tolerance_of(const Body& body) { return body.is_curved ? 1e-6 : 1e-8; }

// A depth is an estimate that is never short: both are in the interval of the other. Mostly they are equal.
TEST(FieldBase, DistancesAreThoseOfTheSameMesh) {
  int deep = 0, others = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Scene scene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.body.name);
    const abut_distance of_field = distance(scene.field, scene.body.shape, scene.pose),
                        of_mesh = distance(scene.same, scene.body.shape, scene.pose);
    const double tolerance = tolerance_of(scene.body);
    if (of_mesh.distance > tolerance) {
      EXPECT_NEAR(of_field.distance, of_mesh.distance, tolerance);
      EXPECT_FALSE(overlaps(scene.field, scene.body.shape, scene.pose));
    } else if (of_mesh.distance < -tolerance) {
      ++deep;
      others += std::abs(of_field.distance - of_mesh.distance) > 1e-6 ? 1 : 0;
      EXPECT_LT(of_field.distance, 0);
      EXPECT_LE(of_field.lower, of_mesh.upper + tolerance);
      EXPECT_LE(of_mesh.lower, of_field.upper + tolerance);
      EXPECT_TRUE(overlaps(scene.field, scene.body.shape, scene.pose));
    }
  }
  EXPECT_GT(deep, scenes / 3);
  EXPECT_LT(others, deep / 50);
}

// Moved by its depth along the normal, a body overlaps nothing of the solid.
TEST(FieldBase, DepthsPart) {
  int deep = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Scene scene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.body.name);
    if (scene.body.has_children) continue;
    const abut_distance found = distance(scene.field, scene.body.shape, scene.pose);
    if (found.distance < 0) {
      ++deep;
      const double tolerance = tolerance_of(scene.body);
      const abut_pose out = moved(scene.pose, found.normal, -found.distance * (1 + 1e-9) + tolerance);
      EXPECT_GE(distance(scene.same, scene.body.shape, out).distance, -tolerance);
    }
  }
  EXPECT_GT(deep, scenes / 3);
}

// A contact where a body overlaps the solid, none where it does not; between points of both surfaces, and no deeper
// than the depth.
TEST(FieldBase, ContactsLieOnTheSurface) {
  const ShapePtr point = made_of_kind("point", {});
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Scene scene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.body.name);
    const double tolerance = tolerance_of(scene.body);
    const abut_distance found = distance(scene.field, scene.body.shape, scene.pose);
    const auto met = contacts(scene.field, scene.body.shape, scene.pose);
    if (std::abs(found.distance) < tolerance) continue;
    EXPECT_EQ(met.empty(), found.distance > 0);
    if (scene.body.has_children) continue;
    for (const abut_contact& contact : met) {
      EXPECT_GE(contact.distance, found.distance - tolerance);
      EXPECT_LE(contact.distance, tolerance);
      const abut_vec3& p = contact.point_a;
      if (contact.distance > found.distance + tolerance || met.size() > 1) {
        EXPECT_NEAR(distance(scene.same, point, at(p.x, p.y, p.z)).distance, 0, 1e-7);
      }
    }
  }
}

TEST(FieldBase, YesOrNoIsThatOfTheDistance) {
  for (std::uint64_t seed = 1; seed <= 4 * scenes; ++seed) {
    Scene scene(seed);
    const double found = distance(scene.field, scene.body.shape, scene.pose).distance;
    if (std::abs(found) > tolerance_of(scene.body)) {
      EXPECT_EQ(overlaps(scene.field, scene.body.shape, scene.pose), found < 0)
          << "seed " << seed << ", " << scene.body.name;
    }
  }
}

TEST(FieldBase, RaysMeetTheSameMesh) {
  int hits = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Scene scene(seed);
    const abut_pose here = at(0, 0, 0);
    for (int k = 0; k < 8; ++k) {
      const abut_vec3 from = near_surface(scene.surface, 1.5, scene.numbers).position,
                      to = near_surface(scene.surface, 1.5, scene.numbers).position;
      const abut_ray ray{from, {to.x - from.x, to.y - from.y, to.z - from.z}, std::numeric_limits<double>::infinity()};
      abut_ray_hit of_field{}, of_mesh{};
      std::uint32_t is_field_hit = 0, is_mesh_hit = 0;
      ASSERT_EQ(abut_shape_cast_ray(scene.field.get(), &here, &ray, &of_field, &is_field_hit), ABUT_OK);
      ASSERT_EQ(abut_shape_cast_ray(scene.same.get(), &here, &ray, &of_mesh, &is_mesh_hit), ABUT_OK);
      EXPECT_EQ(is_field_hit, is_mesh_hit) << "seed " << seed << ", ray " << k;
      EXPECT_NEAR(of_field.distance, of_mesh.distance, 1e-9) << "seed " << seed << ", ray " << k;
      const double cosine = of_field.normal.x * of_mesh.normal.x + of_field.normal.y * of_mesh.normal.y +
                            of_field.normal.z * of_mesh.normal.z;
      EXPECT_NEAR(cosine, is_mesh_hit, 1e-9) << "seed " << seed << ", ray " << k;
      hits += static_cast<int>(is_mesh_hit);
    }
  }
  EXPECT_GT(hits, 4 * scenes);
}

TEST(FieldBase, CastsStopAtTheSameMesh) {
  int hits = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Scene scene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.body.name);
    const abut_pose here = at(0, 0, 0), start = moved(scene.pose, scene.numbers.direction(), 3);
    const abut_vec3 still{0, 0, 0}, way = scene.numbers.direction();
    const abut_vec3 to = near_surface(scene.surface, 0, scene.numbers).position;
    const abut_vec3 move{to.x - start.position.x + 0.2 * way.x, to.y - start.position.y + 0.2 * way.y,
                         to.z - start.position.z + 0.2 * way.z};
    abut_cast_hit of_field{}, of_mesh{};
    std::uint32_t is_field_hit = 0, is_mesh_hit = 0;
    ASSERT_EQ(abut_pair_cast(scene.field.get(), &here, &still, scene.body.shape.get(), &start, &move, nullptr,
                             &of_field, &is_field_hit),
              ABUT_OK);
    ASSERT_EQ(abut_pair_cast(scene.same.get(), &here, &still, scene.body.shape.get(), &start, &move, nullptr, &of_mesh,
                             &is_mesh_hit),
              ABUT_OK);
    EXPECT_EQ(is_field_hit, is_mesh_hit);
    EXPECT_NEAR(of_field.fraction, of_mesh.fraction, 10 * tolerance_of(scene.body));
    hits += static_cast<int>(is_mesh_hit);
  }
  EXPECT_GT(hits, scenes / 2);
}

TEST(FieldBase, TimesOfImpactAreThoseOfTheSameMesh) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "needs the feature motion";
  int touches = 0;
  for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
    Scene scene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.body.name);
    const abut_pose here = at(0, 0, 0), start = moved(scene.pose, scene.numbers.direction(), 2);
    const abut_vec3 to = near_surface(scene.surface, 0.2, scene.numbers).position, turn = scene.numbers.direction();
    const abut_movement still{};
    abut_movement move{};
    move.velocity = {to.x - start.position.x, to.y - start.position.y, to.z - start.position.z};
    move.angular_velocity = turn;
    abut_impact of_field{}, of_mesh{};
    ASSERT_EQ(abut_pair_time_of_impact(scene.field.get(), &here, &still, scene.body.shape.get(), &start, &move, 1,
                                       nullptr, &of_field),
              ABUT_OK);
    ASSERT_EQ(abut_pair_time_of_impact(scene.same.get(), &here, &still, scene.body.shape.get(), &start, &move, 1,
                                       nullptr, &of_mesh),
              ABUT_OK);
    EXPECT_EQ(of_field.state, of_mesh.state);
    EXPECT_NEAR(of_field.upper, of_mesh.upper, 10 * tolerance_of(scene.body));
    touches += of_mesh.state == ABUT_IMPACT_TOUCHES ? 1 : 0;
  }
  EXPECT_GT(touches, scenes / 4);
}

// A flat field without holes is a box.
TEST(FieldBase, FlatOnesAreBoxes) {
  const ShapePtr block = box(4, 3, 4);
  const abut_pose here = at(0, 0, 0), middle = at(4, 3, -3.25);
  for (const abut_diagonal diagonal : {ABUT_DIAGONAL_RISING, ABUT_DIAGONAL_FALLING, ABUT_DIAGONAL_ALTERNATING}) {
    const ShapePtr field = field_of({9, 7, 1, 1, diagonal, std::vector<double>(63, 0.75)});
    const test::Surface surface = prism_of({9, 7, 1, 1, diagonal, std::vector<double>(63, 0.75)});
    int deep = 0, longer = 0;
    for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
      Numbers numbers(seed);
      const Body body = random_body(numbers);
      if (body.has_children) continue;
      const abut_pose pose = near_surface(surface, body.size, numbers);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + body.name);
      const abut_distance found = distance(field, body.shape, pose);
      abut_distance right{};
      ASSERT_EQ(abut_pair_distance(block.get(), &middle, body.shape.get(), &pose, nullptr, &right), ABUT_OK);
      const double tolerance = tolerance_of(body);
      if (right.distance > tolerance) {
        EXPECT_NEAR(found.distance, right.distance, tolerance);
      } else if (right.distance < -tolerance) {
        ++deep;
        EXPECT_LE(found.distance, right.distance + tolerance);  // never short, and mostly the least
        EXPECT_GE(found.upper, right.distance - tolerance);
        longer += found.distance < right.distance - 1e-6 ? 1 : 0;
        const auto met = contacts(field, body.shape, pose);
        EXPECT_NEAR(least_of(met), found.distance, tolerance);
      }
      EXPECT_TRUE(std::abs(right.distance) < tolerance || overlaps(field, body.shape, pose) == (right.distance < 0));
      const abut_vec3 still{0, 0, 0}, way = numbers.direction(), move{3 * way.x, 3 * way.y, 3 * way.z};
      abut_cast_hit hit{}, of_box{};
      std::uint32_t is_hit = 0, is_box_hit = 0;
      ASSERT_EQ(abut_pair_cast(field.get(), &here, &still, body.shape.get(), &pose, &move, nullptr, &hit, &is_hit),
                ABUT_OK);
      ASSERT_EQ(
          abut_pair_cast(block.get(), &middle, &still, body.shape.get(), &pose, &move, nullptr, &of_box, &is_box_hit),
          ABUT_OK);
      if (std::abs(right.distance) > tolerance) {
        EXPECT_EQ(is_hit, is_box_hit);
        EXPECT_NEAR(hit.fraction, of_box.fraction, 10 * tolerance);
      }
    }
    EXPECT_GT(deep, scenes / 4);
    EXPECT_LT(longer, deep / 100);
  }
}

// What fell beside a field, or through its floor.
TEST(FieldBase, SidesAndFloorPushOut) {
  const ShapePtr field = field_of({9, 9, 1, 1, ABUT_DIAGONAL_RISING, std::vector<double>(81, 0.0)});
  const ShapePtr small = box(0.3, 0.3, 0.3), ball = sphere(0.25);
  const auto expect = [&](const ShapePtr& body, const abut_pose& pose, double depth, const abut_vec3& normal) {
    const abut_distance found = distance(field, body, pose);
    EXPECT_NEAR(found.distance, -depth, 1e-12);
    EXPECT_NEAR(found.normal.x, normal.x, 1e-12);
    EXPECT_NEAR(found.normal.y, normal.y, 1e-12);
    EXPECT_NEAR(found.normal.z, normal.z, 1e-12);
    EXPECT_NEAR(least_of(contacts(field, body, pose)), -depth, 1e-12);
    EXPECT_TRUE(overlaps(field, body, pose));
  };
  expect(small, at(-0.1, 4.2, -0.2), 0.2, {-1, 0, 0});
  expect(small, at(0.1, 4.2, -0.2), 0.4, {-1, 0, 0});
  expect(small, at(4.2, 8.1, -0.2), 0.2, {0, 1, 0});
  expect(small, at(0.3, 4.2, -0.2), 0.5, {0, 0, 1});
  expect(small, at(4.2, 4.2, -8.2), 0.1, {0, 0, -1});
  expect(ball, at(8.1, 4, -0.5), 0.15, {1, 0, 0});
  expect(ball, at(4.2, 4.2, -7.9), 0.35, {0, 0, -1});
  EXPECT_NEAR(distance(field, ball, at(8.5, 4, -0.5)).distance, 0.25, 1e-12);
  EXPECT_NEAR(distance(field, ball, at(4.2, 4.2, -9)).distance, 0.75, 1e-12);
}

// Ground around a missing sample ends in walls, down to the floor.
TEST(FieldBase, HolesAreShafts) {
  std::vector<double> heights(81, 0.0);
  heights[4 * 9 + 4] = std::nan("");
  const ShapePtr field = field_of({9, 9, 1, 1, ABUT_DIAGONAL_RISING, heights}), ball = sphere(0.25);
  EXPECT_NEAR(distance(field, ball, at(4, 4, -3)).distance, std::sqrt(0.5) - 0.25, 1e-12);
  EXPECT_TRUE(contacts(field, ball, at(4, 4, -3)).empty());
  EXPECT_FALSE(overlaps(field, ball, at(4, 4, -3)));
  const abut_distance found = distance(field, ball, at(2.9, 3.5, -3));
  EXPECT_NEAR(found.distance, -0.35, 1e-12);
  EXPECT_NEAR(found.normal.x, 1, 1e-12);
  EXPECT_NEAR(distance(field, ball, at(4, 4, -8.5)).distance, std::hypot(std::sqrt(0.5), 0.5) - 0.25, 1e-12);
}

// Its triangles are those that rays and contacts name, and each edge has as many of one side as of the other: two in
// all, or four where shafts meet.
TEST(FieldBase, TrianglesAreClosed) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Numbers numbers(seed);
    const Ground ground = random_ground(numbers);
    const ShapePtr field = field_of(ground), point = made_of_kind("point", {});
    std::size_t vertices = 0, triangles = 0;
    ASSERT_EQ(abut_shape_triangles(field.get(), nullptr, 0, &vertices, nullptr, 0, &triangles), ABUT_OK);
    std::vector<double> xyz(3 * vertices);
    std::vector<std::uint32_t> indices(3 * triangles);
    ASSERT_EQ(abut_shape_triangles(field.get(), xyz.data(), vertices, &vertices, indices.data(), triangles, &triangles),
              ABUT_OK);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t k = 0; k < indices.size(); k += 3) {
      if (indices[k] == indices[k + 1]) continue;
      for (const auto& [from, to] : {std::pair(k, k + 1), std::pair(k + 1, k + 2), std::pair(k + 2, k)}) {
        ++edges[{indices[from], indices[to]}];
      }
    }
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      EXPECT_EQ(count, back == edges.end() ? 0 : back->second) << "seed " << seed;
    }
    const abut_pose here = at(0, 0, 0);
    const test::Surface surface = prism_of(ground);
    for (int k = 0; k < 20; ++k) {
      const abut_vec3 from = near_surface(surface, 1.5, numbers).position,
                      to = near_surface(surface, 1.5, numbers).position;
      const abut_ray ray{from, {to.x - from.x, to.y - from.y, to.z - from.z}, std::numeric_limits<double>::infinity()};
      abut_ray_hit hit{};
      std::uint32_t is_hit = 0;
      ASSERT_EQ(abut_shape_cast_ray(field.get(), &here, &ray, &hit, &is_hit), ABUT_OK);
      if (is_hit == 0) continue;
      ASSERT_LT(hit.feature.index, triangles);
      const auto corner = [&](std::size_t place) {
        const std::size_t vertex = 3 * std::size_t{indices[3 * std::size_t{hit.feature.index} + place]};
        return std::array{xyz[vertex], xyz[vertex + 1], xyz[vertex + 2]};
      };
      const auto a = corner(0), b = corner(1), c = corner(2);
      const ShapePtr triangle = made_of_kind("triangle", {a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
      EXPECT_NEAR(distance(triangle, point, at(hit.point.x, hit.point.y, hit.point.z)).distance, 0, 1e-9);
    }
  }
}

}  // namespace
