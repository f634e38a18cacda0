// SPDX-License-Identifier: Apache-2.0
// The separation of two cores as a record, and the bounds that errors and rounding have.
export module abut.narrow.cores.core_separation;
import abut.capability;
export import abut.capability.cores.core_feature;
import abut.core.standard;
import abut.math;
export import abut.math.tolerance;

export namespace abut {

// The separation of two cores and how it was found, in the frame of a.
struct CoreSeparation {
  Real distance, lower, upper;
  Real rounding;  // of the coordinates, by which the bounds may be off
  Vec3 normal;    // unit, from a to b
  CoreFeatures features;
  Vec3 point_a, point_b;
  bool points_open;  // the points are any support points so far: find_points has to look for them
  bool beyond;       // only `lower` was found, and exceeds the limit asked for
  bool overlap;      // the cores overlap or touch
  Algorithm algorithm;
  std::uint32_t iterations;
};

// Bound of the coordinates of both cores in the frame of a: rounding is relative to it.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Real core_size(const A& a, const B& b, const Pose& ab) {
  return 2 * (a.extent() + b.extent()) + largest_magnitude(a.centre()) + largest_magnitude(placed_centre(b, ab));
}

// The usual bounds of errors, relative to the size of the shapes: searches on curved surfaces come nearer step
// by step, those on polytopes end. The size of two shapes is at most 4 sqrt(3) times their largest coordinate, so
// curves err by less than 1e-9 of that.
inline constexpr Real usual_error = 1e-12, usual_error_of_curves = 1.4e-10;

// Depths of curved cores that differ by less are the same to the corners of a contact.
[[nodiscard]] [[gnu::always_inline]] inline Real curve_blur(Real size) { return 0.5 * usual_error_of_curves * size; }

// The bound of a search on curved surfaces, relative to the size of the shapes.
[[nodiscard]] inline Real bound_of_curves(const QuerySettings& settings) {
  return settings.error_bound > 0 ? settings.error_bound : usual_error_of_curves;
}

// The bound asked for, on shapes of their own size, and no finer than coordinates are.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Real error_of(const A& a, const B& b, Real size,
                                                          const QuerySettings& settings) {
  const Real shape_size = 2 * (a.extent() + b.extent()) + a.radius() + b.radius();
  constexpr Real usual = Curved<A> || Curved<B> ? usual_error_of_curves : usual_error;
  return (settings.error_bound > 0 ? settings.error_bound : usual) * shape_size + touching_distance(size);
}

}  // namespace abut
