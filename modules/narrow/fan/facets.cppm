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

}  // namespace abut
