// SPDX-License-Identifier: Apache-2.0
// Which searches answer a pair of kinds, as far as the kinds tell.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

import abut.pairs.any_shape;

namespace {

std::string_view searches_of(std::string_view a, std::string_view b) {
  return abut::describe_route(*abut::find_kind(a), *abut::find_kind(b)).algorithm;
}

TEST(DescribeRoute, NamesTheSearchesOfConvexPairs) {
  EXPECT_EQ(searches_of("sphere", "sphere"), "closed form");
  EXPECT_EQ(searches_of("sphere", "cylinder"), "closed form");
  EXPECT_EQ(searches_of("box", "capsule"), "closed form apart, SAT in overlap");
  EXPECT_EQ(searches_of("triangle", "box"), "GJK apart, SAT in overlap");
  EXPECT_EQ(searches_of("box", "hull"), "GJK apart, SAT over facets in overlap");
  EXPECT_EQ(searches_of("hull", "hull"), "GJK apart, SAT over facets in overlap");
  EXPECT_EQ(searches_of("cone", "hull"), "GJK apart, SAT over facets and rims in overlap");
  EXPECT_EQ(searches_of("ellipsoid", "box"), "GJK apart, EPA in overlap");
}

TEST(DescribeRoute, NamesOneSearchForSurfaces) {
  EXPECT_EQ(searches_of("mesh", "box"), "nearest triangle apart, separating translation in overlap");
  EXPECT_EQ(searches_of("height_field", "hull"), searches_of("mesh", "box"));
  EXPECT_EQ(searches_of("mesh", "mesh"), searches_of("mesh", "box"));
  EXPECT_EQ(searches_of("particles", "mesh"), searches_of("mesh", "box"));
}

TEST(DescribeRoute, NamesThoseOfThePartsOfAShape) {
  EXPECT_EQ(searches_of("particles", "box"), searches_of("sphere", "box"));
  EXPECT_EQ(searches_of("plane", "particles"), "support point");
  EXPECT_EQ(searches_of("box_hole", "sphere"), "walls, one by one");
  EXPECT_EQ(searches_of("plane", "height_field"), "support point");
  EXPECT_EQ(searches_of("plane", "plane"), "unsupported");
  EXPECT_EQ(searches_of("distance_field", "cone"), "descent of the field");
  EXPECT_EQ(searches_of("distance_field", "mesh"), "descent of the field");
  EXPECT_EQ(searches_of("particles", "distance_field"), "descent of the field");
  EXPECT_EQ(searches_of("plane", "distance_field"), "points of the surface");
  EXPECT_EQ(searches_of("distance_field", "distance_field"), "points of the surface");
}

TEST(DescribeRoute, IsTheSameInEitherOrder) {
  for (std::size_t a = 0; a < abut::shape_kind_count; ++a) {
    for (std::size_t b = 0; b < abut::shape_kind_count; ++b) {
      EXPECT_EQ(abut::describe_route(a, b).algorithm, abut::describe_route(b, a).algorithm);
      EXPECT_FALSE(abut::describe_route(a, b).algorithm.empty()) << a << " and " << b;
    }
  }
}

}  // namespace
