// SPDX-License-Identifier: Apache-2.0
// What must hold for contacts of a surface with a convex shape or another surface, whoever found them.
//
// - There is one where two parts overlap, and none where all are apart by more than the margin.
// - The deepest is as deep as each two parts are, and none is deeper than the shortest move that ends the overlap.
//   meeting.hpp tells why both bounds hold. How deep a body is that meets a triangle with one
//   side from behind is not told by either, nor which way leads out. Apart, the nearest has the distance of the nearest
//   two parts.
// - Points lie on the surfaces of both shapes, across each other, and give the distance along the normal.
// - The normal is that of a face at the point, or the surface around the point lies behind the plane across it. In a
//   deep overlap all that would lead out may be beside it: then the move along the normal ends the overlap of the
//   whole. It leads to the front of a triangle with one side.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meeting.hpp"
#include "quad.hpp"
#include "way_out.hpp"

namespace oracle {

// Relative to the origin of the sides.
struct Touch {
  Vec point_a, point_b;
  Vec normal;  // from a to b
  double distance = 0;
};

struct Doubt {
  double distance = 0;  // of distances that depend on the relative pose alone
  double point = 0;     // of points in the world
  double sine = 1e-6;   // of normals
};

struct Fault {
  std::string fact;
  double off = 0;         // by how much it is missed
  bool is_angle = false;  // then that is a sine, else a length
};

// `meeting`: of all parts within the margin. `holds` tells of a solid that b may be inside of; how deep the deepest
// contact is there at most is left to the caller.
[[nodiscard]] std::vector<Fault> judge_surface_contacts(const Side& a, const Side& b, const Meeting& meeting,
                                                        std::span<const Touch> contacts, double margin,
                                                        const Doubt& doubt, const Holds& holds = {});

// The sine of the angle by which a normal is off: off all normals of faces that hold the point within `reach`, and
// below the steepest corner of their triangles. 2 where no triangle holds the point. Zero of a convex shape.
[[nodiscard]] Quad off_cone(const Side& side, const Vec& point, const Vec& normal, Quad reach);

}  // namespace oracle
