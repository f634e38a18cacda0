// SPDX-License-Identifier: Apache-2.0
// A picture: one ray a pixel through the picker, then light, then more rays where the picture has edges.
#pragma once

#include <vector>

#include "common/progress.hpp"
#include "image.hpp"
#include "light.hpp"

namespace tools {

struct Picture {
  Image image;                   // tone-mapped
  std::vector<abut_pick> picks;  // what the ray of each pixel met
};

/// Tells progress on the error output; where that is no terminal, as `elsewhere` says.
[[nodiscard]] Picture render(const Picker& picker, const Look& look, const abut_camera& camera, Elsewhere elsewhere);

}  // namespace tools
