// SPDX-License-Identifier: Apache-2.0
// The core of points, spheres and particles: the origin, and a radius.
export module abut.capability.cores.point_core;
import abut.capability.concepts;
import abut.capability.cores.placed_support;
import abut.capability.records;
import abut.core.standard;
import abut.math;

export namespace abut {

class PointCore {
 public:
  using Core = PointCore;
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 0;

  inline explicit PointCore(Real radius) : radius_(radius) {}

  [[nodiscard]] inline Real radius() const { return radius_; }
  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    return Aabb::around(pose.position, {radius_, radius_, radius_});
  }
  [[nodiscard]] inline Vec3 half() const { return {0, 0, 0}; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return 0; }
  [[nodiscard]] inline SupportPoint support(const Vec3&) const { return {{0, 0, 0}, 0}; }
  [[nodiscard]] inline Real reach(const Vec3&) const { return 0; }
  [[nodiscard]] inline std::uint32_t corner_count() const { return 1; }
  [[nodiscard]] inline Vec3 corner(std::uint32_t) const { return {0, 0, 0}; }
  [[nodiscard]] inline PlacedPoint placed(const Pose& pose) const { return {pose.position}; }
  [[nodiscard]] inline Face supporting_face(const Vec3&) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, 0}, 0, 0});
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const { return {FeatureKind::vertex, 0}; }
  [[nodiscard]] inline std::array<Vec3, 0> face_normals() const { return {}; }
  [[nodiscard]] inline std::array<Vec3, 0> edge_directions() const { return {}; }

 private:
  Real radius_;
};
static_assert(Placeable<PointCore> && PointCored<PointCore> && FewFaced<PointCore>);

}  // namespace abut
