// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope.newton_step;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cores.second_order_of_pair;

namespace abut {
namespace {

[[nodiscard]] inline bool is_share(Real share) { return share >= -share_slack && share <= 1 + share_slack; }
[[nodiscard]] inline Real clamped(Real share) { return share < 0 ? 0 : share > 1 ? 1 : share; }

// How much the pieces of a and of b count from which edges lead.
struct Weights {
  Real a = 1, b = 1;
};
[[nodiscard]] Weights weights_after(const PairSecondOrder& near, const NewtonStep& step) {
  Weights weights;
  for (std::size_t i = 0; i < step.count; ++i) {
    if (!near.owner(step.edges[i]).is_sum) {
      (near.is_of_a(step.edges[i]) ? weights.a : weights.b) -= step.shares[i];
    }
  }
  return weights;
}

// Tries all places where a minimum may be and keeps the nearest one.
class StepSearch {
 public:
  StepSearch(const PairSecondOrder& near, const Weights& weights, Real noise, Real tolerance)
      : r_(near.point), form_{-r_.n, 0, -r_.n}, noise_(noise), tolerance_(tolerance) {
    form_.add(weights.a, near.a);
    form_.add(weights.b, near.b);
  }

  [[nodiscard]] std::optional<NewtonStep> run(const PairSecondOrder& near) {
    try_piece(near);
    for (std::size_t i = 0; i < near.edge_count(); ++i) {
      const InFrame& u = near.edge(i);
      const Real square = u.x * u.x + u.y * u.y;
      if (!(square > 0) || !(u.n * u.n < square)) {
        continue;
      }
      try_crease(near, i, square);
      for (std::size_t j = i + 1; j < near.edge_count(); ++j) {
        try_crossing(near, i, j);
      }
    }
    return best_.square < infinity ? std::optional(best_) : std::nullopt;
  }

 private:
  // No other piece may be further out there.
  void consider(const PairSecondOrder& near, NewtonStep step) {
    step.square = step.x * step.x + step.y * step.y;
    if (!(step.square < best_.square)) {
      return;
    }
    for (std::size_t i = 0; i < near.edge_count(); ++i) {
      const InFrame& edge = near.edge(i);
      if (!step.takes(i) && edge.n + edge.x * step.x + edge.y * step.y > noise_) {
        return;
      }
    }
    best_ = step;
  }

  void try_piece(const PairSecondOrder& near) {
    const Real determinant = form_.xx * form_.yy - form_.xy * form_.xy;
    if (form_.xx + form_.yy > 0 && determinant > 0) {
      NewtonStep step;
      step.x = (form_.xy * r_.y - form_.yy * r_.x) / determinant;
      step.y = (form_.xy * r_.x - form_.xx * r_.y) / determinant;
      consider(near, step);
    }
    // All directions nearby may be as good.
    if (r_.x * r_.x + r_.y * r_.y <= tolerance_ * tolerance_ && form_.least() >= -tolerance_) {
      consider(near, {});
    }
  }

  // The slope of the depth after a step, without the edges that it takes.
  [[nodiscard]] inline std::pair<Real, Real> slope_after(const NewtonStep& step) const {
    return {r_.x + form_.xx * step.x + form_.xy * step.y, r_.y + form_.xy * step.x + form_.yy * step.y};
  }

  // Along the crease across an edge, which is straight in these coordinates or nearly so.
  void try_crease(const PairSecondOrder& near, std::size_t i, Real square) {
    const InFrame& u = near.edge(i);
    NewtonStep on;
    on.x = -u.n / square * u.x;
    on.y = -u.n / square * u.y;
    const Real rise = r_.x * on.x + r_.y * on.y;  // of the depth, up to the crease
    const Real bend = form_.along(-u.y, u.x) - rise * square;
    const auto [at_x, at_y] = slope_after(on);
    const Real slope = u.x * at_y - u.y * at_x;
    const bool is_level = std::fabs(slope) <= tolerance_ * std::sqrt(square);
    if (!(bend > (is_level ? -tolerance_ * square : 0))) {
      return;
    }
    const Real along = is_level ? 0 : -slope / bend;
    on.x -= along * u.y;
    on.y += along * u.x;
    const auto [pull_x, pull_y] = slope_after(on);
    const Real share = -(u.x * pull_x + u.y * pull_y) / square;
    on.edges[0] = i;
    on.shares[0] = clamped(share);
    on.count = 1;
    if (is_share(share)) {
      consider(near, on);
    }
  }

  void try_crossing(const PairSecondOrder& near, std::size_t i, std::size_t j) {
    const InFrame &u = near.edge(i), &v = near.edge(j);
    const Real across = u.x * v.y - u.y * v.x;
    if (!(across * across > parallel_square * (u.x * u.x + u.y * u.y) * (v.x * v.x + v.y * v.y))) {
      return;
    }
    NewtonStep both;
    both.x = (v.n * u.y - u.n * v.y) / across;
    both.y = (u.n * v.x - v.n * u.x) / across;
    const auto [pull_x, pull_y] = slope_after(both);
    const Real first = (pull_y * v.x - pull_x * v.y) / across, second = (pull_x * u.y - pull_y * u.x) / across;
    both.edges = {i, j};
    both.shares = {clamped(first), clamped(second)};
    both.count = 2;
    if (is_share(first) && is_share(second) && (!is_in_triangle(near, both) || first + second <= 1)) {
      consider(near, both);
    }
  }

  const InFrame r_;
  QuadraticForm form_;
  const Real noise_, tolerance_;
  NewtonStep best_;
};

}  // namespace

std::optional<NewtonStep> newton_step(const PairSecondOrder& near, Real noise, Real tolerance) {
  if (near.a.disc > 0 || near.b.disc > 0) {
    return std::nullopt;
  }
  const auto step = StepSearch(near, {}, noise, tolerance).run(near);
  if (!step) {
    return std::nullopt;
  }
  // Again with the pieces weighed as the first step has found them.
  const Weights weights = weights_after(near, *step);
  return weights.a == 1 && weights.b == 1 ? step : StepSearch(near, weights, noise, tolerance).run(near);
}

NewtonStep step_on_disc(const PairSecondOrder& near, Real noise) {
  NewtonStep step;
  step.square = 0;
  for (std::size_t i = 0; i < near.edge_count() && step.count < 2; ++i) {
    const InFrame& edge = near.edge(i);
    if (std::fabs(edge.n) <= noise && edge.x * edge.x + edge.y * edge.y > 0) {
      step.edges[step.count++] = i;
    }
  }
  // Each in turn, as near as it goes: those of a box are across each other, so that once is enough.
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < step.count; ++i) {
      const InFrame& edge = near.edge(step.edges[i]);
      const InFrame point = point_after(near, step);
      const Real square = edge.x * edge.x + edge.y * edge.y;
      step.shares[i] = clamped(step.shares[i] - (point.x * edge.x + point.y * edge.y) / square);
    }
  }
  if (const Real sum = step.shares[0] + step.shares[1]; is_in_triangle(near, step) && sum > 1) {
    step.shares = {step.shares[0] / sum, step.shares[1] / sum};
  }
  return step;
}

}  // namespace abut
