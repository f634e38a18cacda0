// SPDX-License-Identifier: Apache-2.0
// Whether two shapes overlap, or are within a margin: against distances of brute force and of a search of their own, in
// 113 bits.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "catalogue.hpp"
#include "distance_checks.hpp"
#include "oracle/nearest.hpp"
#include "shortfall.hpp"
#include "solid_scenes.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return {}; }

namespace {

using property::broken;
using property::Case;
using property::SolidSubject;
using property::Subject;

// 1, 0, or nothing where the library gave no answer, after it was reported.
std::optional<std::uint32_t> ask(const Case& c, double margin) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.margin = margin;
  const abut_shape *a = c.a.shape.get(), *b = c.b.shape.get();
  std::uint32_t there = 2, back = 2;
  const abut_status first = abut_pair_overlaps(a, &c.placement.a, b, &c.placement.b, &options, &there);
  const abut_status second = abut_pair_overlaps(b, &c.placement.b, a, &c.placement.a, &options, &back);
  if (first != ABUT_OK || second != ABUT_OK) {
    broken(c, "status", first != ABUT_OK ? first : second, ABUT_OK, 0);
    return std::nullopt;
  }
  if (there != back) broken(c, "overlap swapped", back, there, 0);
  return there;
}

// The signed distance is known to lie between two numbers.
void check(const Case& c, double margin, double lower, double upper, double tolerance) {
  const std::optional<std::uint32_t> answer = ask(c, margin);
  if (!answer) return;
  if (upper < margin - tolerance && *answer != 1) broken(c, "overlaps", *answer, 1, upper - margin);
  if (lower > margin + tolerance && *answer != 0) broken(c, "overlaps not", *answer, 0, lower - margin);
}

// `has_depth`: what the oracle says of an overlap is its depth, and not that of one triangle.
void check_known(const Subject& a, const Subject& b, const property::Placement& placement, bool has_depth) {
  const Case c = make_case(a, b, placement);
  const double distance = static_cast<double>(c.truth.distance), tolerance = distance_tolerance(c.magnitude);
  check(c, 0, distance, distance, tolerance);
  for (const double share : {0.5, 0.99, 1.01, 2.0}) {
    const double margin = share * distance;
    if (margin >= 0 || has_depth) check(c, margin, distance, distance, tolerance);
  }
  if (distance < 0) check(c, -distance, distance, distance, tolerance);
}

TEST(Overlap, OfPolytopesAndRoundOnesIsThatOfTheirDistance) {
  const auto subjects = property::convex_subjects();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    for (std::size_t j = i; j < subjects.size(); ++j) {
      property::Random random(61000 + 100 * i + j);
      for (const auto& placement : placements(subjects[i], subjects[j], random)) {
        check_known(subjects[i], subjects[j], placement, true);
      }
    }
  }
}

TEST(Overlap, WithPlanesIsThatOfTheirDistance) {
  for (const Subject& plane : property::plane_subjects()) {
    for (const Subject& other : property::convex_subjects()) {
      property::Random random(62000);
      for (const auto& placement : placements(plane, other, random)) check_known(plane, other, placement, true);
    }
  }
}

TEST(Overlap, OfSurfacesIsThatOfAnyTriangle) {
  const auto surfaces = property::surface_subjects();
  const auto others = property::convex_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (others[j].size >= 100) continue;
      property::Random random(63000 + 100 * i + j);
      for (const auto& placement : placements(surfaces[i], others[j], random)) {
        check_known(surfaces[i], others[j], placement, false);
      }
    }
  }
}

TEST(Overlap, OfTwoSurfacesIsThatOfAnyTwoTriangles) {
  const auto surfaces = property::surface_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = i; j < surfaces.size(); ++j) {
      if (surfaces[j].kind != "mesh" && surfaces[i].kind != "mesh") continue;
      property::Random random(64000 + 100 * i + j);
      for (const auto& placement : placements(surfaces[i], surfaces[j], random)) {
        check_known(surfaces[i], surfaces[j], placement, false);
      }
    }
  }
}

// What the oracle cannot tell apart overlaps or touches in its cores.
void check_solids(const SolidSubject& a, const SolidSubject& b, const property::Placement& placement) {
  const Case c{a.subject, b.subject, placement, {}, magnitude_of(a.subject, b.subject, placement.a, placement.b)};
  const oracle::Nearest truth =
      nearest(a.solid, property::pose_of(placement.a), b.solid, property::pose_of(placement.b));
  const bool is_curved = a.is_curved || b.is_curved;
  const double size = a.subject.size + b.subject.size;
  const double tolerance = distance_tolerance(c.magnitude) + (is_curved ? 1e-9 * size : 0);
  if (!truth.is_known) {
    check(c, 2 * tolerance, 0, 0, tolerance);
    return;
  }
  const double lower = static_cast<double>(truth.lower), upper = static_cast<double>(truth.upper);
  check(c, 0, lower, upper, tolerance);
  for (const double share : {0.5, 0.99, 1.01, 2.0}) check(c, share * upper, lower, upper, tolerance);
}

TEST(Overlap, OfCurvedSolidsIsThatOfTheirDistance) {
  constexpr std::array<const char*, 10> kinds{"cylinder", "cone",   "ellipsoid", "point",   "segment",
                                              "triangle", "sphere", "box",       "capsule", "hull"};
  constexpr std::size_t curved_kinds = 3;
  for (std::size_t i = 0; i < curved_kinds; ++i) {
    for (std::size_t j = i; j < kinds.size(); ++j) {
      const std::vector<SolidSubject> first = property::solid_subjects(kinds.at(i));
      const std::vector<SolidSubject> second = property::solid_subjects(kinds.at(j));
      property::Random random(65000 + 10 * i + j);
      for (const SolidSubject& a : first) {
        for (const SolidSubject& b : second) {
          for (const auto& placement : property::solid_placements(a, b, random)) check_solids(a, b, placement);
        }
      }
    }
  }
}

}  // namespace
