// SPDX-License-Identifier: Apache-2.0
// What things look like: light, sky, ground and the colours of bodies.
#pragma once

#include "picture/look.hpp"
#include "scene.hpp"

namespace demo {

/// Colour by which bodies of a kind are told apart.
[[nodiscard]] Colour colour_of(Kind kind);

/// The hillside of the demo in the light of the evening. The scene must live longer.
class Hillside : public Look {
 public:
  explicit Hillside(const Scene& scene) : scene_(&scene) {}

  [[nodiscard]] Vec3 sun() const override;
  [[nodiscard]] Reach reach() const override { return {.lift = 0.25, .sky = 160.0, .sun = 40'000.0}; }
  [[nodiscard]] Vec3 normal(const abut_ray& ray, const abut_pick& pick) const override;
  [[nodiscard]] Colour shade(const abut_ray& ray, const abut_pick& pick, const Light& light,
                             double pixel) const override;
  [[nodiscard]] bool lets_through(const abut_pick& from, const abut_pick& hit) const override;

 private:
  const Scene* scene_;
};

}  // namespace demo
