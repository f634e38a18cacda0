/* SPDX-License-Identifier: Apache-2.0 */
/* What a library of spheres and boxes answers, with the feature universe at most, and how it refuses the rest. */
#include <abut/abut.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int is_so, const char* what) {
  if (!is_so) {
    printf("not so: %s; the last message is: %s\n", what, abut_last_error_message());
    failures++;
  }
}

/* Refused, in a sentence that names what is missing. */
static void expect_unsupported(abut_status status, const char* name) {
  expect(status == ABUT_UNSUPPORTED, name);
  expect(strstr(abut_last_error_message(), name) != NULL, name);
}

static void expect_answers(void) {
  const abut_pose origin = {{0, 0, 0}, {1, 0, 0, 0}}, above = {{0, 0, 1.75}, {1, 0, 0, 0}};
  abut_shape *ball = NULL, *box = NULL;
  abut_distance distance;
  abut_query_options options;
  expect(abut_sphere_create(1, &ball) == ABUT_OK && abut_box_create(1, 1, 1, &box) == ABUT_OK, "shapes");
  expect(abut_pair_distance(box, &origin, ball, &above, NULL, &distance) == ABUT_OK, "box and sphere");
  expect(distance.distance == -0.25, "a depth of 0.25");
  abut_query_options_init(&options, sizeof options);
  options.algorithm = ABUT_ALGORITHM_GJK_EPA;
  expect(abut_pair_distance(box, &origin, box, &above, &options, &distance) == ABUT_OK, "GJK and EPA");
  expect(distance.distance > -0.2500001 && distance.distance < -0.2499999, "a depth by EPA");
  options.algorithm = ABUT_ALGORITHM_LIBCCD_GJK;
  expect_unsupported(abut_pair_distance(box, &origin, box, &above, &options, &distance), "ABUT_ALGORITHM_LIBCCD_GJK");
  abut_shape_release(ball);
  abut_shape_release(box);
}

/* Without the feature. */
static void expect_no_universes(void) {
  abut_universe_options options;
  abut_universe* universe = NULL;
  abut_focus focus;
  const abut_part_id part = {0, 0};
  abut_universe_options_init(&options, sizeof options);
  abut_focus_init(&focus, sizeof focus);
  expect(options.struct_size == sizeof options && focus.struct_size == sizeof focus, "structs of their size");
  expect_unsupported(abut_universe_create(&options, &universe), "feature \"universe\"");
  expect(universe == NULL, "nothing is made");
  expect_unsupported(abut_part_destroy(universe, part), "feature \"universe\"");
  expect_unsupported(abut_universe_impacts(universe, NULL, NULL), "feature \"universe\"");
  abut_universe_destroy(universe);
}

static void expect_universes(void) {
  abut_universe_options options;
  abut_universe* universe = NULL;
  uint32_t threads;
  abut_universe_options_init(&options, sizeof options);
  for (threads = 0; threads < 2; threads++) {
    options.threads = threads;
    expect(abut_universe_create(&options, &universe) == ABUT_OK, "at most one thread");
    expect(abut_universe_step(universe, 0.01) == ABUT_OK, "a step");
    abut_universe_destroy(universe);
  }
  universe = NULL;
  options.threads = 4;
  expect_unsupported(abut_universe_create(&options, &universe), "options.threads is 4");
  expect_unsupported(abut_universe_create(&options, &universe), "feature \"threads\"");
  expect(universe == NULL, "nothing is made");
}

int main(void) {
  abut_shape* shape = NULL;
  expect(abut_has_feature("threads") == 0 && abut_has_feature("libccd") == 0, "no features");
  expect(abut_shape_kind_count() == 2, "two kinds");
  expect_unsupported(abut_capsule_create(1, 1, &shape), "capsule");
  expect(shape == NULL, "no shape is made");
  expect_answers();
  if (abut_has_feature("universe")) {
    expect_universes();
  } else {
    expect_no_universes();
  }
  expect_unsupported(abut_pair_time_of_impact(NULL, NULL, NULL, NULL, NULL, NULL, 1, NULL, NULL), "feature \"motion\"");
  expect_unsupported(abut_elements_create(NULL, NULL), "feature \"deforming\"");
  expect_unsupported(abut_distance_field_create(NULL, &shape), "distance_field");
  printf("lean: %d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
