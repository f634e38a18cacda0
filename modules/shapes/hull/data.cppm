// SPDX-License-Identifier: Apache-2.0
// The data of a convex hull: vertices for support points, faces for clipping, and the way there.
export module abut.shapes.hull.data;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

struct HullFace {
  Vec3 normal;          // outward, unit
  Real offset;          // dot(normal, p) on the face
  std::uint32_t first;  // into face_vertices and face_edges
  std::uint32_t count;
};

// Faces and edges for trying separating axes, four at a time.
struct HullFacets {
  // Unit normals out of four faces that look alike, and how far the vertices reach along each; the last four are
  // filled up with copies of the last face.
  struct Planes {
    Lanes x, y, z, reach;
  };
  // Normals of the faces to the left of four edges, seen from outside along them, and to the right, and a vertex.
  struct Arcs {
    Lanes left_x, left_y, left_z, right_x, right_y, right_z, from_x, from_y, from_z;
  };
  struct Line {
    Lanes from, along;  // a vertex, and the way to the next one
  };
  // Where among the points the vertices of an edge are.
  struct Ends {
    std::uint32_t from, to;
  };
  // Where among the planes the faces to the left and to the right of an edge are.
  struct Sides {
    std::uint32_t left, right;
  };
  std::vector<Lanes> points;  // the vertices, the first ones far from each other
  std::vector<Planes> planes;
  std::vector<std::uint32_t> faces;  // which face each plane is of
  std::vector<Sides> sides;          // of each edge
  std::vector<Arcs> arcs;            // filled up with copies of the left side, which are arcs without length
  std::vector<Line> lines;           // of each edge
  std::vector<Ends> ends;            // of each edge
  Vec3 middle{};                     // the centre of a ball inside
  Real inner = 0;                    // and its radius
  Real flatness = 0;                 // no vertex of a face is further than this behind its plane
  bool is_closed = false;            // whether every edge has a face on either side
};

// What building a hull left of the points.
struct HullReport {
  std::uint32_t dimension = 0;  // 0 a point, 1 a segment, 2 a polygon, 3 a solid
  std::size_t point_count = 0;  // given, duplicates included
  std::size_t vertex_count = 0;
  std::size_t edge_count = 0;
  std::size_t face_count = 0;  // a polygon has two, one to either side
  Real error = 0;              // the largest distance of a given point from the hull; 0 below rounding
};

struct HullData {
  // Vertices in blocks of four, x, y and z apart, for one pass over all of them. The last block is
  // filled up with copies of the last vertex.
  struct Block {
    Lanes x, y, z;
  };
  // Vertex numbers, ascending; the last four of a list are filled up with its last one.
  using Four = std::array<std::uint32_t, 4>;

  std::vector<Vec3> vertices;
  std::vector<Block> blocks;
  std::vector<HullFace> faces;  // none when the hull is a segment or a point
  std::vector<std::uint32_t> face_vertices;
  std::vector<std::uint32_t> face_edges;  // edge i leads from face vertex i to the next
  std::vector<std::uint32_t> faces_at;    // faces around a vertex: faces_at[first_face[v] ...]
  std::vector<std::uint32_t> next_at;     // the vertices that come next on these faces
  std::vector<std::uint32_t> first_face;  // one more than vertices
  std::vector<Four> candidates;           // of a direction cell: candidates[first_candidates[cell] ...]
  std::vector<std::uint32_t> first_candidates;
  HullFacets facets;
  Vec3 low{}, high{}, centre{};
  Real extent = 0;
  HullReport report;

  [[nodiscard]] [[gnu::always_inline]] inline SupportPoint support(const Vec3& direction) const {
    return first_candidates.empty() ? scan(direction) : look_up(direction);
  }

  // The face that looks along a direction, of those around a vertex that lies furthest that way. Where an edge or a
  // face lies as far, one that holds all of it: rounding picks the vertex, and must not pick the face.
  [[nodiscard]] inline std::uint32_t face_along(std::uint32_t vertex, const Vec3& direction) const {
    const Real tie = tie_share * largest_magnitude(direction), lowest = dot(vertices[vertex], direction) - tie * extent;
    const auto is_as_high = [&](std::uint32_t other) { return dot(vertices[other], direction) >= lowest; };
    const std::size_t first = first_face[vertex], count = first_face[vertex + 1] - first;
    // The vertices of a convex hull fall from its highest one on: where no neighbour is as high, no other vertex is.
    const bool is_alone = std::ranges::none_of(std::span(next_at).subspan(first, count), is_as_high);
    std::uint32_t found = 0;
    std::ptrdiff_t most = 0;
    Real best = 0;
    for (const std::uint32_t place : std::span(faces_at).subspan(first, count)) {
      const HullFace& face = faces[place];
      const std::ptrdiff_t held =
          is_alone ? 1 : std::ranges::count_if(std::span(face_vertices).subspan(face.first, face.count), is_as_high);
      const Real alignment = dot(face.normal, direction);
      const bool is_better = held > most || (held == most && alignment > best + tie);
      found = is_better ? place : found;
      most = is_better ? held : most;
      best = is_better ? alignment : best;
    }
    return found;
  }

  // Up to this many vertices one pass over all of them is the faster way (measured).
  static constexpr std::size_t scan_limit = 48;

  // Directions are sorted into cells of a cube: six sides, cells_per_side squared each.
  static constexpr std::size_t cells_per_side = 8;
  [[nodiscard]] static inline std::size_t cell_of(const Vec3& d) {
    const Vec3 m{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
    const int axis = m.x >= m.y && m.x >= m.z ? 0 : m.y >= m.z ? 1 : 2;
    const Real main = d[axis];
    const Real u = d[axis == 0 ? 1 : 0], v = d[axis == 2 ? 1 : 2];
    const std::size_t side = static_cast<std::size_t>(2 * axis + (main >= 0 ? 1 : 0));
    const Real scale = main != 0 ? 1 / std::fabs(main) : 0;  // a direction to nowhere is at home in any cell
    return (side * cells_per_side + step_of(v * scale)) * cells_per_side + step_of(u * scale);
  }

 private:
  [[nodiscard]] static inline std::size_t step_of(Real ratio) {
    constexpr auto cells = static_cast<Real>(cells_per_side);
    const Real at = (ratio + 1) * (0.5 * cells);
    return at > 0 ? (at < cells ? static_cast<std::size_t>(at) : cells_per_side - 1) : 0;
  }

  // A bit per lane that holds the value.
  [[nodiscard]] static inline std::uint64_t lanes_with(Lanes values, Real value) {
    using Flags = bool __attribute__((ext_vector_type(4)));
    const LaneNumbers equal = values == all_lanes(value);
    return std::bit_cast<std::uint8_t>(__builtin_convertvector(equal, Flags)) & 15u;
  }

  // The largest dot products seen so far in each lane, and the vertices that have them.
  struct Leaders {
    Lanes values;
    LaneNumbers vertices;
  };
  [[nodiscard]] [[gnu::always_inline]] static inline Leaders larger(const Leaders& a, const Leaders& b) {
    const LaneNumbers beyond = b.values > a.values;
    return {beyond ? b.values : a.values, beyond ? b.vertices : a.vertices};
  }

  // Largest dot product over all vertices. Which of equal ones is found depends on their places alone.
  [[nodiscard]] [[gnu::always_inline]] inline SupportPoint scan(const Vec3& d) const {
    const Lanes dx = d.x, dy = d.y, dz = d.z;
    LaneNumbers numbers{0, 1, 2, 3};
    const auto leaders_of = [&](std::size_t i) __attribute__((always_inline)) {
      const Block& block = blocks[i];
      const Leaders found{multiply_add(block.z, dz, multiply_add(block.y, dy, block.x * dx)), numbers};
      numbers += 4;
      return found;
    };
    // Two chains of maxima take half the time of one.
    const std::size_t count = blocks.size();
    Leaders even = leaders_of(0), odd = even;
    std::size_t next = 1;
    for (; next + 1 < count; next += 2) {
      odd = larger(odd, leaders_of(next));
      even = larger(even, leaders_of(next + 1));
    }
    if (next < count) {
      odd = larger(odd, leaders_of(next));
    }
    const Leaders best = larger(even, odd);
    using Two = double __attribute__((ext_vector_type(2)));
    using TwoNumbers = std::int64_t __attribute__((ext_vector_type(2)));
    const TwoNumbers upper = best.values.hi > best.values.lo;
    const Two values = upper ? best.values.hi : best.values.lo;
    const TwoNumbers holders = upper ? best.vertices.hi : best.vertices.lo;
    const auto found = static_cast<std::size_t>(values[1] > values[0] ? holders[1] : holders[0]);
    // The copies in the last block have numbers beyond the vertex that they are copies of.
    const std::size_t vertex = found < vertices.size() ? found : vertices.size() - 1;
    return {vertices[vertex], static_cast<std::uint32_t>(vertex)};
  }

  [[nodiscard]] [[gnu::always_inline]] inline SupportPoint look_up(const Vec3& d) const {
    const std::size_t cell = cell_of(d);
    const std::size_t last = first_candidates[cell + 1];
    std::uint32_t best = 0;
    Real top = -infinity;
    for (std::size_t i = first_candidates[cell]; i < last; ++i) {
      const Four& four = candidates[i];
      const Vec3 &p = vertices[four[0]], &q = vertices[four[1]], &r = vertices[four[2]], &s = vertices[four[3]];
      const Lanes x{p.x, q.x, r.x, s.x}, y{p.y, q.y, r.y, s.y}, z{p.z, q.z, r.z, s.z};
      const Lanes values = multiply_add(z, Lanes(d.z), multiply_add(y, Lanes(d.y), x * d.x));
      const Real highest = largest(values);
      if (highest > top) {
        top = highest;
        best = four[static_cast<std::size_t>(std::countr_zero(lanes_with(values, highest))) & 3u];
      }
    }
    return {vertices[best], best};
  }
};

// The hull of at least one finite point; coplanar, collinear and coincident points are welcome.
[[nodiscard]] HullData build_hull(std::span<const Vec3> points);

// The hull that has these vertices and faces, in their order: as it was when it was built from points. `faces`: of each
// face how many corners it has, and its corners, counter-clockwise seen from outside; a single 0 for a point or a
// segment.
[[nodiscard]] Result<HullData> hull_of_faces(std::span<const Vec3> vertices, std::span<const std::uint32_t> faces);
[[nodiscard]] std::vector<std::uint32_t> faces_of(const HullData& hull);

// A face by its corners, counter-clockwise seen from outside. One without area bounds nothing and is left out.
void add_face(HullData& hull, std::span<const std::uint32_t> loop);

// Fills in what follows from vertices and faces: blocks, faces around vertices, edges, cells, facets, bounds.
void finish_hull(HullData& hull);

// What became of the points that a finished hull is to be the hull of. `noise`: what counts as rounding.
[[nodiscard]] HullReport report_on(const HullData& hull, std::span<const Vec3> points, Real noise);

}  // namespace abut
