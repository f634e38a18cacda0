// SPDX-License-Identifier: Apache-2.0
#include "support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "nearest.hpp"

namespace oracle {

namespace {

double root(double value) { return std::sqrt(value); }
Quad root(Quad value) { return square_root(value); }

// One formula for both number types: float128 judges, double only proposes.
template <typename Real>
struct Direction {
  Real x, y, z;
};

template <typename Real>
Real magnitude(Real value) {
  return value < 0 ? -value : value;
}

template <typename Real>
Real across(const Direction<Real>& n) {
  return root(n.x * n.x + n.y * n.y);
}

template <typename Real>
Real height(const std::vector<Point>& points, const Direction<Real>& n) {
  Real best = 0;
  bool first = true;
  for (const Point& p : points) {
    const Real there = n.x * static_cast<Real>(p[0]) + n.y * static_cast<Real>(p[1]) + n.z * static_cast<Real>(p[2]);
    if (first || there > best) best = there;
    first = false;
  }
  return best;
}

// The points that may lie furthest along n: all that double cannot tell from the furthest. What it makes of a height is
// off by less than four roundings of the sum of the three magnitudes.
std::vector<Point> leading(const std::vector<Point>& points, const Direction<Quad>& n) {
  const Point rough{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
  std::vector<double> heights;
  double best = -HUGE_VAL;
  double largest = 0;
  for (const Point& p : points) {
    const Point parts{rough[0] * p[0], rough[1] * p[1], rough[2] * p[2]};
    heights.push_back(parts[0] + parts[1] + parts[2]);
    best = std::max(best, heights.back());
    largest = std::max(largest, std::abs(parts[0]) + std::abs(parts[1]) + std::abs(parts[2]));
  }
  std::vector<Point> result;
  const double limit = best - 16 * std::numeric_limits<double>::epsilon() * largest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (heights[i] >= limit) result.push_back(points[i]);
  }
  return result;
}

double height(const Rounded& shape, const Direction<double>& n) {
  const double radius = shape.body.radius;
  const double best = height(shape.body.core, n);
  return radius > 0 ? best + radius * root(n.x * n.x + n.y * n.y + n.z * n.z) : best;
}

Quad height(const Rounded& shape, const Direction<Quad>& n) {
  const Quad radius = quad(shape.body.radius);
  const Quad best = height(leading(shape.body.core, n), n);
  return radius > 0 ? best + radius * root(n.x * n.x + n.y * n.y + n.z * n.z) : best;
}

template <typename Real>
Real height(const Box& box, const Direction<Real>& n) {
  return static_cast<Real>(box.half[0]) * magnitude(n.x) + static_cast<Real>(box.half[1]) * magnitude(n.y) +
         static_cast<Real>(box.half[2]) * magnitude(n.z);
}

template <typename Real>
Real height(const Cylinder& cylinder, const Direction<Real>& n) {
  return static_cast<Real>(cylinder.half_height) * magnitude(n.z) + static_cast<Real>(cylinder.radius) * across(n);
}

template <typename Real>
Real height(const Cone& cone, const Direction<Real>& n) {
  const Real apex = static_cast<Real>(cone.half_height) * n.z;
  const Real rim = static_cast<Real>(cone.radius) * across(n) - apex;
  return apex > rim ? apex : rim;
}

template <typename Real>
Real height(const Ellipsoid& ellipsoid, const Direction<Real>& n) {
  const Real x = static_cast<Real>(ellipsoid.radii[0]) * n.x;
  const Real y = static_cast<Real>(ellipsoid.radii[1]) * n.y;
  const Real z = static_cast<Real>(ellipsoid.radii[2]) * n.z;
  return root(x * x + y * y + z * z);
}

template <typename Real>
Real height_of(const Solid& solid, const Direction<Real>& n) {
  return std::visit([&n](const auto& form) { return height(form, n); }, solid.form);
}

}  // namespace

Quad support(const Solid& solid, const Vec& n) { return height_of(solid, Direction<Quad>{n.x, n.y, n.z}); }
double support(const Solid& solid, const Point& n) { return height_of(solid, Direction<double>{n[0], n[1], n[2]}); }

Quad overlap_along(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b, const Vec& n) {
  return support(a, pose_a.rotate_back(n)) + support(b, pose_b.rotate_back(-n)) +
         dot(n, pose_a.position - pose_b.position);
}

namespace {

// Points whose heights differ by less than this part of the size are equally high.
constexpr Quad rounding = quad(1e-31);

Quad sign_beyond(Quad value, Quad slack) {
  if (value > slack) return 1;
  return value < -slack ? -1 : 0;
}

// The unit vector along the part of n across Z; zero where that is within the slack.
Vec radial(const Vec& n, Quad slack) {
  const Vec flat{n.x, n.y, 0};
  return length(flat) > slack ? unit(flat) : Vec{};
}

Vec furthest(const Rounded& shape, const Vec& n, Quad slack) {
  const Direction<Quad> direction{n.x, n.y, n.z};
  const std::vector<Point> front = leading(shape.body.core, direction);
  const Quad limit = height(front, direction) - (slack + rounding) * quad(size_of(shape.body));
  Vec sum;
  Quad count = 0;
  for (const Point& p : slack > 0 ? shape.body.core : front) {
    const Vec v{quad(p[0]), quad(p[1]), quad(p[2])};
    if (dot(v, n) < limit) continue;
    sum = sum + v;
    count += 1;
  }
  return sum * (1 / count) + n * quad(shape.body.radius);
}

Vec furthest(const Box& box, const Vec& n, Quad slack) {
  return {quad(box.half[0]) * sign_beyond(n.x, slack), quad(box.half[1]) * sign_beyond(n.y, slack),
          quad(box.half[2]) * sign_beyond(n.z, slack)};
}

Vec furthest(const Cylinder& cylinder, const Vec& n, Quad slack) {
  return radial(n, slack) * quad(cylinder.radius) + Vec{0, 0, quad(cylinder.half_height) * sign_beyond(n.z, slack)};
}

Vec furthest(const Cone& cone, const Vec& n, Quad slack) {
  const Quad half = quad(cone.half_height);
  const Vec apex{0, 0, half};
  const Vec rim = radial(n, slack) * quad(cone.radius) - apex;
  const Quad lead = dot(n, apex) - dot(n, rim);
  const Quad limit = slack * (quad(cone.radius) + half);
  if (absolute(lead) <= limit) return (apex + rim) * quad(0.5);
  return lead > 0 ? apex : rim;
}

Vec furthest(const Ellipsoid& ellipsoid, const Vec& n, Quad) {
  const Quad top = height(ellipsoid, Direction<Quad>{n.x, n.y, n.z});
  if (!(top > 0)) return {};
  const std::array<Quad, 3> radii{quad(ellipsoid.radii[0]), quad(ellipsoid.radii[1]), quad(ellipsoid.radii[2])};
  return Vec{radii[0] * radii[0] * n.x, radii[1] * radii[1] * n.y, radii[2] * radii[2] * n.z} * (1 / top);
}

}  // namespace

Vec support_point(const Solid& solid, const Vec& n, Quad slack) {
  return std::visit([&](const auto& form) { return furthest(form, unit(n), slack); }, solid.form);
}

namespace {

Quad beyond(Quad value, Quad limit) { return larger(0, absolute(value) - limit); }

Quad distance_to(const Rounded& shape, const Vec& point) {
  Pose there;
  there.position = point;
  if (shape.measured.pieces.empty()) {
    Solid solid;
    solid.form = shape;
    solid.size = size_of(shape.body);
    return larger(0, nearest(solid, Pose{}, solid_of(make_sphere(0)), there).upper);
  }
  return larger(0, signed_distance(shape.measured, Pose{}, measured(make_sphere(0)), there).distance);
}

Quad distance_to(const Box& box, const Vec& point) {
  return length(
      {beyond(point.x, quad(box.half[0])), beyond(point.y, quad(box.half[1])), beyond(point.z, quad(box.half[2]))});
}

Quad distance_to(const Cylinder& cylinder, const Vec& point) {
  const Quad away = larger(0, length({point.x, point.y, 0}) - quad(cylinder.radius));
  return length({away, 0, beyond(point.z, quad(cylinder.half_height))});
}

// From a point of the plane to a segment of it.
Quad distance_to_side(const Vec& point, const Vec& from, const Vec& to) {
  const Vec along = to - from;
  const Quad squared = dot(along, along);
  const Quad place = squared > 0 ? clamped(dot(point - from, along) / squared, 0, 1) : 0;
  return length(point - from - along * place);
}

// In the half plane of the axis and the point, a cone is a triangle; the side on the axis is inside.
Quad distance_to(const Cone& cone, const Vec& point) {
  const Quad radius = quad(cone.radius);
  const Quad half = quad(cone.half_height);
  const Vec flat{length({point.x, point.y, 0}), point.z, 0};
  const bool within = absolute(flat.y) <= half && flat.x <= radius && 2 * half * flat.x <= radius * (half - flat.y);
  if (within) return 0;
  const Vec rim{radius, -half, 0};
  return smaller(distance_to_side(flat, {0, -half, 0}, rim), distance_to_side(flat, rim, {0, half, 0}));
}

// The nearest point of the ellipsoid is r^2 p / (t + r^2) by component, with the t >= 0 that puts it on the surface:
// sum (r p / (t + r^2))^2 == 1. The sum falls and is convex in t, so Newton from a lower bound never oversteps the
// root; rounding ends it. A component of radius zero takes no part: its nearest coordinate is zero.
Quad distance_to(const Ellipsoid& ellipsoid, const Vec& point) {
  const std::array<Quad, 3> p{point.x, point.y, point.z};
  const std::array<Quad, 3> r{quad(ellipsoid.radii[0]), quad(ellipsoid.radii[1]), quad(ellipsoid.radii[2])};
  Quad outside = 0;
  Quad t = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (r[i] > 0) {
      outside += p[i] / r[i] * (p[i] / r[i]);
      t = larger(t, r[i] * absolute(p[i]) - r[i] * r[i]);
    }
  }
  for (int step = 0; outside > 1 && step < 400; ++step) {
    Quad excess = -1;
    Quad slope = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(r[i] > 0)) continue;
      const Quad share = r[i] * p[i] / (t + r[i] * r[i]);
      excess += share * share;
      slope += 2 * share * share / (t + r[i] * r[i]);
    }
    const Quad next = t + excess / slope;
    if (!(next > t)) break;
    t = next;
  }
  std::array<Quad, 3> away = p;
  for (std::size_t i = 0; i < 3; ++i) {
    if (r[i] > 0) away[i] = outside > 1 ? p[i] * t / (t + r[i] * r[i]) : 0;
  }
  return length({away[0], away[1], away[2]});
}

}  // namespace

Quad distance_to_solid(const Solid& solid, const Vec& point) {
  return std::visit([&point](const auto& form) { return distance_to(form, point); }, solid.form);
}

}  // namespace oracle
