// SPDX-License-Identifier: Apache-2.0
// What a composite is made of.
export module abut.pairs.any_shape.child_list;
import abut.capability;
import abut.core.standard;
import abut.pairs.any_shape;
import abut.pairs.registry;

export namespace abut {

struct ChildDescription {
  PlacedShape placed;
  bool is_hole = false;
  std::uint32_t cut_begin = 0, cut_end = 0;  // of a hole: the solids that it cuts
};

// By their numbers; none for all shapes but composites.
[[nodiscard]] std::vector<ChildDescription> children_of(const AnyShape& shape) {
  std::vector<ChildDescription> out;
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          out.reserve(s.children().size());
          for (const auto& child : s.children()) {
            out.push_back({.placed = {child.shape, child.pose, child.material}});
          }
          for (const auto& hole : s.holes()) {
            out[hole.child].is_hole = true;
            out[hole.child].cut_begin = hole.begin;
            out[hole.child].cut_end = hole.end;
          }
        }
      },
      shape);
  return out;
}

}  // namespace abut
