// SPDX-License-Identifier: Apache-2.0
// A surface behind functions, for the question whether it overlaps another shape, which is compiled once for all kinds.
export module abut.narrow.overlap.surface_side;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.trees.eight_boxes;

export namespace abut {

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
