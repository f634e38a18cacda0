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
    Corners<2, 0> segment{};
    segment.points = {Lanes{0, 0, -shape.half().z, 0}, Lanes{0, 0, shape.half().z, 0}};
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

// The edge between two corners, if there is one.
template <class S>
[[nodiscard]] inline CoreFeature edge_between(const S& shape, std::size_t first, std::size_t second) {
  if constexpr (Faceted<S>) {
    const auto& ends = shape.facets().ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto [from, to] = ends[i];
      if ((from == first && to == second) || (from == second && to == first)) {
        return core_edge(i);
      }
    }
    return {};
  } else if constexpr (Triangular<S>) {
    return core_edge(second == (first + 1) % 3 ? first : second);
  } else if constexpr (SegmentCored<S>) {
    return core_edge(2);
  } else {
    const std::size_t across = first ^ second;
    return across != 0 && (across & (across - 1)) == 0 ? core_edge(static_cast<std::size_t>(std::countr_zero(across)))
                                                       : CoreFeature{};
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
