// SPDX-License-Identifier: Apache-2.0
// Islands against a search of the graph, over many detections that connect and part at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

import abut.detect.lists.islands;
import abut.scene.state.options;

namespace {

using namespace abut;

using Link = std::pair<std::uint32_t, std::uint32_t>;
using Slots = std::set<std::uint32_t>;

// The slots that links lead to from one, breadth first.
Slots reached_from(std::uint32_t start, const std::vector<Link>& links) {
  Slots reached{start};
  std::vector<std::uint32_t> front{start};
  while (!front.empty()) {
    const std::uint32_t at = front.back();
    front.pop_back();
    for (const auto& [a, b] : links) {
      const std::uint32_t other = a == at ? b : b == at ? a : at;
      if (reached.insert(other).second) {
        front.push_back(other);
      }
    }
  }
  return reached;
}

// Parts with generations, and the islands of one detection after the other.
class World {
 public:
  explicit World(std::uint32_t slots) : generations_(slots + 1, 1), are_there_(slots + 1, true) {}

  std::uint32_t slots() const { return static_cast<std::uint32_t>(generations_.size()) - 1; }
  bool is_there(std::uint32_t slot) const { return are_there_.at(slot); }
  PartId id(std::uint32_t slot) const { return {slot, generations_.at(slot)}; }
  void toggle(std::uint32_t slot) {
    generations_.at(slot) += are_there_.at(slot) ? 1 : 0;
    are_there_.at(slot) = !are_there_.at(slot);
  }
  void detect(const std::vector<Link>& links) {
    links_.start(slots());
    for (const auto& [a, b] : links) {
      links_.join(a, b);
    }
    std::vector<PartId> parts;
    for (std::uint32_t slot = 1; slot <= slots(); ++slot) {
      if (is_there(slot)) {
        parts.push_back(id(slot));
      }
    }
    list.number(parts, links_);
  }
  std::uint64_t island(std::uint32_t slot) const {
    const std::optional<Island> found = list.of(id(slot));
    return found ? found->id : 0;
  }
  Slots parts_of(const Island& island) const {
    Slots slots;
    for (const PartId& part : list.parts().subspan(island.first, island.count)) {
      slots.insert(part.slot);
    }
    return slots;
  }

  IslandList list;

 private:
  IslandLinks links_;
  std::vector<std::uint32_t> generations_;
  std::vector<bool> are_there_;
};

TEST(IslandLinks, StandBehindTheLowestSlotInAnyOrder) {
  std::vector<Link> links;
  for (std::uint32_t i = 1; i < 60; ++i) {
    links.emplace_back(i, i + 1);
  }
  std::mt19937 random(7);
  IslandLinks islands;
  for (int round = 0; round < 20; ++round) {
    std::shuffle(links.begin(), links.end(), random);
    islands.start(62);
    for (const auto& [a, b] : links) {
      round % 2 == 0 ? islands.join(a, b) : islands.join(b, a);
    }
    for (std::uint32_t slot = 1; slot <= 60; ++slot) {
      ASSERT_EQ(islands.root_of(slot), 1U);
    }
    ASSERT_EQ(islands.root_of(61), 61U);
  }
  islands.start(62);
  for (std::uint32_t slot = 1; slot <= 62; ++slot) {
    ASSERT_EQ(islands.root_of(slot), slot) << "each alone again";
  }
}

TEST(IslandList, MergesToTheOlderAndSplitsToTheLowest) {
  World world(4);
  world.detect({});
  EXPECT_EQ(world.island(1), 1U);
  EXPECT_EQ(world.island(4), 4U);
  world.detect({{3, 4}, {1, 2}});
  EXPECT_EQ(world.island(2), 1U);
  EXPECT_EQ(world.island(4), 3U);
  world.detect({{3, 4}, {4, 2}, {1, 2}});
  EXPECT_EQ(world.island(3), 1U) << "the older id";
  world.detect({{3, 4}, {4, 2}});
  EXPECT_EQ(world.island(1), 1U) << "the piece with the lowest slot";
  EXPECT_EQ(world.island(2), 5U) << "the other piece is new";
  EXPECT_EQ(world.island(3), 5U);
}

// A piece that breaks off and joins another island in one detection does not take the id of that one away.
TEST(IslandList, APieceThatChangesSidesTakesTheOtherId) {
  World world(6);
  world.detect({{1, 2}, {2, 3}, {4, 5}, {5, 6}});
  const std::uint64_t left = world.island(1), right = world.island(4);
  world.detect({{1, 2}, {3, 4}, {4, 5}, {5, 6}});
  EXPECT_EQ(world.island(2), left);
  EXPECT_EQ(world.island(3), right);
  EXPECT_EQ(world.island(6), right);
}

TEST(IslandList, AReusedSlotIsAnotherPart) {
  World world(3);
  world.detect({{1, 2}, {2, 3}});
  const std::uint64_t id = world.island(1);
  world.toggle(1);
  world.toggle(1);
  EXPECT_EQ(world.island(1), 0U) << "in no island yet";
  world.detect({{2, 3}});
  EXPECT_EQ(world.island(2), id) << "the lowest of those that are left";
  EXPECT_GT(world.island(1), id);
  world.detect({{1, 2}, {2, 3}});
  EXPECT_EQ(world.island(1), id) << "a newcomer with a lower slot changes no id";
}

// What the rule says about ids, with sets instead of arrays.
std::uint64_t expected_id(const World& world, const Slots& island,
                          const std::map<std::uint64_t, std::vector<PartId>>& before) {
  std::uint64_t least = 0;
  for (const auto& [id, parts] : before) {
    const auto survives = [&](const PartId& part) { return world.is_there(part.slot) && world.id(part.slot) == part; };
    const auto heir = std::find_if(parts.begin(), parts.end(), survives);
    if (heir != parts.end() && island.contains(heir->slot) && (least == 0 || id < least)) {
      least = id;
    }
  }
  return least;
}

void expect_graph(const World& world, const std::vector<Link>& links,
                  const std::map<std::uint64_t, std::vector<PartId>>& before, std::uint64_t newest) {
  std::uint32_t last = 0;
  Slots seen;
  for (const Island& island : world.list.islands()) {
    const Slots slots = world.parts_of(island);
    ASSERT_EQ(slots, reached_from(*slots.begin(), links));
    ASSERT_GT(*slots.begin(), last) << "by the lowest slot";
    last = *slots.begin();
    for (const std::uint32_t slot : slots) {
      ASSERT_TRUE(seen.insert(slot).second) << "each part once";
      ASSERT_EQ(world.island(slot), island.id);
    }
    if (const std::uint64_t heritage = expected_id(world, slots, before); heritage != 0) {
      ASSERT_EQ(island.id, heritage);
    } else {
      ASSERT_GT(island.id, newest) << "never used before";
    }
  }
}

TEST(IslandList, IsTheGraphOfTheTouchesForManyDetections) {
  constexpr unsigned seed = 20;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  World world(40);
  std::vector<Link> links;
  std::map<std::uint64_t, std::vector<PartId>> before;
  std::uint64_t newest = 0;
  for (int detection = 0; detection < 2000; ++detection) {
    for (std::uint32_t i = below(3); i > 0; --i) {
      world.toggle(1 + below(world.slots()));
    }
    for (std::uint32_t i = below(6); i > 0; --i) {
      links.emplace_back(1 + below(world.slots()), 1 + below(world.slots()));
    }
    std::erase_if(links, [&](const Link& link) {
      return !world.is_there(link.first) || !world.is_there(link.second) || below(12) == 0;
    });
    world.detect(links);
    expect_graph(world, links, before, newest);
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "detection " << detection;
    before.clear();
    for (const Island& island : world.list.islands()) {
      const auto parts = world.list.parts().subspan(island.first, island.count);
      ASSERT_TRUE(before.emplace(island.id, std::vector<PartId>(parts.begin(), parts.end())).second) << "each id once";
      newest = std::max(newest, island.id);
    }
  }
}

}  // namespace
