// SPDX-License-Identifier: Apache-2.0
// Signed distances of balls, boxes and capsules, by closed forms and by searches of one number. No code of abut.
#pragma once

#include <abut/abut.h>

#include <array>

namespace backend {

enum class Form { ball, block, capsule };

// A ball of radius sizes[0]; a box of half sizes; a capsule about local Z of radius sizes[0] and half height sizes[1].
struct Solid {
  Form form = Form::ball;
  std::array<double, 3> sizes{};
  abut_pose pose{};
};

// Of a point to the surface of a solid, negative inside.
double distance_of(const Solid& solid, const abut_vec3& point);
// Of two solids, negative where they overlap. It is a lower bound alone for boxes that are apart. Where a box holds a
// part of the axis of a capsule, it tells no more than that they overlap.
struct Truth {
  double distance;
  bool is_exact;
};
Truth truth_of(const Solid& a, const Solid& b);

}  // namespace backend
