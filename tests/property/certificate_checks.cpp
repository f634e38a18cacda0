// SPDX-License-Identifier: Apache-2.0
#include "certificate_checks.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/support.hpp"
#include "oracle/sweep.hpp"
#include "record.hpp"

namespace property {

namespace {

using oracle::Pose;
using oracle::Quad;
using oracle::Vec;

struct SolidCase {
  const SolidSubject& a;
  const SolidSubject& b;
  Case base;
  Pose pose_a;
  Pose pose_b;
  double tolerance;         // of the distance
  double points_tolerance;  // of the points being in the shapes
  double way_tolerance;     // of the way between the points, which no search for the nearest ones blurs
};

SolidCase solid_case(const SolidSubject& a, const SolidSubject& b, const Placement& placement, const std::string& row) {
  const Magnitude magnitude = magnitude_of(a.subject, b.subject, placement.a, placement.b);
  const double bound = a.is_curved || b.is_curved ? curved_error_bound : error_bound;
  return {a,
          b,
          {a.subject, b.subject, placement, {}, magnitude, row},
          pose_of(placement.a),
          pose_of(placement.b),
          distance_tolerance(magnitude, bound),
          distance_tolerance(magnitude, bound) + point_rounding(magnitude),
          distance_tolerance(magnitude) + point_rounding(magnitude)};
}

Quad overlap_along(const SolidCase& c, const Vec& n) {
  return oracle::overlap_along(c.a.solid, c.pose_a, c.b.solid, c.pose_b, n);
}

Quad off(const SolidSubject& subject, const Pose& pose, const abut_vec3& point) {
  return oracle::distance_to_solid(subject.solid, pose.rotate_back(vec_of(point) - pose.position));
}

void check_points(const SolidCase& c, const abut_distance& result) {
  const double off_a = static_cast<double>(off(c.a, c.pose_a, result.point_a));
  const double off_b = static_cast<double>(off(c.b, c.pose_b, result.point_b));
  expect_at_most(c.base, "point_a lies in a", off_a, 0, c.points_tolerance);
  expect_at_most(c.base, "point_b lies in b", off_b, 0, c.points_tolerance);
}

double check_apart(const SolidCase& c, const abut_distance& result, const Vec& n) {
  const double separation = -static_cast<double>(overlap_along(c, n));
  const double between = static_cast<double>(oracle::length(vec_of(result.point_b) - vec_of(result.point_a)));
  const double distance = result.distance;
  const double rounded = rounding(c.base.magnitude);
  expect_near(c.base, "points are as far apart as the distance", between, distance, c.way_tolerance);
  expect_at_most(c.base, "distance <= separation along the normal", distance, separation, c.tolerance);
  expect_at_most(c.base, "lower <= separation along the normal", result.lower, separation, c.tolerance);
  expect_at_most(c.base, "separation along the normal <= upper", separation, result.upper, rounded);
  expect_at_most(c.base, "lower <= way between the points", result.lower, between, c.points_tolerance);
  return std::abs(distance - separation);
}

// The points lie in the shapes, and the way between them is the overlap along the normal. So they lie on the planes
// of support on either side.
double check_overlapping(const SolidCase& c, const abut_distance& result, const Vec& n) {
  const double depth = -result.distance;
  const double overlap = static_cast<double>(overlap_along(c, n));
  const oracle::LeastOverlap least = oracle::least_overlap(c.a.solid, c.pose_a, c.b.solid, c.pose_b, n);
  const double swept = static_cast<double>(least.overlap);
  expect_near(c.base, "depth is the overlap along the normal", depth, overlap, c.tolerance);
  expect_at_most(c.base, "depth <= overlap along any direction", depth, swept, c.tolerance);
  expect_at_most(c.base, "-upper <= overlap along any direction", -result.upper, swept, rounding(c.base.magnitude));
  return std::max(std::abs(depth - overlap), depth - swept);
}

bool is_same(const abut_vec3& u, const abut_vec3& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }
bool is_same(const abut_pose& p, const abut_pose& q) {
  return is_same(p.position, q.position) && p.orientation.w == q.orientation.w && p.orientation.x == q.orientation.x &&
         p.orientation.y == q.orientation.y && p.orientation.z == q.orientation.z;
}

// Bit by bit. A shape at the place of its twin cannot tell which of the two comes first.
void check_swapped(const SolidCase& c, const abut_distance& result) {
  const Placement& at = c.base.placement;
  abut_distance other{};
  const abut_status status =
      abut_pair_distance(c.b.subject.shape.get(), &at.b, c.a.subject.shape.get(), &at.a, nullptr, &other);
  if (status != ABUT_OK) return broken(c.base, "status swapped", status, ABUT_OK, 0);
  const abut_vec3 mirrored{-other.normal.x, -other.normal.y, -other.normal.z};
  const bool is_twin = &c.a == &c.b && is_same(at.a, at.b);
  expect_near(c.base, "distance swapped, bit by bit", other.distance, result.distance, 0);
  if (is_twin || is_same(mirrored, result.normal)) return;
  const double off_by = static_cast<double>(oracle::length(vec_of(mirrored) - vec_of(result.normal)));
  broken(c.base, "normal swapped, bit by bit", off_by, 0, 0);
}

}  // namespace

std::optional<Certified> certified(const SolidSubject& a, const SolidSubject& b, const Placement& placement,
                                   const std::string& row) {
  const SolidCase c = solid_case(a, b, placement, row);
  abut_distance result{};
  if (!check_consistency(c.base, result)) return std::nullopt;
  const Vec n = oracle::unit(vec_of(result.normal));
  check_points(c, result);
  const double error = result.distance > 0 ? check_apart(c, result, n) : check_overlapping(c, result, n);
  expect_at_most(c.base, "gap between the bounds", result.upper - result.lower, 0, c.tolerance);
  check_swapped(c, result);
  return Certified{result, error, c.base};
}

void check_certificate(const SolidSubject& a, const SolidSubject& b, const Placement& placement) {
  if (const auto answer = certified(a, b, placement, {})) keep(*answer);
}

void keep(const Certified& answer) {
  const Magnitude& m = answer.base.magnitude;
  const abut_distance& result = answer.result;
  const double scale = std::max(m.size_a + m.size_b + m.apart + std::abs(result.distance), 1e-300);
  record().add(row_of(answer.base), answer.base.a.name + " / " + answer.base.b.name, answer.error / scale,
               (result.upper - result.lower) / scale, result.iterations);
}

}  // namespace property
