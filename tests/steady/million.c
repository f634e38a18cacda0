/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Many geometries in little memory: makes universes of spheres and boxes that share two shapes, one part each. Steps
 * three times with 2 % of them moving. Compares what the process has held at most with a limit of 2 GiB for a million.
 * usage: abut_million [geometries, default 1000000 [broad phase, default 0 for auto [spacing, default 1.1]]]
 */
#define _POSIX_C_SOURCE 200809L
#include <abut/abut.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>

enum { batch = 4096, step_count = 3, share = 50 };

static void require(abut_status status, const char* what) {
  if (status != ABUT_OK) {
    fprintf(stderr, "%s: %s (%s)\n", what, abut_status_name(status), abut_last_error_message());
    exit(2);
  }
}

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The most that the process has held so far, in bytes. */
static double peak_bytes(void) {
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * (double)usage.ru_maxrss;
}

/* A place in a cube of cells, and up to a third of a cell beside it, another one in each step. */
static abut_pose pose_at(uint64_t body, uint64_t side, uint64_t step, double spacing) {
  const uint64_t cell[3] = {body % side, body / side % side, body / (side * side)};
  double place[3];
  int axis;
  abut_pose pose = {{0, 0, 0}, {1, 0, 0, 0}};
  for (axis = 0; axis < 3; ++axis) {
    const uint64_t mixed = (body * 3 + (uint64_t)axis + step * 7919u) * 0x9e3779b97f4a7c15u;
    place[axis] = spacing * ((double)cell[axis] + (double)(mixed >> 40) / (3.0 * (double)(1 << 24)));
  }
  pose.position.x = place[0];
  pose.position.y = place[1];
  pose.position.z = place[2];
  return pose;
}

int main(int count, char** arguments) {
  const uint64_t geometries = count > 1 ? strtoull(arguments[1], NULL, 10) : 1000000u;
  const double spacing = count > 3 ? strtod(arguments[3], NULL) : 1.1;
  const double limit = 2147483648.0 * (double)geometries / 1e6;
  static abut_part_options parts[batch];
  static abut_part_id ids[batch], moving_ids[batch];
  static abut_geometry_id made[batch];
  static abut_pose poses[batch];
  const abut_shape* shapes[batch];
  abut_part_id* moving = malloc((geometries / share + 1) * sizeof *moving);
  abut_shape *sphere = NULL, *box = NULL;
  abut_universe* universe = NULL;
  abut_universe_options options;
  abut_step_stats stats;
  uint64_t side = 1, first, i, step, moving_count = 0;
  double begin = seconds(), peak;
  abut_universe_options_init(&options, sizeof options);
  options.broadphase = count > 2 ? (abut_broadphase)strtoul(arguments[2], NULL, 10) : ABUT_BROADPHASE_AUTO;
  require(abut_universe_create(&options, &universe), "universe");
  require(abut_sphere_create(0.5, &sphere), "sphere");
  require(abut_box_create(0.5, 0.4, 0.45, &box), "box");
  if (moving == NULL) return 2;
  while (side * side * side < geometries) ++side;
  for (first = 0; first < geometries; first += batch) {
    const uint64_t size = geometries - first < batch ? geometries - first : batch;
    for (i = 0; i < size; ++i) {
      abut_part_options_init(&parts[i], sizeof parts[i]);
      parts[i].pose = pose_at(first + i, side, 0, spacing);
      shapes[i] = (first + i) % 2 == 0 ? sphere : box;
    }
    require(abut_parts_create(universe, parts, size, ids), "parts");
    require(abut_geometries_create(universe, ids, shapes, NULL, size, made), "geometries");
    for (i = 0; i < size; ++i) {
      if ((first + i) % share == 0) moving[moving_count++] = ids[i];
    }
  }
  printf("%" PRIu64 " geometries, broad phase %s: made in %.2f s\n", geometries, count > 2 ? arguments[2] : "0",
         seconds() - begin);
  abut_step_stats_init(&stats, sizeof stats);
  for (step = 0; step < step_count; ++step) {
    for (first = 0; step > 0 && first < moving_count; first += batch) {
      const uint64_t size = moving_count - first < batch ? moving_count - first : batch;
      for (i = 0; i < size; ++i) {
        moving_ids[i] = moving[first + i];
        poses[i] = pose_at((first + i) * share, side, step, spacing);
      }
      require(abut_parts_set_poses(universe, moving_ids, poses, size), "poses");
    }
    begin = seconds();
    require(abut_universe_step(universe, 0.01), "step");
    require(abut_universe_stats(universe, &stats), "stats");
    printf("step %" PRIu64 ": %.3f s, %" PRIu64 " moved, %" PRIu64 " candidate pairs, %" PRIu64 " examined, %" PRIu64
           " contacts; the universe holds %.1f MiB, the process %.1f MiB at most\n",
           step, seconds() - begin, stats.moved, stats.candidate_pairs, stats.examined_pairs, stats.contacts,
           (double)stats.bytes / 1048576.0, peak_bytes() / 1048576.0);
  }
  peak = peak_bytes();
  abut_universe_destroy(universe);
  abut_shape_release(sphere);
  abut_shape_release(box);
  free(moving);
  if (peak > limit || (double)stats.bytes > limit || stats.contacts == 0) {
    fprintf(stderr, "%.1f MiB are more than %.1f MiB, or nothing touches\n", peak / 1048576.0, limit / 1048576.0);
    return 1;
  }
  return 0;
}
