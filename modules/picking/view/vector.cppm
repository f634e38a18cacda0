// SPDX-License-Identifier: Apache-2.0
// Vectors, frames and spaces of the picker, on the plain structs of the C interface.
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

export module abut.picking:vector;

namespace abut::picking {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

[[nodiscard]] inline abut_vec3 add(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] inline abut_vec3 subtract(const abut_vec3& a, const abut_vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline abut_vec3 scale(const abut_vec3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
[[nodiscard]] inline double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

[[nodiscard]] inline abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline double length(const abut_vec3& a) { return std::sqrt(dot(a, a)); }

[[nodiscard]] inline double largest_component(const abut_vec3& a) {
  return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

// A squared length this close to 1 needs one Newton step only: it is exact to the last bits.
inline constexpr double nearly_unit = 1e-8;

// A vector times a power of two, so that its largest component is from 1 to 2. Exact; subnormals included.
[[nodiscard]] inline abut_vec3 tamed(const abut_vec3& a) {
  const int exponent = -std::ilogb(largest_component(a));
  return {std::scalbn(a.x, exponent), std::scalbn(a.y, exponent), std::scalbn(a.z, exponent)};
}

// Unit vector of any finite vector but zero. Tamed first where a square may overflow or underflow.
[[nodiscard]] inline abut_vec3 normalized(const abut_vec3& a) {
  const double square = dot(a, a);
  if (square > 1e-200 && square < 1e200) {
    if (std::fabs(square - 1.0) < nearly_unit) return scale(a, 1.5 - 0.5 * square);
    return scale(a, 1.0 / std::sqrt(square));
  }
  const abut_vec3 tame = tamed(a);
  return scale(tame, 1.0 / length(tame));
}

// Four numbers in one register.
using Four = double __attribute__((ext_vector_type(4)));

struct FourRows {
  Four a, b, c, d;
};

// A ray as it lies in memory, in two registers that overlap by one number. Vectors that are put
// together from other parts cost more than all that is computed with them.
[[nodiscard]] inline Four first_half(const abut_ray& ray) {
  return {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x};
}
[[nodiscard]] inline Four last_half(const abut_ray& ray) {
  return {ray.direction.x, ray.direction.y, ray.direction.z, ray.max_distance};
}

// Scalar product of the first three.
[[nodiscard]] inline double dot_of_three(const Four& a, const Four& b) {
  const Four product = a * b;
  return product[0] + product[1] + product[2];
}

// Rows to columns.
[[nodiscard]] inline FourRows transposed(const FourRows& rows) {
  const Four low_ab = __builtin_shufflevector(rows.a, rows.b, 0, 4, 2, 6);
  const Four high_ab = __builtin_shufflevector(rows.a, rows.b, 1, 5, 3, 7);
  const Four low_cd = __builtin_shufflevector(rows.c, rows.d, 0, 4, 2, 6);
  const Four high_cd = __builtin_shufflevector(rows.c, rows.d, 1, 5, 3, 7);
  return {__builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5), __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5),
          __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7), __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7)};
}

// A pose with its rotation as a matrix, whose rows are `rows`.
struct Frame {
  std::array<abut_vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  abut_vec3 position{0, 0, 0};
};

[[nodiscard]] inline Frame frame_of(const abut_pose& pose) {
  const abut_quat& q = pose.orientation;
  const double s = 2.0 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {{{{1 - s * (q.y * q.y + q.z * q.z), s * (q.x * q.y - q.w * q.z), s * (q.x * q.z + q.w * q.y)},
            {s * (q.x * q.y + q.w * q.z), 1 - s * (q.x * q.x + q.z * q.z), s * (q.y * q.z - q.w * q.x)},
            {s * (q.x * q.z - q.w * q.y), s * (q.y * q.z + q.w * q.x), 1 - s * (q.x * q.x + q.y * q.y)}}},
          pose.position};
}

[[nodiscard]] inline abut_vec3 rotate(const Frame& frame, const abut_vec3& v) {
  return {dot(frame.rows[0], v), dot(frame.rows[1], v), dot(frame.rows[2], v)};
}

[[nodiscard]] inline abut_vec3 rotate_back(const Frame& frame, const abut_vec3& v) {
  return add(add(scale(frame.rows[0], v.x), scale(frame.rows[1], v.y)), scale(frame.rows[2], v.z));
}

[[nodiscard]] inline abut_vec3 to_world(const Frame& frame, const abut_vec3& p) {
  return add(rotate(frame, p), frame.position);
}
[[nodiscard]] inline abut_vec3 to_local(const Frame& frame, const abut_vec3& p) {
  return rotate_back(frame, subtract(p, frame.position));
}

inline constexpr abut_aabb empty_box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};

[[nodiscard]] inline bool is_bounded(const abut_aabb& box) {
  return std::isfinite(box.minimum.x) && std::isfinite(box.minimum.y) && std::isfinite(box.minimum.z) &&
         std::isfinite(box.maximum.x) && std::isfinite(box.maximum.y) && std::isfinite(box.maximum.z);
}

inline void extend(abut_aabb& box, const abut_vec3& p) {
  box.minimum = {std::min(box.minimum.x, p.x), std::min(box.minimum.y, p.y), std::min(box.minimum.z, p.z)};
  box.maximum = {std::max(box.maximum.x, p.x), std::max(box.maximum.y, p.y), std::max(box.maximum.z, p.z)};
}

[[nodiscard]] inline abut_vec3 centre_of(const abut_aabb& box) {
  return {0.5 * box.minimum.x + 0.5 * box.maximum.x, 0.5 * box.minimum.y + 0.5 * box.maximum.y,
          0.5 * box.minimum.z + 0.5 * box.maximum.z};
}

[[nodiscard]] inline double diagonal_of(const abut_aabb& box) { return length(subtract(box.maximum, box.minimum)); }

// Largest coordinate of a box relative to a point.
[[nodiscard]] inline double reach_of(const abut_aabb& box, const abut_vec3& origin) {
  return std::max(largest_component(subtract(box.minimum, origin)), largest_component(subtract(box.maximum, origin)));
}

// A cube in which rays are traced in single precision: its centre, and the half of its side.
struct Space {
  abut_vec3 origin{0, 0, 0};
  double extent = 0;

  // In one register. A member function of a named module is inline only when it says so.
  [[nodiscard]] inline Four numbers() const { return {origin.x, origin.y, origin.z, extent}; }
};

// Whether all four are at most as large as the bounds, whatever their signs. Not when one is no number.
[[nodiscard]] inline bool are_within(const Four& a, const Four& bounds) {
  return __builtin_reduce_and(__builtin_elementwise_abs(a) <= bounds) != 0;
}

// Where a ray starts in a space, and how far that is from its own origin.
struct Entrance {
  abut_vec3 point;
  double advance;
};

// Where a ray that starts far outside of a space enters it; none when it passes by.
[[nodiscard]] std::optional<Entrance> enter_from_afar(const Space& space, const abut_vec3& origin,
                                                      const abut_vec3& direction, double limit);

// Rays that start far outside of a space begin where they enter it, so that single precision is
// spent on the space and not on the way. False when such a ray passes by. Inlined: handing the
// result over through memory would cost more than computing it.
[[nodiscard]] [[gnu::always_inline]] inline bool enter(const Space& space, const abut_vec3& origin,
                                                       const abut_vec3& direction, double limit, Entrance& out) {
  out = {subtract(origin, space.origin), 0};
  if (largest_component(out.point) <= 2 * space.extent) [[likely]]
    return true;
  const std::optional<Entrance> entrance = enter_from_afar(space, origin, direction, limit);
  if (!entrance) return false;
  out = *entrance;
  return true;
}

}  // namespace abut::picking
