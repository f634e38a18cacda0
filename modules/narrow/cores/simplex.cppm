// SPDX-License-Identifier: Apache-2.0
// The point of a simplex that is closest to the origin, for GJK.
//
// Signs of sub-determinants, compared with the sign of the whole, decide which face is closest (signed volumes:
// Montanari, Petrinic, Barbieri, "Improving the GJK algorithm for faster and more reliable distance queries", ACM TOG
// 36(3), 2017). Slivers and flat simplices need no thresholds. Where a determinant vanishes, all its faces are
// candidates and the closest wins.
export module abut.narrow.cores.simplex;
import abut.capability;
import abut.core.standard;
import abut.math.wide;
import abut.math;

export namespace abut {

// A vertex w = a - b of the Minkowski difference, with the point a that it came from; b is a - w.
struct DifferenceVertex {
  Vec3 w, a;
  std::uint32_t index_a, index_b;

  // The same two vertices. Support points of curved surfaces have no numbers: they are compared as points.
  [[nodiscard]] inline bool is_same(const DifferenceVertex& other) const {
    return index_a == other.index_a && index_b == other.index_b &&
           ((index_a != no_index && index_b != no_index) || w == other.w);
  }
};

struct Simplex {
  std::array<DifferenceVertex, 4> vertices;
  std::size_t size = 0;

  inline void push(const DifferenceVertex& vertex) { vertices[size++] = vertex; }
  [[nodiscard]] [[gnu::always_inline]] inline bool contains(const DifferenceVertex& vertex) const {
    for (std::size_t i = 0; i < size; ++i) {
      if (vertices[i].is_same(vertex)) {
        return true;
      }
    }
    return false;
  }
};

// A point of a simplex and the vertices that span it, by bit. Weights are left to weights_of: GJK needs
// them only once, at its end. Here and below vectors may have the usual digits or twice as many.
template <class Vector>
struct ClosestPointOf {
  Vector point;
  unsigned vertices;
};
using ClosestPoint = ClosestPointOf<Vec3>;
template <class Vector>
using NumberOf = decltype(Vector::x);

inline constexpr unsigned all_of_tetrahedron = 15;

template <class Vector>
[[nodiscard]] [[gnu::always_inline]] inline ClosestPointOf<Vector> closest_on_segment(const Vector& p, const Vector& q,
                                                                                      unsigned at_p, unsigned at_q) {
  const Vector d = q - p;
  const NumberOf<Vector> along = -dot(p, d), length = squared_norm(d);
  if (!(along > 0)) {
    return {p, at_p};
  }
  if (!(along < length)) {
    return {q, at_q};
  }
  const NumberOf<Vector> inverse = 1 / length;
  const Vector near = p + (along * inverse) * d;
  // Projected again: where the point is small beside p, its direction would be rounding of p.
  return {near - (dot(near, d) * inverse) * d, at_p | at_q};
}

// Keeps the closer one of two candidates.
template <class Vector>
inline void consider(ClosestPointOf<Vector>& best, NumberOf<Vector>& best_square,
                     const ClosestPointOf<Vector>& candidate) {
  const NumberOf<Vector> square = squared_norm(candidate.point);
  if (square < best_square) {
    best = candidate;
    best_square = square;
  }
}

// The edges opposite to corners whose barycentric weight is not positive may hold the closest point.
template <class Vector>
[[nodiscard]] [[gnu::always_inline]] inline ClosestPointOf<Vector> closest_on_triangle(const Vector& p, const Vector& q,
                                                                                       const Vector& r, unsigned at_p,
                                                                                       unsigned at_q, unsigned at_r) {
  const Vector normal = cross(p - r, q - r);
  const NumberOf<Vector> square = squared_norm(normal);
  bool try_pr = true, try_qr = true, try_pq = true;
  if (square > 0) [[likely]] {
    const Vector foot = (dot(normal, r) / square) * normal;
    const Vector fp = p - foot, fq = q - foot, fr = r - foot;
    try_qr = !(dot(normal, cross(fq, fr)) > 0);
    try_pr = !(dot(normal, cross(fr, fp)) > 0);
    try_pq = !(dot(normal, cross(fp, fq)) > 0);
    if (!(try_qr || try_pr || try_pq)) {
      return {foot, at_p | at_q | at_r};
    }
  }
  ClosestPointOf<Vector> best{r, at_r};
  NumberOf<Vector> best_square = infinity;
  if (try_pr) {
    consider(best, best_square, closest_on_segment(p, r, at_p, at_r));
  }
  if (try_qr) {
    consider(best, best_square, closest_on_segment(q, r, at_q, at_r));
  }
  if (try_pq) {
    consider(best, best_square, closest_on_segment(p, q, at_p, at_q));
  }
  return best;
}

// The sign of a cofactor differs from that of the volume where the origin is outside the face opposite to its vertex.
template <class Vector>
[[nodiscard]] [[gnu::always_inline]] inline ClosestPointOf<Vector> closest_on_tetrahedron(const Vector& p,
                                                                                          const Vector& q,
                                                                                          const Vector& r,
                                                                                          const Vector& s) {
  using Number = NumberOf<Vector>;
  const Vector sp = p - s, sq = q - s, sr = r - s;
  const Vector qr = cross(sq, sr), rp = cross(sr, sp), pq = cross(sp, sq);
  const Number volume = dot(sp, qr);
  // Heights of the origin over the planes of the faces through s, in units of the volume.
  const Number hp = -dot(s, qr), hq = -dot(s, rp), hr = -dot(s, pq);
  const Number hs = -dot(p, cross(q - p, r - p));  // the face p q r; s itself has height -volume
  // A volume that is no more than rounding says nothing about sides: then every face is a candidate.
  const Real noise = 16 * epsilon_of<Vector> * largest_magnitude(sp) * largest_magnitude(sq) * largest_magnitude(sr);
  const bool flat = !(volume > noise || volume < -noise);
  const auto outside = [&](const Number& h) { return flat || !(volume > 0 ? h >= 0 : h <= 0); };
  const bool out_p = outside(hp), out_q = outside(hq), out_r = outside(hr), out_s = outside(-hs);
  ClosestPointOf<Vector> best{{0, 0, 0}, all_of_tetrahedron};
  Number best_square = infinity;
  if (out_p) {
    consider(best, best_square, closest_on_triangle(q, r, s, 2, 4, 8));
  }
  if (out_q) {
    consider(best, best_square, closest_on_triangle(p, r, s, 1, 4, 8));
  }
  if (out_r) {
    consider(best, best_square, closest_on_triangle(p, q, s, 1, 2, 8));
  }
  if (out_s) {
    consider(best, best_square, closest_on_triangle(p, q, r, 1, 2, 4));
  }
  return best;
}

// The same on the surface of a tetrahedron that holds the origin.
[[nodiscard]] ClosestPoint closest_on_faces(const Simplex& simplex) {
  const auto& v = simplex.vertices;
  ClosestPoint best{};
  Real best_square = infinity;
  consider(best, best_square, closest_on_triangle(v[0].w, v[1].w, v[2].w, 1, 2, 4));
  consider(best, best_square, closest_on_triangle(v[0].w, v[1].w, v[3].w, 1, 2, 8));
  consider(best, best_square, closest_on_triangle(v[0].w, v[2].w, v[3].w, 1, 4, 8));
  consider(best, best_square, closest_on_triangle(v[1].w, v[2].w, v[3].w, 2, 4, 8));
  return best;
}

// Of three vertices and one more. Out of line: most of the code of a search would be this, once for each pair of cores.
[[nodiscard]] ClosestPoint closest_on_tetrahedron(const Simplex& three, const Vec3& newest) {
  const auto& v = three.vertices;
  return closest_on_tetrahedron(v[0].w, v[1].w, v[2].w, newest);
}

// Of the simplex and one vertex more, which comes by itself so that it can stay in registers.
[[nodiscard]] [[gnu::always_inline]] inline ClosestPoint closest_to_origin(const Simplex& simplex, const Vec3& newest) {
  const auto& v = simplex.vertices;
  switch (simplex.size) {
    case 0: return {newest, 1};
    case 1: return closest_on_segment(v[0].w, newest, 1, 2);
    case 2: return closest_on_triangle(v[0].w, v[1].w, newest, 1, 2, 4);
    default: return closest_on_tetrahedron(simplex, newest);
  }
}

// Of at least one vertex.
[[nodiscard]] ClosestPoint closest_to_origin(Simplex simplex) {
  simplex.size -= 1;
  return closest_to_origin(simplex, simplex.vertices[simplex.size].w);
}

// Keeps the vertices that span a closest point, in their order, of a simplex with the usual digits or more.
template <class AnySimplex>
inline void keep(AnySimplex& simplex, unsigned vertices) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < simplex.size; ++i) {
    if ((vertices >> i & 1u) != 0) {
      if (kept != i) {
        simplex.vertices[kept] = simplex.vertices[i];
      }
      ++kept;
    }
  }
  simplex.size = kept;
}

// What at most three points weigh in their closest point, of which the last ones may be missing.
template <class Vector>
[[nodiscard]] inline std::array<Real, 3> weights_of(std::size_t size, const Vector& first, const Vector& second,
                                                    const Vector& third, const Vector& closest) {
  using Number = NumberOf<Vector>;
  if (size == 1) {
    return {1, 0, 0};
  }
  if (size == 2) {
    const Vector d = second - first;
    const Real t = static_cast<Real>(dot(closest - first, d) / squared_norm(d));
    return {1 - t, t, 0};
  }
  const Vector normal = cross(first - third, second - third);
  const Vector p = first - closest, q = second - closest, r = third - closest;
  // Of slivers rounding leaves weights below zero, which would lead out of the body.
  const auto weight = [&](const Vector& from, const Vector& to) {
    const Number area = dot(normal, cross(from, to));
    return area > 0 ? area : Number(0);
  };
  const Number wp = weight(q, r), wq = weight(r, p), wr = weight(p, q), sum = wp + wq + wr;
  if (!(sum > 0)) {
    return {1, 0, 0};
  }
  const Number scale = 1 / sum;
  return {static_cast<Real>(scale * wp), static_cast<Real>(scale * wq), static_cast<Real>(scale * wr)};
}
[[nodiscard]] inline std::array<Real, 3> weights_of(const Simplex& simplex, const Vec3& closest) {
  const auto& v = simplex.vertices;
  return weights_of(simplex.size, v[0].w, v[1].w, v[2].w, closest);
}

// The point of a simplex with these weights: of a, and of the difference.
struct WeightedPoint {
  Vec3 a, w;
};
[[nodiscard]] inline WeightedPoint point_with(const Simplex& simplex, const std::array<Real, 3>& weights) {
  const auto& v = simplex.vertices;
  const auto& [p, q, r] = weights;
  switch (simplex.size) {
    case 1: return {v[0].a, v[0].w};
    case 2: return {v[0].a + q * (v[1].a - v[0].a), v[0].w + q * (v[1].w - v[0].w)};
    default: return {p * v[0].a + q * v[1].a + r * v[2].a, p * v[0].w + q * v[1].w + r * v[2].w};
  }
}

// The point of a under the closest point of at most three vertices, with the weights that it has there.
[[nodiscard]] inline Vec3 witness_on_a(const Simplex& simplex, const Vec3& closest) {
  return point_with(simplex, weights_of(simplex, closest)).a;
}

}  // namespace abut
