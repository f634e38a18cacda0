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

// How far another core lies beyond a triangle along the axis of each lane, and along its opposite.
struct Gaps {
  Lanes ahead, behind;
};
// The same along axes across an edge of the triangle and each edge of the other core, times the lengths of the axes.
// `square`: of these lengths. `whole`: of those across edges as long that meet at a right angle.
struct EdgeGaps {
  Gaps gaps;
  Lanes square, whole;
};

// A core in the frame of a triangle that it meets. Its faces come after that of the triangle, one per lane; lanes
// without any are zero.
template <class B>
class PlacedBeside;

// All is told in the frame of the box. The heights of a point p across an edge e and the axes are the coordinates of
// p x e.
template <class B>
  requires is_box<B>
class PlacedBeside<B> {
 public:
  [[gnu::always_inline]] inline PlacedBeside(const Triangle& triangle, const B& b, const Pose& ab)
      : rotation_(ab.rotation),
        normal_(triangle.normal()),
        half_(lanes_of(b.half())),
        corners_(in_box(triangle.corners(), ab.position)),
        edges_(in_box(triangle.edge_directions(), {0, 0, 0})) {}

  [[nodiscard]] [[gnu::always_inline]] inline Columns faces() const {
    const Rotation& r = rotation_;
    return Columns::of(lanes_of(normal_), lanes_of(r.x), lanes_of(r.y), lanes_of(r.z));
  }
  [[nodiscard]] [[gnu::always_inline]] inline Gaps beyond_faces() const {
    const auto& [a, b, c] = corners_;
    const Lanes low = minimum(minimum(a, b), c), high = maximum(maximum(a, b), c);
    const Lanes n = LaneMatrix::rows_of(rotation_) * normal_;
    const Real of_a = dot(n, a), of_b = dot(n, b), of_c = dot(n, c), half = dot(absolute(n), half_);
    const Real lowest = std::fmin(std::fmin(of_a, of_b), of_c), highest = std::fmax(std::fmax(of_a, of_b), of_c);
    return {after(-highest - half, -high - half_), after(lowest - half, low - half_)};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Vec3 edge(std::size_t lane) const {
    return lane == 0 ? rotation_.x : lane == 1 ? rotation_.y : rotation_.z;
  }
  [[nodiscard]] [[gnu::always_inline]] inline EdgeGaps beyond_edges(std::size_t edge) const {
    const Lanes e = edges_[edge], wide = absolute(e), squares = e * e;
    const Lanes of_edge = cross(corners_[edge], e), of_corner = cross(corners_[(edge + 2) % 3], e);
    const Lanes half = half_.yzxw * wide.zxyw + half_.zxyw * wide.yzxw;
    return {{-half - maximum(of_edge, of_corner), minimum(of_edge, of_corner) - half},
            squares.yzxw + squares.zxyw,
            all_lanes(sum(squares))};
  }

 private:
  [[nodiscard]] [[gnu::always_inline]] inline std::array<Lanes, 3> in_box(const std::array<Vec3, 3>& vectors,
                                                                          const Vec3& from) const {
    const LaneMatrix back = LaneMatrix::rows_of(rotation_);
    return {back * (vectors[0] - from), back * (vectors[1] - from), back * (vectors[2] - from)};
  }
  [[nodiscard]] [[gnu::always_inline]] static inline Lanes cross(Lanes a, Lanes b) {
    return a.yzxw * b.zxyw - a.zxyw * b.yzxw;
  }
  [[nodiscard]] [[gnu::always_inline]] static inline Lanes after(Real first, Lanes others) {
    return __builtin_shufflevector(all_lanes(first), others, 0, 4, 5, 6);
  }

  Rotation rotation_;
  Vec3 normal_;  // of the triangle
  Lanes half_;
  std::array<Lanes, 3> corners_, edges_;  // of the triangle
};

template <>
class PlacedBeside<Triangle> {
 public:
  [[gnu::always_inline]] inline PlacedBeside(const Triangle& triangle, const Triangle& b, const Pose& ab)
      : corners_of_a_(triangle.corners()),
        normal_of_a_(triangle.normal()),
        edges_(triangle.edge_directions()),
        corners_{ab * b.corners()[0], ab * b.corners()[1], ab * b.corners()[2]},
        normal_(ab.rotation * b.normal()) {}

  [[nodiscard]] [[gnu::always_inline]] inline Columns faces() const {
    const Vec3& first = normal_of_a_;
    return {{first.x, normal_.x, 0, 0}, {first.y, normal_.y, 0, 0}, {first.z, normal_.z, 0, 0}};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Gaps beyond_faces() const { return beyond(faces()); }
  [[nodiscard]] [[gnu::always_inline]] inline Vec3 edge(std::size_t lane) const {
    return corners_[(lane + 1) % 3] - corners_[lane];
  }
  [[nodiscard]] [[gnu::always_inline]] inline EdgeGaps beyond_edges(std::size_t edge) const {
    const auto& [a, b, c] = corners_;
    const Columns edges = Columns::of(lanes_of(b - a), lanes_of(c - b), lanes_of(a - c), all_lanes(0));
    const Columns axes = cross(Columns::all(edges_[edge]), edges);
    return {beyond(axes), dot(axes, axes), squared_norm(edges_[edge]) * dot(edges, edges)};
  }

 private:
  struct Reaches {
    Lanes low, high;
  };
  [[nodiscard]] [[gnu::always_inline]] static inline Reaches reaches_of(const TriangleCorners& corners,
                                                                        const Columns& axes) {
    const Lanes a = dot(axes, Columns::all(corners[0])), b = dot(axes, Columns::all(corners[1])),
                c = dot(axes, Columns::all(corners[2]));
    return {minimum(minimum(a, b), c), maximum(maximum(a, b), c)};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Gaps beyond(const Columns& axes) const {
    const Reaches of_a = reaches_of(corners_of_a_, axes), of_b = reaches_of(corners_, axes);
    return {of_b.low - of_a.high, of_a.low - of_b.high};
  }

  TriangleCorners corners_of_a_;
  Vec3 normal_of_a_;
  std::array<Vec3, 3> edges_;  // of a
  TriangleCorners corners_;
  Vec3 normal_;
};

// Pairs that have this search.
template <class A, class B>
inline constexpr bool has_triangle_sat = std::same_as<A, Triangle> && (is_box<B> || std::same_as<B, Triangle>);

// The axes of the faces of both, into `best`. Of equals the first one counts.
template <class B>
[[gnu::always_inline]] inline void take_faces(const PlacedBeside<B>& b, SatResult& best) {
  const Columns faces = b.faces();
  const auto [ahead, behind] = b.beyond_faces();
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
  LeastDepths least;
  std::array<LaneNumbers, 3> are_opposite{};
  LaneNumbers are_clear = all_lanes(0) == all_lanes(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [gaps, square, whole] = b.beyond_edges(i);
    const LaneNumbers are_across = (square > slender_square * whole) & (square > all_lanes(least_square));
    are_clear &= are_across | (square <= parallel_square * whole);
    const Lanes depth = -maximum(gaps.ahead, gaps.behind) / __builtin_elementwise_sqrt(square);
    are_opposite[i] = gaps.behind > gaps.ahead;
    least.consider(are_across ? depth : all_lanes(infinity), i);
  }
  if (bits_of(are_clear) != 15) {
    return false;
  }
  best.axes += 9;
  const std::size_t lane = least.lane();
  if (-least.depth[lane] > best.separation + noise) {
    const auto edge = static_cast<std::size_t>(least.which[lane]);
    const Vec3 a = triangle.edge_directions()[edge], along_b = b.edge(lane), product = cross(a, along_b);
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
  const PlacedBeside<B> placed(a, b, ab);
  SatResult best{-infinity, {0, 0, 0}, 0, {}};
  take_faces(placed, best);
  if (best.separation > enough) {
    return best;
  }
  return take_edges(a, placed, noise, best) && best.separation > -infinity ? std::optional(best) : std::nullopt;
}

}  // namespace abut
