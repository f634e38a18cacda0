// SPDX-License-Identifier: Apache-2.0
#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace backend {
namespace {

abut_vec3 operator-(const abut_vec3& a, const abut_vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
abut_vec3 operator+(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
abut_vec3 operator*(double s, const abut_vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const abut_vec3& a) { return std::sqrt(dot(a, a)); }

// The columns of the matrix of a unit quaternion.
std::array<abut_vec3, 3> axes_of(const abut_quat& q) {
  const double w = q.w, x = q.x, y = q.y, z = q.z;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
           {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
           {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
}

double distance_of_box(const Solid& box, const abut_vec3& point) {
  const auto axes = axes_of(box.pose.orientation);
  const abut_vec3 way = point - box.pose.position;
  std::array<double, 3> beyond{};
  for (std::size_t i = 0; i < 3; ++i) beyond.at(i) = std::fabs(dot(way, axes.at(i))) - box.sizes.at(i);
  const double inside = std::min(0.0, *std::max_element(beyond.begin(), beyond.end()));
  double square = 0;
  for (const double its : beyond) square += std::max(its, 0.0) * std::max(its, 0.0);
  return std::sqrt(square) + inside;
}

// The axis of a capsule, or the centre of a ball.
struct Core {
  abut_vec3 from, to;
};
Core core_of(const Solid& solid) {
  const double half = solid.form == Form::capsule ? solid.sizes[1] : 0;
  const abut_vec3 reach = half * axes_of(solid.pose.orientation)[2];
  return {solid.pose.position - reach, solid.pose.position + reach};
}
abut_vec3 point_at(const Core& core, double share) { return core.from + share * (core.to - core.from); }

double distance_to_core(const Core& core, const abut_vec3& point) {
  const abut_vec3 along = core.to - core.from;
  const double square = dot(along, along);
  const double share = square == 0 ? 0 : std::clamp(dot(point - core.from, along) / square, 0.0, 1.0);
  return length(point - point_at(core, share));
}

// The least value over an axis of what is convex along it.
template <class Function>
double least_along(const Core& core, Function&& value) {
  double low = 0, high = 1;
  for (int i = 0; i < 200; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (value(point_at(core, left)) < value(point_at(core, right))) {
      high = right;
    } else {
      low = left;
    }
  }
  return value(point_at(core, (low + high) / 2));
}

// The greatest separation over face normals and products of edges: the depth where boxes overlap. Where they do not,
// it is below the distance, which vertices may have.
double separation_of_boxes(const Solid& a, const Solid& b) {
  const auto of_a = axes_of(a.pose.orientation), of_b = axes_of(b.pose.orientation);
  double most = -std::numeric_limits<double>::infinity();
  const auto look = [&](const abut_vec3& axis) {
    const double size = length(axis);
    if (size < 1e-9) return;
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      reach += a.sizes.at(i) * std::fabs(dot(axis, of_a.at(i))) + b.sizes.at(i) * std::fabs(dot(axis, of_b.at(i)));
    }
    most = std::max(most, (std::fabs(dot(axis, b.pose.position - a.pose.position)) - reach) / size);
  };
  for (const abut_vec3& axis : of_a) look(axis);
  for (const abut_vec3& axis : of_b) look(axis);
  for (const abut_vec3& first : of_a) {
    for (const abut_vec3& second : of_b) look(cross(first, second));
  }
  return most;
}

}  // namespace

double distance_of(const Solid& solid, const abut_vec3& point) {
  return solid.form == Form::block ? distance_of_box(solid, point)
                                   : distance_to_core(core_of(solid), point) - solid.sizes[0];
}

Truth truth_of(const Solid& a, const Solid& b) {
  if (a.form == Form::block && b.form == Form::block) {
    const double separation = separation_of_boxes(a, b);
    return {separation, separation < 0};
  }
  if (b.form == Form::block) return truth_of(b, a);
  const double core = least_along(core_of(b), [&](const abut_vec3& point) {
    return a.form == Form::block ? distance_of_box(a, point) : distance_to_core(core_of(a), point);
  });
  if (a.form == Form::block) return {core - b.sizes[0], core > 0 || b.form == Form::ball};
  return {core - a.sizes[0] - b.sizes[0], true};
}

}  // namespace backend
