// SPDX-License-Identifier: Apache-2.0
// Samples of a field on a regular grid, in blocks of 8 x 8 x 8 cells. A block either holds its samples, or is
// interpolated between its eight corners. Memory thus goes where the field has to be exact.
//
// A block holds the samples on all of its sides, so that a cell is read from one block. For tri-quadratic values it
// also holds a fringe: the samples next to these. Positions are in cells: sample (i, j, k) lies at (i, j, k).
export module abut.trees.samples.sparse_blocks;
import abut.core.standard;
import abut.math;
export import abut.trees.samples.sparse_blocks_spline;

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
  // Along each axis of a block, and in all of it.
  [[nodiscard]] static constexpr std::uint32_t samples_along(std::uint32_t fringe) { return side + 1 + 2 * fringe; }
  [[nodiscard]] static constexpr std::size_t samples_of_block(std::uint32_t fringe) {
    return std::size_t{samples_along(fringe)} * samples_along(fringe) * samples_along(fringe);
  }

  // What is known of a block as a whole.
  struct Block {
    std::uint32_t place;  // of its samples among those that are held, or no_samples
    float low, high;      // of its values
    float steepest;       // no gradient is longer
  };
  static constexpr std::uint32_t no_samples = 0xffffffff;

  // Two samples along each axis at least. `held`: the numbers of the blocks that hold samples, in rising order; blocks
  // are counted along X first. `fringe`: how many samples a block holds beyond its cells on each side. It is 1 where
  // values are tri-quadratic, and 0 where they are tri-linear.
  SparseBlocks(const GridPlace& samples, const Vec3& spacing, std::span<const std::uint32_t> held,
               std::uint32_t fringe);
  // Instead of those so far. Their samples are zero.
  void hold(std::span<const std::uint32_t> held);

  [[nodiscard]] inline const GridPlace& samples() const [[clang::lifetimebound]] { return samples_; }
  [[nodiscard]] inline const GridPlace& block_counts() const [[clang::lifetimebound]] { return counts_; }
  [[nodiscard]] inline std::span<const Block> blocks() const [[clang::lifetimebound]] { return blocks_; }
  [[nodiscard]] inline std::size_t held_count() const { return values_.size() / samples_of_block(fringe_); }
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
  // Without a fringe, of a cell of a block that holds samples; `in_block` counts from the first cell of the block.
  [[nodiscard]] inline CellCorners corners_of_cell(const Block& block, const GridPlace& in_block) const {
    constexpr std::size_t row = samples_along(0), layer = row * row;
    const std::span<const float> v = std::span(values_).subspan(
        block.place * samples_of_block(0) + in_block.z * layer + in_block.y * row + in_block.x, layer + row + 2);
    return {v[0], v[1], v[row], v[row + 1], v[layer], v[layer + 1], v[layer + row], v[layer + row + 1]};
  }
  // Of a whole block.
  [[nodiscard]] inline CellCorners corners_of_block(const GridPlace& at) const {
    const std::size_t row = counts_.x + 1, layer = row * (counts_.y + 1);
    const std::span<const float> v = std::span(corners_).subspan(at.z * layer + at.y * row + at.x, layer + row + 2);
    return {v[0], v[1], v[row], v[row + 1], v[layer], v[layer + 1], v[layer + row], v[layer + row + 1]};
  }

  // With a fringe: a sample of a block that holds some, and those around it. Numbers beyond the grid are zero.
  [[nodiscard]] SamplesAround samples_around(const Block& block, const GridPlace& in_block) const;
  // Which end of the grid a sample is, along each axis.
  [[nodiscard]] std::array<NearestSample, 3> ends_at(const GridPlace& sample) const {
    return {{{sample.x == 0, sample.x == samples_.x - 1},
             {sample.y == 0, sample.y == samples_.y - 1},
             {sample.z == 0, sample.z == samples_.z - 1}}};
  }

  // Tri-linear at a position in the grid, in cells.
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
  // Tri-quadratic where samples are held.
  [[nodiscard]] inline Interpolated smooth_at(const Vec3& position) const {
    const GridPlace block_place{cell_at(position.x, samples_.x) / side, cell_at(position.y, samples_.y) / side,
                                cell_at(position.z, samples_.z) / side};
    const Block& block = blocks_[(std::size_t{block_place.z} * counts_.y + block_place.y) * counts_.x + block_place.x];
    if (block.place == no_samples) [[unlikely]] {
      return between_corners(block_place, position);
    }
    const SharesAt x(position.x, samples_.x), y(position.y, samples_.y), z(position.z, samples_.z);
    constexpr std::size_t row = samples_along(1), layer = row * row;
    const std::size_t first = (z.nearest - side * block_place.z) * layer + (y.nearest - side * block_place.y) * row +
                              (x.nearest - side * block_place.x);
    const std::span<const float> v =
        std::span(values_).subspan(block.place * samples_of_block(1) + first, 2 * layer + 2 * row + 3);
    Interpolated out{};
    for (std::size_t k = 0; k < 3; ++k) {
      Interpolated of_layer{};
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t at = k * layer + j * row;
        const Real a = static_cast<Real>(v[at]), b = static_cast<Real>(v[at + 1]), c = static_cast<Real>(v[at + 2]);
        const Real value = x.shares[0] * a + x.shares[1] * b + x.shares[2] * c;
        of_layer.value += y.shares[j] * value;
        of_layer.slope.x += y.shares[j] * (x.slopes[0] * a + x.slopes[1] * b + x.slopes[2] * c);
        of_layer.slope.y += y.slopes[j] * value;
      }
      out.value += z.shares[k] * of_layer.value;
      out.slope.x += z.shares[k] * of_layer.slope.x;
      out.slope.y += z.shares[k] * of_layer.slope.y;
      out.slope.z += z.slopes[k] * of_layer.value;
    }
    return out;
  }

  // A sample; in a block without samples it is interpolated.
  [[nodiscard]] Real sample(const GridPlace& at) const;
  // Sets the samples of a box to value_of(place). Of a block without samples only its corners are set.
  template <class ValueOf>
  void set(const GridBox& box, ValueOf&& value_of) {
    visit_blocks(with_fringe(box), [&](std::uint32_t number) {
      const GridPlace block = block_at(number);
      const Stretch along_x = common(box.first.x, box.count.x, block.x, samples_.x),
                    along_y = common(box.first.y, box.count.y, block.y, samples_.y),
                    along_z = common(box.first.z, box.count.z, block.z, samples_.z);
      for (std::uint32_t k = along_z.first; k < along_z.end; ++k) {
        for (std::uint32_t j = along_y.first; j < along_y.end; ++j) {
          for (std::uint32_t i = along_x.first; i < along_x.end; ++i) {
            write(number, {i, j, k}, static_cast<float>(value_of(GridPlace{i, j, k})));
          }
        }
      }
    });
  }
  // Whether all samples of a box are held.
  [[nodiscard]] bool holds(const GridBox& box) const;
  // After samples and corners were written: what is known of the blocks at these samples.
  void measure(const GridBox& box);
  // The least magnitude of values where blocks with samples meet blocks without; zero where both signs occur.
  [[nodiscard]] Real least_beside_empty() const;
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
  // What the three samples around a position along an axis have to do with the value there.
  struct SharesAt {
    inline SharesAt(Real position, std::uint32_t samples)
        : nearest(std::min(static_cast<std::uint32_t>(position + 0.5), samples - 1)) {
      const NearestSample ends{nearest == 0, nearest == samples - 1};
      const Real away = position - nearest;
      shares = ends.shares(away, away);
      slopes = ends.slopes(away);
    }
    std::uint32_t nearest;
    SampleShares shares, slopes;
  };
  struct Stretch {
    std::uint32_t first, end;
  };
  // The samples of a block along one axis, with its fringe.
  [[nodiscard]] inline Stretch held_along(std::uint32_t block, std::uint32_t samples) const {
    const std::uint32_t begin = side * block, end = std::min(begin + side + 1 + fringe_, samples);
    return {begin > 0 ? begin - fringe_ : 0, end};
  }
  // Those that a box and a block have in common.
  [[nodiscard]] inline Stretch common(std::uint32_t first, std::uint32_t count, std::uint32_t block,
                                      std::uint32_t samples) const {
    const Stretch held = held_along(block, samples);
    return {std::max(first, held.first), std::min(first + count, held.end)};
  }
  // All blocks that hold a sample of a box touch this one.
  [[nodiscard]] inline GridBox with_fringe(const GridBox& box) const {
    const auto wider = [&](std::uint32_t first, std::uint32_t count, std::uint32_t samples) {
      const std::uint32_t low = first > fringe_ ? first - fringe_ : 0, end = std::min(first + count + fringe_, samples);
      return Stretch{low, end - low};
    };
    const Stretch x = wider(box.first.x, box.count.x, samples_.x), y = wider(box.first.y, box.count.y, samples_.y),
                  z = wider(box.first.z, box.count.z, samples_.z);
    return {{x.first, y.first, z.first}, {x.end, y.end, z.end}};
  }
  // Where a block that holds samples has one of these, seen from its first cell.
  [[nodiscard]] inline std::size_t place_in(const Block& block, const GridPlace& in_block) const {
    const std::size_t row = samples_along(fringe_);
    return block.place * samples_of_block(fringe_) + ((in_block.z + fringe_) * row + (in_block.y + fringe_)) * row +
           (in_block.x + fringe_);
  }
  // A sample of a block, which may be one of its corners.
  void write(std::uint32_t number, const GridPlace& sample, float value);
  void measure_block(std::uint32_t number);
  void measure_with_fringe(std::uint32_t number);
  void include_side(std::uint32_t number, int axis, bool is_upper, std::pair<float, float>& range) const;
  [[nodiscard]] Real steepest_of(const CellCorners& corners, const Vec3& size) const;

  GridPlace samples_, counts_;  // counts_: of the blocks
  std::uint32_t fringe_;
  Vec3 spacing_;
  std::vector<Block> blocks_;
  std::vector<float> corners_;  // of blocks, along X first
  std::vector<float> values_;
};

}  // namespace abut
