// SPDX-License-Identifier: Apache-2.0
// A shape that was prepared gives the bits that it would have given anyway, on however many threads that was.
#include <cmath>
#include <cstring>
#include <vector>

#include "support.hpp"

namespace {

using namespace abut_test;

struct Waves {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;

  // So many triangles that their tree is made in several tasks.
  Waves() {
    constexpr std::uint32_t side = 130;
    for (std::uint32_t j = 0; j < side; ++j) {
      for (std::uint32_t i = 0; i < side; ++i) {
        const double x = 0.1 * i, y = 0.1 * j;
        xyz.insert(xyz.end(), {x, y, 0.4 * std::sin(1.3 * x) * std::cos(0.9 * y) + 0.01 * ((7 * i + 3 * j) % 5)});
        if (i + 1 < side && j + 1 < side) {
          const std::uint32_t at = j * side + i;
          triangles.insert(triangles.end(), {at, at + 1, at + side + 1, at, at + side + 1, at + side});
        }
      }
    }
  }
  [[nodiscard]] Shape mesh() const { return make_of_kind("mesh", {0}, xyz, triangles); }
};

// The contacts of a slab across some of the waves, then of balls all over them, as they were found.
// Which of its triangles a ball has contacts with, their neighbours tell.
std::vector<abut_contact> contacts_with(const abut_shape* shape) {
  std::vector<abut_contact> all =
      contacts_of(shape, identity, make_box(2.0, 1.5, 0.1), {{6.0, 5.0, 0.2}, {1.0, 0.0, 0.0, 0.0}});
  const Shape ball = make_sphere(0.3);
  for (int j = 0; j < 50; ++j) {
    for (int i = 0; i < 50; ++i) {
      const double x = 0.15 + 0.25 * i, y = 0.1 + 0.25 * j;
      const abut_pose above{{x, y, 0.4 * std::sin(1.3 * x) * std::cos(0.9 * y) + 0.25}, {1.0, 0.0, 0.0, 0.0}};
      const std::vector<abut_contact> found = contacts_of(shape, identity, ball, above);
      all.insert(all.end(), found.begin(), found.end());
    }
  }
  return all;
}

TEST(PreparedShapes, GiveTheSameBitsForAnyNumberOfThreads) {
  const Waves waves;
  const std::vector<abut_contact> wanted = contacts_with(waves.mesh());
  ASSERT_GT(wanted.size(), 2600U);
  for (const std::uint32_t threads : {0U, 1U, 2U, 8U}) {
    const Shape shape = waves.mesh();
    ASSERT_TRUE(succeeded(abut_shape_prepare(shape, threads_of_build(threads))));
    const std::vector<abut_contact> found = contacts_with(shape);
    ASSERT_EQ(found.size(), wanted.size());
    EXPECT_EQ(std::memcmp(found.data(), wanted.data(), wanted.size() * sizeof(abut_contact)), 0) << threads;
  }
}

TEST(PreparedShapes, MayBeOfAnyKindAndPreparedAgain) {
  for (const Shape& shape : make_one_of_each_kind()) {
    EXPECT_TRUE(succeeded(abut_shape_prepare(shape, 0)));
    EXPECT_TRUE(succeeded(abut_shape_prepare(shape, 1)));
  }
}

}  // namespace
