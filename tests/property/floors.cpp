// SPDX-License-Identifier: Apache-2.0
#include "floors.hpp"

#include <algorithm>
#include <cmath>

#include "scenes.hpp"

namespace property {

namespace {

using Vec = std::array<double, 3>;

Vec vec(const abut_vec3& v) { return {v.x, v.y, v.z}; }
Vec minus(const Vec& u, const Vec& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
double times(const Vec& u, const Vec& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

double distance_to_segment(const Vec& p, const Vec& a, const Vec& b) {
  const Vec along = minus(b, a);
  const Vec from = minus(p, a);
  const double square = times(along, along);
  const double t = square > 0 ? std::clamp(times(from, along) / square, 0.0, 1.0) : 0.0;
  const Vec off{from[0] - t * along[0], from[1] - t * along[1], from[2] - t * along[2]};
  return std::sqrt(times(off, off));
}

double distance_to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const double to_rim =
      std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
  const Vec u = minus(b, a);
  const Vec v = minus(c, a);
  const Vec n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double uu = times(u, u), uv = times(u, v), vv = times(v, v);
  const Vec w = minus(p, a);
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return to_rim;
  const double s = (times(w, u) * vv - times(w, v) * uv) / area;
  const double t = (times(w, v) * uu - times(w, u) * uv) / area;
  return s >= 0 && t >= 0 && s + t <= 1 ? std::abs(times(w, n)) / std::sqrt(times(n, n)) : to_rim;
}

double rounded_if(bool as_float, double x) { return as_float ? static_cast<double>(static_cast<float>(x)) : x; }

}  // namespace

std::vector<double> heights_of(const Floor& floor, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> heights(std::size_t{floor.cells + 1} * (floor.cells + 1));
  for (double& height : heights) height = floor.noise * between(random, -1, 1);
  return heights;
}

TriangleSoup soup_of(const Floor& floor, std::uint64_t seed) {
  const std::vector<double> heights = heights_of(floor, seed);
  const std::uint32_t side = floor.cells + 1;
  // Floats round a floor that leans: a level one stays level.
  const double slope = floor.as_float ? 0.3 : 0;
  TriangleSoup soup;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const double x = (i - 0.5 * floor.cells) * floor.spacing;
      const double y = (j - 0.5 * floor.cells) * floor.spacing;
      const double z = heights[std::size_t{j} * side + i];
      const abut_vec3 p{std::cos(slope) * x - std::sin(slope) * z, y, std::sin(slope) * x + std::cos(slope) * z};
      soup.vertices.push_back(
          {rounded_if(floor.as_float, p.x), rounded_if(floor.as_float, p.y), rounded_if(floor.as_float, p.z)});
      if (i == floor.cells || j == floor.cells) continue;
      const std::uint32_t corner = j * side + i;
      soup.triangles.push_back({corner, corner + 1, corner + side + 1});
      soup.triangles.push_back({corner, corner + side + 1, corner + side});
    }
  }
  return soup;
}

ShapePtr mesh_of(const TriangleSoup& soup, abut_sides sides) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.sides = sides;
  std::vector<double> xyz;
  for (const abut_vec3& v : soup.vertices) xyz.insert(xyz.end(), {v.x, v.y, v.z});
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : soup.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  abut_shape* shape = nullptr;
  const abut_status status =
      abut_mesh_create(xyz.data(), soup.vertices.size(), corners.data(), soup.triangles.size(), &options, &shape);
  return ShapePtr(status == ABUT_OK ? shape : nullptr);
}

double rise_around(const TriangleSoup& soup, const abut_vec3& point, const abut_vec3& normal) {
  const Vec p = vec(point);
  const Vec n = vec(normal);
  double rise = 0;
  for (const auto& triangle : soup.triangles) {
    const std::array<Vec, 3> corners{vec(soup.vertices[triangle[0]]), vec(soup.vertices[triangle[1]]),
                                     vec(soup.vertices[triangle[2]])};
    if (distance_to_triangle(p, corners[0], corners[1], corners[2]) > 1e-11) continue;
    for (const Vec& corner : corners) {
      const Vec to = minus(corner, p);
      // The direction to a corner that the point lies on is rounding.
      const double length = std::sqrt(times(to, to));
      if (length > 1e-6) rise = std::max(rise, times(n, to) / length);
    }
  }
  return rise;
}

}  // namespace property
