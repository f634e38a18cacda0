// SPDX-License-Identifier: Apache-2.0
// Solid convex hull of points.
export module abut.shapes.hull;
import abut.capability.cores.core_feature;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.shapes.hull.data;

export namespace abut {

class Hull {
 public:
  static constexpr std::string_view name = "hull";
  static constexpr std::array<std::string_view, 0> parameter_names{};

  // Points; or the vertices of a hull that was built before, and in the indices its faces, see hull_of_faces.
  [[nodiscard]] static Result<Hull> make(std::span<const Real> parameters, std::span<const Real> reals,
                                         std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 0)) {
      return *fault;
    }
    if (reals.empty()) {
      return Error{Errc::empty, "point_count is 0; a hull needs at least one point"};
    }
    if (reals.size() % 3 != 0) {
      return error_about(Errc::invalid_argument, "real_count", static_cast<std::uint64_t>(reals.size()),
                         "a multiple of 3");
    }
    if (Fault fault = check_all_finite("xyz", reals)) {
      return *fault;
    }
    std::vector<Vec3> points(reals.size() / 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = {reals[3 * i], reals[3 * i + 1], reals[3 * i + 2]};
    }
    if (!indices.empty()) {
      return hull_of_faces(points, indices).transform([](HullData data) { return Hull(std::move(data)); });
    }
    return Hull(build_hull(points));
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {}; }
  [[nodiscard]] Buffers buffers() const {
    Buffers out{{}, faces_of(*data_)};
    for (const Vec3& p : data_->vertices) {
      out.reals.insert(out.reals.end(), {p.x, p.y, p.z});
    }
    return out;
  }
  [[nodiscard]] static std::vector<Hull> samples();

  [[nodiscard]] inline const HullData& data() const [[clang::lifetimebound]] { return *data_; }
  [[nodiscard]] inline const HullReport& report() const [[clang::lifetimebound]] { return data_->report; }
  [[nodiscard]] inline const HullFacets& facets() const [[clang::lifetimebound]] { return data_->facets; }
  [[nodiscard]] inline std::span<const HullData::Block> vertex_blocks() const [[clang::lifetimebound]] {
    return data_->blocks;
  }

  [[nodiscard]] Aabb aabb(const Pose& pose) const {
    // Exact rather than the box of the local box: six support points.
    const Rotation back = pose.rotation.inverse();
    const HullData& hull = *data_;
    const Vec3 high{dot(back.x, hull.support(back.x).point), dot(back.y, hull.support(back.y).point),
                    dot(back.z, hull.support(back.z).point)};
    const Vec3 low{dot(back.x, hull.support(-back.x).point), dot(back.y, hull.support(-back.y).point),
                   dot(back.z, hull.support(-back.z).point)};
    return {low + pose.position, high + pose.position};
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return data_->centre; }
  [[nodiscard]] inline Real extent() const { return data_->extent; }
  [[nodiscard]] [[gnu::always_inline]] inline SupportPoint support(const Vec3& direction) const {
    return data_->support(direction);
  }

  [[nodiscard]] inline std::uint32_t corner_count() const { return static_cast<std::uint32_t>(data_->vertices.size()); }
  [[nodiscard]] inline Vec3 corner(std::uint32_t index) const { return data_->vertices[index]; }

  [[nodiscard]] Face supporting_face(const Vec3& direction) const {
    const HullData& hull = *data_;
    const SupportPoint top = hull.support(direction);
    [[clang::uninitialized]] Face face;
    if (hull.faces.empty()) {
      // A point or a segment: its whole core, for the clipping to choose from.
      for (std::uint32_t i = 0; i < hull.vertices.size(); ++i) {
        face.vertices.push_back({hull.vertices[i], i, 0});
      }
      return face;
    }
    write_face(hull.face_along(top.index, direction), face);
    return face;
  }
  // The same where the face or the edge that lies furthest along the direction is known.
  [[nodiscard]] Face supporting_face(const Vec3& direction, const CoreFeature& feature) const {
    [[clang::uninitialized]] Face face;
    write_face(face_of(direction, feature), face);
    return face;
  }
  [[nodiscard]] FewCorners few_corners(const Vec3& direction) const {
    const HullData& hull = *data_;
    return hull.faces.empty() ? FewCorners{}
                              : few_corners_of(hull.face_along(hull.support(direction).index, direction));
  }
  [[nodiscard]] FewCorners few_corners(const Vec3& direction, const CoreFeature& feature) const {
    return few_corners_of(face_of(direction, feature));
  }

  // Clips the ray by the planes of all faces (Cyrus and Beck 1978).
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const HullData& hull = *data_;
    Real enter = -infinity, leave = infinity;
    std::uint32_t enter_face = no_index, leave_face = no_index;
    for (std::uint32_t i = 0; i < hull.faces.size(); ++i) {
      const HullFace& face = hull.faces[i];
      const Real approach = dot(face.normal, direction.vec());
      const Real height = face.offset - dot(face.normal, origin);
      if (approach == 0) {
        if (height < 0) {
          return std::nullopt;
        }
        continue;
      }
      const Real at = height / approach;
      if (approach < 0 && at > enter) {
        enter = at;
        enter_face = i;
      } else if (approach > 0 && at < leave) {
        leave = at;
        leave_face = i;
      }
    }
    const bool entering = enter >= 0;
    const Real distance = entering ? enter : leave;
    const std::uint32_t face = entering ? enter_face : leave_face;
    if (!(enter <= leave) || face == no_index || !(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    // The two sides of a polygon have no faces between them that would cut the ray.
    if (hull.faces.size() == 2 && !covers(hull.faces[face], origin + distance * direction.vec())) {
      return std::nullopt;
    }
    return RayHit{distance, hull.faces[face].normal, {FeatureKind::face, face}};
  }

  // Each face as a fan of triangles.
  [[nodiscard]] Triangles triangles() const {
    const HullData& hull = *data_;
    Triangles out{hull.vertices, {}};
    for (const HullFace& face : hull.faces) {
      for (std::uint32_t i = 1; i + 1 < face.count; ++i) {
        for (const std::uint32_t corner : {0u, i, i + 1}) {
          out.indices.push_back(hull.face_vertices[face.first + corner]);
        }
      }
    }
    return out;
  }

 private:
  // The number of the face that has a feature; of an edge, of the face that looks along the direction.
  [[nodiscard]] std::uint32_t face_of(const Vec3& direction, const CoreFeature& feature) const {
    const HullData& hull = *data_;
    if (feature.kind == CoreFeature::Kind::face) {
      return hull.facets.faces[feature.index];
    }
    const auto& sides = hull.facets.sides[feature.index];
    const auto [first, second] = std::minmax(hull.facets.faces[sides.left], hull.facets.faces[sides.right]);
    const Real lead = dot(hull.faces[second].normal - hull.faces[first].normal, direction);
    return lead > tie_share * largest_magnitude(direction) ? second : first;
  }
  [[nodiscard]] FewCorners few_corners_of(std::uint32_t index) const {
    const HullData& hull = *data_;
    const HullFace& face = hull.faces[index];
    if (face.count > 4) {
      return {};
    }
    const auto place = [&](std::uint32_t i) { return face.first + std::min(i, face.count - 1); };
    const auto vertex = [&](std::uint32_t i) { return hull.face_vertices[place(i)]; };
    const auto edge = [&](std::uint32_t i) { return hull.face_edges[place(i)]; };
    const auto at = [&](std::uint32_t i) { return lanes_of(hull.vertices[vertex(i)]); };
    return {Columns::of(at(0), at(1), at(2), at(3)),
            face.normal,
            index,
            {vertex(0), vertex(1), vertex(2), vertex(3)},
            {edge(0), edge(1), edge(2), edge(3)}};
  }
  void write_face(std::uint32_t index, Face& out) const {
    const HullData& hull = *data_;
    const HullFace& face = hull.faces[index];
    out.index = index;
    out.normal = face.normal;
    for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
      const std::uint32_t vertex = hull.face_vertices[i];
      out.vertices.push_back({hull.vertices[vertex], vertex, hull.face_edges[i]});
    }
  }

  // Whether a point of the plane of a face lies within it.
  [[nodiscard]] bool covers(const HullFace& face, const Vec3& point) const {
    const HullData& hull = *data_;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const Vec3& from = hull.vertices[hull.face_vertices[face.first + i]];
      const Vec3& to = hull.vertices[hull.face_vertices[face.first + (i + 1 < face.count ? i + 1 : 0)]];
      if (dot(face.normal, cross(to - from, point - from)) < 0) {
        return false;
      }
    }
    return true;
  }

  explicit Hull(HullData data) : data_(std::move(data)) {}
  Frozen<HullData> data_;
};
static_assert(Shape<Hull> && Convex<Hull> && FewCornered<Hull> && Triangulated<Hull>);

}  // namespace abut
