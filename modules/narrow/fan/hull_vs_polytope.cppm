// SPDX-License-Identifier: Apache-2.0
// Least overlap of a polytope that lists its faces and edges with another one, a box, a triangle, a segment or a
// point. It tries the faces of both. The normals of an edge of the first form an arc on the Gauss sphere (Gregorius,
// "The separating axis test between convex polyhedra", GDC 2013). The search walks along it from corner to corner of
// the other one, so pairs of edges need not be tried. Bounds pass over most faces and edges.
export module abut.narrow.fan.hull_vs_polytope;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.corners;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;
import abut.narrow.fan.sat;

export namespace abut {

// Two polytopes with more vertices than this are left to the expanding polytope, which looks at few of them (measured).
inline constexpr std::size_t vertex_limit_of_two = 64;

// Euler's formula bounds faces and edges by vertices, and both by edges.
template <Faceted S>
[[nodiscard]] inline bool has_few_vertices(const S& shape) {
  const auto& facets = shape.facets();
  return facets.points.size() <= vertex_limit_of_two && facets.planes.size() <= vertex_limit_of_two / 2 &&
         facets.lines.size() <= 3 * vertex_limit_of_two;
}
// How many vertices a polytope can have that is tried against another core.
template <class Other>
inline constexpr std::size_t vertex_capacity = Faceted<Other> ? vertex_limit_of_two : 2 * edge_limit / 3 + 2;
// The corners of the other core, `own` in its own frame, from where a polytope is.
template <class Other, class Own>
[[nodiscard]] [[gnu::always_inline]] inline auto seen_from(const Other& other, const Own& own, const Pose& pose) {
  if constexpr (Faceted<Other>) {
    return SeenCorners<vertex_limit_of_two>(own.points, pose);
  } else if constexpr (BoxCored<Other> && !PointCored<Other> && !SegmentCored<Other>) {
    return SeenBox(own.points, other.half(), pose);
  } else {
    return SeenCorners<std::tuple_size_v<decltype(own.points)>>(own.points, pose);
  }
}

// The least overlap along the faces of a core that has few: the polytope tells its vertex for each. `own`: the corners
// and planes of the core.
template <Faceted A, class B, class Own>
[[nodiscard]] inline SatResult along_few_faces(const A& a, const B& b, const Own& own, const Pose& ab) {
  constexpr std::size_t face_count = Triangular<B> ? 2 : 6;
  SatResult best{-infinity, {0, 0, 0}, 0, {}};
  for (std::size_t face = 0; face < face_count; ++face) {
    const Vec3 n = ab.rotation * face_normal(b, face);
    const Real reach = own.planes[face / 4].reach[face % 4] + dot(n, ab.position);
    const Real separation = dot(n, a.support(-n).point) - reach;
    if (separation > best.separation) {
      best = {separation, -n, 0, {{}, core_face(face)}};
    }
  }
  return best;
}

// The arc of an edge of a polytope leads from its left face to its right one. The deepest vertex of the other core
// changes on the way. Where both are equally deep no other vertex is less deep: this bounds the overlap from below.
// Where another one is deeper, the arc is cut there. A stretch is a part of an arc between two such vertices.
struct ArcStretch {
  std::uint16_t line, from, to;
};
template <class Other>
inline constexpr std::size_t stretch_limit = 6 * vertex_limit_of_two + (Faceted<Other> ? 0 : edge_limit);
template <class Other>
struct ArcStretches {
  std::array<ArcStretch, stretch_limit<Other>> all;
  std::size_t count;

  // Both parts of a stretch that another vertex cuts. False where there is no room for them.
  [[nodiscard]] [[gnu::always_inline]] inline bool add_parts(const ArcStretch& of, std::uint16_t vertex) {
    if (count + 2 > all.size()) {
      return false;
    }
    all[count++] = {of.line, of.from, vertex};
    all[count++] = {of.line, vertex, of.to};
    return true;
  }
};

// A bit for each of four arcs that may lead past a lesser overlap. None does where the edge lies higher than `needed`
// over the middle of b along the normals of both ends: a height that is positive there falls below neither in between.
template <class B, class Arcs, class SeenB>
[[nodiscard]] [[gnu::always_inline]] inline std::uint64_t open_arcs(const Arcs& arcs, const SeenB& of_b,
                                                                    const Vec3& middle, Real needed) {
  const Columns out = Columns{arcs.from_x, arcs.from_y, arcs.from_z} - Columns::all(middle);
  const Columns left{arcs.left_x, arcs.left_y, arcs.left_z}, right{arcs.right_x, arcs.right_y, arcs.right_z};
  std::uint64_t open = signs_of(minimum(dot(left, out), dot(right, out)) - all_lanes(needed));
  if constexpr (SegmentCored<B>) {
    // Only from one side of a segment to the other does an arc lead from one end to the other.
    const Columns along = Columns::all(vec3_of(of_b.points[1] - of_b.points[0]));
    open &= signs_of(dot(left, along)) ^ signs_of(dot(right, along));
  }
  return open;
}

// The whole arcs on which the deepest vertex changes.
template <class B, Faceted A, class SeenB, class Faces>
[[gnu::always_inline]] inline void find_stretches(const A& a, const SeenB& of_b, const Vec3& middle_of_b, Real needed,
                                                  Faces& faces_of_a, ArcStretches<B>& out) {
  const auto& facets = a.facets();
  out.count = 0;
  for (std::size_t first = 0; first < facets.arcs.size(); first += 16) {
    const std::size_t last = first + 16 < facets.arcs.size() ? first + 16 : facets.arcs.size();
    std::uint64_t open = 0;
    for (std::size_t at = first; at < last; ++at) {
      open |= open_arcs<B>(facets.arcs[at], of_b, middle_of_b, needed) << (4 * (at - first));
    }
    for (; open != 0; open &= open - 1) {
      const std::size_t line = 4 * first + static_cast<std::size_t>(std::countr_zero(open));
      if (line >= facets.sides.size()) {
        break;
      }
      const auto& sides = facets.sides[line];
      for (const std::uint32_t side : {sides.left, sides.right}) {
        if (!faces_of_a.is_known[side / 4]) {
          faces_of_a.template look<true>(facets.planes[side / 4], side / 4, of_b, infinity);
        }
      }
      const auto from = static_cast<std::uint16_t>(faces_of_a.under[sides.left / 4][sides.left % 4]);
      const auto to = static_cast<std::uint16_t>(faces_of_a.under[sides.right / 4][sides.right % 4]);
      out.all[out.count] = {static_cast<std::uint16_t>(line), from, to};
      out.count += from != to ? 1 : 0;
    }
  }
}

// The normals across the edges of four stretches and the edges of b between their vertices.
struct FourAcross {
  Columns n{};
  Lanes reach;  // of a along each normal
  Lanes lower;  // the depth at which both vertices of a stretch lie
  Lanes above;  // what this has more than the least depth so far; nothing where the vertices are one for the arc

  template <Faceted A, class SeenB>
  [[gnu::always_inline]] inline FourAcross(const A& a, const SeenB& of_b, const std::array<ArcStretch, 4>& taken,
                                           Real least) {
    const auto line_of = [&](std::size_t i) -> const auto& { return a.facets().lines[taken[i].line]; };
    const auto from_of = [&](std::size_t i) { return of_b.points[taken[i].from]; };
    const auto to_of = [&](std::size_t i) { return of_b.points[taken[i].to]; };
    const Columns start = Columns::of(line_of(0).from, line_of(1).from, line_of(2).from, line_of(3).from);
    const Columns along = Columns::of(line_of(0).along, line_of(1).along, line_of(2).along, line_of(3).along);
    const Columns from = Columns::of(from_of(0), from_of(1), from_of(2), from_of(3));
    const Columns back = from - Columns::of(to_of(0), to_of(1), to_of(2), to_of(3));
    const Columns across = cross(back, along);
    const Lanes square = dot(across, across);
    n = unit_across(back, along, across, square, all_lanes(1));
    reach = dot(n, start) + maximum(dot(n, along), all_lanes(0));
    lower = reach - dot(n, from);
    // Vertices that lie behind each other along the edge are one for its arc.
    above = square > parallel_square * dot(along, along) * dot(back, back) ? lower - all_lanes(least) : all_lanes(0);
  }
};

// The least depth along normals across edges so far, and the stretch of the edge.
struct LeastEdge {
  Real depth;
  std::optional<ArcStretch> edge;

  [[gnu::always_inline]] inline void take(const Vec3& normal, Real found, const ArcStretch& stretch, bool is_cut,
                                          Real noise, SatResult& best) {
    if (found < depth) {
      // Of a stretch that is cut the vertices need not share an edge. An edge at no greater depth lies on one of its
      // parts: it must not be passed over as no less deep.
      depth = is_cut ? std::fmin(depth, found + noise) : found;
      best.separation = -found;
      best.normal = normal;
      best.features = {};
      edge = is_cut ? std::nullopt : std::optional(stretch);
    }
  }
};

// Takes the least overlap along normals across edges, where it beats that of faces. False where rounding cuts arcs
// without end.
template <Faceted A, class B, class SeenB>
[[nodiscard]] [[gnu::always_inline]] inline bool search_stretches(const A& a, const B& b, const SeenB& of_b, Real noise,
                                                                  ArcStretches<B>& stretches, SatResult& best) {
  // A normal across edges must beat those of faces by more than the noise.
  LeastEdge least{-best.separation - noise, std::nullopt};
  std::size_t& count = stretches.count;
  while (count > 0) {
    std::array<ArcStretch, 4> taken{};
    const std::size_t in_hand = count < 4 ? count : 4;
    for (std::size_t i = 0; i < 4; ++i) {
      taken[i] = stretches.all[count - 1 - (i < in_hand ? i : 0)];
    }
    count -= in_hand;
    const FourAcross four(a, of_b, taken, least.depth);
    if (signs_of(four.above) == 0) {
      continue;
    }
    best.axes += 4;
    const auto found = of_b.least(four.n);
    const Lanes depth = four.reach - found.value;
    for (std::size_t i = 0; i < in_hand; ++i) {
      if (!(four.above[i] < 0)) {
        continue;
      }
      const auto vertex = static_cast<std::uint16_t>(found.corner[i]);
      const bool is_cut = depth[i] > four.lower[i] + noise && vertex != taken[i].from && vertex != taken[i].to;
      least.take(four.n[i], depth[i], taken[i], is_cut, noise, best);
      if (is_cut && !stretches.add_parts(taken[i], vertex)) {
        return false;
      }
    }
  }
  if (const CoreFeature edge_of_b = least.edge ? edge_between(b, least.edge->from, least.edge->to) : CoreFeature{};
      edge_of_b.kind == CoreFeature::Kind::edge) {
    best.features = {core_edge(least.edge->line), edge_of_b};
  }
  return true;
}

// From a to b, in the frame of a. Nothing where rounding cuts arcs without end. `enough`: a face that parts both by
// more ends the search.
template <Faceted A, class B>
  requires Faceted<B> || is_seen<B>
[[nodiscard]] std::optional<SatResult> sat_of_polytopes(const A& a, const B& b, const Pose& ab, Real noise,
                                                        Real enough = infinity) {
  constexpr std::size_t capacity = vertex_capacity<B>, group_limit = capacity / 2;
  const auto& own_of_b = corners_of(b);
  SatResult best{-infinity, {0, 0, 0}, 0, {}};
  if constexpr (!Faceted<B>) {
    if (has_planes(b)) {
      best = along_few_faces(a, b, own_of_b, ab);
      if (best.separation > enough) {
        return best;
      }
    }
  }
  // Of faces that are equally deep, those of a come first.
  const auto take_face = [&](const LeastDepths& faces, CoreFeature CoreFeatures::* of, bool wins_ties,
                             const auto& out) {
    const std::size_t lane = faces.lane(), face = 4 * static_cast<std::size_t>(faces.which[lane]) + lane;
    const Real separation = -faces.depth[lane];
    if (separation > best.separation || (wins_ties && separation == best.separation)) {
      best.separation = separation;
      best.normal = out(face);
      best.features = {};
      best.features.*of = core_face(face);
    }
  };
  // Rounding must not make the balls larger than they are.
  constexpr Real shrunk = 0.999;
  [[clang::uninitialized]] const auto of_b = seen_from(b, own_of_b, ab);
  const Vec3 middle_of_b = ab * own_of_b.middle;
  const Real inner_of_b = shrunk * own_of_b.inner;
  [[clang::uninitialized]] FaceSearch<group_limit> faces_of_a;
  faces_of_a.template search<true>(a.facets().planes, of_b, middle_of_b, inner_of_b, infinity);
  take_face(faces_of_a.faces, &CoreFeatures::a, true, [&](std::size_t face) { return face_normal(a, face); });
  if constexpr (Faceted<B>) {
    if (best.separation > enough) {
      return best;
    }
    [[clang::uninitialized]] const SeenCorners<capacity> of_a(a.facets().points, ab.inverse());
    [[clang::uninitialized]] FaceSearch<group_limit> faces_of_b;
    faces_of_b.template search<false>(own_of_b.planes, of_a, ab.undo(a.facets().middle), shrunk * a.facets().inner,
                                      -best.separation);
    take_face(faces_of_b.faces, &CoreFeatures::b, false,
              [&](std::size_t face) { return -(ab.rotation * face_normal(b, face)); });
  }
  const std::size_t planes = a.facets().planes.size() + (has_planes(b) ? own_of_b.planes.size() : 0);
  best.axes = static_cast<std::uint32_t>(4 * planes);
  if (PointCored<B> || best.separation > enough) {
    return best;  // a point has no edges
  }
  // Heights of rounding at both ends of half a circle say nothing of its middle.
  const Real needed = std::fmax(noise, -best.separation - inner_of_b);
  [[clang::uninitialized]] ArcStretches<B> stretches;
  find_stretches<B>(a, of_b, middle_of_b, needed, faces_of_a, stretches);
  return search_stretches(a, b, of_b, noise, stretches, best) ? std::optional(best) : std::nullopt;
}

}  // namespace abut
