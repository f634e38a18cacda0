/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Loads the library, asks for a batch on all threads, unloads it and waits until its threads would have woken up.
 * usage: unload FILE
 */
#define _POSIX_C_SOURCE 200809L
#include <abut/abut.h>

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { COUNT = 20000 };

static void* library;

/* Functions and objects are pointers of different kinds in C. */
static void find(void* function, const char* name) {
  void* symbol = dlsym(library, name);
  if (!symbol) {
    fprintf(stderr, "unload: %s\n", dlerror());
    exit(1);
  }
  memcpy(function, &symbol, sizeof symbol);
}

int main(int argc, char** argv) {
  abut_status (*make_box)(double, double, double, abut_shape**);
  abut_status (*ask)(const abut_shape*, const abut_pose*, const abut_shape*, const abut_pose*, size_t,
                     const abut_query_options*, abut_distance*);
  void (*release)(abut_shape*);
  abut_pose* poses = calloc(COUNT, sizeof *poses);
  abut_distance* found = calloc(COUNT, sizeof *found);
  abut_shape* box = NULL;
  const struct timespec while_threads_wake = {0, 100000000};
  size_t i;
  library = argc == 2 ? dlopen(argv[1], RTLD_NOW) : NULL;
  if (!library || !poses || !found) {
    fprintf(stderr, "usage: unload FILE\n");
    return 2;
  }
  find(&make_box, "abut_box_create");
  find(&ask, "abut_pairs_distance");
  find(&release, "abut_shape_release");
  for (i = 0; i < COUNT; ++i) {
    poses[i].position.x = 0.001 * (double)i;
    poses[i].orientation.w = 1;
  }
  if (make_box(1, 1, 1, &box) != ABUT_OK || ask(box, poses, box, poses, COUNT, NULL, found) != ABUT_OK) {
    fprintf(stderr, "unload: a call failed\n");
    return 1;
  }
  release(box);
  free(poses);
  free(found);
  dlclose(library);
  nanosleep(&while_threads_wake, NULL);
  return 0;
}
