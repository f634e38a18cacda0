/* SPDX-License-Identifier: Apache-2.0 */
/* A C program that knows abut by pkg-config: the distance of two unit balls 4 apart. */
#include <abut/abut.h>
#include <stdio.h>

int main(void) {
  abut_pose a = {{0, 0, 0}, {1, 0, 0, 0}};
  abut_pose b = {{4, 0, 0}, {1, 0, 0, 0}};
  abut_shape* ball = NULL;
  abut_distance distance;
  if (abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR) != ABUT_OK ||
      abut_sphere_create(1.0, &ball) != ABUT_OK || abut_pair_distance(ball, &a, ball, &b, NULL, &distance) != ABUT_OK) {
    fprintf(stderr, "%s\n", abut_last_error_message());
    return 1;
  }
  printf("distance %g\n", distance.distance);
  abut_shape_release(ball);
  return 0;
}
