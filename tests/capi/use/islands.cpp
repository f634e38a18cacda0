// SPDX-License-Identifier: Apache-2.0
// Islands of a universe against a search of the graph that its contacts make.
#include <map>
#include <random>
#include <set>

#include "support.hpp"

namespace {

using namespace abut_test;

std::vector<abut_island> islands_of(const abut_universe* universe) { return copy_of(abut_universe_islands, universe); }
std::vector<abut_part_id> parts_of(const abut_universe* universe) {
  return copy_of(abut_universe_island_parts, universe);
}
abut_island island_of(const abut_universe* universe, abut_part_id part) {
  abut_island out{7, 7, 7};
  require(abut_part_island(universe, part, &out));
  return out;
}
std::uint64_t id_of(const abut_universe* universe, abut_part_id part) { return island_of(universe, part).id; }

// Balls of radius 0.5 at random places of a box of side 4, on a static floor that all of them may touch.
class Crowd {
 public:
  explicit Crowd(std::uint32_t threads, std::size_t count) : options_(make_options(threads)), universe(&options_) {
    floor = universe.add_part(identity, ABUT_MOTION_STATIC);
    universe.add_geometry(floor, plane);
    script = universe.add_part(at(2, 2, 2), ABUT_MOTION_ANIMATED);
    universe.add_geometry(script, ball);
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(universe.add_part(somewhere()));
      abut_geometry_options its = default_geometry_options();
      its.flags = i % 7 == 3 ? std::uint32_t{ABUT_GEOMETRY_SENSOR} : 0;
      its.exclusion = i % 5 == 2 ? 1 : 0;
      geometries.push_back(universe.add_geometry(parts.back(), ball, its));
    }
    require(abut_universe_follow_islands(universe, 1));
  }
  static abut_universe_options make_options(std::uint32_t threads) {
    abut_universe_options options = default_universe_options();
    options.threads = threads_of_build(threads);
    return options;
  }
  double below(double most) { return most * double(random_()) / double(random_.max()); }
  std::size_t any() { return random_() % parts.size(); }
  abut_pose somewhere() { return at(below(6), below(6), below(6)); }

  // Moves a few, parks and brings back one, makes one animated or dynamic, and steps.
  void step() {
    for (int i = 0; i < 4; ++i) universe.move(parts.at(any()), somewhere());
    universe.park(geometries.at(any()), random_() % 3);
    require(abut_part_set_motion(universe, parts.at(any()),
                                 random_() % 4 == 0 ? ABUT_MOTION_ANIMATED : ABUT_MOTION_DYNAMIC));
    require(abut_universe_step(universe, 0.01));
  }
  bool is_dynamic(abut_part_id part) const {
    abut_motion motion = 7;
    require(abut_part_motion(universe, part, &motion));
    return motion == ABUT_MOTION_DYNAMIC;
  }

 private:
  std::mt19937 random_{11};
  abut_universe_options options_;

 public:
  Universe universe;
  Shape plane = make_plane({0, 0, 1}, 0);
  Shape ball = make_sphere(0.5);
  abut_part_id floor{}, script{};
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
};

// Parts by their slots, each with the slots of the dynamic ones that it touches.
std::map<std::uint32_t, std::set<std::uint32_t>> graph_of(const Crowd& crowd) {
  std::map<std::uint32_t, std::set<std::uint32_t>> graph;
  for (const abut_part_id part : crowd.parts) {
    if (crowd.is_dynamic(part)) graph[part.slot];
  }
  for (const abut_contact& contact : crowd.universe.contacts()) {
    const std::uint32_t a = crowd.universe.describe(contact.geometry_a).part.slot,
                        b = crowd.universe.describe(contact.geometry_b).part.slot;
    const bool is_sensor = (contact.flags & ABUT_CONTACT_SENSOR) != 0;
    if (!is_sensor && graph.contains(a) && graph.contains(b)) {
      graph[a].insert(b);
      graph[b].insert(a);
    }
  }
  return graph;
}

std::set<std::set<std::uint32_t>> search(std::map<std::uint32_t, std::set<std::uint32_t>> graph) {
  std::set<std::set<std::uint32_t>> found;
  while (!graph.empty()) {
    std::set<std::uint32_t> island, front{graph.begin()->first};
    while (!front.empty()) {
      const std::uint32_t slot = *front.begin();
      front.erase(front.begin());
      island.insert(slot);
      for (const std::uint32_t other : graph.at(slot)) {
        if (!island.contains(other)) front.insert(other);
      }
    }
    for (const std::uint32_t slot : island) graph.erase(slot);
    found.insert(island);
  }
  return found;
}

std::set<std::set<std::uint32_t>> told(const abut_universe* universe) {
  const std::vector<abut_part_id> parts = parts_of(universe);
  std::set<std::set<std::uint32_t>> found;
  std::uint32_t next = 0;
  for (const abut_island& island : islands_of(universe)) {
    EXPECT_EQ(island.first_part, next) << "one behind the other";
    std::set<std::uint32_t> slots;
    for (; next < island.first_part + island.part_count; ++next) {
      slots.insert(parts.at(next).slot);
      EXPECT_EQ(id_of(universe, parts.at(next)), island.id);
    }
    EXPECT_EQ(slots.size(), island.part_count);
    found.insert(slots);
  }
  EXPECT_EQ(next, parts.size());
  return found;
}

TEST(Islands, AreTheGraphOfTheContactsInEveryStep) {
  Crowd crowd(1, 60);
  std::size_t largest = 0;
  for (int step = 0; step < 150; ++step) {
    crowd.step();
    const auto expected = search(graph_of(crowd));
    ASSERT_EQ(told(crowd.universe), expected) << "step " << step;
    for (const auto& island : expected) largest = std::max(largest, island.size());
    EXPECT_EQ(id_of(crowd.universe, crowd.floor), 0U);
    EXPECT_EQ(id_of(crowd.universe, crowd.script), 0U);
  }
  EXPECT_GT(largest, 4U) << "or the test means little";
}

TEST(Islands, AreTheSameForAnyNumberOfThreads) {
  Crowd one(1, 80), many(4, 80);
  for (int step = 0; step < 60; ++step) {
    one.step();
    many.step();
    for (std::size_t i = 0; i < one.parts.size(); ++i) {
      ASSERT_EQ(id_of(one.universe, one.parts.at(i)), id_of(many.universe, many.parts.at(i)))
          << i << " in step " << step;
    }
  }
}

TEST(Islands, KeepTheirIdsWhileTheirPartsTouch) {
  Universe universe;
  const Shape ball = make_sphere(0.51);
  std::vector<abut_part_id> row;
  for (int i = 0; i < 5; ++i) {
    row.push_back(universe.add_part(at(i, 0, 0)));
    universe.add_geometry(row.back(), ball);
  }
  require(abut_universe_follow_islands(universe, 1));
  universe.step();
  const std::uint64_t id = id_of(universe, row[0]);
  EXPECT_EQ(island_of(universe, row[4]).part_count, 5U);
  for (int i = 0; i < 5; ++i) universe.move(row[static_cast<std::size_t>(i)], at(i, 1, 0));
  universe.step();
  EXPECT_EQ(id_of(universe, row[4]), id);
  universe.move(row[2], at(2, 50, 0));
  universe.step();
  EXPECT_EQ(id_of(universe, row[1]), id) << "the piece with the lowest slot";
  EXPECT_NE(id_of(universe, row[3]), id);
  EXPECT_EQ(id_of(universe, row[3]), id_of(universe, row[4]));
  EXPECT_NE(id_of(universe, row[2]), id_of(universe, row[3]));
  universe.move(row[2], at(2, 1, 0));
  universe.step();
  EXPECT_EQ(id_of(universe, row[4]), id) << "the oldest";
  EXPECT_EQ(islands_of(universe).size(), 1U);
}

TEST(Islands, StayAsTheyWereFoundUntilTheNextStep) {
  Universe universe;
  const Shape ball = make_sphere(1);
  const abut_part_id part = universe.add_part(identity);
  universe.add_geometry(part, ball);
  require(abut_universe_follow_islands(universe, 1));
  EXPECT_TRUE(islands_of(universe).empty()) << "before the first step";
  universe.step();
  EXPECT_EQ(islands_of(universe).size(), 1U);
  const abut_part_id later = universe.add_part(at(0.5, 0, 0));
  universe.add_geometry(later, ball);
  EXPECT_EQ(island_of(universe, later).part_count, 0U);
  EXPECT_EQ(island_of(universe, part).part_count, 1U);
  universe.step();
  EXPECT_EQ(island_of(universe, later).part_count, 2U);
  require(abut_universe_follow_islands(universe, 0));
  abut_island out{};
  EXPECT_TRUE(refused(abut_part_island(universe, part, &out), ABUT_UNSUPPORTED, {"islands", "follow"}));
  require(abut_universe_follow_islands(universe, 1));
  EXPECT_TRUE(islands_of(universe).empty()) << "those from before are gone";
}

// What sleeps together is what touches, with or without anyone who asks for islands.
TEST(Islands, ChangeNothingForSleep) {
  std::array<std::uint64_t, 2> hashes{};
  for (const std::uint32_t are_followed : {0U, 1U}) {
    Universe universe;
    require(abut_universe_follow_islands(universe, are_followed));
    const Shape box = make_box(0.5, 0.5, 0.5);
    std::vector<abut_part_id> parts;
    const abut_sleep sleep = default_sleep();
    for (int i = 0; i < 12; ++i) {
      parts.push_back(universe.add_part(at(0.99 * (i + i / 4), 0, 0)));
      universe.add_geometry(parts.back(), box);
      if (i != 5) require(abut_part_set_sleep(universe, parts.back(), &sleep));
    }
    for (int step = 0; step < 30; ++step) {
      if (step == 20) universe.move(parts[9], at(20, 5, 0));
      require(abut_universe_step(universe, 0.01));
      hashes.at(are_followed) = hashes.at(are_followed) * 31 + universe.hash();
      if (step == 15) EXPECT_EQ(universe.stats().asleep, 8U) << "all but those that touch the one that never sleeps";
    }
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
