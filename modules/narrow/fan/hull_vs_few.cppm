// Least overlap of a polytope with a core of few faces, by all axes that can be a face normal of their Minkowski
// difference: the normals of both, and the cross products of those edges whose arcs on the Gauss sphere meet
// (Gregorius, "The separating axis test between convex polyhedra", GDC 2013). Four axes at a time.
export module abut.narrow.fan.hull_vs_few;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;
import abut.narrow.fan.sat;

export namespace abut {

// What can be seen from a polytope.
template <class S>
concept Seen = FewFaced<S> && (BoxCored<S> || Triangular<S>);

// A box, a segment or a point in the frame of a polytope.
template <std::size_t count>
struct SeenBox {
  Vec3 centre;
  std::array<Vec3, count> arms;   // from the centre to the ends
  std::array<Vec3, count> edges;  // unit, or zero where there is none
  static constexpr std::size_t normal_count = count == 3 ? 3 : 0;
  std::array<Vec3, normal_count> normals;

  // How near it comes from far away along each direction.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes least(const Columns& n) const {
    Lanes value = dot(n, Columns::all(centre));
    for (const Vec3& arm : arms) {
      value -= absolute(dot(n, Columns::all(arm)));
    }
    return value;
  }
  // Whether an edge along this direction comes as near: of those that are parallel one always does.
  [[nodiscard]] [[gnu::always_inline]] inline bool leads(std::size_t, const Vec3&, Real) const { return true; }
  static constexpr std::size_t first_edge = count == 1 ? 2 : 0;  // the number of the first one
};

struct SeenTriangle {
  std::array<Vec3, 3> corners;
  std::array<Vec3, 3> edges;
  std::array<Vec3, 1> normals;

  [[nodiscard]] [[gnu::always_inline]] inline Lanes least(const Columns& n) const {
    return minimum(minimum(dot(n, Columns::all(corners[0])), dot(n, Columns::all(corners[1]))),
                   dot(n, Columns::all(corners[2])));
  }
  // Whether an edge comes as near.
  [[nodiscard]] [[gnu::always_inline]] inline bool leads(std::size_t edge, const Vec3& n, Real noise) const {
    const Real at = dot(n, corners[edge]), opposite = dot(n, corners[edge == 0 ? 2 : edge - 1]);
    return at <= opposite + noise;
  }
  static constexpr std::size_t first_edge = 0;
};

template <Seen S>
[[nodiscard]] [[gnu::always_inline]] inline auto seen_from(const S& shape, const Pose& pose) {
  const Rotation& r = pose.rotation;
  if constexpr (BoxCored<S>) {
    constexpr std::size_t count = S::core_axes;
    SeenBox<count> box{};
    box.centre = pose.position;
    const Vec3 half = shape.half();
    if constexpr (count == 3) {
      box.arms = {half.x * r.x, half.y * r.y, half.z * r.z};
      box.edges = {half.x > 0 ? r.x : Vec3{0, 0, 0}, half.y > 0 ? r.y : Vec3{0, 0, 0},
                   half.z > 0 ? r.z : Vec3{0, 0, 0}};
      box.normals = {r.x, r.y, r.z};
    } else if constexpr (count == 1) {
      box.arms = {half.z * r.z};
      box.edges = {half.z > 0 ? r.z : Vec3{0, 0, 0}};
    }
    return box;
  } else {
    SeenTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = pose * shape.corners()[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto edge = UnitVec3::make(triangle.corners[i == 2 ? 0 : i + 1] - triangle.corners[i]);
      triangle.edges[i] = edge ? edge->vec() : Vec3{0, 0, 0};
    }
    triangle.normals = {r * shape.normal()};
    return triangle;
  }
}

// In the frame of the hull, which is a; the normal points out of it.
template <Faceted H, class Core>
[[nodiscard]] SatResult sat_of_hull(const H& hull, const Core& core, Real noise) {
  const auto& facets = hull.facets();
  constexpr std::size_t edge_count = std::tuple_size_v<decltype(core.edges)>;
  SatResult best{-infinity, {0, 0, 0}, 0, {}};
  const auto consider = [&](Real depth, const Vec3& normal, const CoreFeatures& features) {
    if (-depth > best.separation) {
      best.separation = -depth;
      best.normal = normal;
      best.features = features;
    }
  };

  LeastDepths faces;
  std::size_t group = 0;
  for (const auto& planes : facets.planes) {
    faces.consider(planes.reach - core.least({planes.x, planes.y, planes.z}), group++);
  }
  best.axes = static_cast<std::uint32_t>(4 * group);
  const std::size_t lane = faces.lane();
  const auto four = static_cast<std::size_t>(faces.which[lane]);
  const auto& planes = facets.planes[four];
  consider(faces.depth[lane], {planes.x[lane], planes.y[lane], planes.z[lane]}, {core_face(4 * four + lane), {}});

  std::size_t face = 0;
  for (const Vec3& normal : core.normals) {
    const Columns n = Columns::all(normal);
    Lanes high = -infinity, low = infinity;
    for (const auto& block : hull.vertex_blocks()) {
      const Lanes along = dot(n, {block.x, block.y, block.z});
      high = maximum(high, along);
      low = minimum(low, along);
    }
    if (squared_norm(normal) > 0) {
      best.axes += 2;
      consider(largest(high) - core.least(n)[0], normal, {{}, core_face(face)});
      consider(largest(-low) - core.least(Columns::all(-normal))[0], -normal, {{}, core_face(face + 1)});
    }
    face += 2;
  }

  if constexpr (edge_count > 0) {
    // Edges of the hull between a face that an edge of the core leads into and one that it does not: their arcs
    // cross the circle of the normals that are across that edge.
    struct Candidate {
      std::uint16_t line, edge;
      std::int32_t inward;  // into the left face
    };
    [[clang::uninitialized]] std::array<Candidate, edge_count * edge_limit + 4> candidates;
    std::size_t count = 0;
    // One bit per edge, 64 at a time.
    constexpr std::size_t groups = 16;
    for (std::size_t first = 0; first < facets.arcs.size(); first += groups) {
      const std::size_t last = first + groups < facets.arcs.size() ? first + groups : facets.arcs.size();
      std::array<std::uint64_t, edge_count> inward{}, inward_of_right{};
      for (std::size_t at = first; at < last; ++at) {
        const auto& arcs = facets.arcs[at];
        const Columns left{arcs.left_x, arcs.left_y, arcs.left_z}, right{arcs.right_x, arcs.right_y, arcs.right_z};
        for (std::size_t i = 0; i < edge_count; ++i) {
          const Columns edge = Columns::all(core.edges[i]);
          inward[i] |= signs_of(dot(left, edge)) << (4 * (at - first));
          inward_of_right[i] |= signs_of(dot(right, edge)) << (4 * (at - first));
        }
      }
      for (std::size_t i = 0; i < edge_count; ++i) {
        for (std::uint64_t differ = inward[i] ^ inward_of_right[i]; differ != 0; differ &= differ - 1) {
          const auto at = static_cast<std::size_t>(std::countr_zero(differ));
          candidates[count++] = {static_cast<std::uint16_t>(4 * first + at), static_cast<std::uint16_t>(i),
                                 static_cast<std::int32_t>(inward[i] >> at & 1u)};
        }
      }
    }
    if (count > 0) {
      for (std::size_t i = count; i % 4 != 0; ++i) {
        candidates[i] = candidates[count - 1];
      }
      std::array<Lanes, edge_count> edges;
      for (std::size_t i = 0; i < edge_count; ++i) {
        edges[i] = lanes_of(core.edges[i]);
      }
      const auto normals_of = [&](std::size_t first, Columns& from, Columns& along, Lanes& square) {
        const Candidate &p = candidates[first], &q = candidates[first + 1];
        const Candidate &r = candidates[first + 2], &s = candidates[first + 3];
        const auto &on_p = facets.lines[p.line], &on_q = facets.lines[q.line];
        const auto &on_r = facets.lines[r.line], &on_s = facets.lines[s.line];
        from = Columns::of(on_p.from, on_q.from, on_r.from, on_s.from);
        along = Columns::of(on_p.along, on_q.along, on_r.along, on_s.along);
        const Columns edge = Columns::of(edges[p.edge], edges[q.edge], edges[r.edge], edges[s.edge]);
        const Columns across = cross(edge, along);
        square = dot(across, across);
        // Out of the hull: from the left face the arc turns to the right one.
        const LaneNumbers in{p.inward, q.inward, r.inward, s.inward};
        return unit_across(edge, along, across, square, in != 0 ? all_lanes(1) : all_lanes(-1));
      };
      LeastDepths of_edges;
      for (std::size_t first = 0; first < count; first += 4) {
        [[clang::uninitialized]] Columns from, along;
        [[clang::uninitialized]] Lanes square;
        const Columns n = normals_of(first, from, along, square);
        const Lanes depth = dot(n, from) + maximum(dot(n, along), all_lanes(0)) - core.least(n);
        // Edges closer to parallel than rounding span no face. Leaving one out errs by at most the angle times the
        // length of an edge, which is rounding again.
        of_edges.consider(square > 1e-28 * dot(along, along) ? depth : all_lanes(infinity), first);
      }
      best.axes += static_cast<std::uint32_t>(count);
      const std::size_t at = of_edges.lane();
      const auto first = static_cast<std::size_t>(of_edges.which[at]);
      if (-of_edges.depth[at] > best.separation + noise) {
        [[clang::uninitialized]] Columns from, along;
        [[clang::uninitialized]] Lanes square;
        const Columns n = normals_of(first, from, along, square);
        const Candidate& found = candidates[first + at];
        const CoreFeatures pair{core_edge(found.line), core_edge(Core::first_edge + found.edge)};
        consider(of_edges.depth[at], n[at], core.leads(found.edge, n[at], noise) ? pair : CoreFeatures{});
      }
    }
  }
  return best;
}

}  // namespace abut
