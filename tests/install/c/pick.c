/* SPDX-License-Identifier: Apache-2.0 */
/* A C program that knows abut_picking by pkg-config: a ray meets a unit ball from 3 away. */
#include <abut/picking.h>
#include <stdio.h>

int main(void) {
  abut_ray ray = {{-3, 0, 0}, {1, 0, 0}, 10};
  abut_universe* universe = NULL;
  abut_shape* ball = NULL;
  abut_picker* picker = NULL;
  abut_part_id part;
  abut_geometry_id geometry;
  abut_pick pick;
  if (abut_universe_create(NULL, &universe) != ABUT_OK || abut_sphere_create(1.0, &ball) != ABUT_OK ||
      abut_part_create(universe, NULL, &part) != ABUT_OK ||
      abut_geometry_create(universe, part, ball, NULL, &geometry) != ABUT_OK ||
      abut_picker_create(universe, &picker) != ABUT_OK || abut_picker_cast_ray(picker, &ray, NULL, &pick) != ABUT_OK) {
    fprintf(stderr, "%s\n", abut_last_error_message());
    return 1;
  }
  printf("distance %g\n", pick.distance);
  abut_picker_destroy(picker);
  abut_universe_destroy(universe);
  abut_shape_release(ball);
  return 0;
}
