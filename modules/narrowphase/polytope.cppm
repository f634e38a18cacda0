// A convex polytope of triangles that grows vertex by vertex: the body of the expanding polytope
// algorithm. All storage is inside, no allocation.
module;
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
export module abut.narrowphase.polytope;
import abut.math;
import abut.narrowphase.simplex;

export namespace abut {

// Whether a Minkowski difference has no volume, and the direction across it.
struct FlatDifference {
  bool is_flat;
  Vec3 normal;
};

struct Witness {
  Vec3 a, b;
};

class Polytope {
 public:
  static constexpr std::size_t vertex_limit = 192;
  static constexpr std::size_t face_limit = 2 * vertex_limit;  // a triangulated sphere has 2 V - 4 faces
  static constexpr std::size_t none = face_limit;

  inline void reset() { vertex_count_ = face_count_ = 0; }

  // Builds a tetrahedron with volume, from the vertices of a simplex where they do, else from support
  // points in the directions that are still missing.
  template <class VertexToward>
  [[nodiscard]] FlatDifference start(const Simplex& simplex, Real noise, VertexToward&& vertex_toward);

  [[nodiscard]] inline std::size_t least_face() const {
    std::size_t best = none;
    Real least = infinity;
    for (std::size_t i = 0; i < face_count_; ++i) {
      if (faces_[i].alive && faces_[i].distance < least) {
        least = faces_[i].distance;
        best = i;
      }
    }
    return best;
  }
  // The face whose normal is nearest to a direction.
  [[nodiscard]] inline std::size_t face_along(const Vec3& direction) const {
    std::size_t best = none;
    Real most = -infinity;
    for (std::size_t i = 0; i < face_count_; ++i) {
      if (const Real along = dot(faces_[i].normal, direction); faces_[i].alive && along > most) {
        most = along;
        best = i;
      }
    }
    return best;
  }
  // The least one among the faces that the last vertex brought.
  [[nodiscard]] inline std::size_t least_new_face() const {
    std::size_t best = none;
    Real least = infinity;
    for (std::size_t i = 0; i < face_count_; ++i) {
      if (faces_[i].alive && faces_[i].corner[2] + 1u == vertex_count_ && faces_[i].distance < least) {
        least = faces_[i].distance;
        best = i;
      }
    }
    return best;
  }
  [[nodiscard]] inline const Vec3& normal(std::size_t face) const [[clang::lifetimebound]] { return faces_[face].normal; }
  [[nodiscard]] inline Real distance(std::size_t face) const { return faces_[face].distance; }

  [[nodiscard]] inline bool contains(const DifferenceVertex& vertex) const {
    for (std::size_t i = 0; i < vertex_count_; ++i) {
      if (vertices_[i].is_same(vertex)) {
        return true;
      }
    }
    return false;
  }

  // The points of both bodies under the point of a face that is closest to the origin.
  [[nodiscard]] Witness witness(std::size_t face) const {
    [[clang::uninitialized]] Simplex corners;
    for (const std::uint16_t corner : faces_[face].corner) {
      corners.push(vertices_[corner]);
    }
    const ClosestPoint closest = closest_to_origin(corners);
    keep(corners, closest.vertices);
    const Vec3 on_a = witness_on_a(corners, closest.point);
    return {on_a, on_a - closest.point};
  }

  // Replaces all faces that see the vertex by the cone from their horizon. False when the storage is
  // full or rounding has left no closed horizon; the polytope is then unchanged or no longer of use.
  [[nodiscard]] bool expand(std::size_t seed, const DifferenceVertex& vertex, Real noise);

 private:
  struct Face {
    std::array<std::uint16_t, 3> corner;     // counter-clockwise from outside
    std::array<std::uint16_t, 3> neighbour;  // across the edge from corner i to corner i + 1
    bool alive;
    bool visible;
    Vec3 normal;
    Real distance;
  };
  struct HorizonEdge {
    std::uint16_t from, to;
    std::uint16_t outside;  // the face beyond, which stays
  };

  inline void set_face(std::size_t index, std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    Face& face = faces_[index];
    face.corner = {a, b, c};
    face.alive = true;
    face.visible = false;
    const Vec3 &p = vertices_[a].w, &q = vertices_[b].w, &r = vertices_[c].w;
    const Vec3 n = cross(q - p, r - p);
    const Real square = squared_norm(n);
    if (square > 0) {
      face.normal = (1 / std::sqrt(square)) * n;
      // The offset of the corner with the least coordinates has the least rounding.
      face.distance = dot(face.normal, p);
    } else {
      // A face without area bounds nothing: never the least one, and seen by any vertex.
      face.normal = {0, 0, 0};
      face.distance = infinity;
    }
  }
  [[nodiscard]] inline bool sees(const Face& face, const Vec3& p, Real noise) const {
    // A vertex in the plane of a face counts as seeing it: that merges coplanar faces and keeps
    // triangles without area out.
    return face.distance == infinity || dot(face.normal, p) - face.distance > -noise;
  }
  [[nodiscard]] std::size_t free_face(std::size_t& from) const;

  std::array<DifferenceVertex, vertex_limit> vertices_;
  std::array<Face, face_limit> faces_;
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
};

template <class VertexToward>
FlatDifference Polytope::start(const Simplex& simplex, Real noise, VertexToward&& vertex_toward) {
  const auto add = [&](const DifferenceVertex& vertex) { vertices_[vertex_count_++] = vertex; };
  add(simplex.size > 0 ? simplex.vertices[0] : vertex_toward(Vec3{1, 0, 0}));

  // A vertex of the simplex that reaches far enough saves the search along the given directions.
  const auto grow = [&](auto&& reach_of, const auto& directions, Real threshold) {
    DifferenceVertex best = vertices_[0];
    Real best_reach = 0;
    const auto consider = [&](const DifferenceVertex& candidate) {
      const Real reach = reach_of(candidate.w);
      if (reach > best_reach) {
        best_reach = reach;
        best = candidate;
      }
    };
    for (std::size_t i = 1; i < simplex.size; ++i) {
      consider(simplex.vertices[i]);
    }
    if (!(best_reach > threshold)) {
      for (const Vec3& direction : directions) {
        consider(vertex_toward(direction));
        consider(vertex_toward(-direction));
      }
    }
    if (best_reach > threshold) {
      add(best);
      return true;
    }
    return false;
  };

  const Vec3 origin = vertices_[0].w;
  const Real wide = 1e3 * noise;  // extents that leave the digits of a normal in order
  if (!grow([&](const Vec3& w) { return norm(w - origin); }, std::array<Vec3, 3>{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, wide)) {
    return {true, {0, 0, 1}};
  }
  const Vec3 along = UnitVec3::make(vertices_[1].w - origin).value_or(UnitVec3::axis_z());
  const Tangents across = tangents_of(along);
  if (!grow([&](const Vec3& w) { return norm(cross(along, w - origin)); },
            std::array<Vec3, 4>{across.first, across.second, across.first + across.second, across.first - across.second}, wide)) {
    return {true, across.first};
  }
  const Vec3 normal = UnitVec3::make(cross(vertices_[1].w - origin, vertices_[2].w - origin)).value_or(UnitVec3::axis_z());
  if (!grow([&](const Vec3& w) { return std::fabs(dot(normal, w - origin)); }, std::array<Vec3, 1>{normal}, wide)) {
    return {true, normal};
  }
  const bool above = dot(normal, vertices_[3].w - origin) > 0;
  // Four faces, each counter-clockwise from outside.
  const std::array<std::array<std::uint16_t, 3>, 4> loops =
      above ? std::array<std::array<std::uint16_t, 3>, 4>{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}
            : std::array<std::array<std::uint16_t, 3>, 4>{{{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}}};
  for (std::size_t i = 0; i < 4; ++i) {
    set_face(i, loops[i][0], loops[i][1], loops[i][2]);
  }
  face_count_ = 4;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t e = 0; e < 3; ++e) {
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t f = 0; f < 3; ++f) {
          if (loops[j][f] == loops[i][(e + 1) % 3] && loops[j][(f + 1) % 3] == loops[i][e]) {
            faces_[i].neighbour[e] = static_cast<std::uint16_t>(j);
          }
        }
      }
    }
  }
  return {false, normal};
}

}  // namespace abut
