// SPDX-License-Identifier: Apache-2.0
// Where a box that moves along a line meets boxes.
export module abut.trees.volumes.box_sweep;
import abut.core.standard;
import abut.math;

export namespace abut {

// A box with this centre and half extents, displaced by t times the displacement. A ray has no extent.
class BoxSweep {
 public:
  BoxSweep(const Vec3& centre, const Vec3& half, const Vec3& displacement)
      : centres_{centre.x, centre.y, centre.z},
        halves_{half.x, half.y, half.z},
        displacements_{displacement.x, displacement.y, displacement.z} {}

  // The least t in [0, most] at which a box is met, or infinity. It never comes later than in exact arithmetic.
  [[nodiscard]] inline Real entry(const CompactAabb& box, Real most) const {
    Real enter = 0, leave = most;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real centre = centres_[axis], half = halves_[axis], displacement = displacements_[axis];
      // Two operations, each rounded by at most epsilon times the sum of the sizes of all three operands.
      const Real slack = 4 * epsilon * (std::fabs(centre) + half);
      const Real below = outward(static_cast<Real>(box.low[axis]), -1) - half - centre - slack;
      const Real above = outward(static_cast<Real>(box.high[axis]), 1) + half - centre + slack;
      if (displacement == 0) {
        // Met always or never.
        leave = below > 0 || above < 0 ? -1 : leave;
        continue;
      }
      enter = std::max(enter, outward((displacement > 0 ? below : above) / displacement, -1));
      leave = std::min(leave, outward((displacement > 0 ? above : below) / displacement, 1));
    }
    return enter <= leave ? enter : infinity;
  }

 private:
  friend class CompactSweep;

  // By a few roundings towards minus or plus infinity. Products keep infinities as they are.
  [[nodiscard]] static inline Real outward(Real value, Real direction) {
    return value * (direction * value > 0 ? 1 + 4 * epsilon : 1 - 4 * epsilon);
  }

  std::array<Real, 3> centres_, halves_, displacements_;
};

// The same in the precision of compact boxes, for eight of them at once. Its way is t scaled by a power of two, such
// that the largest part of the displacement is between 1 and 2: no product of it with a side overflows early.
class CompactSweep {
 public:
  using Floats = float __attribute__((ext_vector_type(8)));
  using Way = float;

  explicit CompactSweep(const BoxSweep& sweep) {
    Real largest = 0;
    for (const Real displacement : sweep.displacements_) {
      largest = std::max(largest, std::fabs(displacement));
    }
    // Beyond that, slower parts rule nothing out, and no scale is infinite.
    constexpr int most = 1000;
    const int exponent = largest > 0 ? std::clamp(std::ilogb(largest), -most, most) : 0;
    way_of_time_ = std::ldexp(1.0, exponent);
    const Real scale = std::ldexp(1.0, -exponent);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real centre = sweep.centres_[axis], half = sweep.halves_[axis], displacement = sweep.displacements_[axis];
      const Real share = displacement * scale;
      constexpr Real slowest = 1e-37;
      if (displacement != 0 && std::fabs(share) < slowest) {
        // Its inverse is no float: this axis rules nothing out.
        low_[axis] = -infinite;
        high_[axis] = infinite;
        continue;
      }
      low_[axis] = -rounded_up(half - centre);
      high_[axis] = rounded_up(centre + half);
      inverses_[axis] = displacement == 0 ? 0.0f : static_cast<float>(1 / share);
    }
  }

  // Of t, not less than it is.
  [[nodiscard]] inline float way_of(Real t) const { return rounded_up(t * way_of_time_); }

  // The least ways up to `most` at which boxes are met, or infinity. The sides are low ones, then negated high ones.
  // They never come later than in exact arithmetic.
  template <class SideOf>
  [[nodiscard]] [[gnu::always_inline]] inline Floats entries(const SideOf& side, float most) const {
    Floats enter(0.0f), leave(most);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Rounded by a share of themselves, since the sides of the moving box are rounded outward.
      const Floats below = side(axis) - high_[axis], above = -side(axis + 3) - low_[axis];
      const float inverse = inverses_[axis];
      if (inverse == 0) {
        leave = below > 0.0f ? Floats(-1.0f) : above < 0.0f ? Floats(-1.0f) : leave;
        continue;
      }
      const Floats nearer = (inverse > 0 ? below : above) * inverse, farther = (inverse > 0 ? above : below) * inverse;
      enter = nearer > enter ? nearer : enter;
      leave = farther < leave ? farther : leave;
    }
    // Four roundings by half a unit each; the least normal number covers those of numbers below it.
    constexpr float slack = 4 * std::numeric_limits<float>::epsilon(), least = std::numeric_limits<float>::min();
    enter = enter * (1 - slack) - least;
    leave = leave * (1 + slack) + least;
    // Ways beyond the largest float count as that.
    constexpr float largest = std::numeric_limits<float>::max();
    const Floats after_start = enter > 0.0f ? enter : Floats(0.0f);
    const Floats met = after_start < largest ? after_start : Floats(largest);
    return enter <= leave ? met : Floats(infinite);
  }

 private:
  static constexpr float infinite = std::numeric_limits<float>::infinity();

  // A float that is not below the value: at least the one after the nearest.
  [[nodiscard]] static inline float rounded_up(Real value) {
    using Limits = std::numeric_limits<float>;
    constexpr Real largest = static_cast<Real>(Limits::max());
    const auto near = static_cast<float>(std::clamp(value, -largest, largest));
    return value > largest ? infinite : near + std::fabs(near) * Limits::epsilon() + Limits::min();
  }

  std::array<float, 3> low_{}, high_{};  // of the moving box at its start
  std::array<float, 3> inverses_{};      // of the displacement, scaled; 0 along an axis without motion
  Real way_of_time_ = 1;
};

}  // namespace abut
