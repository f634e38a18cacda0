// SPDX-License-Identifier: Apache-2.0
// The names that fragments of C++ in the documents may use, and what runs a fragment.
#include <abut/picking.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

// A universe of a static box, with a ball above it that overlaps it by a quarter.
const abut::Pose pose_a = abut::pose(), pose_b = abut::pose({0, 0, 1.75});
const abut::Shape a = abut::Shape::box(1, 1, 1), b = abut::Shape::sphere(1);
abut::Universe universe;
abut::PartId part;          // the part of the ball
abut::GeometryId geometry;  // the ball in the universe

void set_up() {
  universe.create_geometry(universe.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC)), a);
  part = universe.create_part(abut::PartOptions().with_pose(pose_b));
  geometry = universe.create_geometry(part, b);
  universe.step(0.01);
}

}  // namespace

void fragment(void);

int main() try {
  set_up();
  fragment();
} catch (const abut::Error& error) {
  std::fprintf(stderr, "%s: %s\n", error.name(), error.what());
  return 1;
}
