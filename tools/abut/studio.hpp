// SPDX-License-Identifier: Apache-2.0
// What the geometries of a scene look like: a colour for each kind, and a grid on planes.
#pragma once

#include "picture/look.hpp"
#include "view.hpp"
#include "world.hpp"

namespace cli {

/// Colour by which a kind of shape is told apart.
[[nodiscard]] Colour colour_of(abut_shape_kind kind);

/// Lit from above and from the left. The world must live longer.
class Studio : public Look {
 public:
  Studio(const World& world, const View& view);

  [[nodiscard]] Vec3 sun() const override { return sun_; }
  [[nodiscard]] Reach reach() const override;
  [[nodiscard]] Vec3 normal(const abut_ray& ray, const abut_pick& pick) const override;
  [[nodiscard]] Colour shade(const abut_ray& ray, const abut_pick& pick, const Light& light,
                             double pixel) const override;
  [[nodiscard]] bool lets_through(const abut_pick& from, const abut_pick& hit) const override;

 private:
  [[nodiscard]] Colour background(const Vec3& direction) const;
  [[nodiscard]] Colour surface(const abut_pick& pick, double footprint) const;

  const World* world_;
  View view_;
  Vec3 sun_;
};

}  // namespace cli
