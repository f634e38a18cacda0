// SPDX-License-Identifier: Apache-2.0
// On which stretch of a way each of four triangles overlaps another one: the stretch ends where the first of all
// separating axes parts both (Gottschalk, Lin, Manocha, "OBBTree", 1996). Any axis that parts them is right, also one
// that rounding has turned, as long as all corners are asked.
export module abut.narrow.two_surfaces.leaving_pairs;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.math.four_vec3;
import abut.narrow.fan.sat;
import abut.narrow.ways.leaving_four;
import abut.narrow.triangle.quick_axes;

export namespace abut {

// What a search along a way asks about: stretches that begin before a length, and end after another one. The others may
// be told as none.
struct StretchesWanted {
  Vec3 direction;
  Real begin, end;
  Real touching;  // triangles that overlap by no more only touch
};

// Stretches of overlaps by more than a touch, from `begin` to `last`, and where the touch ends. Where there is none,
// the end is -infinity. `axis`: the number of the axis that parts both at the end: of the face of a, of that of b, then
// of each edge of a and of b.
struct PairStretches {
  Lanes begin, last, end, axis;
};

// Of four pairs of triangles, of which the second ones move.
[[nodiscard]] PairStretches stretches_of(const FourFaces& faces_a, const FourFaces& faces_b,
                                         const StretchesWanted& wanted) {
  const FourTriangles &a = faces_a.triangles, &b = faces_b.triangles;
  const Columns direction = Columns::all(wanted.direction);
  PairStretches found{all_lanes(-infinity), all_lanes(infinity), all_lanes(infinity), all_lanes(0)};
  LaneNumbers is_apart = LaneNumbers(0);
  struct Span {
    Lanes low, high;
  };
  const auto consider = [&](const Columns& axis, Lanes square, LaneNumbers is_axis, const Span& of_a, const Span& of_b,
                            Real number) {
    const Lanes ahead = of_a.high - of_b.low, behind = of_a.low - of_b.high;
    const Lanes speed = dot(axis, direction), slack = wanted.touching * length_bound(axis);
    const LaneNumbers is_moving = speed * speed > along_plane_square * square;
    const Lanes inverse = 1 / (is_moving ? speed : all_lanes(1)), one = ahead * inverse, other = behind * inverse;
    const Lanes end = maximum(one, other), begin = minimum(one, other), inside = slack * absolute(inverse);
    const LaneNumbers counts = is_axis & is_moving, is_sooner = counts & (end < found.end);
    found.end = is_sooner ? end : found.end;
    found.axis = is_sooner ? all_lanes(number) : found.axis;
    found.begin = counts ? maximum(found.begin, begin + inside) : found.begin;
    found.last = counts ? minimum(found.last, end - inside) : found.last;
    is_apart |= is_axis & ~is_moving & ((ahead <= slack) | (behind >= -slack));
  };
  const auto is_none = [&] {
    return is_apart | (found.last <= found.begin) | (found.begin >= all_lanes(wanted.begin)) |
           (found.end <= all_lanes(wanted.end));
  };
  const Lanes nowhere = all_lanes(-infinity);
  const PairStretches none{-nowhere, nowhere, nowhere, all_lanes(0)};
  const auto consider_face = [&](const Columns& normal, Real number) {
    const Lanes square = dot(normal, normal);
    const auto span_of = [&](const FourTriangles& t) {
      const Lanes p = dot(normal, t.a), q = dot(normal, t.b), r = dot(normal, t.c);
      return Span{minimum(minimum(p, q), r), maximum(maximum(p, q), r)};
    };
    consider(normal, square, square > all_lanes(0.5), span_of(a), span_of(b), number);
  };
  consider_face(faces_a.normals, 0);
  consider_face(faces_b.normals, 1);
  if ((~bits_of(is_none()) & 15u) == 0) {
    return none;
  }
  // Of an edge, both ends lie alike across it, and the corner opposite to it elsewhere.
  struct Edge {
    Columns from, along, opposite;
  };
  const auto edges_of = [](const FourTriangles& t) {
    return std::array<Edge, 3>{Edge{t.a, t.b - t.a, t.c}, Edge{t.b, t.c - t.b, t.a}, Edge{t.c, t.a - t.c, t.b}};
  };
  const std::array<Edge, 3> edges_b = edges_of(b);
  Real number = 2;
  for (const Edge& of_a : edges_of(a)) {
    const Lanes least = slim_square * dot(of_a.along, of_a.along);
    for (const Edge& of_b : edges_b) {
      const Columns axis = cross(of_a.along, of_b.along);
      const Lanes square = dot(axis, axis);
      const auto span_of = [&](const Edge& edge) {
        const Lanes p = dot(axis, edge.from), q = dot(axis, edge.opposite);
        return Span{minimum(p, q), maximum(p, q)};
      };
      consider(axis, square, square > least * dot(of_b.along, of_b.along), span_of(of_a), span_of(of_b), number);
      number += 1;
    }
  }
  const LaneNumbers are_none = is_none() | (found.end == all_lanes(infinity));
  found.end = are_none ? nowhere : found.end;
  return found;
}

// The normal of the touch at the end of a stretch, along the direction.
[[nodiscard]] inline Vec3 normal_at_end(const FourFaces& a, const FourFaces& b, std::size_t lane, const Vec3& direction,
                                        Real axis) {
  const auto number = static_cast<std::size_t>(axis);
  Vec3 normal = number == 0 ? a.normals[lane] : b.normals[lane];
  if (number > 1) {
    const auto edge = [lane](const FourFaces& faces, std::size_t i) {
      const TriangleCorners corners = faces.triangles[lane];
      return corners[(i + 1) % 3] - corners[i];
    };
    const Vec3 of_a = edge(a, (number - 2) / 3), of_b = edge(b, (number - 2) % 3), product = cross(of_a, of_b);
    normal = unit_across_edges(of_a, of_b, product, squared_norm(product));
  }
  return dot(normal, direction) < 0 ? -normal : normal;
}

// The point of the second triangle that is last to leave the first one, where it is before it moves. Seen along the
// direction it is a corner of one of both, or where two edges cross. `length`: of the way until then.
[[nodiscard]] Vec3 last_point_of(const TriangleCorners& a, const TriangleCorners& b, const Vec3& direction,
                                 Real length) {
  constexpr Real beside = 1e-7;           // of an edge or a triangle
  constexpr Real passing_square = 1e-24;  // of the sine between the direction and what it passes
  Vec3 best = b[0];
  Real least = infinity;
  const auto offer = [&](const Vec3& point, Real travelled) {
    if (const Real off = std::fabs(travelled - length); off < least) {
      least = off;
      best = point;
    }
  };
  // How far a point is along the direction from a triangle that it passes.
  const auto passes = [&](const Vec3& point, const TriangleCorners& t) -> std::optional<Real> {
    const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
    const Real speed = dot(n, direction), whole = std::fabs(speed);
    if (!(speed * speed > passing_square * squared_norm(n))) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& from = t[i];
      const Vec3 edge = t[(i + 1) % 3] - from;
      if (dot(cross(edge, point - from), direction) * (speed < 0 ? -1 : 1) < -beside * whole) {
        return std::nullopt;
      }
    }
    return dot(n, t[0] - point) / speed;
  };
  for (const Vec3& corner : b) {
    if (const auto travelled = passes(corner, a)) {
      offer(corner, *travelled);
    }
  }
  for (const Vec3& corner : a) {
    if (const auto travelled = passes(corner, b)) {
      offer(corner + *travelled * direction, -*travelled);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 of_a = a[(i + 1) % 3] - a[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 of_b = b[(j + 1) % 3] - b[j], n = cross(of_a, of_b), from = a[i] - b[j];
      const Real speed = dot(n, direction);
      if (!(speed * speed > passing_square * squared_norm(n))) {
        continue;
      }
      const Real on_b = dot(cross(of_a, from), direction) / speed, on_a = dot(cross(of_b, from), direction) / speed;
      if (on_a >= -beside && on_a <= 1 + beside && on_b >= -beside && on_b <= 1 + beside) {
        offer(b[j] + std::clamp(on_b, Real{0}, Real{1}) * of_b, dot(n, from) / speed);
      }
    }
  }
  return best;
}

}  // namespace abut
