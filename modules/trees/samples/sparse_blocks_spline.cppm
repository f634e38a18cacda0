// SPDX-License-Identifier: Apache-2.0
// Tri-quadratic B-splines between samples of a field. Value and gradient are continuous. Both are means, of samples and
// of differences between neighbours: they stay within these, and what is linear stays as it is.
//
// Along an axis a value is made of three samples, the nearest one and its neighbours. At an end of the grid one of them
// is missing, and the value is linear in the half cell there.
export module abut.trees.samples.sparse_blocks_spline;
import abut.core.standard;
import abut.math;

export namespace abut {

// Of a sample and its neighbours along an axis.
using SampleShares = std::array<Real, 3>;

// The nearest of some samples along an axis. Positions are in cells, from this sample on.
struct NearestSample {
  bool is_first, is_last;

  // The polar form: it gives the shares at s where both are the same, and coefficients of Bernstein where they are ends
  // of a stretch.
  [[nodiscard]] [[gnu::always_inline]] inline SampleShares shares(Real s, Real t) const {
    const Real before = 0.5 * (0.5 - s) * (0.5 - t), after = 0.5 * (0.5 + s) * (0.5 + t);
    if (is_first || is_last) [[unlikely]] {
      const Real at = 0.5 * (s + t);
      return is_first ? SampleShares{0, 1 - at, at} : SampleShares{-at, 1 + at, 0};
    }
    return {before, 1 - before - after, after};
  }
  // Of the slope for each cell.
  [[nodiscard]] [[gnu::always_inline]] inline SampleShares slopes(Real s) const {
    if (is_first || is_last) [[unlikely]] {
      return is_first ? SampleShares{0, -1, 1} : SampleShares{-1, 1, 0};
    }
    return {s - 0.5, -2 * s, 0.5 + s};
  }
  // How far its part of the axis reaches.
  [[nodiscard]] inline Real low() const { return is_first ? 0 : -0.5; }
  [[nodiscard]] inline Real high() const { return is_last ? 0 : 0.5; }
};

// The samples around one, along X first.
using SamplesAround = std::array<float, 27>;

// A piece of a spline in Bernstein form: values in its box lie between these numbers. Corners have the values there.
struct SplinePatch {
  std::array<Real, 27> c;

  // `low` and `high` are the ends of the box, seen from the sample in the middle.
  [[nodiscard]] static SplinePatch make(const SamplesAround& samples, const std::array<NearestSample, 3>& middle,
                                        const Vec3& low, const Vec3& high);

  [[nodiscard]] Real corner(std::size_t bits) const {
    return c[(bits & 1 ? 2u : 0u) + (bits & 2 ? 6u : 0u) + (bits & 4 ? 18u : 0u)];
  }
  [[nodiscard]] Real least() const { return *std::ranges::min_element(c); }
  [[nodiscard]] bool has_both_signs() const {
    const auto inside = std::ranges::count_if(c, [](Real value) { return value < 0; });
    return inside > 0 && inside < 27;
  }
  // Half of it along an axis.
  [[nodiscard]] SplinePatch half(int axis, bool is_upper) const;
  // Along the diagonal from the lowest to the highest corner, in Bernstein form.
  [[nodiscard]] std::array<Real, 7> diagonal() const;
};

}  // namespace abut
