// SPDX-License-Identifier: Apache-2.0
#include "view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "failures.hpp"

namespace cli {
namespace {

struct Bounds {
  abut_vec3 least{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  abut_vec3 most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const abut_aabb& box) {
    for (const auto axis : {&abut_vec3::x, &abut_vec3::y, &abut_vec3::z}) {
      least.*axis = std::min(least.*axis, box.minimum.*axis);
      most.*axis = std::max(most.*axis, box.maximum.*axis);
    }
  }
  [[nodiscard]] bool is_empty() const { return !(least.x <= most.x); }
  [[nodiscard]] double radius() const { return is_empty() ? 0.0 : 0.5 * length(most - least); }
};

bool is_finite(const abut_aabb& box) {
  constexpr double far = 1e60;
  return length(box.minimum) < far && length(box.maximum) < far;
}

Bounds bounds_of(const World& world) {
  Bounds moving, all;
  std::vector<abut_aabb> still;
  for (std::size_t i = 0; i < world.scene().geometries.size(); ++i) {
    const Geometry& geometry = world.scene().geometries[i];
    const abut_pose pose = world.pose_of(i);
    abut_aabb box;
    check(abut_shape_aabb(world.shape_of(i), &pose, &box), "box of a geometry");
    if (!is_finite(box)) {
      continue;
    }
    if (world.scene().parts[geometry.part].motion == ABUT_MOTION_STATIC) {
      still.push_back(box);
    } else {
      moving.add(box);
    }
  }
  all = moving;
  for (const abut_aabb& box : still) {
    const bool dwarfs = !moving.is_empty() && 0.5 * length(box.maximum - box.minimum) > 8.0 * moving.radius();
    if (!dwarfs) {
      all.add(box);
    }
  }
  return all;
}

// At right angles to `up`, the axis of X where that is possible.
abut_vec3 right_of(const abut_vec3& up) {
  const abut_vec3 axis = std::abs(up.x) < 0.9 ? abut_vec3{1.0, 0.0, 0.0} : abut_vec3{0.0, 1.0, 0.0};
  return normalised(axis - up * dot(axis, up));
}

// From the middle of all to a camera that looks a little from above and from the side.
abut_vec3 back_of(const abut_vec3& up) {
  const abut_vec3 right = right_of(up);
  return normalised(right * 0.45 - cross(up, right) * 0.85 + up * 0.45);
}

// How far away a camera must be for all corners to be in its picture.
double fitting_distance(const Bounds& bounds, const abut_vec3& target, const abut_vec3& back, const abut_vec3& up,
                        double aspect) {
  const abut_vec3 right = normalised(cross(up, back));
  const abut_vec3 over = cross(back, right);
  const double tangent = std::tan(0.5 * vertical_fov);
  double most = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const abut_vec3 point{(corner & 1U) != 0 ? bounds.most.x : bounds.least.x,
                          (corner & 2U) != 0 ? bounds.most.y : bounds.least.y,
                          (corner & 4U) != 0 ? bounds.most.z : bounds.least.z};
    const abut_vec3 from = point - target;
    const double aside = std::max(std::abs(dot(from, right)) / (tangent * aspect), std::abs(dot(from, over)) / tangent);
    most = std::max(most, dot(from, back) + aside);
  }
  return most;
}

}  // namespace

View view_of(const World& world, const Arguments& arguments) {
  constexpr double border = 1.12;  // room around all, and for the legend
  const abut_vec3 up = arguments.up.value_or(abut_vec3{0.0, 0.0, 1.0});
  if (!(length(up) > 0.0)) {
    throw BadInput("--up is 0,0,0; expected a direction");
  }
  Bounds bounds = bounds_of(world);
  if (bounds.is_empty()) {
    bounds.add({{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}});
  }
  View view{{}, (bounds.least + bounds.most) * 0.5, normalised(up), std::max(bounds.radius(), 1e-9)};
  view.target = arguments.to.value_or(view.target);
  const abut_vec3 back = back_of(view.up);
  const double aspect = static_cast<double>(arguments.width) / arguments.height;
  const double distance = fitting_distance(bounds, view.target, back, view.up, aspect);
  view.eye = arguments.from.value_or(view.target + back * (border * std::max(distance, 1e-9)));
  const abut_vec3 line = view.target - view.eye;
  if (!(length(cross(line, view.up)) > 1e-9 * length(line))) {
    throw BadInput("the line of sight has no length or is parallel to --up; expected others for --from, --to or --up");
  }
  return view;
}

}  // namespace cli
