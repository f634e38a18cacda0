// SPDX-License-Identifier: Apache-2.0
// Particles on a surface: all of them leave it together.
export module abut.narrow.surface.particles_on_surface;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.surface.bodies_on_surface;
import abut.narrow.surface.surface_kernels;
import abut.narrow.surface.triangle_source;

export namespace abut {

// Adds those that a move of length `reach` may bring to a triangle. `pose`: of the particles in the frame of the
// surface, which has to outlive the bodies.
template <Scattered A>
void add_near_particles(const A& particles, const Pose& pose, const TriangleSource& surface, Real reach,
                        const QuerySettings& settings, BodiesOnSurface& bodies) {
  Aabb around = transformed(surface.box().inflated(reach), pose.inverse());
  std::vector<std::uint32_t> found;
  particles.visit_places(around, [&](const Vec3&, std::uint32_t index) { found.push_back(index); });
  std::ranges::sort(found);
  for (const std::uint32_t index : found) {
    const auto part = particles.part(index);
    const auto& ball = core_of(part);
    const Pose placed{pose.rotation, pose * particles.place(index)};
    const Aabb box = ball.aabb(placed).inflated(reach);
    bool is_near = false;
    surface.visit(box, [&](const FourTriangles& four, std::uint64_t present) {
      is_near = (present & four.overlapping(box)) != 0;
      return !is_near;
    });
    if (is_near) {
      bodies.push_back(body_on_surface(surface, ball, placed, settings));
    }
  }
}

// `depth`: of the deepest by itself. False where none counts as overlapping, and where one stands alone.
template <Scattered A, Surface B>
[[nodiscard]] bool depth_of_particles(const A& particles, const Pose& pose, const B& shape, Real depth,
                                      const QuerySettings& settings, Distance& out) {
  const SourceOf<B> surface(shape);
  const auto gather = [&](Real reach, auto&& take) {
    BodiesOnSurface bodies;
    add_near_particles(particles, pose, surface, reach, settings, bodies);
    return take(bodies, bodies.size());
  };
  return depth_within_reach(depth, surface.sides(), gather, out);
}

}  // namespace abut
