// SPDX-License-Identifier: Apache-2.0
// The closest points of a triangle and a segment that it does not pierce: on an edge, all three side by side, or an end
// of the segment over the face. Source: Ericson, "Real-Time Collision Detection", 2005, 5.1.9 and 5.1.10.
//
// A segment that pierces the triangle is separated along a separating axis instead. A segment without radius could pass
// between two triangles by rounding and touch neither; it counts as touching what is within rounding.
export module abut.narrow.triangle.triangle_segment;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.apart.box_cores;
import abut.narrow.triangle.triangle_point;

export namespace abut {

// Squares of sines of lines that tell their common perpendicular better than their points do.
inline constexpr Real skew_square = 1e-4;

// The segment `centre` +- half_length * axis, the axis of length one. Of a pierced triangle the gap is as large as the
// distance, which proves nothing.
[[nodiscard]] inline NearPoints near_points_of_segment(const TriangleCorners& corners, const Vec3& centre,
                                                       const Vec3& axis, Real half_length) {
  const Lanes a = lanes_of(corners[0]), b = lanes_of(corners[1]), c = lanes_of(corners[2]);
  const Columns from = Columns::of(a, b, c, a), edge = Columns::of(b, c, a, b) - from;
  const Columns along = Columns::all(axis), middle = Columns::all(centre), to_middle = middle - from;
  const Lanes half = all_lanes(half_length), zero = all_lanes(0), one = all_lanes(1);

  // Between the lines, then each point under the other one. Any start will do where they are parallel, and any point
  // of an edge of no length. Products of vectors keep what squares of cosines lose where lines are nearly parallel.
  const Columns across = cross(along, edge);
  const Lanes cosine = dot(along, edge), square = dot(edge, edge), of_axis = dot(along, to_middle),
              of_edge = dot(edge, to_middle), sine = dot(across, across);
  const Lanes start = sine > zero ? clamp(dot(cross(edge, to_middle), across) / sine, half) : zero;
  const Lanes t = square > zero ? minimum(maximum((of_edge + start * cosine) / square, zero), one) : zero;
  const Lanes s = clamp(t * cosine - of_axis, half);
  const Columns on_edge = from + t * edge, on_segment = middle + s * along, apart = on_segment - on_edge;
  const Lanes apart_square = dot(apart, apart);
  std::size_t lane = apart_square[1] < apart_square[0] ? 1 : 0;
  lane = apart_square[2] < apart_square[lane] ? 2 : lane;
  Vec3 on_a = on_edge[lane], on_b = on_segment[lane], between = apart[lane];
  Real least = apart_square[lane], at = s[lane];
  // The direction of a short way has the rounding of its ends. It is perpendicular to what they lie within.
  const Vec3 along_edge = edge[lane];
  const bool is_within_edge = t[lane] > 0 && t[lane] < 1, is_within = std::fabs(at) < half_length;
  if (is_within_edge && is_within && sine[lane] > skew_square * square[lane]) {
    between = (dot(across[lane], between) / sine[lane]) * across[lane];
  } else {
    between = is_within_edge ? between - (dot(between, along_edge) / square[lane]) * along_edge : between;
    between = is_within ? between - dot(between, axis) * axis : between;
  }

  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Real normal_square = squared_norm(normal);
  const Columns inward = cross(Columns::all(normal), edge);
  for (const Real end : {-half_length, half_length}) {
    const Vec3 point = centre + end * axis;
    const Real height = dot(normal, point - corners[0]);
    // Squares of heights over the length of the normal.
    if (height * height < least * normal_square && bits_of(dot(inward, Columns::all(point) - from) < zero) == 0) {
      between = (height / normal_square) * normal;
      on_a = point - between;
      on_b = point;
      least = height * height / normal_square;
      at = end;
    }
  }

  const Real slope = dot(axis, between);
  const Real beyond = half_length * std::fabs(slope) + slope * at;
  return {lanes_of(on_a),
          lanes_of(on_b),
          lanes_of(between),
          squared_norm(between),
          gap_beyond(corners, on_a, between) + beyond,
          1};
}

}  // namespace abut
