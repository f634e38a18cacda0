// SPDX-License-Identifier: Apache-2.0
// picking.h: orthographic cameras, shifted axes, pixels that are not square, and projection matrices, against the
// formulas that projection matrices are defined by.
#include "picking_scene.hpp"

#include <abut/picking.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace picking_test;

using Matrix = std::array<double, 16>;  // column by column

// Where the picture ends at unit depth (perspective) or at any depth (orthographic), and the depths of its planes.
struct Frustum {
  double left, right, bottom, top, near, far;
};

struct DepthRange {
  double at_near, at_far;
};

// As glFrustum, for any range of depths: depth = constant + slope / distance.
Matrix perspective_of(const Frustum& its, const DepthRange& range) {
  const double slope = std::isinf(its.far) ? (range.at_near - range.at_far) * its.near
                                           : (range.at_near - range.at_far) / (1 / its.near - 1 / its.far);
  const double constant = range.at_near - slope / its.near;
  const double width = its.right - its.left;
  const double height = its.top - its.bottom;
  return {2 / width, 0,  0, 0, 0,     2 / height, 0, 0, (its.right + its.left) / width, (its.top + its.bottom) / height,
          -constant, -1, 0, 0, slope, 0};
}

// As glOrtho: depth = constant + slope * distance.
Matrix orthographic_of(const Frustum& its, const DepthRange& range) {
  const double slope = (range.at_far - range.at_near) / (its.far - its.near);
  const double constant = range.at_near - slope * its.near;
  const double width = its.right - its.left;
  const double height = its.top - its.bottom;
  return {2 / width,
          0,
          0,
          0,
          0,
          2 / height,
          0,
          0,
          0,
          0,
          -slope,
          0,
          -(its.right + its.left) / width,
          -(its.top + its.bottom) / height,
          constant,
          1};
}

// x, y and depth of a point of the frame of the camera, as a graphics processor computes them.
abut_vec3 clipped(const Matrix& m, const abut_vec3& p) {
  const auto row = [&](std::size_t i) { return m[i] * p.x + m[i + 4] * p.y + m[i + 8] * p.z + m[i + 12]; };
  return {row(0) / row(3), row(1) / row(3), row(2) / row(3)};
}

abut_vec3 turned_back(const abut_quat& q, const abut_vec3& v) {
  const abut_vec3 u{-q.x, -q.y, -q.z};
  const auto cross = [](const abut_vec3& a, const abut_vec3& b) {
    return abut_vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  return v + 2 * cross(u, cross(u, v) + q.w * v);
}

abut_camera camera_of(Random& random) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.width = 1 + static_cast<std::uint32_t>(random.below(1000));
  camera.height = 1 + static_cast<std::uint32_t>(random.below(1000));
  camera.pose = {random.point(20), random.turn()};
  return camera;
}

// The ray through a pixel runs from the near plane to the far plane through points that the matrix maps to the pixel.
void expect_rays_of(const Matrix& matrix, const DepthRange& range, const abut_camera& camera, Random& random) {
  for (int i = 0; i < 20; ++i) {
    const double x = random.in(-200, 1200);
    const double y = random.in(-200, 1200);
    abut_ray ray{};
    ASSERT_EQ(abut_camera_ray(&camera, x, y, &ray), ABUT_OK) << abut_last_error_message();
    EXPECT_NEAR(length(ray.direction), 1, 1e-12);
    const double end = std::isinf(ray.max_distance) ? 1e3 : ray.max_distance;
    for (const double along : {0.0, 0.3 * end, end}) {
      const abut_vec3 point = ray.origin + along * ray.direction - camera.pose.position;
      const abut_vec3 seen = clipped(matrix, turned_back(camera.pose.orientation, point));
      EXPECT_NEAR((seen.x + 1) / 2 * camera.width, x, 1e-7);
      EXPECT_NEAR((1 - seen.y) / 2 * camera.height, y, 1e-7);
      if (along == 0) EXPECT_NEAR(seen.z, range.at_near, 1e-9);
      if (along == ray.max_distance) EXPECT_NEAR(seen.z, range.at_far, 1e-9);
    }
  }
}

TEST(Projection, GivesTheRaysOfItsMatrix) {
  constexpr std::uint64_t seed = 31;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const std::array<DepthRange, 4> ranges{{{-1, 1}, {0, 1}, {1, 0}, {1, -1}}};
  for (int i = 0; i < 40; ++i) {
    const DepthRange range = ranges.at(static_cast<std::size_t>(i) % 4);
    const abut_clip_depth depth =
        std::fabs(range.at_near - range.at_far) == 2 ? ABUT_CLIP_DEPTH_SIGNED : ABUT_CLIP_DEPTH_UNSIGNED;
    const double near = random.in(0.1, 3);
    Frustum its{-random.in(0.1, 2), random.in(0.1, 2), -random.in(0.1, 2), random.in(0.1, 2), near, near + 10};
    if (i % 5 == 0) its.far = infinity;
    const bool is_orthographic = i % 3 == 0 && !std::isinf(its.far);
    if (is_orthographic) its.near = random.in(-3, 3);
    Matrix matrix = is_orthographic ? orthographic_of(its, range) : perspective_of(its, range);
    abut_camera camera = camera_of(random);
    // A factor changes nothing that the matrix maps.
    const double factor = random.in(0.5, 2);
    for (double& element : matrix) element *= factor;
    ASSERT_EQ(abut_camera_set_projection(&camera, matrix.data(), depth), ABUT_OK) << abut_last_error_message();
    SCOPED_TRACE("matrix " + std::to_string(i));
    expect_rays_of(matrix, range, camera, random);
  }
}

TEST(Projection, IsRefusedWhereNoCameraHasIt) {
  const Matrix good = perspective_of({-1, 1, -1, 1, 0.5, 10}, {-1, 1});
  const Matrix parallel = orthographic_of({-1, 1, -1, 1, 0.5, 10}, {-1, 1});
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  const auto refusal = [&](Matrix matrix, std::size_t element, double value) {
    matrix.at(element) = value;
    const abut_status status = abut_camera_set_projection(&camera, matrix.data(), ABUT_CLIP_DEPTH_SIGNED);
    EXPECT_NE(status, ABUT_OK);
    EXPECT_EQ(camera.vertical_fov, 1) << "a camera that is refused stays";
    return std::string(abut_status_name(status)) + " " + abut_last_error_message();
  };
  const auto names = [](const std::string& message, const std::string& word) {
    return message.find(word) != std::string::npos;
  };
  for (const std::size_t zero : {1U, 2U, 3U, 4U, 6U, 7U, 12U, 13U})
    EXPECT_TRUE(names(refusal(good, zero, 0.25), "ABUT_UNSUPPORTED matrix[" + std::to_string(zero) + "] is 0.25"));
  for (const std::size_t zero : {1U, 2U, 3U, 4U, 6U, 7U, 8U, 9U})
    EXPECT_TRUE(names(refusal(parallel, zero, 0.25), "ABUT_UNSUPPORTED matrix[" + std::to_string(zero) + "] is 0.25"));
  EXPECT_TRUE(names(refusal(good, 0, -1), "matrix[0] is -1"));
  EXPECT_TRUE(names(refusal(good, 5, -1), "matrix[5] is -1; it must be positive: negate row 1"));
  EXPECT_TRUE(names(refusal(good, 11, 1), "matrix[11] is 1"));
  EXPECT_TRUE(names(refusal(good, 15, 1), "matrix[15] is 1"));
  EXPECT_TRUE(names(refusal(parallel, 15, 0), "matrix[15] is 0"));
  EXPECT_TRUE(names(refusal(good, 14, 0), "matrix[14] is 0"));
  EXPECT_TRUE(names(refusal(parallel, 10, 0), "matrix[10] is 0"));
  EXPECT_TRUE(names(refusal(good, 3, not_a_number), "ABUT_NOT_FINITE matrix[3] is nan"));
  // Both planes lie behind the eye.
  EXPECT_TRUE(names(refusal(good, 14, 1), "camera.near_distance is inf"));
}

TEST(Camera, OfParallelRaysLooksAlongItsAxis) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.projection = ABUT_PROJECTION_ORTHOGRAPHIC;
  camera.width = 400;
  camera.height = 200;
  camera.vertical_extent = 10;
  camera.near_distance = -2;
  camera.far_distance = 5;
  camera.pixel_aspect = 2;
  abut_ray ray{};
  ASSERT_EQ(abut_camera_ray(&camera, 210, 80, &ray), ABUT_OK);
  EXPECT_NEAR(length(ray.origin - abut_vec3{1, 1, 2}), 0, 1e-15);
  EXPECT_NEAR(length(ray.direction - abut_vec3{0, 0, -1}), 0, 1e-15);
  EXPECT_EQ(ray.max_distance, 7);
  camera.shift_x = 10;
  camera.shift_y = -20;
  ASSERT_EQ(abut_camera_ray(&camera, 210, 80, &ray), ABUT_OK);
  EXPECT_NEAR(length(ray.origin - abut_vec3{0, 0, 2}), 0, 1e-15);
}

TEST(Camera, RendersTheRaysOfItsPixels) {
  constexpr std::uint64_t seed = 32;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  World world;
  world.add(ground_mesh(8, 24, 0.4), {0, 0, -3});
  for (int i = 0; i < 20; ++i) world.add(i % 2 == 0 ? ball_mesh(0.6, 6) : sphere(0.5), random.point(4), random.turn());
  for (int i = 0; i < 8; ++i) {
    abut_camera camera = camera_of(random);
    camera.width = 30 + static_cast<std::uint32_t>(i);
    camera.height = 21;
    camera.projection = i % 2 == 0 ? ABUT_PROJECTION_ORTHOGRAPHIC : ABUT_PROJECTION_PERSPECTIVE;
    camera.depth_axis = ABUT_DEPTH_ALONG_AXIS;
    camera.vertical_extent = 12;
    camera.pixel_aspect = random.in(0.5, 2);
    camera.shift_x = random.in(-9, 9);
    camera.shift_y = random.in(-9, 9);
    camera.near_distance = random.in(1, 8);
    camera.far_distance = 30;
    const abut_vec3 eye = 12 * random.point(1);
    const abut_vec3 target{0, 0, -1};
    const abut_vec3 up{0, 0.1, 1};
    ASSERT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK);
    std::vector<abut_pick> picture(std::size_t{camera.width} * camera.height);
    ASSERT_EQ(abut_picker_render(world.picker(), &camera, nullptr, picture.data(), picture.size()), ABUT_OK);
    std::size_t hits = 0;
    for (std::size_t pixel = 0; pixel < picture.size(); ++pixel) {
      abut_ray ray{};
      const double x = static_cast<double>(pixel % camera.width) + 0.5;
      const double y = static_cast<double>(pixel / camera.width) + 0.5;
      ASSERT_EQ(abut_camera_ray(&camera, x, y, &ray), ABUT_OK);
      EXPECT_TRUE(is_same_pick(picture[pixel], world.pick(ray), 30)) << "camera " << i << ", pixel " << pixel;
      hits += picture[pixel].geometry.slot != 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 20U) << "camera " << i;
  }
}

// A pixel is a tenth of a metre high and a fifth wide.
TEST(PickPixel, MeasuresTheRadiusInAParallelPicture) {
  const std::array<Shape, 4> shapes{sphere(0.05), shape_of_kind("point", {}),
                                    mesh({0, 0, 0, 1, 0.5, 0, 0.5, 1, 0}, {0, 1, 2}), capsule(0.05, 0.3)};
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.projection = ABUT_PROJECTION_ORTHOGRAPHIC;
  camera.vertical_extent = 48;
  camera.pixel_aspect = 2;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE("shape " + std::to_string(i));
    const double edge = i % 2 == 0 && i != 2 ? 0.05 : i == 3 ? 0.05 : 0;
    for (const bool is_across : {false, true}) {
      World world;
      const Placed placed = world.add(shapes[i], is_across ? abut_vec3{1, 0, -50} : abut_vec3{0, 1, -50});
      const double apart = is_across ? (1 - edge) / 0.2 : (1 - edge) / 0.1;
      for (const double radius : {apart - 0.05, apart + 0.05}) {
        abut_pick pick{};
        ASSERT_EQ(abut_picker_pick_pixel(world.picker(), &camera, 320, 240, radius, nullptr, &pick), ABUT_OK);
        EXPECT_EQ(same(pick.geometry, placed.geometry), radius > apart) << (is_across ? "across, " : "up, ") << radius;
      }
    }
  }
}

}  // namespace
