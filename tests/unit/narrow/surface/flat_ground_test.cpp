// SPDX-License-Identifier: Apache-2.0
// Which triangles count as flat ground. Truths are the scenes themselves: each is flat and whole, or has one fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

import abut.capability;
import abut.math;
import abut.narrow.surface.flat_ground;
import abut.narrow.surface.flat_patch;
import abut.narrow.surface.triangle_source;

namespace {

using abut::Aabb;
using abut::FourTriangles;
using abut::Real;
using abut::Triangle;
using abut::TriangleCorners;
using abut::Vec3;

// Triangles one after the other, in fours.
class Soup final : public abut::TriangleSource {
 public:
  Soup() = default;
  Soup(const Soup& other) : TriangleSource(), triangles(other.triangles), its_sides(other.its_sides) {}
  Soup& operator=(const Soup&) = delete;
  ~Soup() override = default;

  std::vector<TriangleCorners> triangles;
  abut::StoppingSides its_sides = abut::StoppingSides::both;

  void visit(const Aabb& box, const TakeFour& take) const override {
    for (std::uint32_t first = 0; first < triangles.size(); first += 4) {
      const auto at = [&](std::uint32_t lane) {
        return std::min(first + lane, static_cast<std::uint32_t>(triangles.size() - 1));
      };
      const FourTriangles four = FourTriangles::of(triangles[at(0)], triangles[at(1)], triangles[at(2)],
                                                   triangles[at(3)], {at(0), at(1), at(2), at(3)});
      const std::uint64_t present = (std::uint64_t{1} << std::min<std::size_t>(4, triangles.size() - first)) - 1;
      const std::uint64_t some = present & four.overlapping(box);
      if (some != 0 && !take(four, some)) {
        return;
      }
    }
  }
  [[nodiscard]] Triangle part(std::uint32_t number) const override { return {triangles[number], number, false}; }
  [[nodiscard]] Triangle part_near(const Vec3&) const override { return part(0); }
  [[nodiscard]] bool is_crest(std::uint32_t, unsigned, const Vec3&, Real) const override { return true; }
  [[nodiscard]] abut::StoppingSides sides() const override { return its_sides; }
  // Flat ground asks for nothing else.
  [[nodiscard]] Aabb box() const override { return Aabb::everything(); }
  [[nodiscard]] std::uint64_t one_sided(const FourTriangles&) const override { return 0; }
  [[nodiscard]] std::uint64_t holding(const FourTriangles&) const override { return 0; }
  [[nodiscard]] bool is_terrain() const override { return false; }
  [[nodiscard]] bool contains(const Vec3&) const override { return false; }
  [[nodiscard]] std::optional<abut::WayToSurface> way_to_surface(const Vec3&, const Vec3&) const override {
    return std::nullopt;
  }
  [[nodiscard]] abut::PointOnSurface nearest(const Vec3&) const override { return {}; }
};

constexpr int side = 6;  // cells of size 1, from -3 to 3

// `height_at`: of the point of the grid.
template <class HeightAt>
Soup floor_with(const HeightAt& height_at) {
  Soup soup;
  const auto at = [&](int i, int j) { return Vec3{i - 3.0, j - 3.0, height_at(i, j)}; };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}
Soup flat_floor() {
  return floor_with([](int, int) { return 0.0; });
}
// Heights are noise of an amplitude, rounded to float.
Soup rough_floor(Real amplitude, std::mt19937_64& random) {
  std::uniform_real_distribution<Real> noise(-amplitude, amplitude);
  std::array<std::array<Real, side + 1>, side + 1> heights{};
  for (auto& row : heights) {
    for (Real& height : row) {
      height = static_cast<Real>(static_cast<float>(noise(random)));
    }
  }
  return floor_with([&](int i, int j) { return heights[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; });
}

class BallAt final : public abut::GroundBody {
 public:
  BallAt(const Vec3& place, Real its_radius)
      : GroundBody(place, Aabb{place, place}.inflated(its_radius), its_radius, its_radius) {}
  [[nodiscard]] abut::Extremes along(const Vec3&) const override { return {centre, centre}; }
};

bool is_flat(const Soup& soup, const Vec3& place = {0.1, 0.2, 0.4}) {
  return abut::flat_ground(soup, BallAt(place, 0.5), 0, abut::infinity).has_value();
}

TEST(FlatGround, IsAPlaneWithTheNormalOfTheNearerSide) {
  const Soup soup = flat_floor();
  const auto above = abut::flat_ground(soup, BallAt({0.1, 0.2, 0.4}, 0.5), 0, abut::infinity);
  const auto below = abut::flat_ground(soup, BallAt({0.1, 0.2, -0.3}, 0.5), 0, abut::infinity);
  ASSERT_TRUE(above && below);
  EXPECT_EQ(above->normal(), (Vec3{0, 0, 1}));
  EXPECT_EQ(below->normal(), (Vec3{0, 0, -1}));
  EXPECT_EQ(above->offset(), 0);
}

TEST(FlatGround, EndsAtABorderNearTheBody) {
  EXPECT_FALSE(is_flat(flat_floor(), {2.6, 0, 0.4}));
  EXPECT_TRUE(is_flat(flat_floor(), {2.3, 0, 0.4}));
}

TEST(FlatGround, HasNoGap) {
  for (std::size_t missing = 0; missing < 2 * side * side; ++missing) {
    Soup soup = flat_floor();
    const Aabb box = abut::box_around(soup.triangles[missing]);
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(missing));
    const bool is_near = box.overlaps(Aabb{{-0.4, -0.3, 0}, {0.6, 0.7, 0}});
    if (is_near) {
      EXPECT_FALSE(is_flat(soup)) << missing;
    }
  }
}

TEST(FlatGround, HasNoStepAndNoCrease) {
  EXPECT_FALSE(is_flat(floor_with([](int i, int) { return i > 3 ? 0.01 : 0.0; })));
  EXPECT_FALSE(is_flat(floor_with([](int i, int) { return i > 3 ? 0.001 * (i - 3) : 0.0; })));
}

TEST(FlatGround, HasNoCrack) {
  Soup soup = flat_floor();
  for (TriangleCorners& corners : soup.triangles) {
    if (corners[0].x + corners[1].x + corners[2].x > 0) {
      for (Vec3& corner : corners) {
        corner.x += 1e-9;
      }
    }
  }
  EXPECT_FALSE(is_flat(soup));
}

TEST(FlatGround, MayBeWoundAnyWayWhereBothSidesCount) {
  Soup soup = flat_floor();
  for (std::size_t i = 0; i < soup.triangles.size(); i += 3) {
    std::swap(soup.triangles[i][1], soup.triangles[i][2]);
  }
  EXPECT_TRUE(is_flat(soup));
  soup.its_sides = abut::StoppingSides::front;
  EXPECT_FALSE(is_flat(soup));
}

// Triangles may lie on each other. Of an even number of layers nobody knows that they leave no gap.
TEST(FlatGround, CountsLayers) {
  const Soup soup = flat_floor();
  Soup twice = soup, thrice = soup;
  twice.triangles.insert(twice.triangles.end(), soup.triangles.begin(), soup.triangles.end());
  for (int i = 0; i < 2; ++i) {
    thrice.triangles.insert(thrice.triangles.end(), soup.triangles.begin(), soup.triangles.end());
  }
  EXPECT_FALSE(is_flat(twice));
  EXPECT_TRUE(is_flat(thrice));
}

TEST(FlatGround, TrianglesWithoutAreaAreHarmlessWithinIt) {
  Soup soup = flat_floor();
  soup.triangles.push_back({Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{1, 1, 0}});
  EXPECT_TRUE(is_flat(soup));
  soup.triangles.push_back({Vec3{0, 0, 0}, Vec3{0.25, 0.25, 0}, Vec3{1, 1, 0}});  // lies on an edge
  EXPECT_TRUE(is_flat(soup));
  soup.triangles.push_back({Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 0, 0.3}});  // sticks out
  EXPECT_FALSE(is_flat(soup));
}

// Two triangles beside a longer one, with one without area in the joint.
TEST(FlatGround, TriangleWithoutAreaFillsAJoint) {
  const Vec3 a{-3, -3, 0}, b{3, -3, 0}, c{3, 3, 0}, d{-3, 3, 0}, middle{0, 0, 0};
  Soup soup;
  soup.triangles = {{a, b, c}, {a, middle, d}, {middle, c, d}};
  EXPECT_FALSE(is_flat(soup));
  soup.triangles.push_back({a, c, middle});
  EXPECT_TRUE(is_flat(soup));
}

// Vertices in rounded numbers: as thin as they make the ground, it is flat, and its interval says how thin.
TEST(FlatGround, MayBeThinInPlaceOfFlat) {
  std::mt19937_64 random(5);
  const Soup soup = rough_floor(1e-7, random);
  const auto ground = abut::flat_ground(soup, BallAt({0.1, 0.2, 0.4}, 0.5), 0, abut::infinity);
  ASSERT_TRUE(ground);
  abut::Distance distance{};
  distance.distance = -0.1;
  ground->widen(distance);
  EXPECT_GT(distance.upper - distance.lower, 1e-8);
  EXPECT_LT(distance.upper - distance.lower, 3e-7);
  EXPECT_LT(abut::norm(ground->normal() - Vec3{0, 0, 1}), 1e-7);
  EXPECT_FALSE(is_flat(rough_floor(1e-4, random)));
  EXPECT_FALSE(is_flat(floor_with([](int i, int j) { return 1e-7 / (1 + i + 7 * j); })));  // no floats
}

TEST(FlatGround, OrderOfTrianglesChangesNoBit) {
  std::mt19937_64 random(7);
  Soup soup = rough_floor(1e-7, random);
  const BallAt ball({0.1, 0.2, 0.4}, 0.5);
  const auto first = abut::flat_ground(soup, ball, 0, abut::infinity);
  ASSERT_TRUE(first);
  for (int round = 0; round < 100; ++round) {
    std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
    const auto ground = abut::flat_ground(soup, ball, 0, abut::infinity);
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->normal(), first->normal());
    EXPECT_EQ(ground->offset(), first->offset());
  }
}

}  // namespace
