// How the support function of the difference of two cores runs near a direction, up to second order.
export module abut.narrow.cores.second_order_of_pair;
import abut.capability.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// The support function of a difference near a direction.
struct PairGerm {
  Germ a, b;
  InFrame point;
  std::array<Real, 3> part_of_a;  // of each step of a: less than 1 where a parallel one of b is added to it
  [[nodiscard]] inline std::size_t step_count() const { return a.step_count + b.step_count; }
  [[nodiscard]] inline const InFrame& step(std::size_t i) const {
    return i < a.step_count ? a.steps[i] : b.steps[i - a.step_count];
  }
  [[nodiscard]] inline bool is_of_a(std::size_t i) const { return i < a.step_count; }
  [[nodiscard]] inline const Germ& owner(std::size_t i) const { return is_of_a(i) ? a : b; }
};

// Parallel edges of both cores are one edge of their difference.
void join_parallel_steps(PairGerm& germ);

// Of a polytope: the supporting vertex and the edges of its face there.
template <Convex S>
[[nodiscard]] [[gnu::always_inline]] inline Germ germ_of(const S& shape, const GermFrame& frame) {
  if constexpr (requires { shape.germ(frame); }) {
    return shape.germ(frame);
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    const Vec3 corner{std::copysign(half.x, frame.n.x), std::copysign(half.y, frame.n.y),
                      std::copysign(half.z, frame.n.z)};
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
[[nodiscard]] [[gnu::always_inline]] inline PairGerm pair_germ(const A& a, const B& b, const Pose& ab,
                                                               const GermFrame& frame) {
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

[[nodiscard]] inline GermFrame frame_along(const Vec3& n) {
  const Tangents tangents = tangents_of(n);
  return {n, tangents.first, tangents.second};
}

}  // namespace abut
