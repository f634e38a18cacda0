// SPDX-License-Identifier: Apache-2.0
// Cones, ellipsoids, points, segments, triangles and holes under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

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
