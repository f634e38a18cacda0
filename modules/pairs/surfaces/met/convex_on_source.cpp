// SPDX-License-Identifier: Apache-2.0
module abut.pairs.surfaces.met.convex_on_source;
import abut.capability;
import abut.math;
import abut.core.standard;
import abut.narrow.surface.bodies_on_surface;
import abut.narrow.surface.flat_ground;
import abut.narrow.surface.surface_kernels;
import abut.narrow.surface.surfaces;
import abut.narrow.surface.triangle_source;
import abut.pairs.registry;
import abut.pairs.composites.children;

namespace abut {

void contacts_on_source(const TriangleSource& surface, const AnyShape& body, const Pose& pose,
                        const QuerySettings& settings, Manifold& out) {
  with_core(body, [&](const auto& core) { contacts_on_surface(surface, core, pose, settings, out); });
}

bool depth_on_source(const TriangleSource& surface, const AnyShape& body, const Pose& pose,
                     const QuerySettings& settings, Distance& out) {
  bool is_overlapped = false;
  with_core(body, [&](const auto& core) {
    is_overlapped =
        flat_distance(surface, core, pose, settings, out) || surface_depth(surface, core, pose, settings, out);
  });
  return is_overlapped;
}

std::unique_ptr<BodyOnSurface> body_on_source(const TriangleSource& surface, const AnyShape& body, const Pose& pose,
                                              const QuerySettings& settings) {
  std::unique_ptr<BodyOnSurface> found;
  with_core(body, [&](const auto& core) { found = body_on_surface(surface, core, pose, settings); });
  return found;
}

}  // namespace abut
