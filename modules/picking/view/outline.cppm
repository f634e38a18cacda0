// SPDX-License-Identifier: Apache-2.0
// Outlines of shapes in a picture, and which point of them is nearest to the one asked for.
module;

#include <abut/picking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

export module abut.picking:outline;
import :camera;
import :source;
import :vector;

namespace abut::picking {

// A point of the picture relative to the one asked for, in pixels.
struct Offset {
  double x;
  double y;
};

[[nodiscard]] inline Offset between(const Offset& a, const Offset& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

// The picture around a point. View coordinates are right, up and depth of a point, from the eye.
struct Sight {
  Aim aim;

  [[nodiscard]] inline abut_vec3 seen(const abut_vec3& p) const {
    const View& view = aim.view;
    const abut_vec3 from_eye = subtract(p, view.eye);
    return {dot(from_eye, view.right), dot(from_eye, view.up), dot(from_eye, view.forward)};
  }
  [[nodiscard]] inline abut_vec3 in_world(const abut_vec3& seen) const {
    const View& view = aim.view;
    return add(view.eye, add(add(scale(view.right, seen.x), scale(view.up, seen.y)), scale(view.forward, seen.z)));
  }
  [[nodiscard]] inline Offset offset_of(const abut_vec3& seen) const {
    const View& view = aim.view;
    const double focal = view.is_parallel ? view.focal : view.focal / seen.z;
    return {view.centre_x + focal / view.aspect * seen.x - aim.x, view.centre_y - focal * seen.y - aim.y};
  }
  [[nodiscard]] inline abut_ray ray_at(const Offset& offset) const {
    return ray_through(aim.view, aim.x + offset.x, aim.y + offset.y);
  }
  // Whether a box may have a point in the picture within the radius. The sphere around the box against a cone.
  [[nodiscard]] bool may_show(const abut_aabb& box) const;
};

// A place of the picture to try, and a place further inside, towards which to go when the outline itself is missed.
struct Candidate {
  double size = infinity;  // distance from the point asked for, in pixels
  Offset nearest{};
  Offset inside{};
};

// Looks at a triangle in view coordinates.
void look_at_triangle(const Sight& sight, const std::array<abut_vec3, 3>& seen, Candidate& best);

// Looks at balls along a segment, of a positive radius.
void look_at_rounded(const Sight& sight, const Frame& frame, const RoundedSegment& rounded, Candidate& best);

// A point of a segment in view coordinates: the one that is nearest in the picture.
struct ThinCandidate {
  double size = infinity;
  abut_vec3 seen{};
};

// Looks at an edge between two points in view coordinates.
[[nodiscard]] ThinCandidate look_at_edge(const Sight& sight, abut_vec3 a, abut_vec3 b);

// What lies on a surface is seen: only what is nearer by more than this part of the distance hides it.
inline constexpr double hiding = 1e-6;

// The ray that ends just before a point; none beyond near and far.
[[nodiscard]] std::optional<abut_ray> sight_line(const View& view, const abut_vec3& point);

}  // namespace abut::picking
