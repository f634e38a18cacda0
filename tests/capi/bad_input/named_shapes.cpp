// SPDX-License-Identifier: Apache-2.0
// Cones, ellipsoids, points, segments, triangles and holes under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(ConeCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_cone_create(1.0, 1.0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(ConeCreate, RefusesNonFiniteAndNegativeNumbers) {
  Out<abut_shape*> out;
  expect_non_finite_refused("radius", [&](double bad) { return abut_cone_create(bad, 1.0, out.address()); });
  expect_non_finite_refused("half_height", [&](double bad) { return abut_cone_create(1.0, bad, out.address()); });
  EXPECT_TRUE(refused(abut_cone_create(-2.5, 1.0, out.address()), ABUT_OUT_OF_RANGE, {"radius", "-2.5"}));
  EXPECT_TRUE(refused(abut_cone_create(1.0, -2.5, out.address()), ABUT_OUT_OF_RANGE, {"half_height", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(EllipsoidCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_ellipsoid_create(1.0, 1.0, 1.0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(EllipsoidCreate, RefusesNonFiniteAndNegativeRadii) {
  Out<abut_shape*> out;
  expect_non_finite_refused("radius_x", [&](double bad) { return abut_ellipsoid_create(bad, 1, 1, out.address()); });
  expect_non_finite_refused("radius_y", [&](double bad) { return abut_ellipsoid_create(1, bad, 1, out.address()); });
  expect_non_finite_refused("radius_z", [&](double bad) { return abut_ellipsoid_create(1, 1, bad, out.address()); });
  EXPECT_TRUE(refused(abut_ellipsoid_create(1, 1, -2.5, out.address()), ABUT_OUT_OF_RANGE, {"radius_z", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(PointCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_point_create(nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(SegmentCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_segment_create(1.0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(SegmentCreate, RefusesNonFiniteAndNegativeLengths) {
  Out<abut_shape*> out;
  expect_non_finite_refused("half_length", [&](double bad) { return abut_segment_create(bad, out.address()); });
  EXPECT_TRUE(refused(abut_segment_create(-2.5, out.address()), ABUT_OUT_OF_RANGE, {"half_length", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

constexpr abut_vec3 zero{0, 0, 0}, along_x{1, 0, 0}, along_y{0, 1, 0};

TEST(TriangleCreate, RefusesNullPointers) {
  Out<abut_shape*> out;
  EXPECT_TRUE(
      refused(abut_triangle_create(nullptr, &along_x, &along_y, out.address()), ABUT_NULL_ARGUMENT, {"a ", "null"}));
  EXPECT_TRUE(
      refused(abut_triangle_create(&zero, nullptr, &along_y, out.address()), ABUT_NULL_ARGUMENT, {"b ", "null"}));
  EXPECT_TRUE(
      refused(abut_triangle_create(&zero, &along_x, nullptr, out.address()), ABUT_NULL_ARGUMENT, {"c ", "null"}));
  EXPECT_TRUE(refused(abut_triangle_create(&zero, &along_x, &along_y, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(TriangleCreate, RefusesNonFiniteCorners) {
  Out<abut_shape*> out;
  for (const BadVector& bad : non_finite_vectors()) {
    EXPECT_TRUE(refused(abut_triangle_create(&bad.vector, &along_x, &along_y, out.address()), ABUT_NOT_FINITE,
                        {"a_", bad.word}));
    EXPECT_TRUE(
        refused(abut_triangle_create(&zero, &along_x, &bad.vector, out.address()), ABUT_NOT_FINITE, {"c_", bad.word}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(SphereHoleCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_sphere_hole_create(1.0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(SphereHoleCreate, RefusesNonFiniteAndNegativeRadii) {
  Out<abut_shape*> out;
  expect_non_finite_refused("radius", [&](double bad) { return abut_sphere_hole_create(bad, out.address()); });
  EXPECT_TRUE(refused(abut_sphere_hole_create(-2.5, out.address()), ABUT_OUT_OF_RANGE, {"radius", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(CylinderHoleCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_cylinder_hole_create(1.0, 1.0, 0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(CylinderHoleCreate, RefusesNonFiniteNumbersAndUnknownEnds) {
  Out<abut_shape*> out;
  expect_non_finite_refused("radius", [&](double bad) { return abut_cylinder_hole_create(bad, 1, 0, out.address()); });
  expect_non_finite_refused("half_height",
                            [&](double bad) { return abut_cylinder_hole_create(1, bad, 0, out.address()); });
  for (const abut_open_ends ends : {4U, 77U, 0xFFFFFFFFU}) {
    EXPECT_TRUE(refused(abut_cylinder_hole_create(1, 1, ends, out.address()), ABUT_UNKNOWN_VALUE, {"open_ends"}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(BoxHoleCreate, RefusesNullOut) {
  EXPECT_TRUE(refused(abut_box_hole_create(1, 1, 1, 0, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
}

TEST(BoxHoleCreate, RefusesNonFiniteNumbersAndFacesOfTwoAxes) {
  Out<abut_shape*> out;
  expect_non_finite_refused("half_y", [&](double bad) { return abut_box_hole_create(1, bad, 1, 0, out.address()); });
  EXPECT_TRUE(refused(abut_box_hole_create(1, 1, 1, 64, out.address()), ABUT_UNKNOWN_VALUE, {"open_faces", "64"}));
  EXPECT_TRUE(refused(abut_box_hole_create(1, 1, 1, ABUT_OPEN_X_HIGH | ABUT_OPEN_Z_LOW, out.address()),
                      ABUT_INVALID_ARGUMENT, {"open_faces", "33", "one axis"}));
  EXPECT_TRUE(out.is_untouched());
}

constexpr std::array<double, 6> two_places{0, 0, 0, 1, 2, 3};
constexpr std::array<double, 2> two_radii{0.5, 0};

TEST(ParticlesCreateWithRadii, RefusesNullPointers) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_particles_create_with_radii(nullptr, two_radii.data(), 2, out.address()), ABUT_NULL_ARGUMENT,
                      {"xyz", "null"}));
  EXPECT_TRUE(refused(abut_particles_create_with_radii(two_places.data(), nullptr, 2, out.address()),
                      ABUT_NULL_ARGUMENT, {"radii", "null"}));
  EXPECT_TRUE(refused(abut_particles_create_with_radii(two_places.data(), two_radii.data(), 2, nullptr),
                      ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ParticlesCreateWithRadii, RefusesNonFiniteAndNegativeNumbers) {
  Out<abut_shape*> out;
  const auto create = [&](const std::array<double, 6>& places, const std::array<double, 2>& radii) {
    return abut_particles_create_with_radii(places.data(), radii.data(), 2, out.address());
  };
  expect_non_finite_refused("xyz[4]", [&](double bad) { return create({0, 0, 0, 1, bad, 3}, two_radii); });
  expect_non_finite_refused("radii[1]", [&](double bad) { return create(two_places, {0.5, bad}); });
  EXPECT_TRUE(refused(create(two_places, {-2.5, 1}), ABUT_OUT_OF_RANGE, {"radii[0]", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(ParticlesCreateWithRadii, RefusesNoneAndCountsThatOverflow) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_particles_create_with_radii(two_places.data(), two_radii.data(), 0, out.address()),
                      ABUT_EMPTY, {"count", "0"}));
  expect_overflow_refused(3 * sizeof(double), "count", [&](std::size_t count) {
    return abut_particles_create_with_radii(two_places.data(), two_radii.data(), count, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
