// SPDX-License-Identifier: Apache-2.0
// A bounding volume hierarchy of boxes that stay, such as those of the triangles of a mesh: a tree of boxes about the
// middle of all, so that single precision loses little far from the origin.
export module abut.trees.bvh;
import abut.core.standard;
import abut.math;
import abut.trees.box_heights;
import abut.trees.box_sweep;
import abut.trees.box_tree;
import abut.trees.eight_boxes;

export namespace abut {

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const Aabb> boxes);

  // Calls visit(item) for the items whose boxes overlap `query`, within rounding. visit may shrink `query`.
  template <class Visitor>
  void visit_overlaps(const Aabb& query, Visitor&& visit) const {
    tree_.visit_within([&] { return limits_of(compact(query, origin_)); }, visit);
  }

  // Calls cast(item) for the items whose boxes a ray meets within `limit`, which cast may lower. Nearer nodes come
  // first.
  template <class Caster>
  void visit_ray(const Vec3& origin, const Vec3& direction, Real& limit, Caster&& cast) const {
    tree_.sweep(CompactSweep(BoxSweep(origin - origin_, {0, 0, 0}, direction)), limit, [&](std::uint32_t item) {
      cast(item);
      return limit;
    });
  }

  // Calls visit(item) for the items whose boxes reach down to `limit` along a direction, which visit may lower. Lower
  // nodes come first.
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    const Real base = dot(direction, origin_);
    tree_.sweep(BoxHeights(direction), limit - base, [&](std::uint32_t item) {
      visit(item);
      return limit - base;
    });
  }

  // An item close to a point. There are items.
  [[nodiscard]] std::uint32_t item_near(const Vec3& point) const;

  [[nodiscard]] Aabb bounds() const { return bounds_; }

 private:
  Aabb bounds_ = Aabb::empty();
  Vec3 origin_{0, 0, 0};  // the middle of the bounds
  BoxTree tree_;
};

}  // namespace abut
