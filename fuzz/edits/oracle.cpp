// SPDX-License-Identifier: Apache-2.0
#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edit_fuzzing {
namespace {

using Number = long double;
using Vector = std::array<Number, 3>;

Vector vector_of(const Point& point) {
  return {static_cast<Number>(point[0]), static_cast<Number>(point[1]), static_cast<Number>(point[2])};
}
Vector between(const Point& from, const Point& to) {
  const Vector a = vector_of(from), b = vector_of(to);
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}
Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Number length(const Vector& a) { return std::sqrt(dot(a, a)); }

Number distance_from_segment(const Point& point, const Point& a, const Point& b) {
  const Vector edge = between(a, b), way = between(a, point);
  const Number square = dot(edge, edge);
  const Number share = square > 0 ? std::clamp(dot(way, edge) / square, Number{0}, Number{1}) : 0;
  return length({way[0] - share * edge[0], way[1] - share * edge[1], way[2] - share * edge[2]});
}

// The plane where the point projects into the triangle; else the nearest of its edges.
Number distance_from_triangle(const Point& point, const Triangle& triangle) {
  Number best = std::numeric_limits<Number>::infinity();
  const Vector normal = cross(between(triangle[0], triangle[1]), between(triangle[0], triangle[2]));
  const Number area = length(normal);
  bool is_over = area > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = triangle.at(i), &to = triangle.at((i + 1) % 3);
    best = std::min(best, distance_from_segment(point, from, to));
    is_over = is_over && dot(normal, cross(between(from, to), between(from, point))) >= 0;
  }
  return is_over ? std::min(best, std::fabs(dot(normal, between(triangle[0], point))) / area) : best;
}

}  // namespace

double distance_from(const Point& point, const std::vector<Triangle>& triangles) {
  Number best = std::numeric_limits<Number>::infinity();
  for (const Triangle& triangle : triangles) {
    best = std::min(best, distance_from_triangle(point, triangle));
  }
  return static_cast<double>(best);
}

double distance_from(const Point& point, const std::vector<Ball>& balls) {
  Number best = std::numeric_limits<Number>::infinity();
  for (const Ball& ball : balls) {
    best = std::min(best, length(between(ball.centre, point)) - static_cast<Number>(ball.radius));
  }
  return static_cast<double>(best);
}

// A triangle is crossed where the three volumes between the ray and its edges have one sign.
Crossing first_crossing(const Point& origin, const Point& direction, const std::vector<Triangle>& triangles) {
  constexpr Number close = 1e-9L;
  Crossing out;
  const Vector way = vector_of(direction);
  for (const Triangle& triangle : triangles) {
    const Vector normal = cross(between(triangle[0], triangle[1]), between(triangle[0], triangle[2]));
    const Number slope = dot(normal, way), size = length(normal) * length(way);
    if (std::fabs(slope) <= close * size) {
      // Along the plane: sure only where it stays away from it.
      out.is_sure = out.is_sure && std::fabs(dot(normal, between(origin, triangle[0]))) > close * size;
      continue;
    }
    const Number at = dot(normal, between(origin, triangle[0])) / slope;
    Number least = std::numeric_limits<Number>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector from = between(origin, triangle.at(i)), to = between(origin, triangle.at((i + 1) % 3));
      least = std::min(least, dot(way, cross(from, to)) / slope);
    }
    if (least > -close && at > -close) {
      out.is_sure = out.is_sure && least > close && at > close;
      out.at = std::min(out.at.value_or(std::numeric_limits<double>::infinity()), static_cast<double>(at));
    }
  }
  return out;
}

}  // namespace edit_fuzzing
