// SPDX-License-Identifier: Apache-2.0
// Bodies on floors of convex parts that lie side by side: their contacts are those with one large box, in a universe
// that welds and with a composite that is asked to. A floor is flat, so closed forms tell the normal and the depth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "scenes.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::ShapePtr;
using Random = std::mt19937_64;

constexpr abut_pose here{{0, 0, 0}, {1, 0, 0, 0}};
constexpr double half_floor = 5;

double between(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}
abut_quat any_turn(Random& random) {
  abut_quat q{};
  double square = 0;
  do {
    q = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  } while (square > 1 || square < 0.01);
  const double scale = 1 / std::sqrt(square);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}
double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double apart(const abut_vec3& a, const abut_vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

ShapePtr made(abut_status status, abut_shape* shape) {
  EXPECT_EQ(status, ABUT_OK);
  return ShapePtr(shape);
}
ShapePtr box(double x, double y, double z) {
  abut_shape* shape = nullptr;
  const abut_status status = abut_box_create(x, y, z, &shape);
  return made(status, shape);
}

struct Part {
  const abut_shape* shape;
  abut_pose pose;
};
// Parts that share the plane z = 0, and the shapes that they hold.
struct Floor {
  std::string name;
  std::vector<ShapePtr> shapes;
  std::vector<Part> parts;
};

enum class Tiles { even, uneven, hulls, mixed_with_meshes };

// Where rows and columns of tiles begin and end.
std::vector<double> cuts(Tiles tiles, std::size_t count, Random& random) {
  std::vector<double> at;
  for (std::size_t i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count), even = half_floor * (2 * share - 1);
    const bool is_fixed = tiles == Tiles::even || i == 0 || i == count;
    at.push_back(is_fixed ? even : even + between(random, -0.3, 0.3) * half_floor / static_cast<double>(count));
  }
  return at;
}
Floor floor_of(Tiles tiles, std::size_t count, Random& random) {
  Floor floor{"", {}, {}};
  const std::vector<double> columns = cuts(tiles, count, random);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> rows = cuts(tiles, count, random);
    for (std::size_t j = 0; j < count; ++j) {
      const double x0 = columns[i], x1 = columns[i + 1], y0 = rows[j], y1 = rows[j + 1];
      const double thick = between(random, 0.8, 1.5);
      abut_shape* shape = nullptr;
      if (tiles == Tiles::mixed_with_meshes && (i + j) % 2 == 0) {
        const double corners[] = {x0, y0, 0, x1, y0, 0, x1, y1, 0, x0, y1, 0};
        const std::uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
        abut_mesh_options options;
        abut_mesh_options_init(&options, sizeof options);
        options.sides = ABUT_SIDES_FRONT;
        const abut_status status = abut_mesh_create(corners, 4, triangles, 2, &options, &shape);
        floor.shapes.push_back(made(status, shape));
        floor.parts.push_back({floor.shapes.back().get(), here});
        continue;
      }
      const abut_pose middle{{0.5 * (x0 + x1), 0.5 * (y0 + y1), -thick}, {1, 0, 0, 0}};
      if (tiles == Tiles::hulls) {
        std::vector<double> xyz;
        for (const double z : {0.0, -2 * thick}) {
          for (const double x : {x0, x1}) {
            for (const double y : {y0, y1}) xyz.insert(xyz.end(), {x, y, z});
          }
        }
        const abut_status status = abut_hull_create(xyz.data(), 8, &shape);
        floor.shapes.push_back(made(status, shape));
        floor.parts.push_back({floor.shapes.back().get(), here});
      } else {
        floor.shapes.push_back(box(0.5 * (x1 - x0), 0.5 * (y1 - y0), thick));
        floor.parts.push_back({floor.shapes.back().get(), middle});
      }
    }
  }
  return floor;
}
Floor one_box() {
  Floor floor{"one box", {}, {}};
  floor.shapes.push_back(box(half_floor, half_floor, 1));
  floor.parts.push_back({floor.shapes.back().get(), {{0, 0, -1}, {1, 0, 0, 0}}});
  return floor;
}

struct Body {
  std::string name;
  ShapePtr shape;
};
std::vector<Body> bodies(Random& random) {
  std::vector<Body> list;
  const auto add = [&](const char* name, abut_status status, abut_shape* shape) {
    list.push_back({name, made(status, shape)});
  };
  abut_shape* shape = nullptr;
  abut_status status = abut_sphere_create(0.4, &shape);
  add("ball", status, shape);
  status = abut_capsule_create(0.2, 0.5, &shape);
  add("capsule", status, shape);
  status = abut_box_create(0.6, 0.4, 0.3, &shape);
  add("box", status, shape);
  status = abut_cylinder_create(0.3, 0.4, &shape);
  add("cylinder", status, shape);
  std::vector<double> xyz;
  for (int i = 0; i < 20; ++i) {
    const abut_vec3 p{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    const double scale = 0.5 / std::max(0.1, std::hypot(p.x, p.y, p.z));
    xyz.insert(xyz.end(), {scale * p.x, scale * p.y, scale * p.z});
  }
  status = abut_hull_create(xyz.data(), 20, &shape);
  add("hull", status, shape);
  return list;
}

class World {
 public:
  World(const Floor& floor, const abut_pose& place, const Body& body, abut_universe_flags flags) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.max_contacts = 0;
    options.flags = flags;
    EXPECT_EQ(abut_universe_create(&options, &universe_), ABUT_OK);
    abut_part_options part_options;
    abut_part_options_init(&part_options, sizeof part_options);
    part_options.motion = ABUT_MOTION_STATIC;
    abut_geometry_id geometry{};
    for (const Part& part : floor.parts) {
      abut_part_id id{};
      part_options.pose = property::composed(place, part.pose);
      EXPECT_EQ(abut_part_create(universe_, &part_options, &id), ABUT_OK);
      EXPECT_EQ(abut_geometry_create(universe_, id, part.shape, nullptr, &geometry), ABUT_OK);
    }
    part_options.motion = ABUT_MOTION_DYNAMIC;
    EXPECT_EQ(abut_part_create(universe_, &part_options, &body_), ABUT_OK);
    EXPECT_EQ(abut_geometry_create(universe_, body_, body.shape.get(), nullptr, &geometry), ABUT_OK);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() { abut_universe_destroy(universe_); }

  [[nodiscard]] std::vector<abut_contact> contacts_at(const abut_pose& pose) const {
    EXPECT_EQ(abut_part_set_pose(universe_, body_, &pose), ABUT_OK);
    EXPECT_EQ(abut_universe_step(universe_, 0.01), ABUT_OK);
    const abut_contact* contacts = nullptr;
    std::size_t count = 0;
    EXPECT_EQ(abut_universe_contacts(universe_, &contacts, &count), ABUT_OK);
    return {contacts, contacts + count};
  }

 private:
  abut_universe* universe_ = nullptr;
  abut_part_id body_{};
};

ShapePtr joined(const Floor& floor) {
  std::vector<const abut_shape*> children;
  std::vector<abut_pose> poses;
  for (const Part& part : floor.parts) {
    children.push_back(part.shape);
    poses.push_back(part.pose);
  }
  abut_shape* shape = nullptr;
  const abut_status status = abut_composite_create(children.data(), poses.data(), children.size(), &shape);
  return made(status, shape);
}

std::vector<abut_contact> contacts_of(const abut_shape* floor, const abut_pose& place, const Body& body,
                                      const abut_pose& pose, double* depth) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.max_contacts = 0;
  options.flags = ABUT_QUERY_WELDS;
  std::vector<abut_contact> contacts(400);
  std::size_t found = 0;
  EXPECT_EQ(
      abut_pair_contacts(floor, &place, body.shape.get(), &pose, &options, contacts.data(), contacts.size(), &found),
      ABUT_OK);
  contacts.resize(std::min(found, contacts.size()));
  abut_distance distance{};
  EXPECT_EQ(abut_pair_distance(floor, &place, body.shape.get(), &pose, &options, &distance), ABUT_OK);
  *depth = -distance.distance;
  return contacts;
}

// How low a body reaches at a pose.
double lowest(const Body& body, const abut_quat& turn) {
  abut_shape* plane = nullptr;
  const abut_vec3 up{0, 0, 1};
  EXPECT_EQ(abut_plane_create(&up, 0, &plane), ABUT_OK);
  const ShapePtr ground(plane);
  const abut_pose pose{{0, 0, 4}, turn};
  abut_distance found{};
  EXPECT_EQ(abut_pair_distance(plane, &here, body.shape.get(), &pose, nullptr, &found), ABUT_OK);
  return found.distance - 4;
}

struct Count {
  int steps = 0, off = 0, wrong_depth = 0, wrong_region = 0, wrong_distance = 0, wrong_point = 0;
  double worst_normal = 0, worst_depth = 0, worst_region = 0;
};

// By how much the points of contacts span less than others along sixteen directions of the floor. They may span more:
// where an edge of the body comes up out of one part, a contact lies on the border of the part.
double lack_of_region(const std::vector<abut_contact>& some, const std::vector<abut_contact>& others,
                      const abut_pose& place) {
  double worst = 0;
  for (int i = 0; i < 16; ++i) {
    const double angle = i * std::numbers::pi / 8;
    const abut_vec3 along = property::composed(place, {{std::cos(angle), std::sin(angle), 0}, {1, 0, 0, 0}}).position;
    const abut_vec3 direction{along.x - place.position.x, along.y - place.position.y, along.z - place.position.z};
    const auto reach = [&](const std::vector<abut_contact>& contacts) {
      double most = -1e300;
      for (const abut_contact& contact : contacts) most = std::max(most, dot(direction, contact.point_b));
      return most;
    };
    worst = std::max(worst, reach(others) - reach(some));
  }
  return worst;
}

void judge(const std::vector<abut_contact>& contacts, const std::vector<abut_contact>& expected, const abut_vec3& up,
           const abut_pose& place, double sunk, Count& count) {
  ++count.steps;
  double normal = 0, depth = 0;
  for (const abut_contact& contact : contacts) {
    normal = std::max(normal, apart(contact.normal, up));
    depth = std::max(depth, -contact.distance);
    const abut_vec3 under{contact.point_b.x - place.position.x, contact.point_b.y - place.position.y,
                          contact.point_b.z - place.position.z};
    count.wrong_point += std::fabs(dot(under, up) - contact.distance) > 1e-9 ? 1 : 0;
  }
  const double off = std::fabs(depth - sunk), region = lack_of_region(contacts, expected, place);
  count.off += normal > 1e-7 ? 1 : 0;
  count.wrong_depth += off > 1e-9 ? 1 : 0;
  count.wrong_region += region > 1e-6 ? 1 : 0;
  count.worst_normal = std::max(count.worst_normal, normal);
  count.worst_depth = std::max(count.worst_depth, off);
  count.worst_region = std::max(count.worst_region, region);
}

enum class Lay { flat, any };

int paths_of_each() {
  const char* wanted = std::getenv("ABUT_SLIDE_PATHS");
  return wanted != nullptr ? std::atoi(wanted) : 6;
}

void slide(Tiles tiles, std::size_t count_of_tiles, Lay lay, double least_sunk, double most_sunk,
           const std::string& name, std::uint64_t seed) {
  Random random(seed);
  const std::vector<Body> all = bodies(random);
  for (const Body& body : all) {
    Count in_world, in_composite;
    for (int path = 0; path < paths_of_each(); ++path) {
      const Floor floor = floor_of(tiles, count_of_tiles, random), whole = one_box();
      const abut_pose place =
          path % 2 == 0
              ? here
              : abut_pose{{between(random, -9, 9), between(random, -9, 9), between(random, -9, 9)}, any_turn(random)};
      const abut_vec3 top = property::composed(place, {{0, 0, 1}, {1, 0, 0, 0}}).position;
      const abut_vec3 up{top.x - place.position.x, top.y - place.position.y, top.z - place.position.z};
      const World world(floor, place, body, ABUT_UNIVERSE_WELDS), one(whole, place, body, 0);
      const ShapePtr composite = joined(floor);
      const double yaw = between(random, 0, 2 * std::numbers::pi), sunk = between(random, least_sunk, most_sunk);
      const abut_quat turn = lay == Lay::any ? any_turn(random)
                             : path % 3 == 0 ? abut_quat{1, 0, 0, 0}
                                             : abut_quat{std::cos(0.5 * yaw), 0, 0, std::sin(0.5 * yaw)};
      const double height = -lowest(body, turn) - sunk, heading = between(random, 0, 2 * std::numbers::pi);
      abut_vec3 at{between(random, -2, 2), between(random, -2, 2), height};
      const double stride = between(random, 0.001, 0.06);
      for (int step = 0; step < 30; ++step) {
        const abut_pose pose = property::composed(place, {at, turn});
        const std::vector<abut_contact> expected = one.contacts_at(pose);
        judge(world.contacts_at(pose), expected, up, place, sunk, in_world);
        double depth = 0;
        judge(contacts_of(composite.get(), place, body, pose, &depth), expected, up, place, sunk, in_composite);
        in_composite.wrong_distance += std::fabs(depth - sunk) > 1e-9 ? 1 : 0;
        at.x += stride * std::cos(heading);
        at.y += stride * std::sin(heading);
      }
    }
    for (const auto& [count, where] : {std::pair(&in_world, "a universe"), std::pair(&in_composite, "a composite")}) {
      const std::string what = body.name + " on " + name + ", " + where + ", seed " + std::to_string(seed) + ", of " +
                               std::to_string(count->steps) + " steps";
      EXPECT_EQ(count->off, 0) << what << ", worst normal " << count->worst_normal;
      EXPECT_EQ(count->wrong_depth, 0) << what << ", worst depth " << count->worst_depth;
      EXPECT_EQ(count->wrong_region, 0) << what << ", worst region " << count->worst_region;
      EXPECT_EQ(count->wrong_distance, 0) << what;
      EXPECT_EQ(count->wrong_point, 0) << what;
    }
  }
}

TEST(Welds, FlatBodiesSlideOverEvenBoxes) { slide(Tiles::even, 10, Lay::flat, 1e-3, 0.02, "even boxes", 1); }
TEST(Welds, FlatBodiesSlideOverUnevenBoxes) { slide(Tiles::uneven, 10, Lay::flat, 1e-3, 0.02, "uneven boxes", 2); }
TEST(Welds, TurnedBodiesSlideOverUnevenBoxes) { slide(Tiles::uneven, 10, Lay::any, 1e-3, 0.02, "uneven boxes", 3); }
TEST(Welds, BodiesSlideOverSmallBoxes) { slide(Tiles::uneven, 24, Lay::any, 1e-3, 0.02, "small boxes", 4); }
TEST(Welds, BodiesSlideOverHulls) { slide(Tiles::hulls, 10, Lay::any, 1e-3, 0.02, "hulls", 5); }
TEST(Welds, BodiesSlideOverBoxesAndMeshes) {
  slide(Tiles::mixed_with_meshes, 10, Lay::any, 1e-3, 0.02, "boxes and meshes", 6);
}
TEST(Welds, DeepBodiesSlideOverBoxes) { slide(Tiles::uneven, 10, Lay::any, 0.05, 0.3, "uneven boxes, deep", 7); }

}  // namespace
