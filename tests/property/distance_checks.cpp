// SPDX-License-Identifier: Apache-2.0
#include "distance_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "record.hpp"

namespace property {

namespace {

double norm(const abut_vec3& v) { return std::hypot(v.x, v.y, v.z); }
double dot(const abut_vec3& u, const abut_vec3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
abut_vec3 minus(const abut_vec3& u, const abut_vec3& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }

bool is_finite(const abut_vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Magnitude magnitude_of(const Subject& a, const Subject& b, const abut_pose& pose_a, const abut_pose& pose_b) {
  return {a.size, b.size, norm(minus(pose_b.position, pose_a.position)),
          std::max(norm(pose_a.position), norm(pose_b.position))};
}

Case make_case(const Subject& a, const Subject& b, const Placement& placement) {
  return {a,
          b,
          placement,
          oracle::signed_distance(a.measured, pose_of(placement.a), b.measured, pose_of(placement.b)),
          magnitude_of(a, b, placement.a, placement.b),
          {}};
}

std::string row_of(const Case& c) {
  return c.row.empty() ? c.a.kind + "/" + c.b.kind + " " + c.placement.scene : c.row;
}

std::string text_of(const Case& c) {
  return c.a.name + " " + text_of(c.placement.a) + " against " + c.b.name + " " + text_of(c.placement.b) + " (" +
         c.placement.scene + ")";
}

void broken(const Case& c, const std::string& fact, double got, double expected, double tolerance) {
  const Magnitude& m = c.magnitude;
  const double size = std::abs(got - expected) / std::max(m.size_a + m.size_b + m.apart, 1e-300);
  if (record().fails_as_known(row_of(c) + " " + fact, size, known_shortfalls())) return;
  std::ostringstream text;
  text.precision(17);
  text << fact << ": got " << got << ", expected " << expected << ", off by " << got - expected << ", tolerance "
       << tolerance << ", " << size << " of the size";
  ADD_FAILURE() << text.str() << "\n  " << text_of(c);
}

void expect_near(const Case& c, const std::string& fact, double got, double expected, double tolerance) {
  if (!(std::abs(got - expected) <= tolerance)) broken(c, fact, got, expected, tolerance);
}

void expect_at_most(const Case& c, const std::string& fact, double got, double limit, double tolerance) {
  if (!(got <= limit + tolerance)) broken(c, fact, got, limit, tolerance);
}

namespace {

abut_status ask(const abut_shape* a, const abut_pose& pose_a, const abut_shape* b, const abut_pose& pose_b,
                abut_distance& out) {
  return abut_pair_distance(a, &pose_a, b, &pose_b, nullptr, &out);
}

}  // namespace

bool check_consistency(const Case& c, abut_distance& result) {
  const abut_status status = ask(c.a.shape.get(), c.placement.a, c.b.shape.get(), c.placement.b, result);
  if (status != ABUT_OK) {
    broken(c, std::string("status ") + abut_status_name(status), status, ABUT_OK, 0);
    return false;
  }
  if (!std::isfinite(result.distance) || !std::isfinite(result.lower) || !std::isfinite(result.upper) ||
      !is_finite(result.point_a) || !is_finite(result.point_b) || !is_finite(result.normal)) {
    broken(c, "finite", result.distance, 0, 0);
    return false;
  }
  expect_near(c, "unit normal", norm(result.normal), 1, unit_tolerance);
  expect_near(c, "points and normal give the distance", dot(minus(result.point_b, result.point_a), result.normal),
              result.distance, point_rounding(c.magnitude));
  expect_at_most(c, "lower <= distance", result.lower, result.distance, 0);
  expect_at_most(c, "distance <= upper", result.distance, result.upper, 0);
  return true;
}

namespace {

void check_value(const Case& c, const abut_distance& result) {
  const double truth = static_cast<double>(c.truth.distance);
  const double error = static_cast<double>(oracle::quad(result.distance) - c.truth.distance);
  const double scale = std::max(c.magnitude.size_a + c.magnitude.size_b + c.magnitude.apart + std::abs(truth), 1e-300);
  const double gap = (result.upper - result.lower) / scale;
  record().add(row_of(c), c.a.name + " / " + c.b.name, std::abs(error) / scale, gap, result.iterations);
  const double tolerance = distance_tolerance(c.magnitude);
  if (!(std::abs(error) <= tolerance)) broken(c, "distance", result.distance, truth, tolerance);
  expect_at_most(c, "lower <= truth", result.lower, truth, rounding(c.magnitude));
  expect_at_most(c, "truth <= upper", truth, result.upper, rounding(c.magnitude));
  expect_at_most(c, "upper - lower within the error bound", result.upper - result.lower, 0, tolerance);
}

// A plane across the normal parts the shapes by the distance: this proves the normal, also where it is not unique.
void check_normal(const Case& c, const abut_distance& result) {
  const oracle::Vec normal = oracle::unit(vec_of(result.normal));
  const oracle::Quad separation =
      oracle::separation_along(c.a.measured, pose_of(c.placement.a), c.b.measured, pose_of(c.placement.b), normal);
  const double loss = static_cast<double>(c.truth.distance - separation);
  expect_near(c, "separation along the normal falls short of the distance", loss, 0, distance_tolerance(c.magnitude));
}

void check_points(const Case& c, const abut_distance& result) {
  const double tolerance = distance_tolerance(c.magnitude) + point_rounding(c.magnitude);
  const auto off_a = oracle::distance_to_point(c.a.measured, pose_of(c.placement.a), vec_of(result.point_a));
  const auto off_b = oracle::distance_to_point(c.b.measured, pose_of(c.placement.b), vec_of(result.point_b));
  expect_near(c, "point_a is off the surface of a", static_cast<double>(off_a), 0, tolerance);
  expect_near(c, "point_b is off the surface of b", static_cast<double>(off_b), 0, tolerance);
}

// The points realise the distance: the way from one to the other is along the normal.
void check_across(const Case& c, const abut_distance& result) {
  const abut_vec3 way = minus(result.point_b, result.point_a);
  const abut_vec3& n = result.normal;
  const double distance = result.distance;
  const double aside = norm({way.x - distance * n.x, way.y - distance * n.y, way.z - distance * n.z});
  const double tolerance = distance_tolerance(c.magnitude) + point_rounding(c.magnitude);
  expect_near(c, "points lie across each other", aside, 0, tolerance);
}

void check_swapped(const Case& c, const abut_distance& result) {
  abut_distance other{};
  const abut_status status = ask(c.b.shape.get(), c.placement.b, c.a.shape.get(), c.placement.a, other);
  if (status != ABUT_OK) return broken(c, "status swapped", status, ABUT_OK, 0);
  expect_near(c, "distance swapped", other.distance, result.distance, distance_tolerance(c.magnitude));
}

void check_moved(const Case& c, const abut_distance& result) {
  const abut_pose motion{{3, -2, 1.5}, {0.5, -0.5, 0.7, 0.1}};
  const oracle::Pose exact = pose_of(motion);
  const auto part = [&exact](std::size_t i) { return static_cast<double>(exact.orientation.at(i)); };
  const abut_pose unit{motion.position, {part(0), part(1), part(2), part(3)}};
  const abut_pose pose_a = composed(unit, c.placement.a);
  const abut_pose pose_b = composed(unit, c.placement.b);
  const Magnitude there = magnitude_of(c.a, c.b, pose_a, pose_b);
  abut_distance other{};
  const abut_status status = ask(c.a.shape.get(), pose_a, c.b.shape.get(), pose_b, other);
  if (status != ABUT_OK) return broken(c, "status moved", status, ABUT_OK, 0);
  expect_near(c, "distance after moving both", other.distance, result.distance,
              distance_tolerance(there) + point_rounding(there));
}

abut_pose doubled(abut_pose pose) {
  pose.position = {2 * pose.position.x, 2 * pose.position.y, 2 * pose.position.z};
  return pose;
}

void check_doubled(const Case& c, const abut_distance& result) {
  abut_distance other{};
  const abut_status status =
      ask(c.a.doubled.get(), doubled(c.placement.a), c.b.doubled.get(), doubled(c.placement.b), other);
  if (status != ABUT_OK) return broken(c, "status at twice the size", status, ABUT_OK, 0);
  expect_near(c, "distance at twice the size", other.distance, 2 * result.distance,
              2 * distance_tolerance(c.magnitude));
}

// The route from support points alone, which every convex pair has beside a faster one.
void check_support_points(const Case& c) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = ABUT_ALGORITHM_GJK_EPA;
  abut_distance other{};
  const abut_status status =
      abut_pair_distance(c.a.shape.get(), &c.placement.a, c.b.shape.get(), &c.placement.b, &options, &other);
  if (status == ABUT_UNSUPPORTED) return;
  if (status != ABUT_OK) return broken(c, "status from support points", status, ABUT_OK, 0);
  const double truth = static_cast<double>(c.truth.distance);
  const double scale = std::max(c.magnitude.size_a + c.magnitude.size_b + c.magnitude.apart + std::abs(truth), 1e-300);
  record().add(row_of(c) + " from support points", c.a.name + " / " + c.b.name,
               std::abs(static_cast<double>(oracle::quad(other.distance) - c.truth.distance)) / scale,
               (other.upper - other.lower) / scale, other.iterations);
  expect_near(c, "distance from support points", other.distance, truth, distance_tolerance(c.magnitude));
}

// A batch of one pose gives the bits of the single call.
void check_batch(const Case& c, const abut_distance& result) {
  abut_distance other{};
  const abut_status status =
      abut_pairs_distance(c.a.shape.get(), &c.placement.a, c.b.shape.get(), &c.placement.b, 1, nullptr, &other);
  if (status != ABUT_OK) return broken(c, "status of a batch", status, ABUT_OK, 0);
  expect_near(c, "distance in a batch", other.distance, result.distance, 0);
}

// Moving b by the depth along the normal leaves the two touching.
void check_parting(const Case& c, const abut_distance& result) {
  if (result.distance >= 0) return;
  abut_pose parted = c.placement.b;
  parted.position = {parted.position.x - result.distance * result.normal.x,
                     parted.position.y - result.distance * result.normal.y,
                     parted.position.z - result.distance * result.normal.z};
  abut_distance other{};
  const abut_status status = ask(c.a.shape.get(), c.placement.a, c.b.shape.get(), parted, other);
  if (status != ABUT_OK) return broken(c, "status after parting", status, ABUT_OK, 0);
  const Magnitude there = magnitude_of(c.a, c.b, c.placement.a, parted);
  expect_near(c, "distance after parting", other.distance, 0, 2 * distance_tolerance(there) + point_rounding(there));
}

}  // namespace

void check_distance(const Case& c) {
  abut_distance result{};
  if (!check_consistency(c, result)) return;
  check_value(c, result);
  check_normal(c, result);
  check_points(c, result);
  check_across(c, result);
  check_swapped(c, result);
  check_moved(c, result);
  check_doubled(c, result);
  check_parting(c, result);
  check_batch(c, result);
  check_support_points(c);
}

}  // namespace property
