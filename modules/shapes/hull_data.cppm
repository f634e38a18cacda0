// The data of a convex hull: vertices for support points, faces for clipping, and the way there.
module;
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>
export module abut.shape.hull_data;
import abut.math;
import abut.shape;

export namespace abut {

// Four doubles that the compiler keeps in one vector register where the target has one.
using Lanes = double __attribute__((ext_vector_type(4)));
using LaneNumbers = std::int64_t __attribute__((ext_vector_type(4)));

struct HullFace {
  Vec3 normal;          // outward, unit
  Real offset;          // dot(normal, p) on the face
  std::uint32_t first;  // into face_vertices and face_edges
  std::uint32_t count;
};

struct HullData {
  // Vertices in blocks of four, x, y and z apart, for one pass over all of them. The last block is
  // filled up with copies of the last vertex.
  struct Block {
    Lanes x, y, z;
  };

  std::vector<Vec3> vertices;
  std::vector<Block> blocks;
  std::vector<HullFace> faces;  // none when the hull is a segment or a point
  std::vector<std::uint32_t> face_vertices;
  std::vector<std::uint32_t> face_edges;    // edge i leads from face vertex i to the next
  std::vector<std::uint32_t> faces_at;      // faces around a vertex: faces_at[first_face[v] ...]
  std::vector<std::uint32_t> first_face;    // one more than vertices
  std::vector<std::uint32_t> cell_vertices; // candidates of a direction cell: cell_vertices[first_candidate[cell] ...]
  std::vector<std::uint32_t> first_candidate;
  Vec3 low{}, high{}, centre{};
  Real extent = 0;

  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    return first_candidate.empty() ? scan(direction) : look_up(direction);
  }

  // Directions are sorted into cells of a cube: six sides, cells_per_side squared each.
  static constexpr std::size_t cells_per_side = 8;
  [[nodiscard]] static inline std::size_t cell_of(const Vec3& d) {
    const Vec3 m{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
    const int axis = m.x >= m.y && m.x >= m.z ? 0 : m.y >= m.z ? 1 : 2;
    const Real main = d[axis];
    const Real u = d[axis == 0 ? 1 : 0], v = d[axis == 2 ? 1 : 2];
    const std::size_t side = static_cast<std::size_t>(2 * axis + (main >= 0 ? 1 : 0));
    const Real scale = 1 / std::fabs(main);
    return (side * cells_per_side + step_of(v * scale)) * cells_per_side + step_of(u * scale);
  }

 private:
  [[nodiscard]] static inline std::size_t step_of(Real ratio) {
    constexpr auto cells = static_cast<Real>(cells_per_side);
    // A zero direction gives NaN, which the comparison sends to the first cell.
    const Real at = (ratio + 1) * (0.5 * cells);
    return at > 0 ? (at < cells ? static_cast<std::size_t>(at) : cells_per_side - 1) : 0;
  }

  // Largest dot product over all vertices; among equals the lowest vertex number.
  [[nodiscard]] inline SupportPoint scan(const Vec3& d) const {
    const Lanes dx = d.x, dy = d.y, dz = d.z;
    Lanes best = -infinity;
    LaneNumbers best_block = 0;
    std::int64_t number = 0;
    for (const Block& block : blocks) {
      const Lanes value = block.x * dx + block.y * dy + block.z * dz;
      const LaneNumbers better = value > best;
      best = better ? value : best;
      best_block = better ? LaneNumbers(number) : best_block;
      ++number;
    }
    Real top = best[0];
    std::int64_t index = 4 * best_block[0];
    for (int lane = 1; lane < 4; ++lane) {
      const std::int64_t candidate = 4 * best_block[lane] + lane;
      if (best[lane] > top || (best[lane] == top && candidate < index)) {
        top = best[lane];
        index = candidate;
      }
    }
    const std::size_t vertex = static_cast<std::size_t>(index) < vertices.size() ? static_cast<std::size_t>(index) : vertices.size() - 1;
    return {vertices[vertex], static_cast<std::uint32_t>(vertex)};
  }

  [[nodiscard]] inline SupportPoint look_up(const Vec3& d) const {
    const std::size_t cell = cell_of(d);
    const std::span<const std::uint32_t> candidates =
        std::span(cell_vertices).subspan(first_candidate[cell], first_candidate[cell + 1] - first_candidate[cell]);
    std::uint32_t best = candidates.front();
    Real top = -infinity;
    for (const std::uint32_t vertex : candidates) {
      const Real value = dot(vertices[vertex], d);
      best = value > top ? vertex : best;
      top = value > top ? value : top;
    }
    return {vertices[best], best};
  }
};

// The hull of at least one finite point; coplanar, collinear and coincident points are welcome.
[[nodiscard]] HullData build_hull(std::span<const Vec3> points);

// Fills in what follows from vertices and faces: blocks, faces around vertices, edges, cells, bounds.
void finish_hull(HullData& hull);

}  // namespace abut
