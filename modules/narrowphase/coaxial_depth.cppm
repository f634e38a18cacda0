// Depth of overlap of two bodies of revolution around one axis, whose outlines are polygons: that of both outlines in a plane
// through the axis, where the least overlap is along the normal of an edge of one of them.
export module abut.narrowphase.coaxial_depth;
import abut.core.standard;
import abut.math;
import abut.narrowphase.depth_minimum;
import abut.shape;
import abut.shape.germ;

export namespace abut {

// A segment along Z counts as a cylinder without radius.
template <class S>
concept Outlined = SegmentCored<S> || (Convex<S> && requires(const S& shape) {
  { shape.outline_normals() } -> std::same_as<OutlineNormals>;
});
template <Outlined S>
[[nodiscard]] inline OutlineNormals outline_normals_of(const S& shape) {
  if constexpr (SegmentCored<S>) {
    return {{{1, 0}, {0, 1}, {0, -1}}};
  } else {
    return shape.outline_normals();
  }
}

// Whether two axes differ by rounding only.
[[nodiscard]] inline bool is_coaxial(const Pose& ab, Real noise) {
  const Vec3& axis = ab.rotation.z;
  const Real tilt = std::fabs(axis.x) + std::fabs(axis.y), aside = std::fabs(ab.position.x) + std::fabs(ab.position.y);
  return tilt <= 4 * epsilon && aside <= noise;
}

// Nothing where the axes differ by more than that, or where no points are found under the normal.
template <Outlined A, Outlined B>
[[nodiscard]] std::optional<DepthMinimum> coaxial_minimum(const A& a, const B& b, const Pose& ab, Real error, Real noise) {
  if (!is_coaxial(ab, noise)) {
    return std::nullopt;
  }
  const auto placement = place(b, ab);
  Vec3 best{0, 0, 0};
  Real least = infinity;
  const auto try_normal = [&](const OutlineNormal& normal, Real up) {
    const Vec3 n{normal.out, 0, up * normal.up};
    if (!(squared_norm(n) > 0)) {
      return;
    }
    const Real depth = depth_along(a, b, placement, n);
    if (depth < least) {
      least = depth;
      best = n;
    }
  };
  for (const OutlineNormal& normal : outline_normals_of(a)) {
    try_normal(normal, 1);
  }
  for (const OutlineNormal& normal : outline_normals_of(b)) {
    try_normal(normal, -std::copysign(Real{1}, ab.rotation.z.z));
  }
  const auto unit = UnitVec3::make(best);
  if (!unit || !(least > noise)) {
    return std::nullopt;
  }
  return points_under(a, b, ab, *unit, error, noise);
}

}  // namespace abut
