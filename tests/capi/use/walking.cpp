// SPDX-License-Identifier: Apache-2.0
// A ball that walks over hills by casts alone: cast, move by the fraction, slide along what was met, cast again. Its
// distance to every triangle tells whether it sinks.
#include <cmath>
#include <random>

#include "moving.hpp"

namespace {

using namespace abut_test;

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 minus(const abut_vec3& a, const abut_vec3& b) { return sum(a, times(-1, b)); }
abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Triangle = std::array<abut_vec3, 3>;

double distance_to_segment(const abut_vec3& p, const abut_vec3& a, const abut_vec3& b) {
  const abut_vec3 along = minus(b, a);
  const double t = std::clamp(dot(minus(p, a), along) / dot(along, along), 0.0, 1.0);
  return length(minus(p, sum(a, times(t, along))));
}
double distance_to(const Triangle& triangle, const abut_vec3& p) {
  const auto& [a, b, c] = triangle;
  const abut_vec3 across = cross(minus(b, a), minus(c, a)), normal = times(1 / length(across), across);
  const double height = dot(normal, minus(p, a));
  const abut_vec3 foot = minus(p, times(height, normal));
  const auto is_left_of = [&](const abut_vec3& from, const abut_vec3& to) {
    return dot(normal, cross(minus(to, from), minus(foot, from))) >= 0;
  };
  if (is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a)) return std::abs(height);
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

struct Hills {
  Shape field, mesh, grid;
  std::vector<Triangle> triangles;
};
Hills make_hills(std::mt19937_64& random, double height) {
  constexpr std::uint32_t side = 12;
  std::vector<double> heights(std::size_t{side} * side), xyz;
  for (double& each : heights) each = height * double(random() >> 11) * 0x1p-53;
  Hills hills;
  hills.field = make_of_kind("height_field", {side, side, 1, 1}, heights);
  std::size_t vertices = 0, count = 0;
  require(abut_shape_triangles(hills.field, nullptr, 0, &vertices, nullptr, 0, &count));
  std::vector<std::uint32_t> indices(3 * count);
  xyz.resize(3 * vertices);
  require(abut_shape_triangles(hills.field, xyz.data(), vertices, &vertices, indices.data(), count, &count));
  hills.mesh = make_of_kind("mesh", {1}, xyz, indices);
  hills.grid = make_of_kind("uv_grid", {1, 0, 1, 6, 6}, xyz, indices);
  const auto corner = [&](std::size_t i) {
    const std::size_t at = 3 * std::size_t{indices[i]};
    return abut_vec3{xyz[at], xyz[at + 1], xyz[at + 2]};
  };
  for (std::size_t i = 0; i < 3 * count; i += 3) {
    hills.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
  }
  return hills;
}

TEST(WalkingBall, NeverSinksAndGetsOn) {
  constexpr std::uint64_t seed = 51;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
  constexpr abut_vec3 none{0, 0, 0};
  for (const double height : {0.0, 0.3, 0.9}) {
    const Hills hills = make_hills(random, height);
    for (const abut_shape* const ground : {static_cast<abut_shape*>(hills.field), static_cast<abut_shape*>(hills.mesh),
                                           static_cast<abut_shape*>(hills.grid)}) {
      const double radius = between(0.2, 0.6);
      const Shape ball = make_sphere(radius);
      abut_pose pose = at(5.5, 5.5, 3);
      double walked = 0;
      for (int step = 0; step < 150; ++step) {
        // Down, aside, and back to the middle.
        abut_vec3 way{0.02 * (5.5 - pose.position.x) + between(-0.2, 0.2),
                      0.02 * (5.5 - pose.position.y) + between(-0.2, 0.2), step == 0 ? -4 : -0.05};
        for (int slide = 0; slide < 4 && length(way) > 1e-9; ++slide) {
          abut_cast_hit hit{};
          std::uint32_t found = 0;
          require(abut_pair_cast(ball, &pose, &way, ground, &identity, &none, nullptr, &hit, &found));
          const double fraction = found == 1 ? hit.fraction : 1;
          walked += step == 0 ? 0 : fraction * length(way);
          pose.position = sum(pose.position, times(fraction, way));
          if (found == 0) break;
          const double against = dot(way, hit.contact.normal);
          way = times(1 - fraction, sum(way, times(-std::max(against, 0.0), hit.contact.normal)));
        }
        double gap = 9;
        for (const Triangle& triangle : hills.triangles) {
          gap = std::min(gap, distance_to(triangle, pose.position) - radius);
        }
        ASSERT_GT(gap, -1e-10) << "step " << step << ", height " << height;
        ASSERT_GT(pose.position.z, 0) << "step " << step << ", height " << height;
      }
      EXPECT_GT(walked, height == 0 ? 10 : 3);
    }
  }
}

}  // namespace
