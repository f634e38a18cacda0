/* SPDX-License-Identifier: Apache-2.0 */
/* The names that fragments of C in the documents may use, and what runs a fragment. A fragment whose calls fail fails.
 */
#define _POSIX_C_SOURCE 200112L /* posix_memalign */
#include <abut/abut.h>
#include <abut/picking.h>
#include <abut/response.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A universe of a static box, with a ball above it that overlaps it by a quarter. */
static abut_universe* universe;
static abut_shape *a, *b; /* the box and the ball */
static const abut_pose pose_a = {{0, 0, 0}, {1, 0, 0, 0}}, pose_b = {{0, 0, 1.75}, {1, 0, 0, 0}};
static abut_part_id part;         /* the part of the ball */
static abut_geometry_id geometry; /* the ball in the universe */
static abut_part_id parts[2];     /* those of the box and of the ball */
static const abut_pose poses[2] = {{{0, 0, 0}, {1, 0, 0, 0}}, {{0, 0, 1.75}, {1, 0, 0, 0}}};
static const size_t count = 2;
static const double dt = 0.01;

void fragment(void);

static int set_up(void) {
  abut_part_options options;
  abut_geometry_id box;
  abut_part_options_init(&options, sizeof options);
  options.motion = ABUT_MOTION_STATIC;
  if (abut_box_create(1, 1, 1, &a) != ABUT_OK || abut_sphere_create(1, &b) != ABUT_OK ||
      abut_universe_create(NULL, &universe) != ABUT_OK || abut_part_create(universe, &options, &parts[0]) != ABUT_OK ||
      abut_geometry_create(universe, parts[0], a, NULL, &box) != ABUT_OK) {
    return 1;
  }
  options.motion = ABUT_MOTION_DYNAMIC;
  options.pose = pose_b;
  if (abut_part_create(universe, &options, &part) != ABUT_OK ||
      abut_geometry_create(universe, part, b, NULL, &geometry) != ABUT_OK) {
    return 1;
  }
  parts[1] = part;
  return abut_universe_step(universe, dt) != ABUT_OK;
}

int main(void) {
  if (set_up() == 0) fragment();
  if (abut_last_error_message()[0] == '\0') return 0;
  fprintf(stderr, "%s\n", abut_last_error_message());
  return 1;
}
