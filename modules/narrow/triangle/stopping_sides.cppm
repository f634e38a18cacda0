// SPDX-License-Identifier: Apache-2.0
// What of a surface stops other shapes: both sides of triangles, their fronts, or all that is inside.
export module abut.narrow.triangle.stopping_sides;
import abut.capability;
import abut.core.standard;

export namespace abut {

enum class StoppingSides : std::uint8_t { both, front, solid };

template <Surface S>
[[nodiscard]] StoppingSides stopping_sides(const S& surface) {
  if constexpr (Enclosing<S>) {
    if (surface.is_solid()) {
      return StoppingSides::solid;
    }
  }
  return surface.has_fronts() ? StoppingSides::front : StoppingSides::both;
}

}  // namespace abut
