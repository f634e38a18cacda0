// SPDX-License-Identifier: Apache-2.0
// What the searches see of a shape.
//
// A convex shape is a core, rounded by a radius. Shapes with the same kind of core are the same to all searches, which
// are compiled once for each pair of kinds: a shape that is derived from its core names it, as in
// `using Core = PointCore`. All other shapes are cores of their own.
export module abut.capability.cores.core_of;
import abut.core.standard;

export namespace abut {

template <class S>
struct CoreOfShape {
  using type = S;
};
template <class S>
  requires requires { typename S::Core; }
struct CoreOfShape<S> {
  using type = typename S::Core;
};
template <class S>
using CoreOf = typename CoreOfShape<S>::type;

// Shapes that are not convex are handed on as they are, too.
template <class S>
[[nodiscard]] [[gnu::always_inline]] inline const CoreOf<S>& core_of(const S& shape [[clang::lifetimebound]]) {
  return shape;
}

}  // namespace abut
