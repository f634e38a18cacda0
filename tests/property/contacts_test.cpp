// SPDX-License-Identifier: Apache-2.0
// Contact points of pairs: what must hold for any of them, over seeded placements.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "catalogue.hpp"
#include "distance_checks.hpp"
#include "manifold.hpp"
#include "record.hpp"
#include "shortfalls.hpp"

std::span<const property::Shortfall> property::known_shortfalls() { return contact_shortfalls; }

namespace {

using property::broken;
using property::Case;
using property::Manifold;
using property::Subject;

double length(const abut_vec3& v) { return std::hypot(v.x, v.y, v.z); }

double apart(const abut_vec3& u, const abut_vec3& v) { return std::hypot(u.x - v.x, u.y - v.y, u.z - v.z); }

double along(const abut_contact& c) {
  return (c.point_b.x - c.point_a.x) * c.normal.x + (c.point_b.y - c.point_a.y) * c.normal.y +
         (c.point_b.z - c.point_a.z) * c.normal.z;
}

// How far the points of a contact are apart across its normal.
double sideways(const abut_contact& c) {
  const double distance = along(c);
  return std::hypot(c.point_b.x - c.point_a.x - distance * c.normal.x,
                    c.point_b.y - c.point_a.y - distance * c.normal.y,
                    c.point_b.z - c.point_a.z - distance * c.normal.z);
}

bool is_surface(const Subject& subject) { return subject.kind == "mesh" || subject.kind == "height_field"; }

bool is_rounded(const Subject& subject) { return subject.kind == "sphere" || subject.kind == "capsule"; }

void expect(const Case& c, const std::string& fact, bool holds, double got, double expected, double tolerance) {
  if (!holds) broken(c, fact, got, expected, tolerance);
}

double off_surface(const Subject& shape, const abut_pose& pose, const abut_vec3& point) {
  return static_cast<double>(
      oracle::distance_to_point(shape.measured, property::pose_of(pose), property::vec_of(point)));
}

// Points of a rounded shape beside the deepest may lie under its surface where the shape curves away, never above.
void check_on_surface(const Case& c, const Subject& shape, const abut_pose& pose, const abut_vec3& point,
                      bool is_deepest, const std::string& side) {
  const double tolerance = distance_tolerance(c.magnitude) + point_rounding(c.magnitude);
  const double off = off_surface(shape, pose, point);
  const bool must_reach = !is_rounded(shape) || is_deepest;
  expect(c, "contact point above the surface of " + side, off <= tolerance, off, 0, tolerance);
  expect(c, "contact point below the surface of " + side, off >= -tolerance || !must_reach, off, 0, tolerance);
}

// How far b has to move along a direction to be parted from all triangles that it meets or would enter on the way;
// without end where that leads through the front of a height field.
oracle::Quad depth_along(const Case& c, const std::vector<oracle::Answer>& answers, const oracle::Vec& direction) {
  const oracle::Pose pose_a = property::pose_of(c.placement.a);
  const oracle::Pose pose_b = property::pose_of(c.placement.b);
  const oracle::Quad tolerance = oracle::quad(distance_tolerance(c.magnitude));
  oracle::Quad depth = 0;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].distance > depth + tolerance) continue;
      const oracle::Features& piece = c.a.measured.pieces[i];
      const oracle::Measured triangle{{piece}, c.a.measured.radius, std::nullopt, c.a.measured.size};
      const oracle::Quad own = -oracle::separation_along(triangle, pose_a, c.b.measured, pose_b, direction);
      if (c.a.kind == "height_field" && own > tolerance) {
        const oracle::Vec& normal = piece.normals.front();
        if (oracle::dot(pose_a.rotate_back(direction), normal) * normal.z < -tolerance) return oracle::quad(1e300);
      }
      if (own <= depth + tolerance) continue;
      depth = own;
      has_grown = true;
    }
  }
  return depth;
}

// The least of that along the least ways out of the single triangles: no contact of a surface is deeper.
double depth_of_all(const Case& c) {
  const oracle::Pose pose_a = property::pose_of(c.placement.a);
  const oracle::Pose pose_b = property::pose_of(c.placement.b);
  std::vector<oracle::Answer> answers;
  for (const oracle::Features& piece : c.a.measured.pieces) {
    const oracle::Measured triangle{{piece}, c.a.measured.radius, std::nullopt, c.a.measured.size};
    answers.push_back(oracle::signed_distance(triangle, pose_a, c.b.measured, pose_b));
  }
  oracle::Quad least = oracle::quad(1e300);
  for (const oracle::Answer& answer : answers) {
    if (answer.distance <= 0) least = oracle::smaller(least, depth_along(c, answers, answer.normal));
  }
  return static_cast<double>(least);
}

void check_each(const Case& c, const Manifold& manifold, double margin) {
  const double tolerance = distance_tolerance(c.magnitude);
  const double truth = static_cast<double>(c.truth.distance);
  const double deepest = is_surface(c.a) && truth < 0 ? -depth_of_all(c) : truth;
  std::set<std::uint64_t> ids;
  double previous = -1e300;
  for (const abut_contact& contact : manifold.contacts) {
    const bool is_deepest = &contact == &manifold.contacts.front();
    const double unit = length(contact.normal);
    expect(c, "unit normal", std::abs(unit - 1) <= property::unit_tolerance, unit, 1, property::unit_tolerance);
    const double rounding = point_rounding(c.magnitude);
    expect(c, "contact points and normal give the distance", std::abs(along(contact) - contact.distance) <= rounding,
           along(contact), contact.distance, rounding);
    expect(c, "deepest contact first", contact.distance >= previous, contact.distance, previous, 0);
    expect(c, "contact within the margin", contact.distance <= margin + tolerance, contact.distance, margin, tolerance);
    // What leans by a thousandth is longer by half a millionth.
    const double leaning = is_surface(c.a) ? 1e-6 * std::abs(deepest) : 0;
    expect(c, "no contact deeper than the shapes", contact.distance >= deepest - tolerance - leaning, contact.distance,
           deepest, tolerance + leaning);
    expect(c, "contact ids differ", ids.insert(contact.id).second, static_cast<double>(contact.id), 0, 0);
    const double aside = sideways(contact);
    expect(c, "contact points lie across each other", aside <= tolerance + rounding, aside, 0, tolerance + rounding);
    check_on_surface(c, c.a, c.placement.a, contact.point_a, is_deepest, "a");
    check_on_surface(c, c.b, c.placement.b, contact.point_b, is_deepest, "b");
    previous = contact.distance;
  }
}

bool are_opposite(const abut_vec3& u, const abut_vec3& v) {
  return std::hypot(u.x + v.x, u.y + v.y, u.z + v.z) < 1e-12;
}

// How far the nearest mirror image of a contact is off.
double nearest_mirror(const abut_contact& contact, const Manifold& back) {
  const abut_contact mirror = property::swapped(contact);
  double nearest = 1e300;
  for (const abut_contact& other : back.contacts) {
    const double off = std::max({apart(mirror.point_a, other.point_a), apart(mirror.point_b, other.point_b),
                                 std::abs(mirror.distance - other.distance)});
    nearest = std::min(nearest, off);
  }
  return nearest;
}

// Every contact of one order has its mirror image in the other, but for those that are at the margin within rounding.
// Where the least way out is not unique, each order may have chosen its own.
void check_mirrored(const Case& c, const Manifold& there, const Manifold& back, double margin) {
  if (there.contacts.empty() || back.contacts.empty()) return;
  if (!are_opposite(there.contacts.front().normal, back.contacts.front().normal)) return;
  const double tolerance = distance_tolerance(c.magnitude) + point_rounding(c.magnitude);
  for (const abut_contact& contact : there.contacts) {
    if (contact.distance > margin - tolerance) continue;
    const double off = nearest_mirror(contact, back);
    expect(c, "contact mirrored when swapped", off <= tolerance, off, 0, tolerance);
  }
}

void check_reduced(const Case& c, const Manifold& all, const Manifold& four) {
  if (is_surface(c.a)) return;
  const std::size_t expected = std::min<std::size_t>(4, all.contacts.size());
  expect(c, "reduced to four", four.contacts.size() <= 4, static_cast<double>(four.contacts.size()),
         static_cast<double>(expected), 0);
  if (all.contacts.empty()) return;
  const double tolerance = distance_tolerance(c.magnitude);
  if (four.contacts.empty()) return broken(c, "reduction leaves something", 0, 1, 0);
  expect(c, "reduction keeps the deepest",
         std::abs(four.contacts.front().distance - all.contacts.front().distance) <= tolerance,
         four.contacts.front().distance, all.contacts.front().distance, tolerance);
  if (all.contacts.size() > 10) return;
  const double best = property::largest_area(property::flattened(all.contacts), 4);
  const double kept = property::hull_area(property::flattened(four.contacts));
  expect(c, "reduction keeps nine tenths of the area", kept >= 0.9 * best - tolerance * c.magnitude.size_a, kept, best,
         0.1 * best);
}

// A triangle of a height field only stops what is in front of it. True when b is behind all that are nearest to it.
bool meets_the_back(const Case& c) {
  if (c.a.kind != "height_field") return false;
  const oracle::Pose field = property::pose_of(c.placement.a);
  for (const oracle::Features& piece : c.a.measured.pieces) {
    const oracle::Measured triangle{{piece}, 0, std::nullopt, c.a.measured.size};
    const oracle::Answer answer =
        oracle::signed_distance(triangle, field, c.b.measured, property::pose_of(c.placement.b));
    if (answer.distance > c.truth.distance + oracle::quad(distance_tolerance(c.magnitude))) continue;
    const oracle::Vec& normal = piece.normals.front();
    const oracle::Quad ahead = oracle::dot(field.rotate_back(answer.normal), normal) * normal.z;
    if (ahead > oracle::quad(property::unit_tolerance)) return false;
  }
  return true;
}

void check_contacts(const Case& c, double margin) {
  const auto& [scene, pose_a, pose_b] = c.placement;
  const Manifold all = contacts_of(c.a, pose_a, c.b, pose_b, margin, 0);
  const Manifold four = contacts_of(c.a, pose_a, c.b, pose_b, margin, 4);
  const Manifold back = contacts_of(c.b, pose_b, c.a, pose_a, margin, 0);
  if (all.status != ABUT_OK || four.status != ABUT_OK || back.status != ABUT_OK) {
    return broken(c, std::string("contact status ") + abut_status_name(all.status), all.status, ABUT_OK, 0);
  }
  const double truth = static_cast<double>(c.truth.distance);
  const double tolerance = distance_tolerance(c.magnitude);
  const double count = static_cast<double>(all.contacts.size());
  expect(c, "no contact beyond the margin", truth <= margin + tolerance || all.contacts.empty(), count, 0, 0);
  expect(c, "contact within the margin exists",
         truth >= margin - tolerance || !all.contacts.empty() || meets_the_back(c), count, 1, 0);
  check_each(c, all, margin);
  check_mirrored(c, all, back, margin);
  check_reduced(c, all, four);
  if (all.contacts.empty()) return;
  const double error = std::abs(all.contacts.front().distance - truth);
  property::record().add(row_of(c) + " contacts", c.a.name + " / " + c.b.name,
                         error / std::max(c.a.size + c.b.size + std::abs(truth), 1e-300), 0,
                         static_cast<std::uint32_t>(all.contacts.size()));
  // The least way out of a triangle may lead into its neighbour. So a contact may be deeper than each triangle by
  // itself, but no deeper than all (see above). None is less deep, unless it meets the back of a sheet.
  const double found = all.contacts.front().distance;
  if (is_surface(c.a) && truth < 0) {
    expect(c, "deepest contact is as deep as each triangle", found <= truth + tolerance || c.a.kind == "height_field",
           found, truth, tolerance);
    return;
  }
  expect(c, "deepest contact is as deep as the shapes", error <= tolerance, found, truth, tolerance);
}

void check_pairs(const std::vector<Subject>& firsts, const std::vector<Subject>& seconds, std::uint64_t seed) {
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    for (std::size_t j = &firsts == &seconds ? i : 0; j < seconds.size(); ++j) {
      property::Random random(seed + 1000 * i + j);
      std::size_t index = 0;
      for (const auto& placement : property::placements(firsts[i], seconds[j], random)) {
        const Case c = make_case(firsts[i], seconds[j], placement);
        const double margin = ++index % 3 == 0 ? 0.1 * std::min(firsts[i].small, seconds[j].small) : 0.0;
        check_contacts(c, margin);
      }
    }
  }
}

TEST(Contacts, OfConvexPairsAreConsistent) {
  const auto subjects = property::convex_subjects();
  check_pairs(subjects, subjects, 50000);
}

TEST(Contacts, WithPlanesAreConsistent) { check_pairs(property::plane_subjects(), property::convex_subjects(), 90000); }

// Only bodies of the size of the surface: how deep a body stands in a surface without inside is not defined.
TEST(Contacts, WithSurfacesAreConsistent) {
  const auto surfaces = property::surface_subjects();
  const auto others = property::convex_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (others[j].size > 100) continue;
      property::Random random(95000 + 100 * i + j);
      auto list = placements_above(surfaces[i], others[j], random);
      for (auto& placement : list) {
        const double gap = (random() % 3 == 0 ? 1e-2 : -1e-2) * others[j].small;
        placement.b = moved_to_gap(surfaces[i], placement.a, others[j], placement.b, gap);
        placement.scene = gap > 0 ? "above" : "sunk in";
        check_contacts(make_case(surfaces[i], others[j], placement), 0.02 * others[j].small);
      }
    }
  }
}

// Bodies deep in meshes of two sides, at their rims, edges and corners too: every contact is one of the mesh as a
// whole.
TEST(Contacts, DeepInMeshesAreNoDeeperThanTheMesh) {
  const auto surfaces = property::surface_subjects();
  const auto others = property::convex_subjects();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].kind != "mesh") continue;
    for (std::size_t j = 0; j < others.size(); ++j) {
      if (others[j].size > 100) continue;
      property::Random random(97000 + 100 * i + j);
      for (int round = 0; round < 12; ++round) {
        property::Placement placement{"deep", {{0, 0, 0}, {1, 0, 0, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}};
        const double reach = 1.3 * surfaces[i].size + others[j].size;
        placement.b.position = property::moved({0, 0, 0}, property::random_direction(random), reach);
        if (round % 2 == 0) placement.b.orientation = property::random_orientation(random);
        const double gap = -property::between(random, 0.02, 0.4) * others[j].small;
        placement.b = moved_to_gap(surfaces[i], placement.a, others[j], placement.b, gap);
        check_contacts(make_case(surfaces[i], others[j], placement), 0);
      }
    }
  }
}

}  // namespace
