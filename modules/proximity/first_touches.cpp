// SPDX-License-Identifier: Apache-2.0
module abut.proximity.first_touches;
import abut.core.standard;
import abut.core;
import abut.deforming;
import abut.elements.nearest;
import abut.math.tolerance;
import abut.math;
import abut.proximity.body;
import abut.proximity.search;
import abut.proximity.stencil;
import abut.trees.elements.element_pairs;
import abut.triangles.elements;

namespace abut {
namespace {

[[nodiscard]] MovingPoint moving(const ElementBody& body, std::uint32_t vertex) {
  return {body.start()[vertex], body.end()[vertex]};
}
[[nodiscard]] Vec3 at(const MovingPoint& point, Real time) { return (1 - time) * point.start + time * point.end; }

// The points of two features at a time, and the normal of the plane in which they meet.
struct Meeting {
  std::array<MovingPoint, 4> vertices;
  std::array<Real, 4> weights;
  Vec3 way;     // from the first feature to the second
  Vec3 across;  // at right angles to both
};

// Features that touch have no way between them, and rounding leaves one that says nothing of the side. Then they come
// together along the normal.
void set_direction(const Meeting& meeting, Real separation, Stencil& out) {
  Vec3 rate{0, 0, 0};
  Real size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const MovingPoint& vertex = meeting.vertices.at(i);
    rate += meeting.weights.at(i) * (vertex.end - vertex.start);
    size = std::max({size, largest_magnitude(vertex.start), largest_magnitude(vertex.end)});
  }
  const Real distance = norm(meeting.way);
  const auto way = UnitVec3::make(meeting.way);
  if (separation > 0 && way && distance > noise_of(size)) {
    out.normal = *way;
    out.distance = distance;
  } else if (const auto across = UnitVec3::make(meeting.across)) {
    out.normal = dot(across->vec(), rate) > 0 ? -across->vec() : across->vec();
  } else {
    const auto against = UnitVec3::make(-rate);
    out.normal = against ? against->vec() : Vec3{1, 0, 0};
  }
}

[[nodiscard]] Stencil touch_of_vertex(const ElementBody& own, std::uint32_t vertex, const ElementBody& other,
                                      std::uint32_t face, bool is_of_b, const MovingTouch& touch, Real separation) {
  const auto corners = other.corners_of(face);
  Meeting meeting{
      {moving(own, vertex), moving(other, corners[0]), moving(other, corners[1]), moving(other, corners[2])},
      {-1, 0, 0, 0},
      {},
      {}};
  const Vec3 place = at(meeting.vertices[0], touch.upper);
  const std::array<Vec3, 3> face_then{at(meeting.vertices[1], touch.upper), at(meeting.vertices[2], touch.upper),
                                      at(meeting.vertices[3], touch.upper)};
  const NearestOnFace nearest = nearest_on_face(place, face_then);
  for (std::size_t i = 0; i < nearest.count; ++i) {
    meeting.weights.at(1 + nearest.corners.at(i)) = nearest.weights.at(i);
  }
  meeting.way = nearest.point - place;
  meeting.across = cross(face_then[1] - face_then[0], face_then[2] - face_then[0]);
  Stencil out{StencilKind::vertex_face, 1,  vertex, face,       {vertex, corners[0], corners[1], corners[2]},
              meeting.weights,          {}, 0,      touch.lower};
  set_direction(meeting, separation, out);
  if (is_of_b) {
    out.vertices = {corners[0], corners[1], corners[2], vertex};
    out.weights = {-meeting.weights[1], -meeting.weights[2], -meeting.weights[3], 1};
    std::swap(out.element_a, out.element_b);
    out.of_a = 3;
    out.normal = -out.normal;
  }
  return out;
}

// How far along each of two edges the closest points are, ends included.
struct Shares {
  Real first, second;
};
[[nodiscard]] Shares closest_shares(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  if (const auto inside = nearest_of_edges(a, b)) {
    return {inside->shares[0], inside->shares[1]};
  }
  Shares best{0, 0};
  Real least = infinity;
  const auto share_on = [](const Vec3& point, const std::array<Vec3, 2>& edge) {
    const Vec3 way = edge[1] - edge[0];
    const Real along = dot(point - edge[0], way), length = squared_norm(way);
    return length > 0 ? std::clamp(along / length, Real{0}, Real{1}) : 0;
  };
  const auto take = [&](const Shares& shares) {
    const Vec3 way = b[0] + shares.second * (b[1] - b[0]) - (a[0] + shares.first * (a[1] - a[0]));
    if (squared_norm(way) < least) {
      least = squared_norm(way);
      best = shares;
    }
  };
  for (std::size_t i = 0; i < 2; ++i) {
    take({share_on(b.at(i), a), static_cast<Real>(i)});
    take({static_cast<Real>(i), share_on(a.at(i), b)});
  }
  return best;
}

[[nodiscard]] Stencil touch_of_edges(const ElementBody& a, std::uint32_t of_a, const ElementBody& b, std::uint32_t of_b,
                                     const MovingTouch& touch, Real separation) {
  const EdgeEnds &first = a.ends_of(of_a), &second = b.ends_of(of_b);
  Meeting meeting{{moving(a, first[0]), moving(a, first[1]), moving(b, second[0]), moving(b, second[1])}, {}, {}, {}};
  const std::array<Vec3, 2> edge{at(meeting.vertices[0], touch.upper), at(meeting.vertices[1], touch.upper)};
  const std::array<Vec3, 2> other{at(meeting.vertices[2], touch.upper), at(meeting.vertices[3], touch.upper)};
  const Shares shares = closest_shares(edge, other);
  meeting.weights = {shares.first - 1, -shares.first, 1 - shares.second, shares.second};
  meeting.way = other[0] + shares.second * (other[1] - other[0]) - (edge[0] + shares.first * (edge[1] - edge[0]));
  meeting.across = cross(edge[1] - edge[0], other[1] - other[0]);
  Stencil out{StencilKind::edge_edge, 2,  of_a, of_b,       {first[0], first[1], second[0], second[1]},
              meeting.weights,        {}, 0,    touch.lower};
  set_direction(meeting, separation, out);
  return out;
}

// Those of vertices of a, of vertices of b, then of edges; each by their numbers.
[[nodiscard]] auto order_of(const Stencil& its) {
  return std::tuple(its.kind, its.of_a, its.of_a == 3 ? its.element_b : its.element_a,
                    its.of_a == 3 ? its.element_a : its.element_b);
}

}  // namespace

void FirstTouches::find(ElementBody& a, ElementBody& b, const FirstTouchOptions& options, const Workers& workers,
                        std::vector<Stencil>& out) {
  constexpr std::uint32_t told_kinds = bit(StencilKind::vertex_face) | bit(StencilKind::edge_edge);
  const std::uint32_t kinds = options.kinds == 0 ? told_kinds : options.kinds;
  const Real rest = &a == &b ? options.rest_distance : 0;
  search_.begin(a, b, options.touch.separation, workers);
  found_.resize(std::max(found_.size(), search_.tasks()));
  for (std::vector<Stencil>& found : found_) {
    found.clear();
  }
  search_.for_each_candidates(a, b, workers, [&](std::size_t task, const Candidates& candidates) {
    const auto add = [&](const ElementPair& pair, const ElementBody& own, const ElementBody& other, bool is_of_b) {
      const auto [vertex, face] = pair;
      const auto corners = other.corners_of(face);
      const MovingTouch touch = first_touch_of_vertex_and_face(
          moving(own, vertex), {moving(other, corners[0]), moving(other, corners[1]), moving(other, corners[2])},
          options.touch);
      if (touch.touches && !(rest > 0 && are_near_at_rest(own, vertex, face, rest))) {
        found_[task].push_back(touch_of_vertex(own, vertex, other, face, is_of_b, touch, options.touch.separation));
      }
    };
    if ((kinds & bit(StencilKind::vertex_face)) != 0) {
      for (const ElementPair& pair : candidates.vertices_and_faces.list()) {
        add(pair, a, b, false);
      }
      for (const ElementPair& pair : candidates.faces_and_vertices.list()) {
        add(pair, b, a, true);
      }
    }
    if ((kinds & bit(StencilKind::edge_edge)) == 0) {
      return;
    }
    for (const auto& [of_a, of_b] : candidates.edges.list()) {
      // Of one mesh the lower number comes first.
      const std::uint32_t first = &a == &b ? std::min(of_a, of_b) : of_a,
                          second = &a == &b ? std::max(of_a, of_b) : of_b;
      const EdgeEnds &ends = a.ends_of(first), &others = b.ends_of(second);
      const MovingTouch touch = first_touch_of_edges({moving(a, ends[0]), moving(a, ends[1])},
                                                     {moving(b, others[0]), moving(b, others[1])}, options.touch);
      if (touch.touches && !(rest > 0 && are_edges_near_at_rest(a, first, second, rest))) {
        found_[task].push_back(touch_of_edges(a, first, b, second, touch, options.touch.separation));
      }
    }
  });
  out.clear();
  for (const std::vector<Stencil>& found : found_) {
    out.insert(out.end(), found.begin(), found.end());
  }
  std::ranges::sort(out, [](const Stencil& x, const Stencil& y) { return order_of(x) < order_of(y); });
}

std::size_t FirstTouches::bytes() const {
  std::size_t sum = found_.capacity() * sizeof(std::vector<Stencil>);
  for (const std::vector<Stencil>& its : found_) {
    sum += its.capacity() * sizeof(Stencil);
  }
  return sum;
}

}  // namespace abut
