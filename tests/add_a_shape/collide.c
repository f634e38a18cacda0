/* SPDX-License-Identifier: Apache-2.0 */
/* Collides the added shape with every kind of shape that the library has, as a pair and in a universe. */
#include "added.h"

#include <string.h>

/* A shape of a kind, without knowing what the kind takes: every parameter is 1, or nine are the corners of a
 * triangle, and the buffers are what some kind could be made from. Kinds with a description of their own are
 * made by it. */
static abut_shape* make(abut_shape_kind kind) {
  static const double corners[] = {-4, -4, 0, 4, -4, 0, 0, 4, 0, 0, 0, -4};
  static const uint32_t triangles[] = {0, 1, 2};
  static const double heights[9] = {0};
  static const uint64_t real_counts[] = {0, 12, 12}, index_counts[] = {0, 0, 3};
  static const double ones[] = {1, 1, 1, 1, 1, 1, 1, 1};
  abut_shape* shape = NULL;
  int attempt;
  if (strcmp(abut_shape_kind_name(kind), "composite") == 0) {
    const abut_pose pose = at(0, 0, 0);
    abut_shape* ball = NULL;
    const abut_shape* child = NULL;
    if (abut_sphere_create(1, &ball) == ABUT_OK) {
      child = ball;
      abut_composite_create(&child, &pose, 1, &shape);
    }
    abut_shape_release(ball);
    return shape;
  }
  if (strcmp(abut_shape_kind_name(kind), "particles") == 0) {
    const double origin[3] = {0, 0, 0};
    return abut_particles_create(origin, 1, 1, &shape) == ABUT_OK ? shape : NULL;
  }
  if (strcmp(abut_shape_kind_name(kind), "height_field") == 0) {
    abut_height_field_desc desc;
    abut_height_field_desc_init(&desc, sizeof desc);
    desc.columns = desc.rows = 3;
    desc.spacing_x = desc.spacing_y = 4;
    desc.heights = heights;
    return abut_height_field_create(&desc, &shape) == ABUT_OK ? shape : NULL;
  }
  if (strcmp(abut_shape_kind_name(kind), "uv_grid") == 0) {
    abut_uv_grid_options options;
    abut_uv_grid_options_init(&options, sizeof options);
    options.sides = ABUT_SIDES_FRONT;
    return abut_uv_grid_create(corners, 4, triangles, 1, &options, &shape) == ABUT_OK ? shape : NULL;
  }
  for (attempt = 0; attempt < 3; attempt++) {
    abut_shape_desc desc;
    abut_shape_desc_init(&desc, sizeof desc);
    desc.kind = kind;
    desc.parameter_count = abut_shape_kind_parameter_count(kind);
    desc.parameters = desc.parameter_count == 9 ? corners : ones;
    desc.real_count = real_counts[attempt];
    desc.reals = desc.real_count > 0 ? corners : NULL;
    desc.index_count = index_counts[attempt];
    desc.indices = desc.index_count > 0 ? triangles : NULL;
    if (desc.parameter_count <= 9 && abut_shape_create(&desc, &shape) == ABUT_OK) {
      return shape;
    }
  }
  return NULL;
}

/* Where a ray from above along Z first meets a shape; far below where it meets nothing. */
static double height_under(const abut_shape* shape, double x, double y) {
  const abut_pose pose = at(0, 0, 0);
  const abut_ray ray = {{x, y, 100}, {0, 0, -1}, 200};
  abut_ray_hit hit;
  uint32_t found = 0;
  expect(abut_shape_cast_ray(shape, &pose, &ray, &hit, &found) == ABUT_OK, "ray", "the other shape");
  return found == 1 ? 100 - hit.distance : -INFINITY;
}

/* The other shape lies around or below its origin; the added one is put over the middle of it, its lowest point 1.5
 * below its origin. Their distance lies between that of their boxes and the one along a ray, which mostly agree. */
static void collide(const abut_shape* added, const abut_shape* other, const char* kind) {
  const double middle = strcmp(kind, "height_field") == 0 ? 4 : 0, lowest = 9 - 1.5;
  abut_pose pose = at(0, 0, 0), touching = at(middle + 0.2, middle + 0.3, 0.5), apart = at(middle, middle, 9);
  abut_universe* universe = NULL;
  abut_part_options still;
  abut_part_id part, still_part;
  abut_geometry_id geometry;
  const abut_contact* found = NULL;
  abut_distance distance, swapped;
  abut_aabb box;
  size_t count = 0;

  expect(abut_pair_distance(added, &apart, other, &pose, NULL, &distance) == ABUT_OK && distance.distance > 1, "apart",
         kind);
  expect(abut_shape_aabb(other, &pose, &box) == ABUT_OK && distance.distance >= lowest - box.maximum.z - 1e-9,
         "below the boxes", kind);
  expect(distance.distance <= lowest - height_under(other, middle, middle) + 1e-9, "beyond the ray", kind);
  expect(abut_pair_contacts(added, &apart, other, &pose, NULL, NULL, 0, &count) == ABUT_OK && count == 0, "no contacts",
         kind);
  expect(abut_pair_distance(other, &pose, added, &apart, NULL, &swapped) == ABUT_OK &&
             fabs(swapped.distance - distance.distance) < 1e-9,
         "swapped", kind);
  expect(abut_pair_distance(added, &touching, other, &pose, NULL, &distance) == ABUT_OK && distance.distance <= 0,
         "overlapping", kind);
  expect(abut_pair_contacts(added, &touching, other, &pose, NULL, NULL, 0, &count) == ABUT_OK && count > 0, "contacts",
         kind);

  abut_part_options_init(&still, sizeof still);
  still.motion = ABUT_MOTION_STATIC;
  expect(abut_universe_create(NULL, &universe) == ABUT_OK && abut_part_create(universe, NULL, &part) == ABUT_OK &&
             abut_part_create(universe, &still, &still_part) == ABUT_OK &&
             abut_part_set_pose(universe, part, &touching) == ABUT_OK &&
             abut_geometry_create(universe, part, added, NULL, &geometry) == ABUT_OK &&
             abut_geometry_create(universe, still_part, other, NULL, &geometry) == ABUT_OK &&
             abut_universe_step(universe, 0.01) == ABUT_OK &&
             abut_universe_contacts(universe, &found, &count) == ABUT_OK && count > 0,
         "universe", kind);
  abut_universe_destroy(universe);
}

int main(void) {
  static const char* const names[] = {"bottom_radius", "top_radius", "half_height"};
  const abut_shape_kind kind = abut_shape_kind_by_name("rounded_cone");
  abut_shape* added = make_rounded_cone(1, 0.4, 0.5);
  size_t i;

  expect(abut_shape_kind_parameter_count(kind) == 3, "described", "rounded_cone");
  for (i = 0; i < 3 && failures == 0; i++) {
    expect(strcmp(abut_shape_kind_parameter_name(kind, i), names[i]) == 0, "described", "rounded_cone");
  }
  for (i = 0; i < abut_shape_kind_count() && added != NULL; i++) {
    const char* name = abut_shape_kind_name(abut_shape_kind_at(i));
    abut_shape* other = NULL;
    if (strstr(name, "_hole") != NULL) {
      uint32_t answers = 0;
      expect(abut_pair_support(kind, abut_shape_kind_at(i), ABUT_QUERY_CONTACTS, &answers) == ABUT_OK && answers == 1,
             "hole", name);
      continue; /* cuts other shapes and is none by itself */
    }
    other = make(abut_shape_kind_at(i));
    expect(other != NULL, "made", name);
    if (other != NULL) {
      collide(added, other, name);
      abut_shape_release(other);
    }
  }
  abut_shape_release(added);
  printf("%d kinds, %d failures\n", (int)abut_shape_kind_count(), failures);
  return failures == 0 ? 0 : 1;
}
