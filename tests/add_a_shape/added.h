/* SPDX-License-Identifier: Apache-2.0 */
/* What both programs of this test share: the added shape, made by name through the generic door. */
#ifndef ADDED_H
#define ADDED_H

#include <abut/abut.h>
#include <math.h>
#include <stdio.h>

static int failures = 0;

static void expect(int condition, const char* what, const char* of) {
  if (!condition) {
    printf("%s: %s; %s\n", of, what, abut_last_error_message());
    failures++;
  }
}

static abut_pose at(double x, double y, double z) {
  abut_pose pose = {{x, y, z}, {1, 0, 0, 0}};
  return pose;
}

static abut_shape* make_of(const char* kind, const double* parameters, uint32_t parameter_count) {
  abut_shape_desc desc;
  abut_shape* shape = NULL;
  abut_shape_desc_init(&desc, sizeof desc);
  desc.kind = abut_shape_kind_by_name(kind);
  desc.parameters = parameters;
  desc.parameter_count = parameter_count;
  expect(abut_shape_create(&desc, &shape) == ABUT_OK, "made", kind);
  return shape;
}

static abut_shape* make_rounded_cone(double bottom_radius, double top_radius, double half_height) {
  const double parameters[3] = {bottom_radius, top_radius, half_height};
  return make_of("rounded_cone", parameters, 3);
}

#endif
