// SPDX-License-Identifier: Apache-2.0
module abut.trees.samples.sparse_blocks;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

constexpr std::uint32_t blocks_along(std::uint32_t samples) { return (samples - 2) / SparseBlocks::side + 1; }

}  // namespace

SparseBlocks::SparseBlocks(const GridPlace& samples, const Vec3& spacing, std::span<const std::uint32_t> held,
                           std::uint32_t fringe)
    : samples_(samples),
      counts_{blocks_along(samples.x), blocks_along(samples.y), blocks_along(samples.z)},
      fringe_(fringe),
      spacing_(spacing),
      blocks_(std::size_t{counts_.x} * counts_.y * counts_.z, Block{no_samples, 0, 0, 0}),
      corners_(std::size_t{counts_.x + 1} * (counts_.y + 1) * (counts_.z + 1)) {
  hold(held);
}

void SparseBlocks::hold(std::span<const std::uint32_t> held) {
  for (Block& block : blocks_) {
    block.place = no_samples;
  }
  values_.assign(held.size() * samples_of_block(fringe_), 0);
  for (std::size_t i = 0; i < held.size(); ++i) {
    blocks_[held[i]].place = static_cast<std::uint32_t>(i);
  }
}

Interpolated SparseBlocks::between_corners(const GridPlace& block, const Vec3& position) const {
  const auto along = [](std::uint32_t at, std::uint32_t all) {
    return static_cast<Real>(std::min(side, all - 1 - side * at));
  };
  const Vec3 size{along(block.x, samples_.x), along(block.y, samples_.y), along(block.z, samples_.z)};
  const Vec3 at{(position.x - side * block.x) / size.x, (position.y - side * block.y) / size.y,
                (position.z - side * block.z) / size.z};
  const Interpolated found = interpolate(corners_of_block(block), at);
  return {found.value, {found.slope.x / size.x, found.slope.y / size.y, found.slope.z / size.z}};
}

Real SparseBlocks::sample(const GridPlace& place) const {
  const auto block_of = [](std::uint32_t at, std::uint32_t count) { return std::min(at / side, count - 1); };
  const GridPlace at{block_of(place.x, counts_.x), block_of(place.y, counts_.y), block_of(place.z, counts_.z)};
  const Block& block = blocks_[(std::size_t{at.z} * counts_.y + at.y) * counts_.x + at.x];
  if (block.place == no_samples) {
    return between_corners(at, {static_cast<Real>(place.x), static_cast<Real>(place.y), static_cast<Real>(place.z)})
        .value;
  }
  return static_cast<Real>(
      values_[place_in(block, {place.x - side * at.x, place.y - side * at.y, place.z - side * at.z})]);
}

SamplesAround SparseBlocks::samples_around(const Block& block, const GridPlace& in_block) const {
  constexpr std::size_t row = samples_along(1), layer = row * row;
  const std::span<const float> v =
      std::span(values_).subspan(place_in(block, in_block) - layer - row - 1, 2 * layer + 2 * row + 3);
  SamplesAround out{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        out[9 * k + 3 * j + i] = v[k * layer + j * row + i];
      }
    }
  }
  return out;
}

bool SparseBlocks::holds(const GridBox& box) const {
  bool holds_all = true;
  visit_blocks(box, [&](std::uint32_t number) { holds_all = holds_all && blocks_[number].place != no_samples; });
  return holds_all;
}

void SparseBlocks::write(std::uint32_t number, const GridPlace& sample, float value) {
  const GridBox cells = cells_of(number);
  // Numbers wrap around in the fringe below the first cell, and come back where the fringe is added.
  const GridPlace in_block{sample.x - cells.first.x, sample.y - cells.first.y, sample.z - cells.first.z};
  if (const Block& block = blocks_[number]; block.place != no_samples) {
    values_[place_in(block, in_block)] = value;
  }
  const auto is_end = [](std::uint32_t at, std::uint32_t count) { return at == 0 || at == count; };
  if (is_end(in_block.x, cells.count.x) && is_end(in_block.y, cells.count.y) && is_end(in_block.z, cells.count.z)) {
    const GridPlace block = block_at(number);
    const auto corner = [](std::uint32_t at, std::uint32_t in) { return at + (in == 0 ? 0u : 1u); };
    corners_[(std::size_t{corner(block.z, in_block.z)} * (counts_.y + 1) + corner(block.y, in_block.y)) *
                 (counts_.x + 1) +
             corner(block.x, in_block.x)] = value;
  }
}

void SparseBlocks::measure(const GridBox& box) {
  visit_blocks(with_fringe(box), [&](std::uint32_t number) {
    if (fringe_ > 0 && blocks_[number].place != no_samples) {
      measure_with_fringe(number);
    } else {
      measure_block(number);
    }
  });
}

// Values are means of samples, and slopes along an axis means of differences, within one sample around the nearest one.
void SparseBlocks::measure_with_fringe(std::uint32_t number) {
  constexpr std::size_t row = samples_along(1), layer = row * row, all = layer * row;
  using Numbers = std::array<float, all>;
  Block& block = blocks_[number];
  const GridPlace at = block_at(number);
  const GridBox cells = cells_of(number);
  // What is beyond the grid is like what is next to it, and makes no difference.
  const Stretch along_x = held_along(at.x, samples_.x), along_y = held_along(at.y, samples_.y),
                along_z = held_along(at.z, samples_.z);
  const auto held = [](std::size_t place, std::uint32_t first_cell, const Stretch& stretch) {
    const std::size_t sample = std::max<std::size_t>(first_cell + place, 1) - 1;
    return std::clamp<std::size_t>(sample, stretch.first, stretch.end - 1) + 1 - first_cell;
  };
  const std::span<const float> values = std::span<const float>(values_).subspan(block.place * all, all);
  Numbers v{};
  for (std::size_t k = 0; k < row; ++k) {
    for (std::size_t j = 0; j < row; ++j) {
      for (std::size_t i = 0; i < row; ++i) {
        v[k * layer + j * row + i] = values[held(k, cells.first.z, along_z) * layer +
                                            held(j, cells.first.y, along_y) * row + held(i, cells.first.x, along_x)];
      }
    }
  }
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  block.low = *low;
  block.high = *high;
  // Around each sample but those of the fringe.
  const auto widened = [](const Numbers& from, std::size_t step) {
    Numbers out{};
    for (std::size_t i = step; i + step < all; ++i) {
      out[i] = std::max(from[i], std::max(from[i - step], from[i + step]));
    }
    return out;
  };
  const auto steepest = [&](std::size_t step, std::size_t second, std::size_t third) {
    Numbers either{};
    for (std::size_t i = step; i + step < all; ++i) {
      either[i] = std::max(std::fabs(v[i] - v[i - step]), std::fabs(v[i + step] - v[i]));
    }
    return widened(widened(either, second), third);
  };
  const Numbers x = steepest(1, row, layer), y = steepest(row, 1, layer), z = steepest(layer, 1, row);
  Real most = 0;
  for (std::size_t k = 1; k + 1 < row; ++k) {
    for (std::size_t j = 1; j + 1 < row; ++j) {
      for (std::size_t i = 1; i + 1 < row; ++i) {
        const std::size_t here = k * layer + j * row + i;
        most = std::max(
            most, squared_norm(Vec3{static_cast<Real>(x[here]) / spacing_.x, static_cast<Real>(y[here]) / spacing_.y,
                                    static_cast<Real>(z[here]) / spacing_.z}));
      }
    }
  }
  // Rounded up, for differences too.
  block.steepest = static_cast<float>(std::sqrt(most)) * (1 + 4 * std::numeric_limits<float>::epsilon());
}

// Of the samples that values on a side of a block are made of.
void SparseBlocks::include_side(std::uint32_t number, int axis, bool is_upper, std::pair<float, float>& range) const {
  const GridPlace at = block_at(number);
  const GridBox cells = cells_of(number);
  std::array<Stretch, 3> held{held_along(at.x, samples_.x), held_along(at.y, samples_.y), held_along(at.z, samples_.z)};
  const auto place = static_cast<std::size_t>(axis);
  const std::uint32_t first = axis == 0 ? cells.first.x : axis == 1 ? cells.first.y : cells.first.z;
  const std::uint32_t side_sample = is_upper ? first + side : first;
  held[place] = {side_sample - fringe_, side_sample + fringe_ + 1};
  for (std::uint32_t k = held[2].first; k < held[2].end; ++k) {
    for (std::uint32_t j = held[1].first; j < held[1].end; ++j) {
      for (std::uint32_t i = held[0].first; i < held[0].end; ++i) {
        const float value =
            values_[place_in(blocks_[number], {i - cells.first.x, j - cells.first.y, k - cells.first.z})];
        range = {std::min(range.first, value), std::max(range.second, value)};
      }
    }
  }
}

Real SparseBlocks::least_beside_empty() const {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  float least = infinite;
  for (std::uint32_t number = 0; number < blocks_.size(); ++number) {
    if (blocks_[number].place == no_samples) {
      continue;
    }
    const GridPlace at = block_at(number);
    const std::array<std::uint32_t, 3> place{at.x, at.y, at.z}, counts{counts_.x, counts_.y, counts_.z},
        steps{1, counts_.x, counts_.x * counts_.y};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool is_upper : {false, true}) {
        const bool is_last = is_upper ? place[axis] + 1 == counts[axis] : place[axis] == 0;
        if (is_last || blocks_[is_upper ? number + steps[axis] : number - steps[axis]].place != no_samples) {
          continue;
        }
        std::pair<float, float> range{infinite, -infinite};
        include_side(number, static_cast<int>(axis), is_upper, range);
        const bool has_both_signs = range.first <= 0 && range.second >= 0;
        least = has_both_signs ? 0 : std::min(least, std::min(std::fabs(range.first), std::fabs(range.second)));
      }
    }
  }
  return static_cast<Real>(least);
}

// The slope along an axis is between those of the four edges along it.
Real SparseBlocks::steepest_of(const CellCorners& c, const Vec3& size) const {
  const auto steepest = [&](std::size_t step, std::size_t first, std::size_t second, Real length) {
    Real most = 0;
    for (const std::size_t i : {std::size_t{0}, first, second, first + second}) {
      most = std::max(most, std::fabs(static_cast<Real>(c[i + step]) - static_cast<Real>(c[i])));
    }
    return most / length;
  };
  return norm({steepest(1, 2, 4, size.x), steepest(2, 1, 4, size.y), steepest(4, 1, 2, size.z)});
}

void SparseBlocks::measure_block(std::uint32_t number) {
  Block& block = blocks_[number];
  const GridBox cells = cells_of(number);
  Real steepest = 0;
  float low = std::numeric_limits<float>::infinity(), high = -low;
  const auto include = [&](const CellCorners& corners, const Vec3& size) {
    for (const float value : corners) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    steepest = std::max(steepest, steepest_of(corners, size));
  };
  if (block.place == no_samples) {
    include(corners_of_block(block_at(number)),
            {spacing_.x * cells.count.x, spacing_.y * cells.count.y, spacing_.z * cells.count.z});
  } else {
    for (std::uint32_t k = 0; k < cells.count.z; ++k) {
      for (std::uint32_t j = 0; j < cells.count.y; ++j) {
        for (std::uint32_t i = 0; i < cells.count.x; ++i) {
          include(corners_of_cell(block, {i, j, k}), spacing_);
        }
      }
    }
  }
  block.low = low;
  block.high = high;
  // Rounded up.
  block.steepest = static_cast<float>(steepest) * (1 + std::numeric_limits<float>::epsilon());
}

}  // namespace abut
