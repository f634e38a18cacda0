// SPDX-License-Identifier: Apache-2.0
module abut.narrow.points.box_contacts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;

namespace abut {
namespace {

// At which ends of both axes the corners of a face are, counter-clockwise.
constexpr Lanes first_ends{-1, 1, 1, -1}, second_ends{-1, -1, 1, 1};
[[nodiscard]] inline std::size_t corner_at(Real first, Real second) {
  return second < 0 ? (first < 0 ? 0 : 1) : (first < 0 ? 3 : 2);
}

struct Side {
  int axis, first, second;  // the axis across the face, and those of its plane
  bool is_upper;
};
// The one that looks furthest along a direction, as the shape picks its face.
[[nodiscard]] inline Side side_toward(const Vec3& d) {
  const int axis = longest_axis(d);
  return {axis, axis == 2 ? 0 : axis + 1, axis == 0 ? 2 : axis - 1, d[axis] >= 0};
}

[[nodiscard]] inline BoxFaceFeatures features_of(const Side& side) {
  const std::uint32_t first = 1u << side.first, second = 1u << side.second, base = side.is_upper ? 1u << side.axis : 0;
  const auto corner = [](std::uint32_t bits) { return Feature{FeatureKind::vertex, bits}; };
  // By its direction and the ends of both other axes, the lower axis first.
  const auto edge = [](int along, std::uint32_t bits) {
    const std::uint32_t others = along == 0 ? bits >> 1 : along == 1 ? (bits & 1) | (bits >> 1 & 2) : bits & 3;
    return Feature{FeatureKind::edge, 4 * static_cast<std::uint32_t>(along) + others};
  };
  return {Feature{FeatureKind::face, 2 * static_cast<std::uint32_t>(side.axis) + (side.is_upper ? 1 : 0)},
          corner(base),
          corner(base | first),
          corner(base | first | second),
          corner(base | second),
          edge(side.second, base),
          edge(side.second, base | first),
          edge(side.first, base),
          edge(side.first, base | second)};
}

[[nodiscard]] inline const Vec3& column(const Rotation& r, int axis) { return axis == 0 ? r.x : axis == 1 ? r.y : r.z; }
[[nodiscard]] inline Lanes unit(int axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0, 0};
}

using LaneBits = bool __attribute__((ext_vector_type(4)));
[[nodiscard]] inline std::uint32_t bits_of(LaneNumbers mask) {
  return std::bit_cast<std::uint8_t>(__builtin_convertvector(mask, LaneBits)) & 15u;
}

// Where something gets along the normal in the plane of the face of a, and how far it is from there.
struct Projected {
  Real u, v, height;
};
[[nodiscard]] inline Projected turned(const Projected& p) { return {p.v, p.u, p.height}; }

// Both faces in that plane: a rectangle of given halves around zero, and a parallelogram with the halves of its sides.
struct Faces {
  Real half_u, half_v;
  Projected centre, first, second;
};
[[nodiscard]] inline Faces turned(const Faces& f) {
  return {f.half_v, f.half_u, turned(f.centre), turned(f.first), turned(f.second)};
}

// Four candidates.
struct Candidates {
  Lanes u, v, distance;
  LaneNumbers are_corners;
};
[[nodiscard]] inline Candidates turned(const Candidates& c) { return {c.v, c.u, c.distance, c.are_corners}; }

// The edges of the rectangle at both ends of u, and both edges of the parallelogram along `run`, at the ends of
// `fixed`.
[[nodiscard]] inline Candidates crossings(const Faces& f, const Projected& run, const Projected& fixed) {
  const Lanes u = first_ends * f.half_u;
  const Lanes at = (u - (f.centre.u + second_ends * fixed.u)) / all_lanes(run.u);
  const Lanes v = f.centre.v + second_ends * fixed.v + at * run.v;
  return {u, v, f.centre.height + second_ends * fixed.height + at * run.height,
          (absolute(at) < 1) & (absolute(v) < f.half_v)};
}

inline void write(const Candidates& candidates, std::size_t group, Real margin, BoxRegion& out) {
  for (std::size_t lane = 0; lane < 4; ++lane) {
    out.along_first[4 * group + lane] = candidates.u[lane];
    out.along_second[4 * group + lane] = candidates.v[lane];
    out.distance[4 * group + lane] = candidates.distance[lane];
  }
  out.corners |= bits_of(candidates.are_corners & (candidates.distance <= margin)) << (4 * group);
}

// Returns the least distance of a corner. Infinite where a corner of one face is closer than `doubt` to an edge of the
// other.
[[nodiscard]] inline Real clip_parallelogram(const Faces& f, Real doubt, Real margin, BoxRegion& out) {
  const auto [half_u, half_v, centre, first, second] = f;
  Candidates of_b;
  of_b.u = centre.u + first_ends * first.u + second_ends * second.u;
  of_b.v = centre.v + first_ends * first.v + second_ends * second.v;
  of_b.distance = centre.height + first_ends * first.height + second_ends * second.height;
  const Lanes beyond_u = absolute(of_b.u) - half_u, beyond_v = absolute(of_b.v) - half_v;
  of_b.are_corners = (beyond_u < 0) & (beyond_v < 0);

  // The corners of a, seen from the centre of the face of b. The unit is half a side of it, times the area of a
  // quarter.
  Candidates of_a;
  of_a.u = first_ends * half_u;
  of_a.v = second_ends * half_v;
  const Real turn = first.u * second.v - first.v * second.u, area = std::fabs(turn);
  const Lanes to_u = of_a.u - centre.u, to_v = of_a.v - centre.v;
  const Lanes along_first = to_u * second.v - to_v * second.u, along_second = to_v * first.u - to_u * first.v;
  const Lanes beyond_first = absolute(along_first) - area, beyond_second = absolute(along_second) - area;
  of_a.are_corners = (beyond_first < 0) & (beyond_second < 0);

  const Real doubt_first = doubt * (std::fabs(second.u) + std::fabs(second.v));
  const Real doubt_second = doubt * (std::fabs(first.u) + std::fabs(first.v));
  const LaneNumbers are_clear = (absolute(beyond_u) > doubt) & (absolute(beyond_v) > doubt) &
                                (absolute(beyond_first) > doubt_first) & (absolute(beyond_second) > doubt_second) &
                                (Lanes{half_u, half_v, area, area} > Lanes{doubt, doubt, doubt_first, doubt_second});
  if (bits_of(are_clear) != 15) {
    return infinity;
  }
  of_a.distance = centre.height + along_first * (first.height / turn) + along_second * (second.height / turn);
  const Faces t = turned(f);
  const std::array<Candidates, 6> all{of_b,
                                      of_a,
                                      crossings(f, first, second),
                                      crossings(f, second, first),
                                      turned(crossings(t, t.first, t.second)),
                                      turned(crossings(t, t.second, t.first))};
  Lanes least = Lanes(infinity);
  for (std::size_t group = 0; group < all.size(); ++group) {
    least = minimum(all[group].are_corners ? all[group].distance : Lanes(infinity), least);
    write(all[group], group, margin, out);
  }
  return -largest(-least);
}

// The same where the sides of the face of b run along the axes of a, as in a stack, `first` along u: the region is as
// wide as the narrower of both is on each side. Where edges lie on each other, within `slack`, those of b count.
[[nodiscard]] inline Real clip_rectangle(const Faces& f, Real slack, Real doubt, Real margin, BoxRegion& out) {
  const Real long_u = std::fabs(f.first.u), long_v = std::fabs(f.second.v);
  const Real side_u = std::copysign(1.0, f.first.u), side_v = std::copysign(1.0, f.second.v);
  const Real wide_u = std::fmin(f.half_u, long_u + f.centre.u) + std::fmin(f.half_u, long_u - f.centre.u);
  const Real wide_v = std::fmin(f.half_v, long_v + f.centre.v) + std::fmin(f.half_v, long_v - f.centre.v);
  if (!(wide_u > doubt && wide_v > doubt)) {
    return infinity;
  }
  Real least = infinity;
  for (std::size_t i = 0; i < 4; ++i) {
    const Real end_u = first_ends[i], end_v = second_ends[i];
    const Real reach_u = long_u + end_u * f.centre.u, reach_v = long_v + end_v * f.centre.v;
    const bool u_of_b = reach_u <= f.half_u + slack, v_of_b = reach_v <= f.half_v + slack;
    const Real u = end_u * (u_of_b ? reach_u : f.half_u), v = end_v * (v_of_b ? reach_v : f.half_v);
    const Real along_first = (u - f.centre.u) / f.first.u, along_second = (v - f.centre.v) / f.second.v;
    const Real distance = f.centre.height + along_first * f.first.height + along_second * f.second.height;
    // The ends of the sides of b, and which candidate has these edges.
    const Real end_first = end_u * side_u, end_second = end_v * side_v;
    const std::size_t candidate = u_of_b
                                      ? (v_of_b ? corner_at(end_first, end_second) : 20 + corner_at(end_v, end_first))
                                      : (v_of_b ? 8 + corner_at(end_u, end_second) : 4 + i);
    out.along_first[candidate] = u;
    out.along_second[candidate] = v;
    out.distance[candidate] = distance;
    out.corners |= distance <= margin ? 1u << candidate : 0;
    least = distance < least ? distance : least;
  }
  return least;
}

}  // namespace

bool clip_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab, const Vec3& normal, Real separation,
                Real margin, Real size, BoxRegion& out) {
  const Side a = side_toward(normal);
  Side b = side_toward(ab.rotation.undo(-normal));
  const Real plane = a.is_upper ? half_a[a.axis] : -half_a[a.axis];
  const Vec3 centre = ab.position + (b.is_upper ? half_b[b.axis] : -half_b[b.axis]) * column(ab.rotation, b.axis);
  const Vec3 first = half_b[b.first] * column(ab.rotation, b.first),
             second = half_b[b.second] * column(ab.rotation, b.second);

  const auto across = [&](int axis) { return Lanes{centre[axis], first[axis], second[axis], 0}; };
  const Lanes heights = (across(a.axis) - Lanes{plane, 0, 0, 0}) * all_lanes(1 / normal[a.axis]);
  const Lanes u = across(a.first) - heights * all_lanes(normal[a.first]);
  const Lanes v = across(a.second) - heights * all_lanes(normal[a.second]);
  Faces faces{
      half_a[a.first], half_a[a.second], {u[0], v[0], heights[0]}, {u[1], v[1], heights[1]}, {u[2], v[2], heights[2]}};

  const Real tie = tie_share * std::fmin(largest_magnitude(half_a), largest_magnitude(half_b));
  const Real slack = rounding_of(size) + tie, doubt = 4 * (noise_of(size) + tie);
  if (std::fabs(faces.first.u) <= slack && std::fabs(faces.second.v) <= slack) {
    std::swap(b.first, b.second);
    std::swap(faces.first, faces.second);
  }
  out.corners = 0;
  const bool is_rectangle = std::fabs(faces.first.v) <= slack && std::fabs(faces.second.u) <= slack;
  const Real least =
      is_rectangle ? clip_rectangle(faces, slack, doubt, margin, out) : clip_parallelogram(faces, doubt, margin, out);
  // Closest points that the region misses, as between edges that cross beside it, are to be looked for.
  if (!(std::fabs(least - separation) <= touching_distance(size)) || out.corners == 0) {
    return false;
  }
  out.base = plane * unit(a.axis);
  out.first = unit(a.first);
  out.second = unit(a.second);
  out.of_a = features_of(a);
  out.of_b = features_of(b);
  return true;
}

}  // namespace abut
