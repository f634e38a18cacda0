// SPDX-License-Identifier: Apache-2.0
// Every kind has a function of its own, which makes what the generic door makes.
#include "support.hpp"

namespace {

using namespace abut_test;

template <class Create>
Shape made_by(Create create) {
  abut_shape* shape = nullptr;
  require(create(&shape));
  return Shape(shape);
}

void expect_same(const abut_shape* named, const char* kind, const std::vector<double>& parameters,
                 const std::vector<double>& reals = {}) {
  const Shape generic = make_of_kind(kind, parameters, reals);
  EXPECT_EQ(abut_shape_kind_of(named), abut_shape_kind_by_name(kind)) << kind;
  std::vector<double> found(9);
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_shape_parameters(named, found.data(), found.size(), &count)));
  found.resize(count);
  EXPECT_EQ(found, parameters) << kind;
  abut_aabb one{}, other{};
  ASSERT_TRUE(succeeded(abut_shape_aabb(named, &identity, &one)));
  ASSERT_TRUE(succeeded(abut_shape_aabb(generic, &identity, &other)));
  EXPECT_EQ(one.minimum.x, other.minimum.x) << kind;
  EXPECT_EQ(one.maximum.z, other.maximum.z) << kind;
}

TEST(NamedShapes, AreThoseOfTheGenericDoor) {
  expect_same(made_by([](abut_shape** out) { return abut_cone_create(0.5, 2, out); }), "cone", {0.5, 2});
  expect_same(made_by([](abut_shape** out) { return abut_ellipsoid_create(1, 2, 3, out); }), "ellipsoid", {1, 2, 3});
  expect_same(made_by([](abut_shape** out) { return abut_point_create(out); }), "point", {});
  expect_same(made_by([](abut_shape** out) { return abut_segment_create(0.75, out); }), "segment", {0.75});
  expect_same(made_by([](abut_shape** out) {
                const abut_vec3 a{1, 2, 3}, b{4, 5, 6}, c{7, 8, 10};
                return abut_triangle_create(&a, &b, &c, out);
              }),
              "triangle", {1, 2, 3, 4, 5, 6, 7, 8, 10});
  expect_same(made_by([](abut_shape** out) { return abut_sphere_hole_create(0.25, out); }), "sphere_hole", {0.25});
  expect_same(made_by([](abut_shape** out) { return abut_cylinder_hole_create(0.5, 1, ABUT_OPEN_BOTTOM, out); }),
              "cylinder_hole", {0.5, 1, 2});
  expect_same(
      made_by([](abut_shape** out) { return abut_box_hole_create(1, 2, 3, ABUT_OPEN_Y_HIGH | ABUT_OPEN_Y_LOW, out); }),
      "box_hole", {1, 2, 3, 12});
}

TEST(NamedShapes, ParticlesHaveRadiiOfTheirOwn) {
  const std::array<double, 6> xyz{0, 0, 0, 5, 0, 0};
  const std::array<double, 2> radii{1, 0.25};
  const Shape balls =
      made_by([&](abut_shape** out) { return abut_particles_create_with_radii(xyz.data(), radii.data(), 2, out); });
  expect_same(balls, "particles", {0}, {0, 0, 0, 1, 5, 0, 0, 0.25});
  const Shape probe = make_sphere(0.5);
  EXPECT_NEAR(distance_of(balls, identity, probe, at(0, 0, 3)), 1.5, 1e-12);
  EXPECT_NEAR(distance_of(balls, identity, probe, at(5, 0, 3)), 2.25, 1e-12);
}

// A bolt hole through a plate: a hole by its named function cuts a composite.
TEST(NamedShapes, AHoleCutsItsComposite) {
  const Shape plate = make_box(1, 1, 0.1);
  const Shape bore = made_by(
      [](abut_shape** out) { return abut_cylinder_hole_create(0.5, 1, ABUT_OPEN_TOP | ABUT_OPEN_BOTTOM, out); });
  const Shape washer = make_composite({plate, bore}, {identity, identity});
  const abut_ray ray{{0, 0, 5}, {0, 0, -1}, 10};
  abut_ray_hit hit;
  std::uint32_t found = 7;
  ASSERT_TRUE(succeeded(abut_shape_cast_ray(washer, &identity, &ray, &hit, &found)));
  EXPECT_EQ(found, 0U);
  ASSERT_TRUE(succeeded(abut_shape_cast_ray(plate, &identity, &ray, &hit, &found)));
  EXPECT_EQ(found, 1U);
}

}  // namespace
