// SPDX-License-Identifier: Apache-2.0
// Distance and contacts of two shapes, and one step of a universe.
#include <array>
#include <cstdio>
#include <span>

import abut;

int main() {
  const std::array<double, 1> radius{1.0};
  const std::array<double, 3> half_extents{1.0, 1.0, 1.0};
  const auto made_ball = abut::Sphere::make(radius, {}, {});
  const auto made_box = abut::Box::make(half_extents, {}, {});
  if (!made_ball || !made_box) return 1;  // what is wrong is in made_ball.error().message
  const abut::AnyShape ball = made_ball.value(), box = made_box.value();

  // Queries take the pose of b in the frame of a, and answer in that frame.
  const abut::Pose above{abut::Rotation::identity(), {0.0, 0.0, 1.75}};
  abut::Distance distance{};
  if (abut::pair_distance(box, ball, above, {}, distance) != abut::Outcome::ok) return 1;
  std::printf("distance %g, normal (%g, %g, %g)\n", distance.distance, distance.normal.x, distance.normal.y,
              distance.normal.z);

  abut::Manifold manifold;
  if (abut::pair_contacts(box, box, above, {}, manifold) != abut::Outcome::ok) return 1;
  std::printf("two boxes touch in %zu points\n", manifold.size());

  abut::Universe universe({}, 1);
  const std::array<abut::PartOptions, 2> options{{{}, {.placement = {.position = {0.0, 0.0, 1.75}}}}};
  const std::array<abut::ShapeHandle, 2> shapes{abut::ShapeHandle(box), abut::ShapeHandle(ball)};
  const auto parts = universe.create_parts(options);
  if (!parts || !universe.create_geometries(parts.value(), shapes, {}) || !universe.step(0.01)) return 1;
  for (const abut::Contact& contact : universe.contacts()) std::printf("contact %g deep\n", -contact.point.distance);
}
