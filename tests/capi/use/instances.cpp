// SPDX-License-Identifier: Apache-2.0
// Several universes with the same shapes: each goes its own way, to the bit. PL-03 of the specification.
#include <cmath>
#include <thread>

#include "support.hpp"

namespace {

using namespace abut_test;

// A crowd of bodies of all kinds that swim about over terrain. Which way depends on a number.
class Crowd {
 public:
  Crowd(const std::vector<Shape>& shapes, int number) : number_(number) {
    for (int i = 0; i < bodies; ++i) {
      parts_.push_back(universe.add_part(pose_of(i, 0)));
      universe.add_geometry(parts_.back(), shapes.at(static_cast<std::size_t>(i) % moving_kinds));
    }
    universe.add(shapes.at(terrain), at(0, 0, -1), ABUT_MOTION_STATIC);
  }

  // What a step found: its hash, and its contacts but for the generations of ids.
  void step() {
    ++steps_;
    for (int i = 0; i < bodies; ++i) universe.move(parts_.at(static_cast<std::size_t>(i)), pose_of(i, steps_));
    for (abut_contact contact : universe.step()) {
      const bool is_ours =
          universe.describe(contact.geometry_a).part.slot != 0 && universe.describe(contact.geometry_b).part.slot != 0;
      EXPECT_TRUE(is_ours) << "a contact of another universe";
      contact.geometry_a.generation = contact.geometry_b.generation = 0;
      found.push_back(std::bit_cast<std::array<unsigned char, sizeof contact>>(contact));
    }
    hashes.push_back(universe.hash());
  }

  Universe universe;
  std::vector<std::uint64_t> hashes;
  std::vector<std::array<unsigned char, sizeof(abut_contact)>> found;

 private:
  static constexpr int bodies = 40;
  static constexpr std::size_t moving_kinds = 3, terrain = 6;

  abut_pose pose_of(int body, int step) const {
    const double turn = 0.1 * body + 0.07 * step + number_;
    return {{2 * std::sin(1.3 * body + 0.05 * step + number_), 2 * std::sin(2.1 * body - 0.04 * step),
             std::cos(1.7 * body + 0.03 * step)},
            {std::cos(turn), 0.6 * std::sin(turn), 0.8 * std::sin(turn), 0}};
  }

  int number_;
  int steps_ = 0;
  std::vector<abut_part_id> parts_;
};

constexpr int steps = 25;

void run(Crowd& crowd) {
  for (int i = 0; i < steps; ++i) crowd.step();
}

void expect_same(const Crowd& crowd, const Crowd& alone) {
  EXPECT_EQ(crowd.hashes, alone.hashes);
  EXPECT_TRUE(crowd.found == alone.found);
}

class Instances : public testing::Test {
 protected:
  Instances() {
    run(first_alone);
    run(second_alone);
    EXPECT_NE(first_alone.hashes, second_alone.hashes) << "they have to differ";
    EXPECT_GT(first_alone.found.size(), 1000U);
    EXPECT_GT(second_alone.found.size(), 1000U);
  }

  const std::vector<Shape> shapes = make_one_of_each_kind(), others = make_one_of_each_kind();
  Crowd first_alone{shapes, 1}, second_alone{others, 2};
};

TEST_F(Instances, DoNotSeeEachOtherWhenTheyTakeTurns) {
  const std::vector<Shape> shared = make_one_of_each_kind();
  Crowd first(shared, 1), second(shared, 2);
  for (int i = 0; i < steps; ++i) {
    first.step();
    second.step();
  }
  expect_same(first, first_alone);
  expect_same(second, second_alone);
}

// Shapes are new each time, so that both threads are the first to ask for what a shape prepares when it is needed.
TEST_F(Instances, DoNotSeeEachOtherAtTheSameTime) {
  for (int round = 0; round < 4; ++round) {
    const std::vector<Shape> shared = make_one_of_each_kind();
    Crowd first(shared, 1), second(shared, 2);
    std::thread other([&] { run(second); });
    run(first);
    other.join();
    expect_same(first, first_alone);
    expect_same(second, second_alone);
  }
}

}  // namespace
