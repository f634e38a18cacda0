// Four doubles that the compiler keeps in one vector register where the target has one, and vectors of
// space in the first three of them. The fused multiply-add is exact on every target, so answers do not
// depend on whether the processor has one.
module;
#include <cstdint>
export module abut.math.lanes;
import abut.math.pose;
import abut.math.vec3;

export namespace abut {

using Lanes = double __attribute__((ext_vector_type(4)));
using LaneNumbers = std::int64_t __attribute__((ext_vector_type(4)));

// The fourth lane of a vector of space is zero.
[[nodiscard]] inline Lanes lanes_of(const Vec3& a) { return Lanes{a.x, a.y, a.z, 0}; }
[[nodiscard]] inline Vec3 vec3_of(Lanes a) { return {a[0], a[1], a[2]}; }
[[nodiscard]] inline Lanes all_lanes(Real value) { return Lanes{value, value, value, value}; }

[[nodiscard]] inline Lanes absolute(Lanes a) { return __builtin_elementwise_abs(a); }
[[nodiscard]] inline Lanes minimum(Lanes a, Lanes b) { return a < b ? a : b; }
[[nodiscard]] inline Lanes maximum(Lanes a, Lanes b) { return a > b ? a : b; }
// The nearest value within -limit and limit.
[[nodiscard]] inline Lanes clamp(Lanes a, Lanes limit) { return minimum(maximum(a, -limit), limit); }
[[nodiscard]] inline Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return __builtin_elementwise_fma(a, b, c); }

[[nodiscard]] inline Real sum(Lanes a) {
  const auto pairs = a.lo + a.hi;
  return pairs[0] + pairs[1];
}
// Over all four lanes.
[[nodiscard]] inline Real largest(Lanes a) {
  const auto pairs = a.lo > a.hi ? a.lo : a.hi;
  return pairs[0] > pairs[1] ? pairs[0] : pairs[1];
}
[[nodiscard]] inline Real dot(Lanes a, Lanes b) { return sum(a * b); }

// A matrix by its columns.
struct LaneMatrix {
  Lanes x, y, z;
  [[nodiscard]] static inline LaneMatrix columns_of(const Rotation& r) { return {lanes_of(r.x), lanes_of(r.y), lanes_of(r.z)}; }
  [[nodiscard]] static inline LaneMatrix rows_of(const Rotation& r) {
    return {Lanes{r.x.x, r.y.x, r.z.x, 0}, Lanes{r.x.y, r.y.y, r.z.y, 0}, Lanes{r.x.z, r.y.z, r.z.z, 0}};
  }
  [[nodiscard]] inline Lanes operator*(Lanes v) const {
    return multiply_add(z, v.zzzz, multiply_add(y, v.yyyy, x * v.xxxx));
  }
  // The product plus an offset.
  [[nodiscard]] inline Lanes apply(Lanes v, Lanes offset) const {
    return multiply_add(z, v.zzzz, multiply_add(y, v.yyyy, multiply_add(x, v.xxxx, offset)));
  }
};

}  // namespace abut
