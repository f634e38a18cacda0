// SPDX-License-Identifier: Apache-2.0
// How far the polygon of the contacts of a pair moves from one step to the next.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

import abut.capability;
import abut.core;
import abut.math;

namespace test {

// A convex polygon of points in the plane, or a segment or point.
using Flat = std::array<double, 2>;

inline double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Without copies up to rounding, as triangles that share a corner make them: an edge between two has no direction.
inline std::vector<Flat> places_of(const std::vector<Flat>& points) {
  constexpr double rounding = 1e-13;
  std::vector<Flat> places;
  for (const Flat& p : points) {
    const auto is_copy = [&](const Flat& q) { return std::hypot(p[0] - q[0], p[1] - q[1]) <= rounding; };
    if (std::ranges::none_of(places, is_copy)) {
      places.push_back(p);
    }
  }
  return places;
}

inline std::vector<Flat> hull_of(const std::vector<Flat>& given) {
  std::vector<Flat> points = places_of(given);
  std::ranges::sort(points);
  if (points.size() < 3) {
    return points;
  }
  std::vector<Flat> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Flat& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

inline double distance_to(const Flat& p, const std::vector<Flat>& hull) {
  bool is_inside = hull.size() > 2;
  double least = 1e300;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Flat &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double u = b[0] - a[0], v = b[1] - a[1], square = u * u + v * v;
    const double t = square > 0 ? std::clamp(((p[0] - a[0]) * u + (p[1] - a[1]) * v) / square, 0.0, 1.0) : 0;
    least = std::fmin(least, std::hypot(p[0] - a[0] - t * u, p[1] - a[1] - t * v));
    is_inside = is_inside && turn(a, b, p) >= 0;
  }
  return is_inside ? 0 : least;
}

using Contacts = std::vector<abut::ContactPoint>;

inline bool have_one_normal(const Contacts& contacts) {
  return std::ranges::all_of(
      contacts, [&](const abut::ContactPoint& c) { return abut::dot(c.normal, contacts[0].normal) > 0.999; });
}

// The distance of Hausdorff of the convex hulls of two sets of contacts, seen along the normal.
inline double moved_by(const Contacts& before, const Contacts& after) {
  const auto [first, second] = abut::tangents_of(before[0].normal);
  const auto flat = [&](const Contacts& contacts) {
    std::vector<Flat> points;
    for (const abut::ContactPoint& contact : contacts) {
      const abut::Vec3 d = 0.5 * (contact.point_a + contact.point_b) - before[0].point_a;
      points.push_back({abut::dot(d, first), abut::dot(d, second)});
    }
    return points;
  };
  const std::vector<Flat> from = flat(before), to = flat(after), hull_from = hull_of(from), hull_to = hull_of(to);
  double largest = 0;
  for (const Flat& p : from) {
    largest = std::fmax(largest, distance_to(p, hull_to));
  }
  for (const Flat& p : to) {
    largest = std::fmax(largest, distance_to(p, hull_from));
  }
  return largest;
}

inline std::vector<std::uint64_t> ids_of(const Contacts& contacts) {
  std::vector<std::uint64_t> ids;
  for (const abut::ContactPoint& contact : contacts) {
    ids.push_back(contact.id);
  }
  return ids;
}

// The contacts of one step whose ids another step has too.
inline Contacts common_to(const Contacts& contacts, const Contacts& other) {
  Contacts common;
  for (const abut::ContactPoint& contact : contacts) {
    if (std::ranges::find(other, contact.id, &abut::ContactPoint::id) != other.end()) {
      common.push_back(contact);
    }
  }
  return common;
}

inline std::set<std::uint64_t> set_of(const std::vector<std::uint64_t>& ids) { return {ids.begin(), ids.end()}; }

}  // namespace test
