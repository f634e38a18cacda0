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

template <class S>
constexpr bool exchanges_vertices = requires(S& shape, std::vector<Vec3>& next) {
  { shape.exchange(next) } -> std::same_as<Aabb>;
};

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

Fault check_next_vertices(const AnyShape& shape, std::span<const Vec3> next) {
  return std::visit(
      [&]<class S>(const S& its) -> Fault {
        if constexpr (exchanges_vertices<S>) {
          return its.check_next(next);
        } else {
          return no_such_part(kind_name(kind_of(shape)), VertexEdit::subject);
        }
      },
      static_cast<const AnyShape::Variant&>(shape));
}

void own_vertices(ShapeHandle& shape) {
  std::visit(
      []<class S>(S& its) {
        if constexpr (exchanges_vertices<S>) {
          its.own();
          its.make_room_for_next();
        }
      },
      static_cast<AnyShape::Variant&>(shape.own()));
}

Aabb exchange_vertices(ShapeHandle& shape, std::vector<Vec3>& next) {
  return std::visit(
      [&]<class S>(S& its) {
        if constexpr (exchanges_vertices<S>) {
          return its.exchange(next);
        } else {
          return Aabb::everything();
        }
      },
      static_cast<AnyShape::Variant&>(shape.own()));
}

}  // namespace abut
