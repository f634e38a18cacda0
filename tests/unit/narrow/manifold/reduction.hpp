// SPDX-License-Identifier: Apache-2.0
// Contacts of a flat patch, and areas of points in the plane, for tests of the reduction.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

import abut.capability;
import abut.math;

namespace test {

// A contact at a point of the plane across Z, from a below to b above.
inline abut::ContactPoint flat_contact(double x, double y, double distance, std::uint64_t id) {
  abut::ContactPoint contact{};
  contact.point_a = {x, y, -0.5 * distance};
  contact.point_b = {x, y, 0.5 * distance};
  contact.normal = {0, 0, 1};
  contact.distance = distance;
  contact.id = id;
  return contact;
}

// Area of the convex hull of points across Z: the chains of sorted points (Andrew 1979).
inline double hull_area(std::vector<abut::Vec3> points) {
  std::ranges::sort(points,
                    [](const abut::Vec3& p, const abut::Vec3& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  double twice = 0;
  for (int side = 0; side < 2; ++side) {
    std::vector<abut::Vec3> chain;
    for (const abut::Vec3& p : points) {
      const auto turns = [&] {
        const abut::Vec3 &o = chain[chain.size() - 2], &q = chain.back();
        return (q.x - o.x) * (p.y - o.y) - (q.y - o.y) * (p.x - o.x) > 0;
      };
      while (chain.size() > 1 && !turns()) {
        chain.pop_back();
      }
      chain.push_back(p);
    }
    for (std::size_t i = 1; i < chain.size(); ++i) {
      twice += chain[i - 1].x * chain[i].y - chain[i].x * chain[i - 1].y;
    }
    std::ranges::reverse(points);
  }
  return twice / 2;
}

inline double hull_area(std::span<const abut::ContactPoint> contacts) {
  std::vector<abut::Vec3> points;
  for (const abut::ContactPoint& contact : contacts) {
    points.push_back(contact.point_a);
  }
  return hull_area(points);
}

}  // namespace test
