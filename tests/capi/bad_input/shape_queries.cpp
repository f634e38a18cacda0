// SPDX-License-Identifier: Apache-2.0
// Questions about one shape under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(ShapeParameters, CountsThenFills) {
  const Shape box = make_box(1.0, 2.0, 3.0);
  std::size_t count = 99;
  ASSERT_TRUE(succeeded(abut_shape_parameters(box, nullptr, 0, &count)));
  ASSERT_EQ(count, 3U);
  OutArray<double> parameters(5);
  ASSERT_TRUE(succeeded(abut_shape_parameters(box, parameters.data(), 2, &count)));
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(parameters[0], 1.0);
  EXPECT_EQ(parameters[1], 2.0);
  EXPECT_TRUE(parameters.is_untouched_from(2));
  ASSERT_TRUE(succeeded(abut_shape_parameters(box, parameters.data(), 5, &count)));
  EXPECT_EQ(parameters[2], 3.0);
  EXPECT_TRUE(parameters.is_untouched_from(3));
}

TEST(ShapeAabb, NormalisesOrientationsThatAreNearlyUnit) {
  const Shape box = make_box(1.0, 2.0, 3.0);
  for (const double length : {0.9991, 1.0009}) {
    const abut_pose pose{{0.0, 0.0, 0.0}, {length, 0.0, 0.0, 0.0}};
    abut_aabb aabb{};
    ASSERT_TRUE(succeeded(abut_shape_aabb(box, &pose, &aabb)));
    EXPECT_NEAR(aabb.maximum.x, 1.0, 1e-14);
    EXPECT_NEAR(aabb.maximum.y, 2.0, 1e-14);
    EXPECT_NEAR(aabb.maximum.z, 3.0, 1e-14);
  }
}

TEST(ShapePrepare, RefusesNullAndTooManyThreads) {
  EXPECT_TRUE(refused(abut_shape_prepare(nullptr, 1), ABUT_NULL_ARGUMENT, {"shape", "null"}));
  const Shape ball = make_sphere(1.0);
  EXPECT_TRUE(refused(abut_shape_prepare(ball, 1025), ABUT_OUT_OF_RANGE, {"threads", "1025", "1024"}));
}

// One call of abut_shape_triangles with room for the surface of a box.
struct TrianglesCall {
  OutArray<double> xyz{64 * 3};
  OutArray<std::uint32_t> triangles{64 * 3};
  Out<std::size_t> vertex_count;
  Out<std::size_t> triangle_count;
  bool is_untouched() const {
    return xyz.is_untouched() && triangles.is_untouched() && vertex_count.is_untouched() &&
           triangle_count.is_untouched();
  }
};

TEST(ShapeTriangles, RefusesNullPointers) {
  const Shape box = make_box(1.0, 1.0, 1.0);
  TrianglesCall call;
  double* const xyz = call.xyz.data();
  std::uint32_t* const triangles = call.triangles.data();
  std::size_t* const vertex_count = call.vertex_count.address();
  std::size_t* const triangle_count = call.triangle_count.address();
  EXPECT_TRUE(refused(abut_shape_triangles(nullptr, xyz, 64, vertex_count, triangles, 64, triangle_count),
                      ABUT_NULL_ARGUMENT, {"shape", "null"}));
  EXPECT_TRUE(refused(abut_shape_triangles(box, nullptr, 64, vertex_count, triangles, 64, triangle_count),
                      ABUT_NULL_ARGUMENT, {"xyz", "null"}));
  EXPECT_TRUE(refused(abut_shape_triangles(box, xyz, 64, nullptr, triangles, 64, triangle_count), ABUT_NULL_ARGUMENT,
                      {"vertex_count", "null"}));
  EXPECT_TRUE(refused(abut_shape_triangles(box, xyz, 64, vertex_count, nullptr, 64, triangle_count), ABUT_NULL_ARGUMENT,
                      {"triangles", "null"}));
  EXPECT_TRUE(refused(abut_shape_triangles(box, xyz, 64, vertex_count, triangles, 64, nullptr), ABUT_NULL_ARGUMENT,
                      {"triangle_count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(ShapeTriangles, RefusesCurvedAndUnboundedShapes) {
  std::vector<Shape> shapes;
  shapes.push_back(make_sphere(1.0));
  shapes.push_back(make_capsule(1.0, 1.0));
  shapes.push_back(make_plane({0.0, 0.0, 1.0}, 0.0));
  constexpr std::array<std::string_view, 3> names{"sphere", "capsule", "plane"};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    TrianglesCall call;
    EXPECT_TRUE(refused(abut_shape_triangles(shapes.at(i), call.xyz.data(), 64, call.vertex_count.address(),
                                             call.triangles.data(), 64, call.triangle_count.address()),
                        ABUT_UNSUPPORTED, {names.at(i)}));
    EXPECT_TRUE(call.is_untouched());
  }
}

struct RayCall {
  Shape shape = make_sphere(1.0);
  abut_ray ray{{-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 100.0};
  Out<abut_ray_hit> hit;
  Out<std::uint32_t> found;
  abut_status cast() { return abut_shape_cast_ray(shape, &identity, &ray, hit.address(), found.address()); }
  bool is_untouched() const { return hit.is_untouched() && found.is_untouched(); }
};

TEST(ShapeCastRay, AcceptsTheCallThatTheOthersSpoil) {
  RayCall call;
  EXPECT_TRUE(succeeded(call.cast()));
  EXPECT_EQ(call.found.value(), 1U);
}

TEST(ShapeCastRay, RefusesNegativeLength) {
  RayCall call;
  call.ray.max_distance = -2.5;
  EXPECT_TRUE(refused(call.cast(), ABUT_OUT_OF_RANGE, {"max_distance", "-2.5"}));
  EXPECT_TRUE(call.is_untouched());
}

// Minus infinity is an infinity and it is negative: both statuses describe it, no other does.
TEST(ShapeCastRay, RefusesMinusInfinity) {
  RayCall call;
  call.ray.max_distance = -infinity;
  const abut_status status = call.cast();
  EXPECT_TRUE(status == ABUT_NOT_FINITE || status == ABUT_OUT_OF_RANGE) << abut_status_name(status);
  EXPECT_TRUE(call.is_untouched());
}

TEST(ShapeCastRay, RefusesZeroDirection) {
  RayCall call;
  call.ray.direction = {0.0, -0.0, 0.0};
  EXPECT_TRUE(refused(call.cast(), ABUT_ZERO_VECTOR, {"direction"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(ShapeCastRay, RefusesBadPoses) {
  RayCall call;
  expect_pose_checked("pose", [&](const abut_pose* pose) {
    return abut_shape_cast_ray(call.shape, pose, &call.ray, call.hit.address(), call.found.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(ShapeCastRay, AcceptsInfiniteLengthAndAnyDirectionLength) {
  for (const double length : {1e-300, 1e-20, 1e20, 1e300}) {
    RayCall call;
    call.ray.max_distance = infinity;
    call.ray.direction = {length, 0.0, 0.0};
    ASSERT_TRUE(succeeded(call.cast())) << length;
    EXPECT_EQ(call.found.value(), 1U) << length;
    EXPECT_NEAR(call.hit.value().distance, 4.0, 1e-12) << length;
  }
}

TEST(ShapeCastRay, LeavesTheHitAloneWhenThereIsNone) {
  RayCall call;
  call.ray.direction = {-1.0, 0.0, 0.0};
  ASSERT_TRUE(succeeded(call.cast()));
  EXPECT_EQ(call.found.value(), 0U);
  EXPECT_TRUE(call.hit.is_untouched());
}

}  // namespace
