// SPDX-License-Identifier: Apache-2.0
// Two surfaces that are sources of triangles: how deep they are in each other, and where they touch. Compiled once for
// all kinds of surfaces.
export module abut.narrow.two_surfaces.two_sources;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.surface.triangle_source;

export namespace abut {

// The shortest translation found that ends the overlap, as a distance. False where nothing is overlapped.
[[nodiscard]] bool depth_of_surfaces(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab,
                                     const QuerySettings& settings, Distance& out);

// Contacts within the margin, as if nothing were behind the surfaces.
void contacts_of_surfaces(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, const QuerySettings& settings,
                          Manifold& out);

}  // namespace abut
