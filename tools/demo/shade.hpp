// SPDX-License-Identifier: Apache-2.0
// What things look like: light, sky, ground and the colours of bodies.
#pragma once

#include "image.hpp"
#include "scene.hpp"

namespace demo {

/// How much light reaches a point: shares of sun and sky that are not covered, in [0, 1].
struct Light {
  double sun = 1.0;
  double sky = 1.0;
};

/// Unit vector towards the sun.
[[nodiscard]] Vec3 sun_direction();

/// Colour by which bodies of a kind are told apart.
[[nodiscard]] Colour colour_of(Kind kind);

/// Light from the sky along a unit direction.
[[nodiscard]] Colour sky(const Vec3& direction);

/// The unit normal that a hit is lit with, on the side of the viewer; smooth on the terrain.
[[nodiscard]] Vec3 shading_normal(const Scene& scene, const abut_ray& ray, const abut_pick& pick);

/// Light that comes back along a ray from what it met; `pixel` is the width of a pixel at distance 1.
[[nodiscard]] Colour shade(const Scene& scene, const abut_ray& ray, const abut_pick& pick, const Light& light,
                           double pixel);

}  // namespace demo
