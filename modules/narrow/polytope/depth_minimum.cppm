// Least depths of two cores of which one is curved: where the support function of their difference D is least among
// nearby unit directions, and in what cap of directions around it surely nothing is less.
//
// Newton's method for the support function on the sphere, whose pieces meet in creases (Hessians of support functions:
// Schneider, "Convex bodies: the Brunn-Minkowski theory", section 2.5). At the minimum n the point d n belongs to D,
// and D reaches beyond that point by at least a quadratic form; where the form exceeds d |w|^2 the ball of radius d is
// in D.
export module abut.narrow.polytope.depth_minimum;
import abut.capability.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;

export namespace abut {

struct DepthMinimum {
  Vec3 normal;        // unit
  Real depth, upper;  // along the normal; rounding and what the search has left lie between them
  Real lower;         // no direction in the cap has less
  Real cosine;        // of the angle of the cap, at most a right one
  Vec3 point_a, point_b;
};

// Which steps are taken, and how far, so that the point lies under the direction n + (x, y).
struct Stride {
  Real x = 0, y = 0, square = infinity;
  std::array<std::size_t, 2> steps{0, 0};
  std::array<Real, 2> shares{0, 0};
  std::size_t count = 0;
};

// Of the pieces that a step leads away from and to, each counts by its share.
struct Weights {
  Real a = 1, b = 1;
};
[[nodiscard]] Weights weights_of(const PairGerm& germ, const Stride& stride);

// To the nearest direction that is a minimum of the second-order model, within `spare`; false where there is none.
[[nodiscard]] bool stride_to_minimum(const PairGerm& germ, const Weights& weights, Real noise, Real spare,
                                     Stride& stride);

// How far from the direction the cap reaches, as a tangent, for what is left of the point aside of n; none: 0.
struct CapReach {
  Real tangent, lower;
};
[[nodiscard]] CapReach cap_of(const PairGerm& germ, const Stride& stride, const InFrame& foot, Real spare);

// The steps along a flat disc that bring the point nearest to its middle.
[[nodiscard]] Stride stride_on_disc(const PairGerm& germ, Real noise);

[[nodiscard]] inline InFrame foot_of(const PairGerm& germ, const Stride& stride) {
  InFrame foot = germ.point;
  for (std::size_t i = 0; i < stride.count; ++i) {
    const InFrame& step = germ.step(stride.steps[i]);
    foot.n += stride.shares[i] * step.n;
    foot.x += stride.shares[i] * step.x;
    foot.y += stride.shares[i] * step.y;
  }
  return foot;
}

// The minimum in a direction where a stride has ended; nothing where no cap around it is proven.
[[nodiscard]] std::optional<DepthMinimum> minimum_at(const GermFrame& frame, const PairGerm& germ, const Stride& stride,
                                                     Real spare);

// The points of both bodies there, whatever is around.
[[nodiscard]] DepthMinimum points_at(const GermFrame& frame, const PairGerm& germ, const Stride& stride);

// By the second-order model, and again with the pieces weighed as it found them.
[[nodiscard]] bool weighed_stride(const PairGerm& germ, Real noise, Real spare, Stride& stride);

// How far a foot is from lying under its direction, and the ends of its steps from being level.
[[nodiscard]] Real error_of_foot(const PairGerm& germ, const Stride& stride);

// The minimum that Newton's method comes to from a unit direction.
[[nodiscard]] std::optional<DepthMinimum> minimum_near(const Difference& cores, const Vec3& direction, Real error,
                                                       Real noise);

// The points of both bodies under a direction that is already a minimum within the error.
[[nodiscard]] std::optional<DepthMinimum> points_under(const Difference& cores, const Vec3& normal, Real error,
                                                       Real noise);

// The one along the axis of a disc.
[[nodiscard]] std::optional<DepthMinimum> minimum_on_disc(const Difference& cores, const Vec3& axis, Real error,
                                                          Real noise);

}  // namespace abut
