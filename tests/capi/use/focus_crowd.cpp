// SPDX-License-Identifier: Apache-2.0
// The focus in a crowd: every tag of every step, under every broad phase and on several threads. FW-2 of the
// specification.
#include <cmath>

#include "support.hpp"

namespace {

using namespace abut_test;

constexpr std::uint32_t near_tag = 1, far_tag = 2;
constexpr double near_distance = 2.3, far_distance = 3.8;

// Numbers that are the same everywhere (Knuth, The Art of Computer Programming 2, 3.3.4; modulus 2^64).
struct Numbers {
  std::uint64_t state = 12345;
  int below(int count) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<int>((state >> 33) % static_cast<std::uint64_t>(count));
  }
};

// A crowd of cubes that move in eighths, with centres that now and then move too, and the tags that they should have.
// With these distances no square of a distance between eighths comes near to a square of a border.
class Crowd {
 public:
  Crowd(std::uint32_t threads, abut_broadphase broadphase) : universe(options_of(threads, broadphase)) {
    abut_policy coarse = default_policy();
    coarse.detail = ABUT_DETAIL_POINT;
    coarse.period = 3;
    EXPECT_TRUE(succeeded(abut_policy_set(universe, near_tag, far_tag, &coarse)));
    coarse.detail = ABUT_DETAIL_BOX;
    EXPECT_TRUE(succeeded(abut_policy_set(universe, far_tag, far_tag, &coarse)));
    abut_geometry_options options = default_geometry_options();
    options.tag = far_tag;
    for (std::size_t i = 0; i < size; ++i) {
      cubes.push_back({universe.add_part(identity), {}, {}, far_tag});
      cubes.back().geometry = universe.add_geometry(cubes.back().part, cube, options);
      place(cubes.back());
    }
  }

  void step(int number) {
    for (std::size_t i = static_cast<std::size_t>(number) % 5; i < size; i += 5) place(cubes.at(i));
    if (number % 3 == 0) {
      for (abut_vec3& centre : centres) centre = random();
    }
    const abut_focus focus = make_focus(near_tag, far_tag, near_distance, far_distance);
    EXPECT_TRUE(succeeded(abut_universe_set_focus(universe, &focus, centres.data(), centres.size())));
    universe.step();
    for (Cube& its : cubes) {
      const std::uint32_t before = its.tag;
      its.tag = expected(its);
      switches += its.tag != before ? 1 : 0;
      ASSERT_EQ(universe.describe(its.geometry).tag, its.tag) << "step " << number;
    }
  }

  Universe universe;
  int switches = 0;

 private:
  struct Cube {
    abut_part_id part;
    abut_geometry_id geometry;
    abut_vec3 position;
    std::uint32_t tag;
  };
  static constexpr std::size_t size = 150;

  static abut_universe_options* options_of(std::uint32_t threads, abut_broadphase broadphase) {
    static abut_universe_options options;
    options = default_universe_options();
    options.threads = threads_of_build(threads);
    options.broadphase = broadphase;
    return &options;
  }
  abut_vec3 random() { return {0.125 * numbers.below(80), 0.125 * numbers.below(80), 0.125 * numbers.below(40)}; }
  void place(Cube& its) {
    its.position = random();
    universe.move(its.part, {its.position, no_rotation});
  }
  std::uint32_t expected(const Cube& its) const {
    double least = 1e9;
    for (const abut_vec3& centre : centres) {
      const auto outside = [](double a, double b) { return std::max(std::abs(a - b) - 0.5, 0.0); };
      least = std::min(least, std::hypot(outside(centre.x, its.position.x), outside(centre.y, its.position.y),
                                         outside(centre.z, its.position.z)));
    }
    return least < near_distance ? near_tag : least > far_distance ? far_tag : its.tag;
  }

  Numbers numbers;
  Shape cube = make_box(0.5, 0.5, 0.5);
  std::vector<Cube> cubes;
  std::array<abut_vec3, 2> centres{};
};

TEST(FocusOfACrowd, FollowsTheDistancesAndHasTheSameBitsWhateverRuns) {
  std::vector<std::uint64_t> expected;
  for (const abut_broadphase broadphase : broadphases) {
    for (const std::uint32_t threads : {1U, 3U}) {
      Crowd crowd(threads, broadphase);
      std::vector<std::uint64_t> hashes;
      for (int step = 0; step < 30; ++step) {
        ASSERT_NO_FATAL_FAILURE(crowd.step(step));
        hashes.push_back(crowd.universe.hash());
      }
      EXPECT_GT(crowd.switches, 300);
      if (expected.empty()) expected = hashes;
      EXPECT_EQ(hashes, expected) << threads << " threads, broad phase " << broadphase;
    }
  }
}

}  // namespace
