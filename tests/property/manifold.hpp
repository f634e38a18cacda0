// SPDX-License-Identifier: Apache-2.0
// Contact points of a pair as a set: asking for them, and measuring their area.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "subject.hpp"

namespace property {

struct Manifold {
  abut_status status = ABUT_OK;
  std::vector<abut_contact> contacts;
};

// All contact points within `margin`, reduced to `max_contacts` (0: not reduced).
[[nodiscard]] Manifold contacts_of(const Subject& a, const abut_pose& pose_a, const Subject& b, const abut_pose& pose_b,
                                   double margin, std::uint32_t max_contacts);

// Points in the plane.
using Flat = std::array<double, 2>;

// Points of the contacts on a, in a plane across the normal of the first.
[[nodiscard]] std::vector<Flat> flattened(std::span<const abut_contact> contacts);

// Area of the convex hull of points in the plane.
[[nodiscard]] double hull_area(std::vector<Flat> points);

// Largest area of `count` of the points, of which the first is one.
[[nodiscard]] double largest_area(const std::vector<Flat>& points, std::size_t count);

// The part of a convex polygon (counter-clockwise) that lies in another one.
[[nodiscard]] std::vector<Flat> overlap(const std::vector<Flat>& polygon, const std::vector<Flat>& window);

// Swaps the two sides of a contact.
[[nodiscard]] abut_contact swapped(const abut_contact& contact);

}  // namespace property
