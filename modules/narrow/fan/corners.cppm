// SPDX-License-Identifier: Apache-2.0
// The corners and planes of polytopes as the search for separating axes sees them from another one.
export module abut.narrow.fan.corners;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;

export namespace abut {

// What can be seen from a polytope: a core of few faces that knows all its corners.
template <class S>
inline constexpr bool is_seen = FewFaced<S> && (BoxCored<S> || Triangular<S>);

// Four planes, as the facets of a hull list them.
struct FourPlanes {
  Lanes x, y, z, reach;
};
// The corners and the planes of a core in its own frame, and a ball inside. Planes are in the order of face numbers.
template <std::size_t corner_count, std::size_t group_count>
struct Corners {
  std::array<Lanes, corner_count> points;
  std::array<FourPlanes, group_count> planes;
  Vec3 middle;
  Real inner;
};

[[nodiscard]] inline Corners<8, 2> corners_of_box(const Vec3& half) {
  Corners<8, 2> box{};
  for (std::size_t i = 0; i < 8; ++i) {
    box.points[i] =
        Lanes{(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y, (i & 4) != 0 ? half.z : -half.z, 0};
  }
  const Lanes none = 0;
  box.planes = {FourPlanes{{-1, 1, 0, 0}, {0, 0, -1, 1}, none, {half.x, half.x, half.y, half.y}},
                FourPlanes{none, none, {-1, 1, 1, 1}, half.z}};
  box.inner = half.x < half.y ? (half.x < half.z ? half.x : half.z) : (half.y < half.z ? half.y : half.z);
  return box;
}
template <class S>
  requires is_seen<S>
[[nodiscard]] inline auto corners_of(const S& shape) {
  if constexpr (Triangular<S>) {
    Corners<3, 1> triangle{};
    const Vec3& n = shape.normal();
    Lanes reach = -infinity;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.points[i] = lanes_of(shape.corners()[i]);
      const Real height = dot(n, shape.corners()[i]);
      reach = maximum(reach, Lanes{-height, height, height, height});
    }
    const Lanes side{-1, 1, 1, 1};
    triangle.planes = {FourPlanes{n.x * side, n.y * side, n.z * side, reach}};
    triangle.middle = shape.centre();
    return triangle;
  } else if constexpr (PointCored<S>) {
    return Corners<1, 0>{};
  } else if constexpr (SegmentCored<S>) {
    Corners<2, 1> segment{};
    segment.points = {Lanes{0, 0, -shape.half().z, 0}, Lanes{0, 0, shape.half().z, 0}};
    segment.planes = {FourPlanes{{-1, 1, 0, 0}, {0, 0, -1, 1}, all_lanes(0), all_lanes(0)}};
    return segment;
  } else {
    return corners_of_box(shape.half());
  }
}
template <Faceted S>
[[nodiscard]] inline const auto& corners_of(const S& shape) {
  return shape.facets();
}
// Faces that say nothing: a triangle without area has no normal.
template <class S>
[[nodiscard]] inline bool has_planes(const S& shape) {
  if constexpr (Triangular<S>) {
    return shape.has_area();
  } else {
    return Faceted<S> || !(PointCored<S> || SegmentCored<S>);
  }
}

// An edge by its ends among the corners, and the faces to its left and right, seen from outside along it.
struct EdgeNumbers {
  std::uint32_t from, to, left, right;
};
// Four edges along each axis.
inline constexpr std::array<EdgeNumbers, 12> edges_of_box = [] {
  std::array<EdgeNumbers, 12> edges{};
  for (std::uint32_t i = 0; i < 12; ++i) {
    const std::uint32_t axis = i / 4, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const std::uint32_t is_beyond_next = i & 1, is_beyond_last = i >> 1 & 1, is_odd = is_beyond_next ^ is_beyond_last;
    const std::uint32_t from = (is_beyond_next << next) | (is_beyond_last << last), to = from | (1u << axis);
    const std::uint32_t first = 2 * next + is_beyond_next, second = 2 * last + is_beyond_last;
    edges.at(i) = is_odd != 0 ? EdgeNumbers{from, to, second, first} : EdgeNumbers{from, to, first, second};
  }
  return edges;
}();
inline constexpr std::array<EdgeNumbers, 3> edges_of_triangle{{{0, 1, 1, 0}, {1, 2, 1, 0}, {2, 0, 1, 0}}};
// A segment is a box without width.
inline constexpr std::array<EdgeNumbers, 4> edges_of_segment{{{0, 1, 0, 2}, {0, 1, 2, 1}, {0, 1, 1, 3}, {0, 1, 3, 0}}};

template <class S>
  requires is_seen<S>
[[nodiscard]] consteval auto edges_of() {
  if constexpr (Triangular<S>) {
    return edges_of_triangle;
  } else if constexpr (SegmentCored<S>) {
    return edges_of_segment;
  } else {
    return edges_of_box;
  }
}
template <class S>
[[nodiscard]] inline std::size_t edge_count(const S& shape) {
  if constexpr (Faceted<S>) {
    return shape.facets().ends.size();
  } else {
    return edges_of<S>().size();
  }
}

// An edge and the numbers of the faces to its left and right. `own`: the corners of the shape.
struct SeenEdge {
  Lanes from, along;
  std::uint32_t left, right;
};
template <class S, class Own>
[[nodiscard]] [[gnu::always_inline]] inline SeenEdge edge_at(const S& shape, const Own& own, std::size_t index) {
  if constexpr (Faceted<S>) {
    const auto& line = shape.facets().lines[index];
    const auto& sides = shape.facets().sides[index];
    return {line.from, line.along, sides.left, sides.right};
  } else {
    static constexpr auto edges = edges_of<S>();
    const EdgeNumbers& edge = edges[index];
    return {own.points[edge.from], own.points[edge.to] - own.points[edge.from], edge.left, edge.right};
  }
}
// The number of an edge as a feature.
template <class S>
[[nodiscard]] inline CoreFeature edge_feature(std::size_t index) {
  if constexpr (Faceted<S> || Triangular<S>) {
    return core_edge(index);
  } else {
    return core_edge(SegmentCored<S> ? 2 : index / 4);
  }
}
// The edge between two corners, if there is one.
template <class S>
[[nodiscard]] inline CoreFeature edge_between(const S& shape, std::size_t first, std::size_t second) {
  const auto find = [&](const auto& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if ((edges[i].from == first && edges[i].to == second) || (edges[i].from == second && edges[i].to == first)) {
        return edge_feature<S>(i);
      }
    }
    return CoreFeature{};
  };
  if constexpr (Faceted<S>) {
    return find(shape.facets().ends);
  } else {
    return find(edges_of<S>());
  }
}

// Corners of a polytope in the frame of another one.
template <std::size_t capacity>
struct SeenCorners {
  static constexpr bool are_few = capacity <= 3;  // all of them: bounds cost more than they spare
  std::array<Lanes, capacity> points;
  std::size_t count;

  SeenCorners(std::span<const Lanes> corners, const Pose& pose) : count(0) {
    const LaneMatrix turn = LaneMatrix::columns_of(pose.rotation);
    const Lanes shift = lanes_of(pose.position);
    for (const Lanes& p : corners) {
      points[count++] = turn.apply(p, shift);
    }
  }

  // How near they come along each direction, and which of them does.
  struct Least {
    Lanes value = infinity;
    LaneNumbers corner{0, 0, 0, 0};
  };
  template <bool with_corner>
  [[gnu::always_inline]] inline void search(const Columns& n, std::size_t first, std::size_t last, Least& best) const {
    LaneNumbers corner = LaneNumbers(static_cast<std::int64_t>(first));
#pragma clang loop unroll_count(4)
    for (const Lanes& p : std::span(points).subspan(first, last - first)) {
      const Lanes value = multiply_add(n.z, p.zzzz, multiply_add(n.y, p.yyyy, n.x * p.xxxx));
      if constexpr (with_corner) {
        best.corner = value < best.value ? corner : best.corner;
        corner += LaneNumbers(1);
      }
      best.value = minimum(value, best.value);
    }
  }
  [[nodiscard]] [[gnu::always_inline]] inline Least least(const Columns& n) const {
    Least best;
    search<true>(n, 0, count, best);
    return best;
  }
};

// The same of a box, whose corner that comes nearest is told by the signs along its three arms.
struct SeenBox : SeenCorners<8> {
  static constexpr bool are_few = true;
  Vec3 centre;
  std::array<Vec3, 3> arms;

  SeenBox(std::span<const Lanes> corners, const Vec3& half, const Pose& pose)
      : SeenCorners(corners, pose),
        centre(pose.position),
        arms{half.x * pose.rotation.x, half.y * pose.rotation.y, half.z * pose.rotation.z} {}

  template <bool with_corner>
  [[gnu::always_inline]] inline void search(const Columns& n, std::size_t, std::size_t, Least& best) const {
    best.value = dot(n, Columns::all(centre));
    std::int64_t bit = 1;
    for (const Vec3& arm : arms) {
      const Lanes along = dot(n, Columns::all(arm));
      best.value -= absolute(along);
      if constexpr (with_corner) {
        best.corner += along < all_lanes(0) ? LaneNumbers(bit) : LaneNumbers(0);
        bit *= 2;
      }
    }
  }
  [[nodiscard]] [[gnu::always_inline]] inline Least least(const Columns& n) const {
    Least best;
    search<true>(n, 0, 8, best);
    return best;
  }
};

}  // namespace abut
