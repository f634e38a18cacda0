// SPDX-License-Identifier: Apache-2.0
// All axes of a triangle with a box or another triangle, four at a time (Gottschalk, Lin, Manocha, "OBBTree", 1996).
export module abut.narrow.fan.triangle_sat;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.facets;
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

// A core in the frame of a triangle that it meets: its edges, and the normals of its faces after that of the triangle,
// one per lane. Lanes without any are zero.
template <class B>
class PlacedBeside;

template <class B>
  requires is_box<B>
class PlacedBeside<B> {
 public:
  [[gnu::always_inline]] inline PlacedBeside(const B& b, const Pose& ab) : half_(b.half()), pose_(ab) {}

  [[nodiscard]] [[gnu::always_inline]] inline Columns edges() const {
    const LaneMatrix rows = LaneMatrix::rows_of(pose_.rotation);
    return {rows.x, rows.y, rows.z};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Columns faces_after(const Vec3& first) const {
    const Rotation& r = pose_.rotation;
    return Columns::of(lanes_of(first), lanes_of(r.x), lanes_of(r.y), lanes_of(r.z));
  }
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
  [[gnu::always_inline]] inline PlacedBeside(const Triangle& b, const Pose& ab)
      : corners_{ab * b.corners()[0], ab * b.corners()[1], ab * b.corners()[2]}, normal_(ab.rotation * b.normal()) {}

  [[nodiscard]] [[gnu::always_inline]] inline Columns edges() const {
    const auto& [a, b, c] = corners_;
    return Columns::of(lanes_of(b - a), lanes_of(c - b), lanes_of(a - c), all_lanes(0));
  }
  [[nodiscard]] [[gnu::always_inline]] inline Columns faces_after(const Vec3& first) const {
    return {{first.x, normal_.x, 0, 0}, {first.y, normal_.y, 0, 0}, {first.z, normal_.z, 0, 0}};
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

// The axes of the faces of both, into `best`. Of equals the first one counts.
template <class B>
[[gnu::always_inline]] inline void take_faces(const Triangle& triangle, const PlacedBeside<B>& b, SatResult& best) {
  const Columns faces = b.faces_after(triangle.normal());
  const Reaches of_a = reaches_of(triangle.corners(), faces), of_b = b.along(faces);
  const Lanes ahead = of_b.low - of_a.high, behind = of_a.low - of_b.high;
  const LaneNumbers are_there = dot(faces, faces) > all_lanes(0);
  LeastDepths least;
  least.consider(are_there ? -maximum(ahead, behind) : all_lanes(infinity), 0);
  best.axes = static_cast<std::uint32_t>(__builtin_popcountll(bits_of(are_there)));
  const std::size_t lane = least.lane();
  if (!(least.depth[lane] < infinity)) {
    return;
  }
  const bool is_opposite = behind[lane] > ahead[lane];
  best.separation = -least.depth[lane];
  best.normal = is_opposite ? -faces[lane] : faces[lane];
  best.features = lane == 0 ? CoreFeatures{core_face(is_opposite ? 0 : 1), {}}
                            : CoreFeatures{{}, core_face(2 * (lane - 1) + (is_opposite ? 1 : 0))};
}

// The axes across edges of both, where they beat the faces by more than `noise`. False where edges are so nearly
// parallel that the axis across them is rounding. Of equals the first one counts.
template <class B>
[[nodiscard]] [[gnu::always_inline]] inline bool take_edges(const Triangle& triangle, const PlacedBeside<B>& b,
                                                            Real noise, SatResult& best) {
  constexpr Real least_square = 1e-280;
  const Columns edges_b = b.edges();
  const Lanes squares_b = dot(edges_b, edges_b);
  const auto edges_a = triangle.edge_directions();
  LeastDepths least;
  std::array<LaneNumbers, 3> are_opposite{};
  LaneNumbers are_clear = all_lanes(0) == all_lanes(0);
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    const Columns axes = cross(Columns::all(edges_a[i]), edges_b);
    const Lanes square = dot(axes, axes), whole = squared_norm(edges_a[i]) * squares_b;
    const LaneNumbers are_across = (square > slender_square * whole) & (square > all_lanes(least_square));
    are_clear &= are_across | (square <= parallel_square * whole);
    const Reaches of_a = reaches_of(triangle.corners(), axes), of_b = b.along(axes);
    const Lanes ahead = of_b.low - of_a.high, behind = of_a.low - of_b.high,
                depth = -maximum(ahead, behind) / __builtin_elementwise_sqrt(square);
    are_opposite[i] = behind > ahead;
    least.consider(are_across ? depth : all_lanes(infinity), i);
  }
  if (bits_of(are_clear) != 15) {
    return false;
  }
  best.axes += 9;
  const std::size_t lane = least.lane();
  if (-least.depth[lane] > best.separation + noise) {
    const auto edge = static_cast<std::size_t>(least.which[lane]);
    const Vec3 &a = edges_a[edge], along_b = edges_b[lane], product = cross(a, along_b);
    const Vec3 n = unit_across_edges(a, along_b, product, squared_norm(product));
    best.separation = -least.depth[lane];
    best.normal = are_opposite[edge][lane] != 0 ? -n : n;
    best.features = {core_edge(edge), core_edge(lane)};
  }
  return true;
}

// As sat does for any cores with few faces. Nothing where rounding leaves the axes in doubt. `enough`: a face that
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
  return take_edges(a, placed, noise, best) && best.separation > -infinity ? std::optional(best) : std::nullopt;
}

}  // namespace abut
