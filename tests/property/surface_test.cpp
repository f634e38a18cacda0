// SPDX-License-Identifier: Apache-2.0
// Meshes and height fields: the separated distance against all triangles, and the sign and consistency otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "catalogue.hpp"
#include "distance_checks.hpp"
#include "record.hpp"
#include "shortfall.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::broken;
using property::Case;
using property::Subject;

bool is_small(const Subject& subject) { return subject.size < 100; }

void check_point_of(const Case& c, const Subject& shape, const abut_pose& pose, const abut_vec3& point,
                    const std::string& fact) {
  const double tolerance = distance_tolerance(c.magnitude) + point_rounding(c.magnitude);
  const double off =
      static_cast<double>(oracle::distance_to_point(shape.measured, property::pose_of(pose), property::vec_of(point)));
  if (!(std::abs(off) <= tolerance)) broken(c, fact, off, 0, tolerance);
}

void check_apart(const Case& c) {
  abut_distance result{};
  if (!check_consistency(c, result)) return;
  const double truth = static_cast<double>(c.truth.distance);
  const double tolerance = distance_tolerance(c.magnitude);
  const double error = std::abs(result.distance - truth);
  property::record().add(row_of(c), c.a.name + " / " + c.b.name, error / (c.a.size + c.b.size + truth),
                         (result.upper - result.lower) / (c.a.size + c.b.size + truth), result.iterations);
  if (!(error <= tolerance)) broken(c, "distance", result.distance, truth, tolerance);
  if (!(result.lower <= truth + rounding(c.magnitude)))
    broken(c, "lower <= truth", result.lower, truth, rounding(c.magnitude));
  if (!(truth <= result.upper + rounding(c.magnitude)))
    broken(c, "truth <= upper", truth, result.upper, rounding(c.magnitude));
  check_point_of(c, c.a, c.placement.a, result.point_a, "point_a is off the surface of a");
  check_point_of(c, c.b, c.placement.b, result.point_b, "point_b is off the surface of b");
}

void check_sign(const Case& c) {
  abut_distance result{};
  if (!check_consistency(c, result)) return;
  const double tolerance = distance_tolerance(c.magnitude);
  if (!(result.distance <= tolerance)) broken(c, "overlap has no positive distance", result.distance, 0, tolerance);
}

void check_swap(const Case& c) {
  abut_distance there{};
  abut_distance back{};
  const abut_pose& pose_a = c.placement.a;
  const abut_pose& pose_b = c.placement.b;
  const abut_status first = abut_pair_distance(c.a.shape.get(), &pose_a, c.b.shape.get(), &pose_b, nullptr, &there);
  const abut_status second = abut_pair_distance(c.b.shape.get(), &pose_b, c.a.shape.get(), &pose_a, nullptr, &back);
  if (first != ABUT_OK || second != ABUT_OK) return broken(c, "status swapped", second, ABUT_OK, 0);
  const double tolerance = distance_tolerance(c.magnitude);
  if (!(std::abs(there.distance - back.distance) <= tolerance)) {
    broken(c, "distance swapped", back.distance, there.distance, tolerance);
  }
}

void check_placements(const Subject& surface, const Subject& other, const std::vector<property::Placement>& list) {
  for (const auto& placement : list) {
    const Case c = make_case(surface, other, placement);
    if (c.truth.distance > oracle::quad(distance_tolerance(c.magnitude))) {
      check_apart(c);
    } else {
      check_sign(c);
    }
    check_swap(c);
  }
}

TEST(SurfacePairs, HaveTheDistanceOfTheNearestTriangle) {
  const auto surfaces = property::surface_subjects();
  const auto others = property::convex_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (!is_small(others[j])) continue;
      property::Random random(7000 + 100 * i + j);
      check_placements(surfaces[i], others[j], placements_above(surfaces[i], others[j], random));
    }
  }
}

TEST(SurfacePairs, MeetOtherSurfacesTriangleByTriangle) {
  const auto surfaces = property::surface_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = 0; j < surfaces.size(); ++j) {
      if (surfaces[j].kind != "mesh") continue;
      property::Random random(9000 + 100 * i + j);
      auto list = placements_above(surfaces[i], surfaces[j], random);
      list.resize(6);
      check_placements(surfaces[i], surfaces[j], list);
    }
  }
}

// Meshes have two sides: touching and overlapping placements from anywhere around.
TEST(SurfacePairs, MeshesAreMetFromAllSides) {
  const auto surfaces = property::surface_subjects();
  const auto others = property::convex_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].kind != "mesh") continue;
    for (std::size_t j = 0; j < others.size(); j += 3) {
      if (!is_small(others[j])) continue;
      property::Random random(8000 + 100 * i + j);
      check_placements(surfaces[i], others[j], placements(surfaces[i], others[j], random));
    }
  }
}

}  // namespace
