// SPDX-License-Identifier: Apache-2.0
// How far a point lies from the surface of a convex solid, from formulas of the solid alone.
#pragma once

#include <abut/abut.h>

#include "solids.hpp"

namespace property {

// Negative inside. Exact outside of cylinders and cones up to rounding; of ellipsoids to first order in the residual.
[[nodiscard]] double surface_residual(const SolidSubject& solid, const abut_pose& pose, const abut_vec3& point);

}  // namespace property
