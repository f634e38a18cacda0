// SPDX-License-Identifier: Apache-2.0
module abut.narrow.points.clip;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.points.closest_of_faces;
import abut.narrow.points.lift;
import abut.narrow.points.small_polygons;

namespace abut {
namespace {

// The box of a projected face. Corners outside of edges by rounding are kept. Near a sharp corner, where edges are
// nearly parallel, such a corner may lie well beyond it.
class Extent {
 public:
  Extent(const Face& face, const Projection& projection) {
    for (const FaceVertex& vertex : face.vertices.span()) {
      const Vec2 p = projection(vertex.point);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }
  [[nodiscard]] bool holds(const Vec2& p, Real slack) const {
    return p.x >= low_.x - slack && p.x <= high_.x + slack && p.y >= low_.y - slack && p.y <= high_.y + slack;
  }

 private:
  Vec2 low_{infinity, infinity}, high_{-infinity, -infinity};
};

[[nodiscard]] bool faces_normal(const Face& face, const Vec3& normal) {
  return std::fabs(dot(face.normal, normal)) > steepest_cosine;
}

// What a face that stands steep to the normal has furthest out along `outward`: the edge there.
[[nodiscard]] Face outer_edge(const Face& face, const Vec3& outward) {
  const auto vertices = face.vertices.span();
  const std::size_t count = vertices.size();
  const auto reach = [&](std::size_t i) { return dot(vertices[i % count].point, outward); };
  std::size_t top = 0;
  for (std::size_t i = 1; i < count; ++i) {
    top = reach(i) > reach(top) ? i : top;
  }
  const std::size_t from = reach(top + 1) > reach(top + count - 1) ? top : (top + count - 1) % count;
  [[clang::uninitialized]] Face edge;
  edge.vertices.push_back(vertices[from]);
  edge.vertices.push_back(vertices[(from + 1) % count]);
  return edge;
}

// A corner of the region while it is cut: what it is on each side, and on which edge of which polygon
// the boundary leaves it.
struct Corner {
  Vec2 at;
  Feature feature_a, feature_b;
  bool leaves_on_b;    // along an edge of b, else of a
  std::uint32_t edge;  // that edge's number
};
using Corners = SmallVector<Corner, 24>;

// An edge of polygon a in the projection, and what it leads from and to.
struct Edge {
  Vec2 from, to;
  std::uint32_t number, from_vertex, to_vertex;
};

// How far to the left of a line a place lies, times the length of the direction. What ties with the line is on it, so
// that faces that meet along an edge have it in common.
[[nodiscard]] inline Real side_of(const Vec2& place, const Vec2& direction, Real tie) {
  const Real side = cross(direction, place);
  return side < -tie * (std::fabs(direction.x) + std::fabs(direction.y)) ? side : std::max(side, Real{0});
}

enum class Cut : std::uint8_t { nothing, everything, some };

// Cuts the corners by the line of an edge; what lies left stays (Sutherland and Hodgman 1974). `out` is
// written only where the line crosses the region.
[[nodiscard]] Cut cut(const Corners& in, Corners& out, const Edge& edge, Real tie, std::uint32_t face_of_b) {
  const Vec2 direction = edge.to - edge.from;
  const auto corners = in.span();
  [[clang::uninitialized]] SmallVector<Real, 24> sides;
  Real least = infinity, largest = -infinity;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Real side = side_of(corners[i].at - edge.from, direction, tie);
    sides.push_back(side);
    least = side < least ? side : least;
    largest = side > largest ? side : largest;
  }
  if (least >= 0) {
    return Cut::nothing;
  }
  if (largest < 0) {
    return Cut::everything;
  }
  out.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t j = i + 1 < corners.size() ? i + 1 : 0;
    const Corner& here = corners[i];
    const bool here_stays = sides[i] >= 0;
    if (here_stays) {
      out.push_back(here);
    }
    if (here_stays != (sides[j] >= 0)) {
      Corner crossing = here;
      crossing.at = mix(here.at, corners[j].at, sides[i] / (sides[i] - sides[j]));
      // Between the two, the boundary runs along an edge of b or of a. This edge crosses one of b, and meets an earlier
      // one of a at a vertex inside b.
      if (here.leaves_on_b) {
        crossing.feature_a = {FeatureKind::edge, edge.number};
        crossing.feature_b = {FeatureKind::edge, here.edge};
      } else {
        crossing.feature_a = {FeatureKind::vertex, here_stays ? edge.from_vertex : edge.to_vertex};
        crossing.feature_b = {FeatureKind::face, face_of_b};
      }
      if (here_stays) {
        crossing.leaves_on_b = false;
        crossing.edge = edge.number;
      }
      out.push_back(crossing);
    }
  }
  return Cut::some;
}

// Of corners that follow each other at one place, from edges that meet there, the first one, or the first vertex.
void merge_ties(const Corners& in, Corners& out, Real tie) {
  const auto is_crossing = [](const Corner& corner) { return corner.feature_a.kind == FeatureKind::edge; };
  const auto are_tied = [&](const Corner& p, const Corner& q) {
    const Vec2 step = q.at - p.at;
    return std::fabs(step.x) + std::fabs(step.y) <= tie;
  };
  const auto merge = [&](Corner& kept, const Corner& corner) {
    kept = is_crossing(kept) && !is_crossing(corner) ? corner : kept;
  };
  out.clear();
  for (const Corner& corner : in.span()) {
    if (out.size() > 0 && are_tied(out[out.size() - 1], corner)) {
      merge(out[out.size() - 1], corner);
    } else if (out.size() > 1 && are_tied(corner, out[0])) {
      merge(out[0], corner);
    } else {
      out.push_back(corner);
    }
  }
}

void clip_polygons(const Face& a, const Face& b, const Projection& projection, ClipPoints& out) {
  [[clang::uninitialized]] Corners first;
  [[clang::uninitialized]] Corners second;
  Corners *current = &first, *spare = &second;
  const auto vertices_a = a.vertices.span();
  const auto vertices_b = b.vertices.span();
  // Seen against the normal a runs counter-clockwise when its normal agrees, b when its disagrees.
  const bool a_turns = dot(a.normal, projection.normal) >= 0;
  const bool b_turns = dot(b.normal, projection.normal) >= 0;
  for (std::size_t i = 0; i < vertices_b.size(); ++i) {
    const std::size_t k = b_turns ? i : vertices_b.size() - 1 - i;
    const std::size_t edge = b_turns ? k : (k > 0 ? k : vertices_b.size()) - 1;
    current->push_back({projection(vertices_b[k].point),
                        {FeatureKind::face, a.index},
                        {FeatureKind::vertex, vertices_b[k].vertex},
                        true,
                        vertices_b[edge].edge});
  }
  const std::size_t count = vertices_a.size();
  const auto place = [&](std::size_t i) { return a_turns ? i : count - 1 - i; };
  Edge edge{};
  edge.to = projection(vertices_a[place(0)].point);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = place(i), to = place(i + 1 < count ? i + 1 : 0);
    edge = {edge.to, projection(vertices_a[to].point), vertices_a[a_turns ? from : to].edge, vertices_a[from].vertex,
            vertices_a[to].vertex};
    const Cut found = cut(*current, *spare, edge, projection.tie, b.index);
    if (found == Cut::everything) {
      return;
    }
    if (found == Cut::some) {
      std::swap(current, spare);
    }
  }
  const Lift lift_a(a, projection), lift_b(b, projection);
  const Extent extent_a(a, projection), extent_b(b, projection);
  merge_ties(*current, *spare, 4 * projection.tie);
  for (const Corner& corner : spare->span()) {
    if (extent_a.holds(corner.at, 4 * projection.tie) && extent_b.holds(corner.at, 4 * projection.tie)) {
      out.push_back({lift_a(corner.at, projection), lift_b(corner.at, projection), corner.feature_a, corner.feature_b});
    }
  }
}

// The stretch of a segment over a polygon, in shares of its length, and the edges at its ends, if any.
struct Stretch {
  Real enter = 0, leave = 1;
  std::uint32_t enter_edge = no_index, leave_edge = no_index;
};
// `tie`: a share of the segment. Of edges that meet under it the first one counts.
[[nodiscard]] std::optional<Stretch> stretch_over(const Vec2& p, const Vec2& q, const Face& polygon,
                                                  const Projection& projection, Real tie) {
  const bool turns = dot(polygon.normal, projection.normal) >= 0;
  const auto vertices = polygon.vertices.span();
  Stretch found;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::size_t j = (i + 1) % vertices.size();
    const Vec2 from = projection(vertices[turns ? i : j].point),
               direction = projection(vertices[turns ? j : i].point) - from;
    const Real at_p = side_of(p - from, direction, projection.tie), at_q = side_of(q - from, direction, projection.tie);
    if (at_p < 0 && at_q < 0) {
      return std::nullopt;
    }
    if (at_p >= 0 && at_q >= 0) {
      continue;
    }
    const Real at = at_p / (at_p - at_q);
    if (at_p < 0 && at > found.enter + tie) {
      found.enter = at;
      found.enter_edge = vertices[i].edge;
    } else if (at_q < 0 && at < found.leave - tie) {
      found.leave = at;
      found.leave_edge = vertices[i].edge;
    }
  }
  return found.enter <= found.leave + tie ? std::optional(found) : std::nullopt;
}

// The stretch of a segment inside a polygon, by its two ends. `swapped`: the segment is side b.
void clip_segment(const Face& segment, const Face& polygon, const Projection& projection, bool swapped,
                  ClipPoints& out) {
  const FaceVertex &start = segment.vertices[0], &end = segment.vertices[1];
  const Real length = norm(end.point - start.point), tie = length > 0 ? 4 * projection.tie / length : 1;
  const std::optional<Stretch> stretch =
      stretch_over(projection(start.point), projection(end.point), polygon, projection, tie);
  if (!stretch) {
    return;
  }
  const Lift lift(polygon, projection);
  const Extent extent(polygon, projection);
  const auto emit = [&](Real t, std::uint32_t edge, std::uint32_t end_vertex) {
    const Vec3 on_segment = start.point + t * (end.point - start.point);
    if (!extent.holds(projection(on_segment), 4 * projection.tie)) {
      return;
    }
    const Vec3 on_polygon = lift(projection(on_segment), projection);
    const Feature of_segment =
        edge == no_index ? Feature{FeatureKind::vertex, end_vertex} : Feature{FeatureKind::edge, start.edge};
    const Feature of_polygon =
        edge == no_index ? Feature{FeatureKind::face, polygon.index} : Feature{FeatureKind::edge, edge};
    if (swapped) {
      out.push_back({on_polygon, on_segment, of_polygon, of_segment});
    } else {
      out.push_back({on_segment, on_polygon, of_segment, of_polygon});
    }
  };
  const bool is_one_point = stretch->leave <= stretch->enter + tie;
  const bool is_end = stretch->enter_edge != no_index && stretch->leave_edge == no_index;
  if (!is_one_point || !is_end) {
    emit(stretch->enter, stretch->enter_edge, start.vertex);
  }
  if (!is_one_point || is_end) {
    emit(stretch->leave, stretch->leave_edge, end.vertex);
  }
}

// Parallel segments share a stretch; crossing ones are left to the closest points.
void clip_segments(const Face& a, const Face& b, const Projection& projection, ClipPoints& out) {
  const FaceVertex &a0 = a.vertices[0], &a1 = a.vertices[1], &b0 = b.vertices[0], &b1 = b.vertices[1];
  const Vec2 p = projection(a0.point), e = projection(a1.point) - p;
  const Vec2 q = projection(b0.point), f = projection(b1.point) - q;
  const Real ee = dot(e, e), ff = dot(f, f);
  const Real turn = cross(e, f);
  if (!(ee > 0 && ff > 0) || turn * turn > parallel_sine * parallel_sine * ee * ff) {
    return;
  }
  const auto on_a = [&](const Vec2& x) { return dot(x - p, e) / ee; };
  const auto on_b = [&](const Vec2& x) { return dot(x - q, f) / ff; };
  struct End {
    Real at;
    Feature feature_a, feature_b;
  };
  const Real start_b = on_a(q), end_b = on_a(q + f);
  const bool same_way = start_b <= end_b;
  const Feature edge_a{FeatureKind::edge, a0.edge}, edge_b{FeatureKind::edge, b0.edge};
  const auto vertex = [](const FaceVertex& v) { return Feature{FeatureKind::vertex, v.vertex}; };
  const Real low_b = same_way ? start_b : end_b, high_b = same_way ? end_b : start_b,
             tie = projection.tie / std::sqrt(ee);
  const End low = low_b > tie ? End{low_b, edge_a, vertex(same_way ? b0 : b1)} : End{0, vertex(a0), edge_b};
  const End high = high_b < 1 - tie ? End{high_b, edge_a, vertex(same_way ? b1 : b0)} : End{1, vertex(a1), edge_b};
  if (low.at > high.at + tie) {
    return;
  }
  const auto emit = [&](const End& end) {
    const Vec3 point_a = a0.point + end.at * (a1.point - a0.point);
    const Real t = std::clamp(on_b(projection(point_a)), Real{0}, Real{1});
    out.push_back({point_a, b0.point + t * (b1.point - b0.point), end.feature_a, end.feature_b});
  };
  emit(low);
  if (high.at > low.at + tie) {
    emit(high);
  }
}

[[nodiscard]] Real reach_from(const Vec3& base, const Face& face) {
  Real reach = 0;
  for (const FaceVertex& vertex : face.vertices.span()) {
    reach = std::max(reach, largest_magnitude(vertex.point - base));
  }
  return reach;
}

[[nodiscard]] Real tie_of(const Face& a, const Face& b) {
  const Vec3 &of_a = a.vertices[0].point, &of_b = b.vertices[0].point;
  return tie_of_sizes(reach_from(of_a, a), reach_from(of_b, b), of_a, of_b);
}

// Faces that both look along the normal, or are edges.
void clip_facing(const Face& a, const Face& b, const Vec3& normal, Real tie, ClipPoints& out) {
  const Projection projection{a.vertices[0].point, tangents_of(normal), normal, tie};
  const bool edge_a = a.vertices.size() == 2, edge_b = b.vertices.size() == 2;
  if (edge_a && edge_b) {
    clip_segments(a, b, projection, out);
  } else if (edge_a) {
    clip_segment(a, b, projection, false, out);
  } else if (edge_b) {
    clip_segment(b, a, projection, true, out);
  } else if (!(has_few_corners(a) && has_few_corners(b) &&
               clip_small_polygons(few_corners_of(a), few_corners_of(b), projection, out))) {
    clip_polygons(a, b, projection, out);
  }
}

[[nodiscard]] inline Real separation(const ClipPoint& point, const Vec3& normal) {
  return dot(point.point_b - point.point_a, normal);
}

// No corner is closer than the faces are. One that ties with the rim of a steep face is brought back; one that is
// further off lies beside its face, which a needle lifts it off.
void drop_too_close(const Vec3& normal, Real closest, Real most, ClipPoints& out) {
  [[clang::uninitialized]] ClipPoints kept;
  for (const ClipPoint& point : out.span()) {
    const Real excess = closest - separation(point, normal);
    if (excess <= most) {
      const Vec3 point_a = point.point_a - std::max(excess, Real{0}) * normal;
      kept.push_back({point_a, point.point_b, point.feature_a, point.feature_b});
    }
  }
  out = kept;
}

// A region may miss the closest points, as between edges that cross, or when a face stands steep.
void settle_closest(const Face& a, const Face& b, const Vec3& normal, Real tie, bool wants_closest, ClipPoints& out) {
  Real top = -infinity, bottom = infinity, least = infinity, size = 0;
  for (const FaceVertex& vertex : a.vertices.span()) {
    top = std::max(top, dot(vertex.point, normal));
    size = std::max(size, largest_magnitude(vertex.point));
  }
  for (const FaceVertex& vertex : b.vertices.span()) {
    bottom = std::min(bottom, dot(vertex.point, normal));
    size = std::max(size, largest_magnitude(vertex.point));
  }
  const Real rounding = noise_of(size), closest = bottom - top;
  const auto find_least = [&] {
    least = infinity;
    for (const ClipPoint& point : out.span()) {
      least = std::min(least, separation(point, normal));
    }
  };
  find_least();
  if (least < closest - rounding) [[unlikely]] {
    drop_too_close(normal, closest, rounding + tie / steepest_cosine, out);
    find_least();
  }
  if (!wants_closest || least <= closest + rounding + tie) {
    return;
  }
  const AcrossPair pair = points_across(a, b, normal, rounding);
  const Vec3 way = pair.point_b - pair.point_a;
  if (largest_magnitude(way - dot(way, normal) * normal) <= rounding) {
    out.push_back({pair.point_a, pair.point_b, feature_of(a), feature_of(b)});
  }
}

}  // namespace

void clip_faces(const Face& a, const Face& b, const Vec3& normal, ClipPoints& out, bool wants_closest) {
  const std::size_t count_a = a.vertices.size(), count_b = b.vertices.size();
  if (count_a < 2 || count_b < 2) {
    return;
  }
  const bool steep_a = count_a > 2 && !faces_normal(a, normal), steep_b = count_b > 2 && !faces_normal(b, normal);
  const Real tie = tie_of(a, b);
  if (steep_a || steep_b) {
    clip_facing(steep_a ? outer_edge(a, normal) : a, steep_b ? outer_edge(b, -normal) : b, normal, tie, out);
  } else {
    clip_facing(a, b, normal, tie, out);
  }
  settle_closest(a, b, normal, tie, wants_closest, out);
}

}  // namespace abut
