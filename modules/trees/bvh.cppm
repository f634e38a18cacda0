// A bounding volume hierarchy of boxes over the triangles of a mesh: built once by binned surface
// area heuristic (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007),
// stored depth first, so that the left child follows its parent.
export module abut.trees.bvh;
import abut.core.standard;
import abut.math;

export namespace abut {

class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const Aabb> boxes);

  // Calls visit(item) for the items of every leaf whose box overlaps `query`, which visit may shrink.
  template <class Visitor>
  void visit_overlaps(const Aabb& query, Visitor&& visit) const {
    if (nodes_.empty()) {
      return;
    }
    // Depth first without recursion: a node that is missed jumps to the one after its subtree.
    std::uint32_t at = 0;
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      if (!node.box.overlaps(query)) {
        at = node.skip;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i) {
        visit(items_[node.first + i]);
      }
      ++at;
    }
  }

  // First crossing of a ray: `cast(item, limit)` answers the distance to an item, or infinity.
  template <class Caster>
  void visit_ray(const Vec3& origin, const Vec3& direction, Real& limit, Caster&& cast) const {
    const auto inverse_of = [](Real value) { return value == 0 ? infinity : 1 / value; };
    const Vec3 inverse{inverse_of(direction.x), inverse_of(direction.y), inverse_of(direction.z)};
    std::uint32_t at = 0;
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      if (!ray_meets(node.box, origin, inverse, limit)) {
        at = node.skip;
        continue;
      }
      for (std::uint32_t i = 0; i < node.count; ++i) {
        cast(items_[node.first + i]);
      }
      ++at;
    }
  }

  // An item close to a point: down the side whose box is closer.
  [[nodiscard]] std::uint32_t item_near(const Vec3& point) const;

  [[nodiscard]] Aabb bounds() const { return nodes_.empty() ? Aabb::empty() : nodes_[0].box; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + items_.capacity() * sizeof(std::uint32_t);
  }

 private:
  struct Node {
    Aabb box;
    std::uint32_t skip;   // the node after this subtree
    std::uint32_t first;  // of the items of a leaf
    std::uint32_t count;  // 0 for an inner node
    std::uint32_t right;  // of an inner node; the left child is the next node
  };
  struct Build;

  [[nodiscard]] static inline bool ray_meets(const Aabb& box, const Vec3& origin, const Vec3& inverse, Real limit) {
    Real enter = 0, leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
      const Real a = (box.low[axis] - origin[axis]) * inverse[axis];
      const Real b = (box.high[axis] - origin[axis]) * inverse[axis];
      // 0 * infinity on a face that the ray lies in gives NaN: then the slab holds the whole ray.
      const bool within = a != a || b != b;
      const Real near = within ? -infinity : std::min(a, b), far = within ? infinity : std::max(a, b);
      enter = near > enter ? near : enter;
      leave = far < leave ? far : leave;
    }
    return enter <= leave * (1 + 4 * epsilon);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

}  // namespace abut
