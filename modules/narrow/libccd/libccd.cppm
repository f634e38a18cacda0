// SPDX-License-Identifier: Apache-2.0
// libccd's GJK/EPA and MPR behind the interface of our own routes: a second, independent opinion.
// What it cannot answer (NaN, iteration limit, contradiction) is reported, never passed on.
export module abut.narrow.libccd;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;

export namespace abut {

// libccd sees whole shapes through this: a support point in the frame of a, and an inner point.
using SupportFunction = std::function<Vec3(const Vec3& direction)>;

// Outcome::unsupported in builds without libccd, and for MPR on shapes that do not overlap. libccd compares with
// numbers that know no unit: it sees lengths by `size`, that of the shapes. MPR ends when a step gains less than
// `error`, GJK and EPA when that is so of the gain times the depth.
[[nodiscard]] Outcome libccd_query(const SupportFunction& support_a, const SupportFunction& support_b,
                                   const Vec3& centre_a, const Vec3& centre_b, Algorithm algorithm, Real size,
                                   Real error, Distance& out);

// Of the whole shape: the core and its radius.
[[nodiscard]] inline Vec3 rounded_off(const Vec3& core_point, const Vec3& direction, Real radius) {
  const auto unit = UnitVec3::make(direction);
  return unit ? core_point + radius * unit->vec() : core_point;
}
template <Convex S>
[[nodiscard]] [[gnu::noinline]] Vec3 support_of_whole(const S& shape, const Vec3& direction) {
  return rounded_off(shape.support(direction).point, direction, shape.radius());
}
template <Convex S>
[[nodiscard]] [[gnu::noinline]] Vec3 support_of_whole(const S& shape, const Pose& pose, const Vec3& direction) {
  return rounded_off(placed_support(shape, place(shape, pose), direction).point, direction, shape.radius());
}

template <Convex A, Convex B>
[[nodiscard]] Outcome libccd_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                      Distance& out) {
  QuerySettings asked = settings;
  // It does not know polytopes from curved shapes.
  asked.error_bound = bound_of_curves(settings);
  const Real size = core_size(a, b, ab) + a.radius() + b.radius();
  return libccd_query([&](const Vec3& d) { return support_of_whole(a, d); },
                      [&](const Vec3& d) { return support_of_whole(b, ab, d); }, a.centre(), placed_centre(b, ab),
                      settings.algorithm, size, error_of(a, b, size, asked), out);
}

}  // namespace abut
