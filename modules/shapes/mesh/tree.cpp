// SPDX-License-Identifier: Apache-2.0
// Trees of oriented boxes or of balls, for meshes that ask for one.
module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.boxes.volume_tree;

namespace abut {

const Mesh::OtherTree& Mesh::other() const {
  return data_->other.get([this] {
    const auto corners_of = [this](std::uint32_t index) { return present_corners(index); };
    return data_->chosen == ChosenTree::balls ? OtherTree(SphereTree(triangle_count(), corners_of))
                                              : OtherTree(OrientedBoxTree(triangle_count(), corners_of));
  });
}

void Mesh::visit_in_other(const Aabb& box, const VisitItem& visit) const {
  std::visit([&](const auto& tree) { tree.visit_overlaps(box, visit); }, other());
}
void Mesh::visit_below_in_other(const Vec3& direction, Real& limit, const VisitItem& visit) const {
  std::visit([&](const auto& tree) { tree.visit_below(direction, limit, visit); }, other());
}
void Mesh::visit_ray_in_other(const Vec3& origin, const Vec3& direction, Real& limit, const VisitItem& visit) const {
  std::visit([&](const auto& tree) { tree.visit_ray(origin, direction, limit, visit); }, other());
}
std::uint32_t Mesh::item_near_in_other(const Vec3& point) const {
  return std::visit([&](const auto& tree) { return tree.item_near(point); }, other());
}

// The tree of boxes tells what a change reaches. So a mesh that has another tree and changes has both.
void Mesh::make_room_in_other() {
  if (std::optional<OtherTree>& other = data_.own().other.made()) {
    static_cast<void>(tree());
    std::visit([](auto& its) { its.make_room(); }, *other);
  }
}

void Mesh::touch_in_other(std::uint32_t triangle) {
  if (std::optional<OtherTree>& other = data_.own().other.made()) [[unlikely]] {
    std::visit([&](auto& its) { its.touch(triangle); }, *other);
  }
}

void Mesh::settle_other() {
  Data& data = data_.own();
  std::optional<OtherTree>& other = data.other.made();
  if (!other) {
    return;
  }
  std::visit([&](auto& its) { its.settle([this](std::uint32_t index) { return present_corners(index); }); }, *other);
  if (std::visit([](const auto& its) { return its.is_worn(); }, *other)) {
    data.other.forget();
  }
}

}  // namespace abut
