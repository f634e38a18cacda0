// SPDX-License-Identifier: Apache-2.0
// How far from the surface of a sampled field a point lies at least, from the value there. Values change along a way no
// faster than the steepest gradient among those values. So the way through each range of values has a least length.
export module abut.shapes.distance_field.ways;
import abut.core.standard;
import abut.math;
import abut.trees.samples.sparse_blocks;

export namespace abut {

class DistanceFieldWays {
 public:
  DistanceFieldWays() = default;
  explicit DistanceFieldWays(std::span<const SparseBlocks::Block> blocks) : outside_(blocks, 1), inside_(blocks, -1) {}

  // `slack`: how far the field may be off where it is coarse.
  [[nodiscard]] Real least(Real value, Real slack) const {
    const Real way = value < 0 ? inside_.least(-value) : outside_.least(value);
    return way > slack ? way - slack : 0;
  }

 private:
  class Side {
   public:
    Side() = default;
    Side(std::span<const SparseBlocks::Block> blocks, Real sign) {
      const auto low = [&](const SparseBlocks::Block& block) {
        return static_cast<Real>(sign > 0 ? block.low : -block.high);
      };
      const auto high = [&](const SparseBlocks::Block& block) {
        return static_cast<Real>(sign > 0 ? block.high : -block.low);
      };
      Real most = 0;
      for (const SparseBlocks::Block& block : blocks) {
        most = std::max(most, high(block));
      }
      step_ = most / ranges;
      std::array<Real, ranges> steepest{};
      for (const SparseBlocks::Block& block : blocks) {
        if (high(block) >= 0) {
          for (std::size_t i = range_of(low(block)); i <= range_of(high(block)); ++i) {
            steepest[i] = std::max(steepest[i], static_cast<Real>(block.steepest));
          }
        }
      }
      for (std::size_t i = 0; i < ranges; ++i) {
        slopes_[i] = 1 / std::max(steepest[i], Real{1});
        ways_[i + 1] = ways_[i] + step_ * slopes_[i];
      }
    }

    [[nodiscard]] Real least(Real value) const {
      const std::size_t range = range_of(value);
      // Beyond all values, outside of the grid, one is a length.
      const Real beyond = std::max(value - step_ * ranges, Real{0});
      return ways_[range] + (std::min(value, step_ * ranges) - step_ * static_cast<Real>(range)) * slopes_[range] +
             beyond;
    }

   private:
    static constexpr std::size_t ranges = 32;
    [[nodiscard]] std::size_t range_of(Real value) const {
      const Real range = step_ > 0 ? value / step_ : 0;
      return range > 0 ? static_cast<std::size_t>(std::min(range, static_cast<Real>(ranges - 1))) : 0;
    }

    Real step_ = 0;  // between the values of ranges
    std::array<Real, ranges> slopes_{};
    std::array<Real, ranges + 1> ways_{};  // to the first value of each range
  };

  Side outside_, inside_;
};

}  // namespace abut
