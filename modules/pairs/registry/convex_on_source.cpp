// SPDX-License-Identifier: Apache-2.0
module abut.pairs.registry.convex_on_source;
import abut.capability;
import abut.math;
import abut.narrow.many.flat_ground;
import abut.narrow.many.surface_kernels;
import abut.narrow.many.surfaces;
import abut.narrow.many.triangle_source;
import abut.pairs.registry;
import abut.pairs.registry.children;

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

}  // namespace abut
