// SPDX-License-Identifier: Apache-2.0
// Samples of a field on a regular grid, in blocks of 8 x 8 x 8 cells. A block either holds its samples, or is
// interpolated between its eight corners. Memory thus goes where the field has to be exact.
//
// A block holds the samples on all of its sides, so that a cell is read from one block. Positions are in cells: sample
// (i, j, k) lies at (i, j, k).
export module abut.trees.sparse_blocks;
import abut.core.standard;
import abut.math;

export namespace abut {

// Of samples or cells along the three axes.
struct GridPlace {
  std::uint32_t x, y, z;

  friend constexpr bool operator==(const GridPlace&, const GridPlace&) = default;
};
// From a first sample or cell on.
struct GridBox {
  GridPlace first, count;
};

// Of a cell: corner with bits x, y, z at place x + 2 y + 4 z.
using CellCorners = std::array<float, 8>;

struct Interpolated {
  Real value;
  Vec3 slope;  // for each cell
};

// Value and slope between the corners of a cell; `at` goes from 0 to 1.
[[nodiscard]] [[gnu::always_inline]] inline Interpolated interpolate(const CellCorners& corners, const Vec3& at) {
  const auto c = [&](std::size_t i) { return static_cast<Real>(corners[i]); };
  const Real x00 = c(1) - c(0), x10 = c(3) - c(2), x01 = c(5) - c(4), x11 = c(7) - c(6);
  const Real v00 = c(0) + at.x * x00, v10 = c(2) + at.x * x10, v01 = c(4) + at.x * x01, v11 = c(6) + at.x * x11;
  const Real y0 = v10 - v00, y1 = v11 - v01;
  const Real v0 = v00 + at.y * y0, v1 = v01 + at.y * y1;
  const Real x0 = x00 + at.y * (x10 - x00), x1 = x01 + at.y * (x11 - x01);
  return {v0 + at.z * (v1 - v0), {x0 + at.z * (x1 - x0), y0 + at.z * (y1 - y0), v1 - v0}};
}

class SparseBlocks {
 public:
  static constexpr std::uint32_t side = 8;  // of a block, in cells
  static constexpr std::uint32_t samples_along = side + 1;
  static constexpr std::size_t samples_of_block = 729;  // nine along each axis

  // What is known of a block as a whole.
  struct Block {
    std::uint32_t place;  // of its samples among those that are held, or no_samples
    float low, high;      // of its values
    float steepest;       // no gradient is longer
  };
  static constexpr std::uint32_t no_samples = 0xffffffff;

  // Two samples along each axis at least. `held`: the numbers of the blocks that hold samples, in rising order; blocks
  // are counted along X first.
  SparseBlocks(const GridPlace& samples, const Vec3& spacing, std::span<const std::uint32_t> held);

  [[nodiscard]] inline const GridPlace& samples() const [[clang::lifetimebound]] { return samples_; }
  [[nodiscard]] inline const GridPlace& block_counts() const [[clang::lifetimebound]] { return counts_; }
  [[nodiscard]] inline std::span<const Block> blocks() const [[clang::lifetimebound]] { return blocks_; }
  [[nodiscard]] inline std::size_t held_count() const { return values_.size() / samples_of_block; }
  [[nodiscard]] inline bool is_sparse() const { return held_count() < blocks_.size(); }
  // The corners of all blocks, and the samples of those that hold some.
  [[nodiscard]] inline std::span<const float> corners() const [[clang::lifetimebound]] { return corners_; }
  [[nodiscard]] inline std::span<const float> values() const [[clang::lifetimebound]] { return values_; }
  [[nodiscard]] inline std::span<float> corners() [[clang::lifetimebound]] { return corners_; }
  [[nodiscard]] inline std::span<float> values() [[clang::lifetimebound]] { return values_; }

  [[nodiscard]] inline GridPlace block_at(std::uint32_t number) const {
    return {number % counts_.x, number / counts_.x % counts_.y, number / counts_.x / counts_.y};
  }
  // The cells of a block.
  [[nodiscard]] inline GridBox cells_of(std::uint32_t number) const {
    const GridPlace at = block_at(number), first{side * at.x, side * at.y, side * at.z};
    return {first,
            {std::min(side, samples_.x - 1 - first.x), std::min(side, samples_.y - 1 - first.y),
             std::min(side, samples_.z - 1 - first.z)}};
  }
  // Of a cell of a block that holds samples; `in_block` counts from the first cell of the block.
  [[nodiscard]] inline CellCorners corners_of_cell(const Block& block, const GridPlace& in_block) const {
    constexpr std::size_t row = samples_along, layer = row * row;
    const std::span<const float> v = std::span(values_).subspan(
        block.place * samples_of_block + in_block.z * layer + in_block.y * row + in_block.x, layer + row + 2);
    return {v[0], v[1], v[row], v[row + 1], v[layer], v[layer + 1], v[layer + row], v[layer + row + 1]};
  }
  // Of a whole block.
  [[nodiscard]] inline CellCorners corners_of_block(const GridPlace& at) const {
    const std::size_t row = counts_.x + 1, layer = row * (counts_.y + 1);
    const std::span<const float> v = std::span(corners_).subspan(at.z * layer + at.y * row + at.x, layer + row + 2);
    return {v[0], v[1], v[row], v[row + 1], v[layer], v[layer + 1], v[layer + row], v[layer + row + 1]};
  }

  // At a position in the grid, in cells.
  [[nodiscard]] inline Interpolated at(const Vec3& position) const {
    const std::uint32_t i = cell_at(position.x, samples_.x), j = cell_at(position.y, samples_.y),
                        k = cell_at(position.z, samples_.z);
    const GridPlace block_place{i / side, j / side, k / side};
    const Block& block = blocks_[(std::size_t{block_place.z} * counts_.y + block_place.y) * counts_.x + block_place.x];
    if (block.place != no_samples) [[likely]] {
      return interpolate(corners_of_cell(block, {i % side, j % side, k % side}),
                         {position.x - i, position.y - j, position.z - k});
    }
    return between_corners(block_place, position);
  }

  // A sample; in a block without samples it is interpolated.
  [[nodiscard]] Real sample(const GridPlace& at) const;
  // Sets the samples of a box to value_of(place). Of a block without samples only its corners are set.
  template <class ValueOf>
  void set(const GridBox& box, ValueOf&& value_of) {
    visit_blocks(box, [&](std::uint32_t number) {
      const GridPlace block = block_at(number);
      const Stretch along_x = common(box.first.x, box.count.x, block.x, samples_.x),
                    along_y = common(box.first.y, box.count.y, block.y, samples_.y),
                    along_z = common(box.first.z, box.count.z, block.z, samples_.z);
      for (std::uint32_t k = along_z.first; k <= along_z.last; ++k) {
        for (std::uint32_t j = along_y.first; j <= along_y.last; ++j) {
          for (std::uint32_t i = along_x.first; i <= along_x.last; ++i) {
            const GridPlace place{side * block.x + i, side * block.y + j, side * block.z + k};
            write(number, {i, j, k}, static_cast<float>(value_of(place)));
          }
        }
      }
    });
  }
  // Whether all samples of a box are held.
  [[nodiscard]] bool holds(const GridBox& box) const;
  // After samples and corners were written: what is known of the blocks at these samples.
  void measure(const GridBox& box);
  // Calls visit(number) for the blocks that hold a sample of the box.
  template <class Visitor>
  void visit_blocks(const GridBox& box, Visitor&& visit) const {
    const auto first = [](std::uint32_t sample) { return sample == 0 ? 0 : (sample - 1) / side; };
    const auto last = [](std::uint32_t sample, std::uint32_t count) { return std::min(sample / side, count - 1); };
    for (std::uint32_t k = first(box.first.z); k <= last(box.first.z + box.count.z - 1, counts_.z); ++k) {
      for (std::uint32_t j = first(box.first.y); j <= last(box.first.y + box.count.y - 1, counts_.y); ++j) {
        for (std::uint32_t i = first(box.first.x); i <= last(box.first.x + box.count.x - 1, counts_.x); ++i) {
          visit((k * counts_.y + j) * counts_.x + i);
        }
      }
    }
  }

 private:
  [[nodiscard]] static inline std::uint32_t cell_at(Real position, std::uint32_t samples) {
    const auto cell = static_cast<std::uint32_t>(position);
    return cell < samples - 2 ? cell : samples - 2;
  }
  [[nodiscard]] Interpolated between_corners(const GridPlace& block, const Vec3& position) const;
  // The samples that a box and a block have in common along one axis, counted from the first of the block.
  struct Stretch {
    std::uint32_t first, last;
  };
  [[nodiscard]] static inline Stretch common(std::uint32_t first, std::uint32_t count, std::uint32_t block,
                                             std::uint32_t samples) {
    const std::uint32_t begin = side * block, end = std::min(begin + side, samples - 1);
    return {std::max(first, begin) - begin, std::min(first + count - 1, end) - begin};
  }
  // A sample of a block, which may be one of its corners.
  void write(std::uint32_t number, const GridPlace& in_block, float value);
  void measure_block(std::uint32_t number);
  [[nodiscard]] Real steepest_of(const CellCorners& corners, const Vec3& size) const;

  GridPlace samples_, counts_;  // counts_: of the blocks
  Vec3 spacing_;
  std::vector<Block> blocks_;
  std::vector<float> corners_;  // of blocks, along X first
  std::vector<float> values_;
};

}  // namespace abut
