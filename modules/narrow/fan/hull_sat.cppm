// SPDX-License-Identifier: Apache-2.0
// Least overlap of two cores of which one is a polytope that lists its faces and edges, by separating axes.
export module abut.narrow.fan.hull_sat;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
export import abut.narrow.fan.facets;
export import abut.narrow.fan.features;
export import abut.narrow.fan.corners;
import abut.narrow.fan.hull_vs_polytope;
import abut.narrow.fan.sat;

export namespace abut {

template <class A, class B>
inline constexpr bool has_hull = (Faceted<A> && (is_seen<B> || Faceted<B>)) || (is_seen<A> && Faceted<B>);

// The same from a to b, in the frame of a. Nothing where there are too many axes. The separation is that of the
// features found: no more than the cores have along the normal. `enough`: faces that part both by more end the search.
template <Convex A, Convex B>
  requires has_hull<A, B>
[[nodiscard]] std::optional<SatResult> hull_sat(const A& a, const B& b, const Pose& ab, Real noise,
                                                Real enough = infinity) {
  if constexpr (Faceted<A> && Faceted<B>) {
    const bool few = has_few_vertices(a) && has_few_vertices(b) && has_facets(a, noise) && has_facets(b, noise);
    return few ? sat_of_polytopes(a, b, ab, noise, enough) : std::nullopt;
  } else if constexpr (Faceted<A>) {
    return has_facets(a, noise) ? sat_of_polytopes(a, b, ab, noise, enough) : std::nullopt;
  } else {
    std::optional<SatResult> found = hull_sat(b, a, ab.inverse(), noise, enough);
    if (found) {
      found->normal = -(ab.rotation * found->normal);
      found->features = {found->features.b, found->features.a};
    }
    return found;
  }
}

// The faces of a thin polytope hardly tell where it ends beside them: a point that is off by d is above their planes
// by about d times the share of the thickness in the extent. Below this share rounding counts for 1e-9 of the extent.
inline constexpr Real least_thickness = 1e-6;
// How far a point lies outside of a polytope along the normal of a face, negative inside.
// Infinite where the faces cannot tell.
template <Faceted S>
[[nodiscard]] inline Real outside_facets(const S& shape, const Vec3& point) {
  if (!shape.facets().is_closed || !(shape.facets().inner > least_thickness * shape.extent())) {
    return infinity;
  }
  Lanes room = infinity;
  for (const auto& planes : shape.facets().planes) {
    room = minimum(room, planes.reach - dot({planes.x, planes.y, planes.z}, Columns::all(point)));
  }
  return largest(-room);
}

// Whether a point is no further than some slack from the edges of a triangle.
[[nodiscard]] inline bool is_on_edges(const std::array<Vec3, 3>& corners, const Vec3& point, Real slack) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = corners[i == 2 ? 0 : i + 1] - corners[i], way = point - corners[i];
    const Real square = squared_norm(edge), along = dot(way, edge);
    const Real t = along > 0 ? (along < square ? along / square : 1) : 0;
    if (squared_norm(way - t * edge) <= slack * slack) {
      return true;
    }
  }
  return false;
}

// Whether a point of its own frame surely lies in a core, up to some slack. Hulls without volume, or nearly, have
// no faces on their sides that could tell, and triangles tell of their edges alone.
template <Convex S>
  requires Faceted<S> || is_seen<S>
[[nodiscard]] inline bool holds(const S& shape, const Vec3& point, Real slack) {
  if constexpr (Faceted<S>) {
    return outside_facets(shape, point) <= slack;
  } else if constexpr (BoxCored<S>) {
    const Vec3 out = absolute(point) - shape.half();
    return out.x <= slack && out.y <= slack && out.z <= slack;
  } else {
    return is_on_edges(shape.corners(), point, slack);
  }
}

}  // namespace abut
