// SPDX-License-Identifier: Apache-2.0
// How the support function of the difference of two cores runs near a direction, up to second order.
export module abut.narrow.cores.second_order_of_pair;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// The support function of a difference near a direction.
struct PairSecondOrder {
  SecondOrder a, b;
  InFrame point;
  [[nodiscard]] inline std::size_t edge_count() const { return a.edge_count + b.edge_count; }
  [[nodiscard]] inline const InFrame& edge(std::size_t i) const [[clang::lifetimebound]] {
    return i < a.edge_count ? a.edges[i] : b.edges[i - a.edge_count];
  }
  [[nodiscard]] inline bool is_of_a(std::size_t i) const { return i < a.edge_count; }
  [[nodiscard]] inline const SecondOrder& owner(std::size_t i) const [[clang::lifetimebound]] {
    return is_of_a(i) ? a : b;
  }
};

// A polytope has a supporting vertex, and the edges of its supporting face there.
template <Convex S>
[[nodiscard]] [[gnu::always_inline]] inline SecondOrder second_order_of(const S& shape, const DirectionFrame& frame) {
  if constexpr (requires { shape.second_order(frame); }) {
    return shape.second_order(frame);
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    const Vec3 corner{std::copysign(half.x, frame.n.x), std::copysign(half.y, frame.n.y),
                      std::copysign(half.z, frame.n.z)};
    SecondOrder near = second_order_of_point(in_frame(frame, corner));
    const auto add_edge = [&](Real full, Real n, Real x, Real y) {
      if (full != 0) {
        near.edges[near.edge_count++] = {full * n, full * x, full * y};
      }
    };
    add_edge(-2 * corner.x, frame.n.x, frame.x.x, frame.y.x);
    add_edge(-2 * corner.y, frame.n.y, frame.x.y, frame.y.y);
    add_edge(-2 * corner.z, frame.n.z, frame.x.z, frame.y.z);
    return near;
  } else {
    const SupportPoint top = shape.support(frame.n);
    SecondOrder near = second_order_of_point(in_frame(frame, top.point));
    near.is_sum = false;
    [[clang::uninitialized]] const Face face = shape.supporting_face(frame.n);
    const std::size_t count = face.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (face.vertices[i].vertex == top.index) {
        const auto add_edge_to = [&](const Vec3& end) {
          near.edges[near.edge_count++] = in_frame(frame, end - top.point);
        };
        if (count > 1) {
          add_edge_to(face.vertices[i + 1 < count ? i + 1 : 0].point);
        }
        if (count > 2) {
          add_edge_to(face.vertices[i > 0 ? i - 1 : count - 1].point);
        }
        break;
      }
    }
    return near;
  }
}

template <Convex B>
[[nodiscard]] [[gnu::always_inline]] inline PairSecondOrder pair_second_order(const SecondOrder& a, const B& b,
                                                                              const Pose& ab,
                                                                              const DirectionFrame& frame) {
  const DirectionFrame frame_b{ab.rotation.undo(-frame.n), ab.rotation.undo(-frame.x), ab.rotation.undo(-frame.y)};
  PairSecondOrder near;
  near.a = a;
  near.b = second_order_of(b, frame_b);
  const InFrame &on_a = near.a.point, &on_b = near.b.point, offset = in_frame(frame, ab.position);
  near.point = {on_a.n + on_b.n - offset.n, on_a.x + on_b.x - offset.x, on_a.y + on_b.y - offset.y};
  return near;
}
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline PairSecondOrder pair_second_order(const A& a, const B& b, const Pose& ab,
                                                                              const DirectionFrame& frame) {
  return pair_second_order(second_order_of(a, frame), b, ab, frame);
}

[[nodiscard]] inline DirectionFrame frame_along(const Vec3& n) {
  const Tangents tangents = tangents_of(n);
  return {n, tangents.first, tangents.second};
}

}  // namespace abut
