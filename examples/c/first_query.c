/* SPDX-License-Identifier: Apache-2.0 */
/* Distance and contacts of two shapes, and one step of a universe. */
#include <abut/abut.h>
#include <stdio.h>

#define OK(call)                       \
  do {                                 \
    if ((call) != ABUT_OK) {           \
      puts(abut_last_error_message()); \
      return 1;                        \
    }                                  \
  } while (0)

int main(void) {
  const abut_pose origin = {{0, 0, 0}, {1, 0, 0, 0}}, above = {{0, 0, 1.75}, {1, 0, 0, 0}};
  abut_shape *ball, *box;
  OK(abut_sphere_create(1.0, &ball));
  OK(abut_box_create(1.0, 1.0, 1.0, &box));

  abut_distance distance;
  OK(abut_pair_distance(box, &origin, ball, &above, NULL, &distance));
  printf("distance %g, normal (%g, %g, %g)\n", distance.distance, distance.normal.x, distance.normal.y,
         distance.normal.z);

  abut_contact pair[4];
  size_t count;
  OK(abut_pair_contacts(box, &origin, box, &above, NULL, pair, 4, &count));
  printf("two boxes touch in %u points\n", (unsigned)count);

  abut_universe* universe;
  abut_part_options options;
  abut_part_id floor, body;
  abut_geometry_id geometry;
  OK(abut_universe_create(NULL, &universe));
  abut_part_options_init(&options, sizeof options);
  OK(abut_part_create(universe, &options, &floor));
  options.pose = above;
  OK(abut_part_create(universe, &options, &body));
  OK(abut_geometry_create(universe, floor, box, NULL, &geometry));
  OK(abut_geometry_create(universe, body, ball, NULL, &geometry));
  OK(abut_universe_step(universe, 0.01));
  const abut_contact* contacts;
  OK(abut_universe_contacts(universe, &contacts, &count));
  for (size_t i = 0; i < count; ++i) printf("contact %g deep\n", -contacts[i].distance);
  abut_universe_destroy(universe);
  abut_shape_release(ball);
  abut_shape_release(box);
}
