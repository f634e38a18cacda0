// SPDX-License-Identifier: Apache-2.0
// What became of the points that a hull was given, and how far outside of it the worst of them lies.
module abut.shapes.hull.data;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

// A point that is behind all planes of a hull is in it.
struct Planes {
  struct Four {
    Lanes x, y, z, offset;
  };
  std::vector<Four> fours;  // the last four are filled up with copies of the last plane
  std::size_t count = 0;
  Vec3 middle{};
  Real inner = 0;  // a ball of this radius about the middle is behind all planes; never negative

  void add(const Vec3& normal, Real offset) {
    if (count % 4 == 0) {
      fours.push_back({normal.x, normal.y, normal.z, offset});
    }
    Four& last = fours.back();
    for (std::size_t i = count % 4; i < 4; ++i) {
      last.x[i] = normal.x;
      last.y[i] = normal.y;
      last.z[i] = normal.z;
      last.offset[i] = offset;
    }
    ++count;
    inner = std::max(Real{0}, std::min(inner, offset - dot(normal, middle)));
  }
  [[nodiscard]] Real height_above(const Vec3& p) const {
    Lanes top = all_lanes(-infinity);
    for (const Four& four : fours) {
      top = maximum(top, multiply_add(four.z, p.z, multiply_add(four.y, p.y, multiply_add(four.x, p.x, -four.offset))));
    }
    return largest(top);
  }
};

struct Heights {
  Real low, high;
};

// Qhull may merge faces: the vertices of one are about in a plane.
Heights heights_of(const HullData& hull, const HullFace& face) {
  Heights heights{infinity, -infinity};
  for (const std::uint32_t vertex : std::span(hull.face_vertices).subspan(face.first, face.count)) {
    const Real height = dot(face.normal, hull.vertices[vertex]);
    heights = {std::min(heights.low, height), std::max(heights.high, height)};
  }
  return heights;
}

// Calls with both ends of each edge of a face, counter-clockwise seen from outside.
template <class Visit>
void for_each_edge(const HullData& hull, const HullFace& face, Visit visit) {
  for (std::uint32_t i = 0; i < face.count; ++i) {
    visit(hull.vertices[hull.face_vertices[face.first + i]],
          hull.vertices[hull.face_vertices[face.first + (i + 1 < face.count ? i + 1 : 0)]]);
  }
}

Planes planes_of(const HullData& hull) {
  Planes planes;
  planes.inner = hull.faces.empty() ? 0 : infinity;
  for (const Vec3& p : hull.vertices) {
    planes.middle += (1 / static_cast<Real>(hull.vertices.size())) * p;
  }
  for (const HullFace& face : hull.faces) {
    planes.add(face.normal, heights_of(hull, face).low);
  }
  // A polygon ends at its edges.
  if (hull.faces.size() == 2) {
    for_each_edge(hull, hull.faces[0], [&](const Vec3& from, const Vec3& to) {
      if (const auto outward = UnitVec3::make(cross(to - from, hull.faces[0].normal))) {
        planes.add(*outward, std::min(dot(outward->vec(), from), dot(outward->vec(), to)));
      }
    });
  }
  return planes;
}

Real distance_to_segment(const Vec3& from, const Vec3& to, const Vec3& p) {
  const auto direction = UnitVec3::make(to - from);
  if (!direction) {
    return norm(p - from);
  }
  const Real along = std::clamp(dot(p - from, direction->vec()), Real{0}, norm(to - from));
  return norm(p - from - along * direction->vec());
}

Real distance_to_face(const HullData& hull, const HullFace& face, const Vec3& p) {
  Real nearest = infinity;
  bool is_above = true;
  for_each_edge(hull, face, [&](const Vec3& from, const Vec3& to) {
    is_above = is_above && dot(face.normal, cross(to - from, p - from)) >= 0;
    nearest = std::min(nearest, distance_to_segment(from, to, p));
  });
  if (!is_above) {
    return nearest;
  }
  const Heights heights = heights_of(hull, face);
  const Real height = dot(face.normal, p);
  return std::max(std::fabs(height - heights.low), std::fabs(height - heights.high));
}

// From a point that is not inside to the nearest face. What is not above `enough` may be more than the distance.
Real distance_to_hull(const HullData& hull, const Vec3& p, Real enough) {
  if (hull.faces.empty()) {
    return distance_to_segment(hull.vertices.front(), hull.vertices.back(), p);
  }
  Real nearest = infinity;
  for (const HullFace& face : hull.faces) {
    if (std::fabs(dot(face.normal, p) - face.offset) < nearest) {
      nearest = std::min(nearest, distance_to_face(hull, face, p));
    }
    if (nearest <= enough) {
      break;
    }
  }
  return nearest;
}

// Most points are vertices or well inside, which is decided at once.
Real error_of(const HullData& hull, std::span<const Vec3> points, Real noise) {
  const auto comes_before = [](const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  std::vector<Vec3> vertices = hull.vertices;
  std::sort(vertices.begin(), vertices.end(), comes_before);
  const Planes planes = planes_of(hull);
  Real error = 0;
  for (const Vec3& p : points) {
    if (squared_norm(p - planes.middle) < planes.inner * planes.inner) {
      continue;
    }
    if (std::binary_search(vertices.begin(), vertices.end(), p, comes_before)) {
      continue;
    }
    if (planes.count != 0 && planes.height_above(p) <= noise) {
      continue;
    }
    const Real distance = distance_to_hull(hull, p, std::max(error, noise));
    if (distance > noise) {
      error = std::max(error, distance);
    }
  }
  return error;
}

}  // namespace

HullReport report_on(const HullData& hull, std::span<const Vec3> points, Real noise) {
  const std::size_t vertices = hull.vertices.size(), faces = hull.faces.size();
  // Edges were numbered one after the other.
  const auto last_edge = std::max_element(hull.face_edges.begin(), hull.face_edges.end());
  const std::size_t edges = last_edge != hull.face_edges.end() ? *last_edge + std::size_t{1} : vertices == 2 ? 1 : 0;
  const std::size_t dimension = faces > 2 ? 3 : std::min<std::size_t>(vertices - 1, 2);
  return {static_cast<std::uint32_t>(dimension), points.size(), vertices, edges, faces, error_of(hull, points, noise)};
}

}  // namespace abut
