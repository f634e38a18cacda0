// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape.shape_edit;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;

namespace abut {
namespace {

// Out of line: once for all kinds and edits.
[[gnu::noinline]] Error no_such_part(std::string_view name, std::string_view subject) {
  return {Errc::unsupported, "geometry is a " + std::string(name) + ", which has no " + std::string(subject)};
}

template <class S, class E>
Fault check_of(const AnyShape& any, const S& shape, const E& edit) {
  if constexpr (Editable<S, E>) {
    return shape.check(edit);
  } else if constexpr (std::is_same_v<E, ParameterEdit> && Resizable<S>) {
    const Result<S> made = S::make(edit.parameters, {}, {});
    return made ? std::nullopt : Fault(made.error());
  } else {
    return no_such_part(kind_name(kind_of(any)), E::subject);
  }
}

template <class S, class E>
Aabb apply_to(S& shape, const E& edit) {
  if constexpr (Editable<S, E>) {
    return shape.apply(edit);
  } else if constexpr (std::is_same_v<E, ParameterEdit> && Resizable<S>) {
    shape = S::make(edit.parameters, {}, {}).value();
  }
  return Aabb::everything();
}

}  // namespace

Fault check_edit(const AnyShape& shape, const Edit& edit) {
  return std::visit([&](const auto& its, const auto& given) { return check_of(shape, its, given); },
                    static_cast<const AnyShape::Variant&>(shape), edit);
}

void own_shape(ShapeHandle& shape, const Edit& edit) {
  std::visit(
      []<class S>(S& its, const auto& given) {
        if constexpr (requires { its.own(); }) {
          its.own();
        }
        if constexpr (requires { its.make_room(given); }) {
          its.make_room(given);
        }
      },
      static_cast<AnyShape::Variant&>(shape.own()), edit);
}

Aabb apply_edit(ShapeHandle& shape, const Edit& edit) {
  return std::visit([](auto& its, const auto& given) { return apply_to(its, given); },
                    static_cast<AnyShape::Variant&>(shape.own()), edit);
}

}  // namespace abut
