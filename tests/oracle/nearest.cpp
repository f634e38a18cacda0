// SPDX-License-Identifier: Apache-2.0
#include "nearest.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "support.hpp"

namespace oracle {

namespace {

constexpr int most_steps = 400;
constexpr Quad enough = quad(1e-26);  // of the size: the interval may be this wide

// What GJK works on: a solid without its radius, which is added at the end.
std::pair<Solid, Quad> core_of(const Solid& solid) {
  std::pair<Solid, Quad> result{solid, 0};
  if (auto* rounded = std::get_if<Rounded>(&result.first.form)) {
    result.second = quad(rounded->body.radius);
    rounded->body.radius = 0;
  }
  return result;
}

using Points = std::vector<Vec>;

// Weights of the points that make the nearest point of their affine hull to the origin. Empty where they are dependent.
// Solved by elimination with the largest pivot.
std::vector<Quad> weights_of(const Points& points) {
  const std::size_t n = points.size() - 1;
  std::array<std::array<Quad, 4>, 3> m{};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec side = points[i + 1] - points[0];
    for (std::size_t j = 0; j < n; ++j) m[i][j] = dot(side, points[j + 1] - points[0]);
    m[i][3] = -dot(side, points[0]);
  }
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < n; ++i) {
      if (absolute(m[i][column]) > absolute(m[pivot][column])) pivot = i;
    }
    std::swap(m[pivot], m[column]);
    if (!(absolute(m[column][column]) > 0)) return {};
    for (std::size_t i = 0; i < n; ++i) {
      if (i == column) continue;
      const Quad factor = m[i][column] / m[column][column];
      for (std::size_t j = column; j < 4; ++j) m[i][j] -= factor * m[column][j];
    }
  }
  std::vector<Quad> weights{1};
  for (std::size_t i = 0; i < n; ++i) {
    weights.push_back(m[i][3] / m[i][i]);
    weights[0] -= weights.back();
  }
  return weights;
}

struct Subset {
  Points points;
  Vec nearest;
};

// The nearest point of a simplex to the origin and the points that make it: the best of all its faces whose own nearest
// point lies inside them. A simplex that is known not to hold the origin may still seem to, where it is thin.
Subset nearest_subset(const Points& simplex, bool may_hold_origin) {
  Subset best{{simplex.back()}, simplex.back()};
  for (unsigned chosen = 1; chosen < (1U << simplex.size()); ++chosen) {
    Points points;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((chosen >> i & 1U) != 0) points.push_back(simplex[i]);
    }
    if (points.size() > 3 && !may_hold_origin) continue;
    const std::vector<Quad> weights = weights_of(points);
    if (weights.empty() || std::any_of(weights.begin(), weights.end(), [](Quad w) { return w < 0; })) continue;
    Vec sum;
    for (std::size_t i = 0; i < points.size(); ++i) sum = sum + points[i] * weights[i];
    if (dot(sum, sum) < dot(best.nearest, best.nearest)) best = {points, sum};
  }
  return best;
}

}  // namespace

Nearest nearest(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b) {
  const auto [core_a, radius_a] = core_of(a);
  const auto [core_b, radius_b] = core_of(b);
  const Vec between = pose_b.position - pose_a.position;
  // The point of b minus a that lies furthest against n.
  const auto support = [&](const Vec& n) {
    return pose_b.rotate(support_point(core_b, pose_b.rotate_back(-n))) -
           pose_a.rotate(support_point(core_a, pose_a.rotate_back(n))) + between;
  };
  const Quad size = quad(a.size) + quad(b.size) + length(between);
  Subset simplex;
  simplex.nearest = support(length(between) > 0 ? unit(between) : Vec{1, 0, 0});
  simplex.points = {simplex.nearest};
  Nearest result;
  for (int step = 0; step < most_steps && simplex.points.size() < 4; ++step) {
    const Quad distance = length(simplex.nearest);
    if (!(distance > enough * size)) break;
    const Vec n = simplex.nearest * (1 / distance);
    const Vec next = support(n);
    const Quad separation = dot(n, next);
    if (step == 0 || separation > result.lower) result = {separation > 0, separation, distance, n};
    result.upper = distance;
    if (distance - result.lower <= enough * size) break;
    Points grown = simplex.points;
    grown.push_back(next);
    const Subset better = nearest_subset(grown, !result.is_known);
    if (!(dot(better.nearest, better.nearest) < distance * distance)) break;
    simplex = better;
  }
  const bool is_enclosed = simplex.points.size() > 3;
  if (is_enclosed) result.upper = 0;
  result.lower -= radius_a + radius_b;
  result.upper -= radius_a + radius_b;
  return result;
}

}  // namespace oracle
