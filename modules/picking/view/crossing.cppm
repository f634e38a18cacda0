// SPDX-License-Identifier: Apache-2.0
// Which triangles a line crosses, so that it leaves a closed surface as often as it enters it.
//
// The line is looked along: triangles become triangles of a plane, and the line a point. On which side of an edge that
// point lies is told exactly, from the same numbers for both triangles of the edge. A point on an edge or a corner is
// moved by infinitesimals, the same for all edges (Edelsbrunner and Muecke 1990), and then lies on none.
module;

#include <abut/picking.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

module abut.picking:crossing;
import :box_scene;
import :source;
import :vector;

namespace abut::picking {

class LineOfSight {
 public:
  // The unit direction; `size` is about that of the coordinates, relative to the start of the line.
  LineOfSight(const abut_vec3& start, const abut_vec3& direction, double size) noexcept;

  // How far along the line it crosses a triangle, which may be behind its start, and whether through its front. A
  // normal cannot tell that of a triangle that is seen edge-on.
  struct Met {
    double along;
    bool enters;
  };
  [[nodiscard]] std::optional<Met> crosses(const std::array<abut_vec3, 3>& corners) const noexcept;

 private:
  // Across the line, and along it.
  struct Seen {
    double x, y, z;
  };
  [[nodiscard]] Seen seen(const abut_vec3& point) const noexcept;
  [[nodiscard]] static int side_of(const Seen& from, const Seen& to) noexcept;

  abut_vec3 start_, direction_;
  std::array<std::size_t, 3> axes_{};  // the last one is the one along which the direction is largest
  double shear_x_, shear_y_, along_;
  double scale_;  // a power of two, so that products neither overflow nor vanish
};

// The triangles of a shape with their faces, and boxes around them where there are many.
struct CrossedSurface {
  TriangleList list;
  std::vector<std::uint32_t> faces;  // empty where they are the triangles
  abut_aabb box = empty_box;
  std::unique_ptr<BoxScene> boxes;

  [[nodiscard]] std::array<abut_vec3, 3> corners_of(std::uint32_t triangle) const;
  [[nodiscard]] std::size_t size() const { return list.indices.size() / 3; }
};

// Crossing after crossing of a shape that is asked in double, until visit(hit) says false: each ray starts behind the
// crossing before, by more than that may be off. A crossing of the same side within the blur is the same one; there the
// next ray starts further behind, so that this ends also for a ray that runs along a surface.
template <class Visit>
void visit_crossings(const PickableShape& shape, const abut_pose& pose, const abut_ray& ray, const Visit& visit) {
  constexpr double least_step = 0x1p-44;
  constexpr double blur = 0x1p-38;
  const double coordinates = largest_component(ray.origin) + largest_component(pose.position);
  double start = 0;
  double step = least_step;
  double last = -infinity;
  bool entered = false;
  while (start <= ray.max_distance) {
    const abut_ray rest{add(ray.origin, scale(ray.direction, start)), ray.direction, ray.max_distance - start};
    auto hit = shape.cast(pose, rest);
    if (!hit) return;
    hit->distance += start;
    const double size = coordinates + hit->distance;
    const bool enters = dot(hit->normal, ray.direction) < 0;
    const bool repeats = enters == entered && hit->distance - last <= blur * size;
    if (!repeats && !visit(*hit)) return;
    step = repeats ? 2 * step : least_step;
    last = hit->distance;
    entered = enters;
    start = hit->distance + step * size;
  }
}

}  // namespace abut::picking
