// SPDX-License-Identifier: Apache-2.0
module abut.proximity.closest;
import abut.core.standard;
import abut.core;
import abut.elements.keeping;
import abut.elements.nearest;
import abut.math.tolerance;
import abut.math;
import abut.proximity.body;
import abut.proximity.search.cones;
import abut.proximity.search.least_of_faces;
import abut.proximity.search;
import abut.proximity.stencil;
import abut.trees.elements.element_pairs;
import abut.triangles.elements;

namespace abut {
namespace {

constexpr std::uint32_t all_kinds = 15;

struct MethodRule {
  std::uint32_t kinds;  // that are told unless others are asked for
  bool keeps_regions;   // a feature counts in its Voronoi region only
  bool has_one;         // of a vertex: the nearest
  bool has_cones;
  bool is_of_faces;  // what is the least of two faces
};
constexpr std::array<MethodRule, 5> rules{{
    {all_kinds, true, false, false, false},
    {all_kinds, false, false, false, true},
    {all_kinds, false, false, false, false},
    {all_kinds & ~bit(StencilKind::edge_edge), true, true, false, false},
    {all_kinds, true, false, true, false},
}};

[[nodiscard]] const MethodRule& rule_of(const ClosestOptions& options) {
  return rules.at(static_cast<std::size_t>(options.method));
}
[[nodiscard]] std::uint32_t kinds_of(const ClosestOptions& options) {
  return options.kinds == 0 ? rule_of(options).kinds : options.kinds;
}

[[nodiscard]] StencilKind kind_of(const FaceStencil& its) {
  return its.count == 3   ? StencilKind::vertex_face
         : its.count == 2 ? StencilKind::vertex_edge
                          : StencilKind::vertex_vertex;
}

[[nodiscard]] std::optional<FaceStencil> stencil_within(const ElementBody& own, std::uint32_t vertex,
                                                        const ElementBody& other, std::uint32_t face, Real square) {
  const auto corners = other.corners_of(face);
  const NearestOnFace nearest = nearest_on_face(own.start()[vertex], corners_at(other.start(), corners));
  if (!(nearest.square <= square)) {
    return std::nullopt;
  }
  return face_stencil(vertex, face, corners, nearest);
}

// Features that are the same for several faces become one. They follow each other.
[[nodiscard]] std::size_t keep_different(std::span<FaceStencil> of_vertex, std::span<const Vec3> places) {
  std::ranges::sort(of_vertex, [&](const FaceStencil& a, const FaceStencil& b) { return comes_before(a, b, places); });
  const auto same = [](const FaceStencil& a, const FaceStencil& b) { return a.feature == b.feature; };
  return static_cast<std::size_t>(std::unique(of_vertex.begin(), of_vertex.end(), same) - of_vertex.begin());
}

// The number of a feature, and its vertices with their weights in the order of the mesh.
struct NumberedFeature {
  std::uint32_t number;
  std::array<std::uint32_t, 3> vertices;
  std::array<Real, 3> weights;
};
[[nodiscard]] NumberedFeature numbered(const FaceStencil& its, const ElementBody& body) {
  if (its.count == 1) {
    return {its.feature[0], its.feature, its.weights};
  }
  NumberedFeature out{its.face, its.feature, its.weights};
  if (its.count == 2) {
    out.number = body.table().edge_between(its.feature[0], its.feature[1]);
    std::ranges::copy(body.ends_of(out.number), out.vertices.begin());
  } else {
    std::ranges::copy(body.corners_of(its.face), out.vertices.begin());
  }
  for (std::size_t i = 0; i < its.count; ++i) {
    const auto place = std::ranges::find(its.feature, out.vertices.at(i)) - its.feature.begin();
    out.weights.at(i) = its.weights.at(static_cast<std::size_t>(place));
  }
  return out;
}

// The unit vector from a vertex to a feature, or across the face where they touch.
[[nodiscard]] Vec3 direction_of(const FaceStencil& its, const ElementBody& own, const ElementBody& other) {
  if (const auto way = UnitVec3::make(its.point - own.start()[its.vertex])) {
    return *way;
  }
  const std::array<Vec3, 3> corners = corners_at(other.start(), other.corners_of(its.face));
  const auto normal = UnitVec3::make(cross(corners[1] - corners[0], corners[2] - corners[0]));
  return normal ? normal->vec() : Vec3{1, 0, 0};
}
[[nodiscard]] Vec3 direction_of(const EdgeStencil& its, const ElementBody& a, const ElementBody& b) {
  if (const auto way = UnitVec3::make(its.nearest.points[1] - its.nearest.points[0])) {
    return *way;
  }
  const std::array<Vec3, 2> of_a = ends_at(a.start(), a.ends_of(its.a)), of_b = ends_at(b.start(), b.ends_of(its.b));
  const auto normal = UnitVec3::make(cross(of_a[1] - of_a[0], of_b[1] - of_b[0]));
  return normal ? normal->vec() : Vec3{1, 0, 0};
}

[[nodiscard]] bool is_minimum(const FaceStencil& its, const ElementBody& own, const ElementBody& other,
                              const ConeOptions& cones) {
  if (!(its.square > 0)) {
    return true;
  }
  const Vec3 way = direction_of(its, own, other);
  if (!is_minimum_of_vertex(own, its.vertex, way, cones)) {
    return false;
  }
  const std::uint32_t number = numbered(its, other).number;
  return its.count == 1   ? is_minimum_of_vertex(other, number, -way, cones)
         : its.count == 2 ? is_minimum_of_edge(other, number, -way, cones)
                          : is_minimum_of_face(other, number, -way, cones);
}
// Where faces go on flat beside an edge, a vertex or a border has the same distance.
[[nodiscard]] bool is_minimum(const EdgeStencil& its, const ElementBody& a, const ElementBody& b,
                              const ConeOptions& cones) {
  if (!(its.nearest.square > 0)) {
    return true;
  }
  const Vec3 way = direction_of(its, a, b);
  return is_ridge(a, its.a) && is_ridge(b, its.b) && is_minimum_of_edge(a, its.a, way, cones) &&
         is_minimum_of_edge(b, its.b, -way, cones);
}

// `is_of_b`: the vertex is of the second mesh.
[[nodiscard]] Stencil told(const FaceStencil& its, const ElementBody& own, const ElementBody& other, bool is_of_b) {
  const NumberedFeature feature = numbered(its, other);
  const Vec3 way = direction_of(its, own, other);
  Stencil out{kind_of(its), 1, its.vertex, feature.number, {}, {}, way, std::sqrt(its.square), 0};
  std::size_t place = 0;
  const auto add = [&](std::uint32_t vertex, Real weight) {
    out.vertices.at(place) = vertex;
    out.weights.at(place) = weight;
    ++place;
  };
  if (!is_of_b) {
    add(its.vertex, -1);
  }
  for (std::size_t i = 0; i < its.count; ++i) {
    add(feature.vertices.at(i), is_of_b ? -feature.weights.at(i) : feature.weights.at(i));
  }
  if (is_of_b) {
    add(its.vertex, 1);
    out.of_a = its.count;
    std::swap(out.element_a, out.element_b);
    out.normal = -way;
  }
  while (place < out.vertices.size()) {
    add(out.vertices.at(place - 1), 0);
  }
  return out;
}
[[nodiscard]] Stencil told(const EdgeStencil& its, const ElementBody& a, const ElementBody& b) {
  const EdgeEnds &of_a = a.ends_of(its.a), &of_b = b.ends_of(its.b);
  const auto [first, second] = its.nearest.shares;
  return {StencilKind::edge_edge,
          2,
          its.a,
          its.b,
          {of_a[0], of_a[1], of_b[0], of_b[1]},
          {first - 1, -first, 1 - second, second},
          direction_of(its, a, b),
          std::sqrt(its.nearest.square),
          0};
}

}  // namespace

void ClosestFeatures::collect(const ElementBody& a, const ElementBody& b, const ClosestOptions& options,
                              const Workers& workers) {
  found_.resize(std::max(found_.size(), search_.tasks()));
  for (Found& found : found_) {
    found.of_vertices[0].clear();
    found.of_vertices[1].clear();
    found.edges.clear();
  }
  const Real square = options.reach * options.reach;
  const Real rest = &a == &b ? options.rest_distance : 0;
  // Other features of a pair of faces may be nearer than those that are told.
  const bool takes_edges = rule_of(options).is_of_faces || (kinds_of(options) & bit(StencilKind::edge_edge)) != 0;
  search_.for_each_candidates(a, b, workers, [&](std::size_t task, const Candidates& candidates) {
    Found& found = found_[task];
    const auto add = [&](const ElementPair& pair, const ElementBody& own, const ElementBody& other, std::size_t side) {
      const auto [vertex, face] = pair;
      const auto its = stencil_within(own, vertex, other, face, square);
      if (its && !(rest > 0 && are_near_at_rest(own, vertex, face, rest))) {
        found.of_vertices.at(side).push_back(*its);
      }
    };
    for (const ElementPair& pair : candidates.vertices_and_faces.list()) {
      add(pair, a, b, 0);
    }
    for (const ElementPair& pair : candidates.faces_and_vertices.list()) {
      add(pair, b, a, 1);
    }
    if (!takes_edges) {
      return;
    }
    for (const auto& [of_a, of_b] : candidates.edges.list()) {
      // Of one mesh the lower number comes first.
      const std::uint32_t first = &a == &b ? std::min(of_a, of_b) : of_a,
                          second = &a == &b ? std::max(of_a, of_b) : of_b;
      const auto nearest =
          nearest_of_edges(ends_at(a.start(), a.ends_of(first)), ends_at(b.start(), b.ends_of(second)));
      if (nearest && nearest->square <= square && !(rest > 0 && are_edges_near_at_rest(a, first, second, rest))) {
        found.edges.push_back({first, second, *nearest});
      }
    }
  });
}

void ClosestFeatures::group(std::size_t side, std::size_t vertex_count) {
  Grouped& out = grouped_.at(side);
  out.firsts.assign(vertex_count + 1, 0);
  for (const Found& found : found_) {
    for (const FaceStencil& its : found.of_vertices.at(side)) {
      ++out.firsts[its.vertex];
    }
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& first : out.firsts) {
    first = sum += first;
  }
  out.stencils.resize(sum);
  for (const Found& found : found_) {
    for (const FaceStencil& its : found.of_vertices.at(side)) {
      out.stencils[--out.firsts[its.vertex]] = its;
    }
  }
}

void ClosestFeatures::gather_edges() {
  edges_.clear();
  for (const Found& found : found_) {
    edges_.insert(edges_.end(), found.edges.begin(), found.edges.end());
  }
  std::ranges::sort(edges_,
                    [](const EdgeStencil& a, const EdgeStencil& b) { return std::tie(a.a, a.b) < std::tie(b.a, b.b); });
}

// What is not the least gets a square that no stencil has.
void ClosestFeatures::keep_least_of_faces(const ElementBody& a, const ElementBody& b) {
  least_.clear();
  for (std::size_t side = 0; side < 2; ++side) {
    for (const FaceStencil& its : grouped_.at(side).stencils) {
      least_.add_vertex(a, b, its.vertex, its.face, side == 1, its.square);
    }
  }
  for (const EdgeStencil& its : edges_) {
    least_.add_edges(a, b, its.a, its.b, its.nearest.square);
  }
  const std::vector<bool>& is_least = least_.result();
  std::size_t place = 0;
  for (Grouped& grouped : grouped_) {
    for (FaceStencil& its : grouped.stencils) {
      its.square = is_least[place++] ? its.square : infinity;
    }
  }
  std::erase_if(edges_, [&](const EdgeStencil&) { return !is_least[place++]; });
}

void ClosestFeatures::tell_vertices(std::size_t side, const ElementBody& own, const ElementBody& other,
                                    const ClosestOptions& options, const Workers& workers, std::vector<Stencil>& out) {
  constexpr std::size_t vertices_of_task = 1024;
  const MethodRule& rule = rule_of(options);
  const std::uint32_t kinds = kinds_of(options);
  Grouped& grouped = grouped_.at(side);
  const Aabb& box = other.box();
  const Real same = noise_of(std::max(largest_magnitude(box.low), largest_magnitude(box.high)));
  const Cuts cuts = workers.cut(own.start().size(), vertices_of_task);
  found_.resize(std::max(found_.size(), cuts.tasks()));
  workers.for_each(cuts.tasks(), [&](std::size_t task) {
    std::vector<Stencil>& told_here = found_[task].stencils;
    told_here.clear();
    for (std::size_t vertex = cuts.begin(task); vertex < cuts.end(task); ++vertex) {
      const std::span<FaceStencil> its =
          std::span(grouped.stencils)
              .subspan(grouped.firsts[vertex], grouped.firsts[vertex + 1] - grouped.firsts[vertex]);
      std::size_t kept = rule.keeps_regions ? keep_closest(its, other.triangles(), other.start(), same)
                                            : keep_different(its, other.start());
      kept = rule.has_one ? std::min<std::size_t>(kept, 1) : kept;
      for (const FaceStencil& stencil : its.first(kept)) {
        if ((kinds & bit(kind_of(stencil))) != 0 && stencil.square < infinity &&
            !(rule.has_cones && !is_minimum(stencil, own, other, options.cones))) {
          told_here.push_back(told(stencil, own, other, side == 1));
        }
      }
    }
  });
  for (std::size_t task = 0; task < cuts.tasks(); ++task) {
    out.insert(out.end(), found_[task].stencils.begin(), found_[task].stencils.end());
  }
}

// Either of two vertices may name the other one.
void ClosestFeatures::merge_vertices(bool is_one_mesh, std::vector<Stencil>& out) {
  const auto is_pair = [](const Stencil& its) { return its.kind == StencilKind::vertex_vertex; };
  if (std::ranges::none_of(out, is_pair)) {
    return;
  }
  for (Stencil& its : out) {
    if (is_one_mesh && is_pair(its) && its.element_b < its.element_a) {
      std::swap(its.element_a, its.element_b);
      its.vertices = {its.element_a, its.element_b, its.element_b, its.element_b};
      its.normal = -its.normal;
    }
  }
  const auto order_of = [](const Stencil& its) {
    const bool is_of_b = its.of_a > 1;
    return std::tuple(is_of_b, is_of_b ? its.element_b : its.element_a, its.distance, its.kind,
                      is_of_b ? its.element_a : its.element_b);
  };
  std::ranges::sort(out, [&](const Stencil& x, const Stencil& y) { return order_of(x) < order_of(y); });
  const auto same = [&](const Stencil& x, const Stencil& y) { return is_pair(x) && order_of(x) == order_of(y); };
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
}

void ClosestFeatures::tell_edges(const ElementBody& a, const ElementBody& b, const ClosestOptions& options,
                                 std::vector<Stencil>& out) {
  if ((kinds_of(options) & bit(StencilKind::edge_edge)) == 0) {
    return;
  }
  for (const EdgeStencil& its : edges_) {
    if (!(rule_of(options).has_cones && !is_minimum(its, a, b, options.cones))) {
      out.push_back(told(its, a, b));
    }
  }
}

void ClosestFeatures::find(ElementBody& a, ElementBody& b, const ClosestOptions& options, const Workers& workers,
                           std::vector<Stencil>& out) {
  out.clear();
  search_.begin(a, b, options.reach, workers);
  collect(a, b, options, workers);
  group(0, a.start().size());
  group(1, b.start().size());
  gather_edges();
  if (rule_of(options).is_of_faces) {
    keep_least_of_faces(a, b);
  }
  tell_vertices(0, a, b, options, workers, out);
  if (&a != &b) {
    tell_vertices(1, b, a, options, workers, out);
  }
  merge_vertices(&a == &b, out);
  tell_edges(a, b, options, out);
}

std::size_t ClosestFeatures::bytes() const {
  std::size_t sum = found_.capacity() * sizeof(Found) + edges_.capacity() * sizeof(EdgeStencil) + least_.bytes();
  for (const Found& its : found_) {
    sum += (its.of_vertices[0].capacity() + its.of_vertices[1].capacity()) * sizeof(FaceStencil) +
           its.edges.capacity() * sizeof(EdgeStencil) + its.stencils.capacity() * sizeof(Stencil);
  }
  for (const Grouped& its : grouped_) {
    sum += its.stencils.capacity() * sizeof(FaceStencil) + its.firsts.capacity() * sizeof(std::uint32_t);
  }
  return sum;
}

}  // namespace abut
