// SPDX-License-Identifier: Apache-2.0
// Distance and contacts of two shapes, and one step of a universe, without modules.
#include <abut/abut.hpp>

#include <cstdio>

int main() try {
  const abut::Shape ball = abut::Shape::sphere(1.0);
  const abut::Shape box = abut::Shape::box(1.0, 1.0, 1.0);
  const abut::Pose origin = abut::pose(), above = abut::pose({0.0, 0.0, 1.75});

  const abut::Distance distance = abut::pair_distance(box, origin, ball, above);
  std::printf("distance %g, normal (%g, %g, %g)\n", distance.distance, distance.normal.x, distance.normal.y,
              distance.normal.z);
  std::printf("two boxes touch in %zu points\n", abut::pair_contacts(box, origin, box, above).size());

  abut::Universe universe;
  const abut::PartId floor = universe.create_part();
  const abut::PartId body = universe.create_part(abut::PartOptions().with_pose(above));
  universe.create_geometry(floor, box);
  universe.create_geometry(body, ball);
  universe.step(0.01);
  for (const abut::Contact& contact : universe.contacts()) std::printf("contact %g deep\n", -contact.distance);
} catch (const abut::Error& error) {
  std::fprintf(stderr, "%s: %s\n", error.name(), error.what());
  return 1;
}
