// SPDX-License-Identifier: Apache-2.0
// Polytopes that list their faces and edges for separating axes, four at a time.
export module abut.narrow.fan.facets;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.math.tolerance;
import abut.narrow.fan.sat;

export namespace abut {

// Polytopes with more edges than this are left to other ways. To try 1,000 takes half to three quarters as long as
// those (measured with boxes, triangles and cylinders); arrays on the stack grow with them.
inline constexpr std::size_t edge_limit = 1024;

// Faces that rounding has bent may hide others that matter.
template <Faceted S>
[[nodiscard]] inline bool has_facets(const S& shape, Real noise) {
  const auto& facets = shape.facets();
  return facets.is_closed && facets.lines.size() <= edge_limit && facets.flatness <= noise;
}

// By how much the overlap may be less than the one found, where faces are not quite flat.
template <Convex S>
[[nodiscard]] inline Real flatness_of(const S& shape) {
  if constexpr (Faceted<S>) {
    return shape.facets().flatness;
  } else {
    return 0;
  }
}

// Unit normals across pairs of edges with these products, whose squares are given, to the side of a sign. Of nearly
// parallel edges products are off by rounding of their lengths: what leads along the second one is taken out, as in
// sat.cppm.
[[nodiscard]] [[gnu::noinline, gnu::cold]] inline Columns settled_across(const Columns& n, const Columns& second) {
  const Columns across = n - (dot(n, second) / dot(second, second)) * second;
  return (1 / __builtin_elementwise_sqrt(dot(across, across))) * across;
}
[[nodiscard]] [[gnu::always_inline]] inline Columns unit_across(const Columns& first, const Columns& second,
                                                                const Columns& products, Lanes squares, Lanes signs) {
  const Columns n = (signs / __builtin_elementwise_sqrt(squares)) * products;
  const Lanes room = squares - slender_square * dot(first, first) * dot(second, second);
  if (signs_of(room) == 0) [[likely]] {
    return n;
  }
  const Columns settled = settled_across(n, second);
  const LaneNumbers is_thin = room < all_lanes(0);
  return {is_thin ? settled.x : n.x, is_thin ? settled.y : n.y, is_thin ? settled.z : n.z};
}

// A depth per lane, the least one so far, and which it was.
struct LeastDepths {
  Lanes depth = infinity;
  LaneNumbers which{0, 0, 0, 0};
  [[gnu::always_inline]] inline void consider(Lanes value, std::size_t group) {
    const LaneNumbers less = value < depth;
    depth = less ? value : depth;
    which = less ? LaneNumbers(static_cast<std::int64_t>(group)) : which;
  }
  // The lane of the least one; among equals that of the first.
  [[nodiscard]] [[gnu::always_inline]] inline std::size_t lane() const {
    const Real least = -largest(-depth);
    const LaneNumbers none = LaneNumbers(std::int64_t{1} << 62);
    const LaneNumbers places = depth == all_lanes(least) ? 4 * which + LaneNumbers{0, 1, 2, 3} : none;
    const auto pairs = places.lo < places.hi ? places.lo : places.hi;
    return static_cast<std::size_t>(pairs[0] < pairs[1] ? pairs[0] : pairs[1]) & 3u;
  }
};

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

}  // namespace abut
