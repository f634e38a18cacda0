// SPDX-License-Identifier: Apache-2.0
// From two types of shapes to an algorithm, at compile time. Knows no shape by name and no kernel.
export module abut.pairs.routes;
import abut.capability;
import abut.core.standard;

export namespace abut {

// How a pair is answered, in the order in which the ways are tried.
enum class Route : std::uint8_t {
  unsupported,
  half_space,
  half_space_of_parts,
  convex,
  parts,
  parts_of_both,
  scattered,
  hole,
  hole_and_parts,
  hole_of_samples,
  sampled,
  sampled_and_parts,
  sampled_both,
  half_space_of_samples,
  children,
  none,
};

// The route of a pair in this order of operands; none when the other order may have one.
template <class A, class B>
[[nodiscard]] consteval Route route_one_way() {
  if constexpr (HalfSpace<A> && HalfSpace<B>) {
    return Route::unsupported;
  } else if constexpr (Assembly<A> || Assembly<B>) {
    return Route::children;
  } else if constexpr (Hole<A> && (Hole<B> || HalfSpace<B>)) {
    return Route::unsupported;
  } else if constexpr (Scattered<A>) {
    return Route::scattered;
  } else if constexpr (Scattered<B>) {
    return Route::none;
  } else if constexpr (Hole<A> && Convex<B>) {
    return Route::hole;
  } else if constexpr (Hole<A> && Surface<B>) {
    return Route::hole_and_parts;
  } else if constexpr (Hole<A> && SampledSolid<B>) {
    return Route::hole_of_samples;
  } else if constexpr (SampledSolid<A> && Convex<B>) {
    return Route::sampled;
  } else if constexpr (SampledSolid<A> && Surface<B>) {
    return Route::sampled_and_parts;
  } else if constexpr (SampledSolid<A> && SampledSolid<B>) {
    return Route::sampled_both;
  } else if constexpr (HalfSpace<A> && SampledSolid<B>) {
    return Route::half_space_of_samples;
  } else if constexpr (HalfSpace<A> && Convex<B>) {
    return Route::half_space;
  } else if constexpr (HalfSpace<A> && Surface<B>) {
    return Route::half_space_of_parts;
  } else if constexpr (Convex<A> && Convex<B>) {
    return Route::convex;
  } else if constexpr (Surface<A> && Convex<B>) {
    return Route::parts;
  } else if constexpr (Surface<A> && Surface<B>) {
    return Route::parts_of_both;
  } else {
    return Route::none;
  }
}

template <class A, class B>
[[nodiscard]] consteval bool is_flipped() {
  return route_one_way<A, B>() == Route::none;
}

template <class A, class B>
[[nodiscard]] consteval Route route() {
  constexpr Route found = is_flipped<A, B>() ? route_one_way<B, A>() : route_one_way<A, B>();
  static_assert(found != Route::none, "this pair of shapes has no capability in common");
  return found;
}

// Whether a shape has contacts with itself: between its solids or its triangles. Terrain has one height above every
// point.
template <class A>
[[nodiscard]] consteval bool meets_itself() {
  return Scattered<A> || (Surface<A> && !Terrain<A>);
}

}  // namespace abut
