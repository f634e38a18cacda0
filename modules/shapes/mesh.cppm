// SPDX-License-Identifier: Apache-2.0
// Triangle mesh: a surface without inside, unless it is declared solid.
export module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.bvh;
import abut.trees.winding_number;

export namespace abut {

class Mesh {
 public:
  using Part = Triangle;
  static constexpr std::string_view name = "mesh";
  static constexpr std::array<std::string_view, 1> parameter_names{"sides"};

  [[nodiscard]] static Result<Mesh> make(std::span<const Real> parameters, std::span<const Real> reals,
                                         std::span<const std::uint32_t> indices);
  [[nodiscard]] std::vector<Real> parameters() const { return {static_cast<Real>(data_->sides)}; }
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
  [[nodiscard]] inline TriangleCorners corners(std::uint32_t index) const {
    const Data& mesh = *data_;
    const std::size_t first = 3 * std::size_t{index};
    return corners({mesh.indices[first], mesh.indices[first + 1], mesh.indices[first + 2]});
  }
  [[nodiscard]] Triangle part(std::uint32_t index) const { return {corners(index), index, is_one_sided(index)}; }
  // See Surface.
  [[nodiscard]] bool is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const;

  template <class Wanted, class Visitor>
  void visit_parts(Aabb& box, Wanted&& is_wanted, Visitor&& visit) const {
    const Tree& tree = this->tree();
    // Corners of triangles that are near each other lie far apart in memory. Those of some triangles are read at once,
    // so that the memory is waited for once.
    [[clang::uninitialized]] SmallVector<std::uint32_t, most_at_once> near;
    const auto visit_near = [&] {
      [[clang::uninitialized]] std::array<TriangleCorners, most_at_once> corners_of;
      for (std::size_t i = 0; i < near.size(); ++i) {
        corners_of[i] = corners(tree.linked[near[i]].corners);
      }
      for (std::size_t i = 0; i < near.size(); ++i) {
        if (box_around(corners_of[i]).overlaps(box) && is_wanted(corners_of[i])) {
          visit(Triangle(corners_of[i], near[i], is_one_sided(near[i])), near[i]);
        }
      }
      near.clear();
    };
    tree.bvh.visit_overlaps(box, [&](std::uint32_t index) {
      __builtin_prefetch(&tree.linked[index]);
      near.push_back(index);
      if (near.size() == most_at_once) {
        visit_near();
      }
    });
    visit_near();
  }
  template <class Visitor>
  void visit_parts(Aabb& box, Visitor&& visit) const {
    visit_parts(box, AcceptsAnyCorners{}, visit);
  }
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    tree().bvh.visit_below(direction, limit, [&](std::uint32_t index) {
      const TriangleCorners of_part = corners(index);
      if (least_along(of_part, direction) <= limit) {
        visit(Triangle(of_part, index, data_->one_sided), index);
      }
    });
  }
  [[nodiscard]] Triangle part_near(const Vec3& point) const { return part(tree().bvh.item_near(point)); }

  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const TriangleRay ray(origin, direction);
    Real nearest = max_distance;
    std::uint32_t hit = no_index;
    tree().bvh.visit_ray(origin, direction, nearest, [&](std::uint32_t index) {
      const auto distance = ray.distance_to(corners(index), nearest);
      if (distance && (*distance < nearest || index < hit)) {
        nearest = *distance;
        hit = index;
      }
    });
    return hit == no_index ? std::nullopt
                           : std::optional(RayHit{nearest, part(hit).normal(), {FeatureKind::face, hit}});
  }
  [[nodiscard]] Triangles triangles() const { return {data_->vertices, data_->indices}; }

  // See Enclosing.
  [[nodiscard]] inline bool is_solid() const { return data_->sides == Sides::solid; }
  [[nodiscard]] bool contains(const Vec3& point) const { return inside().winding.contains(point); }
  [[nodiscard]] bool is_turned(std::uint32_t index) const { return inside().turns(index); }
  [[nodiscard]] std::span<const Vec3> pieces() const [[clang::lifetimebound]] { return inside().pieces; }

  // Whether a query has needed the tree so far.
  [[nodiscard]] bool has_tree() const { return data_->tree.is_made(); }

 private:
  static constexpr std::size_t most_at_once = 32;

  // The corners that a triangle has beside one of its vertices.
  struct OtherCorners {
    std::uint32_t next, last;
  };
  // A triangle by its corners, and by the corners that its neighbours have across its edges. Edge i leads from corner i
  // to the next one. Across a border it is the corner opposite to the edge; where several neighbours share an edge,
  // no_index.
  struct Linked {
    std::array<std::uint32_t, 3> corners, across;
  };
  struct Tree {
    Bvh bvh;
    std::vector<Linked> linked;
    // The triangles around each vertex: those of vertex v are around[first_around[v]] to around[first_around[v + 1] -
    // 1].
    std::vector<std::size_t> first_around;
    std::vector<OtherCorners> around;

    [[nodiscard]] std::span<const OtherCorners> around_vertex(std::uint32_t vertex) const [[clang::lifetimebound]] {
      return std::span(around).subspan(first_around[vertex], first_around[vertex + 1] - first_around[vertex]);
    }
  };
  // What stops other shapes: both sides of triangles, their fronts, or all that is inside.
  enum class Sides : std::uint8_t { both, front, solid };

  struct Inside {
    WindingNumber winding;
    std::vector<Vec3> pieces;
    std::vector<bool> turned;  // for each triangle; nothing where none is

    [[nodiscard]] inline bool turns(std::uint32_t index) const { return !turned.empty() && turned[index]; }
  };
  struct Data {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    Sides sides;
    Aabb box;
    Lazy<Tree> tree;
    Lazy<Inside> inside;
  };

  explicit Mesh(Data data) : data_(std::move(data)) {}
  [[nodiscard]] inline TriangleCorners corners(const std::array<std::uint32_t, 3>& vertices) const {
    const Data& mesh = *data_;
    return {mesh.vertices[vertices[0]], mesh.vertices[vertices[1]], mesh.vertices[vertices[2]]};
  }
  [[nodiscard]] const Tree& tree() const [[clang::lifetimebound]] {
    return data_->tree.get([this] { return make_tree(*data_); });
  }
  [[nodiscard]] const Inside& inside() const [[clang::lifetimebound]] {
    return data_->inside.get([this] { return make_inside(*data_); });
  }
  [[nodiscard]] static Tree make_tree(const Data& data);
  [[nodiscard]] static Inside make_inside(const Data& data);
  [[nodiscard]] static std::vector<Linked> linked_by(const Tree& tree, std::span<const std::uint32_t> indices);

  Frozen<Data> data_;
};
static_assert(Shape<Mesh> && Surface<Mesh> && Enclosing<Mesh> && Triangulated<Mesh>);

}  // namespace abut
