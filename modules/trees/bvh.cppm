// A bounding volume hierarchy of boxes over the triangles of a mesh: built once by binned surface
// area heuristic (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007),
// stored depth first, so that the left child follows its parent. Boxes are kept in single precision, rounded outward.
export module abut.trees.bvh;
import abut.core.standard;
import abut.math;
import abut.trees.ray_slabs;

export namespace abut {

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const Aabb> boxes);

  // Calls visit(item) for the items of every leaf whose box overlaps `query`, within rounding. visit may shrink
  // `query`.
  template <class Visitor>
  void visit_overlaps(const Aabb& query, Visitor&& visit) const {
    if (nodes_.empty()) {
      return;
    }
    CompactAabb box = compact(query, origin_);
    [[clang::uninitialized]] std::array<std::uint32_t, most_levels> waiting;
    waiting[0] = 0;
    for (std::size_t count = 1; count > 0;) {
      const std::uint32_t at = waiting[--count];
      const Node& node = nodes_[at];
      if (!node.box.overlaps(box)) {
        continue;
      }
      if (node.count == 0) {
        waiting[count++] = node.next;
        waiting[count++] = at + 1;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i) {
        visit(items_[node.next + i]);
      }
      box = compact(query, origin_);
    }
  }

  // Calls cast(item) for the items of every leaf whose box a ray meets within `limit`, which cast may lower. Of two
  // boxes the one that the ray enters first comes first.
  template <class Caster>
  void visit_ray(const Vec3& origin, const Vec3& direction, Real& limit, Caster&& cast) const {
    if (nodes_.empty()) {
      return;
    }
    const RaySlabs ray(origin - origin_, direction, {bounds_.low - origin_, bounds_.high - origin_});
    struct Waiting {
      std::uint32_t node;
      RaySlabs::Stretch stretch;
    };
    [[clang::uninitialized]] std::array<Waiting, most_levels> waiting;
    waiting[0] = {0, ray.within(in_double(nodes_[0].box), {0, limit})};
    for (std::size_t count = 1; count > 0;) {
      const Waiting next = waiting[--count];
      if (next.stretch.until(limit).is_empty()) {
        continue;
      }
      std::uint32_t at = next.node;
      while (nodes_[at].count == 0) {
        const std::uint32_t right = nodes_[at].next;
        Waiting near{at + 1, ray.within(in_double(nodes_[at + 1].box), {0, limit})},
            far{right, ray.within(in_double(nodes_[right].box), {0, limit})};
        if (near.stretch.is_empty() || (!far.stretch.is_empty() && far.stretch.enter < near.stretch.enter)) {
          std::swap(near, far);
        }
        if (near.stretch.is_empty()) {
          break;
        }
        if (!far.stretch.is_empty()) {
          waiting[count++] = far;
        }
        at = near.node;
      }
      for (std::uint32_t i = 0; i < nodes_[at].count; ++i) {
        cast(items_[nodes_[at].next + i]);
      }
    }
  }

  // An item close to a point: down the side whose box is closer.
  [[nodiscard]] std::uint32_t item_near(const Vec3& point) const;

  [[nodiscard]] Aabb bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(std::uint32_t);
  }

 private:
  struct Node {
    CompactAabb box;      // relative to the origin
    std::uint32_t next;   // the first item of a leaf, or the right child; the left child follows its parent
    std::uint32_t count;  // of the items of a leaf; 0 for an inner node
  };
  static_assert(sizeof(Node) == 32);
  struct Build;

  // Halves of halves end within 32 levels; before that, cuts by surface area may be uneven.
  static constexpr std::size_t most_uneven_levels = 64, most_levels = most_uneven_levels + 36;

  Aabb bounds_ = Aabb::empty();
  Vec3 origin_{0, 0, 0};  // the middle of the bounds
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

}  // namespace abut
