// SPDX-License-Identifier: Apache-2.0
#include "surface_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "oracle/overlap.hpp"
#include "random_soups.hpp"

namespace property {

namespace {

using oracle::Point;
using oracle::Soup;

ShapePtr owned(abut_status status, abut_shape* shape) {
  if (status != ABUT_OK) throw std::runtime_error(abut_last_error_message());
  return ShapePtr(shape);
}

std::size_t below(Random& random, std::size_t count) { return static_cast<std::size_t>(random() % count); }
std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

struct Arrays {
  std::vector<double> xyz;
  std::vector<std::uint32_t> corners;
};

Arrays arrays_of(const Soup& soup) {
  Arrays arrays;
  for (const Point& p : soup.points) arrays.xyz.insert(arrays.xyz.end(), p.begin(), p.end());
  for (const auto& t : soup.triangles) arrays.corners.insert(arrays.corners.end(), t.begin(), t.end());
  return arrays;
}

SceneShape surface(std::string kind, ShapePtr shape, const Soup& soup, bool is_one_sided) {
  return {std::move(kind), std::move(shape), soup, {}, true, is_one_sided, false, oracle::size_of(soup)};
}

std::string kind_of_sides(const std::string& kind, abut_sides sides) {
  return sides == ABUT_SIDES_FRONT ? kind + " front" : sides == ABUT_SIDES_SOLID ? kind + " solid" : kind;
}

SceneShape mesh_of_soup(const Soup& soup, abut_sides sides) {
  const Arrays arrays = arrays_of(soup);
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.sides = sides;
  abut_shape* shape = nullptr;
  const abut_status status = abut_mesh_create(arrays.xyz.data(), soup.points.size(), arrays.corners.data(),
                                              soup.triangles.size(), &options, &shape);
  return surface(kind_of_sides("mesh", sides), owned(status, shape), soup, sides == ABUT_SIDES_FRONT);
}

}  // namespace

SceneShape random_mesh(Random& random, abut_sides sides, double by) {
  return mesh_of_soup(random_soup(random, by), sides);
}

SceneShape random_solid(Random& random, double by) {
  SceneShape solid = mesh_of_soup(closed_soup(random, by), ABUT_SIDES_SOLID);
  solid.is_solid = true;
  return solid;
}

SceneShape random_uv_grid(Random& random, abut_sides sides, double by) {
  const Soup soup = random_soup(random, by);
  const Arrays arrays = arrays_of(soup);
  abut_uv_grid_options options;
  abut_uv_grid_options_init(&options, sizeof options);
  options.sides = sides;
  abut_shape* shape = nullptr;
  const abut_status status = abut_uv_grid_create(arrays.xyz.data(), soup.points.size(), arrays.corners.data(),
                                                 soup.triangles.size(), &options, &shape);
  return surface(kind_of_sides("uv_grid", sides), owned(status, shape), soup, sides == ABUT_SIDES_FRONT);
}

SceneShape random_height_field(Random& random, double by) {
  const std::size_t columns = 3 + below(random, 4), rows = 3 + below(random, 3), diagonal = below(random, 3);
  const double spacing_x = by * between(random, 0.2, 0.6), spacing_y = by * between(random, 0.2, 0.6);
  const double rough = by * roughness(random);
  std::vector<double> heights;
  for (std::size_t i = 0; i < columns * rows; ++i) heights.push_back(rough * between(random, -1, 1));
  if (happens(random, 0.3)) heights[below(random, columns)] = std::numeric_limits<double>::quiet_NaN();
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.diagonal = static_cast<abut_diagonal>(diagonal);
  desc.columns = index(columns);
  desc.rows = index(rows);
  desc.spacing_x = spacing_x;
  desc.spacing_y = spacing_y;
  desc.heights = heights.data();
  abut_shape* shape = nullptr;
  const abut_status status = abut_height_field_create(&desc, &shape);
  Soup soup;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      soup.points.push_back(
          {static_cast<double>(i) * spacing_x, static_cast<double>(j) * spacing_y, heights[j * columns + i]});
    }
  }
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (std::isnan(heights[a]) || std::isnan(heights[b]) || std::isnan(heights[c])) return;
    soup.triangles.push_back({index(a), index(b), index(c)});
  };
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t a = j * columns + i, b = a + 1, c = b + columns, d = a + columns;
      const bool rises = diagonal == 0 || (diagonal == 2 && (i + j) % 2 == 0);
      add(a, b, rises ? c : d);
      add(rises ? a : b, c, d);
    }
  }
  for (Point& p : soup.points) p[2] = std::isnan(p[2]) ? 0 : p[2];
  return surface("height_field", owned(status, shape), soup, true);
}

SceneShape random_body(Random& random, const std::string& kind, double by) {
  const auto length = [&] { return by * between(random, 0.1, 0.6); };
  abut_shape* shape = nullptr;
  abut_status status = ABUT_OK;
  oracle::Body body;
  if (kind == "sphere") {
    const double radius = length();
    status = abut_sphere_create(radius, &shape);
    body = oracle::make_sphere(radius);
  } else if (kind == "capsule") {
    const double radius = length(), half = length();
    status = abut_capsule_create(radius, half, &shape);
    body = oracle::make_capsule(radius, half);
  } else if (kind == "segment") {
    const double half = length();
    status = abut_segment_create(half, &shape);
    body = oracle::make_capsule(0, half);
  } else if (kind == "triangle") {
    std::array<abut_vec3, 3> corners{};
    for (abut_vec3& p : corners) {
      p = {by * between(random, -0.5, 0.5), by * between(random, -0.5, 0.5), by * between(random, -0.5, 0.5)};
      body.core.push_back({p.x, p.y, p.z});
    }
    status = abut_triangle_create(&corners[0], &corners[1], &corners[2], &shape);
  } else if (kind == "box") {
    const double x = length(), y = length(), z = length();
    status = abut_box_create(x, y, z, &shape);
    body = oracle::make_box(x, y, z);
  } else {
    std::vector<double> xyz;
    for (std::size_t i = 0, count = 6 + below(random, 6); i < count; ++i) {
      const abut_vec3 direction = random_direction(random);
      const double reach = length();
      const Point p{reach * direction.x, reach * direction.y, reach * direction.z};
      xyz.insert(xyz.end(), p.begin(), p.end());
      body.core.push_back(p);
    }
    status = abut_hull_create(xyz.data(), body.core.size(), &shape);
  }
  const double size = oracle::size_of(body);
  return {kind, owned(status, shape), {}, body, false, false, false, size};
}

oracle::Side side_of(const SceneShape& shape, const abut_pose& pose, const oracle::Vec& origin) {
  return shape.is_surface ? oracle::side_of(shape.soup, shape.is_one_sided, pose_of(pose), origin)
                          : oracle::side_of(shape.body, pose_of(pose), origin);
}

namespace {

// A point of one of the triangles.
abut_vec3 point_on(const Soup& soup, Random& random) {
  const auto& t = soup.triangles[below(random, soup.triangles.size())];
  double u = between(random, 0, 1), v = between(random, 0, 1);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  Point p{};
  p = oracle::sum(p, soup.points[t[0]], 1 - u - v);
  p = oracle::sum(p, soup.points[t[1]], u);
  p = oracle::sum(p, soup.points[t[2]], v);
  return {p[0], p[1], p[2]};
}

// Leaves the gap, but for rounding and for neighbours that are met on the way.
void leave_gap(const SceneShape& a, const SceneShape& b, SurfaceScene& scene, double gap) {
  const oracle::Vec origin = vec_of(scene.a.position);
  const oracle::Side side = side_of(a, scene.a, origin);
  for (int i = 0; i < 3; ++i) {
    const oracle::Meeting meeting = oracle::meeting_of(side, side_of(b, scene.b, origin));
    const double off = gap - static_cast<double>(meeting.distance);
    if (std::abs(off) <= 1e-12 * (a.size + b.size)) return;
    scene.b.position = moved(scene.b.position, property::rounded(meeting.normal), off);
  }
}

}  // namespace

SurfaceScene place_on(const SceneShape& a, const SceneShape& b, Random& random) {
  SurfaceScene scene{"", {{0, 0, 0}, {1, 0, 0, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}};
  if (happens(random, 0.7)) scene.b.orientation = random_orientation(random);
  scene.b.position = moved(point_on(a.soup, random), random_direction(random), between(random, 0, 1.2) * b.size);
  if (happens(random, 0.5)) {
    scene.a.orientation = random_orientation(random);
    scene.a.position = moved({0, 0, 0}, random_direction(random), 3 * a.size);
    scene.b = composed(scene.a, scene.b);
  }
  switch (below(random, 4)) {
    case 0: scene.name = "deep"; break;
    case 1:
      scene.name = "sunk in";
      leave_gap(a, b, scene, -std::pow(10, between(random, -5, -1.5)) * b.size);
      break;
    case 2:
      scene.name = "touching";
      leave_gap(a, b, scene, between(random, -1, 1) * 1e-9 * b.size);
      break;
    default: scene.name = "apart"; leave_gap(a, b, scene, std::pow(10, between(random, -5, 0)) * b.size);
  }
  return scene;
}

}  // namespace property
