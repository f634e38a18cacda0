// SPDX-License-Identifier: Apache-2.0
#include "picker.hpp"

#include "common/owners.hpp"

namespace tools {

Picker::Picker(const PickingFunctions& functions, abut_universe* universe)
    : functions_(functions), picker_(nullptr, functions.destroy) {
  abut_picker* created = nullptr;
  check(functions_.create(universe, &created), "cannot create the picker");
  picker_.reset(created);
}

abut_camera Picker::camera(std::uint32_t width, std::uint32_t height, double vertical_fov, const Vec3& eye,
                           const Vec3& target, const Vec3& up) const {
  abut_camera camera;
  functions_.camera_init(&camera, sizeof camera);
  camera.width = width;
  camera.height = height;
  camera.vertical_fov = vertical_fov;
  check(functions_.camera_look_at(&camera, &eye, &target, &up), "cannot aim the camera");
  return camera;
}

abut_ray Picker::ray(const abut_camera& camera, double x, double y) const {
  abut_ray result;
  check(functions_.camera_ray(&camera, x, y, &result), "cannot make a ray");
  return result;
}

std::vector<abut_pick> Picker::render(const abut_camera& camera) const {
  std::vector<abut_pick> picks(std::size_t{camera.width} * camera.height);
  check(functions_.render(picker_.get(), &camera, nullptr, picks.data(), picks.size()), "cannot render");
  return picks;
}

std::vector<abut_pick> Picker::cast(const std::vector<abut_ray>& rays, abut_coherence coherence) const {
  std::vector<abut_pick> picks(rays.size());
  if (!rays.empty()) {
    check(functions_.cast_rays(picker_.get(), rays.data(), rays.size(), coherence, nullptr, picks.data()),
          "cannot cast rays");
  }
  return picks;
}

}  // namespace tools
