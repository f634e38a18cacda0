// SPDX-License-Identifier: Apache-2.0
#include "failures.hpp"
#include "picture.hpp"

namespace cli {

void draw_scene(const Arguments& /*arguments*/) {
  throw BadInput("this build draws no pictures; expected one that was configured with the feature picking");
}

}  // namespace cli
