// SPDX-License-Identifier: Apache-2.0
// How the tree is made: ranges of items are cut in two where the surfaces of both sides, times their items, are least
// (Goldsmith and Salmon, 1987). Cuts are looked for between bins of the centres (Wald, "On fast construction of
// SAH-based bounding volume hierarchies", 2007). Small ranges are cut at whole nodes, so that nearly all nodes are
// full.
//
// Ranges of up to 4,096 items count as small. A tree of 10^6 triangles is made in 0.24 s on one thread.
module abut.trees.boxes.bvh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {

class BvhBuild {
 public:
  using Entry = Bvh::Entry;
  using Floats = Bvh::Floats;

  BvhBuild(std::vector<Entry> entries, std::uint32_t level) : entries_(std::move(entries)), level_(level) {}

  [[nodiscard]] std::vector<EightBoxes> nodes(const Workers& workers) {
    cut_all(workers);
    place_range(0);
    nodes_.resize(node_count_, EightBoxes::empty());
    for (const Inner& inner : inner_) {
      fill_inner(inner);
    }
    const Cuts cuts = workers.cut(clusters_.size(), 64);
    workers.for_each(cuts.tasks(), [&](std::size_t task) {
      for (const Cluster& cluster : cuts.of(std::span<const Cluster>(clusters_), task)) {
        fill_cluster(cluster);
      }
    });
    return std::move(nodes_);
  }

 private:
  static constexpr std::uint32_t width = EightBoxes::width;
  static constexpr std::uint32_t cluster_size = width * width;  // items below a node whose children have items alone
  // Ranges of up to so many are cut at whole clusters.
  static constexpr std::uint32_t most_packed = cluster_size * cluster_size;
  // Below this many cuts by surfaces, ranges are halved: a tree is never deeper than Bvh::most_levels.
  static constexpr std::uint32_t most_cuts = 40;
  static constexpr std::size_t bin_count = 16;

  struct Range {
    std::uint32_t begin, end;
    std::uint32_t depth;
    std::uint32_t left = 0, right = 0;  // the ranges that it is cut into; none where both are 0
    Floats around;                      // all boxes

    [[nodiscard]] std::uint32_t size() const { return end - begin; }
    [[nodiscard]] bool is_cut() const { return left != right; }
  };
  struct Inner {
    std::uint32_t node;
    std::uint32_t count = 0;
    std::array<std::uint32_t, width> ranges{}, children{};
  };
  struct Cluster {
    std::uint32_t range, node;
  };

  [[nodiscard]] static Floats none() { return Floats(no_sides[0]); }
  [[nodiscard]] static Floats merged(Floats a, Floats b) { return a < b ? a : b; }
  // Twice the centres along the axes, then the same negated. Sides are clamped so that no sum overflows.
  [[nodiscard]] static inline Floats centres_of(const Entry& entry) {
    const Floats far(std::numeric_limits<float>::max() / 8);
    Floats sides = entry.lanes < -far ? -far : entry.lanes;
    sides = sides > far ? far : sides;
    return sides - __builtin_shufflevector(sides, sides, 3, 4, 5, 0, 1, 2, 7, 7);
  }
  [[nodiscard]] static inline float half_surface(Floats around) {
    const float x = around[0] + around[3], y = around[1] + around[4], z = around[2] + around[5];
    return x * y + y * z + z * x;
  }
  [[nodiscard]] static BoxSides sides_of(Floats around) {
    return {around[0], around[1], around[2], around[3], around[4], around[5]};
  }

  struct Extent {
    Floats around = none(), centres = none();
  };
  [[nodiscard]] Extent extent_of(std::uint32_t begin, std::uint32_t end) const {
    Extent extent;
    for (const Entry& entry : std::span(entries_).subspan(begin, end - begin)) {
      extent.around = merged(extent.around, entry.lanes);
      extent.centres = merged(extent.centres, centres_of(entry));
    }
    return extent;
  }
  [[nodiscard]] static int longest_axis(Floats centres) {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
      longest = centres[axis] + centres[axis + 3] < centres[longest] + centres[longest + 3] ? axis : longest;
    }
    return longest;
  }

  // Puts the entries first that are wanted, and tells where the others begin. Whether an entry is wanted cannot be
  // foreseen, so nothing waits for the answer.
  template <class IsWanted>
  [[nodiscard]] std::uint32_t put_first(std::uint32_t begin, std::uint32_t end, const IsWanted& is_wanted) {
    const std::span<Entry> entries(entries_);
    std::uint32_t between = begin;
    for (std::uint32_t i = begin; i < end; ++i) {
      const Entry entry = entries[i];
      entries[i] = entries[between];
      entries[between] = entry;
      between += is_wanted(entry) ? 1 : 0;
    }
    return between;
  }
  // Calls use(axis) with the axis as a constant: one number of a register is quickly read where its place is known.
  template <class Use>
  static std::uint32_t with_axis(int axis, const Use& use) {
    return axis == 0   ? use(std::integral_constant<int, 0>())
           : axis == 1 ? use(std::integral_constant<int, 1>())
                       : use(std::integral_constant<int, 2>());
  }

  // Puts the items with the least centres first. Equal ones are told apart by their numbers.
  void put_least_first(std::uint32_t begin, std::uint32_t count, std::uint32_t end, int axis) {
    static_cast<void>(with_axis(axis, [&]<int at>(std::integral_constant<int, at>) {
      // Numbers in the order of centres: floats of one sign are ordered as their bits are.
      const auto key_of = [](const Entry& entry) {
        const auto bits = std::bit_cast<std::uint32_t>(entry.lanes[at] - entry.lanes[at + 3] + 0.0f);
        const std::uint32_t ordered = (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
        return std::uint64_t{ordered} << 32 | entry.number();
      };
      SmallVector<std::uint64_t, cluster_size> keys;
      for (const Entry& entry : std::span(entries_).subspan(begin, end - begin)) {
        keys.push_back(key_of(entry));
      }
      const std::span<std::uint64_t> all = keys.span();
      std::nth_element(all.begin(), all.begin() + count, all.end());
      const std::uint64_t first_of_others = all[count];
      return put_first(begin, end, [&](const Entry& entry) { return key_of(entry) < first_of_others; });
    }));
  }

  struct Cut {
    int axis = -1;
    std::uint32_t bin = 0;  // the last one of the first side
    float cost = std::numeric_limits<float>::infinity();
  };
  // From centres to bins.
  struct Bins {
    Floats low, scale = Floats(0.0f);

    explicit Bins(Floats centres) : low(centres) {
      for (int axis = 0; axis < 3; ++axis) {
        const float length = -(centres[axis] + centres[axis + 3]);
        // A little less, so that the last centre falls into the last bin.
        scale[axis] = length > 0 ? std::min(0.999f * static_cast<float>(bin_count) / length, largest_scale) : 0;
      }
    }
    [[nodiscard]] inline EightBoxes::Numbers of(Floats centres) const {
      return __builtin_convertvector((centres - low) * scale, EightBoxes::Numbers);
    }
    static constexpr float largest_scale = 1e30f;
  };

  struct Histogram {
    std::array<std::array<Floats, bin_count>, 3> around;
    std::array<std::array<std::uint32_t, bin_count>, 3> counts{};
  };

  [[nodiscard]] Cut best_cut(const Range& range, const Bins& bins) const {
    [[clang::uninitialized]] Histogram all;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all.around[axis].fill(none());
      all.counts[axis].fill(0);
    }
    for (const Entry& entry : std::span(entries_).subspan(range.begin, range.size())) {
      const EightBoxes::Numbers bin = bins.of(centres_of(entry));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(bin[static_cast<int>(axis)]);
        all.around[axis][at] = merged(all.around[axis][at], entry.lanes);
        ++all.counts[axis][at];
      }
    }
    Cut best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      consider(all, axis, best);
    }
    return best;
  }
  static void consider(const Histogram& all, std::size_t axis, Cut& best) {
    std::array<float, bin_count> costs_of_rest{};
    Floats around = none();
    std::uint32_t count = 0;
    for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
      around = merged(around, all.around[axis][bin]);
      count += all.counts[axis][bin];
      costs_of_rest[bin] =
          count == 0 ? std::numeric_limits<float>::infinity() : half_surface(around) * static_cast<float>(count);
    }
    around = none();
    count = 0;
    for (std::size_t bin = 0; bin + 1 < bin_count; ++bin) {
      around = merged(around, all.around[axis][bin]);
      count += all.counts[axis][bin];
      const float cost = count == 0 ? std::numeric_limits<float>::infinity()
                                    : half_surface(around) * static_cast<float>(count) + costs_of_rest[bin + 1];
      if (cost < best.cost) {
        best = {static_cast<int>(axis), static_cast<std::uint32_t>(bin), cost};
      }
    }
  }

  // Where the second side of a range begins.
  [[nodiscard]] std::uint32_t cut(const Range& range, Floats centres) {
    const std::uint32_t unit = range.size() > cluster_size ? cluster_size : width;
    const std::uint32_t units = (range.size() + unit - 1) / unit, half = range.begin + units / 2 * unit;
    if (range.size() <= cluster_size || range.depth >= most_cuts) {
      put_least_first(range.begin, half - range.begin, range.end, longest_axis(centres));
      return half;
    }
    const Bins bins(centres);
    const Cut best = best_cut(range, bins);
    if (best.axis < 0) {
      put_least_first(range.begin, half - range.begin, range.end, longest_axis(centres));
      return half;
    }
    const auto last = static_cast<std::int32_t>(best.bin);
    const std::uint32_t between = with_axis(best.axis, [&]<int at>(std::integral_constant<int, at>) {
      return put_first(range.begin, range.end,
                       [&](const Entry& entry) { return bins.of(centres_of(entry))[at] <= last; });
    });
    const std::uint32_t count = between - range.begin;
    if (range.size() > most_packed) {
      return range.begin + count;
    }
    const std::uint32_t whole = std::clamp((count + unit / 2) / unit, 1u, units - 1) * unit;
    if (whole < count) {
      put_least_first(range.begin, whole, range.begin + count, best.axis);
    } else if (whole > count) {
      put_least_first(range.begin + count, whole - count, range.end, best.axis);
    }
    return range.begin + whole;
  }

  // Ranges below `at`, which may be cut on a thread of its own: those lists are different.
  void cut_below(std::vector<Range>& ranges, std::uint32_t at) {
    const Extent extent = extent_of(ranges[at].begin, ranges[at].end);
    ranges[at].around = extent.around;
    if (ranges[at].size() <= cluster_size) {
      return;
    }
    cut_once(ranges, at, extent.centres);
    cut_below(ranges, ranges[at].left);
    cut_below(ranges, ranges[at].right);
  }
  void cut_once(std::vector<Range>& ranges, std::uint32_t at, Floats centres) {
    add_sides(ranges, at, cut(ranges[at], centres));
  }
  static void add_sides(std::vector<Range>& ranges, std::uint32_t at, std::uint32_t between) {
    const Range range = ranges[at];
    ranges[at].left = static_cast<std::uint32_t>(ranges.size());
    ranges[at].right = ranges[at].left + 1;
    ranges.push_back({range.begin, between, range.depth + 1, 0, 0, none()});
    ranges.push_back({between, range.end, range.depth + 1, 0, 0, none()});
  }

  // Large ranges first, all of one round at once; then those that are left, each as a task.
  void cut_all(const Workers& workers) {
    const auto all = static_cast<std::uint32_t>(entries_.size());
    const std::uint32_t most_of_task = std::max(most_packed, all / 64);
    ranges_.push_back({0, all, level_, 0, 0, none()});
    std::vector<std::uint32_t> large, tasks;
    const auto sort_in = [&](std::uint32_t range) {
      (ranges_[range].size() > most_of_task ? large : tasks).push_back(range);
    };
    sort_in(0);
    while (!large.empty()) {
      const std::vector<std::uint32_t> round = std::exchange(large, {});
      std::vector<std::uint32_t> between(round.size());
      workers.for_each(round.size(), [&](std::size_t i) {
        Range& range = ranges_[round[i]];
        const Extent extent = extent_of(range.begin, range.end);
        range.around = extent.around;
        between[i] = cut(range, extent.centres);
      });
      for (std::size_t i = 0; i < round.size(); ++i) {
        add_sides(ranges_, round[i], between[i]);
        sort_in(ranges_[round[i]].left);
        sort_in(ranges_[round[i]].right);
      }
    }
    std::vector<std::vector<Range>> below(tasks.size());
    workers.for_each(tasks.size(), [&](std::size_t i) {
      below[i].push_back(ranges_[tasks[i]]);
      cut_below(below[i], 0);
    });
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      // The first one of each list is there already.
      const auto before = static_cast<std::uint32_t>(ranges_.size()) - 1;
      for (Range& range : below[i]) {
        range.left += range.is_cut() ? before : 0;
        range.right += range.left != 0 && range.right != 0 ? before : 0;
      }
      ranges_[tasks[i]] = below[i].front();
      ranges_.insert(ranges_.end(), below[i].begin() + 1, below[i].end());
    }
  }

  // Gives a range its nodes, after those of its parent. Of a node, the largest child is opened until there are eight.
  std::uint32_t place_range(std::uint32_t at) {
    const std::uint32_t node = node_count_++;
    if (!ranges_[at].is_cut()) {
      const std::uint32_t leaves = (ranges_[at].size() + width - 1) / width;
      node_count_ += leaves > 1 ? leaves : 0;
      clusters_.push_back({at, node});
      return node;
    }
    Inner inner{node, 2, {ranges_[at].left, ranges_[at].right}, {}};
    while (inner.count < width) {
      std::uint32_t widest = width;
      for (std::uint32_t i = 0; i < inner.count; ++i) {
        const Range& range = ranges_[inner.ranges[i]];
        if (range.is_cut() &&
            (widest == width || half_surface(range.around) > half_surface(ranges_[inner.ranges[widest]].around))) {
          widest = i;
        }
      }
      if (widest == width) {
        break;
      }
      const Range& range = ranges_[inner.ranges[widest]];
      inner.ranges[widest] = range.left;
      inner.ranges[inner.count++] = range.right;
    }
    for (std::uint32_t i = 0; i < inner.count; ++i) {
      inner.children[i] = place_range(inner.ranges[i]);
    }
    inner_.push_back(inner);
    return node;
  }
  void fill_inner(const Inner& inner) {
    for (std::uint32_t i = 0; i < inner.count; ++i) {
      nodes_[inner.node].set_sides(i, sides_of(ranges_[inner.ranges[i]].around));
      nodes_[inner.node].numbers[i] = inner.children[i];
    }
  }

  // A cluster is one node of items, or a node and its children.
  void fill_cluster(const Cluster& its) {
    const Range& range = ranges_[its.range];
    if (range.size() <= width) {
      fill_items(its.node, range.begin, range.end);
      return;
    }
    std::uint32_t lane = 0;
    fill_leaves(its.node, lane, {range.begin, range.end, range.depth, 0, 0, none()});
  }
  void fill_leaves(std::uint32_t node, std::uint32_t& lane, Range range) {
    const Extent extent = extent_of(range.begin, range.end);
    if (range.size() <= width) {
      nodes_[node].set_sides(lane, sides_of(extent.around));
      nodes_[node].numbers[lane] = node + lane + 1;
      fill_items(node + lane + 1, range.begin, range.end);
      ++lane;
      return;
    }
    const std::uint32_t between = cut(range, extent.centres);
    fill_leaves(node, lane, {range.begin, between, range.depth, 0, 0, none()});
    fill_leaves(node, lane, {between, range.end, range.depth, 0, 0, none()});
  }
  void fill_items(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      nodes_[node].set_sides(i - begin, sides_of(entries_[i].lanes));
      nodes_[node].numbers[i - begin] = entries_[i].number() ^ EightBoxes::item_bit;
    }
  }

  std::vector<Entry> entries_;
  std::uint32_t level_;
  std::vector<Range> ranges_;
  std::vector<Inner> inner_;
  std::vector<Cluster> clusters_;
  std::uint32_t node_count_ = 0;
  std::vector<EightBoxes> nodes_;
};

void Bvh::build(std::vector<Entry> entries, const Workers& workers) {
  std::erase_if(entries, [](const Entry& entry) { return entry.number() == nobody; });
  nodes_ = made_of(std::move(entries), 0, workers);
}

std::vector<EightBoxes> Bvh::made_of(std::vector<Entry> entries, std::uint32_t level, const Workers& workers) {
  return BvhBuild(std::move(entries), level).nodes(workers);
}

}  // namespace abut
