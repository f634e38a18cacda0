// SPDX-License-Identifier: Apache-2.0
#include "catalogue.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace property {

namespace {

using oracle::Point;

std::vector<Point> points_on_sphere(std::uint64_t seed, int count, const Point& radii, const Point& centre) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count) {
    const Point p{uniform(random), uniform(random), uniform(random)};
    const double length = std::hypot(p[0], p[1], p[2]);
    if (length > 1 || length < 0.1) continue;
    points.push_back({centre[0] + radii[0] * p[0] / length, centre[1] + radii[1] * p[1] / length,
                      centre[2] + radii[2] * p[2] / length});
  }
  return points;
}

std::vector<Point> cube_points(double half) {
  std::vector<Point> points;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      for (const double z : {-half, half}) points.push_back({x, y, z});
    }
  }
  return points;
}

std::vector<Point> polygon(int corners, double z) {
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    points.push_back({std::cos(angle), std::sin(angle), z});
  }
  return points;
}

std::vector<Point> joined(std::vector<Point> first, const std::vector<Point>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

void add_boxes(std::vector<Subject>& list) {
  list.push_back(make_box("box", 1, 0.7, 0.4));
  list.push_back(make_box("cube", 0.5, 0.5, 0.5));
  list.push_back(make_box("tiny box", 1e-3, 1.5e-3, 2e-3));
  list.push_back(make_box("huge box", 1000, 800, 900));
  list.push_back(make_box("needle box", 1e-4, 1e-4, 1));
  list.push_back(make_box("plate box", 1, 1, 1e-4));
  list.push_back(make_box("flat box", 1, 0.5, 0));
  list.push_back(make_box("segment box", 0, 0.8, 0));
  list.push_back(make_box("point box", 0, 0, 0));
}

void add_hulls(std::vector<Subject>& list) {
  list.push_back(make_hull("tetrahedron", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  list.push_back(make_hull("cube hull", cube_points(0.5)));
  list.push_back(make_hull("prism hull", joined(polygon(6, -0.5), polygon(6, 0.5))));
  list.push_back(make_hull("round hull", points_on_sphere(11, 16, {1, 0.8, 0.6}, {0, 0, 0})));
  list.push_back(make_hull("shifted hull", points_on_sphere(12, 12, {1, 1, 1}, {30, -20, 10})));
  list.push_back(make_hull("needle hull", points_on_sphere(13, 10, {1e-4, 1e-4, 1}, {0, 0, 0})));
  list.push_back(make_hull("plate hull", points_on_sphere(14, 12, {1, 1, 1e-4}, {0, 0, 0})));
  list.push_back(make_hull("tiny hull", points_on_sphere(15, 10, {1e-3, 1e-3, 1e-3}, {0, 0, 0})));
  list.push_back(make_hull("point hull", {{0.25, 0.5, 0.75}}));
  list.push_back(make_hull("segment hull", {{-0.5, 0, 0.25}, {0.7, 0.3, 0.1}}));
  list.push_back(make_hull("triangle hull", {{0, 0, 0}, {1, 0.25, 0.5}, {-0.25, 1, 0.75}}));
  list.push_back(make_hull("polygon hull", polygon(6, 0.125)));
  list.push_back(make_hull("hull with repeats", joined(cube_points(0.5), cube_points(0.5))));
  list.push_back(make_hull("collinear hull", {{0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5}, {0.25, 0.25, 0.25}, {1, 1, 1}}));
}

}  // namespace

std::vector<Subject> convex_subjects() {
  std::vector<Subject> list;
  list.push_back(make_sphere("sphere", 0.5));
  list.push_back(make_sphere("tiny sphere", 1e-3));
  list.push_back(make_sphere("huge sphere", 1000));
  add_boxes(list);
  list.push_back(make_capsule("capsule", 0.3, 1));
  list.push_back(make_capsule("round capsule", 0.5, 0));
  list.push_back(make_capsule("needle capsule", 1e-4, 1));
  list.push_back(make_capsule("tiny capsule", 1e-3, 1e-3));
  add_hulls(list);
  return list;
}

std::vector<Subject> plane_subjects() {
  std::vector<Subject> list;
  list.push_back(make_plane("ground", {0, 0, 1}, 0));
  list.push_back(make_plane("slope", {1, -2, 3}, 2.5));
  return list;
}

namespace {

oracle::Soup bumpy_sheet() {
  oracle::Soup soup;
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) soup.points.push_back({i - 1.5, j - 1.5, uniform(random)});
  }
  for (std::uint32_t j = 0; j < 3; ++j) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = j * 4 + i;
      soup.triangles.push_back({corner, corner + 1, corner + 5});
      soup.triangles.push_back({corner, corner + 5, corner + 4});
    }
  }
  return soup;
}

oracle::Soup cube_surface() {
  oracle::Soup soup;
  soup.points = cube_points(0.5);
  for (const auto& quad : {std::array<std::uint32_t, 4>{0, 1, 3, 2},
                           {4, 6, 7, 5},
                           {0, 4, 5, 1},
                           {2, 3, 7, 6},
                           {0, 2, 6, 4},
                           {1, 5, 7, 3}}) {
    soup.triangles.push_back({quad[0], quad[1], quad[2]});
    soup.triangles.push_back({quad[0], quad[2], quad[3]});
  }
  return soup;
}

// Triangles without area, a repeated triangle, a vertex that no triangle uses.
oracle::Soup dirty_soup() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 1}, {9, 9, 9}},
          {{0, 1, 2}, {0, 1, 2}, {0, 1, 3}, {4, 4, 4}, {0, 4, 4}, {2, 1, 4}}};
}

Grid hills(std::uint32_t columns, std::uint32_t rows) {
  Grid grid{columns, rows, 0.5, 0.75, {}};
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  for (std::uint32_t i = 0; i < columns * rows; ++i) grid.heights.push_back(uniform(random));
  return grid;
}

}  // namespace

std::vector<Subject> surface_subjects() {
  std::vector<Subject> list;
  list.push_back(make_mesh("bumpy sheet", bumpy_sheet()));
  list.push_back(make_mesh("cube surface", cube_surface()));
  list.push_back(make_mesh("one triangle", {{{0, 0, 0}, {1, 0.25, 0.5}, {-0.25, 1, 0.75}}, {{0, 1, 2}}}));
  list.push_back(make_mesh("dirty soup", dirty_soup()));
  list.push_back(make_height_field("hills", hills(6, 5)));
  list.push_back(make_height_field("smallest field", {2, 2, 1, 1, {0, 0.25, -0.25, 0}}));
  return list;
}

}  // namespace property
