// SPDX-License-Identifier: Apache-2.0
// On which stretch of a way a convex shape overlaps each of four triangles: closed forms for points, segments and
// boxes.
export module abut.narrow.ways.leaving_four;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.math.four_vec3;
import abut.narrow.fan.triangle_sat;

export namespace abut {

// Four triangles and their planes: unit normals, zero of triangles without area, and heights along them.
struct FourFaces {
  FourTriangles triangles;
  Columns normals;
  Lanes heights;

  // Normals of slivers are told by their triangle.
  void set_planes(std::uint64_t present) {
    constexpr Real sliver_square = 1e-6, least_square = 1e-200, most_square = 1e200;
    const FourTriangles& t = triangles;
    const Columns ab = t.b - t.a, ac = t.c - t.a, n = cross(ab, ac);
    const Lanes square = dot(n, n);
    normals = (1 / __builtin_elementwise_sqrt(square)) * n;
    const LaneNumbers is_wide = (square > sliver_square * dot(ab, ab) * dot(ac, ac)) &
                                (square > all_lanes(least_square)) & (square < all_lanes(most_square));
    for (std::uint64_t left = present & ~bits_of(is_wide); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      normals.put(lane, Triangle(t[lane], 0, false).normal());
    }
    heights = dot(normals, t.a);
  }
};

// Begins and ends of the stretches; where there is none, the end is -infinity. `axis`: of a box, the number of the one
// that parts both at the end.
struct FourStretches {
  Lanes begin, end, axis;
};

template <class B>
inline constexpr bool leaves_in_fours = PointCored<B> || SegmentCored<B> || is_box<B>;

// Squares of the sine between a direction and an axis: nearer to parallel no chord has ends.
inline constexpr Real along_axis_square = 1e-12;
// Keeps quotients finite where an edge has no length.
inline constexpr Real no_length = 1e-300;

// The ends of a chord of a cylinder or a ball: the solutions of a s^2 + 2 b s + c = 0.
struct FourChords {
  Lanes first, last;
  LaneNumbers exist;

  [[gnu::always_inline]] inline FourChords(Lanes a, Lanes b, Lanes c) {
    const Lanes under = b * b - a * c, zero = all_lanes(0);
    exist = (under >= zero) & (a > all_lanes(along_axis_square));
    const Lanes root = __builtin_elementwise_sqrt(maximum(under, zero)), inverse = 1 / (exist ? a : all_lanes(1));
    first = (-root - b) * inverse;
    last = (root - b) * inverse;
  }
};

// Lengths at which a shape of some reach passes a plane, the first and the last.
struct FourPassages {
  Lanes first, last;
  LaneNumbers exist;

  // `height`: of the middle of the shape, `speed`: at which it grows.
  [[gnu::always_inline]] inline FourPassages(Lanes height, Lanes reach, Lanes speed, LaneNumbers is_plane) {
    constexpr Real still = 1e-13;  // of a unit normal along a unit direction
    exist = (absolute(speed) > all_lanes(still)) & is_plane;
    const Lanes inverse = 1 / (exist ? speed : all_lanes(1));
    const Lanes one = (reach - height) * inverse, other = (-reach - height) * inverse;
    first = minimum(one, other);
    last = maximum(one, other);
  }
};

[[gnu::always_inline]] inline void extend(FourStretches& stretches, LaneNumbers begins, Lanes begin, LaneNumbers ends,
                                          Lanes end) {
  stretches.begin = begins ? minimum(stretches.begin, begin) : stretches.begin;
  stretches.end = ends ? maximum(stretches.end, end) : stretches.end;
}

// A share of an edge within it, but for rounding.
[[nodiscard]] [[gnu::always_inline]] inline LaneNumbers is_share(Lanes share) {
  return (share >= all_lanes(-share_slack)) & (share <= all_lanes(1 + share_slack));
}

// A ball: the face that it leaves between two copies of it, the cylinders around the edges and the balls around the
// corners.
template <Convex B>
  requires PointCored<B>
[[nodiscard]] FourStretches stretches_of(const FourFaces& four, const B& b, const Pose& ab, const Vec3& direction) {
  const FourTriangles& t = four.triangles;
  const Real radius = b.radius(), square = radius * radius;
  const Lanes zero = all_lanes(0), slack = all_lanes(-share_slack * square), tiny = all_lanes(no_length);
  const Columns p = Columns::all(ab.position), d = Columns::all(direction);
  FourStretches found{all_lanes(infinity), all_lanes(-infinity), zero};
  const FourPassages plane(dot(four.normals, p) - four.heights, all_lanes(radius), dot(four.normals, d),
                           dot(four.normals, four.normals) > all_lanes(0.5));
  Lanes inside_first = all_lanes(infinity), inside_last = all_lanes(infinity);
  const auto pass_edge = [&](const Columns& from, const Columns& to) {
    const Columns edge = to - from, w = p - from;
    const Lanes ee = dot(edge, edge), we = dot(w, edge), de = dot(edge, d), ww = dot(w, w), wd = dot(w, d);
    const Columns inward = cross(four.normals, edge);
    const Lanes start = dot(inward, w), speed = dot(inward, d);
    inside_first = minimum(inside_first, start + plane.first * speed);
    inside_last = minimum(inside_last, start + plane.last * speed);
    const FourChords ball(all_lanes(1), wd, ww - square);
    extend(found, ball.exist, ball.first, ball.exist, ball.last);
    const Lanes inverse = 1 / (ee + tiny);
    const FourChords tube(1 - de * de * inverse, wd - we * de * inverse, ww - we * we * inverse - square);
    const LaneNumbers exist = tube.exist & (ee > zero);
    extend(found, exist & is_share((we + tube.first * de) * inverse), tube.first,
           exist & is_share((we + tube.last * de) * inverse), tube.last);
  };
  pass_edge(t.a, t.b);
  pass_edge(t.b, t.c);
  pass_edge(t.c, t.a);
  extend(found, plane.exist & (inside_first >= slack), plane.first, plane.exist & (inside_last >= slack), plane.last);
  return found;
}

// A capsule: the face between two copies of its ends, the parallelograms of its axis and the edges, and all that is
// round around these.
template <Convex B>
  requires SegmentCored<B>
[[nodiscard]] FourStretches stretches_of(const FourFaces& four, const B& b, const Pose& ab, const Vec3& direction) {
  const FourTriangles& t = four.triangles;
  const Real radius = b.radius(), square = radius * radius, half = b.half().z;
  const Lanes zero = all_lanes(0), slack = all_lanes(-share_slack * square), tiny = all_lanes(no_length);
  const Columns middle = Columns::all(ab.position), axis = Columns::all(ab.rotation.z), d = Columns::all(direction);
  const Real da = dot(ab.rotation.z, direction);
  FourStretches found{all_lanes(infinity), all_lanes(-infinity), zero};
  const Lanes speed = dot(four.normals, d), lean = dot(four.normals, axis);
  const FourPassages plane(dot(four.normals, middle) - four.heights, half * absolute(lean) + radius, speed,
                           dot(four.normals, four.normals) > all_lanes(0.5));
  // Which end leaves last, and enters first: opposite ones.
  const Lanes last_end = lean * speed >= zero ? all_lanes(-half) : all_lanes(half);
  Lanes inside_first = all_lanes(infinity), inside_last = all_lanes(infinity);
  const auto pass_edge = [&](const Columns& from, const Columns& to) {
    const Columns edge = to - from, w = middle - from;
    const Lanes ee = dot(edge, edge), we = dot(w, edge), de = dot(edge, d), ea = dot(edge, axis), wa = dot(w, axis),
                ww = dot(w, w), wd = dot(w, d), inverse = 1 / (ee + tiny);
    const LaneNumbers has_length = ee > zero;
    const Columns inward = cross(four.normals, edge);
    const Lanes start = dot(inward, w), inward_speed = dot(inward, d), inward_lean = dot(inward, axis);
    inside_first = minimum(inside_first, start - last_end * inward_lean + plane.first * inward_speed);
    inside_last = minimum(inside_last, start + last_end * inward_lean + plane.last * inward_speed);
    // The axis and the edge span planes at the distance of the radius.
    const Lanes across = ee - ea * ea;
    const Columns normal = cross(edge, axis);
    const Lanes passing = dot(normal, d), aside = dot(normal, w);
    const LaneNumbers spans =
        (across > along_axis_square * ee) & has_length & (passing * passing > along_plane_square * across);
    const Lanes by_passing = 1 / (spans ? passing : all_lanes(1)), by_across = 1 / (spans ? across : all_lanes(1)),
                reach = radius * __builtin_elementwise_sqrt(maximum(across, zero));
    const Lanes one = (reach - aside) * by_passing, other = (-reach - aside) * by_passing;
    const Lanes first = minimum(one, other), last = maximum(one, other);
    const auto is_between = [&](Lanes s) {
      const Lanes on_edge = we + s * de, on_axis = wa + s * da;
      return is_share((on_edge - on_axis * ea) * by_across) &
             (absolute((on_axis * ee - on_edge * ea) * by_across) <= all_lanes(half * (1 + share_slack)));
    };
    extend(found, spans & is_between(first), first, spans & is_between(last), last);
    // Without a radius, roots of these are rounding.
    if (!(radius > 0)) {
      return;
    }
    // The tube around the axis passes the corner.
    const FourChords tube(all_lanes(1 - da * da), wd - wa * da, ww - wa * wa - square);
    extend(found, tube.exist & (absolute(wa + tube.first * da) <= all_lanes(half * (1 + share_slack))), tube.first,
           tube.exist & (absolute(wa + tube.last * da) <= all_lanes(half * (1 + share_slack))), tube.last);
    // The balls around the ends pass the corner and the edge.
    for (const Real end : {-half, half}) {
      const Lanes we_end = we + end * ea, wd_end = wd + end * da, ww_end = ww + 2 * end * wa + end * end;
      const FourChords ball(all_lanes(1), wd_end, ww_end - square);
      extend(found, ball.exist, ball.first, ball.exist, ball.last);
      const FourChords rod(1 - de * de * inverse, wd_end - we_end * de * inverse,
                           ww_end - we_end * we_end * inverse - square);
      const LaneNumbers exist = rod.exist & has_length;
      extend(found, exist & is_share((we_end + rod.first * de) * inverse), rod.first,
             exist & is_share((we_end + rod.last * de) * inverse), rod.last);
    }
  };
  pass_edge(t.a, t.b);
  pass_edge(t.b, t.c);
  pass_edge(t.c, t.a);
  extend(found, plane.exist & (inside_first >= slack), plane.first, plane.exist & (inside_last >= slack), plane.last);
  return found;
}

// A box: the stretch ends where the first of all separating axes parts both (Gottschalk, Lin, Manocha, "OBBTree",
// 1996). All is told in the frame of the box. Any axis that parts them is right, also one that rounding has turned, as
// long as all corners are asked.
template <Convex B>
  requires is_box<B>
[[nodiscard]] FourStretches stretches_of(const FourFaces& four, const B& b, const Pose& ab, const Vec3& direction) {
  const Vec3 half = b.half(), d = ab.rotation.undo(direction);
  const auto& [x, y, z] = ab.rotation;
  const auto in_box = [&](const Columns& v) {
    return Columns{dot(v, Columns::all(x)), dot(v, Columns::all(y)), dot(v, Columns::all(z))};
  };
  const Columns position = Columns::all(ab.position);
  const std::array<Columns, 3> q{in_box(four.triangles.a - position), in_box(four.triangles.b - position),
                                 in_box(four.triangles.c - position)};
  FourStretches found{all_lanes(-infinity), all_lanes(infinity), all_lanes(0)};
  LaneNumbers is_apart = LaneNumbers(0);
  const auto consider = [&](Lanes p, Lanes q1, Lanes r, Lanes reach, Lanes speed, Lanes square, LaneNumbers is_axis,
                            Real number) {
    const Lanes ahead = maximum(maximum(p, q1), r) + reach, behind = minimum(minimum(p, q1), r) - reach;
    const LaneNumbers is_moving = speed * speed > along_plane_square * square;
    const Lanes inverse = 1 / (is_moving ? speed : all_lanes(1)), one = ahead * inverse, other = behind * inverse;
    const Lanes end = maximum(one, other), begin = minimum(one, other);
    const LaneNumbers counts = is_axis & is_moving, is_sooner = counts & (end < found.end);
    found.end = is_sooner ? end : found.end;
    found.axis = is_sooner ? all_lanes(number) : found.axis;
    found.begin = counts ? maximum(found.begin, begin) : found.begin;
    is_apart |= is_axis & ~is_moving & ((ahead <= all_lanes(0)) | (behind >= all_lanes(0)));
  };
  const LaneNumbers always = LaneNumbers(-1);
  const Columns n = in_box(four.normals);
  const auto along = [&](const Columns& axis, const Columns& p) { return dot(axis, p); };
  consider(along(n, q[0]), along(n, q[1]), along(n, q[2]),
           absolute(n.x) * half.x + absolute(n.y) * half.y + absolute(n.z) * half.z, dot(n, Columns::all(d)),
           all_lanes(1), dot(n, n) > all_lanes(0.5), 0);
  consider(q[0].x, q[1].x, q[2].x, all_lanes(half.x), all_lanes(d.x), all_lanes(1), always, 1);
  consider(q[0].y, q[1].y, q[2].y, all_lanes(half.y), all_lanes(d.y), all_lanes(1), always, 2);
  consider(q[0].z, q[1].z, q[2].z, all_lanes(half.z), all_lanes(d.z), all_lanes(1), always, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const Columns e = q[(i + 1) % 3] - q[i];
    const Lanes least = slim_square * dot(e, e);
    const auto across = [&](Lanes u, Lanes v, const auto& of_u, const auto& of_v, Real half_u, Real half_v, Real d_u,
                            Real d_v, Real number) {
      const Lanes square = u * u + v * v;
      const auto height = [&](const Columns& p) { return of_v(p) * u - of_u(p) * v; };
      consider(height(q[0]), height(q[1]), height(q[2]), half_v * absolute(u) + half_u * absolute(v), d_v * u - d_u * v,
               square, square > least, number);
    };
    const auto of_x = [](const Columns& p) { return p.x; };
    const auto of_y = [](const Columns& p) { return p.y; };
    const auto of_z = [](const Columns& p) { return p.z; };
    const Real first = 4 + 3 * static_cast<Real>(i);
    across(e.y, e.z, of_y, of_z, half.y, half.z, d.y, d.z, first);
    across(e.z, e.x, of_z, of_x, half.z, half.x, d.z, d.x, first + 1);
    across(e.x, e.y, of_x, of_y, half.x, half.y, d.x, d.y, first + 2);
  }
  const LaneNumbers is_none = is_apart | (found.end <= found.begin);
  found.end = is_none ? all_lanes(-infinity) : found.end;
  found.begin = is_none ? all_lanes(infinity) : found.begin;
  return found;
}

// The normal of the touch at the end of a stretch of a box, along the direction.
[[nodiscard]] inline Vec3 normal_at_end(const FourFaces& four, std::size_t lane, const Pose& ab, const Vec3& direction,
                                        Real axis) {
  const auto number = static_cast<std::size_t>(axis);
  const std::array<Vec3, 3> axes{ab.rotation.x, ab.rotation.y, ab.rotation.z};
  Vec3 normal = four.normals[lane];
  if (number > 3) {
    const TriangleCorners corners = four.triangles[lane];
    const std::size_t edge = (number - 4) / 3;
    const Vec3 along = corners[(edge + 1) % 3] - corners[edge];
    normal = UnitVec3::make(cross(axes[(number - 4) % 3], along)).value_or(UnitVec3::from_unit_unchecked(direction));
  } else if (number > 0) {
    normal = axes[number - 1];
  }
  return dot(normal, direction) < 0 ? -normal : normal;
}

}  // namespace abut
