/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Runs one fixed scene with every broad phase and several numbers of threads and prints the hash of all contacts and
 * events. It is the same number on every instruction set. The motion takes
 * integers and divisions by powers of two only, so that the poses themselves are the same bits.
 * usage: scene [expected hash]
 */
#include <abut/abut.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { side = 4, body_count = side * side * side, step_count = 40, shape_count = 9 };

static void require(abut_status status, const char* what) {
  if (status != ABUT_OK) {
    fprintf(stderr, "%s: %s (%s)\n", what, abut_status_name(status), abut_last_error_message());
    exit(2);
  }
}

static uint64_t mixed(uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

/* A number from -1 to 1 with 20 binary digits. */
static double number(uint64_t seed) { return (double)(int64_t)(mixed(seed) % 2097153u) / 1048576.0 - 1.0; }

static abut_shape* some_shape(uint32_t i) {
  static const double corners[] = {0.5, 0, 0,   -0.5, 0.125, 0,    0,     0.5,   0,    0.0625, -0.5,  0,
                                   0,   0, 0.5, 0,    0.25,  -0.5, 0.375, 0.375, 0.25, -0.375, -0.25, 0.375};
  static const double tent[] = {-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0, 0, 0, 0.375};
  static const uint32_t faces[] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  static const double balls[] = {0, 0, 0, 0.25, 0.25, 0.25, -0.25, 0.25, -0.125, 0.125, -0.375, 0.25};
  const double cone[] = {0.5, 0.5}, ellipsoid[] = {0.5, 0.375, 0.625};
  abut_shape_desc desc;
  abut_shape* shape = NULL;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.parameter_count = i == 4 ? 2 : 3;
  desc.parameters = i == 4 ? cone : ellipsoid;
  desc.kind = abut_shape_kind_by_name(i == 4 ? "cone" : "ellipsoid");
  switch (i) {
    case 0: require(abut_sphere_create(0.5, &shape), "sphere"); break;
    case 1: require(abut_box_create(0.5, 0.375, 0.4375, &shape), "box"); break;
    case 2: require(abut_capsule_create(0.375, 0.25, &shape), "capsule"); break;
    case 3: require(abut_cylinder_create(0.4375, 0.5, &shape), "cylinder"); break;
    case 4:
    case 5: require(abut_shape_create(&desc, &shape), "cone or ellipsoid"); break;
    case 6:
      /* A build without Qhull has no hulls; its hash is another one. */
      if (abut_has_feature("hull") == 0) return some_shape(1);
      require(abut_hull_create(corners, sizeof corners / sizeof corners[0] / 3, &shape), "hull");
      break;
    case 7: require(abut_mesh_create(tent, 5, faces, 4, NULL, &shape), "mesh"); break;
    default: require(abut_particles_create(balls, 4, 0.25, &shape), "particles"); break;
  }
  return shape;
}

static abut_pose pose_at(uint32_t body, uint32_t step) {
  abut_pose pose;
  const uint64_t seed = (uint64_t)body * 1000u;
  const double part = (double)step / 64.0;
  pose.position.x = 0.875 * (double)(body % side) + 0.125 * (number(seed) + part * number(seed + 1));
  pose.position.y = 0.875 * (double)(body / side % side) + 0.125 * (number(seed + 2) + part * number(seed + 3));
  pose.position.z = 0.875 * (double)(body / (side * side)) + 0.125 * (number(seed + 4) + part * number(seed + 5));
  /* Pythagorean quadruples turn without rounding: 1 + 4 + 4 + 16 = 25 and so on. */
  pose.orientation.w = (step + body) % 3 == 0 ? 0.2 : 0.8;
  pose.orientation.x = 0.4;
  pose.orientation.y = body % 2 == 0 ? 0.4 : -0.4;
  pose.orientation.z = (step + body) % 3 == 0 ? 0.8 : 0.2;
  return pose;
}

/* Where the process allows oneTBB that many, a step runs on as many as were asked for. */
static void require_threads(const abut_universe* universe, uint32_t threads) {
#ifdef ABUT_TEST_THREADS
  char text[65536], line[32];
  size_t needed = 0;
  snprintf(line, sizeof line, "\nthreads: %" PRIu32 "\n", threads);
  require(abut_universe_explain(universe, text, sizeof text, &needed), "explain");
  if (strstr(text, line) == NULL) {
    fprintf(stderr, "%" PRIu32 " threads were asked for and not used\n", threads);
    exit(2);
  }
#else
  (void)universe;
  (void)threads;
#endif
}

static uint64_t run(abut_broadphase broadphase, uint32_t threads) {
  abut_shape* shapes[shape_count];
  abut_part_id parts[body_count];
  abut_geometry_id geometries[body_count];
  abut_universe* universe = NULL;
  abut_universe_options options;
  uint64_t all = 0;
  uint32_t i, step;
  abut_universe_options_init(&options, sizeof options);
  options.broadphase = broadphase;
  options.threads = abut_has_feature("threads") != 0 ? threads : 1;
  options.events = ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS;
  require(abut_universe_create(&options, &universe), "universe");
  for (i = 0; i < shape_count; ++i) shapes[i] = some_shape(i);
  for (i = 0; i < body_count; ++i) {
    abut_part_options part;
    abut_part_options_init(&part, sizeof part);
    part.pose = pose_at(i, 0);
    require(abut_part_create(universe, &part, &parts[i]), "part");
    require(abut_geometry_create(universe, parts[i], shapes[i % shape_count], NULL, &geometries[i]), "geometry");
  }
  for (step = 0; step < step_count; ++step) {
    uint64_t hash = 0;
    for (i = 0; i < body_count; ++i) {
      const abut_pose pose = pose_at(i, step);
      if ((i + step) % 4 != 0) require(abut_part_set_pose(universe, parts[i], &pose), "pose");
    }
    if (step % 8 == 3) require(abut_geometry_park(universe, geometries[step], ABUT_PARKING_SHORT_TERM), "park");
    if (step % 8 == 6) require(abut_geometry_park(universe, geometries[step - 3], ABUT_PARKING_NONE), "unpark");
    require(abut_universe_step(universe, 0.015625), "step");
    require(abut_universe_hash(universe, &hash), "hash");
    all = mixed(all ^ hash);
  }
  require_threads(universe, threads);
  abut_universe_destroy(universe);
  for (i = 0; i < shape_count; ++i) abut_shape_release(shapes[i]);
  return all;
}

int main(int count, char** arguments) {
  static const uint32_t threads[] = {1, 2, 5};
  const uint64_t first = run(ABUT_BROADPHASE_AUTO, 1);
  uint64_t expected = first;
  int failures = 0;
  uint32_t kind, i;
  if (count > 1) expected = strtoull(arguments[1], NULL, 16);
  for (kind = ABUT_BROADPHASE_AUTO; kind <= ABUT_BROADPHASE_HASH_GRID; ++kind) {
    for (i = 0; i < sizeof threads / sizeof threads[0]; ++i) {
      const uint64_t hash = run(kind, threads[i]);
      if (hash != expected) {
        fprintf(stderr, "broad phase %" PRIu32 ", %" PRIu32 " threads: %016" PRIx64 ", expected %016" PRIx64 "\n", kind,
                threads[i], hash, expected);
        ++failures;
      }
    }
  }
  printf("%016" PRIx64 "\n", first);
  return failures == 0 ? 0 : 1;
}
