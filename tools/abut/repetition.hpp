// SPDX-License-Identifier: Apache-2.0
// Many copies of a part from one entry of a scene: a grid, or places chosen by a seed.
#pragma once

#include <string>
#include <vector>

#include "node.hpp"

namespace cli {

struct Copy {
  std::string suffix;  // of the name: "" for a single part, "[2]" or "[2][0][1]" for copies
  abut_pose pose;
};

/// The copies of a part with a pose, from the fields "grid" or "scatter"; one copy when there are none of these.
[[nodiscard]] std::vector<Copy> read_copies(Fields& fields, const abut_pose& pose);

}  // namespace cli
