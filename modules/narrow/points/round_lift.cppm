// SPDX-License-Identifier: Apache-2.0
// From corners of the region that two cores share to the surfaces of the rounded shapes.
export module abut.narrow.points.round_lift;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.points.clip;

export namespace abut {

// Lifts points of a core along a unit direction, so that both points of a contact lie on the surfaces and across each
// other. A segment that leans is lifted through its side: its upper end by radius / sine of the angle to the axis.
template <Convex S>
class RoundLift {
 public:
  // `direction` is in the frame that `placed` puts the shape in. `is_a`: which features of a corner are those of the
  // shape.
  RoundLift(const S& shape, const Pose& placed, const Vec3& direction, bool is_a)
      : radius_(shape.radius()), placed_(placed), direction_(placed.rotation.undo(direction)), is_a_(is_a) {
    if constexpr (SegmentCored<S>) {
      half_ = shape.half().z;
    }
  }
  // How far a corner of the region is from the surface; nothing where the way leaves through the ball around an end
  // that is a corner by itself. So it is in a segment that nearly stands: the contact is that of the end.
  [[nodiscard]] inline std::optional<Real> operator()(const ClipPoint& corner, const Vec3& point,
                                                      std::span<const ClipPoint> region) const {
    if constexpr (SegmentCored<S>) {
      if (radius_ > 0) {
        return through_side(corner, point, region);
      }
    }
    return radius_;
  }

 private:
  [[nodiscard]] inline Feature own(const ClipPoint& corner) const {
    return is_a_ ? corner.feature_a : corner.feature_b;
  }
  [[nodiscard]] std::optional<Real> through_side(const ClipPoint& corner, const Vec3& point,
                                                 std::span<const ClipPoint> region) const {
    const Feature its = own(corner), lower{FeatureKind::vertex, direction_.z >= 0 ? 1u : 0u};
    if (its == lower) {
      return radius_;
    }
    const Real z = its.kind == FeatureKind::vertex ? std::copysign(half_, -direction_.z) : placed_.undo(point).z;
    const RoundReach found = reach_of_round_segment(half_, radius_, z, direction_);
    const auto is_lower = [&](const ClipPoint& other) { return own(other) == lower; };
    return found.is_of_other_end && std::ranges::any_of(region, is_lower) ? std::nullopt : std::optional(found.reach);
  }

  Real radius_, half_ = 0;
  Pose placed_;
  Vec3 direction_;
  bool is_a_;
};

}  // namespace abut
