// SPDX-License-Identifier: Apache-2.0
// A tree of boxes, eight to a node, whose leaves come, go and move.
export module abut.trees.boxes.box_tree;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// All leaves have the same depth, nodes are split when a ninth child comes (Guttman, "R-trees", 1984), and the boxes of
// all children of a node are compared at once. Leaves are numbers of the caller.
class BoxTree {
 public:
  BoxTree() = default;
  // Of boxes that stay: leaves are numbered as the boxes are, and nodes are full.
  explicit BoxTree(std::span<const CompactAabb> boxes);

  // Boxes are finite and small enough for their surface to be (|coordinate| below 1e18).
  void insert(std::uint32_t leaf, const CompactAabb& box);
  void erase(std::uint32_t leaf);
  // Gives a leaf another box. It stays where it is if that makes no box above it larger.
  void move(std::uint32_t leaf, const CompactAabb& box) {
    if (!moved_in_place(leaf, box)) {
      move_elsewhere(leaf, box);
    }
  }
  // The first half of that, which may run at once for different leaves: false when the leaf has to go elsewhere.
  [[nodiscard]] bool moved_in_place(std::uint32_t leaf, const CompactAabb& box);

  // Calls visit_leaf(leaf) for every leaf whose box overlaps.
  template <class Visitor>
  void visit(const CompactAabb& box, Visitor&& visit_leaf) const {
    const BoxSides limits = limits_of(box);
    visit_within([&]() -> const BoxSides& { return limits; }, visit_leaf);
  }
  // The same for a box that may shrink on the way. `limits_now`: of the box as it is.
  template <class Limits, class Visitor>
  void visit_within(const Limits& limits_now, Visitor&& visit_leaf) const {
    std::array<std::uint32_t, most_waiting> waiting;
    std::size_t count = 0;
    std::uint32_t at = root_;
    for (;;) {
      const EightBoxes& node = nodes_[at];
      std::uint32_t overlapping = node.overlapping(limits_now());
      while (overlapping != 0) {
        const std::uint32_t child = node.numbers[static_cast<std::size_t>(std::countr_zero(overlapping))];
        overlapping &= overlapping - 1;
        if (is_leaf(child)) {
          visit_leaf(child & ~leaf_bit);
        } else {
          fetch(nodes_[child]);
          waiting[count++] = child;
        }
      }
      if (count == 0) {
        return;
      }
      at = waiting[--count];
    }
  }

  // Calls visit_leaf(leaf) for the leaves whose boxes are met at some t up to `most`, nearer nodes first; it returns up
  // to which t it wants more. `sweep`: a CompactSweep, or BoxHeights, of which t is the height of the lowest corner.
  template <class Order, class Visitor>
  void sweep(const Order& sweep, Real most, Visitor&& visit_leaf) const {
    using Way = typename Order::Way;
    struct Waiting {
      Way entry;
      std::uint32_t child;
    };
    std::array<Waiting, most_waiting> waiting;
    waiting[0] = {-std::numeric_limits<Way>::infinity(), root_};
    std::size_t count = 1;
    Way most_way = sweep.way_of(most);
    while (count > 0) {
      const Waiting nearest = waiting[--count];
      if (nearest.entry > most_way) {
        continue;
      }
      if (is_leaf(nearest.child)) {
        most_way = sweep.way_of(visit_leaf(nearest.child & ~leaf_bit));
        continue;
      }
      const EightBoxes& node = nodes_[nearest.child];
      const auto entries = node.entries(sweep, most_way);
      const std::uint32_t present = (1u << links_[nearest.child].count) - 1;
      const std::size_t begin = count;
      for (std::uint32_t met = EightBoxes::met(entries) & present; met != 0; met &= met - 1) {
        // The nearest one comes last, and next off the stack.
        const auto lane = static_cast<std::size_t>(std::countr_zero(met));
        std::size_t place = count++;
        for (; place > begin && waiting[place - 1].entry < entries[lane]; --place) {
          waiting[place] = waiting[place - 1];
        }
        waiting[place] = {entries[lane], node.numbers[lane]};
        if (!is_leaf(node.numbers[lane])) {
          fetch(nodes_[node.numbers[lane]]);
        }
      }
    }
  }

  // A leaf close to a point: down the side whose box is closer. The tree has leaves.
  [[nodiscard]] std::uint32_t leaf_near(const std::array<float, 3>& point) const;

  // Numbers that are near each other belong to leaves that are, mostly.
  [[nodiscard]] std::uint32_t place_of(std::uint32_t leaf) const { return places_[leaf]; }

  // Asks the cache for what is there, and for where a leaf is.
  inline void expect_place(std::uint32_t place) const {
    if (const std::size_t node = place / width; node < nodes_.size()) {
      fetch(nodes_[node]);
      __builtin_prefetch(&links_[node]);
    }
  }
  inline void expect(std::uint32_t leaf) const {
    if (leaf < places_.size()) {
      __builtin_prefetch(&places_[leaf]);
    }
  }

  // Makes the tree anew, well packed and in the order of space, when many leaves have come, gone or gone elsewhere.
  void tidy();

  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(EightBoxes) + links_.capacity() * sizeof(Link) +
           places_.capacity() * sizeof(std::uint32_t) + entries_.capacity() * sizeof(Entry);
  }

 private:
  static constexpr std::size_t width = EightBoxes::width;

  // The tree is made anew after this many changes per leaf, and never for fewer. When all leaves are new it is time for
  // that.
  static constexpr std::size_t most_changes_of_each = 3;
  static constexpr std::size_t least_changes = 64;
  static constexpr std::size_t changes_of_new = most_changes_of_each + 1;

  static constexpr std::size_t most_levels = 24;
  static constexpr std::size_t most_waiting = most_levels * width;

  // A child is the index of a node or, with this bit, the number of a leaf.
  static constexpr std::uint32_t leaf_bit = 0x80000000;
  [[nodiscard]] static constexpr bool is_leaf(std::uint32_t child) { return (child & leaf_bit) != 0; }
  static constexpr std::uint32_t none = 0x7fffffff;

  struct Link {
    std::uint32_t parent = none;  // for a node that is not in use, the next such node
    std::uint8_t lane = 0;        // in its parent
    std::uint8_t count = 0;       // of children
    std::uint8_t level = 0;       // 0 for nodes of leaves
  };
  struct Entry {
    BoxSides sides;
    std::uint32_t child;
  };

  // Asks the cache for a node.
  static inline void fetch(const EightBoxes& node) {
    __builtin_prefetch(&node.sides[0]);
    __builtin_prefetch(&node.sides[2]);
    __builtin_prefetch(&node.sides[4]);
    __builtin_prefetch(&node.numbers[0]);
  }
  [[nodiscard]] static float half_surface(const BoxSides& box);
  void set_lane(std::uint32_t node, std::size_t lane, const Entry& entry);
  [[nodiscard]] std::uint32_t make_node(std::uint8_t level);
  void free_node(std::uint32_t node);
  [[nodiscard]] std::size_t cheapest_lane(const EightBoxes& node, std::size_t count, const BoxSides& sides) const;
  void move_elsewhere(std::uint32_t leaf, const CompactAabb& box);
  void insert_below(std::uint32_t node, const Entry& entry);
  [[nodiscard]] bool is_inside(std::uint32_t node, const BoxSides& sides) const;
  void add(std::uint32_t node, const Entry& entry);
  void split(std::uint32_t node, const Entry& entry);
  void take_out(std::uint32_t node, std::size_t lane);
  void take_away(std::uint32_t leaf);
  void fit_from(std::uint32_t node);
  static void put_in_order_of_space(std::span<Entry> entries, std::size_t fill);
  void build(std::size_t fill);

  std::vector<EightBoxes> nodes_{EightBoxes{}};  // numbered by their children
  std::vector<Link> links_{Link{}};
  std::vector<std::uint32_t> places_;  // of leaves: node times eight plus lane
  std::uint32_t root_ = 0;
  std::uint32_t free_ = none;
  std::size_t size_ = 0;
  std::size_t changes_ = 0;     // since the tree was made
  std::vector<Entry> entries_;  // scratch of build
};

}  // namespace abut
