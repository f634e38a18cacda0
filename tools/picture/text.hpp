// SPDX-License-Identifier: Apache-2.0
// Text in straight strokes. Capital letters, digits and a few signs; small letters are drawn as capitals.
#pragma once

#include <string_view>

#include "image.hpp"

namespace tools {

/// Writes with the upper left corner at (x, y), letters `height` pixels tall.
void draw_text(Image& image, double x, double y, double height, std::string_view text, const Colour& colour);

/// Width of that text in pixels.
[[nodiscard]] double text_width(std::string_view text, double height);

}  // namespace tools
