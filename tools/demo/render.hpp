// SPDX-License-Identifier: Apache-2.0
// The picture: one ray a pixel through the picker, then light, then more rays where the picture has edges.
#pragma once

#include <vector>

#include "image.hpp"
#include "scene.hpp"

namespace demo {

struct Picture {
  Image image;                   // tone-mapped
  std::vector<abut_pick> picks;  // what the ray of each pixel met
};

/// A camera above the slopes on which the bodies lie.
[[nodiscard]] abut_camera make_camera(const Terrain& terrain, std::uint32_t width, std::uint32_t height);

/// Shows progress on the error output.
[[nodiscard]] Picture render(abut_picker* picker, const Scene& scene, const abut_camera& camera);

}  // namespace demo
