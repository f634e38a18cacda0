// SPDX-License-Identifier: Apache-2.0
// All axes of a triangle with a box or another triangle, four at a time (Gottschalk, Lin, Manocha, "OBBTree", 1996).
export module abut.narrow.fan.triangle_sat;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.sat;

export namespace abut {

template <class S>
inline constexpr bool is_box = BoxCored<S> && !PointCored<S> && !SegmentCored<S>;

// From where to where a core reaches along the axis of each lane.
struct Reaches {
  Lanes low, high;
};
[[nodiscard]] [[gnu::always_inline]] inline Reaches reaches_of(const TriangleCorners& corners, const Columns& axes) {
  const Lanes a = dot(axes, Columns::all(corners[0])), b = dot(axes, Columns::all(corners[1])),
              c = dot(axes, Columns::all(corners[2]));
  return {minimum(minimum(a, b), c), maximum(maximum(a, b), c)};
}

// A core in the frame of a triangle that it meets: its edges and the normals of its faces, one per lane. Lanes without
// any are zero.
template <class B>
class PlacedBeside;

template <class B>
  requires is_box<B>
class PlacedBeside<B> {
 public:
  static constexpr std::size_t face_count = 3;

  [[gnu::always_inline]] inline PlacedBeside(const B& b, const Pose& ab) : half_(b.half()), pose_(ab) {}

  [[nodiscard]] [[gnu::always_inline]] inline Columns edges() const {
    const LaneMatrix rows = LaneMatrix::rows_of(pose_.rotation);
    return {rows.x, rows.y, rows.z};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Columns faces() const { return edges(); }
  [[nodiscard]] [[gnu::always_inline]] inline Reaches along(const Columns& axes) const {
    const auto half_along = [&](const Vec3& axis, Real half) {
      return absolute(dot(axes, Columns::all(axis))) * all_lanes(half);
    };
    const Rotation& r = pose_.rotation;
    const Lanes centre = dot(axes, Columns::all(pose_.position)),
                half = half_along(r.x, half_.x) + half_along(r.y, half_.y) + half_along(r.z, half_.z);
    return {centre - half, centre + half};
  }

 private:
  Vec3 half_;
  Pose pose_;
};

template <>
class PlacedBeside<Triangle> {
 public:
  static constexpr std::size_t face_count = 1;

  [[gnu::always_inline]] inline PlacedBeside(const Triangle& b, const Pose& ab)
      : corners_{ab * b.corners()[0], ab * b.corners()[1], ab * b.corners()[2]}, normal_(ab.rotation * b.normal()) {}

  [[nodiscard]] [[gnu::always_inline]] inline Columns edges() const {
    const auto& [a, b, c] = corners_;
    return Columns::of(lanes_of(b - a), lanes_of(c - b), lanes_of(a - c), all_lanes(0));
  }
  [[nodiscard]] [[gnu::always_inline]] inline Columns faces() const {
    return {{normal_.x, 0, 0, 0}, {normal_.y, 0, 0, 0}, {normal_.z, 0, 0, 0}};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Reaches along(const Columns& axes) const {
    return reaches_of(corners_, axes);
  }

 private:
  TriangleCorners corners_;
  Vec3 normal_;
};

// Pairs that have this search.
template <class A, class B>
inline constexpr bool has_triangle_sat = std::same_as<A, Triangle> && (is_box<B> || std::same_as<B, Triangle>);

// The axes of the faces of both, into `best`.
template <class B>
[[gnu::always_inline]] inline void take_faces(const Triangle& triangle, const PlacedBeside<B>& b, SatResult& best) {
  const auto take = [&](const Vec3& n, Real ahead, Real behind, const CoreFeatures& of_axis,
                        const CoreFeatures& of_opposite) {
    const bool is_opposite = behind > ahead;
    const Real separation = is_opposite ? behind : ahead;
    ++best.axes;
    if (separation > best.separation) {
      best = {separation, is_opposite ? -n : n, best.axes, is_opposite ? of_opposite : of_axis};
    }
  };
  if (triangle.has_area()) {
    const Columns normal = Columns::all(triangle.normal());
    const Reaches of_a = reaches_of(triangle.corners(), normal), of_b = b.along(normal);
    take(triangle.normal(), of_b.low[0] - of_a.high[0], of_a.low[0] - of_b.high[0], {core_face(1), {}},
         {core_face(0), {}});
  }
  const Columns faces = b.faces();
  const Reaches of_a = reaches_of(triangle.corners(), faces), of_b = b.along(faces);
  const Lanes ahead = of_b.low - of_a.high, behind = of_a.low - of_b.high;
  for (std::size_t face = 0; face < PlacedBeside<B>::face_count; ++face) {
    if (const Vec3 n = faces[face]; squared_norm(n) > 0) {
      take(n, ahead[face], behind[face], {{}, core_face(2 * face)}, {{}, core_face(2 * face + 1)});
    }
  }
}

// The axes across edges of both, where they beat the faces by more than `noise`. False where edges are so nearly
// parallel that the axis across them is rounding. `enough`: as triangle_sat has it.
template <class B>
[[nodiscard]] [[gnu::always_inline]] inline bool take_edges(const Triangle& triangle, const PlacedBeside<B>& b,
                                                            Real noise, Real enough, SatResult& best) {
  constexpr Real least_square = 1e-280;
  const Columns edges_b = b.edges();
  const Lanes squares_b = dot(edges_b, edges_b);
  const auto edges_a = triangle.edge_directions();
  Real most = best.separation + noise;
  std::size_t edge_a = 0, edge_b = 0;
  bool is_found = false, is_opposite = false;
  for (std::size_t i = 0; i < edges_a.size() && !(is_found && most > enough); ++i) {
    const Columns axes = cross(Columns::all(edges_a[i]), edges_b);
    const Lanes square = dot(axes, axes), whole = squared_norm(edges_a[i]) * squares_b;
    const LaneNumbers is_across = (square > slender_square * whole) & (square > all_lanes(least_square));
    if (bits_of(is_across | (square <= parallel_square * whole)) != 15) {
      return false;
    }
    const Reaches of_a = reaches_of(triangle.corners(), axes), of_b = b.along(axes);
    const Lanes ahead = of_b.low - of_a.high, behind = of_a.low - of_b.high,
                separation = maximum(ahead, behind) / __builtin_elementwise_sqrt(square);
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_across[j] != 0 && separation[j] > most) {
        most = separation[j];
        edge_a = i;
        edge_b = j;
        is_opposite = behind[j] > ahead[j];
        is_found = true;
      }
    }
    best.axes += 3;
  }
  if (is_found) {
    const Vec3 &a = edges_a[edge_a], along_b = edges_b[edge_b], product = cross(a, along_b);
    const Vec3 n = unit_across_edges(a, along_b, product, squared_norm(product));
    best = {most, is_opposite ? -n : n, best.axes, {core_edge(edge_a), core_edge(edge_b)}};
  }
  return true;
}

// As sat does for any cores with few faces. Nothing where rounding leaves the axes in doubt. `enough`: an axis that
// parts both by more ends the search.
template <class A, class B>
  requires has_triangle_sat<A, B>
[[nodiscard]] inline std::optional<SatResult> triangle_sat(const A& a, const B& b, const Pose& ab, Real noise,
                                                           Real enough = infinity) {
  const PlacedBeside<B> placed(b, ab);
  SatResult best{-infinity, {0, 0, 0}, 0, {}};
  take_faces(a, placed, best);
  if (best.separation > enough) {
    return best;
  }
  return take_edges(a, placed, noise, enough, best) && best.separation > -infinity ? std::optional(best) : std::nullopt;
}

}  // namespace abut
