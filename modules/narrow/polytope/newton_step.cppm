// SPDX-License-Identifier: Apache-2.0
// A step of Newton's method to the least depth of two cores of which one is curved.
//
// The support function of their difference is a few smooth pieces near a direction. They meet in creases, which lie
// across edges of the cores (Schneider, "Convex bodies: the Brunn-Minkowski theory", 2014, section 2.5). The least
// depth lies within a piece, on a crease, or where two creases cross. Its point lies on no edge, on one, or between
// two.
export module abut.narrow.polytope.newton_step;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.second_order_of_pair;

export namespace abut {

// A symmetric matrix across a direction.
struct QuadraticForm {
  Real xx, xy, yy;
  [[nodiscard]] inline Real along(Real x, Real y) const { return x * x * xx + 2 * x * y * xy + y * y * yy; }
  // The lesser eigenvalue.
  [[nodiscard]] inline Real least() const { return 0.5 * (xx + yy - std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy)); }
  // Whether that is no less than a number.
  [[nodiscard]] inline bool is_at_least(Real value) const {
    const Real x = xx - value, y = yy - value;
    return x + y >= 0 && x * y >= xy * xy;
  }
  inline void add(Real factor, const SecondOrder& near) {
    xx += factor * near.xx;
    xy += factor * near.xy;
    yy += factor * near.yy;
  }
};

// A step from a direction n to n + (x, y). The point of the difference there lies by shares along these edges.
struct NewtonStep {
  Real x = 0, y = 0, square = infinity;
  std::array<std::size_t, 2> edges{0, 0};
  std::array<Real, 2> shares{0, 0};
  std::size_t count = 0;

  [[nodiscard]] inline bool takes(std::size_t edge) const {
    return (count > 0 && edges[0] == edge) || (count > 1 && edges[1] == edge);
  }
};

// The step to the nearest direction that is a minimum to second order; nothing where there is none. Less than `noise`
// is rounding of depths. Slopes and bends of less than `tolerance` count as none.
[[nodiscard]] std::optional<NewtonStep> newton_step(const PairSecondOrder& near, Real noise, Real tolerance);

// At the middle of a flat disc: takes the edges that run along it, by shares that bring the point nearest to the
// middle.
[[nodiscard]] NewtonStep step_on_disc(const PairSecondOrder& near, Real noise);

// Whether a step takes two edges from one vertex, whose shares are those of a triangle.
[[nodiscard]] inline bool is_in_triangle(const PairSecondOrder& near, const NewtonStep& step) {
  return step.count == 2 && near.is_of_a(step.edges[0]) == near.is_of_a(step.edges[1]) &&
         !near.owner(step.edges[0]).is_sum;
}

// The point of the difference after a step.
[[nodiscard]] inline InFrame point_after(const PairSecondOrder& near, const NewtonStep& step) {
  InFrame point = near.point;
  for (std::size_t i = 0; i < step.count; ++i) {
    const InFrame& edge = near.edge(step.edges[i]);
    point.n += step.shares[i] * edge.n;
    point.x += step.shares[i] * edge.x;
    point.y += step.shares[i] * edge.y;
  }
  return point;
}

// How far the ends of the edges that a step takes are from being as deep.
[[nodiscard]] inline Real slant_of(const PairSecondOrder& near, const NewtonStep& step) {
  Real slant = 0;
  for (std::size_t i = 0; i < step.count; ++i) {
    slant += std::fabs(near.edge(step.edges[i]).n);
  }
  return slant;
}

// How far the point after a step is from lying along its direction, and its edges from lying across.
[[nodiscard]] inline Real error_after(const PairSecondOrder& near, const NewtonStep& step) {
  const InFrame point = point_after(near, step);
  return std::sqrt(point.x * point.x + point.y * point.y) + slant_of(near, step);
}

}  // namespace abut
