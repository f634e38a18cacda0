// SPDX-License-Identifier: Apache-2.0
// Support points of a hull scan all vertices, four at a time, up to 48 vertices. Above that, directions are sorted into
// 384 cells of a cube, and each cell lists the vertices that can be extreme in it. The lists are groups of four; most
// cells have one group.
module abut.shapes.hull.data;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

void number_edges(HullData& hull) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  hull.face_edges.resize(hull.face_vertices.size());
  for (const HullFace& face : hull.faces) {
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const std::uint32_t from = hull.face_vertices[face.first + i];
      const std::uint32_t to = hull.face_vertices[face.first + (i + 1) % face.count];
      const auto key = std::minmax(from, to);
      hull.face_edges[face.first + i] =
          numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
    }
  }
}

void list_faces_at_vertices(HullData& hull) {
  hull.first_face.assign(hull.vertices.size() + 1, 0);
  for (const std::uint32_t vertex : hull.face_vertices) {
    ++hull.first_face[vertex + 1];
  }
  for (std::size_t i = 1; i < hull.first_face.size(); ++i) {
    hull.first_face[i] += hull.first_face[i - 1];
  }
  std::vector<std::uint32_t> next(hull.first_face.begin(), hull.first_face.end() - 1);
  hull.faces_at.resize(hull.face_vertices.size());
  hull.next_at.resize(hull.face_vertices.size());
  for (std::uint32_t face = 0; face < hull.faces.size(); ++face) {
    const auto vertices = std::span(hull.face_vertices).subspan(hull.faces[face].first, hull.faces[face].count);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::uint32_t place = next[vertices[i]]++;
      hull.faces_at[place] = face;
      hull.next_at[place] = vertices[(i + 1) % vertices.size()];
    }
  }
}

void fill_blocks(HullData& hull) {
  const std::size_t count = hull.vertices.size();
  hull.blocks.resize((count + 3) / 4);
  for (std::size_t i = 0; i < 4 * hull.blocks.size(); ++i) {
    const Vec3& p = hull.vertices[std::min(i, count - 1)];
    HullData::Block& block = hull.blocks[i / 4];
    block.x[i % 4] = p.x;
    block.y[i % 4] = p.y;
    block.z[i % 4] = p.z;
  }
}

// The corner directions of the square of `width` cells on a side that begins at a row and a column.
std::array<Vec3, 4> corners_of_cells(std::size_t side, std::size_t row, std::size_t column, std::size_t width) {
  constexpr auto cells = static_cast<Real>(HullData::cells_per_side);
  std::array<Vec3, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Real u = 2 * static_cast<Real>(column + (i & 1) * width) / cells - 1;
    const Real v = 2 * static_cast<Real>(row + (i >> 1) * width) / cells - 1;
    const Real main = side % 2 == 0 ? -1 : 1;
    corners[i] = side / 2 == 0 ? Vec3{main, u, v} : side / 2 == 1 ? Vec3{u, main, v} : Vec3{u, v, main};
  }
  return corners;
}

// Which vertices can be extreme for some direction of a cell. A cell is the cone of its four corner directions. So a
// vertex that another one beats at all four corners is beaten in the whole cell: what is left after such eliminations
// is certain to hold the support point. `among`: the vertices to choose from, those of a larger cell around.
std::vector<std::uint32_t> candidates_of(const HullData& hull, std::span<const std::uint32_t> among,
                                         const std::array<Vec3, 4>& corners) {
  const auto values_of = [&](const Vec3& p) {
    return std::array<Real, 4>{dot(p, corners[0]), dot(p, corners[1]), dot(p, corners[2]), dot(p, corners[3])};
  };
  const auto beats = [](const std::array<Real, 4>& a, const std::array<Real, 4>& b) {
    return a[0] > b[0] && a[1] > b[1] && a[2] > b[2] && a[3] > b[3];
  };
  // The extreme vertices of the corners and the middle beat nearly all others.
  std::vector<std::array<Real, 4>> strong;
  const Vec3 middle = corners[0] + corners[1] + corners[2] + corners[3];
  for (const Vec3& direction : {corners[0], corners[1], corners[2], corners[3], middle}) {
    const auto top = std::max_element(among.begin(), among.end(), [&](std::uint32_t a, std::uint32_t b) {
      return dot(hull.vertices[a], direction) < dot(hull.vertices[b], direction);
    });
    strong.push_back(values_of(hull.vertices[*top]));
  }
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t i : among) {
    const auto values = values_of(hull.vertices[i]);
    if (std::none_of(strong.begin(), strong.end(), [&](const auto& other) { return beats(other, values); })) {
      kept.push_back(i);
    }
  }
  return kept;
}

using CellLists = std::vector<std::vector<std::uint32_t>>;

// From coarse to fine: what is beaten in a square of cells need not be looked at in its quarters.
void list_cells_within(const HullData& hull, std::span<const std::uint32_t> among, std::size_t side, std::size_t row,
                       std::size_t column, std::size_t width, CellLists& lists) {
  const auto candidates = candidates_of(hull, among, corners_of_cells(side, row, column, width));
  if (width == 1) {
    lists[(side * HullData::cells_per_side + row) * HullData::cells_per_side + column] = candidates;
    return;
  }
  const std::size_t half = width / 2;
  for (const std::size_t down : {std::size_t{0}, half}) {
    for (const std::size_t right : {std::size_t{0}, half}) {
      list_cells_within(hull, candidates, side, row + down, column + right, half, lists);
    }
  }
}

void list_cells(HullData& hull) {
  CellLists lists(6 * HullData::cells_per_side * HullData::cells_per_side);
  std::vector<std::uint32_t> all(hull.vertices.size());
  std::iota(all.begin(), all.end(), 0u);
  for (std::size_t side = 0; side < 6; ++side) {
    list_cells_within(hull, all, side, 0, 0, HullData::cells_per_side, lists);
  }
  for (const auto& list : lists) {
    hull.first_candidates.push_back(static_cast<std::uint32_t>(hull.candidates.size()));
    for (std::size_t i = 0; i < list.size(); i += 4) {
      const auto at = [&](std::size_t place) { return list[std::min(i + place, list.size() - 1)]; };
      hull.candidates.push_back({at(0), at(1), at(2), at(3)});
    }
  }
  hull.first_candidates.push_back(static_cast<std::uint32_t>(hull.candidates.size()));
}

// Each vertex the one that is furthest from all before it. Returns where among the points each vertex is.
std::vector<std::uint32_t> list_points(HullData& hull) {
  std::vector<Lanes>& points = hull.facets.points;
  for (const Vec3& p : hull.vertices) {
    points.push_back(lanes_of(p));
  }
  std::vector<std::uint32_t> vertices(points.size()), places(points.size());
  std::iota(vertices.begin(), vertices.end(), 0u);
  constexpr std::size_t limit = 256;
  std::vector<Real> gaps(points.size(), infinity);
  for (std::size_t i = 1; points.size() <= limit && i < points.size(); ++i) {
    for (std::size_t j = i; j < points.size(); ++j) {
      const Lanes gap = points[j] - points[i - 1];
      gaps[j] = std::min(gaps[j], dot(gap, gap));
    }
    const auto rest = gaps.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t furthest = i + static_cast<std::size_t>(std::max_element(rest, gaps.end()) - rest);
    std::swap(points[i], points[furthest]);
    std::swap(gaps[i], gaps[furthest]);
    std::swap(vertices[i], vertices[furthest]);
  }
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    places[vertices[i]] = i;
  }
  return places;
}

// Faces in an order in which each four look nearly the same way, and so can be passed over together. Polytopes with
// more faces than a few hundred are not tried axis by axis.
std::vector<std::uint32_t> faces_by_direction(const HullData& hull) {
  std::vector<std::uint32_t> order(hull.faces.size());
  std::iota(order.begin(), order.end(), 0u);
  constexpr std::size_t limit = 2048;
  for (std::size_t i = 0; order.size() <= limit && i < order.size(); ++i) {
    if (i % 4 != 0) {
      const Vec3& first = hull.faces[order[i - i % 4]].normal;
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(i);
      std::iter_swap(begin, std::max_element(begin, order.end(), [&](std::uint32_t a, std::uint32_t b) {
                       return dot(hull.faces[a].normal, first) < dot(hull.faces[b].normal, first);
                     }));
    }
  }
  return order;
}

void list_planes(HullData& hull, std::span<const std::uint32_t> order) {
  HullFacets& facets = hull.facets;
  for (const Vec3& p : hull.vertices) {
    facets.middle += (1 / static_cast<Real>(hull.vertices.size())) * p;
  }
  // No ball fits between the two sides of a polygon, whose planes may leave rounding between them.
  facets.inner = order.size() > 2 ? infinity : 0;
  facets.planes.resize((order.size() + 3) / 4);
  facets.faces.assign(order.begin(), order.end());
  facets.faces.resize(4 * facets.planes.size(), order.empty() ? 0 : order.back());
  for (std::size_t i = 0; i < 4 * facets.planes.size(); ++i) {
    const HullFace& face = hull.faces[order[std::min(i, order.size() - 1)]];
    HullFacets::Planes& planes = facets.planes[i / 4];
    planes.x[i % 4] = face.normal.x;
    planes.y[i % 4] = face.normal.y;
    planes.z[i % 4] = face.normal.z;
    // Rounding, or faces that were merged, may leave another vertex outside of the plane.
    const Real reach = std::max(face.offset, dot(face.normal, hull.support(face.normal).point));
    planes.reach[i % 4] = reach;
    facets.inner = std::max(Real{0}, std::min(facets.inner, reach - dot(face.normal, facets.middle)));
    for (const std::uint32_t vertex : std::span(hull.face_vertices).subspan(face.first, face.count)) {
      facets.flatness = std::max(facets.flatness, reach - dot(face.normal, hull.vertices[vertex]));
    }
  }
}

// `order` of the faces; `points`: where the vertices are.
void list_lines(HullData& hull, std::span<const std::uint32_t> order, std::span<const std::uint32_t> points) {
  std::vector<std::uint32_t> places(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    places[order[i]] = i;
  }
  HullFacets& facets = hull.facets;
  std::vector<HullFacets::Sides>& sides = facets.sides;
  for (std::uint32_t index = 0; index < hull.faces.size(); ++index) {
    const HullFace& face = hull.faces[index];
    for (std::uint32_t i = 0; i < face.count; ++i) {
      // Edges were numbered in the order in which they come here.
      const std::size_t edge = hull.face_edges[face.first + i];
      if (edge == sides.size()) {
        const std::uint32_t first = hull.face_vertices[face.first + i];
        const std::uint32_t last = hull.face_vertices[face.first + (i + 1 < face.count ? i + 1 : 0)];
        const Vec3 &from = hull.vertices[first], &to = hull.vertices[last];
        facets.lines.push_back({lanes_of(from), lanes_of(to - from)});
        facets.ends.push_back({points[first], points[last]});
        sides.push_back({places[index], no_index});
      } else {
        sides[edge].right = places[index];
      }
    }
  }
  // Faces without area were left out, and their edges have a side too few.
  facets.is_closed =
      !sides.empty() && std::none_of(sides.begin(), sides.end(), [](const auto& at) { return at.right == no_index; });
  facets.arcs.resize(facets.is_closed ? (sides.size() + 3) / 4 : 0);
  for (std::size_t i = 0; i < 4 * facets.arcs.size(); ++i) {
    const HullFacets::Sides& at = sides[std::min(i, sides.size() - 1)];
    const Vec3& left = hull.faces[order[at.left]].normal;
    const Vec3& right = i < sides.size() ? hull.faces[order[at.right]].normal : left;
    HullFacets::Arcs& arcs = facets.arcs[i / 4];
    arcs.left_x[i % 4] = left.x;
    arcs.left_y[i % 4] = left.y;
    arcs.left_z[i % 4] = left.z;
    arcs.right_x[i % 4] = right.x;
    arcs.right_y[i % 4] = right.y;
    arcs.right_z[i % 4] = right.z;
    const Lanes& from = facets.lines[std::min(i, sides.size() - 1)].from;
    arcs.from_x[i % 4] = from.x;
    arcs.from_y[i % 4] = from.y;
    arcs.from_z[i % 4] = from.z;
  }
}

}  // namespace

void finish_hull(HullData& hull) {
  Aabb box = Aabb::empty();
  for (const Vec3& p : hull.vertices) {
    box.include(p);
  }
  hull.low = box.low;
  hull.high = box.high;
  hull.centre = 0.5 * box.low + 0.5 * box.high;
  hull.extent = largest_magnitude(0.5 * box.high - 0.5 * box.low);
  number_edges(hull);
  list_faces_at_vertices(hull);
  fill_blocks(hull);
  if (hull.vertices.size() > HullData::scan_limit) {
    list_cells(hull);
  }
  const std::vector<std::uint32_t> points = list_points(hull);
  const std::vector<std::uint32_t> order = faces_by_direction(hull);
  list_planes(hull, order);
  list_lines(hull, order, points);
}

}  // namespace abut
