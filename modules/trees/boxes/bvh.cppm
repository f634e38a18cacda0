// SPDX-License-Identifier: Apache-2.0
// A bounding volume hierarchy of boxes that are all there from the start, such as those of the triangles of a mesh.
// Boxes are relative to the middle of all, so that single precision loses little far from the origin. They may move
// later, or go: then the boxes around them are fitted. The tree keeps its form but where that has worn.
//
// A mesh makes its tree when a query first needs it, behind a once-guard; a mesh that is only drawn or picked has none.
// A node has eight boxes. The tree takes 32 bytes a triangle. Neighbours (mesh_neighbours) take 26 more and are made
// when contacts first need them.
export module abut.trees.boxes.bvh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.volumes.box_heights;
import abut.trees.volumes.box_sweep;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// Nodes have up to eight children, which are nodes or items. Items are numbered as their boxes are.
class Bvh {
 public:
  Bvh() = default;
  explicit Bvh(std::span<const Aabb> boxes);
  // Of `count` items, of which box_of(item) tells the box; an empty box is no item. `around`: all of them. The tree
  // does not depend on the number of threads.
  template <class BoxOf>
  Bvh(const Aabb& around, std::size_t count, const BoxOf& box_of, const Workers& workers) : Bvh(around) {
    std::vector<Entry> entries(count);
    const Cuts cuts = workers.cut(count, least_of_task);
    workers.for_each(cuts.tasks(), [&](std::size_t task) {
      for (std::size_t item = cuts.begin(task); item < cuts.end(task); ++item) {
        entries[item] = entry_of(box_of(static_cast<std::uint32_t>(item)), static_cast<std::uint32_t>(item));
      }
    });
    build(std::move(entries), workers);
  }
  // Of the items of an order in which those near each other mostly follow each other. Made in half the time, as cuts
  // are looked for between 64 items and the next alone.
  Bvh(const Aabb& around, std::span<const Aabb> boxes, std::span<const std::uint32_t> order);

  // Calls visit(item) for the items whose boxes overlap `query`, within rounding. visit may shrink `query`.
  template <class Visitor>
  void visit_overlaps(const Aabb& query, Visitor&& visit) const {
    [[clang::uninitialized]] std::array<std::uint32_t, most_waiting> waiting;
    std::size_t count = 0;
    std::uint32_t at = 0;
    Aabb box = query;
    EightBoxes::WideLimits limits = EightBoxes::widened(limits_of(compact(box, origin_)));
    for (;;) {
      const EightBoxes& node = nodes_[at];
      bool is_visited = false;
      for (std::uint32_t met = node.overlapping(limits); met != 0; met &= met - 1) {
        const std::uint32_t child = node.numbers[static_cast<std::size_t>(std::countr_zero(met))];
        if (EightBoxes::is_item(child)) {
          visit(EightBoxes::item_of(child));
          is_visited = true;
        } else {
          fetch(nodes_[child]);
          waiting[count++] = child;
        }
      }
      if (count == 0) {
        return;
      }
      if (is_visited && !are_equal(box, query)) [[unlikely]] {
        box = query;
        limits = EightBoxes::widened(limits_of(compact(box, origin_)));
      }
      at = waiting[--count];
    }
  }

  // Calls cast(item) for the items whose boxes a ray meets within `limit`, which cast may lower. Nearer nodes come
  // first.
  template <class Caster>
  void visit_ray(const Vec3& origin, const Vec3& direction, Real& limit, Caster&& cast) const {
    sweep(CompactSweep(BoxSweep(origin - origin_, {0, 0, 0}, direction)), limit, [&](std::uint32_t item) {
      cast(item);
      return limit;
    });
  }

  // Calls visit(item) for the items whose boxes reach down to `limit` along a direction, which visit may lower. Lower
  // nodes come first.
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    const Real base = dot(direction, origin_);
    sweep(BoxHeights(direction), limit - base, [&](std::uint32_t item) {
      visit(item);
      return limit - base;
    });
  }

  // See Hierarchy.
  [[nodiscard]] const Vec3& origin() const [[clang::lifetimebound]] { return origin_; }
  template <class Visitor>
  void visit_children(std::uint32_t node, Visitor&& visit) const {
    visit(nodes_[node]);
  }

  // An item close to a point: down the side whose box is closer. There are items.
  [[nodiscard]] std::uint32_t item_near(const Vec3& point) const;

  // Around all items, as they were at the start.
  [[nodiscard]] Aabb bounds() const { return bounds_; }
  [[nodiscard]] std::size_t bytes() const;

  // The memory that changes take. Whoever changes a tree asks for it first.
  void make_room();
  // Gives items their new boxes; an empty box takes an item out for good. Items may be there twice. Call settle after
  // the last one.
  template <class BoxOf>
  void move(std::span<const std::uint32_t> items, const BoxOf& box_of) {
    for (const std::uint32_t item : items) {
      move(item, box_of(item));
    }
  }
  void move(std::uint32_t item, const Aabb& box);
  // The same for all items at once, each of which box_of(item) gives a box that is not empty: one pass through the
  // nodes. Call settle after it.
  template <class BoxOf>
  void move_all(const BoxOf& box_of) {
    const BoxSides before = nodes_[0].sides_around();
    // Children come after their parents.
    for (std::size_t node = nodes_.size(); node-- > 0;) {
      ExactSides exact{};
      bool has_items = false;
      for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
        const std::uint32_t child = nodes_[node].numbers[lane];
        if (!EightBoxes::is_item(child)) {
          continue;
        }
        has_items = true;
        const Aabb box = box_of(EightBoxes::item_of(child));
        for (const int axis : {0, 1, 2}) {
          exact[static_cast<std::size_t>(axis)][lane] = box.low[axis];
          exact[static_cast<std::size_t>(axis) + 3][lane] = -box.high[axis];
        }
      }
      if (has_items) {
        set_items(static_cast<std::uint32_t>(node), exact);
      }
      pass_up(static_cast<std::uint32_t>(node));
    }
    leave_to_parents();
    changed_ = merged(changed_, merged(before, nodes_[0].sides_around()));
  }
  // Asks the memory for what move needs of an item: first where it lies, and later, when that has come, its node.
  inline void fetch_place(std::uint32_t item) const {
    if (item < places_.size()) {
      __builtin_prefetch(&places_[item]);
    }
  }
  inline void fetch_node_of(std::uint32_t item) const {
    if (const std::uint32_t place = item < places_.size() ? places_[item] : nobody; place != nobody) {
      fetch(nodes_[place / EightBoxes::width]);
      __builtin_prefetch(&wear_[place / EightBoxes::width]);
    }
  }
  // Fits the boxes above items that moved, and makes sub-trees anew that have worn. A box around these items, before
  // and after.
  [[nodiscard]] Aabb settle();
  // Whether a query costs much more than when the tree was made: for want of memory, or where little has changed.
  [[nodiscard]] bool is_worn() const;

  // The least of value_of(item), where side 0 to 2 asks for the low side of the box along an axis, 3 to 5 for the
  // negated high one. One that is not above `enough` is as good.
  template <class ValueOf>
  [[nodiscard]] Real least(std::size_t side, Real enough, const ValueOf& value_of) const {
    const Real base = side < 3 ? origin_[static_cast<int>(side)] : -origin_[static_cast<int>(side - 3)];
    [[clang::uninitialized]] std::array<std::uint32_t, most_waiting> waiting;
    waiting[0] = 0;
    std::size_t count = 1;
    Real best = infinity;
    while (count > 0 && best > enough) {
      const EightBoxes& node = nodes_[waiting[--count]];
      for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
        const Real beyond = best - base;
        if (node.numbers[lane] == nobody ||
            static_cast<Real>(node.sides[side].of[lane]) > beyond + 4 * epsilon * std::fabs(beyond)) {
          continue;
        }
        if (EightBoxes::is_item(node.numbers[lane])) {
          best = std::min(best, value_of(EightBoxes::item_of(node.numbers[lane])));
        } else {
          waiting[count++] = node.numbers[lane];
        }
      }
    }
    return best;
  }

 private:
  friend class BvhBuild;
  friend class BvhRenewal;
  using Floats = EightBoxes::Floats;

  // The low sides and the negated high sides of a box, one lane without use, and the bits of the number of the item.
  struct Entry {
    Floats lanes;

    [[nodiscard]] inline std::uint32_t number() const { return std::bit_cast<std::uint32_t>(float{lanes[7]}); }
    [[nodiscard]] inline BoxSides sides() const { return {lanes[0], lanes[1], lanes[2], lanes[3], lanes[4], lanes[5]}; }
  };
  explicit Bvh(const Aabb& around) : bounds_(around), origin_(around.is_bounded() ? around.centre() : Vec3{0, 0, 0}) {}
  static constexpr std::size_t least_of_task = 4096;

  // No path is longer than most_levels (see BvhBuild); of each node on it all but one child may wait.
  static constexpr std::size_t most_levels = 72, most_waiting = most_levels * (EightBoxes::width - 1) + 1;

  static constexpr std::uint32_t nobody = EightBoxes::nobody;
  [[nodiscard]] static inline bool are_equal(const Aabb& a, const Aabb& b) {
    return a.low == b.low && a.high == b.high;
  }
  static inline void fetch(const EightBoxes& node) {
    __builtin_prefetch(&node.sides[0]);
    __builtin_prefetch(&node.sides[2]);
    __builtin_prefetch(&node.sides[4]);
    __builtin_prefetch(&node.numbers[0]);
  }
  // Calls visit(item) for the items whose boxes are met at some t up to `most`, nearer nodes first; it returns up to
  // which t it wants more. `order`: a CompactSweep, or BoxHeights, of which t is the height of the lowest corner.
  template <class Order, class Visitor>
  void sweep(const Order& order, Real most, Visitor&& visit) const {
    using Way = typename Order::Way;
    struct Waiting {
      Way entry;
      std::uint32_t child;
    };
    [[clang::uninitialized]] std::array<Waiting, most_waiting> waiting;
    waiting[0] = {-std::numeric_limits<Way>::infinity(), 0};
    std::size_t count = 1;
    Way most_way = order.way_of(most);
    while (count > 0) {
      const Waiting nearest = waiting[--count];
      if (nearest.entry > most_way) {
        continue;
      }
      if (EightBoxes::is_item(nearest.child)) {
        most_way = order.way_of(visit(EightBoxes::item_of(nearest.child)));
        continue;
      }
      const EightBoxes& node = nodes_[nearest.child];
      const auto entries = node.entries(order, most_way);
      const std::size_t begin = count;
      for (std::uint32_t met = EightBoxes::met(entries) & node.present(); met != 0; met &= met - 1) {
        // The nearest one comes last, and next off the stack.
        const auto lane = static_cast<std::size_t>(std::countr_zero(met));
        std::size_t place = count++;
        for (; place > begin && waiting[place - 1].entry < entries[lane]; --place) {
          waiting[place] = waiting[place - 1];
        }
        waiting[place] = {entries[lane], node.numbers[lane]};
        if (!EightBoxes::is_item(node.numbers[lane])) {
          fetch(nodes_[node.numbers[lane]]);
        }
      }
    }
  }
  [[nodiscard]] inline Entry entry_of(const Aabb& box, std::uint32_t item) const {
    if (!(box.low.x <= box.high.x)) {
      const float none = no_sides[0];
      return {{none, none, none, none, none, none, 0, std::bit_cast<float>(nobody)}};
    }
    const CompactAabb its = compact(box, origin_);
    return {
        {its.low[0], its.low[1], its.low[2], -its.high[0], -its.high[1], -its.high[2], 0, std::bit_cast<float>(item)}};
  }
  void build(std::vector<Entry> entries, const Workers& workers);
  // The nodes of a tree whose root lies at a level of another one.
  [[nodiscard]] static std::vector<EightBoxes> made_of(std::vector<Entry> entries, std::uint32_t level,
                                                       const Workers& workers);
  void set_lane(std::uint32_t place, const BoxSides& sides);

  // What a query costs below a node: the surfaces of all boxes there.
  struct Wear {
    double sum, untold;           // and what of it the node above has not been told yet
    double first, first_surface;  // when the form was made: the sum relative to the surface of the node, and that
    std::uint32_t height;         // 1: only items are below
    std::uint32_t made_below;     // the height of the node below which its form was made
  };
  // What the chance of a visit is proportional to. Of no box it is nothing.
  [[nodiscard]] static double surface_of(const BoxSides& sides);
  [[nodiscard]] double surface_of_node(std::uint32_t node) const;
  [[nodiscard]] bool is_worn(std::uint32_t node, double surface, double sum) const;
  // As a node whose form has just been made, below one of a height. Its children are known already.
  void weigh(std::uint32_t node, std::uint32_t made_below);
  // Low sides of eight boxes, then negated high ones.
  using ExactSides = std::array<std::array<double, EightBoxes::width>, 6>;
  // New boxes for the items of a node; what is said of other lanes does not count.
  void set_items(std::uint32_t node, const ExactSides& exact);
  // After all boxes of a node have been set, and those of all nodes below it: tells the node above.
  void pass_up(std::uint32_t node);
  // The same: notes whether the node has worn. `around`: the surface of the box around it.
  void weigh_moved(std::uint32_t node, double around);
  // Of nodes that have worn, only those remain noted whose parents have not.
  void leave_to_parents();
  // Makes the tree below a node anew, if that is better.
  void renew(std::uint32_t node);

  Aabb bounds_ = Aabb::empty();
  Vec3 origin_{0, 0, 0};                                // the middle of the bounds
  std::vector<EightBoxes> nodes_{EightBoxes::empty()};  // children come after their parents

  // Only for changes. A place is the index of a node times eight plus a lane.
  std::vector<std::uint32_t> places_;   // of items
  std::vector<std::uint32_t> parents_;  // places of nodes
  std::vector<std::uint64_t> stale_;    // a bit for each node whose children have changed
  std::vector<Wear> wear_;              // of nodes
  std::vector<std::uint32_t> unused_;   // nodes that sub-trees which were made anew left over
  BoxSides changed_ = no_sides;         // around what has moved since the last settle, before and after
};

}  // namespace abut
