// SPDX-License-Identifier: Apache-2.0
// Bodies that slide along random paths over tessellated surfaces, sunk in by a little. Each normal lies in the cone of
// normals of the whole surface at its point. No contact is deeper than the body is sunk, nor is the deepest one less
// deep than the distance: but for one step in 200, or one, and by half a millimetre at most. ABUT_SLIDE_PATHS=42 makes
// it ten thousand paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "shortfall.hpp"
#include "tessellations.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::Faces;
using property::Piece;
using property::Tessellation;
using Random = std::mt19937_64;

constexpr double half_a_degree = 0.0087265;
constexpr int steps_of_path = 16;

struct Release {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using Shape = std::unique_ptr<abut_shape, Release>;

double between(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

struct Body {
  std::string name;
  Shape shape;
};

std::vector<Body> bodies() {
  std::vector<Body> list;
  const auto add = [&](const char* name, abut_status status, abut_shape* shape) {
    EXPECT_EQ(status, ABUT_OK);
    list.push_back({name, Shape(shape)});
  };
  abut_shape* shape = nullptr;
  add("sphere", abut_sphere_create(0.4, &shape), shape);
  add("box", abut_box_create(0.4, 0.3, 0.2, &shape), shape);
  add("capsule", abut_capsule_create(0.2, 0.35, &shape), shape);
  add("cylinder", abut_cylinder_create(0.25, 0.35, &shape), shape);
  Random random(20);
  std::vector<double> xyz;
  for (int i = 0; i < 24; ++i) {
    double p[3], square = 0;
    for (double& x : p) {
      x = between(random, -1, 1);
      square += x * x;
    }
    for (const double x : p) xyz.push_back(0.4 * x / std::sqrt(square));
  }
  add("hull", abut_hull_create(xyz.data(), 24, &shape), shape);
  return list;
}

std::vector<Shape> meshes_of(const Tessellation& surface, abut_sides sides) {
  std::vector<Shape> shapes;
  for (const Piece& piece : surface.pieces) {
    abut_mesh_options options;
    abut_mesh_options_init(&options, sizeof options);
    options.sides = sides;
    abut_shape* shape = nullptr;
    EXPECT_EQ(abut_mesh_create(&piece.vertices[0].x, piece.vertices.size(), piece.triangles[0].data(),
                               piece.triangles.size(), &options, &shape),
              ABUT_OK);
    shapes.emplace_back(shape);
  }
  return shapes;
}

constexpr abut_pose here{{0, 0, 0}, {1, 0, 0, 0}};

double distance(const std::vector<Shape>& surface, const Body& body, const abut_pose& pose) {
  double least = 1e300;
  for (const Shape& piece : surface) {
    abut_distance found{};
    EXPECT_EQ(abut_pair_distance(piece.get(), &here, body.shape.get(), &pose, nullptr, &found), ABUT_OK);
    least = std::min(least, found.distance);
  }
  return least;
}

// Lets a body that is above the surface down until it nearly touches.
bool let_down(const std::vector<Shape>& surface, const Body& body, abut_pose& pose) {
  for (int i = 0; i < 100; ++i) {
    const double gap = distance(surface, body, pose);
    if (gap < 1e-9) return gap > -1e-9;
    pose.position.z -= gap;
  }
  return true;
}

std::vector<abut_contact> contacts_of_pair(const abut_shape* surface, const Body& body, const abut_pose& pose) {
  std::vector<abut_contact> contacts(800);
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.max_contacts = 0;
  std::size_t found = 0;
  EXPECT_EQ(
      abut_pair_contacts(surface, &here, body.shape.get(), &pose, &options, contacts.data(), contacts.size(), &found),
      ABUT_OK);
  EXPECT_LE(found, contacts.size());
  contacts.resize(std::min(found, contacts.size()));
  return contacts;
}

// A composite of several pieces.
Shape joined(const std::vector<Shape>& pieces) {
  std::vector<const abut_shape*> children;
  for (const Shape& piece : pieces) children.push_back(piece.get());
  const std::vector<abut_pose> poses(children.size(), here);
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_composite_create(children.data(), poses.data(), children.size(), &shape), ABUT_OK);
  return Shape(shape);
}

// A universe in which each piece is a geometry of its own.
class World {
 public:
  World(const std::vector<Shape>& pieces, const Body& body) {
    abut_universe_options options;
    abut_universe_options_init(&options, sizeof options);
    options.max_contacts = 0;
    EXPECT_EQ(abut_universe_create(&options, &universe_), ABUT_OK);
    abut_geometry_id geometry{};
    abut_part_options part_options;
    abut_part_options_init(&part_options, sizeof part_options);
    part_options.motion = ABUT_MOTION_STATIC;
    for (const Shape& piece : pieces) {
      abut_part_id part{};
      EXPECT_EQ(abut_part_create(universe_, &part_options, &part), ABUT_OK);
      EXPECT_EQ(abut_geometry_create(universe_, part, piece.get(), nullptr, &geometry), ABUT_OK);
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
    std::vector<abut_contact> copies(count);
    std::copy_n(contacts, count, copies.begin());
    return copies;
  }

 private:
  abut_universe* universe_ = nullptr;
  abut_part_id body_{};
};

struct Count {
  int steps = 0;
  int off = 0;          // steps with a normal out of the cone
  int too_deep = 0;     // steps with a contact deeper than the way out that is known
  int too_shallow = 0;  // steps whose deepest contact is less deep than the distance says
  double worst_sine = 0, worst_excess = 0, worst_lack = 0;
};

class Slide {
 public:
  Slide(const Tessellation& tessellation, abut_sides sides)
      : tessellation_(tessellation),
        faces_(tessellation),
        surface_(meshes_of(tessellation, sides)),
        whole_(surface_.size() > 1 ? joined(surface_) : nullptr) {}

  [[nodiscard]] const std::vector<Shape>& pieces() const { return surface_; }

  // In a world, or where there is none as one shape.
  void run(const Body& body, const World* world, Random& random, Count& count) const {
    const double angle = between(random, 0, 2 * std::numbers::pi);
    double from_middle = 0;
    do {
      from_middle = between(random, 0, tessellation_.outer);
    } while (from_middle < tessellation_.inner);
    abut_vec3 at{from_middle * std::cos(angle), from_middle * std::sin(angle), 4};
    // Half of the paths cross the middle, where pieces meet.
    if (tessellation_.inner == 0 && random() % 2 == 0) at.x = between(random, -0.3, 0.3);
    const double heading = between(random, 0, 2 * std::numbers::pi);
    const double stride = between(random, 0.001, 0.06);
    const double sunk = std::pow(10, between(random, -4, -1.7));
    const abut_quat turn = orientation(random);
    for (int step = 0; step < steps_of_path; ++step) {
      abut_pose pose{at, turn};
      at.x += stride * std::cos(heading);
      at.y += stride * std::sin(heading);
      const double r = std::hypot(pose.position.x, pose.position.y);
      if (r > tessellation_.outer || r < tessellation_.inner) return;
      if (!let_down(surface_, body, pose)) continue;
      at.z = pose.position.z + 0.3;
      pose.position.z -= sunk;
      check(body, world, pose, sunk, count);
    }
  }

 private:
  // Any, or one that lies on a face or on a side.
  [[nodiscard]] static abut_quat orientation(Random& random) {
    abut_quat q{};
    if (random() % 2 == 0) {
      const double half = between(random, 0, std::numbers::pi);
      const double lay = random() % 2 == 0 ? std::sqrt(0.5) : 0;
      const double stand = lay > 0 ? lay : 1;
      return {stand * std::cos(half), lay * std::cos(half), lay * std::sin(half), stand * std::sin(half)};
    }
    double square = 0;
    do {
      q = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
      square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    } while (square > 1 || square < 0.01);
    const double scale = 1 / std::sqrt(square);
    return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
  }

  // The points of a face under one normal share it, wherever they lie.
  [[nodiscard]] static bool is_deepest_of_its_normal(const abut_contact& contact,
                                                     const std::vector<abut_contact>& contacts) {
    return std::none_of(contacts.begin(), contacts.end(), [&](const abut_contact& other) {
      return other.distance < contact.distance && other.normal.x == contact.normal.x &&
             other.normal.y == contact.normal.y && other.normal.z == contact.normal.z;
    });
  }

  void check(const Body& body, const World* world, const abut_pose& pose, double sunk, Count& count) const {
    ++count.steps;
    const double reach = tessellation_.crack + 1e-9;
    double sine = 0, excess = 0, deepest = 0;
    const abut_shape* one = whole_ ? whole_.get() : surface_.front().get();
    const std::vector<abut_contact> contacts =
        world != nullptr ? world->contacts_at(pose) : contacts_of_pair(one, body, pose);
    for (const abut_contact& contact : contacts) {
      if (is_deepest_of_its_normal(contact, contacts)) {
        sine = std::max(sine, faces_.off_cone(contact.point_a, contact.normal, reach));
      }
      excess = std::max(excess, -contact.distance - sunk);
      deepest = std::min(deepest, contact.distance);
    }
    const double lack = deepest - distance(surface_, body, pose);
    count.off += sine > half_a_degree ? 1 : 0;
    count.too_deep += excess > 2e-9 ? 1 : 0;
    count.too_shallow += lack > 1e-9 ? 1 : 0;
    count.worst_sine = std::max(count.worst_sine, sine);
    count.worst_excess = std::max(count.worst_excess, excess);
    count.worst_lack = std::max(count.worst_lack, lack);
  }

  const Tessellation& tessellation_;
  Faces faces_;
  std::vector<Shape> surface_;
  Shape whole_;
};

// Of each body over each surface, one-sided or not, in a pair and across seams in a universe: 240 kinds of paths.
int paths_of_each() {
  const char* wanted = std::getenv("ABUT_SLIDE_PATHS");
  return wanted != nullptr ? std::atoi(wanted) : 8;
}

void slide_over(const Tessellation& surface, abut_sides sides, const Body& body, bool is_in_world) {
  const Slide slide(surface, sides);
  const std::unique_ptr<World> world = is_in_world ? std::make_unique<World>(slide.pieces(), body) : nullptr;
  Random random(7);
  Count count;
  for (int path = 0; path < paths_of_each(); ++path) slide.run(body, world.get(), random, count);
  const std::string where = surface.name + (sides == ABUT_SIDES_FRONT ? ", front" : "") +
                            (is_in_world ? ", in a universe" : "") + ", " + body.name;
  EXPECT_GT(count.steps, 0) << where;
  EXPECT_EQ(count.off, 0) << where << ": of " << count.steps << " steps, worst sine " << count.worst_sine;
  EXPECT_LE(count.too_deep, 1 + count.steps / 200) << where << ": of " << count.steps;
  EXPECT_LT(count.worst_excess, 5e-4) << where;
  EXPECT_LE(count.too_shallow, 1 + count.steps / 200) << where << ": of " << count.steps;
  EXPECT_LT(count.worst_lack, 5e-4) << where;
}

TEST(Ghosts, NoneOnRandomPaths) {
  const std::vector<Body> all = bodies();
  for (const Tessellation& surface : property::tessellations()) {
    for (const abut_sides sides : {ABUT_SIDES_BOTH, ABUT_SIDES_FRONT}) {
      for (const Body& body : all) {
        slide_over(surface, sides, body, false);
        if (surface.pieces.size() > 1) slide_over(surface, sides, body, true);
      }
    }
  }
}

}  // namespace
