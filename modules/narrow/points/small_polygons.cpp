// SPDX-License-Identifier: Apache-2.0
module abut.narrow.points.small_polygons;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.points.clip;
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

  Polygon(const Face& face, const Projection& projection) {
    const auto& [base, tangents, normal, tie] = projection;
    const std::span<const FaceVertex> vertices = face.vertices.span();
    const auto corner = [&](std::size_t i) { return lanes_of(vertices[i].point); };
    const Columns from_base =
        Columns::of(corner(0), corner(1), corner(2), corner(vertices.size() - 1)) - Columns::all(base);
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
  bool are_clear = true;

  Sides(const Polygon& lines, const Polygon& corners, Real doubt) {
    const Lanes least = doubt * (absolute(lines.along_u) + absolute(lines.along_v));
    for (std::size_t i = 0; i < 4; ++i) {
      left[i] = lines.along_u[i] * (corners.v - lines.v[i]) - lines.along_v[i] * (corners.u - lines.u[i]);
      const std::uint64_t right = signs_of(left[i]);
      inside &= ~right;
      crossed |= (right ^ next(right)) << (4 * i);
      are_clear = are_clear && bits_of(absolute(left[i]) >= all_lanes(least[i])) == 15;
    }
  }
};

// Rows and columns of four by four bits exchanged, two by two and then in blocks of that.
[[nodiscard]] inline std::uint64_t transposed(std::uint64_t bits) {
  const std::uint64_t single = (bits ^ bits >> 3) & 0x0a0a;
  bits ^= single ^ single << 3;
  const std::uint64_t block = (bits ^ bits >> 6) & 0x00cc;
  return bits ^ block ^ block << 6;
}

}  // namespace

bool clip_small_polygons(const Face& a, const Face& b, const Projection& projection, ClipPoints& out) {
  const Polygon of_a(a, projection), of_b(b, projection);
  const Real doubt = 4 * projection.tie;
  const Sides beside_a(of_a, of_b, doubt), beside_b(of_b, of_a, doubt);
  if (!(of_a.is_plane && of_b.is_plane && beside_a.are_clear && beside_b.are_clear)) {
    return false;
  }
  const std::span<const FaceVertex> vertices_a = a.vertices.span(), vertices_b = b.vertices.span();
  const std::uint64_t corners_a = (1u << vertices_a.size()) - 1, corners_b = (1u << vertices_b.size()) - 1;
  // Four bits for corners of b, four for corners of a, and four for each edge of a: the edges of b that cross it. One
  // loop takes all, as the processor guesses where a loop ends.
  std::uint64_t region = (beside_a.inside & corners_b) | (beside_b.inside & corners_a) << 4 |
                         (beside_a.crossed & transposed(beside_b.crossed)) << 8;
  for (; region != 0; region &= region - 1) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(region));
    const std::size_t group = bit / 4, j = bit % 4, end = (j + 1) % 4;
    const bool is_of_b = group == 0, is_of_a = group == 1, is_crossing = group > 1;
    const std::size_t i = is_crossing ? group - 2 : 0;
    const Polygon& of = is_of_a ? of_a : of_b;
    const Real from = beside_a.left[i][j], t = is_crossing ? from / (from - beside_a.left[i][end]) : 0;
    const Real u = of.u[j] + t * (of.u[end] - of.u[j]), v = of.v[j] + t * (of.v[end] - of.v[j]);
    // The edge that closes a triangle is the last one of four here.
    const FaceVertex &vertex_a = vertices_a[std::min(is_crossing ? i : j, vertices_a.size() - 1)],
                     &vertex_b = vertices_b[std::min(j, vertices_b.size() - 1)];
    const Feature feature_a{is_of_b   ? FeatureKind::face
                            : is_of_a ? FeatureKind::vertex
                                      : FeatureKind::edge,
                            is_of_b   ? a.index
                            : is_of_a ? vertex_a.vertex
                                      : vertex_a.edge};
    const Feature feature_b{is_of_b   ? FeatureKind::vertex
                            : is_of_a ? FeatureKind::face
                                      : FeatureKind::edge,
                            is_of_b   ? vertex_b.vertex
                            : is_of_a ? b.index
                                      : vertex_b.edge};
    const Vec3 foot = projection.base + u * projection.tangents.first + v * projection.tangents.second;
    out.push_back({foot + of_a.height_at(u, v) * projection.normal, foot + of_b.height_at(u, v) * projection.normal,
                   feature_a, feature_b});
  }
  return true;
}

}  // namespace abut
