// SPDX-License-Identifier: Apache-2.0
#include "features.hpp"

#include <algorithm>
#include <set>

namespace oracle {

namespace {

// Orientation determinants of double inputs are good to about 1e-33 of size cubed; what is flatter than this counts
// as lying in the plane.
constexpr Quad flatness = quad(1e-30);

struct Side {
  bool above = false;
  bool below = false;
};

Side side_of(const Features& hull, const Vec& corner, const Vec& normal) {
  Side side;
  const Quad limit = flatness * hull.size * hull.size * hull.size;
  for (const Vec& p : hull.points) {
    const Quad height = dot(normal, p - corner);
    side.above = side.above || height > limit;
    side.below = side.below || height < -limit;
    if (side.above && side.below) break;
  }
  return side;
}

void add_direction(std::vector<Vec>& list, const Vec& direction) {
  if (!(dot(direction, direction) > 0)) return;
  const Vec candidate = unit(direction);
  const auto same = [&candidate](const Vec& other) {
    const Vec across = cross(candidate, other);
    return dot(across, across) < quad(1e-60);
  };
  if (std::none_of(list.begin(), list.end(), same)) list.push_back(candidate);
}

std::vector<Vec> without_repeats(const std::vector<Point>& points) {
  const std::set<Point> unique(points.begin(), points.end());
  std::vector<Vec> result;
  for (const Point& p : unique) result.push_back({quad(p[0]), quad(p[1]), quad(p[2])});
  return result;
}

void measure(Features& hull) {
  hull.centre = {};
  for (const Vec& p : hull.points) hull.centre = hull.centre + p;
  hull.centre = hull.centre * (quad(1) / static_cast<Quad>(static_cast<double>(hull.points.size())));
  hull.size = 0;
  for (const Vec& p : hull.points) hull.size = larger(hull.size, length(p - hull.centre));
}

// Edges of a supporting triple that no point of the same plane lies beyond: the rim of the face.
void add_rim(Features& hull, const std::array<std::size_t, 3>& triple, const Vec& normal,
             std::set<std::array<std::size_t, 2>>& edges) {
  const Quad plane_limit = flatness * hull.size * hull.size * hull.size;
  const Vec corner = hull.points[triple[0]];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t first = triple[i];
    const std::size_t second = triple[(i + 1) % 3];
    const Vec outward = cross(hull.points[second] - hull.points[first], normal);
    const Quad opposite = dot(outward, hull.points[triple[(i + 2) % 3]] - hull.points[first]);
    const Quad sign = opposite > 0 ? -1 : 1;
    const Quad limit = flatness * length(outward) * hull.size;
    bool beyond = false;
    for (const Vec& p : hull.points) {
      const bool in_plane = absolute(dot(normal, p - corner)) <= plane_limit;
      if (in_plane && dot(outward, p - hull.points[first]) * sign > limit) beyond = true;
    }
    if (!beyond) edges.insert({std::min(first, second), std::max(first, second)});
  }
}

void find_faces(Features& hull) {
  const std::size_t count = hull.points.size();
  std::set<std::array<std::size_t, 2>> edges;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        const Vec normal = cross(hull.points[j] - hull.points[i], hull.points[k] - hull.points[i]);
        if (!(dot(normal, normal) > 0)) continue;
        const Side side = side_of(hull, hull.points[i], normal);
        if (side.above && side.below) continue;
        hull.triangles.push_back({i, j, k});
        add_direction(hull.normals, normal);
        add_rim(hull, {i, j, k}, normal, edges);
      }
    }
  }
  hull.edges.assign(edges.begin(), edges.end());
}

// Points on one line have no triple: the longest pair is the edge.
void find_segment(Features& hull) {
  std::array<std::size_t, 2> longest{0, 0};
  Quad best = 0;
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    for (std::size_t j = i + 1; j < hull.points.size(); ++j) {
      const Quad distance = length(hull.points[j] - hull.points[i]);
      if (distance > best) {
        best = distance;
        longest = {i, j};
      }
    }
  }
  if (best > 0) hull.edges.push_back(longest);
}

}  // namespace

Features features_of(const std::vector<Point>& points) {
  Features hull;
  hull.points = without_repeats(points);
  measure(hull);
  find_faces(hull);
  if (hull.edges.empty()) find_segment(hull);
  for (const auto& edge : hull.edges) add_direction(hull.directions, hull.points[edge[1]] - hull.points[edge[0]]);
  return hull;
}

Features placed(const Features& local, const Pose& pose, const Vec& origin) {
  Features result = local;
  for (Vec& p : result.points) p = pose.rotate(p) + (pose.position - origin);
  for (Vec& n : result.normals) n = pose.rotate(n);
  for (Vec& d : result.directions) d = pose.rotate(d);
  result.centre = pose.rotate(local.centre) + (pose.position - origin);
  return result;
}

}  // namespace oracle
