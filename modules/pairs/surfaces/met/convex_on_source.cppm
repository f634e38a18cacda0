// SPDX-License-Identifier: Apache-2.0
// A convex shape of any kind against a source of triangles.
export module abut.pairs.surfaces.met.convex_on_source;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.surface.bodies_on_surface;
import abut.narrow.surface.triangle_source;
import abut.pairs.shape_handle;

export namespace abut {

// In the frame of the source, which is side a.
void contacts_on_source(const TriangleSource& surface, const AnyShape& body, const Pose& pose,
                        const QuerySettings& settings, Manifold& out);
// False where nothing is overlapped.
[[nodiscard]] bool depth_on_source(const TriangleSource& surface, const AnyShape& body, const Pose& pose,
                                   const QuerySettings& settings, Distance& out);
// One of several shapes that move together. The surface has to outlive it.
[[nodiscard]] std::unique_ptr<BodyOnSurface> body_on_source(const TriangleSource& surface, const AnyShape& body,
                                                            const Pose& pose, const QuerySettings& settings);

}  // namespace abut
