// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape.casts.ray_child;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace abut {

std::uint32_t child_on_ray(const AnyShape& shape, const Vec3& origin, const UnitVec3& direction, Real distance) {
  return std::visit(
      [&]<class S>(const S& s) -> std::uint32_t {
        if constexpr (Assembly<S>) {
          std::uint32_t nearest = 0;
          Real least = infinity;
          const Real slack = 256 * epsilon * (largest_magnitude(origin) + distance);
          const Real start = std::max(distance - slack, Real{0});
          const Vec3 from = origin + start * direction.vec();
          const auto try_child = [&](std::uint32_t number) {
            const auto& child = s.children()[number];
            const UnitVec3 turned = UnitVec3::make(child.pose.rotation.undo(direction)).value_or(direction);
            const auto hit = cast_ray(*child.shape, child.pose.undo(from), turned, 2 * slack);
            const Real off = hit ? std::fabs(start + hit->distance - distance) : infinity;
            if (off < least || (hit && off == least && number < nearest)) {
              least = off;
              nearest = number;
            }
          };
          s.visit_children(Aabb{from, from}.inflated(4 * slack), try_child);
          for (const auto& hole : s.holes()) {
            try_child(hole.child);
          }
          return nearest;
        } else {
          return 0;
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

}  // namespace abut
