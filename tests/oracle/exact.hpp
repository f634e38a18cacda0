// SPDX-License-Identifier: Apache-2.0
// Signs of determinants and where triangles meet, without rounding: the coordinates of 113 bits are taken as they are.
//
// A determinant is first found in 113 bits. Where it might have either sign it is found again as a sum of doubles that
// has no error.
// Source: Shewchuk, Discrete & Computational Geometry 18(3):305 (1997).
#pragma once

#include <array>

#include "features.hpp"
#include "quad.hpp"

namespace oracle {

using Triple = std::array<Vec, 3>;

// Of the volume that three corners and a fourth point span: positive where the corners are counter-clockwise seen from
// the point.
[[nodiscard]] int side_of_plane(const Vec& a, const Vec& b, const Vec& c, const Vec& point);

[[nodiscard]] bool has_area(const Triple& triangle);

// Whether two closed sets share a point; touching counts. Each triangle has an area. The ends of a segment may
// coincide.
[[nodiscard]] bool meets(const Vec& from, const Vec& to, const Triple& triangle);
[[nodiscard]] bool meets(const Triple& one, const Triple& other);
// With the convex hull of some points, flat or not.
[[nodiscard]] bool meets(const Triple& triangle, const Features& hull);

}  // namespace oracle
