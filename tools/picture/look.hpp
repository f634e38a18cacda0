// SPDX-License-Identifier: Apache-2.0
// What the things of a picture look like.
#pragma once

#include "abut/picking.h"
#include "common/vector.hpp"
#include "image.hpp"

namespace tools {

/// How much light reaches a point: shares of sun and sky that are not covered, in [0, 1].
struct Light {
  double sun = 1.0;
  double sky = 1.0;
};

/// Lengths of the rays that look for light.
struct Reach {
  double lift;  // by which they start off the surface
  double sky;   // in which something covers the sky
  double sun;   // in which something covers the sun
};

class Look {
 public:
  Look() = default;
  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;
  virtual ~Look() = default;

  /// Unit vector towards the sun.
  [[nodiscard]] virtual Vec3 sun() const = 0;

  [[nodiscard]] virtual Reach reach() const = 0;

  /// The unit normal that a hit is lit with, on the side of the viewer.
  [[nodiscard]] virtual Vec3 normal(const abut_ray& ray, const abut_pick& pick) const = 0;

  /// Light that comes back along a ray from what it met; `pixel` is the width of a pixel at distance 1.
  [[nodiscard]] virtual Colour shade(const abut_ray& ray, const abut_pick& pick, const Light& light,
                                     double pixel) const = 0;

  /// Whether what a ray towards the sun met casts no shadow on where the ray came from.
  [[nodiscard]] virtual bool lets_through(const abut_pick& from, const abut_pick& hit) const = 0;
};

}  // namespace tools
