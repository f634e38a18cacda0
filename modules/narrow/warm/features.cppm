// The features of two cores that a normal across their least overlap belongs to: found from the normal once, and from
// then on the normal follows from the features and the pose, with the same operations as in the search and hence with
// the same bits.
export module abut.narrow.warm.features;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.hull_vs_few;
export import abut.narrow.warm.pair_memory;

export namespace abut {

// A body with flat ends across Z.
template <class S>
concept FlatEnded = Curved<S> && requires(const S& shape, const Vec3& direction) {
  { shape.supporting_rim(direction)->radius } -> std::convertible_to<Real>;
  { shape.supporting_rim(direction)->height } -> std::convertible_to<Real>;
};
template <class S>
concept Edged = Faceted<S> || FlatEnded<S> || (BoxCored<S> && !PointCored<S>);

// Pairs whose least overlap mostly has features that can be named.
template <class A, class B>
concept Featured = Edged<A> && Edged<B> && !(BoxCored<A> && BoxCored<B>);

// Numbers of vertices, lines and faces have to fit in what is kept of them.
template <Edged S>
[[nodiscard]] inline bool has_features(const S& shape, Real noise) {
  if constexpr (Faceted<S>) {
    const auto& facets = shape.facets();
    return facets.is_closed && facets.flatness <= noise && facets.inner > 0 && facets.lines.size() < 0xffff;
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    return SegmentCored<S> ? half.z > 0 : half.x > 0 && half.y > 0 && half.z > 0;
  } else {
    return shape.supporting_rim({0, 0, -1}).has_value();
  }
}

inline constexpr std::uint16_t no_face = 0xffff;

// The face that looks along a direction best, everything in the frame of the shape.
template <Edged S>
[[nodiscard]] inline std::uint16_t face_along(const S& shape, const Vec3& direction) {
  if constexpr (Faceted<S>) {
    const Columns n = Columns::all(direction);
    LeastDepths faces;
    std::size_t group = 0;
    for (const auto& planes : shape.facets().planes) {
      faces.consider(-dot(n, {planes.x, planes.y, planes.z}), group++);
    }
    const std::size_t lane = faces.lane();
    return static_cast<std::uint16_t>(4 * static_cast<std::size_t>(faces.which[lane]) + lane);
  } else if constexpr (SegmentCored<S>) {
    return no_face;
  } else if constexpr (BoxCored<S>) {
    const Vec3 size = absolute(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::uint16_t>(2 * axis + (direction[axis] >= 0 ? 1 : 0));
  } else {
    return direction.z >= 0 ? 1 : 0;
  }
}
template <Edged S>
[[nodiscard]] inline Vec3 face_normal(const S& shape, std::uint16_t number) {
  if constexpr (Faceted<S>) {
    const auto& planes = shape.facets().planes[number / 4];
    return {planes.x[number % 4], planes.y[number % 4], planes.z[number % 4]};
  } else {
    const Real sign = number % 2 == 1 ? 1 : -1;
    const int axis = BoxCored<S> ? number / 2 : 2;
    return {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
  }
}

// As the searches for axes compute them: a box that is seen from a hull has its normals by a way of their own.
template <Edged A, Edged B>
[[nodiscard]] inline Vec3 normal_of_face_of_a(const A& a, const B&, const Pose& ab, std::uint16_t number) {
  if constexpr (BoxCored<A> && Faceted<B>) {
    const Rotation back = ab.rotation.inverse();
    const Vec3& column = number / 2 == 0 ? back.x : number / 2 == 1 ? back.y : back.z;
    return -(ab.rotation * (number % 2 == 1 ? -column : column));
  } else {
    return face_normal(a, number);
  }
}
template <Edged A, Edged B>
[[nodiscard]] inline Vec3 normal_of_face_of_b(const A&, const B& b, const Pose& ab, std::uint16_t number) {
  if constexpr (Faceted<A> && BoxCored<B>) {
    const Vec3& column = number / 2 == 0 ? ab.rotation.x : number / 2 == 1 ? ab.rotation.y : ab.rotation.z;
    return number % 2 == 1 ? -column : column;
  } else {
    return -(ab.rotation * face_normal(b, number));
  }
}

// The unit normal across two directions, by the operations of the searches.
[[nodiscard]] inline Vec3 unit_across(const Vec3& first, const Vec3& second, Real sign) {
  const Columns a = Columns::all(first), b = Columns::all(second), across = cross(a, b);
  return unit_across(a, b, across, dot(across, across), all_lanes(sign))[0];
}

// The normal across an edge of each body, and the directions of both, in the frame of a.
struct CrossedEdges {
  Vec3 normal, edge_a, edge_b;
};

// Two hulls: a line of a, and the vertices of b at the ends of its edge. A hull and a box or a segment: a line of the
// hull, and an axis of the other one.
template <Edged A, Edged B>
  requires HullAndSeen<A, B>
[[nodiscard]] inline CrossedEdges crossed_edges(const A& a, const B& b, const Pose& ab, const PairFeatures& features) {
  const Rotation& r = ab.rotation;
  if constexpr (Faceted<A> && Faceted<B>) {
    const LaneMatrix turn = LaneMatrix::columns_of(r);
    const Lanes shift = lanes_of(ab.position);
    const auto placed = [&](std::uint16_t number) { return turn.apply(b.facets().points[number], shift); };
    const Vec3 along = vec3_of(a.facets().lines[features.numbers[0]].along);
    const Vec3 back = vec3_of(placed(features.numbers[1]) - placed(features.numbers[2]));
    return {unit_across(back, along, 1), along, back};
  } else if constexpr (Faceted<A>) {
    const Vec3 along = vec3_of(a.facets().lines[features.numbers[0]].along);
    const Vec3& edge = features.numbers[1] == 0 ? r.x : features.numbers[1] == 1 ? r.y : r.z;
    return {unit_across(edge, along, features.side == 1 ? 1 : -1), along, edge};
  } else {
    const CrossedEdges seen = crossed_edges(b, a, ab.inverse(), features);
    return {-(r * seen.normal), r * seen.edge_b, r * seen.edge_a};
  }
}

// With a round body: its side along Z, a line of a hull or an axis of a box or segment.
template <Edged S>
[[nodiscard]] inline Vec3 edge_direction(const S& shape, std::uint16_t number) {
  if constexpr (Faceted<S>) {
    return vec3_of(shape.facets().lines[number].along);
  } else {
    const int axis = BoxCored<S> ? number : 2;
    return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  }
}
template <Edged A, Edged B>
  requires(FlatEnded<A> || FlatEnded<B>)
[[nodiscard]] inline CrossedEdges crossed_edges(const A& a, const B& b, const Pose& ab, const PairFeatures& features) {
  const Vec3 along = edge_direction(a, features.numbers[0]),
             other = ab.rotation * edge_direction(b, features.numbers[1]);
  return {unit_across(along, other, features.side == 1 ? 1 : -1), along, other};
}

// The line of a hull both ends of which lie furthest along a direction.
template <Faceted S>
[[nodiscard]] inline std::uint16_t line_along(const S& hull, const Vec3& direction) {
  Real most = -infinity;
  std::size_t found = 0;
  const Lanes n = lanes_of(direction);
  for (std::size_t i = 0; i < hull.facets().lines.size(); ++i) {
    const auto& line = hull.facets().lines[i];
    const Real height = dot(n, 2 * line.from + line.along);
    if (height > most) {
      most = height;
      found = i;
    }
  }
  return static_cast<std::uint16_t>(found);
}
// The numbers of the two vertices that lie furthest along a direction.
template <Faceted S>
[[nodiscard]] inline std::array<std::uint16_t, 2> vertices_along(const S& hull, const Vec3& direction) {
  std::array<Real, 2> most{-infinity, -infinity};
  std::array<std::uint16_t, 2> found{};
  const Lanes n = lanes_of(direction);
  for (std::size_t i = 0; i < hull.facets().points.size(); ++i) {
    const Real height = dot(n, hull.facets().points[i]);
    const std::size_t place = height > most[0] ? 0 : 1;
    if (height > most[place]) {
      most = {place == 0 ? height : most[0], place == 0 ? most[0] : height};
      found = {place == 0 ? static_cast<std::uint16_t>(i) : found[0],
               place == 0 ? found[0] : static_cast<std::uint16_t>(i)};
    }
  }
  return found;
}

// The normal of features; what belongs to edges is nothing for faces.
template <Edged A, Edged B>
[[nodiscard]] inline CrossedEdges normal_of(const A& a, const B& b, const Pose& ab, const PairFeatures& features) {
  switch (features.kind) {
    case PairFeatures::Kind::face_of_a: return {normal_of_face_of_a(a, b, ab, features.numbers[0]), {}, {}};
    case PairFeatures::Kind::face_of_b: return {normal_of_face_of_b(a, b, ab, features.numbers[0]), {}, {}};
    case PairFeatures::Kind::edges: return crossed_edges(a, b, ab, features);
    case PairFeatures::Kind::none: break;
  }
  return {};
}

// The edge of a body that is furthest out along a direction; of a box the axis that is most across it.
template <Edged S>
[[nodiscard]] inline std::uint16_t edge_along(const S& shape, const Vec3& direction) {
  if constexpr (Faceted<S>) {
    return line_along(shape, direction);
  } else if constexpr (BoxCored<S> && !SegmentCored<S>) {
    const Vec3 size = absolute(direction);
    return size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  } else {
    return 2;
  }
}

// Hands over the features that may have a normal, until one of them is taken.
template <Edged A, Edged B, class Take>
inline void offer_faces(const A& a, const B& b, const Pose& ab, const Vec3& normal, Take&& take) {
  using Kind = PairFeatures::Kind;
  const std::uint16_t of_a = face_along(a, normal), of_b = face_along(b, ab.rotation.undo(-normal));
  if (of_a != no_face && take(PairFeatures{Kind::face_of_a, 0, {of_a, 0, 0}})) {
    return;
  }
  if (of_b != no_face) {
    take(PairFeatures{Kind::face_of_b, 0, {of_b, 0, 0}});
  }
}
template <Edged A, Edged B, class Take>
inline void offer_edges(const A& a, const B& b, const Pose& ab, const Vec3& normal, Take&& take) {
  using Kind = PairFeatures::Kind;
  const Vec3 local = ab.rotation.undo(-normal);
  const std::uint16_t of_a = edge_along(a, normal);
  if constexpr (Faceted<A> && Faceted<B>) {
    const auto [first, second] = vertices_along(b, local);
    if (!take(PairFeatures{Kind::edges, 0, {of_a, first, second}})) {
      take(PairFeatures{Kind::edges, 0, {of_a, second, first}});
    }
  } else {
    const std::uint16_t of_b = edge_along(b, local);
    const bool hull_first = FlatEnded<A> || FlatEnded<B> || Faceted<A>;
    const std::uint16_t first = hull_first ? of_a : of_b, second = hull_first ? of_b : of_a;
    if (!take(PairFeatures{Kind::edges, 0, {first, second, 0}})) {
      take(PairFeatures{Kind::edges, 1, {first, second, 0}});
    }
  }
}

// The features that give a normal with exactly these bits.
template <Edged A, Edged B>
[[nodiscard]] inline PairFeatures features_of(const A& a, const B& b, const Pose& ab, const Vec3& normal) {
  PairFeatures found{};
  const auto take = [&](const PairFeatures& features) {
    const bool is_it = normal_of(a, b, ab, features).normal == normal;
    found = is_it ? features : found;
    return is_it;
  };
  offer_faces(a, b, ab, normal, take);
  if (found.kind == PairFeatures::Kind::none) {
    offer_edges(a, b, ab, normal, take);
  }
  return found;
}

}  // namespace abut
