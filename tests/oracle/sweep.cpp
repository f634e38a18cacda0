// SPDX-License-Identifier: Apache-2.0
#include "sweep.hpp"

#include <vector>

#include "search.hpp"
#include "support.hpp"

namespace oracle {

namespace {

// What the directions are made of, in the world.
struct Parts {
  std::vector<Vec> normals;
  std::vector<Vec> edges;
  std::vector<Circle> circles;
};

void add_parts(const Solid& solid, const Pose& pose, Parts& parts) {
  for (const Vec& normal : solid.normals) parts.normals.push_back(pose.rotate(normal));
  for (const Vec& edge : solid.edges) {
    parts.edges.push_back(pose.rotate(edge));
    parts.circles.push_back(circle_of(parts.edges.back(), 0));
  }
  for (const Crease& crease : solid.creases) {
    parts.circles.push_back(circle_of(pose.rotate(crease.axis), crease.height));
    parts.circles.push_back(circle_of(pose.rotate(-crease.axis), crease.height));
  }
}

void add_both_ways(const Vec& direction, std::vector<Point>& found) {
  if (!(dot(direction, direction) > quad(1e-60))) return;
  const Point n = rounded(unit(direction));
  found.push_back(n);
  found.push_back({-n[0], -n[1], -n[2]});
}

// Normals, cross products of edges, and the way between the centres, whole and across each edge.
void add_kinks(const Parts& parts, const Vec& between, std::vector<Point>& found) {
  for (const Vec& normal : parts.normals) add_both_ways(normal, found);
  add_both_ways(between, found);
  for (std::size_t i = 0; i < parts.edges.size(); ++i) {
    add_both_ways(between - parts.edges[i] * dot(between, parts.edges[i]), found);
    for (std::size_t j = 0; j < i; ++j) add_both_ways(cross(parts.edges[i], parts.edges[j]), found);
  }
}

}  // namespace

LeastOverlap least_overlap(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b, const Vec& hint) {
  const Pair pair(a, pose_a, b, pose_b);
  Parts parts;
  add_parts(a, pose_a, parts);
  add_parts(b, pose_b, parts);
  std::vector<Point> found{rounded(hint)};
  add_kinks(parts, exact(pair.from_b()), found);
  if (!a.is_straight || !b.is_straight) {
    add_circles(pair, parts.circles, found);
    add_sphere(pair, Chart{}, rounded(hint), found);
    add_sphere(pair, stretched(pair), rounded(hint), found);
  }
  std::vector<Proposal> list;
  for (const Point& n : found) list.push_back({pair.overlap(n), n});
  keep_best(list, 4);
  LeastOverlap least;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Vec n = unit(exact(list[i].place));
    const Quad overlap = overlap_along(a, pose_a, b, pose_b, n);
    if (i == 0 || overlap < least.overlap) least = {overlap, n};
  }
  return least;
}

}  // namespace oracle
