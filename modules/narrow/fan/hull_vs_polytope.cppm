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

// The least overlap along the faces of a polytope, where other ones are the vertices of another one, which has a ball
// inside. What the ball shows to be no less than `most` is passed over.
template <std::size_t group_limit>
struct FaceSearch {
  LeastDepths faces;
  std::array<LaneNumbers, group_limit> under;  // the vertex that lies deepest under each face
  std::array<bool, group_limit> is_known;

  // The first vertices, which lie far from each other, often show that a face is no less deep than `most`.
  static constexpr std::size_t first_vertices = 8;
  template <bool with_vertices, class Planes, class Others>
  [[gnu::always_inline]] inline void look(const Planes& planes, std::size_t group, const Others& others, Real most) {
    const Columns n{planes.x, planes.y, planes.z};
    typename Others::Least least;
    if constexpr (Others::are_few) {
      others.template search<with_vertices>(n, 0, others.points.size(), least);
      faces.consider(planes.reach - least.value, group);
      under[group] = least.corner;
      is_known[group] = true;
      return;
    }
    const std::size_t some = others.count < first_vertices ? others.count : first_vertices;
    others.template search<with_vertices>(n, 0, some, least);
    if (signs_of(planes.reach - least.value - all_lanes(most)) == 0) {
      return;
    }
    others.template search<with_vertices>(n, some, others.count, least);
    faces.consider(planes.reach - least.value, group);
    if constexpr (with_vertices) {
      under[group] = least.corner;
      is_known[group] = true;
    }
  }
  template <bool with_vertices, class Planes, class Others>
  [[gnu::always_inline]] inline void search(const Planes& planes, const Others& others, const Vec3& ball, Real radius,
                                            Real most) {
    faces = {};
    if constexpr (Others::are_few) {
      std::size_t each = 0;
      for (const auto& four : planes) {
        look<with_vertices>(four, each++, others, infinity);
      }
      return;
    }
    const Columns centre = Columns::all(ball);
    [[clang::uninitialized]] std::array<Lanes, group_limit> bounds;
    LeastDepths lowest;
    std::size_t group = 0;
    for (const auto& four : planes) {
      const Lanes bound = four.reach - dot({four.x, four.y, four.z}, centre) + all_lanes(radius);
      lowest.consider(bound, group);
      is_known[group] = false;
      bounds[group++] = bound;
    }
    const auto first = static_cast<std::size_t>(lowest.which[lowest.lane()]);
    look<with_vertices>(planes[first], first, others, infinity);
    Real least = -largest(-faces.depth);
    least = least < most ? least : most;
    group = 0;
    for (const auto& four : planes) {
      if (signs_of(bounds[group] - all_lanes(least)) != 0) {
        look<with_vertices>(four, group, others, least);
        const Real found = -largest(-faces.depth);
        least = found < least ? found : least;
      }
      ++group;
    }
  }
};

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
  // The arc of an edge of a leads from its left face to its right one. The deepest vertex of b changes on the way.
  // Where both are equally deep no other vertex is less deep: this bounds the overlap from below. Where another one
  // is deeper, the arc is cut there.
  struct Stretch {
    std::uint16_t line, from, to;
  };
  constexpr std::size_t room = 6 * vertex_limit_of_two + (Faceted<B> ? 0 : edge_limit);
  [[clang::uninitialized]] std::array<Stretch, room> stretches;
  std::size_t count = 0;
  // Heights of rounding at both ends of half a circle say nothing of its middle.
  const Real needed = std::fmax(noise, -best.separation - inner_of_b);
  for (std::size_t first = 0; first < a.facets().arcs.size(); first += 16) {
    const std::size_t last = first + 16 < a.facets().arcs.size() ? first + 16 : a.facets().arcs.size();
    std::uint64_t open = 0;
    for (std::size_t at = first; at < last; ++at) {
      // Where it is positive at both ends, the height of a point falls below neither in between.
      const auto& arcs = a.facets().arcs[at];
      const Columns out = Columns{arcs.from_x, arcs.from_y, arcs.from_z} - Columns::all(middle_of_b);
      const Columns left{arcs.left_x, arcs.left_y, arcs.left_z}, right{arcs.right_x, arcs.right_y, arcs.right_z};
      std::uint64_t four = signs_of(minimum(dot(left, out), dot(right, out)) - all_lanes(needed));
      if constexpr (SegmentCored<B>) {
        // Only from one side of a segment to the other does an arc lead from one end to the other.
        const Columns along = Columns::all(vec3_of(of_b.points[1] - of_b.points[0]));
        four &= signs_of(dot(left, along)) ^ signs_of(dot(right, along));
      }
      open |= four << (4 * (at - first));
    }
    for (; open != 0; open &= open - 1) {
      const std::size_t line = 4 * first + static_cast<std::size_t>(std::countr_zero(open));
      if (line >= a.facets().sides.size()) {
        break;
      }
      const auto& sides = a.facets().sides[line];
      for (const std::uint32_t side : {sides.left, sides.right}) {
        if (!faces_of_a.is_known[side / 4]) {
          faces_of_a.template look<true>(a.facets().planes[side / 4], side / 4, of_b, infinity);
        }
      }
      const auto from = static_cast<std::uint16_t>(faces_of_a.under[sides.left / 4][sides.left % 4]);
      const auto to = static_cast<std::uint16_t>(faces_of_a.under[sides.right / 4][sides.right % 4]);
      stretches[count] = {static_cast<std::uint16_t>(line), from, to};
      count += from != to ? 1 : 0;
    }
  }
  // A normal across edges must beat those of faces by more than the noise.
  Real least_of_edges = -best.separation - noise;
  std::optional<Stretch> least;
  while (count > 0) {
    [[clang::uninitialized]] std::array<Stretch, 4> taken;
    const std::size_t in_hand = count < 4 ? count : 4;
    for (std::size_t i = 0; i < 4; ++i) {
      taken[i] = stretches[count - 1 - (i < in_hand ? i : 0)];
    }
    count -= in_hand;
    const auto line_of = [&](std::size_t i) -> const auto& { return a.facets().lines[taken[i].line]; };
    const auto from_of = [&](std::size_t i) { return of_b.points[taken[i].from]; };
    const auto to_of = [&](std::size_t i) { return of_b.points[taken[i].to]; };
    const Columns start = Columns::of(line_of(0).from, line_of(1).from, line_of(2).from, line_of(3).from);
    const Columns along = Columns::of(line_of(0).along, line_of(1).along, line_of(2).along, line_of(3).along);
    const Columns from = Columns::of(from_of(0), from_of(1), from_of(2), from_of(3));
    const Columns back = from - Columns::of(to_of(0), to_of(1), to_of(2), to_of(3));
    const Columns across = cross(back, along);
    const Lanes square = dot(across, across);
    const Columns n = unit_across(back, along, across, square, all_lanes(1));
    const Lanes reach = dot(n, start) + maximum(dot(n, along), all_lanes(0));
    const Lanes lower = reach - dot(n, from);
    // Vertices that lie behind each other along the edge are one for its arc.
    const Lanes above = square > parallel_square * dot(along, along) * dot(back, back)
                            ? lower - all_lanes(least_of_edges)
                            : all_lanes(0);
    if (signs_of(above) == 0) {
      continue;
    }
    best.axes += 4;
    const auto found = of_b.least(n);
    const Lanes depth = reach - found.value;
    for (std::size_t i = 0; i < in_hand; ++i) {
      if (!(above[i] < 0)) {
        continue;
      }
      const auto vertex = static_cast<std::uint16_t>(found.corner[i]);
      const bool is_cut = depth[i] > lower[i] + noise && vertex != taken[i].from && vertex != taken[i].to;
      if (depth[i] < least_of_edges) {
        // Of a stretch that is cut the vertices need not share an edge. An edge at no greater depth lies on one of its
        // parts: it must not be passed over as no less deep.
        least_of_edges = is_cut ? std::fmin(least_of_edges, depth[i] + noise) : depth[i];
        best.separation = -depth[i];
        best.normal = n[i];
        best.features = {};
        least = is_cut ? std::nullopt : std::optional(taken[i]);
      }
      if (is_cut) {
        if (count + 2 > room) {
          return std::nullopt;
        }
        stretches[count++] = {taken[i].line, taken[i].from, vertex};
        stretches[count++] = {taken[i].line, vertex, taken[i].to};
      }
    }
  }
  if (least) {
    const CoreFeature edge_of_b = edge_between(b, least->from, least->to);
    if (edge_of_b.kind == CoreFeature::Kind::edge) {
      best.features = {core_edge(least->line), edge_of_b};
    }
  }
  return best;
}

}  // namespace abut
