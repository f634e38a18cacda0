// SPDX-License-Identifier: Apache-2.0
// How large triangles look from a point, with a sign: positive where their backs are seen. Half of the solid angle of
// one is the angle of a complex number (van Oosterom, Strackee, "The solid angle of a plane triangle", 1983). The
// angles of many are added as these numbers are multiplied, with the turns counted.
export module abut.trees.inside.solid_angle;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.wide;

export namespace abut {

// Of complex numbers that are not zero, from -pi to pi. Square roots and divisions are the same on every processor.
[[nodiscard]] Real angle_of(Real real, Real imaginary);

// Corners of four triangles, as seen from a point.
struct CornersSeen {
  Columns a, b, c;
};

// Of half of a solid angle, up to a common factor.
struct HalfAngle {
  Real sine, cosine;
};
// With twice the digits. From a point on a triangle half of it is seen on either side: together nothing.
[[nodiscard]] HalfAngle half_angle(const std::array<WideVec3, 3>& corners);

class SolidAngles {
 public:
  // Four triangles. `exactly(lane)`: the corners of one of them with twice the digits.
  template <class Exactly>
  inline void add(const CornersSeen& seen, const Exactly& exactly) {
    const auto& [a, b, c] = seen;
    const Lanes of_a = length(a), of_b = length(b), of_c = length(c), size = of_a * of_b * of_c;
    Lanes sine = dot(a, cross(b, c));
    Lanes cosine = size + dot(a, b) * of_c + dot(b, c) * of_a + dot(c, a) * of_b;
    // From a point near the plane of a triangle, rounding may take the sign; near an edge or a corner, all digits.
    const LaneNumbers on_plane = (absolute(sine) <= sign_blur * size) & (cosine <= clear_share * size);
    const LaneNumbers at_edge = absolute(sine) + absolute(cosine) <= edge_share * size;
    if (const std::uint64_t doubtful = bits_of(on_plane | at_edge); doubtful != 0) [[unlikely]] {
      for (std::uint64_t left = doubtful; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const HalfAngle found = half_angle(exactly(lane));
        sine[lane] = found.sine;
        cosine[lane] = found.cosine;
      }
    }
    multiply(cosine, sine);
  }

  // The sum over four pi. A closed surface that is seen from inside has one turn.
  [[nodiscard]] Real turns() const;

 private:
  // Shares of the product of three lengths.
  static constexpr Real sign_blur = 64 * epsilon, clear_share = 1e-3, edge_share = 1e-5;

  [[nodiscard]] static inline Lanes length(const Columns& v) { return __builtin_elementwise_sqrt(dot(v, v)); }

  inline void multiply(Lanes real, Lanes imaginary) {
    const Lanes product = real_ * real - imaginary_ * imaginary, crossed = real_ * imaginary + imaginary_ * real;
    // Past the negative axis: two angles above it have a sum below it, or the other way round.
    turns_ -= (imaginary_ >= 0) & (imaginary >= 0) & (crossed < 0);
    turns_ += (imaginary_ < 0) & (imaginary < 0) & (crossed >= 0);
    const Lanes scale = 1 / (absolute(product) + absolute(crossed));
    real_ = product * scale;
    imaginary_ = crossed * scale;
  }

  Lanes real_ = all_lanes(1), imaginary_ = all_lanes(0);
  LaneNumbers turns_ = {0, 0, 0, 0};
};

}  // namespace abut
