// Least depths of two cores of which one is curved: where the support function of their difference D is least among
// nearby unit directions, and in what cap of directions around it surely nothing is less.
//
// Newton's method for the support function on the sphere, whose pieces meet in creases (Hessians of support functions:
// Schneider, "Convex bodies: the Brunn-Minkowski theory", section 2.5). At the minimum n the point d n belongs to D, and
// D reaches beyond that point by at least a quadratic form; where the form exceeds d |w|^2 the ball of radius d is in D.
export module abut.narrowphase.depth_minimum;
import abut.core.standard;
import abut.math;
import abut.shape;
import abut.shape.germ;

export namespace abut {

struct DepthMinimum {
  Vec3 normal;  // unit
  Real depth, upper;  // along the normal; rounding and what the search has left lie between them
  Real lower;         // no direction in the cap has less
  Real cosine;        // of the angle of the cap, at most a right one
  Vec3 point_a, point_b;
};

// The support function of a difference near a direction.
struct PairGerm {
  Germ a, b;
  InFrame point;
  std::array<Real, 3> part_of_a;  // of each step of a: less than 1 where a parallel one of b is added to it
  [[nodiscard]] inline std::size_t step_count() const { return a.step_count + b.step_count; }
  [[nodiscard]] inline const InFrame& step(std::size_t i) const { return i < a.step_count ? a.steps[i] : b.steps[i - a.step_count]; }
  [[nodiscard]] inline bool is_of_a(std::size_t i) const { return i < a.step_count; }
  [[nodiscard]] inline const Germ& owner(std::size_t i) const { return is_of_a(i) ? a : b; }
};

// Parallel edges of both cores are one edge of their difference.
void join_parallel_steps(PairGerm& germ);

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
[[nodiscard]] bool stride_to_minimum(const PairGerm& germ, const Weights& weights, Real noise, Real spare, Stride& stride);

// How far from the direction the cap reaches, as a tangent, for what is left of the point aside of n; none: 0.
struct CapReach {
  Real tangent, lower;
};
[[nodiscard]] CapReach cap_of(const PairGerm& germ, const Stride& stride, const InFrame& foot, Real spare);

// The steps along a flat disc that bring the point nearest to its middle.
[[nodiscard]] Stride stride_on_disc(const PairGerm& germ, Real noise);

// Of a polytope: the supporting vertex and the edges of its face there.
template <Convex S>
[[nodiscard]] [[gnu::always_inline]] inline Germ germ_of(const S& shape, const GermFrame& frame) {
  if constexpr (requires { shape.germ(frame); }) {
    return shape.germ(frame);
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    const Vec3 corner{std::copysign(half.x, frame.n.x), std::copysign(half.y, frame.n.y), std::copysign(half.z, frame.n.z)};
    Germ germ = germ_of_point(in_frame(frame, corner));
    const auto step_along = [&](Real full, Real n, Real x, Real y) {
      if (full != 0) {
        germ.steps[germ.step_count++] = {full * n, full * x, full * y};
      }
    };
    step_along(-2 * corner.x, frame.n.x, frame.x.x, frame.y.x);
    step_along(-2 * corner.y, frame.n.y, frame.x.y, frame.y.y);
    step_along(-2 * corner.z, frame.n.z, frame.x.z, frame.y.z);
    return germ;
  } else {
    const SupportPoint top = shape.support(frame.n);
    Germ germ = germ_of_point(in_frame(frame, top.point));
    germ.is_sum = false;
    [[clang::uninitialized]] const Face face = shape.supporting_face(frame.n);
    const std::size_t count = face.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (face.vertices[i].vertex == top.index) {
        const auto step_to = [&](const Vec3& end) { germ.steps[germ.step_count++] = in_frame(frame, end - top.point); };
        if (count > 1) {
          step_to(face.vertices[i + 1 < count ? i + 1 : 0].point);
        }
        if (count > 2) {
          step_to(face.vertices[i > 0 ? i - 1 : count - 1].point);
        }
        break;
      }
    }
    return germ;
  }
}

template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline PairGerm pair_germ(const A& a, const B& b, const Pose& ab, const GermFrame& frame) {
  const GermFrame frame_b{ab.rotation.undo(-frame.n), ab.rotation.undo(-frame.x), ab.rotation.undo(-frame.y)};
  PairGerm germ;
  germ.a = germ_of(a, frame);
  germ.b = germ_of(b, frame_b);
  const InFrame &on_a = germ.a.point, &on_b = germ.b.point, offset = in_frame(frame, ab.position);
  germ.point = {on_a.n + on_b.n - offset.n, on_a.x + on_b.x - offset.x, on_a.y + on_b.y - offset.y};
  germ.part_of_a = {1, 1, 1};
  if (germ.a.step_count > 0 && germ.b.step_count > 0 && germ.a.is_sum && germ.b.is_sum) {
    join_parallel_steps(germ);
  }
  return germ;
}

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
[[nodiscard]] std::optional<DepthMinimum> minimum_at(const GermFrame& frame, const PairGerm& germ, const Stride& stride, Real spare);

// The points of both bodies there, whatever is around.
[[nodiscard]] DepthMinimum points_at(const GermFrame& frame, const PairGerm& germ, const Stride& stride);

[[nodiscard]] inline GermFrame frame_along(const Vec3& n) {
  const Tangents tangents = tangents_of(n);
  return {n, tangents.first, tangents.second};
}

inline constexpr int minimum_rounds = 12;

// By the second-order model, and again with the pieces weighed as it found them.
[[nodiscard]] inline bool weighed_stride(const PairGerm& germ, Real noise, Real spare, Stride& stride) {
  stride = {};
  if (!stride_to_minimum(germ, {}, noise, spare, stride)) {
    return false;
  }
  const Weights weights = weights_of(germ, stride);
  if (weights.a == 1 && weights.b == 1) {
    return true;
  }
  stride = {};
  return stride_to_minimum(germ, weights, noise, spare, stride);
}

// How far a foot is from lying under its direction, and the ends of its steps from being level.
[[nodiscard]] inline Real error_of_foot(const PairGerm& germ, const Stride& stride) {
  const InFrame foot = foot_of(germ, stride);
  Real off = std::sqrt(foot.x * foot.x + foot.y * foot.y);
  for (std::size_t i = 0; i < stride.count; ++i) {
    off += std::fabs(germ.step(stride.steps[i]).n);
  }
  return off;
}

// The minimum that Newton's method comes to from a unit direction.
template <Convex A, Convex B>
[[nodiscard]] std::optional<DepthMinimum> minimum_near(const A& a, const B& b, const Pose& ab, const Vec3& direction, Real error, Real noise) {
  Vec3 n = direction;
  for (int round = 0; round < minimum_rounds; ++round) {
    const GermFrame frame = frame_along(n);
    const PairGerm germ = pair_germ(a, b, ab, frame);
    Stride stride;
    if (!weighed_stride(germ, noise, error / 16, stride)) {
      return std::nullopt;
    }
    if (error_of_foot(germ, stride) <= error / 16) {
      return minimum_at(frame, germ, stride, error / 16);
    }
    const Real shorten = stride.square > 0.25 ? 0.5 / std::sqrt(stride.square) : 1;
    const auto next = UnitVec3::make(n + (shorten * stride.x) * frame.x + (shorten * stride.y) * frame.y);
    if (!next) {
      return std::nullopt;
    }
    n = *next;
  }
  return std::nullopt;
}

// The support function of the difference: how deep the cores overlap along a unit direction.
template <Convex A, Convex B, class Placement>
[[nodiscard]] [[gnu::always_inline]] inline Real depth_along(const A& a, const B& b, const Placement& placement, const Vec3& n) {
  return dot(n, a.support(n).point - placed_support(b, placement, -n).point);
}

// The points of both bodies under a direction that is already a minimum within the error.
template <Convex A, Convex B>
[[nodiscard]] std::optional<DepthMinimum> points_under(const A& a, const B& b, const Pose& ab, const Vec3& normal, Real error, Real noise) {
  const GermFrame frame = frame_along(normal);
  const PairGerm germ = pair_germ(a, b, ab, frame);
  Stride stride;
  if (germ.a.disc > 0 || germ.b.disc > 0) {
    stride = stride_on_disc(germ, noise);
    const InFrame foot = foot_of(germ, stride);
    if (std::hypot(foot.x, foot.y) > germ.a.disc + germ.b.disc) {
      return std::nullopt;
    }
  } else if (!weighed_stride(germ, noise, error / 16, stride) || error_of_foot(germ, stride) > error / 16) {
    return std::nullopt;
  }
  return points_at(frame, germ, stride);
}

// The one along the axis of a disc.
template <Convex A, Convex B>
[[nodiscard]] std::optional<DepthMinimum> minimum_on_disc(const A& a, const B& b, const Pose& ab, const Vec3& axis, Real error, Real noise) {
  const GermFrame frame = frame_along(axis);
  const PairGerm germ = pair_germ(a, b, ab, frame);
  return minimum_at(frame, germ, stride_on_disc(germ, noise), error / 16);
}

}  // namespace abut
