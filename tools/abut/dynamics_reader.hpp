// SPDX-License-Identifier: Apache-2.0
// What a scene says of masses and forces: the field "response", and what two materials do where they touch.
#pragma once

#include "scene.hpp"

namespace cli {

void read_response(const std::optional<Node>& node, Scene& scene);

void read_material_pairs(const std::optional<Node>& node, Scene& scene);

}  // namespace cli
