// SPDX-License-Identifier: Apache-2.0
// The core of segments and capsules: a segment along Z around the origin, and a radius.
export module abut.capability.cores.segment_core;
import abut.capability.concepts;
import abut.capability.cores.placed_support;
import abut.capability.records;
import abut.core.standard;
import abut.math;

export namespace abut {

// How far the surface of a rounded core lies from a point of the core, along a direction of length one.
struct RoundReach {
  Real reach;
  bool is_of_other_end;  // the way ends on the ball around an end of the core that is not the point
};
// From the point at a height `z` of a segment along Z. Where the direction leans toward an end, the way leaves
// through the side or through the ball around that end.
[[nodiscard]] inline RoundReach reach_of_round_segment(Real half_length, Real radius, Real z, const Vec3& direction) {
  const Real left = direction.z >= 0 ? half_length - z : half_length + z;
  if (!(radius > 0 && left > 0)) {
    return {radius, false};
  }
  const Real across = std::sqrt(direction.x * direction.x + direction.y * direction.y), along = std::fabs(direction.z);
  if (across > 0 && along * radius <= left * across) {
    return {radius / across, false};
  }
  const Real aside = left * across;
  return {left * along + std::sqrt(radius * radius - aside * aside), true};
}
// From an end of the segment.
[[nodiscard]] inline RoundReach reach_from_end(Real half_length, Real radius, bool is_upper, const Vec3& direction) {
  return reach_of_round_segment(half_length, radius, is_upper ? half_length : -half_length, direction);
}

class SegmentCore {
 public:
  using Core = SegmentCore;
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 1;

  inline SegmentCore(Real half_length, Real radius) : half_length_(half_length), radius_(radius) {}

  [[nodiscard]] inline Real half_length() const { return half_length_; }
  [[nodiscard]] inline Real radius() const { return radius_; }
  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Vec3 r{radius_, radius_, radius_};
    return Aabb::around(pose.position, half_length_ * absolute(pose.rotation.z) + r);
  }
  [[nodiscard]] inline Vec3 half() const { return {0, 0, half_length_}; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return half_length_; }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const bool upper = direction.z >= 0;
    return {{0, 0, upper ? half_length_ : -half_length_}, upper ? 1u : 0u};
  }
  [[nodiscard]] inline Real reach(const Vec3& direction) const { return half_length_ * std::fabs(direction.z); }
  [[nodiscard]] inline std::uint32_t corner_count() const { return half_length_ > 0 ? 2 : 1; }
  [[nodiscard]] inline Vec3 corner(std::uint32_t index) const {
    return {0, 0, index == 0 ? -half_length_ : half_length_};
  }
  [[nodiscard]] inline PlacedSegment placed(const Pose& pose) const {
    return {pose.position, half_length_ * pose.rotation.z};
  }
  [[nodiscard]] inline Face supporting_face(const Vec3&) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, -half_length_}, 0, 0});
    if (half_length_ > 0) {
      face.vertices.push_back({{0, 0, half_length_}, 1, 0});
    }
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const {
    return {half_length_ > 0 ? FeatureKind::edge : FeatureKind::vertex, 0};
  }
  [[nodiscard]] inline std::array<Vec3, 0> face_normals() const { return {}; }
  [[nodiscard]] inline std::array<Vec3, 1> edge_directions() const { return {Vec3{0, 0, 1}}; }

 private:
  Real half_length_, radius_;
};
static_assert(Placeable<SegmentCore> && SegmentCored<SegmentCore> && FewFaced<SegmentCore>);

}  // namespace abut
