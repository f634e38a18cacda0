// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

module abut.picking;
import :camera;
import :outline;
import :source;
import :vector;

namespace abut::picking {

namespace {

// What comes nearer to the plane of the eye than this part of the greatest depth is cut off: its picture is without
// end.
constexpr double least_depth = 1e-6;
// Shorter pictures of edges, in pixels, are rounding.
constexpr double least_length = 1e-9;

[[nodiscard]] double size_of(const Offset& offset) { return std::sqrt(offset.x * offset.x + offset.y * offset.y); }

// Where a segment of the picture comes nearest to the point asked for, from 0 at a to 1 at b.
[[nodiscard]] double nearest_on(const Offset& a, const Offset& b) {
  const Offset along{b.x - a.x, b.y - a.y};
  const double square = along.x * along.x + along.y * along.y;
  return square == 0 ? 0 : std::clamp(-(a.x * along.x + a.y * along.y) / square, 0.0, 1.0);
}

void improve(Candidate& best, const Offset& nearest, const Offset& inside) {
  const double size = size_of(nearest);
  if (size < best.size) best = {size, nearest, inside};
}

// Where the segment from a to b has the depth `cut`.
[[nodiscard]] abut_vec3 cut_at(const abut_vec3& a, const abut_vec3& b, double cut) {
  const abut_vec3 between_them = add(a, scale(subtract(b, a), (cut - a.z) / (b.z - a.z)));
  return {between_them.x, between_them.y, cut};
}

// The depth at which a shape is cut off that reaches up to `deepest`. A parallel picture has no end.
[[nodiscard]] double cut_of(const View& view, double deepest) {
  return view.is_parallel ? -infinity : least_depth * deepest;
}

// Point of a sphere, in view coordinates, whose picture is nearest: the normal there points against
// the gradient of the distance in the picture.
void look_at_sphere(const Sight& sight, const abut_vec3& centre, double radius, Candidate& best) {
  const View& view = sight.aim.view;
  if (!view.is_parallel && centre.z <= radius) return;
  abut_vec3 point = centre;
  for (int step = 0; step < 40; ++step) {
    const Offset off = sight.offset_of(point);
    const double across = off.x / view.aspect;
    const double down = -off.y;
    const double toward = view.is_parallel ? 0 : -(across * point.x + down * point.y) / point.z;
    const abut_vec3 gradient{across, down, toward};
    if (!(largest_component(gradient) > 0)) break;
    point = add(centre, scale(normalized(gradient), -radius));
  }
  improve(best, sight.offset_of(point), sight.offset_of(centre));
}

}  // namespace

bool Sight::may_show(const abut_aabb& box) const {
  const View& view = aim.view;
  const double around = 0.5 * diagonal_of(box);
  const abut_vec3 centre = subtract(centre_of(box), eye_of(view, aim.x, aim.y));
  const abut_vec3 axis = direction_through(view, aim.x, aim.y);
  const double along = dot(centre, axis);
  // Twice the tangent of the radius at the centre of the picture: enough also for an oblique sight.
  const double spread = 2 * aim.radius * std::max(1.0, view.aspect) / view.focal;
  if (view.is_parallel) return length(cross(centre, axis)) <= spread + around;
  if (along < -around) return false;
  return length(cross(centre, axis)) <= spread * (along + around) + around * (1 + spread);
}

void look_at_triangle(const Sight& sight, const std::array<abut_vec3, 3>& seen, Candidate& best) {
  const double deepest = std::max({seen[0].z, seen[1].z, seen[2].z});
  if (!sight.aim.view.is_parallel && deepest <= 0) return;
  const double cut = cut_of(sight.aim.view, deepest);
  std::array<Offset, 4> outline{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const abut_vec3& a = seen[i];
    const abut_vec3& b = seen[(i + 1) % 3];
    if (a.z >= cut) outline[count++] = sight.offset_of(a);
    if ((a.z >= cut) != (b.z >= cut)) outline[count++] = sight.offset_of(cut_at(a, b, cut));
  }
  if (count == 0) return;
  Offset inside{0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    inside.x += outline[i].x / static_cast<double>(count);
    inside.y += outline[i].y / static_cast<double>(count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Offset& a = outline[i];
    const Offset& b = outline[(i + 1) % count];
    improve(best, between(a, b, nearest_on(a, b)), inside);
  }
}

// A capsule is a row of spheres; the distance in the picture along it has one valley.
void look_at_rounded(const Sight& sight, const Frame& frame, const RoundedSegment& rounded, Candidate& best) {
  const auto at = [&](double z) {
    Candidate candidate;
    look_at_sphere(sight, sight.seen(to_world(frame, {0, 0, z})), rounded.radius, candidate);
    return candidate;
  };
  double low = -rounded.half_height;
  double high = rounded.half_height;
  const double golden = 1 / std::numbers::phi;
  for (int step = 0; step < 40 && high > low; ++step) {
    const double width = golden * (high - low);
    if (at(high - width).size <= at(low + width).size) {
      high = low + width;
    } else {
      low = high - width;
    }
  }
  const Candidate found = at(0.5 * (low + high));
  if (found.size < best.size) best = found;
}

ThinCandidate look_at_edge(const Sight& sight, abut_vec3 a, abut_vec3 b) {
  const bool is_parallel = sight.aim.view.is_parallel;
  const double cut = cut_of(sight.aim.view, std::max(a.z, b.z));
  if (!is_parallel && !(cut > 0)) return {};
  if (a.z < cut) {
    a = cut_at(a, b, cut);
  } else if (b.z < cut) {
    b = cut_at(b, a, cut);
  }
  const Offset from = sight.offset_of(a);
  const Offset to = sight.offset_of(b);
  // An edge that is seen as a point shows its nearer end.
  const double t = size_of({to.x - from.x, to.y - from.y}) < least_length ? (b.z < a.z ? 1 : 0) : nearest_on(from, to);
  // A perspective picture of a segment runs faster where it is near: t of the picture is this part of the segment.
  const double part = is_parallel ? t : t * a.z / ((1 - t) * b.z + t * a.z);
  return {size_of(between(from, to, t)), add(a, scale(subtract(b, a), part))};
}

std::optional<abut_ray> sight_line(const View& view, const abut_vec3& point) {
  const abut_vec3 from_eye = subtract(point, view.eye);
  const abut_vec3 direction = view.is_parallel ? view.forward : normalized(from_eye);
  const double depth = view.is_parallel ? dot(from_eye, view.forward) : length(from_eye);
  const double stretch = stretch_of(view, direction);
  const double distance = depth - stretch * view.start;
  if (!(distance >= 0 && distance <= stretch * view.limit)) return std::nullopt;
  return abut_ray{subtract(point, scale(direction, distance)), direction, distance * (1 - hiding)};
}

}  // namespace abut::picking
