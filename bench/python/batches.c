/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Reads pairs of poses of two boxes and asks a question about each of them, again and again: by single calls in a loop,
 * and by one call for all on one thread.
 * usage: batches distances|contacts|casts FILE COUNT REPEATS
 * The file holds COUNT poses of a and then COUNT poses of b. In casts, a moves to the origin.
 * Prints the least processor time in seconds of the loop, that of the call, and a sum over all answers.
 */
#define _POSIX_C_SOURCE 199309L
#include <abut/abut.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROOM = 16 }; /* contacts of two boxes */

static size_t count;
static abut_shape *a, *b;
static abut_pose *poses_a, *poses_b;
static abut_vec3 *ways, *still;
static abut_query_options options;
static abut_distance* distances;
static abut_contact* contacts;
static uint64_t* offsets;
static abut_cast_hit* hits;

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static abut_status loop_of_distances(void) {
  abut_status status = ABUT_OK;
  for (size_t i = 0; i < count && status == ABUT_OK; ++i) {
    status = abut_pair_distance(a, poses_a + i, b, poses_b + i, NULL, distances + i);
  }
  return status;
}
static abut_status batch_of_distances(void) {
  return abut_pairs_distance(a, poses_a, b, poses_b, count, &options, distances);
}
static double sum_of_distances(void) {
  double sum = 0;
  for (size_t i = 0; i < count; ++i) {
    sum += distances[i].distance;
  }
  return sum;
}

static abut_status loop_of_contacts(void) {
  abut_status status = ABUT_OK;
  size_t filled = 0;
  for (size_t i = 0; i < count && status == ABUT_OK; ++i) {
    size_t more = 0;
    status = abut_pair_contacts(a, poses_a + i, b, poses_b + i, NULL, contacts + filled, ROOM, &more);
    filled += more;
    offsets[i + 1] = filled;
  }
  return status;
}
static abut_status batch_of_contacts(void) {
  size_t filled = 0;
  return abut_pairs_contacts(a, poses_a, b, poses_b, count, &options, offsets, contacts, ROOM * count, &filled);
}
static double sum_of_contacts(void) {
  double sum = 0;
  for (uint64_t i = 0; i < offsets[count]; ++i) {
    sum += contacts[i].distance;
  }
  return sum;
}

static abut_status loop_of_casts(void) {
  abut_status status = ABUT_OK;
  for (size_t i = 0; i < count && status == ABUT_OK; ++i) {
    uint32_t found = 0;
    status = abut_pair_cast(a, poses_a + i, ways + i, b, poses_b + i, still + i, NULL, hits + i, &found);
    hits[i].fraction = found ? hits[i].fraction : HUGE_VAL;
  }
  return status;
}
static abut_status batch_of_casts(void) {
  return abut_pairs_cast(a, poses_a, ways, b, poses_b, still, count, &options, hits);
}
static double sum_of_casts(void) {
  double sum = 0;
  for (size_t i = 0; i < count; ++i) {
    sum += isinf(hits[i].fraction) ? 0 : hits[i].fraction;
  }
  return sum;
}

typedef struct question {
  const char* name;
  abut_status (*loop)(void), (*batch)(void);
  double (*sum)(void);
} question;
static const question questions[] = {{"distances", loop_of_distances, batch_of_distances, sum_of_distances},
                                     {"contacts", loop_of_contacts, batch_of_contacts, sum_of_contacts},
                                     {"casts", loop_of_casts, batch_of_casts, sum_of_casts}};

static double time_of(abut_status (*ask)(void)) {
  double start = seconds();
  if (ask() != ABUT_OK) {
    fprintf(stderr, "batches: %s\n", abut_last_error_message());
    exit(1);
  }
  return seconds() - start;
}

static int read_poses(const char* path) {
  FILE* file = fopen(path, "rb");
  int is_read = file && fread(poses_a, sizeof *poses_a, count, file) == count &&
                fread(poses_b, sizeof *poses_b, count, file) == count;
  if (file) {
    fclose(file);
  }
  return is_read;
}

int main(int argc, char** argv) {
  const question* asked = NULL;
  for (size_t i = 0; argc == 5 && i < sizeof questions / sizeof *questions; ++i) {
    asked = strcmp(questions[i].name, argv[1]) == 0 ? questions + i : asked;
  }
  if (!asked) {
    fprintf(stderr, "usage: batches distances|contacts|casts FILE COUNT REPEATS\n");
    return 2;
  }
  count = strtoul(argv[3], NULL, 10);
  size_t repeats = strtoul(argv[4], NULL, 10);
  poses_a = malloc(count * sizeof *poses_a), poses_b = malloc(count * sizeof *poses_b);
  ways = malloc(count * sizeof *ways), still = calloc(count, sizeof *still);
  distances = malloc(count * sizeof *distances), hits = malloc(count * sizeof *hits);
  contacts = malloc((count + 1) * ROOM * sizeof *contacts), offsets = calloc(count + 1, sizeof *offsets);
  if (!poses_a || !poses_b || !ways || !still || !distances || !hits || !contacts || !offsets || !read_poses(argv[2])) {
    fprintf(stderr, "batches: cannot read %s\n", argv[2]);
    return 1;
  }
  for (size_t i = 0; i < count; ++i) {
    const abut_vec3 from = poses_a[i].position;
    ways[i] = (abut_vec3){-from.x, -from.y, -from.z};
  }
  abut_query_options_init(&options, sizeof options);
  options.threads = 1;
  if (abut_box_create(0.5, 0.3, 0.2, &a) != ABUT_OK || abut_box_create(0.1, 0.4, 0.6, &b) != ABUT_OK) {
    return 1;
  }
  double loop = 1e9, batch = 1e9;
  for (size_t i = 0; i < repeats; ++i) {
    loop = fmin(loop, time_of(asked->loop));
    batch = fmin(batch, time_of(asked->batch));
  }
  printf("%.9f %.9f %.17g\n", loop, batch, asked->sum());
  return 0;
}
