// SPDX-License-Identifier: Apache-2.0
// A tree of boxes is gone down to the items that reach furthest by a measure of boxes.
export module abut.trees.boxes.furthest_first;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// Calls visit(item) for items whose boxes may reach beyond a limit, which visit may raise. Those that reach further
// come first, mostly. `reach_of`: no point of a box reaches further. What is no number may reach anywhere.
template <Hierarchy T, class ReachOf, class Visitor>
void visit_furthest_first(const T& tree, const ReachOf& reach_of, const Real& limit, Visitor&& visit) {
  struct Waiting {
    Real reach;
    std::uint32_t number;
  };
  SmallVector<Waiting, 96> waiting;
  waiting.push_back({infinity, 0});
  while (!waiting.empty()) {
    const Waiting next = waiting[waiting.size() - 1];
    waiting.pop_back();
    if (next.reach <= limit) {
      continue;
    }
    if (EightBoxes::is_item(next.number)) {
      visit(EightBoxes::item_of(next.number));
      continue;
    }
    const std::size_t begin = waiting.size();
    tree.visit_children(next.number, [&](const EightBoxes& eight) {
      for (std::uint32_t left = eight.present(); left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const CompactAabb box = box_of(eight.sides_of_lane(lane));
        const auto corner = [&](const std::array<float, 3>& sides) {
          return tree.origin() +
                 Vec3{static_cast<Real>(sides[0]), static_cast<Real>(sides[1]), static_cast<Real>(sides[2])};
        };
        const Real reach = reach_of(Aabb{corner(box.low), corner(box.high)});
        if (reach <= limit) {
          continue;
        }
        // The one that reaches furthest comes last, and next off the list.
        waiting.push_back({reach, eight.numbers[lane]});
        const std::span<Waiting> list = waiting.span();
        for (std::size_t place = list.size() - 1; place > begin && list[place - 1].reach > list[place].reach; --place) {
          std::swap(list[place - 1], list[place]);
        }
      }
    });
  }
}

}  // namespace abut
