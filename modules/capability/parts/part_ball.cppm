// SPDX-License-Identifier: Apache-2.0
// A ball around the origin: a sphere, or one of many particles.
export module abut.capability.parts.part_ball;
import abut.capability.concepts;
import abut.capability.cores.point_core;
import abut.capability.records;
import abut.core.standard;
import abut.math;

export namespace abut {

class Ball : public PointCore {
 public:
  using PointCore::PointCore;

  // The two roots of |origin + t direction| = radius, in the form without cancellation
  // (Haines et al., "Precision improvements for ray/sphere intersection", 2019).
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction,
                                                      Real max_distance) const {
    const Real along = -dot(origin, direction);
    const Vec3 nearest = origin + along * direction.vec();
    const Real under = radius() * radius() - squared_norm(nearest);
    if (under < 0) {
      return std::nullopt;
    }
    const Real half_chord = std::sqrt(under);
    const Real distance = along - half_chord >= 0 ? along - half_chord : along + half_chord;
    if (!(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    const auto normal = UnitVec3::make(origin + distance * direction.vec());
    return RayHit{distance, normal.value_or(direction), {FeatureKind::whole, 0}};
  }
};
static_assert(PointCored<Ball> && RayCastable<Ball>);

}  // namespace abut
