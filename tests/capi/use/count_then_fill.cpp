// SPDX-License-Identifier: Apache-2.0
// Arrays of unknown length: ask for the count, then fill.
#include <cmath>

#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Asks `call`, a callable (Value* values, size_t capacity, size_t* count) that has `expected` answers, every way there
// is.
template <class Value, class Call>
void check_count_then_fill(std::size_t expected, Call call) {
  std::size_t count = 99;
  ASSERT_TRUE(succeeded(call(static_cast<Value*>(nullptr), std::size_t{0}, &count)));
  ASSERT_EQ(count, expected);
  for (std::size_t capacity = 0; capacity <= expected + 2; ++capacity) {
    OutArray<Value> values(expected + 2);
    count = 99;
    ASSERT_TRUE(succeeded(call(values.data(), capacity, &count)));
    EXPECT_EQ(count, expected) << "the count is that of all, whatever fits";
    EXPECT_TRUE(values.is_untouched_from(std::min(capacity, expected))) << "nothing past capacity and count is written";
    if (capacity > 0) EXPECT_FALSE(values.is_untouched());
  }
}

TEST(CountThenFill, Parts) {
  Universe universe;
  for (int i = 0; i < 3; ++i) universe.add_part(identity);
  check_count_then_fill<abut_part_id>(3, [&](auto... rest) { return abut_universe_parts(universe, rest...); });
}

TEST(CountThenFill, Geometries) {
  Universe universe;
  const Shape ball = make_sphere(1);
  const abut_part_id part = universe.add_part(identity);
  for (int i = 0; i < 3; ++i) universe.add_geometry(part, ball);
  check_count_then_fill<abut_geometry_id>(3, [&](auto... rest) { return abut_universe_geometries(universe, rest...); });
  check_count_then_fill<abut_geometry_id>(3,
                                          [&](auto... rest) { return abut_part_geometries(universe, part, rest...); });
}

TEST(CountThenFill, ContactsOfAPair) {
  const Shape block = make_box(1, 1, 1);
  const abut_pose other = at(0, 0, 1.9);
  check_count_then_fill<abut_contact>(
      4, [&](auto... rest) { return abut_pair_contacts(block, &identity, block, &other, nullptr, rest...); });
}

TEST(CountThenFill, ShortArraysHoldTheDeepestContacts) {
  const Shape block = make_box(1, 1, 1);
  // Tilted a little, so that the corners lie at different depths.
  const abut_pose other{{0, 0, 1.9}, {std::sqrt(1 - 0.0001), 0.01, 0, 0}};
  std::array<abut_contact, 4> all{};
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_pair_contacts(block, &identity, block, &other, nullptr, all.data(), 4, &count)));
  ASSERT_GE(count, 2U);
  abut_contact first{};
  ASSERT_TRUE(succeeded(abut_pair_contacts(block, &identity, block, &other, nullptr, &first, 1, &count)));
  using Bytes = std::array<unsigned char, sizeof(abut_contact)>;
  EXPECT_EQ(std::bit_cast<Bytes>(first), std::bit_cast<Bytes>(all[0]));
  for (std::size_t i = 1; i < count; ++i) EXPECT_LE(all.at(i - 1).distance, all.at(i).distance);
}

TEST(CountThenFill, Triangles) {
  const Shape mesh = make_square_mesh(1);
  std::size_t vertex_count = 0;
  std::size_t triangle_count = 0;
  ASSERT_TRUE(succeeded(abut_shape_triangles(mesh, nullptr, 0, &vertex_count, nullptr, 0, &triangle_count)));
  EXPECT_EQ(vertex_count, 4U);
  EXPECT_EQ(triangle_count, 2U);
  OutArray<double> xyz(15);
  OutArray<std::uint32_t> triangles(9);
  ASSERT_TRUE(
      succeeded(abut_shape_triangles(mesh, xyz.data(), 3, &vertex_count, triangles.data(), 1, &triangle_count)));
  EXPECT_EQ(vertex_count, 4U);
  EXPECT_EQ(triangle_count, 2U);
  EXPECT_TRUE(xyz.is_untouched_from(9));
  EXPECT_TRUE(triangles.is_untouched_from(3));
  ASSERT_TRUE(
      succeeded(abut_shape_triangles(mesh, xyz.data(), 4, &vertex_count, triangles.data(), 2, &triangle_count)));
  EXPECT_EQ(triangles[5], 3U);
  EXPECT_EQ(xyz[9], -1.0);
}

// Meshes and height fields are their triangles; the faces of boxes and hulls become several each.
bool numbers_its_triangles(const abut_shape* shape) {
  const abut_shape_kind kind = abut_shape_kind_of(shape);
  return kind == abut_shape_kind_by_name("mesh") || kind == abut_shape_kind_by_name("height_field") ||
         kind == abut_shape_kind_by_name("uv_grid");
}

// Every triangle of the surface lies on it, and of surfaces its index is the feature of a ray through its middle.
TEST(CountThenFill, TrianglesAreTheFeaturesOfRays) {
  std::vector<Shape> shapes;
  shapes.push_back(make_box(1, 0.75, 0.5));
  shapes.push_back(make_octahedron(1));
  shapes.push_back(make_square_mesh(1));
  shapes.push_back(make_terrain(5, 1.0));
  for (const Shape& shape : shapes) {
    std::size_t vertex_count = 0;
    std::size_t triangle_count = 0;
    ASSERT_TRUE(succeeded(abut_shape_triangles(shape, nullptr, 0, &vertex_count, nullptr, 0, &triangle_count)));
    std::vector<double> xyz(vertex_count * 3);
    std::vector<std::uint32_t> triangles(triangle_count * 3);
    ASSERT_TRUE(succeeded(abut_shape_triangles(shape, xyz.data(), vertex_count, &vertex_count, triangles.data(),
                                               triangle_count, &triangle_count)));
    for (std::uint32_t triangle = 0; triangle < triangle_count; ++triangle) {
      const auto corner = [&](std::size_t c, std::size_t axis) {
        return xyz.at(std::size_t{triangles.at(3 * triangle + c)} * 3 + axis);
      };
      std::array<double, 3> middle{};
      std::array<double, 3> u{};
      std::array<double, 3> v{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        middle.at(axis) = (corner(0, axis) + corner(1, axis) + corner(2, axis)) / 3;
        u.at(axis) = corner(1, axis) - corner(0, axis);
        v.at(axis) = corner(2, axis) - corner(0, axis);
      }
      const abut_vec3 normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
      const double step = 0.01 / length;
      const abut_ray ray{{middle[0] + step * normal.x, middle[1] + step * normal.y, middle[2] + step * normal.z},
                         {-normal.x, -normal.y, -normal.z},
                         0.02};
      abut_ray_hit hit{};
      std::uint32_t found = 0;
      ASSERT_TRUE(succeeded(abut_shape_cast_ray(shape, &identity, &ray, &hit, &found)));
      ASSERT_EQ(found, 1U);
      EXPECT_NEAR(hit.distance, 0.01, 1e-12);
      EXPECT_EQ(hit.feature.kind, abut_feature_kind{ABUT_FEATURE_FACE});
      if (numbers_its_triangles(shape))
        EXPECT_EQ(hit.feature.index, triangle) << abut_shape_kind_name(abut_shape_kind_of(shape));
      EXPECT_NEAR(hit.normal.x * normal.x + hit.normal.y * normal.y + hit.normal.z * normal.z, length, 1e-9);
    }
  }
}

}  // namespace
