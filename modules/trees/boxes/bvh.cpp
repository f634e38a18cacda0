// SPDX-License-Identifier: Apache-2.0
module abut.trees.boxes.bvh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {
namespace {

Aabb box_around(std::span<const Aabb> boxes) {
  Aabb around = Aabb::empty();
  for (const Aabb& box : boxes) {
    around.include(box);
  }
  return around;
}

}  // namespace

Bvh::Bvh(std::span<const Aabb> boxes)
    : Bvh(
          box_around(boxes), boxes.size(), [&](std::uint32_t item) -> const Aabb& { return boxes[item]; }, Workers(1)) {
}

std::uint32_t Bvh::item_near(const Vec3& point) const {
  const std::array<float, 3> place = compact({point, point}, origin_).low;
  std::uint32_t at = 0;
  while (!EightBoxes::is_item(at)) {
    const EightBoxes& node = nodes_[at];
    Floats square(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Floats below = node.side(axis) - place[axis], above = place[axis] + node.side(axis + 3);
      const Floats beyond = below > above ? below : above;
      square += beyond > 0.0f ? beyond * beyond : Floats(0.0f);
    }
    // A point far from all boxes is as far from lanes without one.
    std::uint32_t present = node.present();
    auto nearest = static_cast<std::size_t>(std::countr_zero(present));
    for (present &= present - 1; present != 0; present &= present - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(present));
      nearest = square[lane] < square[nearest] ? lane : nearest;
    }
    at = node.numbers[nearest];
  }
  return EightBoxes::item_of(at);
}

std::size_t Bvh::bytes() const {
  return nodes_.capacity() * sizeof(EightBoxes) + stale_.capacity() * sizeof(std::uint64_t) +
         wear_.capacity() * sizeof(Wear) +
         (places_.capacity() + parents_.capacity() + unused_.capacity()) * sizeof(std::uint32_t);
}

void Bvh::make_room() {
  if (!parents_.empty()) {
    return;
  }
  std::vector<std::uint32_t> places, parents(nodes_.size(), nobody);
  std::vector<std::uint64_t> stale(nodes_.size() / 64 + 1, 0);
  std::vector<Wear> wear(nodes_.size());
  std::uint32_t most = 0;
  for (const EightBoxes& node : nodes_) {
    for (const std::uint32_t child : node.numbers) {
      most = EightBoxes::is_item(child) ? std::max(most, EightBoxes::item_of(child) + 1) : most;
    }
  }
  places.resize(most, nobody);
  for (std::uint32_t place = 0; place < nodes_.size() * EightBoxes::width; ++place) {
    const std::uint32_t child = nodes_[place / EightBoxes::width].numbers[place % EightBoxes::width];
    if (child != nobody) {
      (EightBoxes::is_item(child) ? places[EightBoxes::item_of(child)] : parents[child]) = place;
    }
  }
  places_ = std::move(places);
  stale_ = std::move(stale);
  wear_ = std::move(wear);
  parents_ = std::move(parents);
  for (std::size_t node = nodes_.size(); node > 0; --node) {
    weigh(static_cast<std::uint32_t>(node - 1), 2 * most_levels);
  }
}

double Bvh::surface_of(const BoxSides& sides) {
  const auto minus_length = [&](std::size_t axis) {
    return static_cast<double>(sides[axis]) + static_cast<double>(sides[axis + 3]);
  };
  const double x = minus_length(0), y = minus_length(1), z = minus_length(2);
  const double surface = x * y + y * z + z * x;
  return surface < std::numeric_limits<double>::infinity() ? surface : 0;
}

double Bvh::surface_of_node(std::uint32_t node) const {
  // Items without extent have none at all.
  return std::max(surface_of(nodes_[node].sides_around()), std::numeric_limits<double>::min());
}

void Bvh::weigh(std::uint32_t node, std::uint32_t made_below) {
  double sum = 0;
  std::uint32_t height = 0;
  for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
    const std::uint32_t child = nodes_[node].numbers[lane];
    if (child == nobody) {
      continue;
    }
    sum += surface_of(nodes_[node].sides_of_lane(lane));
    if (!EightBoxes::is_item(child)) {
      sum += wear_[child].sum;
      height = std::max(height, wear_[child].height);
    }
  }
  const double surface = surface_of_node(node);
  wear_[node] = {sum, 0, sum / surface, surface, height + 1, made_below};
}

bool Bvh::is_worn(std::uint32_t node, double surface, double sum) const {
  constexpr double most = 1.2;
  // Eight items stay eight items.
  return wear_[node].height > 1 && sum > most * wear_[node].first * surface;
}

// As compact rounds a side of one box. Eight at once, a box costs a quarter of the time.
void Bvh::set_items(std::uint32_t node, const ExactSides& exact) {
  EightBoxes& its = nodes_[node];
  const EightBoxes::Numbers is_item = std::bit_cast<EightBoxes::Numbers>(its.numbers) < 0;
  for (std::size_t side = 0; side < exact.size(); ++side) {
    const Lanes base = all_lanes(side < 3 ? origin_[static_cast<int>(side)] : -origin_[static_cast<int>(side - 3)]);
    const auto rounded = [&](Lanes values) {
      const Lanes moved = values - base - epsilon * (absolute(values) + absolute(base));
      return round_down(absolute(values) < infinity ? moved : values);
    };
    const auto [first, last] = std::bit_cast<std::array<Lanes, 2>>(exact[side]);
    const Floats sides = __builtin_shufflevector(rounded(first), rounded(last), 0, 1, 2, 3, 4, 5, 6, 7);
    its.sides[side].of = std::bit_cast<std::array<float, EightBoxes::width>>(is_item ? sides : its.side(side));
  }
}

void Bvh::pass_up(std::uint32_t node) {
  const BoxSides around = nodes_[node].sides_around();
  // Items without extent have none at all.
  weigh_moved(node, std::max(surface_of(around), std::numeric_limits<double>::min()));
  // Nodes without use are empty, and below no other one.
  if (node != 0 && nodes_[node].present() != 0) {
    nodes_[parents_[node] / EightBoxes::width].set_sides(parents_[node] % EightBoxes::width, around);
  }
}

void Bvh::weigh_moved(std::uint32_t node, double around) {
  const EightBoxes& its = nodes_[node];
  // All lanes at once. What has no extent, or none that is told, counts as nothing; so does a lane without a box.
  using Doubles = double __attribute__((ext_vector_type(8)));
  const Doubles x = __builtin_convertvector(its.side(0), Doubles) + __builtin_convertvector(its.side(3), Doubles);
  const Doubles y = __builtin_convertvector(its.side(1), Doubles) + __builtin_convertvector(its.side(4), Doubles);
  const Doubles z = __builtin_convertvector(its.side(2), Doubles) + __builtin_convertvector(its.side(5), Doubles);
  const Doubles surfaces = x * y + y * z + z * x;
  double sum = 0;
  for (std::uint32_t left = its.present(); left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const double surface = surfaces[lane];
    sum += surface < std::numeric_limits<double>::infinity() ? surface : 0;
    if (!EightBoxes::is_item(its.numbers[lane])) {
      sum += wear_[its.numbers[lane]].sum;
    }
  }
  Wear& wear = wear_[node];
  wear.sum = sum;
  wear.untold = 0;
  // What has become better may be expected from then on.
  wear.first = std::min(wear.first, sum / around);
  const std::uint64_t bit = std::uint64_t{1} << node % 64;
  std::uint64_t& word = stale_[node / 64];
  word = is_worn(node, around, sum) ? word | bit : word & ~bit;
}

void Bvh::leave_to_parents() {
  const auto is_noted = [&](std::size_t node) { return (stale_[node / 64] >> node % 64 & 1) != 0; };
  for (std::size_t node = nodes_.size(); node-- > 1;) {
    if (is_noted(node) && is_noted(parents_[node] / EightBoxes::width)) {
      stale_[node / 64] ^= std::uint64_t{1} << node % 64;
    }
  }
}

bool Bvh::is_worn() const { return is_worn(0, surface_of_node(0), wear_[0].sum); }

void Bvh::set_lane(std::uint32_t place, const BoxSides& sides) {
  const std::uint32_t index = place / EightBoxes::width;
  EightBoxes& node = nodes_[index];
  const double grown = surface_of(sides) - surface_of(node.sides_of_lane(place % EightBoxes::width));
  wear_[index].sum += grown;
  wear_[index].untold += grown;
  node.set_sides(place % EightBoxes::width, sides);
  stale_[index / 64] |= std::uint64_t{1} << index % 64;
}

void Bvh::move(std::uint32_t item, const Aabb& box) {
  const std::uint32_t place = item < places_.size() ? places_[item] : nobody;
  if (place == nobody) {
    return;
  }
  EightBoxes& node = nodes_[place / EightBoxes::width];
  const Entry entry = entry_of(box, item);
  const BoxSides sides = entry.sides();
  changed_ = merged(changed_, merged(sides, node.sides_of_lane(place % EightBoxes::width)));
  set_lane(place, sides);
  if (entry.number() == nobody) {
    node.numbers[place % EightBoxes::width] = nobody;
    places_[item] = nobody;
  }
}

Aabb Bvh::settle() {
  // Children come after their parents, so that each node is fitted after all below it.
  for (std::size_t word = stale_.size(); word > 0; --word) {
    while (stale_[word - 1] != 0) {
      const auto bit = static_cast<std::size_t>(std::bit_width(stale_[word - 1])) - 1;
      stale_[word - 1] ^= std::uint64_t{1} << bit;
      const auto node = static_cast<std::uint32_t>(64 * (word - 1) + bit);
      const BoxSides around = nodes_[node].sides_around();
      const double surface = std::max(surface_of(around), std::numeric_limits<double>::min());
      // What has become better may be expected from then on.
      wear_[node].first = std::min(wear_[node].first, wear_[node].sum / surface);
      // Where the node above has worn as well, that one is made anew.
      const auto is_left_to_parent = [&] {
        const std::uint32_t parent = parents_[node] / EightBoxes::width;
        return node != 0 && is_worn(parent, surface_of_node(parent), wear_[parent].sum + wear_[node].untold);
      };
      if (is_worn(node, surface, wear_[node].sum) && !is_left_to_parent()) [[unlikely]] {
        try {
          renew(node);
        } catch (const std::bad_alloc&) {
          // The tree is right as it is, and only slower.
        }
      }
      if (node == 0) {
        wear_[node].untold = 0;
        continue;
      }
      const std::uint32_t place = parents_[node], above = place / EightBoxes::width;
      if (around != nodes_[above].sides_of_lane(place % EightBoxes::width)) {
        set_lane(place, around);
      }
      if (const double untold = std::exchange(wear_[node].untold, 0); untold != 0) {
        wear_[above].sum += untold;
        wear_[above].untold += untold;
        stale_[above / 64] |= std::uint64_t{1} << above % 64;
      }
    }
  }
  const BoxSides sides = std::exchange(changed_, no_sides);
  const auto wide = [&](std::size_t first, Real sign) {
    const Vec3 relative{static_cast<Real>(sides[first]), static_cast<Real>(sides[first + 1]),
                        static_cast<Real>(sides[first + 2])};
    const Vec3 sum = origin_ + sign * relative;
    return sum - sign * (2 * epsilon) * (absolute(sum) + absolute(origin_));
  };
  return {wide(0, 1), wide(3, -1)};
}

}  // namespace abut
