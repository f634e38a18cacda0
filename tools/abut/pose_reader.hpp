// SPDX-License-Identifier: Apache-2.0
// Poses: a position, and an orientation as a quaternion or as an axis and degrees.
#pragma once

#include "node.hpp"
#include "turn.hpp"

namespace cli {

/// Position and orientation from fields of an object; both may be left out.
[[nodiscard]] abut_pose read_pose_fields(Fields& fields);

/// An object that is a pose; the identity where there is none.
[[nodiscard]] abut_pose read_pose(const std::optional<Node>& node);

}  // namespace cli
