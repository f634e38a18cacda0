// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope.depth_descent;
import abut.capability.cores.second_order;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.newton_step;

namespace abut {
namespace {

constexpr int descent_rounds = 40, corrections = 2;
// Lengths of moves; what is shorter than the last one is at the bottom of its valley.
constexpr Real longest_move = 0.5, shortest_move = 1e-9, settled_move = 1e-14;
constexpr Real stiff_share = 1e-3;  // of the depth: less bend than that makes no valley

// From a direction n to n + (x, y).
struct Move {
  Real x, y;
};
[[nodiscard]] inline Real length_of(Real x, Real y) { return std::sqrt(x * x + y * y); }

// To the bottom of a smooth valley, across which the second-order model bends most.
[[nodiscard]] Move move_across_bend(const PairSecondOrder& near, Real radius) {
  const InFrame& r = near.point;
  const Real xx = near.a.xx + near.b.xx - r.n, xy = near.a.xy + near.b.xy, yy = near.a.yy + near.b.yy - r.n;
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

// The move across the valley around a direction to its bottom; zero where the bottom is farther than a radius.
[[nodiscard]] Move move_to_bottom(const PairSecondOrder& near, Real radius) {
  const InFrame& r = near.point;
  Move to_bottom{0, 0};
  Real deepest = -1;
  for (std::size_t i = 0; i < near.edge_count(); ++i) {
    const InFrame& u = near.edge(i);
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
  return deepest >= 0 ? to_bottom : move_across_bend(near, radius);
}

// Moves of one length that may lead down: against the slope, and along each crease from where it is nearest.
using Moves = SmallVector<Move, 13>;
void collect_moves(const PairSecondOrder& near, Real length, Moves& moves) {
  moves.clear();
  const InFrame& r = near.point;
  if (const Real slope = length_of(r.x, r.y); slope > 0) {
    moves.push_back({-length * r.x / slope, -length * r.y / slope});
  }
  for (std::size_t i = 0; i < near.edge_count(); ++i) {
    const InFrame& u = near.edge(i);
    const Real size = length_of(u.x, u.y);
    if (!(std::fabs(u.n) < length * size)) {
      continue;
    }
    const Move at{-u.n / size * (u.x / size), -u.n / size * (u.y / size)};
    const Move along{-length * u.y / size, length * u.x / size};
    moves.push_back({at.x + along.x, at.y + along.y});
    moves.push_back({at.x - along.x, at.y - along.y});
  }
}

[[nodiscard]] inline Vec3 moved(const DirectionFrame& frame, const Move& move) {
  return UnitVec3::make(frame.n + move.x * frame.x + move.y * frame.y).value_or(UnitVec3::axis_z()).vec();
}

// The best direction that moves have led to so far.
struct Lowest {
  Vec3 normal;
  Real depth;

  // Each move is judged before and after it is brought back to the bottom of its valley.
  void try_move(const Difference& cores, const DirectionFrame& frame, const Move& move, Real radius) {
    Vec3 n = moved(frame, move);
    for (int correction = 0; correction < corrections; ++correction) {
      if (const Real there = cores.depth_along(n); there < depth) {
        depth = there;
        normal = n;
      }
      const DirectionFrame beside = frame_along(n);
      const Move back = move_to_bottom(cores.second_order(beside), radius);
      if (std::fabs(back.x) + std::fabs(back.y) < settled_move) {
        return;
      }
      n = moved(beside, back);
    }
  }
};

}  // namespace

Descent descend(const Difference& cores, const Vec3& from, Real error, Real noise) {
  const Real least_gain = error / 64;
  Descent here{from, cores.depth_along(from), std::nullopt};
  Real radius = longest_move;
  for (int round = 0; round < descent_rounds && radius > shortest_move; ++round) {
    const DirectionFrame frame = frame_along(here.normal);
    const PairSecondOrder near = cores.second_order(frame);
    const auto step = newton_step(near, noise, error / 16);
    if (const Real off = step ? error_after(near, *step) : infinity; off <= error / 16) {
      here.minimum = minimum_at(frame, near, *step);
      // The model may be off by rounding: the depth is the overlap along the normal, and less by `off` beside it.
      here.minimum->depth = here.minimum->upper = here.depth;
      here.minimum->lower = here.depth - off;
      here.minimum->point_b = here.minimum->point_a - here.depth * here.normal;
      return here;
    }
    Lowest lowest{here.normal, here.depth - least_gain};
    Real reached = 0.03125 * radius;
    // A long move may end on the other side of a narrow place, barely lower: a short one competes with it.
    for (const Real reach : {radius, 0.25 * radius}) {
      const Real before = lowest.depth;
      if (step) {
        const Real shorten = step->square > reach * reach ? reach / std::sqrt(step->square) : 1;
        lowest.try_move(cores, frame, {shorten * step->x, shorten * step->y}, radius);
      }
      if (!(lowest.depth < before)) {
        [[clang::uninitialized]] Moves moves;
        collect_moves(near, reach, moves);
        for (const Move& move : moves.span()) {
          lowest.try_move(cores, frame, move, radius);
        }
      }
      reached = lowest.depth < before ? reach : reached;
    }
    if (lowest.depth < here.depth - least_gain) {
      here = {lowest.normal, lowest.depth, std::nullopt};
    }
    radius = std::fmin(longest_move, 2 * reached);
  }
  return here;
}

}  // namespace abut
