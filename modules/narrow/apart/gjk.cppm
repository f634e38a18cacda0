// SPDX-License-Identifier: Apache-2.0
// Distance of two convex cores by GJK (Gilbert, Johnson, Keerthi 1988).
//
// Ends by a proof, not by a count: with v the closest point of the current simplex of the Minkowski
// difference and w the support point against it, dot(v, w) / |v| <= distance <= |v|. When the two agree
// within the error bound, the distance is certified. When rounding stops progress first, the interval
// that was reached is reported as it is.
export module abut.narrow.apart.gjk;
import abut.capability;
import abut.core.standard;
import abut.math;
export import abut.math.tolerance;
import abut.narrow.cores.simplex;

export namespace abut {

struct GjkResult {
  bool overlap;       // the cores overlap or touch within rounding; the rest is then undefined but the simplex
  bool beyond;        // stopped early: the distance is at least `lower`, which exceeds the limit asked for
  Real lower, upper;  // the distance of the cores lies between them
  Vec3 closest;       // the closest point of the difference: from b to a; where it stopped early, along what bounds it
  Vec3 normal;        // unit, from a to b
  Simplex simplex;
  std::uint32_t iterations;
};

// Bounded work: no pair in the tests needs more than a third of this.
inline constexpr std::uint32_t gjk_iteration_limit = 96;
inline constexpr std::uint32_t stall_limit = 4;
// Unproven distances below this many times the touching distance are left to the overlap routes.
inline constexpr Real unproven_limit = 1e4;

// The unit direction from the closest point of a simplex to the origin. Of a triangle it is the
// normal, which stays exact when the distance is so small that the closest point is rounding.
[[nodiscard]] inline Vec3 normal_of(const Simplex& simplex, const Vec3& closest, Real distance) {
  if (simplex.size == 3) {
    const Vec3& r = simplex.vertices[2].w;
    const Vec3 normal = cross(simplex.vertices[0].w - r, simplex.vertices[1].w - r);
    const Real square = squared_norm(normal);
    if (square > 0) {
      return (std::copysign(Real{1}, -dot(normal, closest)) / std::sqrt(square)) * normal;
    }
  }
  // Cores that touch in a point have none of their own.
  return distance > 0 ? (-1 / distance) * closest : Vec3{0, 0, 1};
}

// The cores of a and b in the frame of a, b being placed by ab. `size` bounds the coordinates of both;
// `toward` points from a to b as far as is known; `error` is the gap that is allowed; `limit`: stop as
// soon as the distance is known to exceed it; `unproven`: a smaller gap that is allowed as long as nothing
// proves the cores apart.
template <Convex A, Convex B>
[[nodiscard]] GjkResult gjk(const A& a, const B& b, const Pose& ab, const Vec3& toward, Real size, Real error,
                            Real limit, Real unproven = infinity) {
  unproven = unproven < error ? unproven : error;
  const auto placement = place(b, ab);
  [[clang::uninitialized]] GjkResult result;
  result.overlap = false;
  result.beyond = false;
  result.simplex.size = 0;
  Simplex& simplex = result.simplex;

  const Real touching = touching_distance(size);
  // One support point of each per round, the first along `toward`.
  Vec3 v = -toward;
  Real square = infinity;
  // The best lower bound so far, reach / sqrt(square), kept as it is to spare the root.
  Real best_reach = 0, best_square = 1;

  std::uint32_t stalls = 0;
  std::uint32_t iteration = 0;
  for (; iteration < gjk_iteration_limit; ++iteration) {
    const SupportPoint on_a = a.support(-v), on_b = placed_support(b, placement, v);
    // The next step reads `newest` from registers. It is stored number by number: copied whole, it would be read in
    // wider pieces than it was written in, each of which waits for the stores.
    const Vec3 newest = on_a.point - on_b.point;
    DifferenceVertex& vertex = simplex.vertices[simplex.size];
    vertex.w = newest;
    vertex.a = on_a.point;
    vertex.index_a = on_a.index;
    vertex.index_b = on_b.index;
    if (simplex.size == 0) {
      simplex.size = 1;
      v = newest;
      square = squared_norm(v);
      if (!(square > touching * touching)) {
        result.overlap = true;
        break;
      }
      continue;
    }
    const Real reach = dot(v, newest);
    if (reach > 0 && reach * reach * best_square > best_reach * best_reach * square) {
      best_reach = reach;
      best_square = square;
      if (limit < 0 || reach * reach > limit * limit * square) {
        result.beyond = true;
        break;
      }
    }
    const Real gap = square - reach;  // (upper - lower) * |v|
    const Real allowed = best_reach > 0 ? error : unproven;
    if (gap * gap <= allowed * allowed * square || gap <= 0 || simplex.contains(vertex)) {
      break;
    }
    const ClosestPoint closest = closest_to_origin(simplex, newest);
    simplex.size += 1;
    if (closest.vertices == all_of_tetrahedron) {
      result.overlap = true;
      break;
    }
    const Real closest_square = squared_norm(closest.point);
    if (!(closest_square < square)) {
      // A face that is no closer within rounding may still turn the direction, and with it raise the
      // lower bound; more than a few of those in a row lead nowhere.
      ++stalls;
      if (stalls > stall_limit || !(closest_square <= square + touching * (2 * std::sqrt(square) + touching))) {
        simplex.size -= 1;  // what was reached before is the answer
        break;
      }
    }
    keep(simplex, closest.vertices);
    v = closest.point;
    square = closest_square;
    if (!(square > touching * touching)) {
      result.overlap = true;
      break;
    }
  }
  const Real lower = best_reach / std::sqrt(best_square);
  result.iterations = iteration;
  result.closest = v;
  if (result.beyond) {
    result.lower = lower;
    return result;
  }
  result.upper = std::sqrt(square);
  result.lower = lower < result.upper ? lower : result.upper;
  // A separation without proof, no larger than what rounding adds up to or than what is allowed of it, is a touch:
  // how deep it is needs another search.
  const Real small = unproven_limit * touching > unproven ? unproven_limit * touching : unproven;
  result.overlap = result.overlap || (!(lower > 0) && result.upper <= small);
  result.normal = normal_of(simplex, v, result.upper);
  return result;
}

}  // namespace abut
