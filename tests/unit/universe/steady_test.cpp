// SPDX-License-Identifier: Apache-2.0
// Scenes that go on as they are: nothing grows, and nothing is done twice.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.universe;

namespace {

using namespace abut;

ShapeHandle make(std::string_view kind, const std::vector<Real>& parameters) {
  return ShapeHandle(make_shape(find_kind(kind).value(), parameters, {}, {}).value());
}

// A block of bodies that overlap their neighbours, each swaying by a few millimetres.
class Block {
 public:
  explicit Block(std::size_t count, const UniverseOptions& options = {}) : universe(options, 1) {
    const std::array shapes{make("sphere", {0.55}), make("box", {0.5, 0.45, 0.5}), make("capsule", {0.4, 0.3}),
                            make("cylinder", {0.5, 0.5})};
    for (std::size_t i = 0; i < count; ++i) {
      placements.push_back({{double(i % 5), double(i / 5 % 5), double(i / 25)}, {1, 0, 0, 0}});
      const PartOptions part{.placement = placements.back()};
      parts.push_back(universe.create_parts(std::span(&part, 1)).value()[0]);
      const ShapeHandle& shape = shapes[i % shapes.size()];
      geometries.push_back(
          universe.create_geometries(std::span(&parts.back(), 1), std::span(&shape, 1), {}).value()[0]);
    }
  }

  void move(std::size_t frame) {
    std::vector<Placement> moved = placements;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      moved[i].position.x += 0.004 * double((frame + i) % 5);
      moved[i].position.z -= 0.003 * double((frame + 2 * i) % 7);
    }
    ASSERT_TRUE(universe.set_poses(parts, moved).has_value());
  }
  void step() { ASSERT_TRUE(universe.step(0.01).has_value()); }

  Universe universe;
  std::vector<Placement> placements;
  std::vector<PartId> parts;
  std::vector<GeometryId> geometries;
};

TEST(SteadyUniverse, HoldsAsMuchMemoryAfterManySteps) {
  Block block(75);
  const auto run = [&] {
    for (std::size_t frame = 0; frame < 70; ++frame) {
      block.move(frame);
      block.step();
    }
    return block.universe.stats().bytes;
  };
  const std::uint64_t bytes = run();
  EXPECT_EQ(run(), bytes);
  EXPECT_EQ(run(), bytes);
}

// All of them sleep and wake again and again.
TEST(SteadyUniverse, HoldsAsMuchMemoryWithPartsThatSleep) {
  Block block(75);
  const std::vector<std::optional<Sleep>> thresholds(75, Sleep{.steps = 2});
  ASSERT_TRUE(block.universe.set_sleep(block.parts, thresholds).has_value());
  std::size_t asleep = 0;
  const auto run = [&] {
    for (std::size_t frame = 0; frame < 70; ++frame) {
      if (frame % 10 == 0) {
        block.move(frame);
      }
      block.step();
      asleep += block.universe.stats().asleep;
    }
    return block.universe.stats().bytes;
  };
  run();
  const std::uint64_t bytes = run();
  EXPECT_EQ(run(), bytes);
  EXPECT_EQ(run(), bytes);
  EXPECT_GT(asleep, 75U * 4 * 21);
}

TEST(SteadyUniverse, ExaminesNothingThatStays) {
  Block block(75);
  block.step();
  EXPECT_EQ(block.universe.stats().examined_pairs, block.universe.stats().candidate_pairs);
  const std::size_t contacts = block.universe.contacts().size();
  ASSERT_GT(contacts, 75U);
  block.step();
  EXPECT_EQ(block.universe.stats().examined_pairs, 0U);
  EXPECT_EQ(block.universe.stats().moved, 0U);
  EXPECT_EQ(block.universe.contacts().size(), contacts);
  EXPECT_EQ(block.universe.contacts()[0].age, 1U);
}

TEST(SteadyUniverse, ExaminesThePairsOfWhatMovesOnly) {
  Block block(75);
  block.step();
  Placement moved = block.placements[37];
  moved.position.x += 0.01;
  ASSERT_TRUE(block.universe.set_poses(std::span(&block.parts[37], 1), std::span(&moved, 1)).has_value());
  block.step();
  EXPECT_EQ(block.universe.stats().moved, 1U);
  EXPECT_GT(block.universe.stats().examined_pairs, 0U);
  EXPECT_LT(block.universe.stats().examined_pairs, 27U);
}

TEST(SteadyUniverse, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> expected;
  for (const std::uint32_t threads : {1U, 2U, 3U, 8U}) {
    Block block(250, {.threads = threads, .events = event_pairs | event_persist | event_contacts});
    std::vector<std::uint64_t> hashes;
    for (std::size_t frame = 0; frame < 12; ++frame) {
      block.move(frame);
      block.step();
      hashes.push_back(block.universe.hash());
    }
#ifdef ABUT_TEST_THREADS
    EXPECT_NE(block.universe.explain().find("threads: " + std::to_string(threads) + "\n"), std::string::npos)
        << block.universe.explain();
#endif
    expected = expected.empty() ? hashes : expected;
    EXPECT_EQ(hashes, expected) << threads << " threads";
  }
}

TEST(SteadyUniverse, HashesEveryBitOfItsContacts) {
  Block block(30), other(30);
  block.step();
  other.step();
  EXPECT_EQ(block.universe.hash(), other.universe.hash());
  std::vector<std::uint64_t> values(block.universe.contacts().size());
  values.back() = 1;
  ASSERT_TRUE(block.universe.set_contact_user_data(values).has_value());
  EXPECT_NE(block.universe.hash(), other.universe.hash());
}

}  // namespace
