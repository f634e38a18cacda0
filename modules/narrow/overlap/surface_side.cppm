// SPDX-License-Identifier: Apache-2.0
// A surface, and a convex core among its triangles, behind functions: whether they overlap is asked in code that is
// compiled once for all kinds.
export module abut.narrow.overlap.surface_side;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.many.quick_axes;
import abut.narrow.many.triangle_point;
import abut.narrow.many.triangle_segment;
import abut.narrow.overlap.convex_side;
import abut.trees.eight_boxes;

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

// What is asked of the triangles near a box.
class TriangleQuestion {
 public:
  // A bit for each triangle that is wanted.
  [[nodiscard]] virtual std::uint64_t near(const FourTriangles& triangles) const = 0;
  // Whether the answer is found, so that no more triangles are wanted.
  [[nodiscard]] virtual bool is_answered_by(const TriangleCorners& corners) = 0;

 protected:
  TriangleQuestion() = default;
  TriangleQuestion(const TriangleQuestion&) = default;
  TriangleQuestion& operator=(const TriangleQuestion&) = default;
  ~TriangleQuestion() = default;
};

class NodeVisitor {
 public:
  virtual void visit(const EightBoxes& boxes) = 0;

 protected:
  NodeVisitor() = default;
  NodeVisitor(const NodeVisitor&) = default;
  NodeVisitor& operator=(const NodeVisitor&) = default;
  ~NodeVisitor() = default;
};

// All is in the frame of the surface.
class SurfaceSide {
 public:
  [[nodiscard]] virtual Aabb box() const = 0;
  // Whether triangles only stop what comes from their fronts. What a solid encloses is inside from all sides.
  [[nodiscard]] virtual bool has_open_fronts() const = 0;
  [[nodiscard]] virtual bool is_solid() const = 0;
  [[nodiscard]] virtual bool is_terrain() const = 0;
  [[nodiscard]] virtual bool contains(const Vec3& point) const = 0;
  // See Enclosing. Of a terrain a point, which is put in `spare`.
  using OnePoint = std::array<Vec3, 1>;
  [[nodiscard]] virtual std::span<const Vec3> pieces(OnePoint& spare [[clang::lifetimebound]]) const = 0;
  [[nodiscard]] virtual TriangleCorners corners(std::uint32_t index) const = 0;
  // Asks about the triangles whose boxes overlap one. Whether one has answered.
  [[nodiscard]] virtual bool ask(const Aabb& near, TriangleQuestion& question) const = 0;
  // See Hierarchy.
  [[nodiscard]] virtual Vec3 middle() const = 0;
  virtual void visit_node(std::uint32_t node, NodeVisitor& visitor) const = 0;

 protected:
  SurfaceSide() = default;
  SurfaceSide(const SurfaceSide&) = default;
  SurfaceSide& operator=(const SurfaceSide&) = default;
  ~SurfaceSide() = default;
};

template <Surface A>
class SideOfSurface final : public SurfaceSide {
 public:
  explicit SideOfSurface(const A& surface) : surface_(surface) {}

  [[nodiscard]] Aabb box() const override { return surface_.aabb(Pose::identity()); }
  [[nodiscard]] bool has_open_fronts() const override { return surface_.has_fronts() && !is_solid(); }
  [[nodiscard]] bool is_solid() const override {
    if constexpr (Enclosing<A>) {
      return surface_.is_solid();
    } else {
      return false;
    }
  }
  [[nodiscard]] bool is_terrain() const override { return Terrain<A>; }
  [[nodiscard]] bool contains(const Vec3& point) const override {
    if constexpr (Enclosing<A>) {
      return box().overlaps({point, point}) && surface_.contains(point);
    } else {
      return false;
    }
  }
  [[nodiscard]] std::span<const Vec3> pieces([[maybe_unused]] OnePoint& spare [[clang::lifetimebound]]) const override {
    if constexpr (Enclosing<A> && !Terrain<A>) {
      return surface_.pieces();
    } else {
      spare = {surface_.part_near(box().centre()).corners()[0]};
      return spare;
    }
  }
  [[nodiscard]] TriangleCorners corners(std::uint32_t index) const override { return surface_.corners(index); }
  [[nodiscard]] bool ask(const Aabb& near, TriangleQuestion& question) const override {
    Aabb box = near;
    bool is_answered = false;
    const auto is_near = [&](const FourTriangles& triangles) { return question.near(triangles); };
    surface_.visit_parts(box, InFours{is_near}, [&](const Triangle& part, std::uint32_t) {
      if (!is_answered && question.is_answered_by(part.corners())) {
        is_answered = true;
        box = Aabb::empty();
      }
    });
    return is_answered;
  }
  [[nodiscard]] Vec3 middle() const override { return surface_.origin(); }
  void visit_node(std::uint32_t node, NodeVisitor& visitor) const override {
    surface_.visit_children(node, [&](const EightBoxes& boxes) { visitor.visit(boxes); });
  }

 private:
  const A& surface_;
};

}  // namespace abut
