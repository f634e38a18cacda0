// SPDX-License-Identifier: Apache-2.0
// Spheres, boxes, capsules and planes under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 2> not_positive{0.0, -2.5};

std::string_view word_of(double value) { return value < 0.0 ? "-2.5" : "0"; }

TEST(SphereCreate, RefusesNonFiniteRadius) {
  Out<abut_shape*> out;
  expect_non_finite_refused("radius", [&](double bad) { return abut_sphere_create(bad, out.address()); });
  EXPECT_TRUE(out.is_untouched());
}

TEST(SphereCreate, RefusesRadiusThatIsNotPositive) {
  Out<abut_shape*> out;
  for (const double radius : not_positive) {
    EXPECT_TRUE(refused(abut_sphere_create(radius, out.address()), ABUT_OUT_OF_RANGE, {"radius", word_of(radius)}));
  }
  EXPECT_TRUE(refused(abut_sphere_create(-0.0, out.address()), ABUT_OUT_OF_RANGE, {"radius", "0"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(BoxCreate, RefusesNegativeHalfExtents) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_box_create(-2.5, 1.0, 1.0, out.address()), ABUT_OUT_OF_RANGE, {"half_x", "-2.5"}));
  EXPECT_TRUE(refused(abut_box_create(1.0, -2.5, 1.0, out.address()), ABUT_OUT_OF_RANGE, {"half_y", "-2.5"}));
  EXPECT_TRUE(refused(abut_box_create(1.0, 1.0, -2.5, out.address()), ABUT_OUT_OF_RANGE, {"half_z", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(BoxCreate, AcceptsFlatBoxes) {
  const Shape flat = make_box(1.0, 1.0, 0.0);
  const Shape line = make_box(1.0, 0.0, 0.0);
  const Shape point = make_box(0.0, 0.0, 0.0);
}

TEST(CylinderCreate, RefusesNegativeNumbers) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_cylinder_create(-2.5, 1.0, out.address()), ABUT_OUT_OF_RANGE, {"radius", "-2.5"}));
  EXPECT_TRUE(refused(abut_cylinder_create(1.0, -2.5, out.address()), ABUT_OUT_OF_RANGE, {"half_height", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(CapsuleCreate, RefusesRadiusThatIsNotPositive) {
  Out<abut_shape*> out;
  for (const double radius : not_positive) {
    EXPECT_TRUE(
        refused(abut_capsule_create(radius, 1.0, out.address()), ABUT_OUT_OF_RANGE, {"radius", word_of(radius)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(CapsuleCreate, RefusesNegativeHalfHeight) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_capsule_create(1.0, -2.5, out.address()), ABUT_OUT_OF_RANGE, {"half_height", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(CapsuleCreate, AcceptsNoHeight) { const Shape round = make_capsule(1.0, 0.0); }

TEST(PlaneCreate, RefusesZeroNormal) {
  Out<abut_shape*> out;
  for (const abut_vec3& zero : {abut_vec3{0.0, 0.0, 0.0}, abut_vec3{-0.0, 0.0, -0.0}}) {
    EXPECT_TRUE(refused(abut_plane_create(&zero, 0.0, out.address()), ABUT_ZERO_VECTOR, {"normal"}));
  }
  EXPECT_TRUE(out.is_untouched());
}

// The squares of these lengths underflow or overflow; the directions are as good as any.
TEST(PlaneCreate, AcceptsNormalsOfAnyLength) {
  for (const double length : {1e-300, 1e-160, 1e-20, 1e20, 1e160, 1e300}) {
    const Shape plane = make_plane({0.0, 0.6 * length, 0.8 * length}, 2.0);
    const abut_ray ray{{0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}, infinity};
    Out<abut_ray_hit> hit;
    std::uint32_t found = 7;
    ASSERT_TRUE(succeeded(abut_shape_cast_ray(plane, &identity, &ray, hit.address(), &found))) << length;
    ASSERT_EQ(found, 1U) << length;
    EXPECT_NEAR(hit.value().distance, 7.5, 1e-12) << length;
    EXPECT_NEAR(hit.value().normal.z, 0.8, 1e-12) << length;
  }
}

}  // namespace
