// SPDX-License-Identifier: Apache-2.0
#include "body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oracle {

Body make_sphere(double radius) { return {{{0, 0, 0}}, radius}; }

Body make_capsule(double radius, double half_height) { return {{{0, 0, -half_height}, {0, 0, half_height}}, radius}; }

Body make_box(double x, double y, double z) {
  Body body;
  for (const double sx : {-x, x}) {
    for (const double sy : {-y, y}) {
      for (const double sz : {-z, z}) body.core.push_back({sx, sy, sz});
    }
  }
  return body;
}

Body make_hull(std::vector<Point> points) { return {std::move(points), 0}; }

namespace {

double farthest(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& p : points) size = std::max(size, std::hypot(p[0], p[1], p[2]));
  return size;
}

}  // namespace

double size_of(const Body& body) { return farthest(body.core) + body.radius; }

double size_of(const Soup& soup) { return farthest(soup.points); }

}  // namespace oracle
