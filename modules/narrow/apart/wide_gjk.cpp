// SPDX-License-Identifier: Apache-2.0
module abut.narrow.apart.wide_gjk;
import abut.capability;
import abut.core.standard;
import abut.math.wide;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;

namespace abut {
namespace {

// The points of b are kept too: those of a less the rounded difference are others, which weighted sums of slivers would
// show.
struct WideVertex {
  WideVec3 w{0, 0, 0};
  SupportPair of{};

  WideVertex() = default;
  explicit WideVertex(const SupportPair& pair) : w(wide_difference(pair.a, pair.b)), of(pair) {}
};

struct WideSimplex {
  std::array<WideVertex, 4> vertices;
  std::size_t size = 0;

  void push(const WideVertex& vertex) { vertices[size++] = vertex; }
  [[nodiscard]] bool contains(const SupportPair& pair) const {
    return std::ranges::any_of(std::span(vertices).first(size), [&](const WideVertex& vertex) {
      return vertex.of.a == pair.a && vertex.of.b == pair.b;
    });
  }
};

[[nodiscard]] ClosestPointOf<WideVec3> closest_to_origin(const WideSimplex& simplex) {
  const auto& [p, q, r, s] = simplex.vertices;
  switch (simplex.size) {
    case 1: return {p.w, 1};
    case 2: return closest_on_segment(p.w, q.w, 1, 2);
    case 3: return closest_on_triangle(p.w, q.w, r.w, 1, 2, 4);
    default: return closest_on_tetrahedron(p.w, q.w, r.w, s.w);
  }
}

[[nodiscard]] Simplex rounded(const WideSimplex& wide) {
  Simplex simplex;
  for (const WideVertex& vertex : std::span(wide.vertices).first(wide.size)) {
    simplex.push({rounded(vertex.w), vertex.of.a, vertex.of.index_a, vertex.of.index_b});
  }
  return simplex;
}

}  // namespace

WideGjkResult wide_gjk(const Difference& cores, const Vec3& toward, Real error, Real limit, Real unproven) {
  const Real size = cores.size;
  const Real touching = touching_distance(size);
  unproven = std::fmin(unproven, error);
  WideGjkResult result{};
  GjkResult& gjk = result.gjk;
  WideSimplex simplex;
  simplex.push(WideVertex(cores.support(toward)));
  WideVec3 v = simplex.vertices[0].w;
  Wide square = squared_norm(v);
  gjk.normal = UnitVec3::axis_z();
  Real best = -infinity;  // of the gaps along the directions so far
  for (; gjk.iterations < gjk_iteration_limit; ++gjk.iterations) {
    gjk.upper = std::sqrt(square.high);
    if (!(gjk.upper > touching)) {
      gjk.overlap = true;
      break;
    }
    // What is asked for is the rounded direction, and the bound is that along it.
    const Vec3 normal = *UnitVec3::make(-rounded(v));  // is there: shapes have no coordinates beyond 1e70
    const SupportPair newest = cores.support(normal);
    const WideVec3 difference = wide_difference(newest.b, newest.a);
    const Real reach = static_cast<Real>(normal.x * difference.x + normal.y * difference.y + normal.z * difference.z);
    if (reach > best) {
      best = reach;
      gjk.normal = normal;
    }
    gjk.lower = std::fmax(best, 0.0);
    gjk.beyond = gjk.lower > 0 && (limit < 0 || gjk.lower > limit);
    const Real allowed = gjk.lower > 0 ? error : unproven;
    if (gjk.beyond || gjk.upper - reach <= allowed || simplex.contains(newest)) {
      break;
    }
    WideSimplex larger = simplex;
    larger.push(WideVertex(newest));
    const ClosestPointOf<WideVec3> closest = closest_to_origin(larger);
    if (closest.vertices == all_of_tetrahedron) {
      simplex = larger;
      gjk.overlap = true;
      break;
    }
    const Wide closest_square = squared_norm(closest.point);
    if (!(closest_square < square)) {
      break;
    }
    keep(larger, closest.vertices);
    simplex = larger;
    v = closest.point;
    square = closest_square;
  }
  gjk.closest = rounded(v);
  gjk.simplex = rounded(simplex);
  gjk.lower = std::fmin(gjk.lower, gjk.upper);
  const Real small = std::fmax(unproven_limit * touching, unproven);
  gjk.overlap = gjk.overlap || (!(gjk.lower > 0) && gjk.upper <= small);
  if (!gjk.overlap) {
    const auto& [p, q, r, s] = simplex.vertices;
    const std::array<Real, 3> weights = weights_of(simplex.size, p.w, q.w, r.w, v);
    for (std::size_t i = 0; i < simplex.size; ++i) {
      result.point_a += weights[i] * simplex.vertices[i].of.a;
      result.point_b += weights[i] * simplex.vertices[i].of.b;
    }
  }
  return result;
}

}  // namespace abut
