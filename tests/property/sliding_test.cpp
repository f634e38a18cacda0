// SPDX-License-Identifier: Apache-2.0
// Bodies that slide and roll over floors which are flat but for noise or rounding: no seam may turn a normal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "floors.hpp"
#include "manifold.hpp"
#include "scenes.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::Floor;
using property::Random;
using property::ShapePtr;
using property::TriangleSoup;

constexpr double half_a_degree = 0.0087265;
constexpr int steps = 250;

struct Body {
  std::string name;
  ShapePtr shape;
  double height;  // of its middle over what it lies on
  bool is_lying;
};

std::vector<Body> bodies() {
  std::vector<Body> list;
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_box_create(0.4, 0.3, 0.3, &shape), ABUT_OK);
  list.push_back({"box", ShapePtr(shape), 0.3, false});
  EXPECT_EQ(abut_sphere_create(0.4, &shape), ABUT_OK);
  list.push_back({"sphere", ShapePtr(shape), 0.4, false});
  EXPECT_EQ(abut_capsule_create(0.25, 0.4, &shape), ABUT_OK);
  list.push_back({"capsule", ShapePtr(shape), 0.25, true});
  EXPECT_EQ(abut_cylinder_create(0.25, 0.4, &shape), ABUT_OK);
  list.push_back({"cylinder", ShapePtr(shape), 0.25, true});
  return list;
}

struct Ground {
  std::string name;
  ShapePtr shape;
  TriangleSoup soup;
  abut_pose pose;
  abut_quat lean;  // of the floor in the frame of the mesh
};

abut_quat product(const abut_quat& p, const abut_quat& q) {
  return property::composed({{0, 0, 0}, p}, {{0, 0, 0}, q}).orientation;
}

Ground mesh(const std::string& name, const Floor& floor, std::uint64_t seed, abut_sides sides) {
  TriangleSoup soup = property::soup_of(floor, seed);
  ShapePtr shape = property::mesh_of(soup, sides);
  const abut_quat lean = floor.as_float ? property::about({0, -1, 0}, 0.3) : abut_quat{1, 0, 0, 0};
  return {name, std::move(shape), std::move(soup), {{0, 0, 0}, {1, 0, 0, 0}}, lean};
}

Ground field(const Floor& floor, std::uint64_t seed) {
  const std::vector<double> heights = property::heights_of(floor, seed);
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = desc.rows = floor.cells + 1;
  desc.spacing_x = desc.spacing_y = floor.spacing;
  desc.heights = heights.data();
  abut_shape* shape = nullptr;
  EXPECT_EQ(abut_height_field_create(&desc, &shape), ABUT_OK);
  const double middle = -0.5 * floor.cells * floor.spacing;
  return {"height field",
          ShapePtr(shape),
          property::soup_of(floor, seed),
          {{middle, middle, 0}, {1, 0, 0, 0}},
          {1, 0, 0, 0}};
}

std::vector<Ground> grounds(const Floor& floor, std::uint64_t seed) {
  std::vector<Ground> list;
  list.push_back(mesh("mesh, both sides", floor, seed, ABUT_SIDES_BOTH));
  list.push_back(mesh("mesh, front", floor, seed, ABUT_SIDES_FRONT));
  if (!floor.as_float) list.push_back(field(floor, seed));
  return list;
}

// A pose on a straight path through the middle of the floor, sunk in by a depth.
abut_pose step_of(const Body& body, const Ground& ground, double direction, double at, double sunk) {
  const abut_pose lean{{0, 0, 0}, ground.lean};
  abut_quat turn = property::about({0, 0, 1}, direction);
  if (body.is_lying) {
    // Lying across the path, and rolling along it.
    turn = product(turn,
                   product(property::about({0, 1, 0}, at / body.height), property::about({1, 0, 0}, std::acos(0.0))));
  }
  const abut_pose local{{at * std::cos(direction) + 0.01, at * std::sin(direction) + 0.003, body.height - sunk}, turn};
  return property::composed(lean, local);
}

struct Count {
  int off = 0;      // steps with a normal that the surface rises over
  int missing = 0;  // steps without a contact, or with one that is too deep or not deep enough
  double worst = 0;
};

Count slide(const Body& body, const Ground& ground, double direction, double sunk, double blur) {
  Count count;
  for (int step = 0; step < steps; ++step) {
    const double at = -1.2 + 2.4 * step / steps;
    const abut_pose pose = step_of(body, ground, direction, at, sunk);
    std::size_t found = 0;
    std::vector<abut_contact> contacts(400);
    abut_query_options options;
    abut_query_options_init(&options, sizeof options);
    options.max_contacts = 0;
    EXPECT_EQ(abut_pair_contacts(ground.shape.get(), &ground.pose, body.shape.get(), &pose, &options, contacts.data(),
                                 contacts.size(), &found),
              ABUT_OK);
    contacts.resize(found);
    double rise = 0;
    for (const abut_contact& contact : contacts) {
      abut_vec3 local = contact.point_a;
      local.x -= ground.pose.position.x;
      local.y -= ground.pose.position.y;
      rise = std::max(rise, property::rise_around(ground.soup, local, contact.normal));
    }
    count.worst = std::max(count.worst, rise);
    if (rise > half_a_degree) ++count.off;
    if (contacts.empty() || std::abs(contacts.front().distance + sunk) > blur) ++count.missing;
  }
  return count;
}

void slide_all(const Floor& floor, std::uint64_t seed) {
  const auto floors = grounds(floor, seed);
  for (const Body& body : bodies()) {
    for (const Ground& ground : floors) {
      for (const double sunk : {1e-3, 1e-2}) {
        Count all;
        for (const double direction : {0.0, 0.3, 0.785398163397448, 2.0}) {
          const Count count = slide(body, ground, direction, sunk, 8 * floor.noise + (floor.as_float ? 1e-6 : 1e-9));
          all.off += count.off;
          all.missing += count.missing;
          all.worst = std::max(all.worst, count.worst);
        }
        const std::string where = body.name + " on " + ground.name + ", noise " + std::to_string(floor.noise * 1e6) +
                                  "e-6, sunk " + std::to_string(sunk) + ", seed " + std::to_string(seed);
        EXPECT_EQ(all.off, 0) << where << ": of " << 4 * steps << " steps, worst sine " << all.worst;
        EXPECT_EQ(all.missing, 0) << where << ": steps whose deepest contact is not as deep as the body is sunk";
      }
    }
  }
}

TEST(Sliding, OverAFlatFloorKeepsItsNormal) { slide_all({8, 0.5, 0, false}, 1); }
TEST(Sliding, OverNoiseOfAPicometreKeepsItsNormal) { slide_all({8, 0.5, 1e-12, false}, 2); }
TEST(Sliding, OverNoiseOfANanometreKeepsItsNormal) { slide_all({8, 0.5, 1e-9, false}, 3); }
TEST(Sliding, OverNoiseOfAMicrometreKeepsItsNormal) { slide_all({8, 0.5, 1e-6, false}, 4); }
TEST(Sliding, OverAFloorOfFloatsKeepsItsNormal) { slide_all({8, 0.5, 0, true}, 5); }

}  // namespace
