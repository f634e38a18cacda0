/* A program of C99 on libabut.so: shapes, a pair query, a universe. */
#include <abut/abut.h>

#include <stdio.h>

#define CHECK(condition)                                                         \
  do {                                                                           \
    if (!(condition)) {                                                          \
      printf("line %d: %s (%s)\n", __LINE__, #condition, abut_last_error_message()); \
      return 1;                                                                  \
    }                                                                            \
  } while (0)

static int is_near(double a, double b) { return a - b < 1e-12 && b - a < 1e-12; }

static int ask_a_pair(abut_shape *ball, abut_shape *box) {
  const abut_pose here = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  const abut_pose there = {{3.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  abut_distance distance;
  abut_contact contacts[4];
  size_t count = 7;
  CHECK(abut_shapes_distance(ball, &here, box, &there, NULL, &distance) == ABUT_OK);
  CHECK(is_near(distance.distance, 1.0));
  CHECK(is_near(distance.normal.x, 1.0));
  CHECK(abut_shapes_contacts(ball, &here, box, &there, NULL, contacts, 4, &count) == ABUT_OK);
  CHECK(count == 0);
  return 0;
}

static int step_a_universe(abut_shape *ball, abut_shape *box) {
  abut_universe *universe = NULL;
  abut_part_options options;
  abut_part_id part;
  abut_geometry_id geometry;
  const abut_contact *contacts = NULL;
  size_t count = 0;
  CHECK(abut_universe_create(NULL, &universe) == ABUT_OK);
  CHECK(abut_part_create(universe, NULL, &part) == ABUT_OK);
  CHECK(abut_geometry_create(universe, part, ball, NULL, &geometry) == ABUT_OK);
  abut_part_options_init(&options, sizeof options);
  options.pose.position.x = 1.5;
  CHECK(abut_part_create(universe, &options, &part) == ABUT_OK);
  CHECK(abut_geometry_create(universe, part, box, NULL, &geometry) == ABUT_OK);
  CHECK(abut_universe_step(universe, 0.01) == ABUT_OK);
  CHECK(abut_universe_contacts(universe, &contacts, &count) == ABUT_OK);
  CHECK(count == 1);
  CHECK(is_near(contacts[0].distance, -0.5));
  CHECK(is_near(contacts[0].normal.x, 1.0));
  abut_universe_destroy(universe);
  return 0;
}

int main(void) {
  abut_shape *ball = NULL;
  abut_shape *box = NULL;
  int failed;
  CHECK(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR) == ABUT_OK);
  CHECK(abut_sphere_create(1.0, &ball) == ABUT_OK);
  CHECK(abut_box_create(1.0, 1.0, 1.0, &box) == ABUT_OK);
  failed = ask_a_pair(ball, box) + step_a_universe(ball, box);
  abut_shape_release(ball);
  abut_shape_release(box);
  return failed;
}
