// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope.depth_minimum;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.newton_step;

namespace abut {
namespace {

constexpr int minimum_rounds = 12;
// Tangents of the angles of caps that are tried, by halving the range of their logarithms.
constexpr Real widest_cap = 400, narrowest_cap = 0.01;
constexpr int cap_rounds = 6;

// What is left of the edges on both sides of the point of a minimum, and of the pieces there: D surely holds that much
// of them around the point.
struct Surroundings {
  QuadraticForm edges{0, 0, 0};
  Real share_a = 1, share_b = 1;
};
[[nodiscard]] Surroundings surroundings_of(const PairSecondOrder& near, const NewtonStep& step) {
  Surroundings left;
  std::array<Real, 2> rests{0, 0};
  for (std::size_t i = 0; i < step.count; ++i) {
    rests[i] = std::fmin(step.shares[i], 1 - step.shares[i]);
  }
  if (is_in_triangle(near, step)) {
    const Real third = 0.5 * (1 - step.shares[0] - step.shares[1]);
    rests[0] = rests[1] = std::fmax(0, std::fmin(third, std::fmin(step.shares[0], step.shares[1])));
  } else {
    for (std::size_t i = 0; i < step.count; ++i) {
      const SecondOrder& owner = near.owner(step.edges[i]);
      if (!owner.is_sum && owner.xx + owner.yy > 0) {
        rests[i] *= 0.5;
        (near.is_of_a(step.edges[i]) ? left.share_a : left.share_b) = 1 - step.shares[i] - rests[i];
      }
    }
  }
  for (std::size_t i = 0; i < step.count; ++i) {
    const InFrame& edge = near.edge(step.edges[i]);
    const Real square = edge.x * edge.x + edge.y * edge.y, rest = square > 0 ? rests[i] / std::sqrt(square) : 0;
    left.edges.xx += rest * edge.x * edge.x;
    left.edges.xy += rest * edge.x * edge.y;
    left.edges.yy += rest * edge.y * edge.y;
  }
  return left;
}

// By what form the support function surely exceeds that of the point, anywhere in a cap. A ball that touches there
// loses nothing. An edge counts by its length over that of w.
[[nodiscard]] QuadraticForm form_in_cap(const PairSecondOrder& near, const Surroundings& left, Real tangent) {
  const Real ends = (1 + std::sqrt(1 + tangent * tangent)) / tangent;
  QuadraticForm form{ends * left.edges.xx, ends * left.edges.xy, ends * left.edges.yy};
  const auto add = [&](Real share, const SecondOrder& core) {
    if (core.ball > 0) {
      form.xx += share * core.ball;
      form.yy += share * core.ball;
    } else {
      form.add(share * stiffness_at(core, tangent), core);
    }
  };
  add(left.share_a, near.a);
  add(left.share_b, near.b);
  return form;
}

// With the widest cap in which nothing is less than the depth, but for a tolerance.
[[nodiscard]] std::optional<DepthMinimum> proven_minimum(const DirectionFrame& frame, const PairSecondOrder& near,
                                                         const NewtonStep& step, Real tolerance) {
  DepthMinimum found = minimum_at(frame, near, step);
  const Surroundings left = surroundings_of(near, step);
  // The form grows as the cap shrinks.
  const auto holds = [&](Real tangent) {
    return form_in_cap(near, left, tangent).is_at_least(found.depth - tolerance);
  };
  Real tangent = widest_cap;
  if (!holds(tangent)) {
    tangent = narrowest_cap;
    if (!holds(tangent)) {
      return std::nullopt;
    }
    Real too_wide = widest_cap;
    for (int round = 0; round < cap_rounds; ++round) {
      const Real middle = std::sqrt(tangent * too_wide);
      (holds(middle) ? tangent : too_wide) = middle;
    }
  }
  if (!(found.depth > 0)) {
    return std::nullopt;
  }
  const Real short_by = found.depth - form_in_cap(near, left, tangent).least();
  found.lower = found.depth - error_after(near, step) - std::fmax(short_by, 0);
  found.cosine = 1 / std::sqrt(1 + tangent * tangent);
  return found;
}

}  // namespace

DepthMinimum minimum_at(const DirectionFrame& frame, const PairSecondOrder& near, const NewtonStep& step) {
  const InFrame point = point_after(near, step);
  // The points of both cores whose difference is that point.
  InFrame on_a = near.a.point;
  for (std::size_t i = 0; i < step.count; ++i) {
    if (near.is_of_a(step.edges[i])) {
      const InFrame& edge = near.edge(step.edges[i]);
      on_a.x += step.shares[i] * edge.x;
      on_a.y += step.shares[i] * edge.y;
      on_a.n += step.shares[i] * edge.n;
    }
  }
  // A disc has one under any point near its middle.
  if (const Real disc = near.a.disc + near.b.disc; disc > 0) {
    const Real part = near.a.disc / disc;
    on_a.x -= part * point.x;
    on_a.y -= part * point.y;
  }
  const Vec3 point_a = on_a.n * frame.n + on_a.x * frame.x + on_a.y * frame.y;
  return {frame.n, point.n, point.n + slant_of(near, step), point.n, 1, point_a, point_a - point.n * frame.n};
}

std::optional<DepthMinimum> minimum_near(const Difference& cores, const Vec3& direction, Real error, Real noise) {
  const Real tolerance = error / 16;
  Vec3 n = direction;
  for (int round = 0; round < minimum_rounds; ++round) {
    const DirectionFrame frame = frame_along(n);
    const PairSecondOrder near = cores.second_order(frame);
    const auto step = newton_step(near, noise, tolerance);
    if (!step) {
      return std::nullopt;
    }
    if (error_after(near, *step) <= tolerance) {
      return proven_minimum(frame, near, *step, tolerance);
    }
    const Real shorten = step->square > 0.25 ? 0.5 / std::sqrt(step->square) : 1;
    const auto next = UnitVec3::make(n + (shorten * step->x) * frame.x + (shorten * step->y) * frame.y);
    if (!next) {
      return std::nullopt;
    }
    n = *next;
  }
  return std::nullopt;
}

}  // namespace abut
