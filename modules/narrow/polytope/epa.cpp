module abut.narrow.polytope.epa;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.polytope;

namespace abut {
namespace {

// Where so many vertices were not enough, the difference is round and many directions are as good: the
// others are spent near one of them, so that at least this one is exact.
constexpr std::uint32_t global_rounds = 5 * Polytope::vertex_limit / 8;

}  // namespace

EpaResult epa(const Difference& cores, Real error, const Simplex& start) {
  const Real noise = cores.noise();

  [[clang::uninitialized]] Polytope polytope;
  polytope.reset();
  const FlatDifference flat = polytope.start(start, noise, cores);
  EpaResult result{0, 0, infinity, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}, 0};
  if (flat.is_flat) {
    // Without volume the depth is zero across the flat, up to the noise that made it flat.
    const DifferenceVertex top = cores.vertex_toward(flat.normal);
    const DifferenceVertex bottom = cores.vertex_toward(-flat.normal);
    const Real above = dot(flat.normal, top.w), below = -dot(flat.normal, bottom.w);
    const bool up = above <= below;
    result.normal = up ? flat.normal : -flat.normal;
    result.depth = result.upper = up ? above : below;
    result.lower = result.depth < 0 ? result.depth : 0;
    result.point_a = up ? top.a : bottom.a;
    result.point_b = result.point_a - (up ? top.w : bottom.w);
    return result;
  }

  std::size_t face = 0;
  Real reach = 0, distance = 0;
  for (std::uint32_t iteration = 1; iteration <= Polytope::vertex_limit; ++iteration) {
    result.iterations = iteration;
    const bool near_by = iteration > global_rounds;
    const std::size_t next = !near_by                         ? polytope.least_face()
                             : iteration == global_rounds + 1 ? polytope.face_along(result.normal)
                                                              : polytope.least_new_face();
    if (next == Polytope::none) [[unlikely]] {
      break;
    }
    face = next;
    const Vec3 normal = polytope.normal(face);
    distance = polytope.distance(face);
    const DifferenceVertex vertex = cores.vertex_toward(normal);
    reach = dot(normal, vertex.w);
    // Face distances only grow; rounding must not make the bound shrink again.
    result.lower = iteration == 1 || (!near_by && distance > result.lower) ? distance : result.lower;
    // Among equal bounds the normal of the latest face, which lies nearest to the boundary.
    if (reach <= result.upper + noise) {
      result.upper = reach < result.upper ? reach : result.upper;
      result.normal = normal;
    }
    if (result.upper - result.lower <= error || reach - distance <= (near_by ? error : noise)) {
      break;
    }
    if (polytope.contains(vertex)) {
      // A sliver whose normal is rounding: the other faces tell more.
      polytope.hide(face);
      continue;
    }
    if (!polytope.expand(face, vertex, noise)) {
      break;
    }
  }
  Witness witness = polytope.witness(face);
  if (cores.is_curved && reach <= result.upper + error && reach - distance <= error) {
    // The points lie under the last face: its normal, which is as good as the best within the bound.
    result.upper = reach;
    result.normal = polytope.normal(face);
  } else if (cores.is_curved && reach - distance > error) {
    // No face lies on the surface yet; the points where both bodies end along the normal do.
    const DifferenceVertex end = cores.vertex_toward(result.normal);
    witness = {end.a, end.a - end.w};
  }
  result.depth = result.upper;
  result.point_a = witness.a;
  result.point_b = witness.b;
  // What is left between the points and the depth, below the error bound, is shared by both.
  const Vec3 half = (0.5 * (result.depth + dot(witness.b - witness.a, result.normal))) * result.normal;
  result.point_a += half;
  result.point_b = result.point_b - half;
  result.lower = result.lower < result.upper ? result.lower : result.upper;
  return result;
}

}  // namespace abut
