// SPDX-License-Identifier: Apache-2.0
// A convex shape against a surface that is a source of triangles. Whoever asks sees these declarations alone: the
// registry has them compiled once for each kind of core.
export module abut.narrow.surface.surface_kernels;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.surface.bodies_on_surface;
import abut.narrow.surface.triangle_source;

export namespace abut {

// Contacts within the margin, as if nothing were behind the surface.
template <Convex B>
void surface_contacts(const TriangleSource& surface, const B& b, const Pose& ab, const QuerySettings& settings,
                      Manifold& out);

// The shortest translation found that ends the overlap, as a distance. False where nothing is overlapped.
template <Convex B>
[[nodiscard]] bool surface_depth(const TriangleSource& surface, const B& b, const Pose& ab,
                                 const QuerySettings& settings, Distance& out);

// One of several shapes that move together. The surface has to outlive it.
template <Convex B>
[[nodiscard]] std::unique_ptr<BodyOnSurface> body_on_surface(const TriangleSource& surface, const B& b, const Pose& ab,
                                                             const QuerySettings& settings);

}  // namespace abut
