// SPDX-License-Identifier: Apache-2.0
// A convex core among triangles, behind functions: whether they overlap is asked in code that is compiled once for all
// kinds.
export module abut.narrow.overlap.surfaces.core_among_triangles;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.triangle.quick_axes;
import abut.narrow.triangle.triangle_point;
import abut.narrow.triangle.triangle_segment;
import abut.narrow.overlap.convex_side;

export namespace abut {

class CoreAmongTriangles : public ConvexSide {
 public:
  // The frame of the triangles, in which the shape is placed.
  virtual void place(const Pose& pose) = 0;
  // A bit for each triangle that may be nearer to the core than a limit.
  [[nodiscard]] virtual std::uint64_t near(const FourTriangles& triangles, Real limit) const = 0;
  // Whether the core is within a reach of a triangle; nothing where only a search tells it.
  [[nodiscard]] virtual std::optional<bool> is_within(const TriangleCorners& triangle, Real reach) const = 0;

 protected:
  using ConvexSide::ConvexSide;
  CoreAmongTriangles(const CoreAmongTriangles&) = default;
  CoreAmongTriangles& operator=(const CoreAmongTriangles&) = default;
  ~CoreAmongTriangles() = default;
};

// Whether a segment goes through a triangle. Rounding decides where it meets an edge.
[[nodiscard]] inline bool is_pierced(const TriangleCorners& triangle, const Vec3& from, const Vec3& to) {
  const auto& [a, b, c] = triangle;
  const Vec3 normal = cross(b - a, c - a), along = to - from;
  const Real low = dot(normal, from - a), high = dot(normal, to - a);
  if ((low > 0 && high > 0) || (low < 0 && high < 0) || low == high) {
    return false;
  }
  const Vec3 pa = a - from, pb = b - from, pc = c - from;
  const Real of_a = dot(along, cross(pb, pc)), of_b = dot(along, cross(pc, pa)), of_c = dot(along, cross(pa, pb));
  return (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
}

template <Convex B>
class PlacedCore final : public CoreFunctions<B, CoreAmongTriangles> {
 public:
  using CoreFunctions<B, CoreAmongTriangles>::CoreFunctions;

  void place(const Pose& pose) override {
    pose_ = pose;
    axes_.emplace(this->core(), pose);
  }
  [[nodiscard]] std::uint64_t near(const FourTriangles& triangles, Real limit) const override {
    return axes_->near(triangles, limit);
  }
  [[nodiscard]] std::optional<bool> is_within(const TriangleCorners& triangle, Real reach) const override {
    if constexpr (PointCored<B>) {
      return squared_norm(pose_.position - nearest_on(triangle, pose_.position)) <= reach * reach;
    } else if constexpr (SegmentCored<B>) {
      const Vec3 &middle = pose_.position, &axis = pose_.rotation.z;
      const Real length = this->core().half().z;
      return near_points_of_segment(triangle, middle, axis, length).square <= reach * reach ||
             is_pierced(triangle, middle - length * axis, middle + length * axis);
    } else {
      return std::nullopt;
    }
  }

 private:
  Pose pose_ = Pose::identity();
  std::optional<QuickAxes<B>> axes_;
};

}  // namespace abut
