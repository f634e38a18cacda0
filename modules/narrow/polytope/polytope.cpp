// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;

namespace abut {
namespace {

// The normals of thin triangles, of which the product of two edges is small beside these, are off by rounding of their
// lengths. What leads along the longest edge is taken out, as its length would multiply it.
[[nodiscard]] [[gnu::noinline]] Columns settled_on_longest(const Columns& normal, const Columns& u, const Columns& v) {
  const auto choose = [](LaneNumbers which, const Columns& a, const Columns& b) {
    return Columns{which ? a.x : b.x, which ? a.y : b.y, which ? a.z : b.z};
  };
  const Columns w = u - v;
  const Columns longer = choose(dot(u, u) >= dot(v, v), u, v);
  const Columns longest = choose(dot(longer, longer) >= dot(w, w), longer, w);
  const Columns across = normal - (dot(normal, longest) / dot(longest, longest)) * longest;
  const Lanes square = dot(across, across);
  return choose(square > all_lanes(0.5), (1 / __builtin_elementwise_sqrt(square)) * across, normal);
}

}  // namespace

void Polytope::set_faces(const Triangles& triangles, std::size_t count) {
  const auto corners = [&](const std::array<std::uint16_t, 4>& of) {
    return Columns::of(points_[of[0]], points_[of[1]], points_[of[2]], points_[of[3]]);
  };
  const Columns p = corners(triangles.p), r = corners(triangles.r);
  const Columns u = p - r, v = corners(triangles.q) - r;
  const Columns n = cross(u, v);
  const Lanes square = dot(n, n);
  // A face without area bounds nothing: never the least one, and seen by any vertex.
  const LaneNumbers has_area = square > all_lanes(0);
  const Lanes inverse = has_area ? 1 / __builtin_elementwise_sqrt(square) : all_lanes(0);
  Columns normal = inverse * n;
  const LaneNumbers is_thin = square < all_lanes(slender_square) * dot(u, u) * dot(v, v);
  if (largest(is_thin ? inverse : all_lanes(0)) > 0) [[unlikely]] {
    const Columns settled = settled_on_longest(normal, u, v);
    normal = {is_thin ? settled.x : normal.x, is_thin ? settled.y : normal.y, is_thin ? settled.z : normal.z};
  }
  const Lanes distance = dot(normal, p);
  const Lanes beyond = has_area ? distance : all_lanes(-infinity);
  const Lanes least = has_area ? distance : all_lanes(infinity);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t face = triangles.faces[i];
    planes_[face] = Lanes{normal.x[i], normal.y[i], normal.z[i], beyond[i]};
    distances_[face / 4][face % 4] = least[i];
    corners_[face] = {triangles.p[i], triangles.q[i], triangles.r[i], 0};
    visible_[face] = 0;
  }
}

bool Polytope::expand(std::size_t seed, const DifferenceVertex& vertex, Real noise) {
  if (vertex_count_ == vertex_limit) {
    return false;
  }
  Lanes from = lanes_of(vertex.w);
  from[3] = -1;
  // A vertex in the plane of a face counts as seeing it: that merges coplanar faces and keeps triangles
  // without area out.
  const auto sees = [&](std::size_t face) { return dot(planes_[face], from) > -noise; };

  // The faces that see the vertex, walked over from the seed, so that they are connected, and from each on
  // over its edges counter-clockwise: that meets the edges of the horizon in the order of their loop.
  [[clang::uninitialized]] std::array<std::uint16_t, face_limit> visible;
  [[clang::uninitialized]] std::array<Edge, face_limit> horizon;  // as edges of the faces that stay
  [[clang::uninitialized]] std::array<Edge, 3 * face_limit> open;
  std::size_t visible_count = 1, horizon_count = 0, open_count = 3;
  visible[0] = static_cast<std::uint16_t>(seed);
  visible_[seed] = 1;
  open[0] = edge_of(seed, 2);
  open[1] = edge_of(seed, 1);
  open[2] = edge_of(seed, 0);
  while (open_count > 0) {
    const Edge beyond = across(open[--open_count]);
    const std::size_t face = face_of(beyond);
    if (visible_[face] != 0) {
      continue;
    }
    if (sees(face)) {
      visible_[face] = 1;
      visible[visible_count++] = static_cast<std::uint16_t>(face);
      open[open_count++] = after(after(beyond));
      open[open_count++] = after(beyond);
    } else {
      if (horizon_count == face_limit) {
        return false;
      }
      horizon[horizon_count++] = beyond;
    }
  }
  if (horizon_count < 3) {
    return false;
  }
  // Seen from the faces that stay the loop runs the other way: an edge ends where the one before it starts.
  for (std::size_t i = 0; i < horizon_count; ++i) {
    if (start_of(after(horizon[i])) != start_of(horizon[i > 0 ? i - 1 : horizon_count - 1])) {
      return false;
    }
  }

  const auto apex = static_cast<std::uint16_t>(vertex_count_);
  add(vertex);
  // The cone takes the places of the faces that go, and gives back those that it does not need.
  std::size_t count = visible_count;
  for (; count < horizon_count; ++count) {
    const std::size_t face = new_face();
    if (face == none) {
      return false;
    }
    visible[count] = static_cast<std::uint16_t>(face);
  }
  while (count > horizon_count) {
    const std::size_t face = visible[--count];
    distances_[face / 4][face % 4] = infinity;
    free_[free_count_++] = static_cast<std::uint16_t>(face);
  }
  for (std::size_t first = 0; first < horizon_count; first += 4) {
    const std::size_t in_group = horizon_count - first < 4 ? horizon_count - first : 4;
    [[clang::uninitialized]] Triangles group;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t at = first + (i < in_group ? i : 0);
      group.faces[i] = visible[at];
      group.p[i] = start_of(after(horizon[at]));
      group.q[i] = start_of(horizon[at]);
      group.r[i] = apex;
    }
    set_faces(group, in_group);
  }
  std::size_t previous = visible[horizon_count - 1];
  for (std::size_t i = 0; i < horizon_count; ++i) {
    const std::size_t face = visible[i];
    join(edge_of(face, 0), horizon[i]);
    join(edge_of(face, 2), edge_of(previous, 1));
    previous = face;
  }
  return true;
}

FlatDifference Polytope::start(const Simplex& simplex, Real noise, const Difference& cores) {
  add(simplex.size > 0 ? simplex.vertices[0] : cores.vertex_toward(Vec3{1, 0, 0}));

  // A vertex of the simplex that reaches far enough saves the search along the given directions.
  const auto grow = [&](auto&& reach_of, const auto& directions, Real threshold) {
    DifferenceVertex best = vertices_[0];
    Real best_reach = 0;
    const auto consider = [&](const DifferenceVertex& candidate) {
      const Real reach = reach_of(candidate.w);
      if (reach > best_reach) {
        best_reach = reach;
        best = candidate;
      }
    };
    for (std::size_t i = 1; i < simplex.size; ++i) {
      consider(simplex.vertices[i]);
    }
    if (!(best_reach > threshold)) {
      for (const Vec3& direction : directions) {
        consider(cores.vertex_toward(direction));
        consider(cores.vertex_toward(-direction));
      }
    }
    if (best_reach > threshold) {
      add(best);
      return true;
    }
    return false;
  };

  const Vec3 origin = vertices_[0].w;
  const Real wide = 1e3 * noise;  // extents that leave the digits of a normal in order
  const Real thick = 16 * noise;  // across such a normal: what is thinner tells no faces apart
  if (!grow([&](const Vec3& w) { return norm(w - origin); },
            std::array<Vec3, 3>{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}, wide)) {
    return {true, {0, 0, 1}};
  }
  const Vec3 along = UnitVec3::make(vertices_[1].w - origin).value_or(UnitVec3::axis_z());
  const Tangents across = tangents_of(along);
  if (!grow(
          [&](const Vec3& w) { return norm(cross(along, w - origin)); },
          std::array<Vec3, 4>{across.first, across.second, across.first + across.second, across.first - across.second},
          wide)) {
    return {true, across.first};
  }
  const Vec3 normal =
      UnitVec3::make(cross(vertices_[1].w - origin, vertices_[2].w - origin)).value_or(UnitVec3::axis_z());
  if (!grow([&](const Vec3& w) { return std::fabs(dot(normal, w - origin)); }, std::array<Vec3, 1>{normal}, thick)) {
    return {true, normal};
  }
  const bool above = dot(normal, vertices_[3].w - origin) > 0;
  const std::uint16_t one = above ? 1 : 2, two = above ? 2 : 1;
  for (std::size_t i = 0; i < 4; ++i) {
    [[maybe_unused]] const std::size_t face = new_face();
  }
  set_faces({{0, 1, 2, 3}, {0, 0, one, two}, {two, one, two, 0}, {one, 3, 3, 3}}, 4);
  constexpr std::array<std::array<Edge, 2>, 6> joints{{{edge_of(0, 0), edge_of(3, 0)},
                                                       {edge_of(0, 1), edge_of(2, 0)},
                                                       {edge_of(0, 2), edge_of(1, 0)},
                                                       {edge_of(1, 1), edge_of(2, 2)},
                                                       {edge_of(1, 2), edge_of(3, 1)},
                                                       {edge_of(2, 1), edge_of(3, 2)}}};
  for (const auto& [edge, other] : joints) {
    join(edge, other);
  }
  return {false, normal};
}

}  // namespace abut
