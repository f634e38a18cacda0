// SPDX-License-Identifier: Apache-2.0
// Several convex shapes that move as one body: the children of a composite, or particles. A way out of a surface that
// one of them takes by itself may lead another one into it.
export module abut.narrow.surface.bodies_on_surface;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.triangle.stopping_sides;
import abut.narrow.ways.translation_search;

export namespace abut {

// One of them.
class BodyOnSurface {
 public:
  BodyOnSurface() = default;
  BodyOnSurface(const BodyOnSurface&) = delete;
  BodyOnSurface& operator=(const BodyOnSurface&) = delete;
  virtual ~BodyOnSurface() = default;

  [[nodiscard]] virtual Vec3 centre() const = 0;
  // Whether it overlaps a triangle, or is in a solid.
  [[nodiscard]] virtual bool is_met() const = 0;
  // What is known of its own way out. To be called before the others, which are only called where some shape is met.
  [[nodiscard]] virtual TranslationSearch begin() = 0;
  // The end of the overlap along a direction, no earlier than at `from`. See Obstacles.
  [[nodiscard]] virtual SurfaceExit exit_along(const Vec3& direction, Real from, Real enough) = 0;
  // What it would try by itself.
  [[nodiscard]] virtual Obstacles& obstacles() = 0;
  // The point of it, where it is, that is last to leave the surface.
  [[nodiscard]] virtual Vec3 last_point(const SeparatingTranslation& translation) const = 0;
};

using BodiesOnSurface = std::vector<std::unique_ptr<BodyOnSurface>>;

// The shortest translation found after which none overlaps the surface, in the frame of the surface, which is side a.
// False where none is met.
[[nodiscard]] bool depth_of_bodies(const BodiesOnSurface& bodies, StoppingSides sides, Distance& out);

// The same for bodies within a reach: a longer translation than that may lead past others, which are taken in then.
// `depth`: of the deepest by itself. `gather(reach, take)` returns take(bodies, a count that grows with what is in
// reach). False also for a single body.
template <class Gather>
[[nodiscard]] bool depth_within_reach(Real depth, StoppingSides sides, Gather&& gather, Distance& out) {
  // The way of all is mostly little longer than that of the deepest.
  constexpr Real further = 2;
  Real reach = further * depth;
  bool is_found = false;
  for (std::size_t known = 0;;) {
    const bool are_more = gather(reach, [&](const BodiesOnSurface& bodies, std::size_t count) {
      return bodies.size() > 1 && std::exchange(known, count) != count && depth_of_bodies(bodies, sides, out);
    });
    is_found = is_found || are_more;
    if (!are_more || -out.distance <= reach) {
      return is_found;
    }
    reach = further * -out.distance;
  }
}

}  // namespace abut
