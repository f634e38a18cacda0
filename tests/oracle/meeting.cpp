// SPDX-License-Identifier: Apache-2.0
#include "meeting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "overlap.hpp"

namespace oracle {

namespace {

Part part_of(const Features& local, const Pose& pose, const Vec& origin) {
  Part part{placed(local, pose, origin), {}, {}, {}};
  part.low.fill(std::numeric_limits<double>::infinity());
  part.high.fill(-std::numeric_limits<double>::infinity());
  for (const Vec& p : part.hull.points) {
    const Point point = rounded(p);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double room = 1e-15 * std::abs(point[axis]);
      part.low[axis] = std::min(part.low[axis], point[axis] - room);
      part.high[axis] = std::max(part.high[axis], point[axis] + room);
    }
  }
  return part;
}

void measure(Side& side) {
  for (const Part& part : side.parts) {
    for (const Vec& p : part.hull.points) side.size = larger(side.size, length(p) + side.radius);
  }
}

Features moved(Features hull, const Vec& move) {
  for (Vec& p : hull.points) p = p + move;
  hull.centre = hull.centre + move;
  return hull;
}

// Each triangle with one side is left on the side of its front.
bool leads_to_fronts(const Side& a, const Part& of_a, const Side& b, const Part& of_b, const Vec& normal) {
  // A way across a triangle is not known to lead to either side.
  constexpr Quad least = quad(1e-9);
  return !(a.is_one_sided && !(dot(normal, of_a.normal) > least)) &&
         !(b.is_one_sided && !(dot(-normal, of_b.normal) > least));
}

}  // namespace

Side side_of(const Soup& soup, bool is_one_sided, const Pose& pose, const Vec& origin) {
  Side side{{}, 0, true, is_one_sided, 0};
  for (const auto& [i, j, k] : soup.triangles) {
    const Point &a = soup.points[i], &b = soup.points[j], &c = soup.points[k];
    Part part = part_of(features_of({a, b, c}), pose, origin);
    // In the frame of the soup there is no rounding before the product.
    part.normal = pose.rotate(unit(cross(exact(b) - exact(a), exact(c) - exact(a))));
    side.parts.push_back(part);
  }
  measure(side);
  return side;
}

Side side_of(const Body& body, const Pose& pose, const Vec& origin) {
  Side side{{part_of(features_of(body.core), pose, origin)}, quad(body.radius), false, false, 0};
  measure(side);
  return side;
}

double gap_of_boxes(const Part& a, const Part& b, const Point& move_of_b) {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double gap =
        std::max({b.low[axis] + move_of_b[axis] - a.high[axis], a.low[axis] - b.high[axis] - move_of_b[axis], 0.0});
    square += gap * gap;
  }
  return std::sqrt(square) * (1 - 1e-14);
}

Meeting meeting_of(const Side& a, const Side& b, double reach) {
  struct Candidate {
    double gap;
    std::size_t a, b;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    for (std::size_t j = 0; j < b.parts.size(); ++j) {
      candidates.push_back({gap_of_boxes(a.parts[i], b.parts[j], {}), i, j});
    }
  }
  std::ranges::sort(candidates, {}, &Candidate::gap);
  const Quad radii = a.radius + b.radius;
  Meeting meeting;
  bool is_first = true;
  for (const auto& [gap, i, j] : candidates) {
    if (!is_first && quad(gap) - radii > larger(meeting.distance, quad(reach))) break;
    const CoreAnswer core = core_distance(a.parts[i].hull, b.parts[j].hull);
    const Quad distance = core.distance - radii;
    if (is_first || distance < meeting.distance) {
      meeting.distance = distance;
      meeting.normal = core.normal;
      is_first = false;
    }
    if (distance <= quad(reach)) {
      meeting.met.push_back({i, j, distance, core.normal, leads_to_fronts(a, a.parts[i], b, b.parts[j], core.normal)});
    }
  }
  return meeting;
}

Quad least_depth(const Meeting& meeting) {
  Quad depth = 0;
  for (const PartsMet& met : meeting.met) {
    if (met.is_allowed) depth = larger(depth, -met.distance);
  }
  return depth;
}

Quad depth_of_points(const Side& a, const Side& b, const Inside& is_inside) {
  Quad depth = 0;
  const auto consider = [&](const Vec& point) {
    if (!is_inside(point)) return;
    Side alone{{part_of(features_of({{0, 0, 0}}), Pose{point, {1, 0, 0, 0}}, {})}, 0, false, false, 0};
    depth = larger(depth, meeting_of(a, alone).distance + b.radius);
  };
  for (const Part& part : b.parts) {
    consider(part.hull.centre);
    for (const Vec& corner : part.hull.points) consider(corner);
    for (const auto& [i, j] : part.hull.edges) consider((part.hull.points[i] + part.hull.points[j]) * quad(0.5));
  }
  return depth;
}

Quad distance_after(const Side& a, const Side& b, const Vec& move, Quad limit, bool counts_backs) {
  Quad least = limit;
  for (const Part& of_b : b.parts) {
    const Features there = moved(of_b.hull, move);
    for (const Part& of_a : a.parts) {
      if (quad(gap_of_boxes(of_a, of_b, rounded(move))) - a.radius - b.radius >= least) continue;
      const CoreAnswer core = core_distance(of_a.hull, there);
      if (!counts_backs && !leads_to_fronts(a, of_a, b, of_b, core.normal)) continue;
      least = smaller(least, core.distance - a.radius - b.radius);
    }
  }
  return least;
}

}  // namespace oracle
