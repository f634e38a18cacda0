// SPDX-License-Identifier: Apache-2.0
// The same bits for any number of threads, and the hash that tells.
#include <cmath>
#include <filesystem>
#include <iterator>

#include "box_world.hpp"

namespace {

using namespace abut_test;

// How many threads a step runs on, as the plan says.
std::string threads_in(const abut_universe* universe) {
  std::size_t needed = 0;
  EXPECT_TRUE(succeeded(abut_universe_explain(universe, nullptr, 0, &needed)));
  std::string text(needed, ' ');
  EXPECT_TRUE(succeeded(abut_universe_explain(universe, text.data(), text.size(), &needed)));
  const std::size_t begin = text.find("\nthreads: ");
  return begin == std::string::npos ? text : text.substr(begin + 10, text.find('\n', begin + 1) - begin - 10);
}

// The hashes of the steps of a crowd of balls, boxes and capsules that swim about over a plane.
std::vector<std::uint64_t> hashes_with(std::uint32_t threads, abut_broadphase broadphase) {
  abut_universe_options options = default_universe_options();
  options.threads = threads_of_build(threads);
  options.broadphase = broadphase;
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
  Universe universe(&options);
  const std::vector<Shape> shapes = make_one_of_each_kind();
  std::vector<abut_part_id> parts;
  const auto pose_of = [](int body, int step) {
    const double turn = 0.1 * body + 0.07 * step;
    return abut_pose{{4 * std::sin(1.3 * body + 0.03 * step), 4 * std::sin(2.1 * body - 0.02 * step),
                      4 * std::cos(1.7 * body + 0.01 * step)},
                     {std::cos(turn), 0.6 * std::sin(turn), 0.8 * std::sin(turn), 0}};
  };
  constexpr int bodies = 350;
  for (int i = 0; i < bodies; ++i) {
    parts.push_back(universe.add_part(pose_of(i, 0)));
    universe.add_geometry(parts.back(), shapes.at(static_cast<std::size_t>(i) % 3));
  }
  universe.add(shapes.at(3), at(0, 0, -3), ABUT_MOTION_STATIC);
  std::vector<std::uint64_t> hashes;
  for (int step = 0; step < 10; ++step) {
    for (int i = 0; i < bodies; i += 1 + step % 3)
      universe.move(parts.at(static_cast<std::size_t>(i)), pose_of(i, step));
    EXPECT_GT(universe.step().size(), 500U);
    hashes.push_back(universe.hash());
  }
#ifdef ABUT_TEST_THREADS
  EXPECT_EQ(threads_in(universe), std::to_string(threads == 0 ? ABUT_TEST_THREADS : threads));
#endif
  return hashes;
}

TEST(Threads, HaveTheSameBitsWhateverTheirNumber) {
  for (const auto broadphase :
       {ABUT_BROADPHASE_AUTO, ABUT_BROADPHASE_TREE, ABUT_BROADPHASE_SWEEP_AND_PRUNE, ABUT_BROADPHASE_HASH_GRID}) {
    const auto expected = hashes_with(1, broadphase);
    EXPECT_EQ(std::set<std::uint64_t>(expected.begin(), expected.end()).size(), expected.size())
        << "the scene has to change";
    for (const std::uint32_t threads : {2U, 3U, 7U, 0U}) {
      EXPECT_EQ(hashes_with(threads, broadphase), expected) << threads << " threads, broad phase " << broadphase;
    }
  }
}

#ifdef ABUT_TEST_THREADS
// What the system knows of this process: whoever steps on seven threads has started more than one beside the first.
TEST(Threads, AreStartedWhereTheyAreAskedFor) {
  const auto count = [] {
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return std::distance(begin(tasks), end(tasks));
  };
  hashes_with(1, ABUT_BROADPHASE_TREE);
  const auto before = count();
  hashes_with(7, ABUT_BROADPHASE_TREE);
  EXPECT_GT(count(), 2);
  EXPECT_LE(before, count());
}
#endif

TEST(Threads, FollowTheModelOfEventsToo) {
  abut_universe_options options = default_universe_options();
  options.threads = threads_of_build(3);
  BoxWorld world(options, 20250117, 60);
  for (int step = 0; step < 100; ++step) {
    const auto expected = world.foretell();
    world.universe().step();
    ASSERT_EQ(changes_of(world.universe().events()), expected) << "step " << step;
    world.edit();
  }
}

// Two balls that touch, a hash, and everything that has to change it.
TEST(Hash, IsThatOfEveryBitOfContactsAndEvents) {
  const Shape ball = make_sphere(1.0);
  struct Pair {
    Universe universe;
    abut_part_id part{};
  };
  const auto prepare = [&](Pair& pair) {
    pair.universe.add(ball, identity);
    pair.part = pair.universe.add_part(at(1, 0, 0));
    pair.universe.add_geometry(pair.part, ball);
    pair.universe.step();
  };
  Pair one, other;
  prepare(one);
  prepare(other);
  EXPECT_EQ(one.universe.hash(), other.universe.hash()) << "generations of ids are not part of it";
  const std::uint64_t value = 7;
  ASSERT_TRUE(succeeded(abut_contacts_set_user_data(one.universe, &value, 1)));
  EXPECT_NE(one.universe.hash(), other.universe.hash()) << "user data are";
  ASSERT_TRUE(succeeded(abut_contacts_set_user_data(other.universe, &value, 1)));
  EXPECT_EQ(one.universe.hash(), other.universe.hash());
  const std::uint64_t first = one.universe.hash();
  one.universe.step();
  EXPECT_NE(one.universe.hash(), first) << "the contact is older, and the event another";
  const std::uint64_t second = one.universe.hash();
  Pair third;
  prepare(third);
  ASSERT_TRUE(succeeded(abut_contacts_set_user_data(third.universe, &value, 1)));
  for (int i = 0; i < 2; ++i) third.universe.step();
  EXPECT_NE(third.universe.hash(), second) << "nothing but the age differs";
  other.universe.move(other.part, at(1 + 0x1p-52, 0, 0));
  other.universe.step();
  EXPECT_NE(one.universe.hash(), other.universe.hash()) << "one bit of a coordinate is";
}

}  // namespace
