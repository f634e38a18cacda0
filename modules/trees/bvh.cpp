// SPDX-License-Identifier: Apache-2.0
module abut.trees.bvh;
import abut.core.standard;
import abut.math;
import abut.trees.box_tree;

namespace abut {

Bvh::Bvh(std::span<const Aabb> boxes) {
  for (const Aabb& box : boxes) {
    bounds_.include(box);
  }
  origin_ = boxes.empty() ? origin_ : bounds_.centre();
  std::vector<CompactAabb> compact_boxes;
  compact_boxes.reserve(boxes.size());
  for (const Aabb& box : boxes) {
    compact_boxes.push_back(compact(box, origin_));
  }
  tree_ = BoxTree(compact_boxes);
}

std::uint32_t Bvh::item_near(const Vec3& point) const {
  const Aabb place{point, point};
  return tree_.leaf_near(compact(place, origin_).low);
}

}  // namespace abut
