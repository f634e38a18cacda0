// SPDX-License-Identifier: Apache-2.0
// A binary tree over triangles, of one volume for each node: oriented boxes or balls. Triangles stay with their owner,
// who tells their corners when the tree is made and when it is fitted.
//
// Boxes along the axes are the default (bvh). On terrain and on a bent tube of 131,000 triangles, boxes and rays took
// 2.3 to 32 times as long with oriented boxes, and 1 to 15 times with balls. Two surfaces use the default tree in any
// case.
export module abut.trees.boxes.volume_tree;
import abut.capability.parts.item_tree;
import abut.core.standard;
import abut.math;
export import abut.trees.volumes.bounding_ball;
export import abut.trees.volumes.oriented_box;

export namespace abut {

template <BoundingVolume Volume>
class VolumeTree {
 public:
  static constexpr std::uint32_t nobody = 0xffffffff;
  static constexpr std::uint32_t most_in_leaf = 4;

  VolumeTree() = default;
  // `corners_of` tells the corners of a triangle, or nothing where it is not there. Halves are as large as each other,
  // across the longest side of the box around the middles. O(n log n).
  template <class CornersOf>
  VolumeTree(std::size_t count, const CornersOf& corners_of) : leaves_(count, nobody) {
    std::vector<Vec3> middles(count);
    for (std::uint32_t item = 0; item < count; ++item) {
      if (const std::optional<std::array<Vec3, 3>> corners = corners_of(item)) {
        items_.push_back(item);
        middles[item] = (Real{1} / 3) * ((*corners)[0] + (*corners)[1] + (*corners)[2]);
      }
    }
    if (!items_.empty()) {
      split(0, static_cast<std::uint32_t>(items_.size()), nobody, middles, corners_of);
    }
    for (const Node& node : nodes_) {
      count_surface(node, 1);
    }
    first_surface_ = relative_surface();
  }

  template <class Visitor>
  void visit_overlaps(const Aabb& query, Visitor&& visit) const {
    std::array<std::uint32_t, most_waiting> waiting;
    std::size_t count = start(waiting);
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      if (!node.volume.overlaps(query)) {
        continue;
      }
      if (node.is_leaf()) {
        visit_items(node, visit);
      } else {
        waiting[count++] = node.second;
        waiting[count++] = first_below(node);
      }
    }
  }
  template <class Caster>
  void visit_ray(const Vec3& origin, const Vec3& direction, Real& limit, Caster&& cast) const {
    descend([&](const Volume& volume) { return volume.entry_of(origin, direction); }, limit, cast);
  }
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    descend([&](const Volume& volume) { return volume.lowest_along(direction); }, limit, visit);
  }
  [[nodiscard]] std::uint32_t item_near(const Vec3& point) const {
    std::uint32_t at = 0;
    while (!nodes_[at].is_leaf()) {
      const std::uint32_t first = at + 1, second = nodes_[at].second;
      at = nodes_[second].volume.distance_to(point) < nodes_[first].volume.distance_to(point) ? second : first;
    }
    return items_[nodes_[at].first];
  }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + stale_.capacity() * sizeof(std::uint64_t) +
           (items_.capacity() + leaves_.capacity()) * sizeof(std::uint32_t);
  }

  // The memory that changes take. Whoever changes a tree asks for it first.
  void make_room() { stale_.resize(nodes_.size() / 64 + 1, 0); }
  // A triangle has moved or gone; settle comes after the last one. One that has gone does not come back.
  void touch(std::uint32_t item) {
    if (item < leaves_.size() && leaves_[item] != nobody) {
      stale_[leaves_[item] / 64] |= std::uint64_t{1} << leaves_[item] % 64;
    }
  }
  // Fits the volumes above triangles that were touched.
  template <class CornersOf>
  void settle(const CornersOf& corners_of) {
    for (std::size_t word = stale_.size(); word > 0; --word) {
      while (stale_[word - 1] != 0) {
        const auto bit = static_cast<std::size_t>(std::bit_width(stale_[word - 1])) - 1;
        stale_[word - 1] ^= std::uint64_t{1} << bit;
        fit(static_cast<std::uint32_t>(64 * (word - 1) + bit), corners_of);
      }
    }
  }
  // Whether what a query costs, by the surfaces of all volumes, has grown by a half since the tree was made.
  [[nodiscard]] bool is_worn() const { return relative_surface() > 1.5 * first_surface_; }

  // Calls check(volume, item) for each item and each volume above it.
  template <class Check>
  void for_each_above(const Check& check) const {
    for (std::uint32_t item = 0; item < leaves_.size(); ++item) {
      for (std::uint32_t at = leaves_[item]; at != nobody; at = nodes_[at].parent) {
        check(nodes_[at].volume, item);
      }
    }
  }

 private:
  // The first of two nodes below another one follows it. A leaf has items [first, first + count).
  struct Node {
    Volume volume;
    std::uint32_t second, first, count, parent;
    [[nodiscard]] inline bool is_leaf() const { return second == nobody; }
  };
  // Halves are as large as each other, so that no path is longer.
  static constexpr std::size_t most_waiting = 66;

  [[nodiscard]] std::uint32_t first_below(const Node& node) const {
    return static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
  }
  std::size_t start(std::array<std::uint32_t, most_waiting>& waiting) const {
    waiting[0] = 0;
    return nodes_.empty() ? 0 : 1;
  }
  template <class Visitor>
  void visit_items(const Node& node, Visitor&& visit) const {
    for (std::uint32_t i = 0; i < node.count; ++i) {
      visit(items_[node.first + i]);
    }
  }
  // Nodes with a way of no more than `limit`, the least first.
  template <class WayOf, class Visitor>
  void descend(const WayOf& way_of, Real& limit, Visitor&& visit) const {
    struct Waiting {
      Real way;
      std::uint32_t node;
    };
    std::array<Waiting, most_waiting> waiting;
    std::size_t count = 0;
    const auto add = [&](std::uint32_t node, Real way) {
      if (way <= limit && way < infinity) {
        waiting[count++] = {way, node};
      }
    };
    if (!nodes_.empty()) {
      add(0, way_of(nodes_[0].volume));
    }
    while (count > 0) {
      const Waiting next = waiting[--count];
      const Node& node = nodes_[next.node];
      if (next.way > limit) {
        continue;
      }
      if (node.is_leaf()) {
        visit_items(node, visit);
        continue;
      }
      const std::uint32_t first = next.node + 1, second = node.second;
      const Real of_first = way_of(nodes_[first].volume), of_second = way_of(nodes_[second].volume);
      const bool is_first_nearer = of_first <= of_second;
      add(is_first_nearer ? second : first, is_first_nearer ? of_second : of_first);
      add(is_first_nearer ? first : second, is_first_nearer ? of_first : of_second);
    }
  }

  template <class CornersOf>
  void split(std::uint32_t begin, std::uint32_t end, std::uint32_t parent, std::span<const Vec3> middles,
             const CornersOf& corners_of) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({around(begin, end, corners_of), nobody, begin, end - begin, parent});
    if (end - begin <= most_in_leaf) {
      for (std::uint32_t i = begin; i < end; ++i) {
        leaves_[items_[i]] = at;
      }
      return;
    }
    Aabb box = Aabb::empty();
    for (std::uint32_t i = begin; i < end; ++i) {
      box.include(middles[items_[i]]);
    }
    const Vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto place = [&](std::uint32_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(begin), place(middle), place(end), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(middles[a][axis], a) < std::pair(middles[b][axis], b);
    });
    nodes_[at].count = 0;
    split(begin, middle, at, middles, corners_of);
    nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
    split(middle, end, at, middles, corners_of);
  }
  template <class CornersOf>
  [[nodiscard]] Volume around(std::uint32_t begin, std::uint32_t end, const CornersOf& corners_of) const {
    std::vector<Vec3> points;
    points.reserve(3 * std::size_t{end - begin});
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::optional<std::array<Vec3, 3>> corners = corners_of(items_[i]);
      points.insert(points.end(), corners->begin(), corners->end());
    }
    return points.empty() ? Volume() : Volume::around(points);
  }
  template <class CornersOf>
  void fit(std::uint32_t at, const CornersOf& corners_of) {
    Node& node = nodes_[at];
    count_surface(node, -1);
    if (node.is_leaf()) {
      for (std::uint32_t i = node.first; i < node.first + node.count;) {
        if (corners_of(items_[i])) {
          ++i;
          continue;
        }
        leaves_[items_[i]] = nobody;
        std::swap(items_[i], items_[node.first + --node.count]);
      }
      node.volume = around(node.first, node.first + node.count, corners_of);
    } else {
      node.volume = Volume::around(nodes_[at + 1].volume, nodes_[node.second].volume, node.volume);
    }
    count_surface(node, 1);
    if (node.parent != nobody) {
      stale_[node.parent / 64] |= std::uint64_t{1} << node.parent % 64;
    }
  }
  void count_surface(const Node& node, Real sign) { surface_ += sign * node.volume.surface(); }
  [[nodiscard]] Real relative_surface() const {
    const Real root = nodes_.empty() ? 0 : nodes_[0].volume.surface();
    return surface_ / std::max(root, std::numeric_limits<Real>::min());
  }

  std::vector<Node> nodes_;               // those below a node come after it
  std::vector<std::uint32_t> items_;      // in the order of the leaves
  std::vector<std::uint32_t> leaves_;     // of items
  std::vector<std::uint64_t> stale_;      // a bit for each node that has to be fitted
  Real surface_ = 0, first_surface_ = 0;  // of all volumes; and at the start, relative to the root
};

using OrientedBoxTree = VolumeTree<OrientedBox>;
using SphereTree = VolumeTree<BoundingBall>;
static_assert(ItemTree<OrientedBoxTree> && ItemTree<SphereTree>);

}  // namespace abut
