// SPDX-License-Identifier: Apache-2.0
module abut.pairs.taken_apart.shape_parts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.registry;

namespace abut {

const ShapeTraits& traits_of(const AnyShape& shape) {
  static constexpr auto traits = []<std::size_t... Places>(std::index_sequence<Places...>) {
    return std::array{ShapeTraits{HalfSpace<Shapes::At<Places>>, Assembly<Shapes::At<Places>>,
                                  Hole<Shapes::At<Places>> || SampledSolid<Shapes::At<Places>>,
                                  Surface<Shapes::At<Places>> || Scattered<Shapes::At<Places>>,
                                  Surface<Shapes::At<Places>>}...};
  }(std::make_index_sequence<Shapes::count>{});
  return traits[shape.index()];
}

void visit_parts(const AnyShape& shape, const Aabb& near, const VisitPart& visit) {
  Aabb box = near;
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Surface<S>) {
          s.visit_parts(box, [&](const Triangle& part, std::uint32_t) {
            visit(ConvexPart::of(part), Pose::identity(), std::uint32_t{0});
          });
        } else if constexpr (Scattered<S>) {
          s.visit_places(box, [&](const Vec3& place, std::uint32_t index) {
            visit(ConvexPart::of(s.part(index)), Pose{Rotation::identity(), place}, index);
          });
        } else if (const auto part = ConvexPart::of(shape)) {
          visit(*part, Pose::identity(), std::uint32_t{0});
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

void visit_children(const AnyShape& shape, const Aabb& near, const VisitChild& visit) {
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          s.visit_children(near, [&](std::uint32_t child) {
            const auto& its = s.children()[child];
            visit(*its.shape, its.pose, child);
          });
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

}  // namespace abut
