// SPDX-License-Identifier: Apache-2.0
// Hulls that are made of vertices and faces: of those of a hull, and of those that are none.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

using Faces = std::vector<std::uint32_t>;
const std::vector<double> tetrahedron{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const Faces its_faces{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};

TEST(ShapeCreate, MakesAHullOfItsFaces) {
  const Shape given = make_of_kind("hull", {}, tetrahedron, its_faces), found = make_of_kind("hull", {}, tetrahedron);
  EXPECT_NEAR(distance_of(given, identity, found, at(3, 0, 0)), 2, 1e-12);
  const abut_ray ray{{0.1, 0.1, 5}, {0, 0, -1}, 10};
  abut_ray_hit hit;
  std::uint32_t is_met = 0;
  ASSERT_TRUE(succeeded(abut_shape_cast_ray(given, &identity, &ray, &hit, &is_met)));
  ASSERT_EQ(is_met, 1U);
  EXPECT_EQ(hit.feature.index, 3U) << "faces keep their numbers";
  EXPECT_NEAR(hit.distance, 4.2, 1e-12);
}

TEST(ShapeCreate, RefusesFacesThatAreNoneOfAHull) {
  const auto expect_refused = [](const Faces& faces, std::initializer_list<std::string_view> words) {
    expect_kind_refused("hull", {}, tetrahedron, faces, ABUT_INVALID_ARGUMENT, words);
  };
  expect_refused({0}, {"faces", "none"});
  expect_refused({2, 0, 1}, {"face 0", "2 corners"});
  expect_refused({3, 0, 1}, {"face 0", "3 corners"});
  expect_refused({3, 0, 1, 4}, {"face 0", "no vertex"});
  expect_refused({3, 0, 1, 1}, {"no area"});
  expect_refused({3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2}, {"convex solid"});
  expect_refused({3, 0, 1, 2, 3, 0, 3, 1, 3, 0, 2, 3, 3, 1, 3, 2}, {"convex solid"});
}

}  // namespace
