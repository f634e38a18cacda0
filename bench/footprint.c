/* SPDX-License-Identifier: Apache-2.0 */
/* What a program of spheres and boxes costs with whichever libabut is loaded: resident bytes, time of a step. */
#include <abut/abut.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SIDE = 15, COUNT = SIDE * SIDE * SIDE, STEPS = 40 };

static void require(abut_status status) {
  if (status != ABUT_OK) {
    fprintf(stderr, "%s\n", abut_last_error_message());
    exit(1);
  }
}

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

static long resident_kilobytes(void) {
  char line[256];
  long kilobytes = 0;
  FILE* file = fopen("/proc/self/status", "r");
  while (file && fgets(line, sizeof line, file)) {
    if (strncmp(line, "VmRSS:", 6) == 0) kilobytes = atol(line + 6);
  }
  if (file) fclose(file);
  return kilobytes;
}

static abut_part_id parts[COUNT];
static abut_pose poses[COUNT];
static double times[STEPS];

static int compare(const void* a, const void* b) {
  const double difference = *(const double*)a - *(const double*)b;
  return difference < 0 ? -1 : difference > 0;
}

static void fill(abut_universe* universe) {
  abut_shape *ball = NULL, *box = NULL;
  int i;
  require(abut_sphere_create(0.52, &ball));
  require(abut_box_create(0.52, 0.52, 0.52, &box));
  for (i = 0; i < COUNT; i++) {
    abut_part_options part;
    abut_geometry_options geometry;
    abut_geometry_id id;
    abut_part_options_init(&part, sizeof part);
    abut_geometry_options_init(&geometry, sizeof geometry);
    part.pose.position.x = i % SIDE;
    part.pose.position.y = i / SIDE % SIDE;
    part.pose.position.z = i / SIDE / SIDE;
    poses[i] = part.pose;
    require(abut_part_create(universe, &part, &parts[i]));
    require(abut_geometry_create(universe, parts[i], i % 2 ? ball : box, &geometry, &id));
  }
  abut_shape_release(ball);
  abut_shape_release(box);
}

/* A build without the feature universe has pairs alone. */
static void ask_for_a_pair(void) {
  const abut_pose pose = {{0, 0, 0}, {1, 0, 0, 0}};
  abut_shape *ball = NULL, *box = NULL;
  abut_distance found;
  require(abut_sphere_create(0.52, &ball));
  require(abut_box_create(0.52, 0.52, 0.52, &box));
  require(abut_pair_distance(ball, &pose, box, &pose, NULL, &found));
  abut_shape_release(ball);
  abut_shape_release(box);
}

/* With an argument it only starts: a universe is made, and nothing else. */
int main(int count, char** words) {
  abut_universe* universe = NULL;
  int step, i;
  (void)words;
  if (!abut_has_feature("universe")) {
    ask_for_a_pair();
    if (count > 1) {
      return 0;
    }
    printf("{\"step_microseconds\": 0, \"resident_bytes\": %ld}\n", 1024 * resident_kilobytes());
    return 0;
  }
  require(abut_universe_create(NULL, &universe));
  if (count > 1) {
    abut_universe_destroy(universe);
    return 0;
  }
  fill(universe);
  for (step = 0; step < STEPS; step++) {
    const double start = seconds();
    for (i = 0; i < COUNT; i++) poses[i].position.z += (step % 2 ? -1 : 1) * 1e-3 * (i % 7);
    require(abut_parts_set_poses(universe, parts, poses, COUNT));
    require(abut_universe_step(universe, 0.01));
    times[step] = seconds() - start;
  }
  qsort(times, STEPS, sizeof times[0], compare);
  printf("{\"step_microseconds\": %.1f, \"resident_bytes\": %ld}\n", 1e6 * times[STEPS / 2],
         1024 * resident_kilobytes());
  abut_universe_destroy(universe);
  return 0;
}
