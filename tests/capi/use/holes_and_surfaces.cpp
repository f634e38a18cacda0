// SPDX-License-Identifier: Apache-2.0
// Holes against what is no convex shape: meshes, height fields, grids of cells and distance fields.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>

#include "hollow_bodies.hpp"

namespace {

using namespace abut_test;

struct Surface {
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
};

// The triangles of a shape in its own frame.
Surface triangles_of(const abut_shape* shape) {
  std::size_t vertices = 0, triangles = 0;
  require(abut_shape_triangles(shape, nullptr, 0, &vertices, nullptr, 0, &triangles));
  Surface all{std::vector<double>(3 * vertices), std::vector<std::uint32_t>(3 * triangles)};
  require(
      abut_shape_triangles(shape, all.points.data(), vertices, &vertices, all.triangles.data(), triangles, &triangles));
  return all;
}

// A ball of triangles, closed and turned outward.
Surface ball_of_triangles(double radius, std::uint32_t rings) {
  Surface ball;
  const std::uint32_t around = 2 * rings;
  const double pi = std::numbers::pi;
  for (std::uint32_t j = 0; j <= rings; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double up = pi * j / rings, a = 2 * pi * i / around, r = radius * std::sin(up);
      ball.points.insert(ball.points.end(), {r * std::cos(a), r * std::sin(a), -radius * std::cos(up)});
    }
  }
  for (std::uint32_t j = 0; j < rings; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      if (j > 0) ball.triangles.insert(ball.triangles.end(), {a, b, d});
      if (j + 1 < rings) ball.triangles.insert(ball.triangles.end(), {a, d, c});
    }
  }
  return ball;
}

Shape make_mesh(const Surface& surface, abut_sides sides = ABUT_SIDES_BOTH, abut_mesh_tree tree = ABUT_MESH_TREE_AUTO) {
  auto options = filled_by(abut_mesh_options_init);
  options.sides = sides;
  options.tree = tree;
  abut_shape* shape = nullptr;
  require(abut_mesh_create(surface.points.data(), surface.points.size() / 3, surface.triangles.data(),
                           surface.triangles.size() / 3, &options, &shape));
  return Shape(shape);
}

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  abut_pose pose(double far) {
    const double w = between(-1, 1), x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {{between(-far, far), between(-far, far), between(-far, far)},
            {w / length, x / length, y / length, z / length}};
  }
  // A sheet of squares with random heights.
  Surface sheet(std::uint32_t squares, double size) {
    Surface sheet;
    for (std::uint32_t j = 0; j <= squares; ++j) {
      for (std::uint32_t i = 0; i <= squares; ++i) {
        sheet.points.insert(sheet.points.end(),
                            {size * i / squares - size / 2, size * j / squares - size / 2, between(-0.2, 0.2)});
      }
    }
    for (std::uint32_t j = 0; j < squares; ++j) {
      for (std::uint32_t i = 0; i < squares; ++i) {
        const std::uint32_t a = j * (squares + 1) + i, c = a + squares + 1;
        sheet.triangles.insert(sheet.triangles.end(), {a, a + 1, c + 1, a, c + 1, c});
      }
    }
    return sheet;
  }

 private:
  std::mt19937_64 random_;
};

abut_vec3 turned(const abut_quat& q, const abut_vec3& v) {
  const abut_vec3 t{2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x)};
  return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
          v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}
abut_vec3 placed(const abut_pose& pose, const abut_vec3& v) {
  const abut_vec3 t = turned(pose.orientation, v);
  return {t.x + pose.position.x, t.y + pose.position.y, t.z + pose.position.z};
}
abut_vec3 corner_of(const Surface& surface, std::size_t corner) {
  const std::size_t vertex = 3 * std::size_t{surface.triangles.at(corner)};
  return {surface.points.at(vertex), surface.points.at(vertex + 1), surface.points.at(vertex + 2)};
}

// A hole, and the room that its walls leave a point of its own frame.
struct Cavity {
  const char* kind;
  std::vector<double> parameters;
  std::vector<double> (*rooms)(const abut_vec3& p);

  double room(const abut_vec3& p) const {
    const std::vector<double> all = rooms(p);
    return *std::min_element(all.begin(), all.end());
  }
};
const std::array<Cavity, 5> cavities{
    Cavity{"sphere_hole", {1}, [](const abut_vec3& p) { return std::vector{1 - std::hypot(p.x, p.y, p.z)}; }},
    Cavity{"cylinder_hole", {0.8, 1, 3}, [](const abut_vec3& p) { return std::vector{0.8 - std::hypot(p.x, p.y)}; }},
    Cavity{"cylinder_hole",
           {0.8, 1, 1},
           [](const abut_vec3& p) { return std::vector{0.8 - std::hypot(p.x, p.y), 1 + p.z}; }},
    Cavity{
        "box_hole",
        {1, 0.75, 0.5, 0},
        [](const abut_vec3& p) { return std::vector{1 - p.x, 1 + p.x, 0.75 - p.y, 0.75 + p.y, 0.5 - p.z, 0.5 + p.z}; }},
    Cavity{"box_hole", {1, 0.75, 0.5, 48}, [](const abut_vec3& p) {
             return std::vector{1 - p.x, 1 + p.x, 0.75 - p.y, 0.75 + p.y};
           }}};

std::vector<Shape> make_surfaces(Numbers& numbers) {
  const Surface sheet = numbers.sheet(8, 2), ball = ball_of_triangles(0.6, 7);
  std::vector<Shape> surfaces;
  surfaces.push_back(make_mesh(sheet));
  surfaces.push_back(make_mesh(ball, ABUT_SIDES_SOLID));
  surfaces.push_back(make_mesh(ball, ABUT_SIDES_BOTH, ABUT_MESH_TREE_SPHERE));
  surfaces.push_back(make_of_kind("uv_grid", {0, 0, 1, 0, 0}, sheet.points, sheet.triangles));
  std::vector<double> heights;
  for (int i = 0; i < 36; ++i) heights.push_back(numbers.between(-0.3, 0.3));
  heights.at(14) = std::nan("");
  surfaces.push_back(make_of_kind("height_field", {6, 6, 0.3, 0.35, 1}, heights));
  return surfaces;
}

bool are_near(const abut_vec3& a, const abut_vec3& b) {
  return std::fabs(a.x - b.x) + std::fabs(a.y - b.y) + std::fabs(a.z - b.z) < 1e-9;
}

// Every corner is looked at, and every triangle asked as a shape of its own.
TEST(HolesAndSurfaces, MeetAsTheirTrianglesDo) {
  Numbers numbers(5);
  const std::vector<Shape> surfaces = make_surfaces(numbers);
  std::size_t touching = 0, apart = 0;
  for (const Cavity& cavity : cavities) {
    const Shape hole = make_of_kind(cavity.kind, cavity.parameters);
    for (const Shape& surface : surfaces) {
      const Surface all = triangles_of(surface);
      for (int i = 0; i < 12; ++i) {
        const abut_pose pose = numbers.pose(i % 3 == 0 ? 2 : 0.4);
        const double margin = i % 2 == 0 ? 0 : 0.3;
        double least = std::numeric_limits<double>::infinity();
        std::vector<abut_contact> expected;
        for (std::size_t first = 0; first < all.triangles.size(); first += 3) {
          if (all.triangles.at(first) == all.triangles.at(first + 1)) continue;  // missing
          std::vector<double> corners;
          for (std::size_t corner = first; corner < first + 3; ++corner) {
            const abut_vec3 p = corner_of(all, corner);
            least = std::min(least, cavity.room(placed(pose, p)));
            corners.insert(corners.end(), {p.x, p.y, p.z});
          }
          const auto of_one = contacts_of(hole, identity, make_of_kind("triangle", corners), pose, margin);
          expected.insert(expected.end(), of_one.begin(), of_one.end());
        }
        const auto found = contacts_of(hole, identity, surface, pose, margin);
        const auto is_among = [](const abut_contact& one, const std::vector<abut_contact>& many) {
          return std::any_of(many.begin(), many.end(), [&](const abut_contact& other) {
            return are_near(one.point_b, other.point_b) && are_near(one.point_a, other.point_a) &&
                   are_near(one.normal, other.normal) && std::fabs(one.distance - other.distance) < 1e-9;
          });
        };
        for (const abut_contact& one : found) EXPECT_TRUE(is_among(one, expected)) << cavity.kind << i;
        for (const abut_contact& one : expected) EXPECT_TRUE(is_among(one, found)) << cavity.kind << i;
        EXPECT_NEAR(distance_of(hole, identity, surface, pose), least, 1e-9) << cavity.kind << i;
        EXPECT_NEAR(distance_of(surface, pose, hole, identity), least, 1e-9) << cavity.kind << i;
        if (least <= margin) EXPECT_NEAR(deepest(found), least, 1e-9) << cavity.kind << i;
        ++(least <= margin ? touching : apart);
      }
    }
  }
  EXPECT_GT(touching, 60U);
  EXPECT_GT(apart, 5U);
}

// A ball of samples: the room of its middle, less its radius.
TEST(HolesAndSurfaces, MeetDistanceFields) {
  const Surface ball = ball_of_triangles(0.4, 24);
  auto options = filled_by(abut_distance_field_options_init);
  options.spacing = 0.05;
  abut_shape* made = nullptr;
  require(abut_distance_field_from_mesh(ball.points.data(), ball.points.size() / 3, ball.triangles.data(),
                                        ball.triangles.size() / 3, &options, &made));
  const Shape field(made);
  abut_distance_field_report report;
  abut_distance_field_report_init(&report, sizeof report);
  require(abut_distance_field_describe(field, &report));
  const double off = report.error + 0.4 * (1 - std::cos(std::numbers::pi / 24));
  Numbers numbers(6);
  for (const Cavity& cavity : cavities) {
    const Shape hole = make_of_kind(cavity.kind, cavity.parameters);
    for (int i = 0; i < 12; ++i) {
      const abut_pose pose = numbers.pose(0.6);
      const double room = cavity.room(pose.position) - 0.4;
      abut_distance found{};
      ASSERT_TRUE(succeeded(abut_pair_distance(hole, &identity, field, &pose, nullptr, &found)));
      EXPECT_NEAR(found.distance, room, off) << cavity.kind << i;
      EXPECT_LE(found.lower, room + off);
      EXPECT_LE(found.lower, found.distance);
      EXPECT_GE(found.upper, found.distance);
      const auto contacts = contacts_of(hole, identity, field, pose);
      if (found.distance < 0) {
        EXPECT_NEAR(deepest(contacts), found.distance, 1e-12) << cavity.kind << i;
      } else {
        EXPECT_TRUE(contacts.empty());
      }
      for (const abut_contact& contact : contacts) {
        EXPECT_NEAR(contact.distance, cavity.room(contact.point_b), 1e-9 + (contact.distance < room ? 0 : 1));
      }
    }
  }
}

// Squares that come through the walls of a cavity are pushed back in, by what their corners are beyond.
TEST(HolesAndSurfaces, SheetsComeThroughWalls) {
  Numbers numbers(7);
  const Surface square{{-0.4, -0.3, 0, 0.4, -0.3, 0, 0.4, 0.3, 0.05, -0.4, 0.3, 0}, {0, 1, 2, 0, 2, 3}};
  const Shape sheet = make_mesh(square);
  int through = 0, within = 0;
  for (const Cavity& cavity : cavities) {
    const Shape body = hollow(make_of_kind(cavity.kind, cavity.parameters));
    for (int i = 0; i < 400; ++i) {
      const abut_pose pose = numbers.pose(0.8);
      std::array<double, 6> rooms{};
      std::set<std::size_t> passed;
      for (std::size_t corner = 0; corner < 6; ++corner) {
        const std::vector<double> of_walls = cavity.rooms(placed(pose, corner_of(square, corner)));
        rooms.at(corner) = *std::min_element(of_walls.begin(), of_walls.end());
        for (std::size_t wall = 0; wall < of_walls.size(); ++wall) {
          if (of_walls.at(wall) < 0) passed.insert(wall);
        }
      }
      const auto [least, most] = std::minmax_element(rooms.begin(), rooms.end());
      if (std::fabs(*least) < 1e-6 || *least < -0.15) continue;
      const auto found = contacts_of(body, identity, sheet, pose);
      if (*least > 0) {
        EXPECT_TRUE(found.empty()) << cavity.kind << i;
        ++within;
      } else if (*most > 0) {
        // Both triangles reach into the cavity where a corner that they share does.
        const bool do_both = std::max(rooms.at(0), rooms.at(2)) > 0;
        if (!do_both) continue;
        // Beside an edge, what is beyond two walls may have come through one of them only.
        EXPECT_NEAR(deepest(found), *least, passed.size() == 1 ? 1e-9 : -*least) << cavity.kind << i;
        for (const abut_contact& contact : found) {
          EXPECT_LT(contact.distance, 0);
          EXPECT_EQ(contact.child_a, 1U) << "the hole";
          EXPECT_EQ(contact.feature_b.kind, static_cast<abut_feature_kind>(ABUT_FEATURE_FACE));
        }
        ++through;
      }
    }
  }
  EXPECT_GT(through, 100);
  EXPECT_GT(within, 100);
}

// A ball of triangles in a tube, as a sheet and as a solid: the tube is free, and its wall is there.
TEST(HolesAndSurfaces, MeshesSlideThroughATube) {
  const Shape solid = make_of_kind("cylinder", {1, 2});
  const Shape tube = make_composite({solid, cylinder_hole(0.5, 2, 3)}, {identity, identity});
  for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT, ABUT_SIDES_SOLID}) {
    const Shape ball = make_mesh(ball_of_triangles(0.45, 8), sides);
    for (double z = -4; z <= 4; z += 0.25) {
      EXPECT_TRUE(contacts_of(tube, identity, ball, at(0.03, 0, z)).empty()) << z << " sides " << sides;
    }
    for (double z = -1.75; z <= 1.75; z += 0.25) {
      const auto found = contacts_of(tube, identity, ball, at(0.08, 0, z));
      EXPECT_NEAR(deepest(found), -0.03, 1e-9) << z << " sides " << sides;
      for (const abut_contact& contact : found) EXPECT_LT(contact.normal.x, 0) << "into the tube";
    }
    EXPECT_FALSE(contacts_of(tube, identity, ball, at(0.75, 0, 0)).empty()) << "in the material";
    EXPECT_TRUE(contacts_of(tube, identity, ball, at(1.5, 0, 0)).empty()) << "beside it";
  }
}

// Ground under an upright tube: the solid stands on it, and no wall is in the way.
TEST(HolesAndSurfaces, TubesStandOnTerrain) {
  const Shape solid = make_of_kind("cylinder", {1, 2});
  const Shape tube = make_composite({solid, cylinder_hole(0.5, 2, 3)}, {identity, identity});
  const Shape ground = make_of_kind("height_field", {9, 9, 0.75, 0.75, 0}, std::vector<double>(81, 0.0));
  EXPECT_TRUE(contacts_of(tube, at(3, 3, 2.01), ground, identity).empty());
  const auto found = contacts_of(tube, at(3, 3, 1.99), ground, identity);
  ASSERT_FALSE(found.empty());
  for (const abut_contact& contact : found) {
    EXPECT_NEAR(contact.distance, -0.01, 1e-9);
    EXPECT_NEAR(contact.normal.z, -1, 1e-9);
    EXPECT_GE(std::hypot(contact.point_a.x - 3, contact.point_a.y - 3), 0.5 - 1e-9) << "none in the hole";
  }
}

Shape make_field(const Surface& surface, double spacing, double& off) {
  auto options = filled_by(abut_distance_field_options_init);
  options.spacing = spacing;
  abut_shape* made = nullptr;
  require(abut_distance_field_from_mesh(surface.points.data(), surface.points.size() / 3, surface.triangles.data(),
                                        surface.triangles.size() / 3, &options, &made));
  abut_distance_field_report report;
  abut_distance_field_report_init(&report, sizeof report);
  require(abut_distance_field_describe(made, &report));
  off = report.error;
  return Shape(made);
}

// A block with holes is the same whatever it is made of: a box, a solid mesh or samples. A hollow sheet has no wall.
TEST(HolesAndSurfaces, CutMeshesAndFields) {
  const Surface block = triangles_of(make_box(2, 2, 2));
  double off = 0;
  std::vector<Shape> blocks;
  blocks.push_back(make_box(2, 2, 2));
  blocks.push_back(make_mesh(block, ABUT_SIDES_SOLID));
  blocks.push_back(make_field(block, 0.1, off));
  blocks.push_back(make_mesh(block, ABUT_SIDES_BOTH));
  const Shape marble = make_sphere(0.25), ball = make_sphere(1);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const bool is_sheet = i == 3;
    const double near = i == 2 ? off : 1e-9;
    const Shape body = make_composite({blocks.at(i), sphere_hole(1)}, {identity, identity});
    const Shape pierced = make_composite({blocks.at(i), cylinder_hole(0.6, 2, 3)}, {identity, identity});
    for (const double x : {0.0, 0.3, 0.7, 0.8, 0.95, 1.6, 1.8, 2.2, 2.3}) {
      const double of_cavity = 0.75 - x, of_block = std::fabs(x - 2) - 0.25;
      const double expected = is_sheet ? of_block : x < 1.5 ? of_cavity : x - 2.25;
      const auto found = contacts_of(body, identity, marble, at(x, 0, 0));
      EXPECT_EQ(found.empty(), expected > 0) << i << " at " << x;
      if (!found.empty()) EXPECT_NEAR(deepest(found), expected, near) << i << " at " << x;
      EXPECT_NEAR(distance_of(body, identity, marble, at(x, 0, 0)), expected, near) << i << " at " << x;
    }
    for (const double z : {2.79, 2.81, 2.75, 3.1}) {
      const double expected = std::hypot(0.6, z - 2) - 1;
      const auto found = contacts_of(pierced, identity, ball, at(0, 0, z));
      EXPECT_EQ(found.empty(), expected > 0) << i << " at " << z;
      if (!found.empty()) EXPECT_NEAR(deepest(found), expected, 1e-9) << i << " at " << z;
      for (const abut_contact& contact : found) {
        EXPECT_NEAR(std::hypot(contact.point_a.x, contact.point_a.y), 0.6, 1e-9) << "on the rim";
      }
    }
    for (const double z : {-1.0, 0.0, 1.6, 2.0, 2.4}) {
      EXPECT_TRUE(contacts_of(pierced, identity, make_sphere(0.55), at(0, 0, z)).empty()) << i << " at " << z;
    }
  }
}

// A ball of many triangles does not fit into a hole: as a solid it rests on the rim as deep as a ball does.
TEST(HolesAndSurfaces, SolidMeshesRestOnTheRim) {
  const Shape plate = make_composite({make_box(3, 3, 0.5), cylinder_hole(0.6, 0.5, 3)}, {identity, identity});
  const Shape mesh = make_mesh(ball_of_triangles(1, 30), ABUT_SIDES_SOLID);
  EXPECT_TRUE(contacts_of(plate, identity, mesh, at(0, 0, 1.31)).empty());
  for (const double z : {1.29, 1.25}) {
    const auto found = contacts_of(plate, identity, mesh, at(0, 0, z));
    EXPECT_GE(found.size(), 4U);
    EXPECT_NEAR(deepest(found), std::hypot(0.6, z - 0.5) - 1, 2e-3) << "flat triangles are less than the ball";
    for (const abut_contact& contact : found) {
      EXPECT_NEAR(std::hypot(contact.point_a.x, contact.point_a.y), 0.6, 1e-9);
      EXPECT_GT(contact.normal.z, 0.6);
    }
  }
}

// A slanted square over the rim: it has no inside, and so no depth.
TEST(HolesAndSurfaces, SheetsArePiercedByTheRim) {
  const Shape plate = make_composite({make_box(3, 3, 0.5), cylinder_hole(0.6, 0.5, 3)}, {identity, identity});
  const Shape sheet =
      make_mesh({{-0.1, -0.5, 0.24, 1.2, -0.5, 0.76, 1.2, 0.5, 0.76, -0.1, 0.5, 0.24}, {0, 1, 2, 0, 2, 3}});
  const auto found = contacts_of(plate, identity, sheet, identity);
  std::size_t on_rim = 0;
  for (const abut_contact& contact : found) {
    const bool is_on_rim = std::fabs(std::hypot(contact.point_a.x, contact.point_a.y) - 0.6) < 1e-9 &&
                           std::fabs(contact.point_a.z - 0.5) < 1e-9;
    if (!is_on_rim) continue;
    ++on_rim;
    EXPECT_EQ(contact.distance, 0);
    EXPECT_LT(contact.normal.x, 0) << "out of the material";
    EXPECT_GT(contact.normal.z, 0);
  }
  EXPECT_EQ(on_rim, 2U);
}

// Eight triangles each, which leave nodes of the trees without some of their children.
TEST(HolesAndSurfaces, ASolidOfFewTrianglesHasADistanceFromAnother) {
  const Surface ball = ball_of_triangles(1, 2);
  const Shape solid = make_mesh(ball, ABUT_SIDES_SOLID), hole = sphere_hole(0.3), other = make_mesh(ball);
  const Shape body = make_composite({solid, hole}, {identity, identity});
  const abut_pose place = at(5, 0, 0);
  abut_distance distance{};
  require(abut_pair_distance(body, &identity, other, &place, nullptr, &distance));
  EXPECT_NEAR(distance.distance, 3, 1e-9);
}

}  // namespace
