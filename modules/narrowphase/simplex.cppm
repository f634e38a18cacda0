// The point of a simplex that is closest to the origin, for GJK.
//
// Which face of a simplex is closest is decided by the signs of sub-determinants compared with the
// sign of the whole (signed volumes: Montanari, Petrinic, Barbieri, "Improving the GJK algorithm for
// faster and more reliable distance queries", ACM TOG 36(3), 2017), so that slivers and flat simplices
// need no thresholds: where a determinant vanishes, all its faces are candidates and the closest wins.
module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
export module abut.narrowphase.simplex;
import abut.math;

export namespace abut {

// A vertex w = a - b of the Minkowski difference, with the point a that it came from; b is a - w.
struct DifferenceVertex {
  Vec3 w, a;
  std::uint32_t index_a, index_b;
};

struct Simplex {
  std::array<DifferenceVertex, 4> vertices;
  std::array<Real, 4> weights;  // of the closest point
  std::size_t size = 0;

  inline void push(const DifferenceVertex& vertex) { vertices[size++] = vertex; }
  [[nodiscard]] inline bool contains(const DifferenceVertex& vertex) const {
    for (std::size_t i = 0; i < size; ++i) {
      if (vertices[i].index_a == vertex.index_a && vertices[i].index_b == vertex.index_b) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] inline Vec3 witness_a() const {
    Vec3 sum = weights[0] * vertices[0].a;
    for (std::size_t i = 1; i < size; ++i) {
      sum += weights[i] * vertices[i].a;
    }
    return sum;
  }
};

// A choice of vertices of a simplex with their weights, and the point that they make.
struct ClosestPoint {
  Vec3 point;
  std::array<std::uint8_t, 4> chosen;
  std::array<Real, 4> weights;
  std::size_t size;
  bool encloses_origin;
};

[[nodiscard]] inline ClosestPoint closest_on_segment(const Vec3& p, const Vec3& q, std::uint8_t ip, std::uint8_t iq) {
  const Vec3 d = q - p;
  const Real along = -dot(p, d), length = squared_norm(d);
  if (!(along > 0)) {
    return {p, {ip}, {1}, 1, false};
  }
  if (!(along < length)) {
    return {q, {iq}, {1}, 1, false};
  }
  const Real t = along / length;
  const Vec3 near = p + t * d;
  // Projected again: where the point is small beside p, its direction would be rounding of p.
  return {near - (dot(near, d) / length) * d, {ip, iq}, {1 - t, t}, 2, false};
}

// r is the newest vertex. The closest point of a triangle that GJK extends lies on a face with r in
// it; the edge p q only counts when rounding says so.
[[nodiscard]] inline ClosestPoint closest_on_triangle(const Vec3& p, const Vec3& q, const Vec3& r, std::uint8_t ip,
                                                      std::uint8_t iq, std::uint8_t ir) {
  const Vec3 normal = cross(p - r, q - r);
  const Real square = squared_norm(normal);
  bool try_pr = true, try_qr = true, try_pq = true;
  if (square > 0) {
    const Real height = dot(normal, r);
    const Vec3 foot = (height / square) * normal;
    const Vec3 fp = p - foot, fq = q - foot, fr = r - foot;
    const Real wp = dot(normal, cross(fq, fr)), wq = dot(normal, cross(fr, fp)), wr = dot(normal, cross(fp, fq));
    if (wp > 0 && wq > 0 && wr > 0) {
      const Real scale = 1 / (wp + wq + wr);
      return {foot, {ip, iq, ir}, {scale * wp, scale * wq, scale * wr}, 3, false};
    }
    try_qr = !(wp > 0);
    try_pr = !(wq > 0);
    try_pq = !(wr > 0);
  }
  ClosestPoint best{};
  Real best_square = infinity;
  const auto consider = [&](const ClosestPoint& candidate) {
    const Real candidate_square = squared_norm(candidate.point);
    if (candidate_square < best_square) {
      best = candidate;
      best_square = candidate_square;
    }
  };
  if (try_pr) {
    consider(closest_on_segment(p, r, ip, ir));
  }
  if (try_qr) {
    consider(closest_on_segment(q, r, iq, ir));
  }
  if (try_pq) {
    consider(closest_on_segment(p, q, ip, iq));
  }
  return best;
}

// The simplex p q r s, s being the newest. With cofactors of mixed signs the origin is outside the
// faces opposite to the vertices whose sign differs from that of the volume.
[[nodiscard]] inline ClosestPoint closest_on_tetrahedron(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 sp = p - s, sq = q - s, sr = r - s;
  const Vec3 qr = cross(sq, sr), rp = cross(sr, sp), pq = cross(sp, sq);
  const Real volume = dot(sp, qr);
  // Heights of the origin over the planes of the faces through s, in units of the volume.
  const Real hp = -dot(s, qr), hq = -dot(s, rp), hr = -dot(s, pq);
  const Vec3 base = cross(q - p, r - p);
  const Real hs = -dot(p, base);  // the face p q r; s itself has height -volume
  // A volume that is no more than rounding says nothing about sides: then every face is a candidate.
  const Real noise = 16 * epsilon * largest_magnitude(sp) * largest_magnitude(sq) * largest_magnitude(sr);
  const bool flat = !(volume > noise || volume < -noise);
  const auto outside = [&](Real h) { return flat || !(volume > 0 ? h >= 0 : h <= 0); };
  const bool out_p = outside(hp), out_q = outside(hq), out_r = outside(hr), out_s = outside(-hs);
  if (!(out_p || out_q || out_r || out_s)) {
    const Real scale = 1 / volume;
    return {{0, 0, 0}, {0, 1, 2, 3}, {scale * hp, scale * hq, scale * hr, 1 - scale * (hp + hq + hr)}, 4, true};
  }
  ClosestPoint best{};
  Real best_square = infinity;
  const auto consider = [&](const ClosestPoint& candidate) {
    const Real candidate_square = squared_norm(candidate.point);
    if (candidate_square < best_square) {
      best = candidate;
      best_square = candidate_square;
    }
  };
  if (out_p) {
    consider(closest_on_triangle(q, r, s, 1, 2, 3));
  }
  if (out_q) {
    consider(closest_on_triangle(p, r, s, 0, 2, 3));
  }
  if (out_r) {
    consider(closest_on_triangle(p, q, s, 0, 1, 3));
  }
  if (out_s) {
    consider(closest_on_triangle(p, q, r, 0, 1, 2));
  }
  return best;
}

[[nodiscard]] inline ClosestPoint closest_to_origin(const Simplex& simplex) {
  const auto& v = simplex.vertices;
  switch (simplex.size) {
    case 1:
      return {v[0].w, {0}, {1}, 1, false};
    case 2:
      return closest_on_segment(v[0].w, v[1].w, 0, 1);
    case 3:
      return closest_on_triangle(v[0].w, v[1].w, v[2].w, 0, 1, 2);
    default:
      return closest_on_tetrahedron(v[0].w, v[1].w, v[2].w, v[3].w);
  }
}

// Keeps the chosen vertices, in their order.
inline void keep(Simplex& simplex, const ClosestPoint& closest) {
  for (std::size_t i = 0; i < closest.size; ++i) {
    simplex.vertices[i] = simplex.vertices[closest.chosen[i]];
    simplex.weights[i] = closest.weights[i];
  }
  simplex.size = closest.size;
}

}  // namespace abut
