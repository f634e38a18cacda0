// SPDX-License-Identifier: Apache-2.0
#include "separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "closest.hpp"

namespace oracle {

namespace {

struct Axis {
  Vec direction;
  Quad separation = 0;
};

struct Rounded {
  double x, y, z;
};

Rounded rounded(const Vec& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }

std::vector<Rounded> rounded(const std::vector<Vec>& points) {
  std::vector<Rounded> result;
  for (const Vec& p : points) result.push_back(rounded(p));
  return result;
}

// Looks for the direction of the largest separation. Candidates are first tried in double; only those that could win
// within its error are evaluated in 113 bits.
class BestAxis {
 public:
  BestAxis(const Features& a, const Features& b) : a_(rounded(a.points)), b_(rounded(b.points)) {
    reach_ = static_cast<double>(a.size + b.size + length(a.centre) + length(b.centre));
  }

  void offer(const Vec& raw, const Features& a, const Features& b) {
    const Quad squared = dot(raw, raw);
    if (!(squared > 0)) return;
    const Vec direction = raw * (1 / square_root(squared));
    const double error = 64 * std::numeric_limits<double>::epsilon() * reach_;
    if (found && rough(rounded(direction)) + error < static_cast<double>(best.separation)) return;
    try_exactly(direction, a, b);
  }

  Axis best;
  bool found = false;

 private:
  [[nodiscard]] double rough(const Rounded& n) const {
    const double infinity = std::numeric_limits<double>::infinity();
    double high_a = -infinity, high_b = -infinity, low_a = infinity, low_b = infinity;
    for (const Rounded& p : a_) {
      const double height = n.x * p.x + n.y * p.y + n.z * p.z;
      high_a = std::max(high_a, height);
      low_a = std::min(low_a, height);
    }
    for (const Rounded& p : b_) {
      const double height = n.x * p.x + n.y * p.y + n.z * p.z;
      high_b = std::max(high_b, height);
      low_b = std::min(low_b, height);
    }
    return std::max(low_b - high_a, low_a - high_b);
  }

  void try_exactly(const Vec& n, const Features& a, const Features& b) {
    Quad high_a = dot(n, a.points.front()), low_a = high_a;
    Quad high_b = dot(n, b.points.front()), low_b = high_b;
    for (const Vec& p : a.points) {
      const Quad height = dot(n, p);
      high_a = larger(high_a, height);
      low_a = smaller(low_a, height);
    }
    for (const Vec& p : b.points) {
      const Quad height = dot(n, p);
      high_b = larger(high_b, height);
      low_b = smaller(low_b, height);
    }
    keep({n, low_b - high_a});
    keep({-n, low_a - high_b});
  }

  void keep(const Axis& axis) {
    if (found && axis.separation <= best.separation) return;
    best = axis;
    found = true;
  }

  std::vector<Rounded> a_;
  std::vector<Rounded> b_;
  double reach_ = 0;
};

BestAxis widest_axis(const Features& a, const Features& b) {
  BestAxis search(a, b);
  for (const Vec& n : a.normals) search.offer(n, a, b);
  for (const Vec& n : b.normals) search.offer(n, a, b);
  for (const Vec& along_a : a.directions) {
    for (const Vec& along_b : b.directions) search.offer(cross(along_a, along_b), a, b);
  }
  return search;
}

// Keeps the closest pair, and skips features that a plane across the best pair holds further apart.
class NearestPair {
 public:
  NearestPair(const Features& a, const Features& b) : best_(pair_of(a.points.front(), b.points.front())) {
    for (const Vec& p : a.points) {
      for (const Vec& q : b.points) improve(pair_of(p, q));
    }
    project(a, b);
  }

  void offer(const ClosestPair& pair, const Features& a, const Features& b) {
    if (improve(pair)) project(a, b);
  }

  template <typename IndicesA, typename IndicesB>
  [[nodiscard]] bool is_too_far(const IndicesA& of_a, const IndicesB& of_b) const {
    Quad high = heights_a_[of_a[0]];
    for (const std::size_t i : of_a) high = larger(high, heights_a_[i]);
    Quad low = heights_b_[of_b[0]];
    for (const std::size_t i : of_b) low = smaller(low, heights_b_[i]);
    const Quad gap = low - high;
    return gap > 0 && gap * gap > best_.squared * length_squared_;
  }

  [[nodiscard]] const ClosestPair& best() const { return best_; }

 private:
  bool improve(const ClosestPair& pair) {
    if (!(pair.squared < best_.squared)) return false;
    best_ = pair;
    return true;
  }

  void project(const Features& a, const Features& b) {
    const Vec across = best_.b - best_.a;
    length_squared_ = dot(across, across);
    heights_a_.clear();
    heights_b_.clear();
    for (const Vec& p : a.points) heights_a_.push_back(dot(across, p - best_.a));
    for (const Vec& p : b.points) heights_b_.push_back(dot(across, p - best_.a));
  }

  ClosestPair best_;
  Quad length_squared_ = 0;
  std::vector<Quad> heights_a_;
  std::vector<Quad> heights_b_;
};

using Edge = std::array<std::size_t, 2>;

std::vector<Edge> edges_or_point(const Features& shape) {
  return shape.edges.empty() ? std::vector<Edge>{{0, 0}} : shape.edges;
}

ClosestPair nearest_pair(const Features& a, const Features& b) {
  NearestPair nearest(a, b);
  for (const Edge& e : edges_or_point(a)) {
    for (const Edge& f : edges_or_point(b)) {
      if (nearest.is_too_far(e, f)) continue;
      nearest.offer(closest_of_segments(a.points[e[0]], a.points[e[1]], b.points[f[0]], b.points[f[1]]), a, b);
    }
  }
  for (const auto& t : a.triangles) {
    for (std::size_t i = 0; i < b.points.size(); ++i) {
      if (nearest.is_too_far(t, std::array{i})) continue;
      const auto foot = foot_in_triangle(b.points[i], a.points[t[0]], a.points[t[1]], a.points[t[2]]);
      if (foot) nearest.offer(pair_of(*foot, b.points[i]), a, b);
    }
  }
  for (const auto& t : b.triangles) {
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      if (nearest.is_too_far(std::array{i}, t)) continue;
      const auto foot = foot_in_triangle(a.points[i], b.points[t[0]], b.points[t[1]], b.points[t[2]]);
      if (foot) nearest.offer(pair_of(a.points[i], *foot), a, b);
    }
  }
  return nearest.best();
}

// Cores that meet without a direction of their own: any direction at a right angle to a segment will do.
Vec any_normal(const Features& a, const Features& b) {
  if (!a.directions.empty()) return perpendicular(a.directions.front());
  if (!b.directions.empty()) return perpendicular(b.directions.front());
  return {0, 0, 1};
}

}  // namespace

CoreAnswer core_distance(const Features& a, const Features& b) {
  const BestAxis axis = widest_axis(a, b);
  const Quad reach = a.size + b.size + length(a.centre) + length(b.centre);
  const Quad touching = quad(1e-27) * reach;
  if (axis.found && axis.best.separation < -touching) {
    return {axis.best.separation, axis.best.direction, std::nullopt};
  }
  const ClosestPair pair = nearest_pair(a, b);
  const Quad distance = square_root(pair.squared);
  CoreAnswer answer{distance, {}, CoreWitness{pair.a, pair.b}};
  if (distance > touching) {
    answer.normal = (pair.b - pair.a) * (1 / distance);
  } else {
    answer.distance = 0;
    answer.normal = axis.found ? axis.best.direction : any_normal(a, b);
  }
  return answer;
}

}  // namespace oracle
