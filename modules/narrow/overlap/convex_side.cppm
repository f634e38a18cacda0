// SPDX-License-Identifier: Apache-2.0
// A convex shape behind functions, for the question whether two shapes overlap, which is compiled once for all kinds.
export module abut.narrow.overlap.convex_side;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.many.quick_axes;
import abut.narrow.many.triangle_point;
import abut.narrow.many.triangle_segment;

export namespace abut {

// Cores that closed forms know: boxes around the origin along their own axes, a segment along Z being one of them.
enum class CoreForm : std::uint8_t { point, segment, box, other };

struct FormOfCore {
  CoreForm form;
  Vec3 half;  // of a core that closed forms know
  Real radius;
};
template <Convex B>
[[nodiscard]] inline FormOfCore form_of_core(const B& core) {
  if constexpr (BoxCored<B>) {
    constexpr CoreForm form = PointCored<B> ? CoreForm::point : SegmentCored<B> ? CoreForm::segment : CoreForm::box;
    return {form, core.half(), core.radius()};
  } else {
    return {CoreForm::other, {0, 0, 0}, core.radius()};
  }
}

// All is in the frame of the shape where nothing else is said.
class ConvexSide {
 public:
  // Of the core.
  Vec3 centre;
  Real extent;  // as in Convex
  Real radius;
  FormOfCore form;
  bool is_curved;

  // The point of the core that lies furthest in a direction.
  [[nodiscard]] virtual Vec3 support(const Vec3& direction) const = 0;
  // From the core to a point, negative inside; nothing where only a search tells it.
  [[nodiscard]] virtual std::optional<Real> distance_to(const Vec3& point) const = 0;
  // The box around the rounded shape where it is placed.
  [[nodiscard]] virtual Aabb box_at(const Pose& pose) const = 0;

  // The frame of the triangles of the two functions below, in which the shape is placed.
  virtual void place_among_triangles(const Pose& pose) = 0;
  // A bit for each triangle that may be nearer to the core than a limit.
  [[nodiscard]] virtual std::uint64_t near(const FourTriangles& triangles, Real limit) const = 0;
  // Whether the core is within a reach of a triangle; nothing where only a search tells it.
  [[nodiscard]] virtual std::optional<bool> is_within(const TriangleCorners& triangle, Real reach) const = 0;

 protected:
  ConvexSide(const Vec3& its_centre, Real its_extent, const FormOfCore& its_form, bool curved)
      : centre(its_centre), extent(its_extent), radius(its_form.radius), form(its_form), is_curved(curved) {}
  ConvexSide(const ConvexSide&) = default;
  ConvexSide& operator=(const ConvexSide&) = default;
  ~ConvexSide() = default;
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
class CoreSide final : public ConvexSide {
 public:
  explicit CoreSide(const B& core)
      : ConvexSide(core.centre(), core.extent(), form_of_core(core), Curved<B>), core_(core) {}

  [[nodiscard]] Vec3 support(const Vec3& direction) const override { return core_.support(direction).point; }
  [[nodiscard]] std::optional<Real> distance_to(const Vec3& point) const override {
    if constexpr (Field<B>) {
      return core_.nearest(point).distance;
    } else {
      return std::nullopt;
    }
  }
  [[nodiscard]] Aabb box_at(const Pose& pose) const override { return core_.aabb(pose); }

  void place_among_triangles(const Pose& pose) override {
    pose_ = pose;
    axes_.emplace(core_, pose);
  }
  [[nodiscard]] std::uint64_t near(const FourTriangles& triangles, Real limit) const override {
    return axes_->near(triangles, limit);
  }
  [[nodiscard]] std::optional<bool> is_within(const TriangleCorners& triangle, Real reach) const override {
    if constexpr (PointCored<B>) {
      return squared_norm(pose_.position - nearest_on(triangle, pose_.position)) <= reach * reach;
    } else if constexpr (SegmentCored<B>) {
      const Vec3 &middle = pose_.position, &axis = pose_.rotation.z;
      const Real length = core_.half().z;
      return near_points_of_segment(triangle, middle, axis, length).square <= reach * reach ||
             is_pierced(triangle, middle - length * axis, middle + length * axis);
    } else {
      return std::nullopt;
    }
  }

 private:
  const B& core_;
  Pose pose_ = Pose::identity();
  std::optional<QuickAxes<B>> axes_;
};

}  // namespace abut
