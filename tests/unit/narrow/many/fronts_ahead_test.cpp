// SPDX-License-Identifier: Apache-2.0
// A front stands in a way where one is found by asking all triangles of a surface.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "../../damaged_meshes.hpp"
#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.many.fronts_ahead;
import abut.shapes.height_field;
import abut.shapes.mesh;

namespace {

using abut::Aabb;
using abut::HeightField;
using abut::Mesh;
using abut::Real;
using abut::Vec3;

// In how many random boxes, of 400, a front is found.
template <class Surface>
int count_against(const Surface& surface, std::uint32_t triangles, test::Random& random, Real upward) {
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 at = random.point(2), half = random.point(0.6);
    const Aabb box = Aabb::around(at, absolute(half));
    const Vec3 direction = *abut::UnitVec3::make(random.point(1) + Vec3{0, 0, upward});
    bool is_expected = false;
    for (std::uint32_t number = 0; number < triangles; ++number) {
      const abut::Triangle triangle = surface.part(number);
      is_expected = is_expected ||
                    (triangle.is_one_sided() && triangle.box().overlaps(box) && dot(triangle.normal(), direction) < 0);
    }
    EXPECT_EQ(abut::has_front_against(surface, box, direction), is_expected) << "box " << i;
    found += is_expected ? 1 : 0;
  }
  return found;
}

Mesh torus_with_sides(double sides) {
  const test::Surface torus = test::torus(1.3, 0.6, 17, 9);
  return test::made<Mesh>({sides}, torus.xyz, torus.triangles);
}

TEST(FrontsAhead, AreThoseOfAllTriangles) {
  test::Random random(71);
  const Mesh front = torus_with_sides(1), solid = torus_with_sides(2);
  const auto count = static_cast<std::uint32_t>(front.triangle_count());
  EXPECT_GT(count_against(front, count, random, 0), 50);
  EXPECT_GT(count_against(solid, count, random, 0), 50);

  std::vector<double> heights;
  for (int i = 0; i < 400; ++i) {
    heights.push_back(random.uniform(-0.2, 0.2));
  }
  const HeightField field = test::made<HeightField>({20, 20, 0.2, 0.2, 0, 0}, heights);
  const auto parts = static_cast<std::uint32_t>(field.triangle_count());
  EXPECT_GT(count_against(field, parts, random, 0), 20);
  // Nothing that rises steeply runs into ground.
  EXPECT_EQ(count_against(field, parts, random, 9), 0);
}

TEST(FrontsAhead, AreNoneOfSurfacesWithTwoSides) {
  test::Random random(72);
  const Mesh mesh = torus_with_sides(0);
  EXPECT_FALSE(mesh.has_fronts());
  EXPECT_EQ(count_against(mesh, static_cast<std::uint32_t>(mesh.triangle_count()), random, 0), 0);
}

}  // namespace
