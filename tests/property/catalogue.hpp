// SPDX-License-Identifier: Apache-2.0
// The shapes that the property tests pair with each other: ordinary, tiny, huge, thin, flat and degenerate ones.
#pragma once

#include <vector>

#include "subject.hpp"

namespace property {

[[nodiscard]] std::vector<Subject> convex_subjects();  // spheres, boxes, capsules, hulls
[[nodiscard]] std::vector<Subject> plane_subjects();
[[nodiscard]] std::vector<Subject> surface_subjects();  // meshes and height fields

}  // namespace property
