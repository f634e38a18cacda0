module abut.trees.bvh;
import abut.core.standard;
import abut.math;
import abut.trees.ray_slabs;

namespace abut {
namespace {

constexpr std::size_t bin_count = 16;
constexpr std::size_t leaf_size = 4;

Real half_area(const Aabb& box) {
  const Vec3 d = box.high - box.low;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

struct Split {
  Real cost = infinity;
  int axis = 0;
  std::size_t bin = 0;  // items of this bin and below go left
};

std::size_t bin_of(Real centre, Real low, Real per_unit) {
  return std::min(bin_count - 1, static_cast<std::size_t>((centre - low) * per_unit));
}

}  // namespace

struct Bvh::Build {
  static Split best_split(std::span<const Aabb> boxes, std::span<const std::uint32_t> items, const Aabb& centres) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      const Real low = centres.low[axis], width = centres.high[axis] - low;
      if (!(width > 0)) {
        continue;
      }
      const Real per_unit = static_cast<Real>(bin_count) / width;
      std::array<Aabb, bin_count> bins;
      bins.fill(Aabb::empty());
      std::array<std::size_t, bin_count> counts{};
      for (const std::uint32_t item : items) {
        const std::size_t bin = bin_of(boxes[item].centre()[axis], low, per_unit);
        bins[bin].include(boxes[item]);
        ++counts[bin];
      }
      std::array<Real, bin_count> right_cost{};
      Aabb right = Aabb::empty();
      std::size_t right_count = 0;
      for (std::size_t bin = bin_count - 1; bin > 0; --bin) {
        right.include(bins[bin]);
        right_count += counts[bin];
        right_cost[bin - 1] = right_count == 0 ? 0 : half_area(right) * static_cast<Real>(right_count);
      }
      Aabb left = Aabb::empty();
      std::size_t left_count = 0;
      for (std::size_t bin = 0; bin + 1 < bin_count; ++bin) {
        left.include(bins[bin]);
        left_count += counts[bin];
        if (left_count == 0 || left_count == items.size()) {
          continue;
        }
        const Real cost = half_area(left) * static_cast<Real>(left_count) + right_cost[bin];
        if (cost < best.cost) {
          best = {cost, axis, bin};
        }
      }
    }
    return best;
  }

  // Emits the subtree over items[first, first + count) at a level. Items with equal centres are halved, and so is what
  // many uneven cuts have left.
  static void emit(Bvh& tree, std::span<const Aabb> boxes, std::uint32_t first, std::uint32_t count,
                   std::size_t level) {
    const std::span<std::uint32_t> items = std::span(tree.items_).subspan(first, count);
    Aabb box = Aabb::empty(), centres = Aabb::empty();
    for (const std::uint32_t item : items) {
      box.include(boxes[item]);
      centres.include(boxes[item].centre());
    }
    const auto index = static_cast<std::uint32_t>(tree.nodes_.size());
    tree.nodes_.push_back({compact(box, tree.origin_), first, count});
    if (count > leaf_size) {
      const Split split = level < most_uneven_levels ? best_split(boxes, items, centres) : Split{};
      auto middle = items.begin() + count / 2;
      if (split.cost < infinity) {
        const Real low = centres.low[split.axis];
        const Real per_unit = static_cast<Real>(bin_count) / (centres.high[split.axis] - low);
        middle = std::partition(items.begin(), items.end(), [&](std::uint32_t item) {
          return bin_of(boxes[item].centre()[split.axis], low, per_unit) <= split.bin;
        });
      }
      const auto left = static_cast<std::uint32_t>(middle - items.begin());
      tree.nodes_[index].count = 0;
      emit(tree, boxes, first, left, level + 1);
      tree.nodes_[index].next = static_cast<std::uint32_t>(tree.nodes_.size());
      emit(tree, boxes, first + left, count - left, level + 1);
    }
  }
};

Bvh::Bvh(std::span<const Aabb> boxes) {
  items_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    items_[i] = static_cast<std::uint32_t>(i);
  }
  nodes_.reserve(boxes.size());
  for (const Aabb& box : boxes) {
    bounds_.include(box);
  }
  if (!boxes.empty()) {
    origin_ = bounds_.centre();
    Build::emit(*this, boxes, 0, static_cast<std::uint32_t>(boxes.size()), 0);
  }
}

std::uint32_t Bvh::item_near(const Vec3& point) const {
  const Vec3 place = point - origin_;
  const auto distance_to = [&](std::uint32_t node) { return in_double(nodes_[node].box).squared_distance(place); };
  std::uint32_t at = 0;
  while (nodes_[at].count == 0) {
    const std::uint32_t left = at + 1, right = nodes_[at].next;
    at = distance_to(left) <= distance_to(right) ? left : right;
  }
  return items_[nodes_[at].next];
}

}  // namespace abut
