module abut.narrow.polytope.depth_descent;
import abut.capability.second_order;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.epa;

namespace abut {
namespace {

constexpr int descent_rounds = 40, corrections = 2;
// Lengths of moves; what is shorter than the last one is at the bottom of its valley.
constexpr Real first_stride = 0.5, least_stride = 1e-9, settled_stride = 1e-14;
constexpr Real stiff_share = 1e-3;  // of the depth: less bend than that makes no valley

[[nodiscard]] inline Real length_of(Real x, Real y) { return std::sqrt(x * x + y * y); }

// To the bottom of a smooth valley, across which the second-order model bends most.
[[nodiscard]] Move move_across_bend(const PairGerm& germ, Real radius) {
  const InFrame& r = germ.point;
  const Real xx = germ.a.xx + germ.b.xx - r.n, xy = germ.a.xy + germ.b.xy, yy = germ.a.yy + germ.b.yy - r.n;
  const Real half = 0.5 * (xx - yy), spread = std::sqrt(half * half + xy * xy), most = 0.5 * (xx + yy) + spread;
  const Move along = half >= 0 ? Move{half + spread, xy} : Move{xy, spread - half};
  const Real length = length_of(along.x, along.y);
  const Move across = length > 0 ? Move{along.x / length, along.y / length} : Move{1, 0};
  if (!(most > stiff_share * r.n)) {
    return {0, 0};
  }
  const Real stride = std::clamp(-(r.x * across.x + r.y * across.y) / most, -radius, radius);
  return {stride * across.x, stride * across.y};
}

// Moves of one length that may lead down: against the slope of each piece, and to each crease and along it.
using Moves = SmallVector<Move, 26>;
void collect_moves(const PairGerm& germ, Real length, Moves& moves) {
  moves.clear();
  const InFrame& r = germ.point;
  const auto add_against = [&](Real x, Real y) {
    if (const Real slope = length_of(x, y); slope > 0) {
      moves.push_back({-length * x / slope, -length * y / slope});
    }
  };
  add_against(r.x, r.y);
  for (std::size_t i = 0; i < germ.step_count(); ++i) {
    const InFrame& u = germ.step(i);
    const Real size = length_of(u.x, u.y);
    if (!(std::fabs(u.n) < length * size)) {
      continue;
    }
    const Move at{-u.n / size * (u.x / size), -u.n / size * (u.y / size)};
    const Move along{-length * u.y / size, length * u.x / size};
    moves.push_back(at);
    moves.push_back({at.x + along.x, at.y + along.y});
    moves.push_back({at.x - along.x, at.y - along.y});
    add_against(r.x + u.x, r.y + u.y);
  }
}

[[nodiscard]] inline Vec3 moved(const GermFrame& frame, const Move& move) {
  return UnitVec3::make(frame.n + move.x * frame.x + move.y * frame.y).value_or(UnitVec3::axis_z()).vec();
}

// The best direction that moves have led to so far.
struct Lowest {
  Vec3 normal;
  Real depth;

  // Each move is judged before and after it is brought back to the bottom of its valley.
  void try_move(const Difference& cores, const GermFrame& frame, const Move& move, Real radius) {
    Vec3 n = moved(frame, move);
    for (int correction = 0; correction < corrections; ++correction) {
      if (const Real there = cores.depth_along(n); there < depth) {
        depth = there;
        normal = n;
      }
      const GermFrame beside = frame_along(n);
      const Move back = move_to_bottom(cores.germ(beside), radius);
      if (std::fabs(back.x) + std::fabs(back.y) < settled_stride) {
        return;
      }
      n = moved(beside, back);
    }
  }
};

}  // namespace

Move move_to_bottom(const PairGerm& germ, Real radius) {
  const InFrame& r = germ.point;
  Move to_bottom{0, 0};
  Real deepest = -1;
  for (std::size_t i = 0; i < germ.step_count(); ++i) {
    const InFrame& u = germ.step(i);
    const Real length = length_of(u.x, u.y);
    if (!(length > 0)) {
      continue;
    }
    // The depth falls up to the crease and rises beyond it.
    const Real away = -u.n / length, fall = -(r.x * u.x + r.y * u.y) / length, rise = length - fall;
    if (!(std::fabs(away) < radius) || fall < 0 || rise < 0) {
      continue;
    }
    if (const Real drop = away > 0 ? away * fall : -away * rise; drop > deepest) {
      deepest = drop;
      to_bottom = {away * u.x / length, away * u.y / length};
    }
  }
  return deepest >= 0 ? to_bottom : move_across_bend(germ, radius);
}

Descent descend(const Difference& cores, const Vec3& from, Real error, Real noise) {
  const Real least_gain = error / 64;
  Descent here{from, cores.depth_along(from), std::nullopt};
  Real radius = first_stride;
  for (int round = 0; round < descent_rounds && radius > least_stride; ++round) {
    const GermFrame frame = frame_along(here.normal);
    const PairGerm germ = cores.germ(frame);
    Stride stride;
    const bool is_modelled = weighed_stride(germ, noise, error / 16, stride);
    if (is_modelled && error_of_foot(germ, stride) <= error / 16) {
      here.minimum = points_at(frame, germ, stride);
      // The model may be off by rounding: the depth is the overlap along the normal.
      here.minimum->depth = here.minimum->upper = here.depth;
      here.minimum->lower = here.depth - error_of_foot(germ, stride);  // beside it the depth may be less by this
      here.minimum->point_b = here.minimum->point_a - here.depth * here.normal;
      return here;
    }
    Lowest lowest{here.normal, here.depth - least_gain};
    Real reached = 0.03125 * radius;
    // A long move may end on the other side of a narrow place, barely lower: a short one competes with it.
    for (const Real reach : {radius, 0.25 * radius}) {
      const Real before = lowest.depth;
      if (is_modelled) {
        const Real shorten = stride.square > reach * reach ? reach / std::sqrt(stride.square) : 1;
        lowest.try_move(cores, frame, {shorten * stride.x, shorten * stride.y}, radius);
      }
      if (!(lowest.depth < before)) {
        [[clang::uninitialized]] Moves moves;
        collect_moves(germ, reach, moves);
        for (const Move& move : moves.span()) {
          lowest.try_move(cores, frame, move, radius);
        }
      }
      reached = lowest.depth < before ? reach : reached;
    }
    if (lowest.depth < here.depth - least_gain) {
      here = {lowest.normal, lowest.depth, std::nullopt};
    }
    radius = std::fmin(first_stride, 2 * reached);
  }
  return here;
}

void find_points_under(const Difference& cores, Real error, EpaResult& found) {
  const Real apart = 0.25 * cores.size;
  const Vec3 shift = (found.depth + apart) * found.normal;
  const auto shifted = [&](const Vec3& direction) {
    SupportPair pair = cores.support(direction);
    pair.b += shift;
    return pair;
  };
  Difference parted;
  parted.support = [&shifted](const Vec3& direction) { return shifted(direction); };
  parted.size = cores.size + norm(shift);
  const WideGjkResult near = wide_gjk(parted, found.normal, error, infinity, error);
  if (near.gjk.overlap) {
    return;
  }
  const Vec3 on_b = near.point_b - shift;
  // The points share what is left between them and the depth.
  const Vec3 half = (0.5 * (found.depth + dot(on_b - near.point_a, found.normal))) * found.normal;
  found.point_a = near.point_a + half;
  found.point_b = on_b - half;
}

}  // namespace abut
