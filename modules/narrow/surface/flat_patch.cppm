// SPDX-License-Identifier: Apache-2.0
// Triangles that make up flat ground within a box: they lie between two parallel planes, and leave no gap between them.
//
// Two conditions tell that there is no gap. Each edge that meets the box has an even number of triangles. An odd number
// of triangles covers one point of the plane within the box. Seen along the normal, the number of triangles over a
// point changes at edges only, each time by an even number. So it is odd everywhere within the box. Neither condition
// depends on how the triangles are numbered or wound, or whether some of them have no area.
//
// Edges are compared by the positions of their ends: each gives a number, and the exclusive or of all numbers is zero.
// So triangles need not share vertices, and an edit has nothing to update. Two different sums agree by chance in one of
// 2^60 cases. A neighbour across an edge of the nearest triangle rules out most other ground first. Vertices rounded to
// float give the ground a thickness: up to a millionth of the size of the shape, or four millionths at large
// coordinates. The normal is then the mean of all normals.
export module abut.narrow.surface.flat_patch;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

// Takes four triangles and a bit for each of them that counts. Answers whether it wants more.
using TakeFour = std::function<bool(const FourTriangles&, std::uint64_t)>;
// Calls a function with the triangles whose boxes overlap a box, until it wants no more.
using VisitFours = std::function<void(const Aabb&, const TakeFour&)>;

// Two parallel planes and what lies between: low <= dot(normal, p) <= high.
struct GroundSlab {
  Vec3 normal;
  Real low, high;
};

class [[gsl::Pointer]] FlatPatch {
 public:
  // What the triangles of the box have to agree with.
  struct Demand {
    Triangle seed;  // a triangle of the box, which tells the plane within the angle of `lean`
    Aabb box;
    Real thickness;     // of the slab, at most, where vertices are rounded to float; else it is noise
    Real noise;         // of coordinates
    bool are_oriented;  // whether all normals have to look the same way
  };
  static constexpr Real lean = 1e-5;  // radians

  // `visit` has to live as long as the patch.
  FlatPatch(const VisitFours& visit, const Demand& demand) : visit_(visit), demand_(demand) {}

  // The slab of all triangles, with the mean of their normals, which are weighted by their areas. None where they do
  // not fit into one, or where an edge that meets the box has an odd number of triangles. The order of the triangles
  // changes no bit of it.
  [[nodiscard]] std::optional<GroundSlab> slab();
  // Of the triangles that cover a point of the slab within the box, the lowest number. None where they are an even
  // number. Asks about places as far beside the point as `aside`, since triangles that share an edge both have its
  // points.
  [[nodiscard]] std::optional<std::uint32_t> triangle_at(const Vec3& point, Real aside);

 private:
  // Sums of edges: the exclusive or of a number for each edge, made from its ends. Where each edge is there an even
  // number of times it is zero; else it is zero with a probability of about 2^-60.
  struct EdgeSums {
    LaneNumbers all, narrow;
    [[nodiscard]] bool is_even() const;
  };
  struct Four {
    FourTriangles triangles;
    std::uint64_t counting;
  };
  enum class Edges : std::uint8_t { with_boxes, exactly };

  [[nodiscard]] bool take(const FourTriangles& triangles, std::uint64_t counting);
  void add_normals(const Columns& normals);
  [[nodiscard]] LaneNumbers are_narrow(const Columns& ab, const Columns& ac, Lanes along) const;
  void add_edges(const FourTriangles& triangles, std::uint64_t counting, Edges which, EdgeSums& sums) const;
  [[nodiscard]] bool has_even_edges();
  [[nodiscard]] Vec3 sum_of_normals() const;
  [[nodiscard]] bool has_rounded_heights();
  // The axis nearest to the normal.
  [[nodiscard]] int dropped_axis() const;
  // Those that were kept, or all once more where there were too many.
  template <class Visitor>
  void visit_all(const Visitor& visit);

  static constexpr std::size_t most_kept = 64;

  const VisitFours& visit_;
  Demand demand_;
  std::array<Four, most_kept> kept_;
  std::size_t count_ = 0;  // of all fours
  Columns sum_, rest_;     // of normals, and what its rounding has lost
  EdgeSums edges_;
};

}  // namespace abut
