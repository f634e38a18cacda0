// Triangle mesh: a surface without inside.
export module abut.shapes.mesh;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.bvh;

export namespace abut {

class Mesh {
 public:
  using Part = Triangle;
  static constexpr std::string_view name = "mesh";
  static constexpr std::array<std::string_view, 1> parameter_names{"one_sided"};

  [[nodiscard]] static Result<Mesh> make(std::span<const Real> parameters, std::span<const Real> reals,
                                         std::span<const std::uint32_t> indices);
  [[nodiscard]] std::vector<Real> parameters() const { return {data_->one_sided ? 1.0 : 0.0}; }
  [[nodiscard]] static std::vector<Mesh> samples();

  [[nodiscard]] Aabb aabb(const Pose& pose) const { return transformed(data_->box, pose); }
  [[nodiscard]] std::size_t triangle_count() const { return data_->indices.size() / 3; }

  [[nodiscard]] Triangle part(std::uint32_t index) const { return {corners(index), index, data_->one_sided}; }
  // See Surface.
  [[nodiscard]] bool is_crest(std::uint32_t index, unsigned corners, const Vec3& direction, Real height) const;

  template <class Wanted, class Visitor>
  void visit_parts(Aabb& box, Wanted&& is_wanted, Visitor&& visit) const {
    tree().bvh.visit_overlaps(box, [&](std::uint32_t index) {
      const TriangleCorners of_part = corners(index);
      if (box_around(of_part).overlaps(box) && is_wanted(of_part)) {
        visit(Triangle(of_part, index, data_->one_sided), index);
      }
    });
  }
  template <class Visitor>
  void visit_parts(Aabb& box, Visitor&& visit) const {
    visit_parts(box, AcceptsAnyCorners{}, visit);
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

  // Whether a query has needed the tree so far.
  [[nodiscard]] bool has_tree() const { return data_->tree.is_made(); }

 private:
  struct Tree {
    Bvh bvh;
    // The triangles around each vertex: those of vertex v are around[first_around[v]] to around[first_around[v + 1] -
    // 1].
    std::vector<std::size_t> first_around;
    std::vector<std::uint32_t> around;
  };
  struct Data {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> indices;
    bool one_sided;
    Aabb box;
    Lazy<Tree> tree;
  };

  explicit Mesh(Data data) : data_(std::move(data)) {}
  [[nodiscard]] TriangleCorners corners(std::uint32_t index) const {
    const Data& mesh = *data_;
    const std::size_t first = 3 * std::size_t{index};
    return {mesh.vertices[mesh.indices[first]], mesh.vertices[mesh.indices[first + 1]],
            mesh.vertices[mesh.indices[first + 2]]};
  }
  [[nodiscard]] const Tree& tree() const [[clang::lifetimebound]] {
    return data_->tree.get([this] { return make_tree(*data_); });
  }
  [[nodiscard]] static Tree make_tree(const Data& data);

  Frozen<Data> data_;
};
static_assert(Shape<Mesh> && Surface<Mesh> && Triangulated<Mesh>);

}  // namespace abut
