// SPDX-License-Identifier: Apache-2.0
// What must hold for the signed distance of every pair in every placement.
#pragma once

#include <string>

#include "scenes.hpp"
#include "subject.hpp"
#include "tolerance.hpp"

namespace property {

// One placement of two shapes, with the oracle's answer.
struct Case {
  const Subject& a;
  const Subject& b;
  Placement placement;
  oracle::Answer truth;
  Magnitude magnitude;
  std::string row{};  // of the table; empty for one of the kinds and the scene
};

[[nodiscard]] Magnitude magnitude_of(const Subject& a, const Subject& b, const abut_pose& pose_a,
                                     const abut_pose& pose_b);

[[nodiscard]] Case make_case(const Subject& a, const Subject& b, const Placement& placement);

// "box/hull touching" where the case names no other row, and the same with the names of the shapes and their poses.
[[nodiscard]] std::string row_of(const Case& c);
[[nodiscard]] std::string text_of(const Case& c);

// Reports a broken fact once or twice per row of the table and counts the rest.
void broken(const Case& c, const std::string& fact, double got, double expected, double tolerance);

// Reports as broken what is off by more than the tolerance, or not a number.
void expect_near(const Case& c, const std::string& fact, double got, double expected, double tolerance);
void expect_at_most(const Case& c, const std::string& fact, double got, double limit, double tolerance);

// Everything: value against the oracle, bounds, normal, points, swap, rigid motion, scaling, parting.
void check_distance(const Case& c);

// What holds without knowing the true value: finite, unit normal, points agree with the distance.
// False when the query failed.
bool check_consistency(const Case& c, abut_distance& result);

}  // namespace property
