// SPDX-License-Identifier: Apache-2.0
// Mass of shapes, against sums over a grid of points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

// What points on a grid within a box of half size 1 add up to, of density 1.
abut_mass_properties sum_of(const std::function<bool(double, double, double)>& is_inside) {
  constexpr int count = 120;
  constexpr double cell = 2.0 / count;
  abut_mass_properties out{};
  std::array<double, 9> second{};
  for (int i = 0; i < count * count * count; ++i) {
    const std::array<double, 3> at{-1 + cell * (i % count + 0.5), -1 + cell * (i / count % count + 0.5),
                                   -1 + cell * (i / count / count + 0.5)};
    if (!is_inside(at[0], at[1], at[2])) continue;
    const double mass = cell * cell * cell;
    out.mass += mass;
    out.centre = {out.centre.x + mass * at[0], out.centre.y + mass * at[1], out.centre.z + mass * at[2]};
    for (std::size_t j = 0; j < 9; ++j) second[j] += mass * at[j / 3] * at[j % 3];
  }
  out.centre = {out.centre.x / out.mass, out.centre.y / out.mass, out.centre.z / out.mass};
  const std::array<double, 3> centre{out.centre.x, out.centre.y, out.centre.z};
  for (std::size_t j = 0; j < 9; ++j) second[j] -= out.mass * centre[j / 3] * centre[j % 3];
  const double trace = second[0] + second[4] + second[8];
  for (std::size_t j = 0; j < 9; ++j) out.inertia[j] = (j % 4 == 0 ? trace : 0) - second[j];
  return out;
}

void expect_near(const abut_mass_properties& is, const abut_mass_properties& expected, double part,
                 const std::string& what) {
  EXPECT_NEAR(is.mass, expected.mass, part * expected.mass) << what;
  EXPECT_NEAR(is.centre.x, expected.centre.x, part) << what;
  EXPECT_NEAR(is.centre.y, expected.centre.y, part) << what;
  EXPECT_NEAR(is.centre.z, expected.centre.z, part) << what;
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_NEAR(is.inertia[i], expected.inertia[i], part * expected.mass) << what << i;
}

abut_mass_properties mass_of(const Shape& shape, double density = 1) {
  abut_mass_properties out{};
  require(abut_shape_mass_properties(shape.get(), density, &out));
  return out;
}

TEST(Mass, IsThatOfTheSolidsOfAFormula) {
  constexpr double grid = 5e-3;
  const auto make = [](auto create, auto... numbers) {
    return shape_from([&](abut_shape** out) { return create(numbers..., out); });
  };
  expect_near(mass_of(make(abut_sphere_create, 0.8)),
              sum_of([](double x, double y, double z) { return x * x + y * y + z * z < 0.64; }), grid, "sphere");
  expect_near(mass_of(make(abut_box_create, 0.8, 0.5, 0.3)), sum_of([](double x, double y, double z) {
                return std::fabs(x) < 0.8 && std::fabs(y) < 0.5 && std::fabs(z) < 0.3;
              }),
              grid, "box");
  expect_near(mass_of(make(abut_capsule_create, 0.4, 0.5)), sum_of([](double x, double y, double z) {
                const double beyond = std::max(std::fabs(z) - 0.5, 0.0);
                return x * x + y * y + beyond * beyond < 0.16;
              }),
              grid, "capsule");
  expect_near(mass_of(make(abut_cylinder_create, 0.7, 0.6)),
              sum_of([](double x, double y, double z) { return x * x + y * y < 0.49 && std::fabs(z) < 0.6; }), grid,
              "cylinder");
  expect_near(mass_of(make(abut_cone_create, 0.9, 0.8)), sum_of([](double x, double y, double z) {
                return std::fabs(z) < 0.8 && std::hypot(x, y) < 0.9 * (0.8 - z) / 1.6;
              }),
              grid, "cone");
  expect_near(mass_of(make(abut_ellipsoid_create, 0.9, 0.6, 0.4)),
              sum_of([](double x, double y, double z) { return x * x / 0.81 + y * y / 0.36 + z * z / 0.16 < 1; }), grid,
              "ellipsoid");
}

constexpr std::array<double, 12> corners{0.1, 0.2, 0.3, 0.9, 0.2, 0.3, 0.1, 0.95, 0.3, 0.1, 0.2, 0.9};
constexpr std::array<std::uint32_t, 12> faces{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

Shape mesh(std::vector<std::uint32_t> triangles) {
  return shape_from([&](abut_shape** out) {
    return abut_mesh_create(corners.data(), 4, triangles.data(), triangles.size() / 3, nullptr, out);
  });
}

TEST(Mass, IsWhatTrianglesEnclose) {
  const abut_mass_properties expected = sum_of([](double x, double y, double z) {
    return x > 0.1 && y > 0.2 && z > 0.3 && (x - 0.1) / 0.8 + (y - 0.2) / 0.75 + (z - 0.3) / 0.6 < 1;
  });
  const abut_mass_properties is = mass_of(mesh({faces.begin(), faces.end()}), 2.5);
  EXPECT_NEAR(is.mass, 2.5 * 0.8 * 0.75 * 0.6 / 6, 1e-12);
  EXPECT_NEAR(is.centre.x, 0.3, 1e-12);
  EXPECT_NEAR(is.centre.y, 0.3875, 1e-12);
  EXPECT_NEAR(is.centre.z, 0.45, 1e-12);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(is.inertia[i] / 2.5, expected.inertia[i], 1e-2 * expected.mass) << i;
  const Shape hull = shape_from([](abut_shape** out) { return abut_hull_create(corners.data(), 4, out); });
  expect_near(mass_of(hull, 2.5), is, 1e-12, "hull");
}

void expect_unsupported(const Shape& shape, const char* word) {
  abut_mass_properties out{.mass = -7, .centre = {}, .inertia = {}};
  EXPECT_EQ(abut_shape_mass_properties(shape.get(), 1, &out), ABUT_UNSUPPORTED);
  EXPECT_NE(std::string(abut_last_error_message()).find(word), std::string::npos) << abut_last_error_message();
  EXPECT_EQ(out.mass, -7);
}

TEST(Mass, IsRefusedWhereNothingIsEnclosed) {
  expect_unsupported(ground(), "plane");
  expect_unsupported(mesh({faces.begin(), faces.end() - 3}), "enclose");
  std::vector<std::uint32_t> inside_out(faces.begin(), faces.end());
  for (std::size_t i = 0; i < inside_out.size(); i += 3) std::swap(inside_out[i], inside_out[i + 1]);
  expect_unsupported(mesh(inside_out), "enclose");
  expect_unsupported(block(1, 1, 0), "flat");
}

}  // namespace
