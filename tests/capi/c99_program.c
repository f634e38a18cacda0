/* SPDX-License-Identifier: Apache-2.0 */
/* A program of C99 on libabut.so: shapes, a pair query, a universe. */
#include <abut/abut.h>

#include <stdio.h>

#define CHECK(condition)                                                             \
  do {                                                                               \
    if (!(condition)) {                                                              \
      printf("line %d: %s (%s)\n", __LINE__, #condition, abut_last_error_message()); \
      return 1;                                                                      \
    }                                                                                \
  } while (0)

static int is_near(double a, double b) { return a - b < 1e-12 && b - a < 1e-12; }

static int ask_a_pair(abut_shape* ball, abut_shape* box) {
  const abut_pose here = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  const abut_pose there = {{3.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  abut_distance distance;
  abut_contact contacts[4];
  size_t count = 7;
  CHECK(abut_pair_distance(ball, &here, box, &there, NULL, &distance) == ABUT_OK);
  CHECK(is_near(distance.distance, 1.0));
  CHECK(is_near(distance.normal.x, 1.0));
  CHECK(abut_pair_contacts(ball, &here, box, &there, NULL, contacts, 4, &count) == ABUT_OK);
  CHECK(count == 0);
  return 0;
}

static int step_a_universe(abut_shape* ball, abut_shape* box) {
  abut_universe* universe = NULL;
  abut_part_options options;
  abut_part_id part;
  abut_geometry_id geometry;
  const abut_contact* contacts = NULL;
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

static uint32_t leave_out(void* context, const abut_universe* universe, abut_geometry_id a, abut_geometry_id b) {
  uint32_t* asked = (uint32_t*)context;
  abut_revision revision;
  ++*asked;
  return abut_universe_revision(universe, &revision) != ABUT_OK || a.slot == b.slot;
}

static int filter_and_listen(abut_shape* ball) {
  abut_universe* universe = NULL;
  abut_universe_options options;
  abut_part_id part;
  abut_geometry_id first, second;
  abut_policy policy;
  const abut_event* events = NULL;
  size_t count = 0;
  uint32_t asked = 0;
  abut_universe_options_init(&options, sizeof options);
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_CONTACTS;
  CHECK(abut_universe_create(&options, &universe) == ABUT_OK);
  CHECK(abut_part_create(universe, NULL, &part) == ABUT_OK);
  CHECK(abut_geometry_create(universe, part, ball, NULL, &first) == ABUT_OK);
  CHECK(abut_part_create(universe, NULL, &part) == ABUT_OK);
  CHECK(abut_geometry_create(universe, part, ball, NULL, &second) == ABUT_OK);
  abut_policy_init(&policy, sizeof policy);
  policy.detail = ABUT_DETAIL_POINT;
  CHECK(abut_policy_set(universe, 0, 0, &policy) == ABUT_OK);
  CHECK(abut_universe_set_filter(universe, leave_out, &asked) == ABUT_OK);
  CHECK(abut_universe_step(universe, 0.01) == ABUT_OK);
  CHECK(abut_universe_events(universe, &events, &count) == ABUT_OK);
  CHECK(asked == 1 && count == 0);
  CHECK(abut_universe_set_filter(universe, NULL, NULL) == ABUT_OK);
  CHECK(abut_universe_step(universe, 0.01) == ABUT_OK);
  CHECK(abut_universe_events(universe, &events, &count) == ABUT_OK);
  CHECK(count == 2);
  CHECK(events[0].kind == ABUT_EVENT_BEGIN && events[0].flags == 0);
  CHECK(events[1].kind == ABUT_EVENT_BEGIN && events[1].flags == ABUT_EVENT_CONTACT);
  CHECK(abut_geometry_park(universe, second, ABUT_PARKING_LONG_TERM) == ABUT_OK);
  CHECK(abut_universe_detect_changed(universe) == ABUT_OK);
  CHECK(abut_universe_events(universe, &events, &count) == ABUT_OK);
  CHECK(count == 2 && events[0].kind == ABUT_EVENT_END);
  abut_universe_destroy(universe);
  return 0;
}

int main(void) {
  abut_shape* ball = NULL;
  abut_shape* box = NULL;
  int failed;
  CHECK(abut_check_version(ABUT_VERSION_MAJOR, ABUT_VERSION_MINOR) == ABUT_OK);
  CHECK(abut_sphere_create(1.0, &ball) == ABUT_OK);
  CHECK(abut_box_create(1.0, 1.0, 1.0, &box) == ABUT_OK);
  failed = ask_a_pair(ball, box) + step_a_universe(ball, box) + filter_and_listen(ball);
  abut_shape_release(ball);
  abut_shape_release(box);
  return failed;
}
