// SPDX-License-Identifier: Apache-2.0
module abut.trees.sparse_blocks;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

constexpr std::uint32_t blocks_along(std::uint32_t samples) { return (samples - 2) / SparseBlocks::side + 1; }

}  // namespace

SparseBlocks::SparseBlocks(const GridPlace& samples, const Vec3& spacing, std::span<const std::uint32_t> held)
    : samples_(samples),
      counts_{blocks_along(samples.x), blocks_along(samples.y), blocks_along(samples.z)},
      spacing_(spacing),
      blocks_(std::size_t{counts_.x} * counts_.y * counts_.z, Block{no_samples, 0, 0, 0}),
      corners_(std::size_t{counts_.x + 1} * (counts_.y + 1) * (counts_.z + 1)),
      values_(held.size() * samples_of_block) {
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
  const std::size_t layer = place.z - side * at.z, row = place.y - side * at.y, column = place.x - side * at.x;
  return static_cast<Real>(
      values_[block.place * samples_of_block + (layer * samples_along + row) * samples_along + column]);
}

bool SparseBlocks::holds(const GridBox& box) const {
  bool holds_all = true;
  visit_blocks(box, [&](std::uint32_t number) { holds_all = holds_all && blocks_[number].place != no_samples; });
  return holds_all;
}

void SparseBlocks::write(std::uint32_t number, const GridPlace& in_block, float value) {
  const GridPlace block = block_at(number);
  const GridBox cells = cells_of(number);
  if (const std::uint32_t place = blocks_[number].place; place != no_samples) {
    values_[place * samples_of_block + (std::size_t{in_block.z} * samples_along + in_block.y) * samples_along +
            in_block.x] = value;
  }
  const auto is_end = [](std::uint32_t sample, std::uint32_t count) { return sample == 0 || sample == count; };
  if (is_end(in_block.x, cells.count.x) && is_end(in_block.y, cells.count.y) && is_end(in_block.z, cells.count.z)) {
    const auto corner = [](std::uint32_t at, std::uint32_t sample) { return at + (sample == 0 ? 0u : 1u); };
    corners_[(std::size_t{corner(block.z, in_block.z)} * (counts_.y + 1) + corner(block.y, in_block.y)) *
                 (counts_.x + 1) +
             corner(block.x, in_block.x)] = value;
  }
}

void SparseBlocks::measure(const GridBox& box) {
  visit_blocks(box, [&](std::uint32_t number) { measure_block(number); });
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
