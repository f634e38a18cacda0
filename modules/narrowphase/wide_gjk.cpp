module abut.narrowphase.wide_gjk;
import abut.core.standard;
import abut.math;
import abut.math.wide;
import abut.narrowphase.gjk;
import abut.narrowphase.simplex;
import abut.shape;

namespace abut {
namespace {

// The points of b are not those of a less the rounded difference: weighted sums of slivers would show it.
struct WideSimplex {
  std::array<WideVec3, 4> differences{no_difference, no_difference, no_difference, no_difference};
  std::array<SupportPair, 4> pairs{};
  std::size_t size = 0;

  static constexpr WideVec3 no_difference{0, 0, 0};

  void push(const SupportPair& pair) {
    differences[size] = wide_difference(pair.a, pair.b);
    pairs[size] = pair;
    ++size;
  }
  [[nodiscard]] ClosestPointOf<WideVec3> closest_to_origin() const {
    const auto& [p, q, r, s] = differences;
    switch (size) {
      case 1:
        return {p, 1};
      case 2:
        return closest_on_segment(p, q, 1, 2);
      case 3:
        return closest_on_triangle(p, q, r, 1, 2, 4);
      default:
        return closest_on_tetrahedron(p, q, r, s);
    }
  }
  void keep(unsigned vertices) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if ((vertices >> i & 1u) != 0) {
        differences[kept] = differences[i];
        pairs[kept] = pairs[i];
        ++kept;
      }
    }
    size = kept;
  }
  [[nodiscard]] Simplex rounded_simplex() const {
    Simplex simplex;
    for (std::size_t i = 0; i < size; ++i) {
      simplex.push({rounded(differences[i]), pairs[i].a, pairs[i].index_a, pairs[i].index_b});
    }
    return simplex;
  }
};

}  // namespace

WideGjkResult wide_gjk(const SupportPairFunction& support, const Vec3& toward, Real size, Real error, Real limit, Real unproven) {
  const Real touching = touching_distance(size);
  unproven = std::fmin(unproven, error);
  WideGjkResult result{};
  GjkResult& gjk = result.gjk;
  WideSimplex simplex;
  simplex.push(support(toward));
  WideVec3 v = simplex.differences[0];
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
    const Vec3 normal = *UnitVec3::make(-rounded(v));
    const SupportPair newest = support(normal);
    const WideVec3 difference = wide_difference(newest.b, newest.a);
    const Real reach = static_cast<Real>(normal.x * difference.x + normal.y * difference.y + normal.z * difference.z);
    if (reach > best) {
      best = reach;
      gjk.normal = normal;
    }
    gjk.lower = std::fmax(best, 0.0);
    gjk.beyond = gjk.lower > 0 && (limit < 0 || gjk.lower > limit);
    const Real allowed = gjk.lower > 0 ? error : unproven;
    const bool is_known = std::ranges::any_of(std::span(simplex.pairs).first(simplex.size), [&](const SupportPair& pair) {
      return pair.a == newest.a && pair.b == newest.b;
    });
    if (gjk.beyond || gjk.upper - reach <= allowed || is_known) {
      break;
    }
    WideSimplex larger = simplex;
    larger.push(newest);
    const ClosestPointOf<WideVec3> closest = larger.closest_to_origin();
    if (closest.vertices == all_of_tetrahedron) {
      simplex = larger;
      gjk.overlap = true;
      break;
    }
    const Wide closest_square = squared_norm(closest.point);
    if (!(closest_square < square)) {
      break;
    }
    larger.keep(closest.vertices);
    simplex = larger;
    v = closest.point;
    square = closest_square;
  }
  gjk.closest = rounded(v);
  gjk.simplex = simplex.rounded_simplex();
  gjk.lower = std::fmin(gjk.lower, gjk.upper);
  const Real small = std::fmax(unproven_limit * touching, unproven);
  gjk.overlap = gjk.overlap || (!(gjk.lower > 0) && gjk.upper <= small);
  if (!gjk.overlap) {
    const auto& [p, q, r, s] = simplex.differences;
    const std::array<Real, 3> weights = weights_of(simplex.size, p, q, r, v);
    for (std::size_t i = 0; i < simplex.size; ++i) {
      result.point_a += weights[i] * simplex.pairs[i].a;
      result.point_b += weights[i] * simplex.pairs[i].b;
    }
  }
  return result;
}

}  // namespace abut
