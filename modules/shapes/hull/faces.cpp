// SPDX-License-Identifier: Apache-2.0
// Hulls of which the faces are known.
module abut.shapes.hull.data;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;

namespace abut {
namespace {

Error bad_faces(std::string_view what) { return {Errc::invalid_argument, "faces of a hull: " + std::string(what)}; }

// How far a vertex may lie outside of a face, as a share of the size: faces of Qhull are merged within rounding.
constexpr Real slack = 1e-6;

// Whether each face has all vertices behind it, and each edge a face on either side.
bool is_hull(const HullData& hull) {
  const bool is_convex = std::ranges::all_of(hull.faces, [&](const HullFace& face) {
    return dot(face.normal, hull.support(face.normal).point) - face.offset <= slack * hull.extent;
  });
  return is_convex && (hull.faces.empty() || hull.facets.is_closed);
}

}  // namespace

void add_face(HullData& hull, std::span<const std::uint32_t> loop) {
  // Newell's normal, about the first vertex so that a face far from the origin loses no digits.
  Vec3 sum{0, 0, 0};
  const Vec3 base = hull.vertices[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += cross(hull.vertices[loop[i]] - base, hull.vertices[loop[i + 1]] - base);
  }
  const auto normal = UnitVec3::make(sum);
  if (!normal) {
    return;  // a face without area bounds nothing
  }
  Real offset = -infinity;
  for (const std::uint32_t vertex : loop) {
    offset = std::max(offset, dot(normal->vec(), hull.vertices[vertex]));
  }
  hull.faces.push_back({*normal, offset, static_cast<std::uint32_t>(hull.face_vertices.size()),
                        static_cast<std::uint32_t>(loop.size())});
  hull.face_vertices.insert(hull.face_vertices.end(), loop.begin(), loop.end());
}

std::vector<std::uint32_t> faces_of(const HullData& hull) {
  std::vector<std::uint32_t> faces;
  for (const HullFace& face : hull.faces) {
    faces.push_back(face.count);
    const auto corners = std::span(hull.face_vertices).subspan(face.first, face.count);
    faces.insert(faces.end(), corners.begin(), corners.end());
  }
  return faces.empty() ? std::vector<std::uint32_t>{0} : faces;
}

Result<HullData> hull_of_faces(std::span<const Vec3> vertices, std::span<const std::uint32_t> faces) {
  HullData hull;
  hull.vertices.assign(vertices.begin(), vertices.end());
  const bool has_faces = faces.size() != 1 || faces[0] != 0;
  if (!has_faces && vertices.size() > 2) {
    return bad_faces("there are none, but more than two vertices");
  }
  Real magnitude = 0;
  for (const Vec3& p : vertices) {
    magnitude = std::max(magnitude, largest_magnitude(p));
  }
  std::size_t added = 0;
  for (auto rest = has_faces ? faces : std::span<const std::uint32_t>(); !rest.empty(); ++added) {
    const std::size_t count = rest[0];
    if (count < 3 || count >= rest.size()) {
      return bad_faces("face " + std::to_string(added) + " has " + std::to_string(count) +
                       " corners; it must have at least 3, and as many as follow");
    }
    const auto loop = rest.subspan(1, count);
    if (std::ranges::any_of(loop, [&](std::uint32_t corner) { return corner >= vertices.size(); })) {
      return bad_faces("face " + std::to_string(added) + " has a corner that is no vertex");
    }
    add_face(hull, loop);
    rest = rest.subspan(1 + count);
  }
  if (hull.faces.size() != added) {
    return bad_faces("one of them has no area");
  }
  finish_hull(hull);
  if (!is_hull(hull)) {
    return bad_faces("they are not those of a convex solid");
  }
  hull.report = report_on(hull, vertices, rounding_of(magnitude));
  return hull;
}

}  // namespace abut
