// SPDX-License-Identifier: Apache-2.0
// Rays and the mouse against a universe, through Embree: picking.h for C++17 and newer. Link libabut_picking as well.
#ifndef ABUT_PICKING_HPP
#define ABUT_PICKING_HPP

#include <abut/abut.hpp>
#include <abut/picking.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut {

using Pick = abut_pick;
using Coherence = abut_coherence_value;
using Projection = abut_projection_value;
using ClipDepth = abut_clip_depth_value;
using ClipPlane = abut_clip_plane;
using Selection = abut_selection_value;
using Snap = abut_snap;
using Barycentric = abut_barycentric;

inline namespace ABUT_ANSWERS {

// A camera that looks along its local -Z, with local +Y up.
struct Camera : Defaulted<Camera, abut_camera, abut_camera_init> {
  using C = abut_camera;
  [[nodiscard]] Camera with_size(std::uint32_t pixels_x, std::uint32_t pixels_y) const {
    return with(&C::width, pixels_x).with(&C::height, pixels_y);
  }
  [[nodiscard]] Camera with_pose(const Pose& value) const { return with(&C::pose, value); }
  [[nodiscard]] Camera with_vertical_fov(double radians) const { return with(&C::vertical_fov, radians); }
  [[nodiscard]] Camera with_range(double nearest, double farthest) const {
    return with(&C::near_distance, nearest).with(&C::far_distance, farthest);
  }
  // Near and far become planes.
  [[nodiscard]] Camera with_depth_along_axis() const { return with(&C::depth_axis, ABUT_DEPTH_ALONG_AXIS); }
  // All rays become parallel; the picture is so high.
  [[nodiscard]] Camera with_vertical_extent(double length) const {
    return with(&C::projection, ABUT_PROJECTION_ORTHOGRAPHIC).with(&C::vertical_extent, length);
  }
  [[nodiscard]] Camera with_pixel_aspect(double value) const { return with(&C::pixel_aspect, value); }
  [[nodiscard]] Camera with_shift(double pixels_x, double pixels_y) const {
    return with(&C::shift_x, pixels_x).with(&C::shift_y, pixels_y);
  }

  // Turns the camera from `eye` to `target`, with `up` upwards in the picture.
  Answer<void> look_at(Vec3 eye, Vec3 target, Vec3 up = {0, 0, 1}) {
    return detail::answer(abut_camera_look_at(this, &eye, &target, &up));
  }
  // Takes over a projection matrix, column by column.
  Answer<void> set_projection(const std::array<double, 16>& matrix, ClipDepth depth = ABUT_CLIP_DEPTH_SIGNED) {
    return detail::answer(abut_camera_set_projection(this, matrix.data(), depth));
  }
  // Through a point of the picture, in pixels: x to the right, y down.
  [[nodiscard]] Answer<Ray> ray(double x, double y) const {
    Ray out{};
    return detail::answer(abut_camera_ray(this, x, y, &out), out);
  }
};

// Follows its universe, and keeps it. Queries may run on many threads at once.
class Picker {
 public:
  [[nodiscard]] static Answer<Picker> create(Universe& universe) {
    abut_picker* out = nullptr;
    const abut_status status = abut_picker_create(universe.get(), &out);
    return detail::answer_with(status, [&] { return Picker(out); });
  }
#ifndef ABUT_NO_EXCEPTIONS
  explicit Picker(Universe& universe) : Picker(create(universe)) {}
#endif

  [[nodiscard]] abut_picker* get() const noexcept { return handle_.get(); }

  // Follows the universe now rather than at the next query.
  Answer<void> update() const { return detail::answer(abut_picker_update(get())); }

  // What all later queries see: bits of abut_picker_flags, and what clip planes keep.
  Answer<void> set_flags(abut_picker_flags flags) { return detail::answer(abut_picker_set_flags(get(), flags)); }
  Answer<void> set_clip_planes(Span<const ClipPlane> planes) {
    return detail::answer(abut_picker_set_clip_planes(get(), planes.data(), planes.size()));
  }

  // The geometry of a pick is null where nothing was hit.
  [[nodiscard]] Answer<Pick> cast_ray(const Ray& ray, OptionalRef<abut_query_filter> filter = {}) const {
    Pick out{};
    return detail::answer(abut_picker_cast_ray(get(), &ray, filter.get(), &out), out);
  }
  Answer<void> cast_rays(Span<const Ray> rays, Span<Pick> out, Coherence coherence = ABUT_COHERENCE_NONE,
                         OptionalRef<abut_query_filter> filter = {}) const {
    const abut_status sizes = detail::expect_as_many("out", out.size(), "rays", rays.size());
    return detail::answer(
        sizes != ABUT_OK ? sizes
                         : abut_picker_cast_rays(get(), rays.data(), rays.size(), coherence, filter.get(), out.data()));
  }
  [[nodiscard]] Answer<std::vector<Pick>> cast_rays(Span<const Ray> rays, Coherence coherence = ABUT_COHERENCE_NONE,
                                                    OptionalRef<abut_query_filter> filter = {}) const {
    std::vector<Pick> out(rays.size());
    return detail::answer(abut_picker_cast_rays(get(), rays.data(), rays.size(), coherence, filter.get(), out.data()),
                          out);
  }
  // Whether a ray meets anything; of many rays 1 or 0 for each.
  [[nodiscard]] Answer<bool> ray_hits(const Ray& ray, OptionalRef<abut_query_filter> filter = {}) const {
    std::uint32_t out = 0;
    const abut_status status = abut_picker_ray_hits(get(), &ray, filter.get(), &out);
    return detail::answer_with(status, [&] { return out != 0; });
  }
  [[nodiscard]] Answer<std::vector<std::uint32_t>> rays_hit(Span<const Ray> rays,
                                                            Coherence coherence = ABUT_COHERENCE_NONE,
                                                            OptionalRef<abut_query_filter> filter = {}) const {
    std::vector<std::uint32_t> out(rays.size());
    return detail::answer(abut_picker_rays_hit(get(), rays.data(), rays.size(), coherence, filter.get(), out.data()),
                          out);
  }
  // Each crossing of a surface, nearest first.
  [[nodiscard]] Answer<std::vector<Pick>> cast_ray_all(const Ray& ray,
                                                       OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect<Pick>([&](Pick* data, std::size_t capacity, std::size_t* count) {
      return abut_picker_cast_ray_all(get(), &ray, filter.get(), data, capacity, count);
    });
  }
  // What lies under the mouse, within a radius in pixels.
  [[nodiscard]] Answer<Pick> pick_pixel(const Camera& camera, double x, double y, double radius,
                                        OptionalRef<abut_query_filter> filter = {}) const {
    Pick out{};
    return detail::answer(abut_picker_pick_pixel(get(), &camera, x, y, radius, filter.get(), &out), out);
  }
  // Geometries that touch a rectangle, or lie inside, between two opposite corners in pixels.
  [[nodiscard]] Answer<std::vector<GeometryId>> select_rectangle(const Camera& camera, double x0, double y0, double x1,
                                                                 double y1,
                                                                 Selection selection = ABUT_SELECTION_TOUCHING,
                                                                 OptionalRef<abut_query_filter> filter = {}) const {
    return detail::collect<GeometryId>([&](GeometryId* data, std::size_t capacity, std::size_t* count) {
      return abut_picker_select_rectangle(get(), &camera, x0, y0, x1, y1, selection, filter.get(), data, capacity,
                                          count);
    });
  }
  // The nearest vertex, middle of an edge or point of an edge within a radius in pixels.
  [[nodiscard]] Answer<Snap> snap(const Camera& camera, double x, double y, double radius, abut_snap_kinds kinds = 0,
                                  OptionalRef<abut_query_filter> filter = {}) const {
    Snap out{};
    return detail::answer(abut_picker_snap(get(), &camera, x, y, radius, kinds, filter.get(), &out), out);
  }
  // Weights of the corners of a triangle at the point of a pick.
  [[nodiscard]] Answer<Barycentric> barycentric(const Pick& pick) const {
    Barycentric out{};
    return detail::answer(abut_picker_barycentric(get(), pick.geometry, pick.feature.index, &pick.point, &out), out);
  }
  // One pick for each pixel, row by row from the top.
  [[nodiscard]] Answer<std::vector<Pick>> render(const Camera& camera,
                                                 OptionalRef<abut_query_filter> filter = {}) const {
    std::vector<Pick> out(std::size_t{camera.width} * camera.height);
    return detail::answer(abut_picker_render(get(), &camera, filter.get(), out.data(), out.size()), out);
  }

 private:
  explicit Picker(abut_picker* handle) noexcept : handle_(handle) {}

  struct Destroy {
    void operator()(abut_picker* picker) const noexcept { abut_picker_destroy(picker); }
  };
  std::unique_ptr<abut_picker, Destroy> handle_;
};

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
