// SPDX-License-Identifier: Apache-2.0
// Shapes of any kind that move along a line: when they first touch.
export module abut.pairs.any_shape.casts.shape_cast;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;

export namespace abut {

struct ShapeCastHit {
  Real fraction;     // of the motion: they do not touch before
  Distance contact;  // at that time, in the world
  Feature feature_a{FeatureKind::whole, 0}, feature_b{FeatureKind::whole, 0};
  std::uint32_t child_a = 0, child_b = 0;  // of a composite, or the particle; else 0
};

// When two shapes that move by their displacements first come as near as settings.margin, up to the fraction `most`.
// What touches at the start has fraction 0 and the deepest contact. One-sided triangles let through what comes from
// behind. Nothing is written when they do not touch.
[[nodiscard]] Outcome cast_shapes(const AnyShape& a, const Pose& pose_a, const Vec3& displacement_a, const AnyShape& b,
                                  const Pose& pose_b, const Vec3& displacement_b, const QuerySettings& settings,
                                  Real most, std::optional<ShapeCastHit>& out);

}  // namespace abut
