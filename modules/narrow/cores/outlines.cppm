// Bodies of revolution by their outlines, which are polygons: around one axis two of them overlap least across an edge
// of one.
export module abut.narrow.cores.outlines;
import abut.capability.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// A segment along Z counts as a cylinder without radius.
template <class S>
inline constexpr bool is_outlined = SegmentCored<S> || requires(const S& shape) { shape.outline_normals(); };
template <Convex S>
  requires is_outlined<S>
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

// Unit directions across the outlines, out of a, in the plane of X and Z.
template <Convex A, Convex B, class Directions>
  requires(is_outlined<A> && is_outlined<B>)
void collect_outlines(const A& a, const B& b, const Pose& ab, Directions& directions) {
  const auto add = [&](const OutlineNormal& normal, Real up) {
    const Vec3 n{normal.out, 0, up * normal.up};
    if (squared_norm(n) > 0) {
      directions.push_back(n);
    }
  };
  for (const OutlineNormal& normal : outline_normals_of(a)) {
    add(normal, 1);
  }
  for (const OutlineNormal& normal : outline_normals_of(b)) {
    add(normal, -std::copysign(Real{1}, ab.rotation.z.z));
  }
}

}  // namespace abut
