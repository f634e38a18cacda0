// SPDX-License-Identifier: Apache-2.0
// The names that fragments of C++ in the documents may use, and what runs a fragment.
#include <abut/picking.hpp>
#include <abut/response.hpp>

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
abut::PartId part;                // the part of the ball
abut::GeometryId geometry;        // the ball in the universe
std::vector<abut::PartId> parts;  // those of the box and of the ball
const std::vector<abut::Pose> poses{pose_a, pose_b};
const double dt = 0.01;

void set_up() {
  const abut::PartId ground = universe.create_part(abut::PartOptions().with_motion(ABUT_MOTION_STATIC));
  universe.create_geometry(ground, a);
  part = universe.create_part(abut::PartOptions().with_pose(pose_b));
  geometry = universe.create_geometry(part, b);
  parts = {ground, part};
  universe.step(dt);
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
