// SPDX-License-Identifier: Apache-2.0
module abut.narrow.points.small_polygons;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.points.clip;
import abut.narrow.points.lane_contact;
import abut.narrow.points.lift;

namespace abut {
namespace {

[[nodiscard]] inline Lanes next(Lanes corners) { return __builtin_shufflevector(corners, corners, 1, 2, 3, 0); }
[[nodiscard]] inline std::uint64_t next(std::uint64_t bits) { return (bits >> 1 | bits << 3) & 15u; }

// A polygon in the plane across the normal, a corner a lane. The last corner of a triangle stands twice, with an edge
// without length between, which every point is to the left of.
struct Polygon {
  Lanes u, v, height;
  Lanes along_u, along_v;  // from each corner to the next one, with the polygon to the left
  Real slope_u, slope_v;   // of its plane
  bool is_plane;           // whether all corners are in that plane

  Polygon(const FewCorners& face, const Projection& projection) {
    const auto& [base, tangents, normal, tie] = projection;
    const Columns from_base = face.at - Columns::all(base);
    u = dot(from_base, Columns::all(tangents.first));
    v = dot(from_base, Columns::all(tangents.second));
    height = dot(from_base, Columns::all(normal));
    const Real facing = dot(face.normal, normal), turn = std::copysign(1.0, facing);
    along_u = turn * (next(u) - u);
    along_v = turn * (next(v) - v);
    slope_u = -dot(face.normal, tangents.first) / facing;
    slope_v = -dot(face.normal, tangents.second) / facing;
    const Lanes off = height - height[0] - slope_u * (u - u[0]) - slope_v * (v - v[0]);
    is_plane = largest(absolute(off)) <= tie;
  }
  [[nodiscard]] Real height_at(Real at_u, Real at_v) const {
    return height[0] + slope_u * (at_u - u[0]) + slope_v * (at_v - v[0]);
  }
};

// On which sides of the lines of one polygon's edges the corners of another one are.
struct Sides {
  std::array<Lanes, 4> left;  // of each line: how far to the left each corner is, times the length of the edge
  std::uint64_t inside = 15;  // the corners that are to the left of all lines
  std::uint64_t crossed = 0;  // four bits for each line: the edges that it crosses, each named by its first corner
  bool are_clear;

  Sides(const Polygon& lines, const Polygon& corners, Real doubt) {
    const Lanes least = doubt * (absolute(lines.along_u) + absolute(lines.along_v));
    LaneNumbers clear = all_lanes(0) == all_lanes(0);
    for (std::size_t i = 0; i < 4; ++i) {
      left[i] = lines.along_u[i] * (corners.v - lines.v[i]) - lines.along_v[i] * (corners.u - lines.u[i]);
      const std::uint64_t right = signs_of(left[i]);
      inside &= ~right;
      crossed |= (right ^ next(right)) << (4 * i);
      clear &= absolute(left[i]) >= all_lanes(least[i]);
    }
    are_clear = bits_of(clear) == 15;
  }
};

// Rows and columns of four by four bits exchanged, two by two and then in blocks of that.
[[nodiscard]] inline std::uint64_t transposed(std::uint64_t bits) {
  const std::uint64_t single = (bits ^ bits >> 3) & 0x0a0a;
  bits ^= single ^ single << 3;
  const std::uint64_t block = (bits ^ bits >> 6) & 0x00cc;
  return bits ^ block ^ block << 6;
}

// The corners of a region: their feet in the plane across the normal, and the heights of both polygons over these.
// There is room for all corners of both polygons and for every crossing of two edges.
struct RegionCorners {
  struct Corner {
    Lanes foot;
    Real height_a, height_b;
    Feature of_a, of_b;
  };
  std::array<Corner, 24> all;
  std::size_t count;

  [[nodiscard]] std::span<const Corner> span() const [[clang::lifetimebound]] { return std::span(all).first(count); }
};

// What a polygon is at a corner of the region: its own corner or its face there, or its edge where two edges cross.
[[nodiscard]] inline Feature feature_there(const FewCorners& polygon, std::size_t number, bool is_own,
                                           bool is_crossing) {
  const FeatureKind kind = is_crossing ? FeatureKind::edge : (is_own ? FeatureKind::vertex : FeatureKind::face);
  const std::uint32_t at_corner = is_own ? polygon.vertices[number] : polygon.index;
  return {kind, is_crossing ? polygon.edges[number] : at_corner};
}

// False, with nothing found, where there is doubt.
[[nodiscard]] bool find_region(const FewCorners& a, const FewCorners& b, const Projection& projection,
                               RegionCorners& out) {
  out.count = 0;
  const Polygon of_a(a, projection), of_b(b, projection);
  const Real doubt = 4 * projection.tie;
  const Sides beside_a(of_a, of_b, doubt), beside_b(of_b, of_a, doubt);
  if (!(of_a.is_plane && of_b.is_plane && beside_a.are_clear && beside_b.are_clear)) {
    return false;
  }
  // A bit for each corner of b, then of a, then for each pair of edges that cross. The last corner of a triangle stands
  // twice, and counts once. One loop takes all, as the processor guesses where a loop ends.
  const auto counted = [](const FewCorners& of) { return of.vertices[3] == of.vertices[2] ? 7u : 15u; };
  std::uint64_t region = (beside_a.inside & counted(b)) | (beside_b.inside & counted(a)) << 4 |
                         (beside_a.crossed & transposed(beside_b.crossed)) << 8;
  const Lanes first = lanes_of(projection.tangents.first), second = lanes_of(projection.tangents.second),
              base = lanes_of(projection.base);
  for (; region != 0; region &= region - 1) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(region));
    const std::size_t group = bit / 4, j = bit % 4, end = (j + 1) % 4;
    const bool is_of_a = group == 1, is_crossing = group > 1;
    const std::size_t i = is_crossing ? group - 2 : j;
    const Polygon& of = is_of_a ? of_a : of_b;
    const Real from = beside_a.left[i][j], t = is_crossing ? from / (from - beside_a.left[i][end]) : 0;
    const Real u = of.u[j] + t * (of.u[end] - of.u[j]), v = of.v[j] + t * (of.v[end] - of.v[j]);
    out.all[out.count++] = {base + u * first + v * second, of_a.height_at(u, v), of_b.height_at(u, v),
                            feature_there(a, i, is_of_a, is_crossing), feature_there(b, j, !is_of_a, is_crossing)};
  }
  return true;
}

// Within which places of two faces tie: as those of any faces do.
[[nodiscard]] inline Real tie_of(const FewCorners& a, const FewCorners& b) {
  const auto reach_from = [](const Vec3& base, const FewCorners& face) {
    return largest(largest_magnitude(face.at - Columns::all(base)));
  };
  const Vec3 of_a = a.at[0], of_b = b.at[0];
  return tie_of_sizes(reach_from(of_a, a), reach_from(of_b, b), of_a, of_b);
}

}  // namespace

bool clip_small_polygons(const FewCorners& a, const FewCorners& b, const Projection& projection, ClipPoints& out) {
  [[clang::uninitialized]] RegionCorners region;
  const bool is_clear = find_region(a, b, projection, region);
  const Lanes normal = lanes_of(projection.normal);
  for (const auto& corner : region.span()) {
    out.push_back({vec3_of(corner.foot + corner.height_a * normal), vec3_of(corner.foot + corner.height_b * normal),
                   corner.of_a, corner.of_b});
  }
  return is_clear;
}

std::optional<Real> append_contacts_of(const FewCorners& a, const FewCorners& b, const ContactsWanted& wanted,
                                       Manifold& out) {
  const auto& [normal, deepest, radius_a, radius_b, margin, blur, closest_count] = wanted;
  const auto is_steep = [&](const FewCorners& face) {
    return !(std::fabs(dot(face.normal, normal)) > steepest_cosine);
  };
  if (is_steep(a) || is_steep(b)) {
    return std::nullopt;
  }
  const Real tie = tie_of(a, b);
  const std::size_t first = out.size();
  [[clang::uninitialized]] RegionCorners region;
  if (!find_region(a, b, {a.at[0], tangents_of(normal), normal, tie}, region)) {
    return std::nullopt;
  }
  const Lanes along = lanes_of(normal);
  Real least_of_cores = infinity, least = infinity;
  for (const auto& corner : region.span()) {
    const Lanes point_a = corner.foot + corner.height_a * along, point_b = corner.foot + corner.height_b * along;
    const Real of_cores = dot(vec3_of(point_b - point_a), normal), distance = of_cores - (radius_a + radius_b);
    least_of_cores = std::fmin(least_of_cores, of_cores);
    if (distance <= margin) {
      least = std::fmin(least, distance);
      append_contact({point_a + radius_a * along, point_b - radius_b * along, along, distance, corner.of_a, corner.of_b,
                      contact_id(corner.of_a, corner.of_b)},
                     out);
    }
  }
  const Real rounding = noise_of(std::fmax(largest(largest_magnitude(a.at)), largest(largest_magnitude(b.at))));
  const Columns normals = Columns::all(normal);
  const Real closest = -largest(-dot(b.at, normals)) - largest(dot(a.at, normals));
  // Corners that are too close, and closest points that the region misses, take a longer look.
  if (least_of_cores < closest - rounding ||
      (closest_count && (least_of_cores > closest + rounding + tie || least > deepest + blur))) {
    out.erase(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
    return std::nullopt;
  }
  return least;
}

}  // namespace abut
