// Least depths of two cores where many directions are nearly as good: bodies of revolution that almost share an axis, a speck
// inside a round core.
//
// The support function of their difference D then has a long valley whose bottom hardly falls. A straight step along it leaves the
// bottom by more than it gains, so each step is brought back to the bottom before it is judged, by the depth itself (second-order
// corrections against the Maratos effect: Nocedal and Wright, "Numerical optimization", 2006, chapters 15 and 18).
export module abut.narrowphase.depth_descent;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.capped_epa;
import abut.narrowphase.depth_minimum;
import abut.narrowphase.epa;
import abut.narrowphase.gjk;
import abut.narrowphase.simplex;
import abut.shape;
import abut.shape.germ;

export namespace abut {

// From a direction n to n + (x, y).
struct Move {
  Real x, y;
};

// The valley around a direction: across it to the bottom, none where the bottom is farther than a radius; and along it, of length one.
struct Valley {
  Move to_bottom, along;
};
[[nodiscard]] Valley valley_of(const PairGerm& germ, Real radius);

// Moves of one length that may lead down: against the slope, where D is softest, and along each crease.
using Moves = SmallVector<Move, 28>;
void collect_moves(const PairGerm& germ, Real length, Moves& moves);

// Where a descent ended: at a minimum whose points are known, or where no move that was tried leads further down.
struct Descent {
  Vec3 normal;
  Real depth;
  std::optional<DepthMinimum> minimum;
};

[[nodiscard]] inline Vec3 moved(const GermFrame& frame, const Move& move) {
  return UnitVec3::make(frame.n + move.x * frame.x + move.y * frame.y).value_or(UnitVec3::axis_z()).vec();
}

inline constexpr int descent_rounds = 40, corrections = 6;
inline constexpr Real first_stride = 0.5, least_stride = 1e-9, settled_stride = 1e-14;

template <Convex A, Convex B>
[[nodiscard]] Descent descend(const A& a, const B& b, const Pose& ab, const Vec3& from, Real error, Real noise) {
  const auto placement = place(b, ab);
  const Real step = error / 64;  // less than this is no progress
  Descent here{from, depth_along(a, b, placement, from), std::nullopt};
  Real radius = first_stride;
  for (int round = 0; round < descent_rounds && radius > least_stride; ++round) {
    const GermFrame frame = frame_along(here.normal);
    const PairGerm germ = pair_germ(a, b, ab, frame);
    Stride stride;
    const bool is_modelled = weighed_stride(germ, noise, error / 16, stride);
    if (is_modelled && error_of_foot(germ, stride) <= error / 16) {
      here.minimum = points_at(frame, germ, stride);
      return here;
    }
    Descent next{here.normal, here.depth - step, std::nullopt};
    bool is_lower = false;
    const auto try_move = [&](const Move& move) {
      Vec3 n = moved(frame, move);
      for (int correction = 0; correction < corrections; ++correction) {
        if (const Real depth = depth_along(a, b, placement, n); depth < next.depth) {
          next = {n, depth, std::nullopt};
          is_lower = true;
        }
        const GermFrame there = frame_along(n);
        const Move back = valley_of(pair_germ(a, b, ab, there), radius).to_bottom;
        if (std::fabs(back.x) + std::fabs(back.y) < settled_stride) {
          break;
        }
        n = moved(there, back);
      }
    };
    if (is_modelled) {
      const Real shorten = stride.square > radius * radius ? radius / std::sqrt(stride.square) : 1;
      try_move({shorten * stride.x, shorten * stride.y});
    }
    if (!is_lower) {
      [[clang::uninitialized]] Moves moves;
      collect_moves(germ, radius, moves);
      for (const Move& move : moves.span()) {
        try_move(move);
      }
    }
    if (is_lower) {
      here = next;
    }
    radius = is_lower ? std::fmin(first_stride, 2 * radius) : 0.25 * radius;
  }
  return here;
}

inline constexpr int walk_steps = 32;
inline constexpr Real walk_stride = 0.2;

// Along the bottom of the valley that a direction lies in, as long as `visit` answers true.
template <Convex A, Convex B, class Visit>
void walk_valley(const A& a, const B& b, const Pose& ab, const Vec3& from, Visit&& visit) {
  Vec3 n = from, ahead{0, 0, 0};
  for (int step = 0; step < walk_steps; ++step) {
    const GermFrame frame = frame_along(n);
    const Move along = valley_of(pair_germ(a, b, ab, frame), walk_stride).along;
    const Real side = dot(along.x * frame.x + along.y * frame.y, ahead) < 0 ? -walk_stride : walk_stride;
    Vec3 next = moved(frame, {side * along.x, side * along.y});
    for (int correction = 0; correction < corrections; ++correction) {
      const GermFrame there = frame_along(next);
      next = moved(there, valley_of(pair_germ(a, b, ab, there), walk_stride).to_bottom);
    }
    ahead = next - n;
    n = next;
    const bool is_around = step > 2 && dot(n, from) > 1 - 0.5 * walk_stride * walk_stride;
    if (is_around || !visit(n)) {
      return;
    }
  }
}

// The points of both cores under a direction, seen from where the cores are apart along it.
template <Convex A, Convex B>
void find_points_under(const A& a, const B& b, const Pose& ab, Real size, Real error, EpaResult& found) {
  const Real apart = 0.25 * size;
  const Vec3 shift = (found.depth + apart) * found.normal;
  const Pose parted{ab.rotation, ab.position + shift};
  const GjkResult near = gjk(a, b, parted, found.normal, size + norm(shift), error, infinity, error);
  if (near.overlap) {
    return;
  }
  const Vec3 on_a = witness_on_a(near.simplex, near.closest), on_b = on_a - near.closest - shift;
  // What is left between the points and the depth is shared by both.
  const Vec3 half = (0.5 * (found.depth + dot(on_b - on_a, found.normal))) * found.normal;
  found.point_a = on_a + half;
  found.point_b = on_b - half;
}

inline constexpr int sweep_reach = 2;
inline constexpr std::size_t sweep_size = 98, descent_limit = 8;
inline constexpr Real valley_share = 1e-3;  // of the depth, by which the bottom of a valley may rise
inline constexpr Real same_start = 0.9;  // cosine between directions that need not both be tried

// The least depth that descents reach from the answer of a search that ended without a proof, from the discs, and from the
// best of a sweep of directions.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline, gnu::cold]] EpaResult least_of_descents(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                                                       const EpaResult& found) {
  const Real noise = 8 * epsilon * size;
  const auto placement = place(b, ab);
  Descent least{found.normal, infinity, std::nullopt};
  const auto keep = [&](const Descent& tried) {
    // Of equal depths the one whose points are known.
    const bool is_better = tried.minimum && !least.minimum ? tried.depth < least.depth + error / 16 : tried.depth < least.depth - error / 16;
    if (is_better || !(least.depth < infinity)) {
      least = tried;
    }
  };
  [[clang::uninitialized]] SmallVector<Vec3, descent_limit + 1> starts;
  const auto descend_from = [&](const Vec3& n) {
    for (const Vec3& start : starts.span()) {
      if (dot(start, n) > same_start) {
        return;
      }
    }
    starts.push_back(n);
    keep(descend(a, b, ab, n, error, noise));
  };
  descend_from(found.normal);
  visit_discs(a, b, ab, [&](const Vec3& axis) { keep({axis, depth_along(a, b, placement, axis), points_under(a, b, ab, axis, error, noise)}); });
  // A flat or slender core bends within so few directions that only its own axes lead there.
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, ab.rotation.x, ab.rotation.y, ab.rotation.z}) {
    for (const Vec3& n : {axis, -axis}) {
      if (depth_along(a, b, placement, n) < least.depth * (1 + valley_share)) {
        keep(descend(a, b, ab, n, error, noise));
      }
    }
  }
  // Toward the points on the surface of a cubic grid.
  [[clang::uninitialized]] SmallVector<Vec3, sweep_size> directions;
  [[clang::uninitialized]] SmallVector<Real, sweep_size> depths;
  for (int x = -sweep_reach; x <= sweep_reach; ++x) {
    for (int y = -sweep_reach; y <= sweep_reach; ++y) {
      for (int z = -sweep_reach; z <= sweep_reach; ++z) {
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == sweep_reach) {
          const Vec3 toward{static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
          directions.push_back((1 / norm(toward)) * toward);
          depths.push_back(depth_along(a, b, placement, directions[directions.size() - 1]));
        }
      }
    }
  }
  while (starts.size() < descent_limit) {
    const auto least_of_sweep = std::ranges::min_element(depths.span());
    if (!(*least_of_sweep < infinity)) {
      break;
    }
    descend_from(directions[static_cast<std::size_t>(least_of_sweep - depths.span().begin())]);
    *least_of_sweep = infinity;
  }
  // A valley may have more low places than the sweep has found, where the other core has corners.
  const Descent first = least;
  walk_valley(a, b, ab, first.normal, [&](const Vec3& n) {
    const Real depth = depth_along(a, b, placement, n);
    const bool is_low = depth < first.depth * (1 + valley_share);
    if (is_low) {
      keep(descend(a, b, ab, n, error, noise));
    }
    return is_low;
  });
  EpaResult better = found;
  better.normal = least.normal;
  better.depth = better.upper = least.depth;
  if (least.minimum) {
    better.point_a = least.minimum->point_a;
    better.point_b = better.point_a - least.depth * least.normal;
  } else {
    find_points_under(a, b, ab, size, error, better);
  }
  better.lower = std::fmin(found.lower, better.depth);
  return better;
}

}  // namespace abut
