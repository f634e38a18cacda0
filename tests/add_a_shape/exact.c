/* SPDX-License-Identifier: Apache-2.0 */
/* The rounded cone with radii 1 and 0.4 and centres at heights -0.5 and 0.5: its side rises by 3 in 4 and runs from
 * (0.8, 0, 0.1) to (0.32, 0, 0.74), so that rays, spheres and planes have answers in closed form. */
#include "added.h"

#include <string.h>

static const double tolerance = 1e-12;

/* Points of the surface: half-way up the side, on the ball below, far down and just under the side, and on the ball
 * above. */
typedef struct place {
  const char* name;
  abut_vec3 point, normal;
} place;
static const place places[] = {{"side", {0.56, 0, 0.42}, {0.8, 0, 0.6}},
                               {"bottom", {0.6, 0, -1.3}, {0.6, 0, -0.8}},
                               {"shoulder", {12.0 / 13, 0, -0.5 + 5.0 / 13}, {12.0 / 13, 0, 5.0 / 13}},
                               {"top", {0.24, 0, 0.82}, {0.6, 0, 0.8}}};
enum { place_count = sizeof places / sizeof places[0] };

static double dot(abut_vec3 a, abut_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static abut_vec3 above(const place* where, double height) {
  const abut_vec3 p = where->point, n = where->normal;
  abut_vec3 result = {p.x + height * n.x, p.y + height * n.y, p.z + height * n.z};
  return result;
}

static int is_near(abut_vec3 a, abut_vec3 b) {
  return fabs(a.x - b.x) < tolerance && fabs(a.y - b.y) < tolerance && fabs(a.z - b.z) < tolerance;
}

static int casts(const abut_shape* shape, abut_vec3 origin, abut_vec3 direction, double max_distance,
                 abut_ray_hit* hit) {
  const abut_pose pose = at(0, 0, 0);
  uint32_t found = 2;
  abut_ray ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.max_distance = max_distance;
  expect(abut_shape_cast_ray(shape, &pose, &ray, hit, &found) == ABUT_OK, "answered", "ray");
  return found == 1;
}

static void expect_hit(const abut_shape* shape, abut_vec3 origin, abut_vec3 direction, double distance,
                       abut_vec3 normal, const char* what) {
  abut_ray_hit hit;
  memset(&hit, 0, sizeof hit);
  expect(casts(shape, origin, direction, 100, &hit), what, "ray misses");
  expect(fabs(hit.distance - distance) < tolerance, what, "distance of a ray");
  expect(is_near(hit.normal, normal), what, "normal of a ray");
}

static void expect_rays(const abut_shape* shape) {
  /* Along the side from bottom to top, 0.2 below it: feet of the centres of both balls lie 0.8 apart. */
  const abut_vec3 up = {-0.6, 0, 0.8}, foot = {0.64, 0, -0.02}, before = {1.84, 0, -1.62}, east = {1, 0, 0};
  const double half_chord = sqrt(0.12);
  const abut_vec3 leaving = {(0.16 - 0.6 * half_chord) / 0.4, 0, (0.12 + 0.8 * half_chord) / 0.4};
  const abut_vec3 outside = {0.8 + 0.008 + 6, 0, 0.1 + 0.006 - 8};
  abut_ray_hit hit;
  int i;
  for (i = 0; i < place_count; i++) {
    const abut_vec3 n = places[i].normal, inward = {-n.x, 0, -n.z};
    expect_hit(shape, above(&places[i], 3), inward, 3, n, places[i].name);
    expect_hit(shape, above(&places[i], -0.25), n, 0.25, n, places[i].name);
    expect(casts(shape, above(&places[i], 3), inward, 3.001, &hit), places[i].name, "ray within reach misses");
    expect(!casts(shape, above(&places[i], 3), inward, 2.999, &hit), places[i].name, "ray out of reach hits");
    expect(!casts(shape, above(&places[i], 3), n, 100, &hit), places[i].name, "ray that leaves hits");
  }
  expect_hit(shape, before, up, 1.4, east, "along the side from outside");
  expect_hit(shape, foot, up, 0.8 + half_chord, leaving, "along the side from inside");
  expect(!casts(shape, outside, up, 100, &hit), "along the side", "ray above the side hits");
}

/* A sphere of radius 0.25 over a place, apart, touching, overlapping, and with its centre inside. */
static void expect_spheres(const abut_shape* shape) {
  static const double heights[] = {3, 0.25, 0.1, -0.2}, radius[] = {0.25};
  const abut_pose pose = at(0, 0, 0);
  abut_shape* sphere = make_of("sphere", radius, 1);
  int i, k;
  for (i = 0; i < place_count; i++) {
    for (k = 0; k < 4; k++) {
      const abut_vec3 centre = above(&places[i], heights[k]);
      const abut_pose placed = at(centre.x, centre.y, centre.z);
      abut_distance found;
      abut_contact contact;
      size_t count = 0;
      memset(&found, 0, sizeof found);
      expect(abut_pair_distance(shape, &pose, sphere, &placed, NULL, &found) == ABUT_OK, places[i].name, "sphere");
      expect(fabs(found.distance - (heights[k] - 0.25)) < tolerance, places[i].name, "distance of a sphere");
      expect(is_near(found.normal, places[i].normal), places[i].name, "normal of a sphere");
      expect(is_near(found.point_a, places[i].point), places[i].name, "point toward a sphere");
      expect(is_near(found.point_b, above(&places[i], heights[k] - 0.25)), places[i].name, "point of a sphere");
      if (heights[k] != 0.25) {
        expect(abut_pair_contacts(shape, &pose, sphere, &placed, NULL, &contact, 1, &count) == ABUT_OK &&
                   count == (heights[k] > 0.25 ? 0u : 1u),
               places[i].name, "contacts of a sphere");
      }
    }
  }
  abut_shape_release(sphere);
}

/* Planes that a place faces: along the whole side two contacts hold the shape, on a ball one does. */
static void expect_planes(const abut_shape* shape) {
  static const double gaps[] = {2, -0.1};
  const abut_pose pose = at(0, 0, 0);
  int i, k;
  for (i = 0; i < place_count; i++) {
    for (k = 0; k < 2; k++) {
      const abut_vec3 n = places[i].normal;
      double parameters[4] = {-n.x, -n.y, -n.z, 0};
      abut_shape* plane;
      abut_distance found;
      abut_contact contacts[4];
      size_t count = 0, c;
      parameters[3] = -dot(n, places[i].point) - gaps[k];
      plane = make_of("plane", parameters, 4);
      memset(&found, 0, sizeof found);
      expect(abut_pair_distance(shape, &pose, plane, &pose, NULL, &found) == ABUT_OK, places[i].name, "plane");
      expect(fabs(found.distance - gaps[k]) < tolerance, places[i].name, "distance of a plane");
      expect(is_near(found.normal, n), places[i].name, "normal of a plane");
      expect(abut_pair_contacts(shape, &pose, plane, &pose, NULL, contacts, 4, &count) == ABUT_OK &&
                 count == (gaps[k] > 0 ? 0u
                           : i == 0    ? 2u
                                       : 1u),
             places[i].name, "contacts of a plane");
      for (c = 0; c < count && c < 4; c++) {
        expect(fabs(contacts[c].distance - gaps[k]) < tolerance, places[i].name, "depth on a plane");
      }
      abut_shape_release(plane);
    }
  }
}

/* Where one ball holds the other, the larger one is all there is. */
static void expect_ball(double bottom_radius, double top_radius, double height) {
  const abut_vec3 from = {0, 0, 5}, down = {0, 0, -1}, up = {0, 0, 1};
  const double radius[] = {2};
  const abut_pose pose = at(0, 0, 0), aside = at(6, 0, height);
  abut_shape *shape = make_rounded_cone(bottom_radius, top_radius, 0.125), *sphere = make_of("sphere", radius, 1);
  abut_distance found;
  expect_hit(shape, from, down, 4 - height, up, "one ball");
  expect(
      abut_pair_distance(shape, &pose, sphere, &aside, NULL, &found) == ABUT_OK && fabs(found.distance - 3) < tolerance,
      "one ball", "distance of a sphere");
  abut_shape_release(sphere);
  abut_shape_release(shape);
}

int main(void) {
  abut_shape* shape = make_rounded_cone(1, 0.4, 0.5);
  expect_rays(shape);
  if (abut_shape_kind_by_name("sphere") != 0) {
    expect_spheres(shape);
    expect_ball(1, 0.25, -0.125);
    expect_ball(0.25, 1, 0.125);
  }
  if (abut_shape_kind_by_name("plane") != 0) {
    expect_planes(shape);
  }
  abut_shape_release(shape);
  printf("closed forms: %d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
