// The point of a simplex that is closest to the origin, for GJK.
//
// Which face of a simplex is closest is decided by the signs of sub-determinants compared with the
// sign of the whole (signed volumes: Montanari, Petrinic, Barbieri, "Improving the GJK algorithm for
// faster and more reliable distance queries", ACM TOG 36(3), 2017), so that slivers and flat simplices
// need no thresholds: where a determinant vanishes, all its faces are candidates and the closest wins.
export module abut.narrowphase.simplex;
import abut.core.standard;
import abut.math;
import abut.shape;

export namespace abut {

// A vertex w = a - b of the Minkowski difference, with the point a that it came from; b is a - w.
struct DifferenceVertex {
  Vec3 w, a;
  std::uint32_t index_a, index_b;

  // The same two vertices. Support points of curved surfaces have no numbers: they are compared as points.
  [[nodiscard]] inline bool is_same(const DifferenceVertex& other) const {
    return index_a == other.index_a && index_b == other.index_b && ((index_a != no_index && index_b != no_index) || w == other.w);
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
// them only once, at its end.
struct ClosestPoint {
  Vec3 point;
  unsigned vertices;
};

inline constexpr unsigned all_of_tetrahedron = 15;

[[nodiscard]] [[gnu::always_inline]] inline ClosestPoint closest_on_segment(const Vec3& p, const Vec3& q, unsigned at_p, unsigned at_q) {
  const Vec3 d = q - p;
  const Real along = -dot(p, d), length = squared_norm(d);
  if (!(along > 0)) {
    return {p, at_p};
  }
  if (!(along < length)) {
    return {q, at_q};
  }
  const Real inverse = 1 / length;
  const Vec3 near = p + (along * inverse) * d;
  // Projected again: where the point is small beside p, its direction would be rounding of p.
  return {near - (dot(near, d) * inverse) * d, at_p | at_q};
}

// Keeps the closer one of two candidates.
inline void consider(ClosestPoint& best, Real& best_square, const ClosestPoint& candidate) {
  const Real square = squared_norm(candidate.point);
  if (square < best_square) {
    best = candidate;
    best_square = square;
  }
}

// The edges opposite to corners whose barycentric weight is not positive may hold the closest point.
[[nodiscard]] [[gnu::always_inline]] inline ClosestPoint closest_on_triangle(const Vec3& p, const Vec3& q, const Vec3& r, unsigned at_p, unsigned at_q,
                                                      unsigned at_r) {
  const Vec3 normal = cross(p - r, q - r);
  const Real square = squared_norm(normal);
  bool try_pr = true, try_qr = true, try_pq = true;
  if (square > 0) [[likely]] {
    const Vec3 foot = (dot(normal, r) / square) * normal;
    const Vec3 fp = p - foot, fq = q - foot, fr = r - foot;
    try_qr = !(dot(normal, cross(fq, fr)) > 0);
    try_pr = !(dot(normal, cross(fr, fp)) > 0);
    try_pq = !(dot(normal, cross(fp, fq)) > 0);
    if (!(try_qr || try_pr || try_pq)) {
      return {foot, at_p | at_q | at_r};
    }
  }
  ClosestPoint best{r, at_r};
  Real best_square = infinity;
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

// With cofactors of mixed signs the origin is outside the faces opposite to the vertices whose sign
// differs from that of the volume.
[[nodiscard]] [[gnu::always_inline]] inline ClosestPoint closest_on_tetrahedron(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 sp = p - s, sq = q - s, sr = r - s;
  const Vec3 qr = cross(sq, sr), rp = cross(sr, sp), pq = cross(sp, sq);
  const Real volume = dot(sp, qr);
  // Heights of the origin over the planes of the faces through s, in units of the volume.
  const Real hp = -dot(s, qr), hq = -dot(s, rp), hr = -dot(s, pq);
  const Real hs = -dot(p, cross(q - p, r - p));  // the face p q r; s itself has height -volume
  // A volume that is no more than rounding says nothing about sides: then every face is a candidate.
  const Real noise = 16 * epsilon * largest_magnitude(sp) * largest_magnitude(sq) * largest_magnitude(sr);
  const bool flat = !(volume > noise || volume < -noise);
  const auto outside = [&](Real h) { return flat || !(volume > 0 ? h >= 0 : h <= 0); };
  const bool out_p = outside(hp), out_q = outside(hq), out_r = outside(hr), out_s = outside(-hs);
  ClosestPoint best{{0, 0, 0}, all_of_tetrahedron};
  Real best_square = infinity;
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
[[nodiscard]] inline ClosestPoint closest_on_faces(const Simplex& simplex) {
  const auto& v = simplex.vertices;
  ClosestPoint best{};
  Real best_square = infinity;
  consider(best, best_square, closest_on_triangle(v[0].w, v[1].w, v[2].w, 1, 2, 4));
  consider(best, best_square, closest_on_triangle(v[0].w, v[1].w, v[3].w, 1, 2, 8));
  consider(best, best_square, closest_on_triangle(v[0].w, v[2].w, v[3].w, 1, 4, 8));
  consider(best, best_square, closest_on_triangle(v[1].w, v[2].w, v[3].w, 2, 4, 8));
  return best;
}

// Of the simplex and one vertex more, which comes by itself so that it can stay in registers.
[[nodiscard]] [[gnu::always_inline]] inline ClosestPoint closest_to_origin(const Simplex& simplex, const Vec3& newest) {
  const auto& v = simplex.vertices;
  switch (simplex.size) {
    case 0:
      return {newest, 1};
    case 1:
      return closest_on_segment(v[0].w, newest, 1, 2);
    case 2:
      return closest_on_triangle(v[0].w, v[1].w, newest, 1, 2, 4);
    default:
      return closest_on_tetrahedron(v[0].w, v[1].w, v[2].w, newest);
  }
}

// Of at least one vertex.
[[nodiscard]] [[gnu::noinline]] inline ClosestPoint closest_to_origin(Simplex simplex) {
  simplex.size -= 1;
  return closest_to_origin(simplex, simplex.vertices[simplex.size].w);
}

// Keeps the vertices that span a closest point, in their order.
inline void keep(Simplex& simplex, unsigned vertices) {
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

// What at most three vertices weigh in their closest point.
[[nodiscard]] inline std::array<Real, 3> weights_of(const Simplex& simplex, const Vec3& closest) {
  const auto& v = simplex.vertices;
  if (simplex.size == 1) {
    return {1, 0, 0};
  }
  if (simplex.size == 2) {
    const Vec3 d = v[1].w - v[0].w;
    const Real t = dot(closest - v[0].w, d) / squared_norm(d);
    return {1 - t, t, 0};
  }
  const Vec3 normal = cross(v[0].w - v[2].w, v[1].w - v[2].w);
  const Vec3 p = v[0].w - closest, q = v[1].w - closest, r = v[2].w - closest;
  // Of slivers rounding leaves weights below zero, which would lead out of the body.
  const auto weight = [&](const Vec3& from, const Vec3& to) {
    const Real area = dot(normal, cross(from, to));
    return area > 0 ? area : 0;
  };
  const Real wp = weight(q, r), wq = weight(r, p), wr = weight(p, q), sum = wp + wq + wr;
  if (!(sum > 0)) {
    return {1, 0, 0};
  }
  const Real scale = 1 / sum;
  return {scale * wp, scale * wq, scale * wr};
}

// The point of a simplex with these weights: of a, and of the difference.
struct WeightedPoint {
  Vec3 a, w;
};
[[nodiscard]] inline WeightedPoint point_with(const Simplex& simplex, const std::array<Real, 3>& weights) {
  const auto& v = simplex.vertices;
  const auto& [p, q, r] = weights;
  switch (simplex.size) {
    case 1:
      return {v[0].a, v[0].w};
    case 2:
      return {v[0].a + q * (v[1].a - v[0].a), v[0].w + q * (v[1].w - v[0].w)};
    default:
      return {p * v[0].a + q * v[1].a + r * v[2].a, p * v[0].w + q * v[1].w + r * v[2].w};
  }
}

// The point of a under the closest point of at most three vertices, with the weights that it has there.
[[nodiscard]] inline Vec3 witness_on_a(const Simplex& simplex, const Vec3& closest) {
  return point_with(simplex, weights_of(simplex, closest)).a;
}

}  // namespace abut
