// SPDX-License-Identifier: Apache-2.0
module abut.trees.grids.cell_order;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

constexpr Real most_along_an_axis = 65535;

bool is_there(const Aabb& box) { return box.low.x <= box.high.x; }

// Such that about four boxes lie in a cell, but cells are wider than most boxes.
std::uint32_t cells_that_suit(Real extent, Real other_extent, Real mean_width, Real count) {
  constexpr Real boxes_of_cell = 4, widths_of_cell = 1.4;
  const Real most = std::max(std::floor(count / boxes_of_cell), Real{1});
  const Real even = other_extent > 0 ? std::sqrt(most * (extent / other_extent)) : most;
  const Real wide = mean_width > 0 ? extent / (widths_of_cell * mean_width) : most;
  return extent > 0
             ? static_cast<std::uint32_t>(std::clamp(std::min(even, wide), Real{1}, std::min(most, most_along_an_axis)))
             : 1;
}

CellPlan settled(CellPlan plan, const Vec3& extent, std::span<const Aabb> boxes) {
  Vec3 widths{0, 0, 0};
  for (const Aabb& box : boxes) {
    widths += is_there(box) ? box.high - box.low : Vec3{0, 0, 0};
  }
  const auto count = static_cast<Real>(boxes.size());
  const auto suit = [&](int axis, int other) {
    return cells_that_suit(extent[axis], extent[other], widths[axis] / count, count);
  };
  plan.columns = plan.columns > 0 ? plan.columns : suit(plan.u, plan.v);
  plan.rows = plan.rows > 0 ? plan.rows : suit(plan.v, plan.u);
  return plan;
}

// The place of a cell along the curve. Each pair of bits tells in which quarter of a square the cell lies; the curve in
// the first one is mirrored about one diagonal, in the last one about the other.
std::uint64_t place_along_curve(std::uint32_t i, std::uint32_t j, unsigned bits) {
  std::uint64_t place = 0;
  while (bits-- > 0) {
    const std::uint32_t right = i >> bits & 1, upper = j >> bits & 1;
    place = place << 2 | (3 * right ^ upper);
    if (upper == 0) {
      const std::uint32_t turned = right == 1 ? ~0u : 0u;
      i = std::exchange(j, i ^ turned) ^ turned;
    }
  }
  return place;
}

// Bits 0, 3, 6 and so on take those of a number of nine bits.
std::uint64_t spread(std::uint32_t number) {
  std::uint64_t bits = number;
  bits = (bits | bits << 16) & 0x030000ff;
  bits = (bits | bits << 8) & 0x0300f00f;
  bits = (bits | bits << 4) & 0x030c30c3;
  return (bits | bits << 2) & 0x09249249;
}

// By their upper halves. Equal ones keep their order.
void sort_by_upper_half(std::vector<std::uint64_t>& keys) {
  constexpr unsigned digit_bits = 11;
  constexpr std::size_t digits = 1 << digit_bits;
  std::vector<std::uint64_t> sorted(keys.size());
  for (unsigned shift = 32; shift < 64; shift += digit_bits) {
    const auto digit_of = [&](std::uint64_t key) { return key >> shift & (digits - 1); };
    std::array<std::size_t, digits> places{};
    for (const std::uint64_t key : keys) {
      ++places[digit_of(key)];
    }
    std::size_t before = 0;
    for (std::size_t& place : places) {
      before += std::exchange(place, before);
    }
    for (const std::uint64_t key : keys) {
      sorted[places[digit_of(key)]++] = key;
    }
    keys.swap(sorted);
  }
}

}  // namespace

std::vector<std::uint32_t> ordered_by_cells(CellPlan plan, const Aabb& around, std::span<const Aabb> boxes) {
  constexpr Real steps = 512;  // of a cell along each axis
  const Vec3 extent = around.high - around.low;
  plan = settled(plan, extent, boxes);
  const int w = 3 - plan.u - plan.v;
  const unsigned bits = static_cast<unsigned>(std::bit_width(std::max(plan.columns, plan.rows) - 1));
  const auto scale_of = [&](int axis, Real cells) {
    const Real scale = cells / extent[axis];
    return scale < infinity ? scale : 0;
  };
  const Real scale_u = scale_of(plan.u, plan.columns), scale_v = scale_of(plan.v, plan.rows), scale_w = scale_of(w, 1);
  // In cells from the low corner of all, and the cell that is meant.
  struct Along {
    Real place;
    std::uint32_t cell;

    Along(Real at, std::uint32_t cells)
        : place(at), cell(static_cast<std::uint32_t>(std::clamp(at, Real{0}, static_cast<Real>(cells - 1)))) {}
    [[nodiscard]] std::uint32_t step() const {
      return static_cast<std::uint32_t>(std::clamp(steps * (place - cell), Real{0}, steps - 1));
    }
  };
  // The upper half tells the place: three bits of how wide a box is, then the first ones of its place along the curve
  // and in its cell. The lower half is its number.
  constexpr unsigned bits_of_place = 29, bits_in_cell = 27;
  const unsigned all_bits = 2 * bits + bits_in_cell, left_out = all_bits - std::min(all_bits, bits_of_place);
  std::vector<std::uint64_t> keys;
  keys.reserve(boxes.size());
  std::uint32_t cell_u = 0, cell_v = 0;
  std::uint64_t place_of_cell = 0;  // the first one along the curve, until another one is met
  for (std::uint32_t number = 0; number < boxes.size(); ++number) {
    const Aabb& box = boxes[number];
    if (!is_there(box)) {
      continue;
    }
    const Vec3 middle = 0.5 * ((box.low - around.low) + (box.high - around.low)), width = box.high - box.low;
    const Along u(scale_u * middle[plan.u], plan.columns), v(scale_v * middle[plan.v], plan.rows),
        up(scale_w * middle[w], 1);
    // Triangles that follow each other mostly lie in one cell.
    if (u.cell != cell_u || v.cell != cell_v) {
      cell_u = u.cell;
      cell_v = v.cell;
      place_of_cell = place_along_curve(cell_u, cell_v, bits);
    }
    std::uint64_t widths = 0;
    for (Real cells = std::max(scale_u * width[plan.u], scale_v * width[plan.v]); cells > 4; cells /= 4) {
      ++widths;
    }
    const std::uint64_t in_cell = spread(up.step()) << 2 | spread(v.step()) << 1 | spread(u.step()),
                        place = (place_of_cell << bits_in_cell | in_cell) >> left_out;
    keys.push_back((widths << bits_of_place | place) << 32 | number);
  }
  sort_by_upper_half(keys);
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(),
                 [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
  return order;
}

}  // namespace abut
