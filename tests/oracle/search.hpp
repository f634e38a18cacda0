// SPDX-License-Identifier: Apache-2.0
// Searches for the directions of least overlap: all over the sphere, and along circles where the overlap has a kink.
#pragma once

#include <cstddef>
#include <vector>

#include "overlap.hpp"

namespace oracle {

struct Proposal {
  double overlap;
  Point place;  // a direction, or what a search makes one of
};

// The best come first.
void keep_best(std::vector<Proposal>& list, std::size_t count);

// Places on the sphere that stand for directions n: place = L^T n without its length. Let L L^T be the squared
// extents of both solids together. Then their difference is about as wide at every place, and a needle or a plate is
// searched as well as a ball.
struct Chart {
  Matrix to_direction{Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
  Matrix to_place = to_direction;

  [[nodiscard]] Point direction(const Point& place) const { return unit_of(times(to_direction, place)); }
  [[nodiscard]] Point place(const Point& direction) const { return unit_of(times(to_place, direction)); }
};

[[nodiscard]] Chart stretched(const Pair& pair);

// Points of a circle of directions by angle.
struct Circle {
  Point axis, u, v;  // u and v as long as the radius
};

[[nodiscard]] Circle circle_of(const Vec& axis, Quad height);

// Add the best directions found. `hint` is one more to start from.
void add_sphere(const Pair& pair, const Chart& chart, const Point& hint, std::vector<Point>& found);
void add_circles(const Pair& pair, const std::vector<Circle>& circles, std::vector<Point>& found);

}  // namespace oracle
