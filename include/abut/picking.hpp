// SPDX-License-Identifier: Apache-2.0
// Rays and the mouse against a universe, through Embree: picking.h for C++17 and newer. Link libabut_picking as well.
#ifndef ABUT_PICKING_HPP
#define ABUT_PICKING_HPP

#include <abut/abut.hpp>
#include <abut/picking.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut {

using Pick = abut_pick;
using Coherence = abut_coherence_value;

inline namespace ABUT_ANSWERS {

// A pinhole camera that looks along its local -Z, with local +Y up.
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

  // Turns the camera from `eye` to `target`, with `up` upwards in the picture.
  Answer<void> look_at(Vec3 eye, Vec3 target, Vec3 up = {0, 0, 1}) {
    return detail::answer(abut_camera_look_at(this, &eye, &target, &up));
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
