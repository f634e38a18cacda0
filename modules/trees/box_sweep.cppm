// Where a box that moves along a line meets boxes.
export module abut.trees.box_sweep;
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
    std::array<Real, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = static_cast<Real>(box.low[axis]);
      high[axis] = static_cast<Real>(box.high[axis]);
    }
    return entries(low, high, most);
  }

  // The same for one number or for a vector of them for each side.
  template <class Value>
  [[nodiscard]] [[gnu::always_inline]] inline Value entries(const std::array<Value, 3>& low,
                                                            const std::array<Value, 3>& high, Real most) const {
    Value enter = Value(0.0), leave = Value(most);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real centre = centres_[axis], half = halves_[axis], displacement = displacements_[axis];
      // Two operations, each rounded by at most epsilon times the sum of the sizes of all three operands.
      const Real slack = 4 * epsilon * (std::fabs(centre) + half);
      const Value below = outward(low[axis], -1) - half - centre - slack;
      const Value above = outward(high[axis], 1) + half - centre + slack;
      if (displacement == 0) {
        // Met always or never.
        leave = below > 0.0 ? Value(-1.0) : above < 0.0 ? Value(-1.0) : leave;
        continue;
      }
      const Value nearer = outward((displacement > 0 ? below : above) / displacement, -1);
      const Value farther = outward((displacement > 0 ? above : below) / displacement, 1);
      enter = nearer > enter ? nearer : enter;
      leave = farther < leave ? farther : leave;
    }
    return enter <= leave ? enter : Value(infinity);
  }

 private:
  // By a few roundings towards minus or plus infinity. Products keep infinities as they are.
  template <class Value>
  [[nodiscard]] [[gnu::always_inline]] static inline Value outward(const Value& value, Real direction) {
    const Real grow = 1 + 4 * epsilon, shrink = 1 - 4 * epsilon;
    return direction < 0 ? (value > 0.0 ? value * shrink : value * grow)
                         : (value > 0.0 ? value * grow : value * shrink);
  }

  std::array<Real, 3> centres_, halves_, displacements_;
};

}  // namespace abut
