// The directions in which a polytope that lists its faces and edges may overlap least with two discs, four faces at a
// time.
export module abut.narrow.fan.disc_depth_of_hull;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.disc_depth;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;

export namespace abut {

// Offers the directions of all faces, corners and edges of a polytope that has facets (hull_sat_facets.cppm).
template <Faceted S>
void search_facets(const S& shape, DiscDepth& least) {
  const auto& facets = shape.facets();
  const PlacedDiscs& discs = least.discs();
  const Columns axis = Columns::all(discs.axis), x = Columns::all(discs.x), y = Columns::all(discs.y);
  const Columns centre = Columns::all(discs.centre);
  const auto plus = [](const Columns& a, const Columns& b) { return Columns{a.x + b.x, a.y + b.y, a.z + b.z}; };

  // Faces. Of each the point of the discs that reaches furthest.
  [[clang::uninitialized]] std::array<Lanes, edge_limit> feet;
  LeastDepths depths;
  for (std::size_t group = 0; group < facets.planes.size(); ++group) {
    const auto& plane = facets.planes[group];
    const Columns normal{plane.x, plane.y, plane.z};
    const Lanes up = dot(normal, axis), out_x = dot(normal, x), out_y = dot(normal, y);
    const Lanes out = __builtin_elementwise_sqrt(out_x * out_x + out_y * out_y);
    const Lanes first = discs.height[0] * up + discs.radius[0] * out,
                second = discs.height[1] * up + discs.radius[1] * out;
    const LaneNumbers is_first = first > second, is_aside = out > all_lanes(least_aside);
    const Lanes height = is_first ? all_lanes(discs.height[0]) : all_lanes(discs.height[1]);
    const Lanes radius = is_first ? all_lanes(discs.radius[0]) : all_lanes(discs.radius[1]);
    const Lanes per_aside = is_aside ? radius / out : all_lanes(0);
    depths.consider(plane.reach + dot(normal, centre) + (is_first ? first : second), group);
    const Columns foot = plus(plus(centre, height * axis), plus((per_aside * out_x) * x, (per_aside * out_y) * y));
    for (std::size_t i = 0; i < 4; ++i) {
      feet[4 * group + i] = lanes_of(foot[i]);
    }
  }
  const std::size_t lane = depths.lane(), group = static_cast<std::size_t>(depths.which[lane]);
  least.offer(depths.depth[lane], face_normal(shape, 4 * group + lane), {core_face(4 * group + lane), {}});

  // Ends of the discs.
  const Real top = std::fmax(discs.height[0], discs.height[1]);
  const auto offer_end = [&](const Vec3& end, std::size_t face) {
    least.offer(dot(shape.support(end).point + discs.centre, end) + top, end, {{}, core_face(face)});
  };
  offer_end(discs.axis, face_along_axis);
  offer_end(-discs.axis, face_against_axis);

  // The side against corners.
  const Real side = discs.side();
  for (const auto& block : shape.vertex_blocks()) {
    const Columns p = plus({block.x, block.y, block.z}, centre);
    const Lanes up = dot(p, axis), out_x = dot(p, x), out_y = dot(p, y);
    const Lanes square = out_x * out_x + out_y * out_y, spare = (side - least.depth()) + discs.side_up * up;
    const Lanes room = spare * absolute(spare) - (discs.side_out * discs.side_out) * square;
    // Only a corner that reaches further along the normal than the ball inside counts.
    const Columns from_middle = Columns{block.x, block.y, block.z} - Columns::all(facets.middle);
    const Lanes length = __builtin_elementwise_sqrt(square), forward = dot(from_middle, axis);
    const Lanes outward = out_x * dot(from_middle, x) + out_y * dot(from_middle, y);
    const Lanes short_of = facets.inner * length + discs.side_out * outward - discs.side_up * length * forward;
    for (std::uint64_t lanes = signs_of(room) & ~signs_of(-short_of); lanes != 0; lanes &= lanes - 1) {
      const Vec3 u = normal_of_side(discs, p[static_cast<std::size_t>(std::countr_zero(lanes))]);
      least.offer(dot(shape.support(u).point + discs.centre, u) + side, u);
    }
  }

  // Edges, four at a time.
  const std::size_t count = facets.lines.size();
  const auto edge_at = [&](std::size_t i) { return i < count ? i : count - 1; };
  for (std::size_t first = 0; first < count; first += 4) {
    const std::array<std::size_t, 4> edges{first, edge_at(first + 1), edge_at(first + 2), edge_at(first + 3)};
    const auto left_of = [&](std::size_t i) { return feet[facets.sides[edges[i]].left]; };
    const auto right_of = [&](std::size_t i) { return feet[facets.sides[edges[i]].right]; };
    const auto from_of = [&](std::size_t i) { return facets.lines[edges[i]].from; };
    const auto along_of = [&](std::size_t i) { return facets.lines[edges[i]].along; };
    const Columns left = Columns::of(left_of(0), left_of(1), left_of(2), left_of(3));
    const Columns chord = Columns::of(right_of(0), right_of(1), right_of(2), right_of(3)) - left;
    const Columns along = Columns::of(along_of(0), along_of(1), along_of(2), along_of(3));
    const Columns foot = plus(Columns::of(from_of(0), from_of(1), from_of(2), from_of(3)), left),
                  across = cross(chord, along);
    const Lanes reach = dot(along, cross(foot, chord));
    for (std::uint64_t lanes = least.lanes_left(reach, dot(across, across)); lanes != 0; lanes &= lanes - 1) {
      const std::size_t edge = edges[static_cast<std::size_t>(std::countr_zero(lanes))];
      search_edge(edge, vec3_of(facets.lines[edge].from), vec3_of(facets.lines[edge].along),
                  face_normal(shape, facets.sides[edge].left), face_normal(shape, facets.sides[edge].right), least);
    }
  }
}

}  // namespace abut
