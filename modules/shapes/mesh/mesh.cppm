// SPDX-License-Identifier: Apache-2.0
// Triangle mesh: a surface without inside, unless it is declared solid. Its vertices move, and its triangles go, while
// others use it. A triangle that has gone keeps its number and names one vertex three times; it is met by nothing.
export module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.shapes.mesh.inside;
import abut.shapes.mesh.neighbours;
import abut.trees.boxes.bvh;
import abut.trees.grids.cell_order;
import abut.trees.volumes.eight_boxes;
import abut.trees.boxes.volume_tree;

export namespace abut {

// The number of the vertex that place i of an edit is for.
[[nodiscard]] inline std::uint32_t moved_vertex(const VertexEdit& edit, std::size_t i) {
  return edit.vertices.empty() ? static_cast<std::uint32_t>(edit.first + i) : edit.vertices[i];
}

class Mesh {
 public:
  using Part = Triangle;
  static constexpr std::string_view name = "mesh";
  static constexpr std::array<std::string_view, 1> parameter_names{"sides"};

  [[nodiscard]] static Result<Mesh> make(std::span<const Real> parameters, std::span<const Real> reals,
                                         std::span<const std::uint32_t> indices);
  // The sides, and what the tree is made by where that was chosen: its kind, or the numbers of a UvGrid.
  [[nodiscard]] std::vector<Real> parameters() const;
  [[nodiscard]] Buffers buffers() const {
    Buffers out{{}, data_->indices};
    out.reals.reserve(3 * data_->vertices.size());
    for (const Vec3& p : data_->vertices) {
      out.reals.insert(out.reals.end(), {p.x, p.y, p.z});
    }
    return out;
  }
  [[nodiscard]] static std::vector<Mesh> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const { return transformed(data_->box, pose); }
  [[nodiscard]] std::size_t triangle_count() const { return data_->indices.size() / 3; }

  // A triangle of a solid that is wound the wrong way stops from both sides: then neighbours tell where inside is.
  [[nodiscard]] inline bool is_one_sided(std::uint32_t index) const {
    return data_->sides == Sides::front || (data_->sides == Sides::solid && !inside().turns(index));
  }
  [[nodiscard]] inline bool has_fronts() const { return data_->sides != Sides::both; }
  [[nodiscard]] [[gnu::always_inline]] inline TriangleCorners corners(std::uint32_t index) const {
    const Data& mesh = *data_;
    const std::size_t first = 3 * std::size_t{index};
    return {mesh.vertices[mesh.indices[first]], mesh.vertices[mesh.indices[first + 1]],
            mesh.vertices[mesh.indices[first + 2]]};
  }
  [[nodiscard]] Triangle part(std::uint32_t index) const { return {corners(index), index, is_one_sided(index)}; }
  // See Surface.
  [[nodiscard]] bool is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const;

  template <class Wanted, class Visitor>
  void visit_parts(Aabb& box, Wanted&& is_wanted, Visitor&& visit) const {
    const Data& mesh = *data_;
    const auto read_corners = [&](std::uint32_t index, TriangleCorners& out) {
      const auto its = std::span(mesh.indices).subspan(3 * std::size_t{index}).template first<3>();
      out[0] = mesh.vertices[its[0]];
      out[1] = mesh.vertices[its[1]];
      out[2] = mesh.vertices[its[2]];
    };
    const auto visit_part = [&](const TriangleCorners& of_part, std::uint32_t index) {
      visit(Triangle(of_part, index, is_one_sided(index)), index);
    };
    const MeshNeighbours* beside = mesh.neighbours.is_made() ? &neighbours() : nullptr;
    [[clang::uninitialized]] WaitingTriangles waiting(box, read_corners, is_wanted, visit_part);
    const auto add = [&](std::uint32_t index) {
      __builtin_prefetch(&mesh.indices[3 * std::size_t{index}]);
      if (beside != nullptr) {
        beside->fetch_across(index);
      }
      waiting.add(index);
    };
    if (has_other_tree()) [[unlikely]] {
      visit_in_other(box, add);
    } else {
      tree().visit_overlaps(box, add);
    }
    waiting.visit_all();
  }
  template <class Visitor>
  void visit_parts(Aabb& box, Visitor&& visit) const {
    visit_parts(box, AcceptsAnyCorners{}, visit);
  }
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    const auto visit_part = [&](std::uint32_t index) {
      const TriangleCorners of_part = corners(index);
      if (least_along(of_part, direction) <= limit) {
        visit(Triangle(of_part, index, is_one_sided(index)), index);
      }
    };
    if (has_other_tree()) [[unlikely]] {
      visit_below_in_other(direction, limit, visit_part);
    } else {
      tree().visit_below(direction, limit, visit_part);
    }
  }
  [[nodiscard]] Triangle part_near(const Vec3& point) const {
    return part(has_other_tree() ? item_near_in_other(point) : tree().item_near(point));
  }

  // See Hierarchy. Two surfaces go down trees of boxes, whatever was chosen.
  [[nodiscard]] const Vec3& origin() const [[clang::lifetimebound]] { return tree().origin(); }
  template <class Visitor>
  void visit_children(std::uint32_t node, Visitor&& visit) const {
    tree().visit_children(node, visit);
  }

  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const TriangleRay ray(origin, direction);
    Real nearest = max_distance;
    std::uint32_t hit = no_index;
    const auto cast = [&](std::uint32_t index) {
      const auto distance = ray.distance_to(corners(index), nearest);
      if (distance && (*distance < nearest || index < hit)) {
        nearest = *distance;
        hit = index;
      }
    };
    if (has_other_tree()) [[unlikely]] {
      visit_ray_in_other(origin, direction, nearest, cast);
    } else {
      tree().visit_ray(origin, direction, nearest, cast);
    }
    return hit == no_index ? std::nullopt
                           : std::optional(RayHit{nearest, part(hit).normal(), {FeatureKind::face, hit}});
  }
  [[nodiscard]] Triangles triangles() const { return {data_->vertices, data_->indices}; }
  // The same without a copy.
  [[nodiscard]] std::span<const Vec3> vertices() const [[clang::lifetimebound]] { return data_->vertices; }
  [[nodiscard]] std::span<const std::uint32_t> indices() const [[clang::lifetimebound]] { return data_->indices; }

  // See Enclosing.
  [[nodiscard]] inline bool is_solid() const { return data_->sides == Sides::solid; }
  [[nodiscard]] bool contains(const Vec3& point) const { return inside().contains(point); }
  [[nodiscard]] bool is_turned(std::uint32_t index) const { return inside().turns(index); }
  [[nodiscard]] std::span<const Vec3> pieces() const [[clang::lifetimebound]] { return inside().pieces(); }

  // Makes what queries make when they first need it.
  void prepare(const Workers& workers) const;
  // Whether a query has needed the tree so far.
  [[nodiscard]] bool has_tree() const { return data_->tree.is_made(); }

  [[nodiscard]] Fault check(const VertexEdit& edit) const;
  [[nodiscard]] Fault check(const RemovalEdit& edit) const;
  [[nodiscard]] Fault check(const RecreationEdit& edit) const;
  void own() { static_cast<void>(data_.own()); }
  void make_room(const VertexEdit& edit) { make_room_for_change(!moves_most(edit)); }
  void make_room(const RemovalEdit&) { make_room_for_change(true); }
  void make_room(const RecreationEdit& edit);
  [[nodiscard]] Aabb apply(const VertexEdit& edit);
  [[nodiscard]] Aabb apply(const RemovalEdit& edit);
  [[nodiscard]] Aabb apply(const RecreationEdit& edit);

  // All vertices at once, in the same steps as edits: `next`, as many as there are, become the vertices, and it gets
  // those that were.
  [[nodiscard]] Fault check_next(std::span<const Vec3> next) const;
  void make_room_for_next() { make_room_for_change(false); }
  [[nodiscard]] Aabb exchange(std::vector<Vec3>& next);

 private:
  // What stops other shapes: both sides of triangles, their fronts, or all that is inside.
  enum class Sides : std::uint8_t { both, front, solid };
  // What triangles are found by. Boxes along the axes are the fastest.
  enum class ChosenTree : std::uint8_t { automatic, boxes, oriented_boxes, balls };
  friend struct UvGrid;
  using OtherTree = std::variant<OrientedBoxTree, SphereTree>;
  using VisitItem = std::function<void(std::uint32_t)>;

  struct Data {
    std::vector<Vec3> vertices{};
    std::vector<std::uint32_t> indices{};
    Sides sides;
    ChosenTree chosen;
    std::optional<CellPlan> cells;  // of a UvGrid
    Aabb box = Aabb::empty();
    std::size_t present = 0;  // triangles that have not gone
    Lazy<Bvh> tree{};
    Lazy<MeshNeighbours> neighbours{};
    Lazy<MeshInside> inside{};
    Lazy<OtherTree> other{};  // where one was chosen
  };

  explicit Mesh(Data data) : data_(std::move(data)) {}
  [[nodiscard]] const Bvh& tree() const [[clang::lifetimebound]] {
    return data_->tree.get([this] { return make_tree(Workers(1)); });
  }
  [[nodiscard]] const MeshNeighbours& neighbours() const [[clang::lifetimebound]] {
    return data_->neighbours.get([this] { return make_neighbours(Workers(1)); });
  }
  [[nodiscard]] const MeshInside& inside() const [[clang::lifetimebound]] {
    return data_->inside.get([this] { return MeshInside(data_->vertices, data_->indices, data_->box); });
  }
  [[nodiscard]] inline bool has_other_tree() const { return data_->chosen > ChosenTree::boxes; }
  // Of a triangle; empty where it has gone.
  [[nodiscard]] inline Aabb present_box(std::uint32_t index) const {
    return has_gone(index) ? Aabb::empty() : box_around(corners(index));
  }
  [[nodiscard]] bool has_gone(std::uint32_t index) const { return is_removed(data_->indices, index); }
  [[nodiscard]] std::optional<TriangleCorners> present_corners(std::uint32_t index) const {
    return has_gone(index) ? std::nullopt : std::optional(corners(index));
  }
  [[nodiscard]] const OtherTree& other() const [[clang::lifetimebound]];
  void visit_in_other(const Aabb& box, const VisitItem& visit) const;
  void visit_below_in_other(const Vec3& direction, Real& limit, const VisitItem& visit) const;
  void visit_ray_in_other(const Vec3& origin, const Vec3& direction, Real& limit, const VisitItem& visit) const;
  [[nodiscard]] std::uint32_t item_near_in_other(const Vec3& point) const;
  void make_room_in_other();
  void touch_in_other(std::uint32_t triangle);
  void settle_other();
  [[nodiscard]] bool follow(std::uint32_t touched, const Aabb& moved);
  // `follows_vertices`: whether what lies around single vertices is asked for.
  void make_room_for_change(bool follows_vertices);
  // One pass through all triangles costs less than what lies around so many vertices.
  [[nodiscard]] bool moves_most(const VertexEdit& edit) const {
    return edit.xyz.size() / 3 >= data_->vertices.size() / 2 + 1;
  }
  void follow_all();
  [[nodiscard]] Aabb move_in_tree(const VertexEdit& edit);
  void place(const VertexEdit& edit);
  void take_out(std::uint32_t triangle);
  // Calls visit(triangle) for all around the vertices of an edit: once each where these are a range.
  template <class Visitor>
  void visit_moved(const VertexEdit& edit, Visitor&& visit) const {
    constexpr std::size_t ahead = 16;
    const Data& mesh = *data_;
    const std::size_t count = edit.xyz.size() / 3;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t vertex = moved_vertex(edit, i);
      if (!edit.vertices.empty()) {
        fetch_around(edit, i + 2 * ahead, i + ahead, i + ahead / 2);
      }
      for (const std::uint32_t triangle : neighbours().around_vertex(vertex)) {
        // One that several vertices of a range share moves with the first of them.
        const auto its = std::span(mesh.indices).subspan(3 * std::size_t{triangle}, 3);
        const auto moves_before = [&](std::uint32_t other) { return other >= edit.first && other < vertex; };
        if (!has_gone(triangle) && !(edit.vertices.empty() && std::ranges::any_of(its, moves_before))) {
          visit(triangle);
        }
      }
    }
  }
  // Asks the memory for what lies around vertices that are moved later: where the list of their triangles begins, then
  // the list, then the triangles.
  void fetch_around(const VertexEdit& edit, std::size_t begin, std::size_t list, std::size_t triangles) const {
    if (begin < edit.vertices.size()) {
      neighbours().fetch_begin(edit.vertices[begin]);
    }
    if (list < edit.vertices.size()) {
      neighbours().fetch_list(edit.vertices[list]);
    }
    if (triangles < edit.vertices.size()) {
      for (const std::uint32_t triangle : neighbours().around_vertex(edit.vertices[triangles])) {
        __builtin_prefetch(&data_->indices[3 * std::size_t{triangle}]);
      }
    }
  }
  void fetch_corners(std::uint32_t triangle) const {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      __builtin_prefetch(&data_->vertices[data_->indices[3 * std::size_t{triangle} + corner]]);
    }
  }
  void follow_inside(const VertexEdit& edit);
  [[nodiscard]] bool is_closed_around(std::uint32_t vertex) const;
  void settle_inside();
  [[nodiscard]] static Fault check_sides(Real sides);
  [[nodiscard]] static Mesh made(Sides sides, ChosenTree chosen, const std::optional<CellPlan>& cells,
                                 std::span<const Real> reals, std::span<const std::uint32_t> indices);
  [[nodiscard]] Fault check_stays_in_cell(std::uint32_t vertex, const Vec3& next, std::string_view name,
                                          std::size_t first) const;
  [[nodiscard]] Fault check_stays_in_cells(const VertexEdit& edit) const;
  [[nodiscard]] Fault check_next_stays_in_cells(std::span<const Vec3> next) const;
  static void fill(Data& data, std::span<const Real> reals, std::span<const std::uint32_t> indices);
  [[nodiscard]] static Aabb box_of(const Data& data);
  [[nodiscard]] Bvh make_tree(const Workers& workers) const;
  [[nodiscard]] MeshNeighbours make_neighbours(const Workers& workers) const;

  Frozen<Data> data_;
};
static_assert(Shape<Mesh> && Surface<Mesh> && Hierarchy<Mesh> && Enclosing<Mesh> && Triangulated<Mesh> &&
              Editable<Mesh, VertexEdit> && Editable<Mesh, RemovalEdit> && Editable<Mesh, RecreationEdit>);

// A mesh whose tree is made by a grid of cells across two axes, and whose vertices move along the third one alone: what
// terrain with bridges and caves is made of. It is a kind by its name and its numbers, and a Mesh in all else.
struct UvGrid {
  using OfClass = Mesh;
  static constexpr std::string_view name = "uv_grid";
  static constexpr std::array<std::string_view, 5> parameter_names{"sides", "axis_u", "axis_v", "cells_u", "cells_v"};

  [[nodiscard]] static Result<Mesh> make(std::span<const Real> parameters, std::span<const Real> reals,
                                         std::span<const std::uint32_t> indices);
  [[nodiscard]] static bool has_made(const Mesh& mesh) { return mesh.data_->cells.has_value(); }
};

}  // namespace abut
