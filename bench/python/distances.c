/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Reads pairs of poses of two boxes and asks for their distances in one call, again and again.
 * usage: distances FILE COUNT REPEATS; the file holds COUNT poses of a and then COUNT poses of b.
 * Prints the least processor time of a call in seconds and the sum of the distances.
 */
#define _POSIX_C_SOURCE 199309L
#include <abut/abut.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(int argc, char** argv) {
  if (argc != 4) {
    fprintf(stderr, "usage: distances FILE COUNT REPEATS\n");
    return 2;
  }
  size_t count = strtoul(argv[2], NULL, 10), repeats = strtoul(argv[3], NULL, 10);
  abut_pose* poses = malloc(2 * count * sizeof *poses);
  abut_distance* out = malloc(count * sizeof *out);
  double least = 1e9;
  FILE* file = fopen(argv[1], "rb");
  if (!poses || !out || !file || fread(poses, sizeof *poses, 2 * count, file) != 2 * count) {
    fprintf(stderr, "distances: cannot read %s\n", argv[1]);
    return 1;
  }
  fclose(file);

  abut_shape *a = NULL, *b = NULL;
  if (abut_box_create(0.5, 0.3, 0.2, &a) != ABUT_OK || abut_box_create(0.1, 0.4, 0.6, &b) != ABUT_OK) {
    return 1;
  }
  for (size_t i = 0; i < repeats; ++i) {
    double start = seconds();
    if (abut_pairs_distance(a, poses, b, poses + count, count, NULL, out) != ABUT_OK) {
      fprintf(stderr, "distances: %s\n", abut_last_error_message());
      return 1;
    }
    double spent = seconds() - start;
    least = spent < least ? spent : least;
  }
  double sum = 0;
  for (size_t i = 0; i < count; ++i) {
    sum += out[i].distance;
  }
  printf("%.9f %.17g\n", least, sum);
  abut_shape_release(a);
  abut_shape_release(b);
  free(poses);
  free(out);
  return 0;
}
