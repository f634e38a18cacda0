// SPDX-License-Identifier: Apache-2.0
// Sub-trees that have worn are made anew where they are. Large ones are made of small ones that are still good. So one
// that has worn in one place costs little.
//
// A bit for each node says whether its children have changed. Children follow their parents in memory, so one pass from
// the last bit to the first fits all. Each node stores the sum of the surfaces below it relative to its own. At 1.2
// times the initial sum its sub-tree is made anew in that pass, unless its parent has worn as well. A large sub-tree
// reuses those of up to 64 triangles that are still good, until an eighth has changed. New nodes take the numbers of
// old ones.
//
// If 2 % of 131,000 boxes in one place are torn up, an update takes up to 3 ms, or 10 to 16 ms if the root has worn;
// making the whole tree takes 32 ms. Over 150 such updates a query costs at most 1.25 times as much as in a new tree.
// Fitting 10^6 triangles takes 47 ms, or 0.6 ms for a hundredth of the vertices in one neighbourhood. Scattered
// vertices prefetch what a block of triangles needs, and take a tenth of the time of all instead of a sixth.
module abut.trees.boxes.bvh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {

class BvhRenewal {
 public:
  // `takes_good`: whether small sub-trees that are still good stay as they are.
  BvhRenewal(const Bvh& tree, std::uint32_t node, bool takes_good)
      : node_(node), height_(tree.wear_[node].height), takes_good_(takes_good && height_ > height_of_good + 1) {
    take_apart(tree);
    items_torn_ += items_.size();
    const std::uint32_t level = level_of(tree, node);
    if (!good_.empty()) {
      // What is no longer good becomes small sub-trees of its own, all of which then are items of a tree above them.
      made_ = Bvh::made_of(std::move(items_), level, Workers(1));
      items_.clear();
      first_of_made_ = copies_.size();
      take_made(0);
      items_ = std::move(good_entries_);
    }
    made_ = Bvh::made_of(std::move(items_), level, Workers(1));
  }

  // Whether so much has been made anew since the whole was that the whole may be made again.
  [[nodiscard]] bool is_large() const { return 8 * items_torn_ >= items_torn_ + items_good_; }
  // The surfaces of all boxes.
  [[nodiscard]] double sum() const {
    double sum = good_sum_;
    const auto add = [&](const EightBoxes& node) {
      for (std::uint32_t left = node.present(); left != 0; left &= left - 1) {
        sum += Bvh::surface_of(node.sides_of_lane(static_cast<std::size_t>(std::countr_zero(left))));
      }
    };
    std::ranges::for_each(std::span(copies_).subspan(first_of_made_), add);
    std::ranges::for_each(made_, add);
    return sum;
  }

  void put(Bvh& tree) {
    find_numbers(tree);
    // From here on nothing asks for memory.
    const Bvh::Wear before = tree.wear_[node_];
    put_good(tree);
    put_made(tree);
    tree.unused_.swap(unused_);
    Bvh::Wear& wear = tree.wear_[node_];
    wear.untold = before.untold + wear.sum - before.sum;
    // Sub-trees that stay do not lower what is expected of the whole.
    wear.first = good_.empty() ? wear.first : before.first;
  }

 private:
  static constexpr std::uint32_t width = EightBoxes::width, nobody = EightBoxes::nobody;
  // Nodes with items alone, and such with these below, are taken as they are, where they are good.
  static constexpr std::uint32_t height_of_good = 2;
  // In the number of an entry: that it is a small sub-tree, by its place in the list. BvhBuild turns the upper bit
  // over.
  static constexpr std::uint32_t good_bit = 0x40000000;

  // Whether its form was made along with all around it. That is told by a height beyond all others.
  [[nodiscard]] static bool is_of_whole(const Bvh::Wear& wear) { return wear.made_below > Bvh::most_levels; }
  [[nodiscard]] std::uint32_t made_below() const { return good_.empty() ? Bvh::most_levels + height_ : height_; }
  // What was made anew since, of items that lay below one smaller node, may lie across what others have made.
  [[nodiscard]] bool is_good(const Bvh& tree, std::uint32_t node) const {
    constexpr double most = 1.1;
    const Bvh::Wear& wear = tree.wear_[node];
    const std::uint32_t made_below = is_of_whole(wear) ? wear.made_below - Bvh::most_levels : wear.made_below;
    return takes_good_ && made_below >= height_ && wear.height <= height_of_good &&
           wear.sum <= most * wear.first * wear.first_surface &&
           tree.surface_of_node(node) <= most * wear.first_surface;
  }

  void take_apart(const Bvh& tree) {
    numbers_.push_back(node_);
    std::vector<std::uint32_t> opened{node_};
    for (std::size_t next = 0; next < opened.size(); ++next) {
      const EightBoxes& its = tree.nodes_[opened[next]];
      for (std::size_t lane = 0; lane < width; ++lane) {
        const std::uint32_t child = its.numbers[lane];
        if (child == nobody) {
          continue;
        }
        if (EightBoxes::is_item(child)) {
          items_.push_back(entry_of(its.sides_of_lane(lane), EightBoxes::item_of(child)));
        } else if (is_good(tree, child)) {
          add_good(its.sides_of_lane(lane));
          good_sum_ += tree.wear_[child].sum;
          take_good(tree, child);
        } else {
          opened.push_back(child);
          numbers_.push_back(child);
        }
      }
    }
    first_of_made_ = copies_.size();
  }
  [[nodiscard]] static Bvh::Entry entry_of(const BoxSides& sides, std::uint32_t number) {
    return {{sides[0], sides[1], sides[2], sides[3], sides[4], sides[5], 0, std::bit_cast<float>(number)}};
  }
  // The sub-tree that is copied next.
  void add_good(const BoxSides& sides) {
    good_entries_.push_back(
        entry_of(sides, EightBoxes::item_bit | good_bit | static_cast<std::uint32_t>(good_.size())));
    good_.push_back(static_cast<std::uint32_t>(copies_.size()));
  }
  // Parents before children, which follow in the order of the lanes.
  void take_good(const Bvh& tree, std::uint32_t node) {
    const bool is_old = is_of_whole(tree.wear_[node]);
    numbers_.push_back(node);
    copies_.push_back(tree.nodes_[node]);
    worn_.push_back(tree.wear_[node]);
    for (const std::uint32_t child : tree.nodes_[node].numbers) {
      if (child != nobody && !EightBoxes::is_item(child)) {
        take_good(tree, child);
      } else {
        (is_old ? items_good_ : items_torn_) += child != nobody ? 1 : 0;
      }
    }
  }
  [[nodiscard]] std::uint32_t height_of_made(std::uint32_t node) const {
    std::uint32_t height = 0;
    for (const std::uint32_t child : made_[node].numbers) {
      height = child == nobody || EightBoxes::is_item(child) ? height : std::max(height, height_of_made(child));
    }
    return height + 1;
  }
  void take_made(std::uint32_t node) {
    if (height_of_made(node) <= height_of_good) {
      if (made_[node].present() != 0) {
        add_good(made_[node].sides_around());
        copy_made(node);
      }
      return;
    }
    for (const std::uint32_t child : std::array(made_[node].numbers)) {
      if (child != nobody) {
        take_made(child);
      }
    }
  }
  void copy_made(std::uint32_t node) {
    copies_.push_back(made_[node]);
    worn_.push_back({});
    for (const std::uint32_t child : std::array(made_[node].numbers)) {
      if (child != nobody && !EightBoxes::is_item(child)) {
        copy_made(child);
      }
    }
  }

  [[nodiscard]] static std::uint32_t level_of(const Bvh& tree, std::uint32_t node) {
    std::uint32_t level = 0;
    for (; node != 0; node = tree.parents_[node] / width) {
      ++level;
    }
    return level;
  }
  // Those of the nodes that there are, those without use that come later, and new ones. In their order the made nodes
  // come first and the good ones last, so that children come after their parents.
  void find_numbers(Bvh& tree) {
    for (const std::uint32_t number : tree.unused_) {
      (number > node_ ? numbers_ : unused_).push_back(number);
    }
    std::ranges::sort(numbers_);
    const std::size_t needed = made_.size() + copies_.size(), before = tree.nodes_.size();
    const std::size_t all = before + std::max(needed, numbers_.size()) - numbers_.size();
    for (std::size_t number = before; number < all; ++number) {
      numbers_.push_back(static_cast<std::uint32_t>(number));
    }
    unused_.insert(unused_.end(), numbers_.begin() + static_cast<std::ptrdiff_t>(needed), numbers_.end());
    tree.nodes_.reserve(all);
    tree.parents_.reserve(all);
    tree.wear_.reserve(all);
    tree.stale_.resize(std::max(tree.stale_.size(), all / 64 + 1), 0);
    tree.nodes_.resize(all);
    tree.parents_.resize(all, nobody);
    tree.wear_.resize(all);
    for (std::size_t i = needed; i < numbers_.size(); ++i) {
      tree.nodes_[numbers_[i]] = EightBoxes::empty();
    }
  }

  [[nodiscard]] std::uint32_t number_of_copy(std::size_t copy) const { return numbers_[made_.size() + copy]; }

  void put_good(Bvh& tree) {
    for (std::size_t copy = copies_.size(); copy > 0; --copy) {
      const std::uint32_t at = number_of_copy(copy - 1);
      tree.nodes_[at] = copies_[copy - 1];
      tree.wear_[at] = worn_[copy - 1];
      // Children follow in the order of the lanes, and have items alone.
      std::size_t next = copy;
      put_lanes(tree, at, [&](std::uint32_t) { return number_of_copy(next++); });
      if (copy > first_of_made_) {
        tree.weigh(at, made_below());
      }
    }
  }
  void put_made(Bvh& tree) {
    for (std::size_t i = made_.size(); i > 0; --i) {
      const std::uint32_t at = numbers_[i - 1];
      tree.nodes_[at] = made_[i - 1];
      put_lanes(tree, at, [&](std::uint32_t child) {
        return (child & good_bit) != 0 ? number_of_copy(good_[child & ~good_bit]) : numbers_[child];
      });
      tree.weigh(at, made_below());
    }
  }
  // Tells items and children where they are. number_of(child) is the new number of a child.
  template <class NumberOf>
  static void put_lanes(Bvh& tree, std::uint32_t at, const NumberOf& number_of) {
    for (std::uint32_t lane = 0; lane < width; ++lane) {
      std::uint32_t& child = tree.nodes_[at].numbers[lane];
      if (child == nobody) {
        continue;
      }
      if (EightBoxes::is_item(child)) {
        tree.places_[EightBoxes::item_of(child)] = width * at + lane;
      } else {
        child = number_of(child);
        tree.parents_[child] = width * at + lane;
      }
    }
  }

  std::uint32_t node_;
  std::uint32_t height_;
  bool takes_good_;
  std::vector<std::uint32_t> numbers_, unused_;
  std::vector<Bvh::Entry> items_, good_entries_;
  std::vector<std::uint32_t> good_;  // where in the list of copies each small sub-tree begins
  double good_sum_ = 0;
  std::size_t items_torn_ = 0, items_good_ = 0;
  std::vector<EightBoxes> copies_, made_;
  std::vector<Bvh::Wear> worn_;    // of the copies
  std::size_t first_of_made_ = 0;  // of the copies, those that are new
};

void Bvh::renew(std::uint32_t node) {
  const double surface = surface_of_node(node), before = wear_[node].sum;
  for (const bool takes_good : {true, false}) {
    BvhRenewal renewal(*this, node, takes_good);
    const double sum = renewal.sum();
    if (takes_good && renewal.is_large() && is_worn(node, surface, sum)) {
      continue;
    }
    if (sum < before) {
      renewal.put(*this);
      return;
    }
  }
  // The boxes themselves allow no better.
  wear_[node].first = before / surface;
  wear_[node].first_surface = surface;
}

}  // namespace abut
