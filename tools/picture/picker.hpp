// SPDX-License-Identifier: Apache-2.0
// The part of the picking interface that pictures need, wherever its functions come from.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "abut/picking.h"
#include "common/vector.hpp"

namespace tools {

/// Linked, or looked up in a library that was loaded.
struct PickingFunctions {
  decltype(&abut_picker_create) create;
  decltype(&abut_picker_destroy) destroy;
  decltype(&abut_picker_render) render;
  decltype(&abut_picker_cast_rays) cast_rays;
  decltype(&abut_camera_init) camera_init;
  decltype(&abut_camera_look_at) camera_look_at;
  decltype(&abut_camera_ray) camera_ray;
};

/// A picker on a universe, which must live longer. Calls throw Failure; they may run together.
class Picker {
 public:
  Picker(const PickingFunctions& functions, abut_universe* universe);

  /// A camera at `eye` that looks to `target`.
  [[nodiscard]] abut_camera camera(std::uint32_t width, std::uint32_t height, double vertical_fov, const Vec3& eye,
                                   const Vec3& target, const Vec3& up) const;

  /// Through a point of the picture, in pixels from its upper left corner.
  [[nodiscard]] abut_ray ray(const abut_camera& camera, double x, double y) const;

  /// What each pixel sees, row by row.
  [[nodiscard]] std::vector<abut_pick> render(const abut_camera& camera) const;

  /// What each ray meets first.
  [[nodiscard]] std::vector<abut_pick> cast(const std::vector<abut_ray>& rays, abut_coherence coherence) const;

 private:
  PickingFunctions functions_;
  std::unique_ptr<abut_picker, decltype(&abut_picker_destroy)> picker_;
};

}  // namespace tools
