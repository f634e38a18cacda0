// SPDX-License-Identifier: Apache-2.0
// Particles: many balls as one shape.
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "support.hpp"

namespace {

using namespace abut_test;

std::vector<double> cloud(std::size_t count, std::uint64_t seed, double thickness = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<double> xyz;
  for (std::size_t i = 0; i < count; ++i) {
    xyz.push_back(2 * place(random));
    xyz.push_back(place(random));
    xyz.push_back(thickness * place(random));
  }
  return xyz;
}

constexpr abut_pose tilted{{0.3, -0.2, 0.1}, {0.8, 0.6, 0, 0}};

bool is_surface(const abut_shape* shape) {
  const std::string kind = abut_shape_kind_name(abut_shape_kind_of(shape));
  return kind == "mesh" || kind == "height_field" || kind == "uv_grid";
}
// As deep as the deepest ball at least, and after the move none overlaps.
void expect_to_leave_together(const abut_shape* dust, const abut_shape* surface, double least) {
  abut_distance found{}, swapped{};
  ASSERT_EQ(abut_pair_distance(dust, &identity, surface, &tilted, nullptr, &found), ABUT_OK);
  ASSERT_EQ(abut_pair_distance(surface, &tilted, dust, &identity, nullptr, &swapped), ABUT_OK);
  EXPECT_LE(found.distance, least + 1e-12);
  EXPECT_EQ(swapped.distance, found.distance);
  // What is mostly behind a front is let through.
  if (std::string(abut_shape_kind_name(abut_shape_kind_of(surface))) == "height_field") {
    return;
  }
  const abut_pose moved =
      at(found.distance * found.normal.x, found.distance * found.normal.y, found.distance * found.normal.z);
  EXPECT_GT(distance_of(dust, moved, surface, tilted), -1e-9);
}

TEST(Particles, AreBallsOneByOne) {
  // Volumes, layers and lines of them; one, few and many.
  for (const double thickness : {1.0, 0.0}) {
    for (const std::size_t count : {1U, 7U, 400U}) {
      const double radius = 0.04;
      const std::vector<double> xyz = cloud(count, count, thickness);
      const Shape dust = make_of_kind("particles", {radius}, xyz);
      const Shape ball = make_sphere(radius);
      const std::vector<Shape> others = make_one_of_each_kind();
      for (const Shape& other : others) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t touching = 0;
        for (std::size_t i = 0; i < count; ++i) {
          const abut_pose place = at(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
          least = std::min(least, distance_of(ball, place, other, tilted));
          touching += contacts_of(ball, place, other, tilted).empty() ? 0 : 1;
        }
        if (least < 0 && is_surface(other)) {
          expect_to_leave_together(dust, other, least);
        } else {
          EXPECT_NEAR(distance_of(dust, identity, other, tilted), least, 1e-12);
          EXPECT_NEAR(distance_of(other, tilted, dust, identity), least, 1e-12);
        }
        std::vector<bool> seen(count);
        for (const abut_contact& contact : contacts_of(dust, identity, other, tilted)) seen.at(contact.child_a) = true;
        EXPECT_EQ(static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true)), touching);
      }
    }
  }
}

TEST(Particles, MeetEachOtherOnce) {
  const double radius = 0.05;
  const std::vector<double> first = cloud(300, 1), second = cloud(200, 2);
  const Shape a = make_of_kind("particles", {radius}, first), b = make_of_kind("particles", {radius}, second);
  std::size_t expected = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    for (std::size_t k = 0; k < 200; ++k) {
      const double x = first[3 * i] - second[3 * k], y = first[3 * i + 1] - second[3 * k + 1],
                   z = first[3 * i + 2] - second[3 * k + 2];
      expected += std::sqrt(x * x + y * y + z * z) <= 2 * radius ? 1 : 0;
    }
  }
  ASSERT_GT(expected, 10U);
  const auto found = contacts_of(a, identity, b, identity);
  EXPECT_EQ(found.size(), expected);
  const auto swapped = contacts_of(b, identity, a, identity);
  ASSERT_EQ(swapped.size(), expected);
  for (const abut_contact& contact : found) {
    const bool is_there = std::any_of(swapped.begin(), swapped.end(), [&](const abut_contact& other) {
      return other.child_a == contact.child_b && other.child_b == contact.child_a && other.distance == contact.distance;
    });
    EXPECT_TRUE(is_there);
  }
}

TEST(Particles, MayHaveRadiiOfTheirOwn) {
  const Shape dust = make_of_kind("particles", {0}, {0, 0, 0, 0.5, 3, 0, 0, 0.1, 6, 0, 0, 0});
  const Shape ball = make_sphere(1);
  EXPECT_NEAR(distance_of(dust, identity, ball, at(0, 2, 0)), 0.5, 1e-12);
  EXPECT_NEAR(distance_of(dust, identity, ball, at(3, 2, 0)), 0.9, 1e-12);
  EXPECT_NEAR(distance_of(dust, identity, ball, at(6, 2, 0)), 1.0, 1e-12);
}

TEST(Particles, AreNamedByTheFeaturesOfContactsAndCasts) {
  const Shape dust = make_of_kind("particles", {0.5}, {0, 0, 0, 3, 0, 0, 6, 0, 0});
  const Shape ball = make_sphere(0.5);
  const auto found = contacts_of(ball, at(6.9, 0, 0), dust, identity);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].feature_b.kind, abut_feature_kind{ABUT_FEATURE_PARTICLE});
  EXPECT_EQ(found[0].feature_b.index, 2U);
  EXPECT_EQ(found[0].child_b, 2U);
  EXPECT_EQ(found[0].id & ABUT_CONTACT_ID_HASHED, 0U);
  const abut_pose start = at(3, 0, 4);
  const abut_vec3 down{0, 0, -4}, still{0, 0, 0};
  abut_cast_hit hit{};
  std::uint32_t is_hit = 0;
  require(abut_pair_cast(ball, &start, &down, dust, &identity, &still, nullptr, &hit, &is_hit));
  ASSERT_EQ(is_hit, 1U);
  EXPECT_EQ(hit.feature_b.kind, abut_feature_kind{ABUT_FEATURE_PARTICLE});
  EXPECT_EQ(hit.feature_b.index, 1U);
}

TEST(Particles, OfAChildKeepTheirNumber) {
  const Shape dust = make_of_kind("particles", {0.5}, {0, 0, 0, 3, 0, 0, 6, 0, 0});
  const Shape ball = make_sphere(0.5);
  const Shape both = make_composite({ball, dust}, {at(0, 0, 9), identity});
  const auto found = contacts_of(both, identity, ball, at(3, 0.9, 0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].child_a, 1U);
  EXPECT_EQ(found[0].feature_a.kind, abut_feature_kind{ABUT_FEATURE_PARTICLE});
  EXPECT_EQ(found[0].feature_a.index, 1U);
}

TEST(Particles, AtOnePlaceAreFoundAll) {
  const Shape dust = make_of_kind("particles", {0.5}, {1, 1, 1, 1, 1, 1, 1, 1, 1});
  EXPECT_EQ(contacts_of(dust, identity, make_sphere(1), at(1, 1, 2)).size(), 3U);
}

TEST(Particles, AgainstASurfaceHaveAContactForEachDirection) {
  // A ball in the corner of two flat sheets, each of two triangles.
  const Shape corner = make_of_kind("mesh", {0}, {0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0, 0, -1, 1, 0, 1, 1},
                                    {0, 1, 2, 0, 2, 3, 0, 4, 5, 0, 5, 3});
  const Shape dust = make_of_kind("particles", {0.5}, {0.45, 0, 0.4});
  const auto found = contacts_of(dust, identity, corner, identity);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(std::fabs(found[0].normal.x * found[1].normal.x + found[0].normal.y * found[1].normal.y +
                        found[0].normal.z * found[1].normal.z),
              0, 1e-9);
}

TEST(Particles, AreMetByRays) {
  const double radius = 0.05;
  for (const double thickness : {1.0, 0.0}) {
    const std::vector<double> xyz = cloud(500, 5, thickness);
    const Shape dust = make_of_kind("particles", {radius}, xyz);
    const Shape ball = make_sphere(radius);
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> place(-1, 1);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
      const abut_ray ray{
          {3 * place(random), 3 * place(random), 3 * place(random)}, {place(random), place(random), place(random)}, 10};
      double nearest = std::numeric_limits<double>::infinity();
      std::uint32_t which = 0, found = 0;
      abut_ray_hit hit{};
      for (std::uint32_t k = 0; k < 500; ++k) {
        const abut_pose pose = at(xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]);
        ASSERT_TRUE(succeeded(abut_shape_cast_ray(ball, &pose, &ray, &hit, &found)));
        if (found != 0 && hit.distance < nearest) {
          nearest = hit.distance;
          which = k;
        }
      }
      ASSERT_TRUE(succeeded(abut_shape_cast_ray(dust, &identity, &ray, &hit, &found)));
      ASSERT_EQ(found != 0, std::isfinite(nearest)) << i;
      if (found != 0) {
        EXPECT_NEAR(hit.distance, nearest, 1e-12);
        EXPECT_EQ(hit.feature.kind, abut_feature_kind{ABUT_FEATURE_PARTICLE});
        EXPECT_EQ(hit.feature.index, which);
        ++hits;
      }
    }
    EXPECT_GT(hits, 40);
  }
}

TEST(Particles, NumbersThatMakeNoSenseAreRefusedByName) {
  const auto refuses = [](const std::vector<double>& parameters, const std::vector<double>& reals, abut_status status,
                          std::initializer_list<std::string_view> words) {
    expect_kind_refused("particles", parameters, reals, {}, status, words);
  };
  refuses({0.5}, {}, ABUT_EMPTY, {"count", "0"});
  refuses({0.5}, {0, 0, 0, 1}, ABUT_INVALID_ARGUMENT, {"real_count", "4", "multiple of 3"});
  refuses({0}, {0, 0, 0}, ABUT_INVALID_ARGUMENT, {"real_count", "3", "multiple of 4"});
  refuses({0}, {0, 0, 0, -1}, ABUT_OUT_OF_RANGE, {"[3]", "-1"});
  refuses({-1}, {0, 0, 0}, ABUT_OUT_OF_RANGE, {"radius", "-1"});
  refuses({}, {0, 0, 0}, ABUT_INVALID_ARGUMENT, {"parameter_count"});
}

}  // namespace
