// SPDX-License-Identifier: Apache-2.0
#include "search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace oracle {

namespace {

constexpr int sphere_directions = 600;
constexpr std::size_t circle_directions = 32;
constexpr std::size_t refined = 10;

bool is_less(const Proposal& p, const Proposal& q) { return p.overlap < q.overlap; }

}  // namespace

void keep_best(std::vector<Proposal>& list, std::size_t count) {
  const std::size_t kept = std::min(count, list.size());
  std::partial_sort(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(kept), list.end(), is_less);
  list.resize(kept);
}

namespace {

// The first places of a sorted list that are not next to an earlier one: each valley is searched once.
void keep_scattered(std::vector<Proposal>& list, std::size_t count) {
  std::vector<Proposal> kept;
  for (const Proposal& proposal : list) {
    const auto is_near = [&proposal](const Proposal& other) { return inner(proposal.place, other.place) > 0.97; };
    if (kept.size() < count && std::none_of(kept.begin(), kept.end(), is_near)) kept.push_back(proposal);
  }
  list = kept;
}

// Directions even on the sphere (Fibonacci lattice).
std::vector<Point> even_directions() {
  std::vector<Point> list;
  for (int i = 0; i < sphere_directions; ++i) {
    const double z = 1 - (2 * i + 1.0) / sphere_directions;
    const double radius = std::sqrt(1 - z * z);
    const double angle = 2 * std::numbers::pi * i / std::numbers::phi;
    list.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return list;
}

void add_squares(Matrix& squares, const Matrix& to_local, const Point& extents) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      squares[row] = sum(squares[row], to_local[i], extents[i] * extents[i] * to_local[i][row]);
    }
  }
}

}  // namespace

// In units of the larger solid; what is thinner than 1e-7 counts as that thick.
Chart stretched(const Pair& pair) {
  const double size = std::max({pair.a().size, pair.b().size, 1e-300});
  const auto relative = [size](const Point& p) { return Point{p[0] / size, p[1] / size, p[2] / size}; };
  constexpr double floor = 1e-14;
  Matrix c{Point{floor, 0, 0}, Point{0, floor, 0}, Point{0, 0, floor}};
  add_squares(c, pair.to_a(), relative(pair.a().extents));
  add_squares(c, pair.to_b(), relative(pair.b().extents));
  const double l00 = std::sqrt(std::max(c[0][0], floor));
  const double l10 = c[1][0] / l00;
  const double l20 = c[2][0] / l00;
  const double l11 = std::sqrt(std::max(c[1][1] - l10 * l10, floor));
  const double l21 = (c[2][1] - l20 * l10) / l11;
  const double l22 = std::sqrt(std::max(c[2][2] - l20 * l20 - l21 * l21, floor));
  const double inverse_12 = -l21 / (l11 * l22);
  const double inverse_02 = -(l10 * inverse_12 + l20 / l22) / l00;
  return {{Point{1 / l00, -l10 / (l00 * l11), inverse_02}, Point{0, 1 / l11, inverse_12}, Point{0, 0, 1 / l22}},
          {Point{l00, l10, l20}, Point{0, l11, l21}, Point{0, 0, l22}}};
}

namespace {

// Tries eight places around the best at a step, turned a little each time, and halves the step when none is better.
Point refined_on_sphere(const Pair& pair, const Chart& chart, const Point& start, double first_step) {
  const auto overlap_at = [&](const Point& place) { return pair.overlap(chart.direction(place)); };
  Proposal best{overlap_at(start), start};
  double turn = 0;
  int tries = 0;
  for (double step = first_step; step > 1e-11 && tries < 120; ++tries) {
    const Point& p = best.place;
    const Point u = unit_of(vector_product(p, std::abs(p[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0}));
    const Point v = vector_product(p, u);
    Proposal next = best;
    for (int i = 0; i < 8; ++i) {
      const double angle = turn + i * std::numbers::pi / 4;
      const Point place = unit_of(sum(sum(p, u, step * std::cos(angle)), v, step * std::sin(angle)));
      const double there = overlap_at(place);
      if (there < next.overlap) next = {there, place};
    }
    turn += std::numbers::phi;
    if (!(next.overlap < best.overlap)) step /= 2;
    best = next;
  }
  return chart.direction(best.place);
}

}  // namespace

void add_sphere(const Pair& pair, const Chart& chart, const Point& hint, std::vector<Point>& found) {
  std::vector<Proposal> list;
  for (const Point& place : even_directions()) list.push_back({pair.overlap(chart.direction(place)), place});
  keep_best(list, sphere_directions / 10);
  keep_scattered(list, refined / 2);
  list.push_back({0, chart.place(hint)});
  for (const Proposal& proposal : list) found.push_back(refined_on_sphere(pair, chart, proposal.place, 0.1));
}

namespace {

Point direction_at(const Circle& circle, double angle) {
  return unit_of(sum(sum(circle.axis, circle.u, std::cos(angle)), circle.v, std::sin(angle)));
}

// Golden section between two angles.
double refined_angle(const Pair& pair, const Circle& circle, double low, double high) {
  const double share = 1 / std::numbers::phi;
  double left = high - share * (high - low);
  double right = low + share * (high - low);
  double at_left = pair.overlap(direction_at(circle, left));
  double at_right = pair.overlap(direction_at(circle, right));
  for (int i = 0; i < 70; ++i) {
    if (at_left <= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - share * (high - low);
      at_left = pair.overlap(direction_at(circle, left));
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + share * (high - low);
      at_right = pair.overlap(direction_at(circle, right));
    }
  }
  return at_left <= at_right ? left : right;
}

}  // namespace

void add_circles(const Pair& pair, const std::vector<Circle>& circles, std::vector<Point>& found) {
  std::vector<Proposal> list;
  const double step = 2 * std::numbers::pi / static_cast<double>(circle_directions);
  for (std::size_t c = 0; c < circles.size(); ++c) {
    std::array<double, circle_directions> overlaps{};
    for (std::size_t i = 0; i < circle_directions; ++i) {
      overlaps[i] = pair.overlap(direction_at(circles[c], step * static_cast<double>(i)));
    }
    for (std::size_t i = 0; i < circle_directions; ++i) {
      const double before = overlaps[(i + circle_directions - 1) % circle_directions];
      const double after = overlaps[(i + 1) % circle_directions];
      if (overlaps[i] > before || overlaps[i] > after) continue;
      list.push_back({overlaps[i], {static_cast<double>(c), step * static_cast<double>(i), 0}});
    }
  }
  keep_best(list, refined);
  for (const auto& [overlap, place] : list) {
    const Circle& circle = circles[static_cast<std::size_t>(place[0])];
    found.push_back(direction_at(circle, refined_angle(pair, circle, place[1] - step, place[1] + step)));
    // Thin ellipsoids have a narrow valley instead of a kink, and its floor may lie beside the circle.
    found.push_back(refined_on_sphere(pair, Chart{}, found.back(), 1e-5));
  }
}

Circle circle_of(const Vec& axis, Quad height) {
  const Vec u = perpendicular(axis);
  const Quad radius = square_root(1 - height * height);
  return {rounded(axis * height), rounded(u * radius), rounded(cross(axis, u) * radius)};
}

}  // namespace oracle
