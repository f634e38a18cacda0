// SPDX-License-Identifier: Apache-2.0
// Pairs of children of two shapes, and their contacts. A shape that is no composite counts as its only child.
export module abut.pairs.composites.children;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;
import abut.pairs.registry;

export namespace abut {

[[nodiscard]] inline bool is_assembly(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return Assembly<S>; }, static_cast<const AnyShape::Variant&>(shape));
}

[[nodiscard]] inline bool is_convex(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return Convex<S>; }, static_cast<const AnyShape::Variant&>(shape));
}

[[nodiscard]] inline bool is_scattered(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return Scattered<S>; }, static_cast<const AnyShape::Variant&>(shape));
}

// Calls ask(surface) for a shape that is a surface.
template <class Ask>
void with_surface(const AnyShape& shape, Ask&& ask) {
  std::visit(
      [&]<class S>(const S& surface) {
        if constexpr (Surface<S>) {
          ask(surface);
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}
// Calls ask(core) for a convex shape.
template <class Ask>
void with_core(const AnyShape& shape, Ask&& ask) {
  std::visit(
      [&]<class S>(const S& body) {
        if constexpr (Convex<S>) {
          ask(core_of(body));
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

[[nodiscard]] inline Aabb box_of(const AnyShape& shape, const Pose& pose) {
  return std::visit([&](const auto& s) { return s.aabb(pose); }, static_cast<const AnyShape::Variant&>(shape));
}

// Children of a shape near a box in its frame, as placed in another frame; the shape itself where it has none.
template <class Visitor>
void visit_children(const AnyShape& shape, const Pose& pose, const Aabb& box, Visitor&& visit) {
  std::visit(
      [&]<class S>(const S& s) {
        if constexpr (Assembly<S>) {
          s.visit_children(box, [&](std::uint32_t child) {
            visit(*s.children()[child].shape, pose * s.children()[child].pose, child);
          });
        } else {
          visit(shape, pose, 0);
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

// Visits the pairs of children whose boxes come within `reach`, which may shrink on the way. Poses are those in
// the frame of a.
template <class Visitor>
void visit_pairs_of_children(const AnyShape& a, const AnyShape& b, const Pose& ab, const Real& reach, Visitor&& visit) {
  const Aabb around_b = box_of(b, ab);
  Aabb near_b = around_b.inflated(std::max(reach, Real{0}));
  visit_children(a, Pose::identity(), near_b, [&](const AnyShape& of_a, const Pose& pose_a, std::uint32_t child_a) {
    const Aabb around_a = box_of(of_a, ab.inverse() * pose_a);
    Aabb near_a = around_a.inflated(std::max(reach, Real{0}));
    visit_children(b, ab, near_a, [&](const AnyShape& of_b, const Pose& pose_b, std::uint32_t child_b) {
      visit(of_a, pose_a, child_a, of_b, pose_b, child_b);
      near_a = around_a.inflated(std::max(reach, Real{0}));
    });
    near_b = around_b.inflated(std::max(reach, Real{0}));
  });
}

// Pairs of children are looked up in the order of the table.
template <class Ask>
Outcome ask_in_order(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, Ask&& ask_kernel) {
  const bool from_b = b.index() < a.index();
  const AnyShape &first = from_b ? b : a, &second = from_b ? a : b;
  return ask_kernel(pair_kernels(first.index(), second.index()), first, second, from_b ? pose_b : pose_a,
                    from_b ? pose_a : pose_b, from_b);
}

[[nodiscard]] inline Outcome contacts_of_pair(const AnyShape& a, const AnyShape& b, const Pose& pose_a,
                                              const Pose& pose_b, const QuerySettings& settings, Manifold& out) {
  return ask_in_order(a, b, pose_a, pose_b,
                      [&](const PairKernels<AnyShape>& kernels, const AnyShape& first, const AnyShape& second,
                          const Pose& first_pose, const Pose& second_pose, bool from_b) {
                        return kernels.contacts(first, second, first_pose, second_pose, from_b, settings, out);
                      });
}

// Tells contacts which children they are of. Particles have told theirs already.
inline void name_children(const AnyShape& a, const AnyShape& b, std::uint32_t child_a, std::uint32_t child_b,
                          std::span<ContactPoint> contacts) {
  const bool of_a = is_assembly(a), of_b = is_assembly(b);
  for (ContactPoint& contact : contacts) {
    contact.id = contact_id_of_part(contact_id_of_part(contact.id, child_a), child_b);
    contact.child_a = of_a ? child_a : contact.child_a;
    contact.child_b = of_b ? child_b : contact.child_b;
  }
}

}  // namespace abut
