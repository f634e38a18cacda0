// SPDX-License-Identifier: Apache-2.0
// The directions in which a polytope and two discs may overlap least, four at a time.
export module abut.narrow.fan.discs.disc_depth_of_polytope;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.corners;
import abut.narrow.fan.discs.disc_depth;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;

export namespace abut {

// Four faces: how deep the discs are behind each, and their point that is furthest along its normal.
struct FourDepths {
  Lanes depth;
  Columns foot;
};
template <class Planes>
[[nodiscard]] [[gnu::always_inline]] inline FourDepths depths_behind(const Planes& planes, const PlacedDiscs& discs) {
  const Columns normal{planes.x, planes.y, planes.z}, axis = Columns::all(discs.axis), x = Columns::all(discs.x),
                                                      y = Columns::all(discs.y), centre = Columns::all(discs.centre);
  const Lanes up = dot(normal, axis), out_x = dot(normal, x), out_y = dot(normal, y);
  const Lanes out = __builtin_elementwise_sqrt(out_x * out_x + out_y * out_y);
  const Lanes first = discs.height[0] * up + discs.radius[0] * out,
              second = discs.height[1] * up + discs.radius[1] * out;
  const LaneNumbers is_first = first > second, is_aside = out > all_lanes(least_aside);
  const Lanes height = is_first ? all_lanes(discs.height[0]) : all_lanes(discs.height[1]);
  const Lanes radius = is_first ? all_lanes(discs.radius[0]) : all_lanes(discs.radius[1]);
  const Lanes per_aside = is_aside ? radius / out : all_lanes(0);
  return {planes.reach + dot(normal, centre) + (is_first ? first : second),
          centre + height * axis + (per_aside * out_x) * x + (per_aside * out_y) * y};
}

// Offers the normals of all faces. `feet`: of each face, the point of the discs that is furthest along its normal.
template <class S, class Planes>
[[gnu::always_inline]] inline void search_faces(const S& shape, const Planes& planes,
                                                std::array<Lanes, edge_limit>& feet, DiscDepth& least) {
  [[clang::uninitialized]] std::array<Lanes, edge_limit / 4> depths;
  Lanes lowest = infinity;
  std::size_t group = 0, face = 0;
  for (const auto& four : planes) {
    const auto [depth, foot] = depths_behind(four, least.discs());
    depths[group++] = depth;
    lowest = minimum(lowest, depth);
    for (std::size_t i = 0; i < 4; ++i) {
      feet[face++] = lanes_of(foot[i]);
    }
  }
  // The first one of those that rounding cannot tell apart, so that it does not choose.
  const Lanes limit = -largest(-lowest) + least.noise();
  for (std::size_t i = 0; i < group; ++i) {
    if (const std::uint64_t lanes = bits_of(depths[i] <= limit); lanes != 0) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      least.offer(depths[i][lane], face_normal(shape, 4 * i + lane), {core_face(4 * i + lane), {}});
      return;
    }
  }
}

// Offers the normals of the side toward four corners. `middle`, `inner`: a ball inside the polytope; only a corner that
// reaches further along the normal counts.
template <class S>
[[gnu::always_inline]] inline void search_corners(const S& shape, const Columns& corners, const Vec3& middle,
                                                  Real inner, DiscDepth& least) {
  const PlacedDiscs& discs = least.discs();
  const Columns axis = Columns::all(discs.axis), x = Columns::all(discs.x), y = Columns::all(discs.y);
  const Columns p = corners + Columns::all(discs.centre), from_middle = corners - Columns::all(middle);
  const Real side = discs.side();
  const Lanes up = dot(p, axis), out_x = dot(p, x), out_y = dot(p, y);
  const Lanes square = out_x * out_x + out_y * out_y, spare = (side - least.depth()) + discs.side_up * up;
  const Lanes room = spare * absolute(spare) - (discs.side_out * discs.side_out) * square;
  const Lanes length = __builtin_elementwise_sqrt(square), forward = dot(from_middle, axis);
  const Lanes outward = out_x * dot(from_middle, x) + out_y * dot(from_middle, y);
  const Lanes short_of = inner * length + discs.side_out * outward - discs.side_up * length * forward;
  for (std::uint64_t lanes = signs_of(room) & ~signs_of(-short_of); lanes != 0; lanes &= lanes - 1) {
    const Vec3 u = normal_of_side(discs, p[static_cast<std::size_t>(std::countr_zero(lanes))]);
    least.offer(dot(shape.support(u).point + discs.centre, u) + side, u);
  }
}

// Offers the directions of all faces, corners and edges.
template <class S>
  requires Faceted<S> || is_seen<S>
void search_polytope(const S& shape, DiscDepth& least) {
  const PlacedDiscs& discs = least.discs();
  const auto& own = corners_of(shape);
  [[clang::uninitialized]] std::array<Lanes, edge_limit> feet;
  search_faces(shape, own.planes, feet, least);

  const Real top = std::fmax(discs.height[0], discs.height[1]);
  const auto offer_end = [&](const Vec3& end, std::size_t number) {
    least.offer(dot(shape.support(end).point + discs.centre, end) + top, end, {{}, core_face(number)});
  };
  offer_end(discs.axis, face_along_axis);
  offer_end(-discs.axis, face_against_axis);

  const std::size_t corner_count = own.points.size(), count = edge_count(shape);
  const auto corner_at = [&](std::size_t i) { return own.points[i < corner_count ? i : corner_count - 1]; };
  for (std::size_t i = 0; i < corner_count; i += 4) {
    const Columns four = Columns::of(corner_at(i), corner_at(i + 1), corner_at(i + 2), corner_at(i + 3));
    search_corners(shape, four, own.middle, own.inner, least);
  }

  // Between the directions of both faces of an edge nothing is less than the distance of the line through their feet:
  // what lies between the feet belongs to the difference.
  for (std::size_t first = 0; first < count; first += 4) {
    const auto at = [&](std::size_t i) { return edge_at(shape, own, first + i < count ? first + i : count - 1); };
    const std::array<SeenEdge, 4> edges{at(0), at(1), at(2), at(3)};
    const Columns from = Columns::of(edges[0].from, edges[1].from, edges[2].from, edges[3].from);
    const Columns along = Columns::of(edges[0].along, edges[1].along, edges[2].along, edges[3].along);
    const Columns left =
        Columns::of(feet[edges[0].left], feet[edges[1].left], feet[edges[2].left], feet[edges[3].left]);
    const Columns right =
        Columns::of(feet[edges[0].right], feet[edges[1].right], feet[edges[2].right], feet[edges[3].right]);
    const Columns chord = right - left, across = cross(chord, along);
    const Lanes reach = dot(along, cross(from + left, chord)), goal = all_lanes(least.goal() * least.goal());
    std::uint64_t lanes = signs_of(reach) | bits_of(reach * reach < goal * dot(across, across));
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      const SeenEdge edge = at(lane);
      if (first + lane < count) {
        search_edge({vec3_of(edge.from), vec3_of(edge.along), face_normal(shape, edge.left),
                     face_normal(shape, edge.right), left[lane], right[lane], edge_feature<S>(first + lane)},
                    least);
      }
    }
  }
}

}  // namespace abut
