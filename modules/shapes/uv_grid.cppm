// SPDX-License-Identifier: Apache-2.0
// A mesh whose triangles are found by a grid of cells across two axes: what terrain with bridges and caves is made of.
// Vertices move up and down, and triangles go, while others use it.
export module abut.shapes.uv_grid;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.mesh;
import abut.trees.eight_boxes;
import abut.trees.uv_cells;

export namespace abut {

class UvGrid {
 public:
  using Part = Triangle;
  static constexpr std::string_view name = "uv_grid";
  static constexpr std::array<std::string_view, 5> parameter_names{"sides", "axis_u", "axis_v", "cells_u", "cells_v"};

  [[nodiscard]] static Result<UvGrid> make(std::span<const Real> parameters, std::span<const Real> reals,
                                           std::span<const std::uint32_t> indices);
  [[nodiscard]] std::vector<Real> parameters() const;
  [[nodiscard]] Buffers buffers() const { return data_->mesh.buffers(); }
  [[nodiscard]] static std::vector<UvGrid> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const { return data_->mesh.aabb(pose); }
  [[nodiscard]] std::size_t triangle_count() const { return data_->mesh.triangle_count(); }

  [[nodiscard]] TriangleCorners corners(std::uint32_t index) const { return data_->mesh.corners(index); }
  [[nodiscard]] Triangle part(std::uint32_t index) const { return data_->mesh.part(index); }
  [[nodiscard]] inline bool has_fronts() const { return data_->mesh.has_fronts(); }
  // See Surface.
  [[nodiscard]] bool is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const {
    return data_->mesh.is_crest(index, corners, direction, height);
  }

  template <class Wanted, class Visitor>
  void visit_parts(Aabb& box, Wanted&& is_wanted, Visitor&& visit) const {
    data_->mesh.visit_found(box, is_wanted, visit, [&](const auto& add) { cells().visit_overlaps(box, add); });
  }
  template <class Visitor>
  void visit_parts(Aabb& box, Visitor&& visit) const {
    visit_parts(box, AcceptsAnyCorners{}, visit);
  }
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    const Mesh& mesh = data_->mesh;
    cells().visit_below(direction, limit, [&](std::uint32_t index) {
      const TriangleCorners of_part = mesh.corners(index);
      if (least_along(of_part, direction) <= limit) {
        visit(Triangle(of_part, index, mesh.is_one_sided(index)), index);
      }
    });
  }
  [[nodiscard]] Triangle part_near(const Vec3& point) const { return part(cells().item_near(point)); }

  // See Hierarchy. Two surfaces need a tree, which the mesh makes when they first meet.
  [[nodiscard]] const Vec3& origin() const [[clang::lifetimebound]] { return data_->mesh.origin(); }
  template <class Visitor>
  void visit_children(std::uint32_t node, Visitor&& visit) const {
    data_->mesh.visit_children(node, visit);
  }

  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const;
  [[nodiscard]] Triangles triangles() const { return data_->mesh.triangles(); }

  // See Enclosing.
  [[nodiscard]] inline bool is_solid() const { return data_->mesh.is_solid(); }
  [[nodiscard]] bool contains(const Vec3& point) const { return data_->mesh.contains(point); }
  [[nodiscard]] bool is_turned(std::uint32_t index) const { return data_->mesh.is_turned(index); }
  [[nodiscard]] std::span<const Vec3> pieces() const [[clang::lifetimebound]] { return data_->mesh.pieces(); }

  // Heights of vertices, along the axis that is none of the grid; triangles that go; another mesh. The first change
  // takes O(all triangles), and so does one of another holder's grid.
  [[nodiscard]] Fault check(const VertexEdit& edit) const;
  [[nodiscard]] Fault check(const RemovalEdit& edit) const { return data_->mesh.check(edit); }
  [[nodiscard]] Fault check(const RecreationEdit& edit) const { return data_->mesh.check(edit); }
  void own() { data_.own().mesh.own(); }
  void make_room(const VertexEdit&) { make_room_for_change(); }
  void make_room(const RemovalEdit&) { make_room_for_change(); }
  void make_room(const RecreationEdit& edit) { data_.own().mesh.make_room(edit); }
  [[nodiscard]] Aabb apply(const VertexEdit& edit);
  [[nodiscard]] Aabb apply(const RemovalEdit& edit);
  [[nodiscard]] Aabb apply(const RecreationEdit& edit);

  // See Mesh::prepare.
  void prepare(const Workers& workers) const {
    static_cast<void>(cells());
    data_->mesh.prepare(workers);
  }
  // Whether a query has needed the cells so far.
  [[nodiscard]] bool has_cells() const { return data_->cells.is_made(); }

 private:
  struct Data {
    Mesh mesh;
    UvCells::Plan plan;  // 0 cells: as many as suit the triangles
    Lazy<UvCells> cells;
  };

  explicit UvGrid(Data data) : data_(std::move(data)) {}
  [[nodiscard]] const UvCells& cells() const [[clang::lifetimebound]] {
    return data_->cells.get([this] { return make_cells(*data_); });
  }
  [[nodiscard]] static UvCells make_cells(const Data& data);
  void make_room_for_change();
  [[nodiscard]] Aabb follow(const Aabb& changed);

  Frozen<Data> data_;
};
static_assert(Shape<UvGrid> && Surface<UvGrid> && Hierarchy<UvGrid> && Enclosing<UvGrid> && Triangulated<UvGrid> &&
              Editable<UvGrid, VertexEdit> && Editable<UvGrid, RemovalEdit> && Editable<UvGrid, RecreationEdit>);

}  // namespace abut
