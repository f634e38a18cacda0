// SPDX-License-Identifier: Apache-2.0
// Axis-aligned boxes: exact ones in double, and compact ones in float for the broad phase.
export module abut.math.aabb;
import abut.core.standard;
import abut.math.lanes;
import abut.math.vec3;
import abut.math.pose;

export namespace abut {

// All points from low to high, both included. Unbounded shapes have infinite sides.
struct Aabb {
  Vec3 low, high;

  [[nodiscard]] static inline constexpr Aabb empty() {
    return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  }
  [[nodiscard]] static inline constexpr Aabb everything() {
    return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  }
  [[nodiscard]] static inline constexpr Aabb around(const Vec3& centre, const Vec3& half) {
    return {centre - half, centre + half};
  }
  inline constexpr void include(const Vec3& p) {
    low = minimum(low, p);
    high = maximum(high, p);
  }
  inline constexpr void include(const Aabb& other) {
    low = minimum(low, other.low);
    high = maximum(high, other.high);
  }
  [[nodiscard]] inline constexpr bool overlaps(const Aabb& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y &&
           low.z <= other.high.z && other.low.z <= high.z;
  }
  [[nodiscard]] inline constexpr Aabb inflated(Real by) const {
    return {low - Vec3{by, by, by}, high + Vec3{by, by, by}};
  }
  // All that it passes between two shifts.
  [[nodiscard]] inline constexpr Aabb swept(const Vec3& from, const Vec3& to) const {
    return {low + minimum(from, to), high + maximum(from, to)};
  }
  [[nodiscard]] inline constexpr Vec3 centre() const { return 0.5 * (low + high); }
  [[nodiscard]] inline bool is_bounded() const { return is_finite(low) && is_finite(high); }
  [[nodiscard]] inline constexpr Real squared_distance(const Vec3& p) const {
    const Vec3 outside = maximum(maximum(low - p, p - high), Vec3{0, 0, 0});
    return squared_norm(outside);
  }
};

// The box of a box under a pose (Arvo, "Transforming axis-aligned bounding boxes", 1990).
[[nodiscard]] inline Aabb transformed(const Aabb& box, const Pose& pose) {
  if (!box.is_bounded()) {
    return Aabb::everything();
  }
  const Vec3 half = 0.5 * (box.high - box.low);
  const Rotation& r = pose.rotation;
  const Vec3 extent = half.x * absolute(r.x) + half.y * absolute(r.y) + half.z * absolute(r.z);
  return Aabb::around(pose * box.centre(), extent);
}

// 24 bytes: an Aabb relative to an origin, each side rounded outward to the next float.
struct CompactAabb {
  std::array<float, 3> low, high;

  [[nodiscard]] inline bool overlaps(const CompactAabb& other) const {
    // Without short circuits the six comparisons become two vector instructions.
    return static_cast<bool>(int{low[0] <= other.high[0]} & int{other.low[0] <= high[0]} &
                             int{low[1] <= other.high[1]} & int{other.low[1] <= high[1]} &
                             int{low[2] <= other.high[2]} & int{other.low[2] <= high[2]});
  }
  [[nodiscard]] inline bool contains(const CompactAabb& other) const {
    return low[0] <= other.low[0] && low[1] <= other.low[1] && low[2] <= other.low[2] && high[0] >= other.high[0] &&
           high[1] >= other.high[1] && high[2] >= other.high[2];
  }
};
static_assert(sizeof(CompactAabb) == 24);

using SingleLanes = float __attribute__((ext_vector_type(4)));

// The greatest single numbers that are not above numbers. Single numbers of one sign are ordered as their bits are;
// with all bits but the sign turned over in negative ones, all are.
[[nodiscard]] [[gnu::always_inline]] inline SingleLanes round_down(Lanes values) {
  using Bits = std::int32_t __attribute__((ext_vector_type(4)));
  const auto in_order = [](Bits bits) { return bits ^ ((bits >> 31) & std::numeric_limits<std::int32_t>::max()); };
  const SingleLanes nearest = __builtin_convertvector(values, SingleLanes);
  // Minus one where the nearest one is above.
  const Bits step = __builtin_convertvector(__builtin_convertvector(nearest, Lanes) > values, Bits);
  return std::bit_cast<SingleLanes>(in_order(in_order(std::bit_cast<Bits>(nearest)) + step));
}

[[nodiscard]] inline CompactAabb compact(const Aabb& box, const Vec3& origin) {
  const auto below = [](Lanes values, Lanes base) {
    // The subtraction rounds too; one unit in the last place of the operands covers it.
    const Lanes moved = values - base - epsilon * (absolute(values) + absolute(base));
    return round_down(absolute(values) < infinity ? moved : values);
  };
  const SingleLanes low = below(lanes_of(box.low), lanes_of(origin));
  const SingleLanes high = -below(-lanes_of(box.high), -lanes_of(origin));
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace abut
