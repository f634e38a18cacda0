// SPDX-License-Identifier: Apache-2.0
// A body that stands on several places of a surface keeps contacts at each of them.
#include <algorithm>
#include <cmath>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

struct Foot {
  double x, y;
};
constexpr double half_foot = 0.1, height_of_feet = 0.5;

// A plate on feet that end at z = 0, as one mesh. `jitter`: of its vertices.
Shape make_table(const std::vector<Foot>& feet, double jitter, std::mt19937& random) {
  std::uniform_real_distribution<double> tremble(-jitter, jitter);
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  const auto add_box = [&](const abut_vec3& low, const abut_vec3& high) {
    const auto first = static_cast<std::uint32_t>(points.size() / 3);
    for (int i = 0; i < 8; ++i) {
      points.insert(points.end(), {((i & 1) != 0 ? high.x : low.x) + tremble(random),
                                   ((i & 2) != 0 ? high.y : low.y) + tremble(random),
                                   ((i & 4) != 0 ? high.z : low.z) + tremble(random)});
    }
    for (const std::uint32_t corner : {0u, 2u, 3u, 0u, 3u, 1u, 4u, 5u, 7u, 4u, 7u, 6u, 0u, 1u, 5u, 0u, 5u, 4u,
                                       2u, 6u, 7u, 2u, 7u, 3u, 0u, 4u, 6u, 0u, 6u, 2u, 1u, 3u, 7u, 1u, 7u, 5u}) {
      triangles.push_back(first + corner);
    }
  };
  add_box({-1.5, -1.2, height_of_feet}, {1.5, 1.2, height_of_feet + 0.1});
  for (const Foot& foot : feet) {
    add_box({foot.x - half_foot, foot.y - half_foot, 0}, {foot.x + half_foot, foot.y + half_foot, height_of_feet});
  }
  return make_of_kind("mesh", {ABUT_SIDES_FRONT}, points, triangles);
}

// Floors with their top at z = 0.
constexpr std::size_t plane_of_floors = 2;
std::vector<Shape> make_floors() {
  std::vector<Shape> floors;
  floors.push_back(
      make_of_kind("mesh", {ABUT_SIDES_FRONT}, {-3, -3, 0, 3, -3, 0, 3, 3, 0, -3, 3, 0}, {0, 1, 2, 0, 2, 3}));
  std::vector<double> points;
  std::vector<std::uint32_t> triangles;
  constexpr std::uint32_t cells = 40;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) points.insert(points.end(), {0.15 * i - 3, 0.15 * j - 3, 0});
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
      triangles.insert(triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  floors.push_back(make_of_kind("mesh", {ABUT_SIDES_FRONT}, points, triangles));
  floors.push_back(make_plane({0, 0, 1}, 0));
  return floors;
}

// Twice the area of the hull of points, by the signs of all triples.
double span_of(const std::vector<abut_vec3>& points) {
  double most = 0;
  for (const abut_vec3& a : points) {
    for (const abut_vec3& b : points) {
      for (const abut_vec3& c : points) {
        most = std::max(most, (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
      }
    }
  }
  return most;
}

const std::vector<Foot> four_feet{{-1, -0.8}, {1, -0.8}, {-1, 0.8}, {1, 0.8}};
const std::vector<Foot> six_feet{{-1.3, -0.8}, {0, -0.8}, {1.3, -0.8}, {-1.3, 0.8}, {0, 0.8}, {1.3, 0.8}};

// The contacts at each foot; the numbers of the contacts have to be as few as a patch may have.
void expect_each_foot_held(const std::vector<abut_contact>& contacts, const std::vector<Foot>& feet,
                           std::size_t most_of_foot) {
  std::size_t placed = 0;
  for (const Foot& foot : feet) {
    std::vector<abut_vec3> points;
    for (const abut_contact& contact : contacts) {
      if (std::fabs(contact.point_a.x - foot.x) < 0.15 && std::fabs(contact.point_a.y - foot.y) < 0.15) {
        points.push_back(contact.point_a);
      }
    }
    EXPECT_GE(points.size(), 3U) << foot.x << " " << foot.y;
    EXPECT_LE(points.size(), most_of_foot) << foot.x << " " << foot.y;
    EXPECT_GT(span_of(points), 0.9 * 2 * half_foot * 2 * half_foot);
    placed += points.size();
  }
  EXPECT_EQ(placed, contacts.size());
}

std::vector<abut_contact> reduced_contacts(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b,
                                           const abut_pose& pose_b, std::uint32_t most, std::uint32_t most_of_pair) {
  auto options = filled_by(abut_query_options_init);
  options.max_contacts = most;
  options.max_pair_contacts = most_of_pair;
  std::size_t count = 0;
  require(abut_pair_contacts(a, &pose_a, b, &pose_b, &options, nullptr, 0, &count));
  std::vector<abut_contact> contacts(count);
  require(abut_pair_contacts(a, &pose_a, b, &pose_b, &options, contacts.data(), count, &count));
  return contacts;
}

double deepest(const std::vector<abut_contact>& contacts) {
  return std::ranges::min_element(contacts, {}, &abut_contact::distance)->distance;
}

// What stands on a mesh trembles as a whole. Vertices tremble over the plane alone: two meshes whose faces are parallel
// but for noise have other contacts with each noise, before any reduction.
TEST(Regions, EachFootOfATableHasContactsUnderJitter) {
  std::mt19937 random(4);
  for (const std::vector<Foot>& feet : {four_feet, six_feet}) {
    for (int attempt = 0; attempt < 12; ++attempt) {
      std::uniform_real_distribution<double> tremble(-1e-9, 1e-9);
      const bool trembles = attempt > 0;
      const Shape calm = make_table(feet, 0, random), rough = make_table(feet, trembles ? 1e-9 : 0, random);
      const std::vector<Shape> floors = make_floors();
      for (std::size_t floor = 0; floor < floors.size(); ++floor) {
        SCOPED_TRACE("floor " + std::to_string(floor) + ", attempt " + std::to_string(attempt));
        const Shape& table = floor == plane_of_floors ? rough : calm;
        const double x = 0.07 + (trembles ? tremble(random) : 0), y = 0.03 + (trembles ? tremble(random) : 0);
        const abut_pose pose = at(x, y, -0.002 + (trembles ? tremble(random) : 0));
        std::vector<Foot> placed = feet;
        for (Foot& foot : placed) foot = {foot.x + x, foot.y + y};
        const auto all = contacts_of(table, pose, floors[floor], identity);
        const auto contacts = reduced_contacts(table, pose, floors[floor], identity, 4, 0);
        expect_each_foot_held(contacts, placed, 4);
        EXPECT_EQ(contacts[0].distance, deepest(all));
        const auto capped = reduced_contacts(table, pose, floors[floor], identity, 4, 5);
        EXPECT_EQ(capped.size(), 5U);
        EXPECT_EQ(capped[0].distance, deepest(all));
      }
    }
  }
}

TEST(Regions, TheDeepestContactIsKeptWhereTheTableLeans) {
  std::mt19937 random(9);
  const Shape table = make_table(four_feet, 0, random);
  const std::vector<Shape> floors = make_floors();
  for (const Shape& floor : floors) {
    for (int i = 0; i < 10; ++i) {
      const double angle = 4e-4 * (i - 5);
      const abut_pose pose{{0, 0, -0.003}, {std::cos(angle / 2), 0, std::sin(angle / 2), 0}};
      const auto contacts = reduced_contacts(table, pose, floor, identity, 4, 0);
      expect_each_foot_held(contacts, four_feet, 4);
      EXPECT_EQ(contacts[0].distance, deepest(contacts_of(table, pose, floor, identity)));
    }
  }
}

TEST(Regions, StayInAUniverseWhileTheTableTrembles) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> tremble(-1e-9, 1e-9);
  const Shape table = make_table(four_feet, 0, random);
  const std::vector<Shape> floors = make_floors();
  for (const Shape& floor : floors) {
    for (const std::uint32_t most_of_pair : {0U, 7U}) {
      abut_universe_options options = default_universe_options();
      options.max_pair_contacts = most_of_pair;
      Universe universe(&options);
      universe.add(floor, identity, ABUT_MOTION_STATIC);
      const abut_part_id part = universe.add_part(at(0, 0, -0.002));
      universe.add_geometry(part, table);
      for (int step = 0; step < 30; ++step) {
        universe.move(part, at(tremble(random), tremble(random), -0.002 + tremble(random)));
        const auto contacts = universe.step();
        if (most_of_pair == 0) {
          expect_each_foot_held(contacts, four_feet, 5);
        } else {
          EXPECT_EQ(contacts.size(), most_of_pair);
        }
      }
    }
  }
}

// A table with a box on it, on floors that are children too.
TEST(Regions, AreThoseOfChildrenOfComposites) {
  std::mt19937 random(5);
  const Shape table = make_table(four_feet, 0, random), load = make_box(0.2, 0.2, 0.2);
  const Shape loaded_table = make_composite({load, table}, {at(0, 0, 1), at(0, 0, 0.1)});
  const std::vector<Shape> floors = make_floors();
  for (std::size_t floor = 0; floor < floors.size(); ++floor) {
    const Shape below = make_composite({load, floors[floor]}, {at(0, 0, -3), at(0, 0, 0.3)});
    for (const auto& [body, height_of_body] : {std::pair<const Shape*, double>{&table, 0}, {&loaded_table, -0.1}}) {
      for (const auto& [ground, height_of_ground] :
           {std::pair<const Shape*, double>{&floors[floor], 0}, {&below, 0.3}}) {
        SCOPED_TRACE("floor " + std::to_string(floor) + (body == &table ? "" : ", loaded") +
                     (ground == &below ? ", of a composite" : ""));
        const abut_pose pose = at(0, 0, height_of_body + height_of_ground - 0.002);
        expect_each_foot_held(reduced_contacts(*body, pose, *ground, identity, 4, 0), four_feet, 4);
        Universe universe;
        universe.add(*ground, identity, ABUT_MOTION_STATIC);
        universe.add_geometry(universe.add_part(pose), *body);
        for (int step = 0; step < 2; ++step) {
          std::vector<abut_contact> contacts = universe.step();
          expect_each_foot_held(contacts, four_feet, 5);
        }
      }
    }
  }
}

TEST(Regions, ABoxOnAFloorOfTrianglesHasOne) {
  const std::vector<Shape> floors = make_floors();
  const Shape box = make_box(0.5, 0.4, 0.3);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(reduced_contacts(box, at(0.1, 0.2, 0.298), floors[i], identity, 4, 0).size(), 4U);
  }
}

}  // namespace
