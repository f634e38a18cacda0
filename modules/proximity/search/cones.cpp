// SPDX-License-Identifier: Apache-2.0
module abut.proximity.search.cones;
import abut.core.standard;
import abut.math;
import abut.proximity.body;
import abut.triangles.elements;

namespace abut {
namespace {

// Cosines that rounding may have made of zero.
constexpr Real slack = 1e-9;

[[nodiscard]] Vec3 unit_or_zero(const Vec3& vector) {
  const auto unit = UnitVec3::make(vector);
  return unit ? unit->vec() : Vec3{0, 0, 0};
}
[[nodiscard]] Vec3 normal_of(const ElementBody& body, std::uint32_t face) {
  const std::array<Vec3, 3> corners = corners_at(body.start(), body.corners_of(face));
  return unit_or_zero(cross(corners[1] - corners[0], corners[2] - corners[0]));
}
// On the side of a way, whatever the winding of faces; with their winding where only fronts count.
[[nodiscard]] Vec3 mean_normal(const ElementBody& body, std::span<const std::uint32_t> faces, const Vec3& way,
                               const ConeOptions& options) {
  Vec3 sum{0, 0, 0};
  for (const std::uint32_t face : faces) {
    const Vec3 normal = normal_of(body, face);
    sum += !options.is_front_only && dot(normal, way) < 0 ? -normal : normal;
  }
  return unit_or_zero(sum);
}

// `side`: a unit vector out of what lies beside the feature.
[[nodiscard]] bool is_in_cone(const Vec3& side, const Vec3& normal, const Vec3& way, const ConeOptions& options) {
  const Real widening = std::max(Real{0}, dot(normal, side) * options.factor) + options.angle;
  return dot(side, way) >= -widening - slack;
}
[[nodiscard]] bool is_in_front(const Vec3& normal, const Vec3& way, const ConeOptions& options) {
  return !options.is_front_only || dot(normal, way) >= -options.angle - slack;
}

// Out of a face beside an edge, at right angles to the edge.
[[nodiscard]] Vec3 side_beyond(const std::array<Vec3, 2>& ends, const Vec3& across) {
  const Vec3 along = unit_or_zero(ends[1] - ends[0]), out = ends[0] - across;
  return unit_or_zero(out - dot(out, along) * along);
}

}  // namespace

bool is_minimum_of_vertex(const ElementBody& body, std::uint32_t vertex, const Vec3& way, const ConeOptions& options) {
  const std::span<const Vec3> places = body.start();
  const std::span<const std::uint32_t> faces = body.faces_around_vertices().of(vertex);
  const Vec3 normal = mean_normal(body, faces, way, options);
  if (!is_in_front(normal, way, options)) {
    return false;
  }
  return std::ranges::all_of(body.table().edges_around(vertex), [&](std::uint32_t edge) {
    const EdgeEnds& ends = body.ends_of(edge);
    const Vec3 side = unit_or_zero(places[vertex] - places[ends[0] == vertex ? ends[1] : ends[0]]);
    return is_in_cone(side, normal, way, options);
  });
}

bool is_minimum_of_edge(const ElementBody& body, std::uint32_t edge, const Vec3& way, const ConeOptions& options) {
  const std::span<const Vec3> places = body.start();
  const std::array<Vec3, 2> ends = ends_at(places, body.ends_of(edge));
  const std::span<const std::uint32_t> across = body.table().corners_across(edge);
  if (across.empty()) {
    return std::fabs(dot(unit_or_zero(ends[1] - ends[0]), way)) <= options.angle + 1e-4;
  }
  const Vec3 normal = mean_normal(body, body.faces_around_edges().of(edge), way, options);
  if (!is_in_front(normal, way, options)) {
    return false;
  }
  return std::ranges::all_of(across, [&](std::uint32_t corner) {
    return is_in_cone(side_beyond(ends, places[corner]), normal, way, options);
  });
}

bool is_minimum_of_face(const ElementBody& body, std::uint32_t face, const Vec3& way, const ConeOptions& options) {
  return is_in_front(normal_of(body, face), way, options);
}

bool is_ridge(const ElementBody& body, std::uint32_t edge) {
  const std::span<const std::uint32_t> across = body.table().corners_across(edge);
  if (across.size() != 2) {
    return true;
  }
  const std::array<Vec3, 2> ends = ends_at(body.start(), body.ends_of(edge));
  const Vec3 first = side_beyond(ends, body.start()[across[0]]), second = side_beyond(ends, body.start()[across[1]]);
  return squared_norm(first + second) > slack * slack;
}

}  // namespace abut
