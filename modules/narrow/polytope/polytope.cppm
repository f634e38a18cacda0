// SPDX-License-Identifier: Apache-2.0
// A convex polytope of triangles that grows vertex by vertex: the body of the expanding polytope
// algorithm. All storage is inside, no allocation.
export module abut.narrow.polytope;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;

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
  static constexpr std::size_t vertex_limit = 224;
  static constexpr std::size_t face_limit = 2 * vertex_limit;  // a triangulated sphere has 2 V - 4 faces
  static constexpr std::size_t none = face_limit;

  inline void reset() { vertex_count_ = face_count_ = free_count_ = 0; }

  // Builds a tetrahedron with volume: from the vertices of a simplex where they do, else from support points in the
  // directions that are missing.
  [[nodiscard]] FlatDifference start(const Simplex& simplex, Real noise, const Difference& cores);

  // The first one among equals.
  [[nodiscard]] inline std::size_t least_face() const {
    Lanes least = infinity;
    LaneNumbers groups{0, 0, 0, 0};
    for (std::size_t i = 0; 4 * i < face_count_; ++i) {
      const Lanes& distances = distances_[i];
      const LaneNumbers closer = distances < least;
      least = closer ? distances : least;
      groups = closer ? LaneNumbers(static_cast<std::int64_t>(i)) : groups;
    }
    std::size_t best = none;
    Real top = infinity;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const std::size_t face = 4 * static_cast<std::size_t>(groups[lane]) + lane;
      if (least[lane] < top || (least[lane] == top && face < best)) {
        top = least[lane];
        best = face;
      }
    }
    return best;
  }
  // Faces have numbers below this; those that are not in use have an infinite distance.
  [[nodiscard]] inline std::size_t face_end() const { return face_count_; }
  [[nodiscard]] inline Vec3 normal(std::size_t face) const { return vec3_of(planes_[face]); }
  [[nodiscard]] inline Real distance(std::size_t face) const { return distances_[face / 4][face % 4]; }

  [[nodiscard]] inline bool contains(const DifferenceVertex& vertex) const {
    for (std::size_t i = 0; i < vertex_count_; ++i) {
      if (vertices_[i].is_same(vertex)) {
        return true;
      }
    }
    return false;
  }

  // Leaves a face out of the search for the least one.
  inline void hide(std::size_t face) { distances_[face / 4][face % 4] = infinity; }

  // The points of both bodies under the point of a face that is closest to the origin.
  [[nodiscard]] Witness witness(std::size_t face) const {
    [[clang::uninitialized]] Simplex corners;
    corners.size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      corners.push(vertices_[corners_[face][i]]);
    }
    const ClosestPoint closest = closest_to_origin(corners);
    keep(corners, closest.vertices);
    const Vec3 on_a = witness_on_a(corners, closest.point);
    return {on_a, on_a - closest.point};
  }

  // Replaces all faces that see the vertex by the cone from their horizon. False when the storage is
  // full or rounding has left no closed horizon; the polytope is then no longer of use.
  [[nodiscard]] bool expand(std::size_t seed, const DifferenceVertex& vertex, Real noise);

 private:
  // Edge i of a face leads from its corner i to the next one; as a number it is 4 face + i.
  using Edge = std::uint16_t;
  [[nodiscard]] static constexpr std::size_t face_of(Edge edge) { return edge / 4u; }
  [[nodiscard]] static constexpr Edge edge_of(std::size_t face, std::size_t i) {
    return static_cast<Edge>(4 * face + i);
  }
  [[nodiscard]] static constexpr Edge after(Edge edge) {
    return static_cast<Edge>(edge % 4 == 2 ? edge - 2 : edge + 1);
  }
  [[nodiscard]] inline std::uint16_t start_of(Edge edge) const { return corners_[edge / 4u][edge % 4u]; }
  [[nodiscard]] inline Edge across(Edge edge) const { return neighbours_[edge / 4u][edge % 4u]; }
  inline void join(Edge edge, Edge other) {
    neighbours_[edge / 4u][edge % 4u] = other;
    neighbours_[other / 4u][other % 4u] = edge;
  }

  // Up to four triangles at a time.
  struct Triangles {
    std::array<std::uint16_t, 4> faces;
    std::array<std::uint16_t, 4> p, q, r;  // corners, counter-clockwise from outside
  };
  void set_faces(const Triangles& triangles, std::size_t count);
  [[nodiscard]] inline std::size_t new_face() {
    if (free_count_ > 0) {
      return free_[--free_count_];
    }
    if (face_count_ < face_limit && face_count_ % 4 == 0) {
      distances_[face_count_ / 4] = infinity;
    }
    return face_count_ < face_limit ? face_count_++ : none;
  }
  inline void add(const DifferenceVertex& vertex) {
    points_[vertex_count_] = lanes_of(vertex.w);
    vertices_[vertex_count_++] = vertex;
  }

  std::array<DifferenceVertex, vertex_limit> vertices_;
  std::array<Lanes, vertex_limit> points_;       // their w
  std::array<Lanes, face_limit> planes_;         // normal and distance; of a face that any point sees: 0, -infinity
  std::array<Lanes, face_limit / 4> distances_;  // infinity where there is no face, or none with area
  std::array<std::array<std::uint16_t, 4>, face_limit> corners_;  // the fourth is not used, here and below
  std::array<std::array<Edge, 4>, face_limit> neighbours_;        // the same edge as edge of the face beyond
  std::array<std::uint8_t, face_limit> visible_;
  std::array<std::uint16_t, face_limit> free_;  // faces below face_count_ that are not in use
  std::size_t vertex_count_ = 0;
  std::size_t face_count_ = 0;
  std::size_t free_count_ = 0;
};

}  // namespace abut
