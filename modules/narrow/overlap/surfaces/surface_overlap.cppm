// SPDX-License-Identifier: Apache-2.0
// Whether a surface overlaps another shape: the first triangle that does ends the search.
export module abut.narrow.overlap.surfaces.surface_overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.surface.triangle_source;
import abut.narrow.overlap.convex_overlap;
import abut.narrow.overlap.surfaces.core_among_triangles;

export namespace abut {

// Whether a triangle of a surface is within `reach` of a convex core, or the core is inside. The core is placed by ab
// in the frame of the surface. `reach`: not negative.
[[nodiscard]] Met meets(const SurfaceSource& surface, CoreAmongTriangles& core, const Pose& ab, Real reach,
                        Fronts fronts);
// The same of two surfaces.
[[nodiscard]] Met meets(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, Real reach, Fronts fronts);

template <Surface A, Convex B>
[[nodiscard]] Met surface_meets(const A& a, const B& b, const Pose& ab, Real reach, Fronts fronts) {
  PlacedCore<B> core(b);
  return meets(SourceOf<A>(a), core, ab, reach, fronts);
}
template <Surface A, Surface B>
[[nodiscard]] Met surface_meets(const A& a, const B& b, const Pose& ab, Real reach, Fronts fronts) {
  return meets(SourceOf<A>(a), SourceOf<B>(b), ab, reach, fronts);
}

}  // namespace abut
