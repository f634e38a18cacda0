// SPDX-License-Identifier: Apache-2.0
// Solids whose faces lie in each other, or end at each other, so that triangles touch but do not cross.
#include <algorithm>
#include <string>

#include "solids.hpp"

namespace {

using namespace solid;

using Three = std::array<double, 3>;

// Two boxes along the axes part along one of them. Negative where they are apart.
double depth_of_boxes(const Three& a, const Three& b, const Three& place) {
  double depth = a[0] + b[0] - std::abs(place[0]);
  for (std::size_t i = 1; i < 3; ++i) depth = std::min(depth, a[i] + b[i] - std::abs(place[i]));
  return depth;
}

test::Surface rectangle(double x, double y) { return {{-x, -y, 0, x, -y, 0, x, y, 0, -x, y, 0}, {0, 1, 2, 0, 2, 3}}; }

void expect_depth(const ShapePtr& a, const ShapePtr& b, const Three& place, double depth, const std::string& what) {
  const abut_pose pose = at(place[0], place[1], place[2]);
  const abut_distance found = distance(a, b, pose);
  const std::vector<abut_contact> touches = contacts(a, b, pose);
  if (depth < 0) {
    EXPECT_GT(found.distance, 0) << what;
    return;
  }
  EXPECT_NEAR(found.distance, -depth, 1e-11) << what;
  EXPECT_LE(found.lower, -depth + 1e-11) << what;
  EXPECT_GE(found.upper, -depth - 1e-11) << what;
  ASSERT_FALSE(touches.empty()) << what;
  EXPECT_NEAR(least_of(touches), -depth, 1e-11) << what;
  if (depth > 0) {
    const abut_vec3& n = found.normal;
    EXPECT_NEAR(distance(a, b, at(place[0] + depth * n.x, place[1] + depth * n.y, place[2] + depth * n.z)).distance, 0,
                1e-11)
        << what;
  }
}

TEST(Flush, CubeInItselfMovedAside) {
  const ShapePtr cube = mesh(box_surface(1, 1, 1));
  for (const double x : {0.5, -0.5, 1.5, 1.999, 1e-3}) {
    expect_depth(cube, cube, {x, 0, 0}, 2 - std::abs(x), "x");
    expect_depth(cube, cube, {0, x, 0}, 2 - std::abs(x), "y");
    expect_depth(cube, cube, {0, 0, x}, 2 - std::abs(x), "z");
  }
  expect_depth(cube, cube, {0, 0, 0}, 2, "the same place");
}

// Of those that only touch, no depth.
TEST(Flush, CubesSideBySideTouch) {
  const ShapePtr cube = mesh(box_surface(1, 1, 1));
  for (const Three& place : {Three{2, 0, 0}, Three{0, 2, 0}, Three{0, 0, -2}, Three{2, 0.5, 0}, Three{2, 2, 0},
                             Three{2, 2, 2}, Three{2, 1, 1}}) {
    expect_depth(cube, cube, place, 0, "touching");
  }
}

// The L of (0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2), one high. Its notch is a cube of side 1.
test::Surface corner() {
  test::Surface out;
  const std::array<std::array<double, 2>, 6> around{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : around) out.xyz.insert(out.xyz.end(), {x, y, z});
  }
  out.triangles = {9, 10, 11, 9, 11, 6, 9, 6, 7, 9, 7, 8, 3, 5, 4, 3, 0, 5, 3, 1, 0, 3, 2, 1};
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    out.triangles.insert(out.triangles.end(), {i, next, next + 6, i, next + 6, i + 6});
  }
  return out;
}

// Boxes around both overlap, and the cube has both faces of the notch, but no volume is shared.
TEST(Flush, CubeInANotchTouches) {
  const ShapePtr notched = mesh(corner()), cube = mesh(box_surface(0.5, 0.5, 0.5));
  expect_depth(notched, cube, {1.5, 1.5, 0.5}, 0, "in the notch");
  expect_depth(notched, cube, {1.5, 1.5, 0.25}, 0, "in the notch, lower");
  expect_depth(notched, cube, {1.25, 1.5, 0.5}, 0.25, "in a wall");
  expect_depth(notched, cube, {1.5, 1.125, 0.5}, 0.375, "in the other wall");
  const abut_distance both = distance(notched, cube, at(1.25, 1.25, 0.5));
  EXPECT_NEAR(both.distance, -0.25 * std::sqrt(2), 1e-11);
}

class Boxes {
 public:
  explicit Boxes(std::uint32_t seed) : random_(seed) {}
  Three half() { return {size_(random_) / 1.0, size_(random_) / 1.0, size_(random_) / 1.0}; }
  Three place() { return {place_(random_) / 1.0, place_(random_) / 1.0, place_(random_) / 1.0}; }

 private:
  std::mt19937 random_;
  std::uniform_int_distribution<int> size_{1, 4}, place_{-5, 5};
};

TEST(Flush, BoxesOfWholeNumbers) {
  constexpr std::uint32_t seed = 11;
  Boxes boxes(seed);
  for (int i = 0; i < 500; ++i) {
    const Three a = boxes.half(), b = boxes.half(), place = boxes.place();
    expect_depth(mesh(box_surface(a[0], a[1], a[2])), mesh(box_surface(b[0], b[1], b[2])), place,
                 depth_of_boxes(a, b, place), "seed " + std::to_string(seed) + " pair " + std::to_string(i));
  }
}

TEST(Flush, RectanglesOfWholeNumbersInBoxes) {
  constexpr std::uint32_t seed = 12;
  Boxes boxes(seed);
  for (int i = 0; i < 500; ++i) {
    const Three a = boxes.half(), b = boxes.half(), place = boxes.place();
    expect_depth(mesh(box_surface(a[0], a[1], a[2])), mesh(rectangle(b[0], b[1]), ABUT_SIDES_BOTH), place,
                 depth_of_boxes(a, {b[0], b[1], 0}, place),
                 "seed " + std::to_string(seed) + " pair " + std::to_string(i));
  }
}

}  // namespace
