// SPDX-License-Identifier: Apache-2.0
// Solids that are known by samples of their signed distance.
export module abut.capability.sampled_solid;
import abut.capability.concepts;
import abut.core.standard;
import abut.math;

export namespace abut {

// The value of a sampled field at a point: about the distance to the surface, negative inside. The gradient leads out
// of the solid; it has about length one, and may vanish.
struct FieldValue {
  Real value;
  Vec3 gradient;
};

// Points of a surface in runs that lie close together.
struct SurfacePoints {
  struct Run {
    Aabb box;
    std::uint32_t first, count;
  };
  std::vector<Vec3> points;
  std::vector<std::uint32_t> cells;  // of the grid, in which they lie
  std::vector<Run> runs;
  std::vector<Vec3> doubtful;  // about them there may be a surface that no point tells of
};

// Is where its field is not positive. `value_at` answers everywhere.
// - `least_within`: a lower bound of the values within a radius of a point, from the value there.
// - `least_way`: a lower bound of the way from a point to the surface, from the value there.
// - `surface`: points of the surface, such that every point of it is within `surface_error` of one or of a doubtful
// one.
template <class S>
concept SampledSolid = Bounded<S> && requires(const S& shape, const Vec3& point, Real number) {
  { shape.value_at(point) } -> std::same_as<FieldValue>;
  { shape.least_within(number, number) } -> std::same_as<Real>;
  { shape.least_way(number) } -> std::same_as<Real>;
  { shape.finest() } -> std::convertible_to<Real>;  // the shortest side of a cell
  { shape.surface_error() } -> std::convertible_to<Real>;
  { shape.surface() } -> std::same_as<const SurfacePoints&>;
  { shape.solid_box() } -> std::convertible_to<Aabb>;      // around the solid; of a container, around its cavity
  { shape.is_inside_out() } -> std::convertible_to<bool>;  // a container: all space but a cavity
};

}  // namespace abut
