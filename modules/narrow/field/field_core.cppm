// SPDX-License-Identifier: Apache-2.0
// A convex core in a sampled field: values at its points, and the way from there to the surface.
//
// A descent leads from any point of the core to a point of least value nearby.
export module abut.narrow.field.field_core;
import abut.capability.cores.core_feature;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
export import abut.narrow.ways.downhill;
import abut.narrow.triangle.triangle_point;

export namespace abut {

// The point of a core that is nearest to a point, in the frame of the core; the point itself where it lies in it.
// Nothing, or a point, where that is further away than a limit.
template <Convex B>
[[nodiscard]] std::optional<Vec3> nearest_of_core(const B& b, const Vec3& point, Real limit) {
  if constexpr (PointCored<B>) {
    return Vec3{0, 0, 0};
  } else if constexpr (SegmentCored<B>) {
    const Real half = b.half().z;
    return Vec3{0, 0, std::max(-half, std::min(half, point.z))};
  } else if constexpr (BoxCored<B>) {
    return maximum(minimum(point, b.half()), -b.half());
  } else if constexpr (Triangular<B>) {
    return nearest_on(b.corners(), point);
  } else {
    if constexpr (Field<B>) {
      if (b.radius() == 0) {
        const SurfacePoint found = b.nearest(point);
        return found.distance > 0 ? found.point : point;
      }
    }
    constexpr Real allowed = 1e-9;
    const Vec3 centre = b.centre();
    const Real size = b.extent() + largest_magnitude(centre) + largest_magnitude(point);
    const GjkResult found =
        gjk(b, PointCore(0), Pose{Rotation::identity(), point}, point - centre, size, allowed * size, limit);
    return found.beyond ? std::nullopt : std::optional(found.overlap ? point : point + found.closest);
  }
}

// A box that holds a core, in its own frame.
template <Convex B>
[[nodiscard]] Aabb box_of_core(const B& b) {
  const Aabb whole = b.aabb(Pose::identity());
  const Vec3 middle = whole.centre(), r{b.radius(), b.radius(), b.radius()};
  return {minimum(whole.low + r, middle), maximum(whole.high - r, middle)};
}

// A convex core in a field, seen from the frame of the core.
template <SampledSolid F, Convex B>
class [[gsl::Pointer]] CoreInField {
 public:
  CoreInField(const F& field, const B& b, const Pose& pose) : field_(field), b_(b), pose_(pose) {}

  [[nodiscard]] FieldPoint at(const Vec3& point) const {
    const FieldValue found = field_.value_at(pose_ * point);
    return {point, {found.value, pose_.rotation.undo(found.gradient)}};
  }
  [[nodiscard]] Vec3 nearest(const Vec3& point) const { return nearest_of_core(b_, point, infinity).value_or(point); }
  // Nothing where the core is further away than a limit.
  [[nodiscard]] std::optional<Vec3> nearest_within(const Vec3& point, Real limit) const {
    const std::optional<Vec3> found = nearest_of_core(b_, point, limit);
    return found && squared_norm(*found - point) <= limit * limit ? found : std::nullopt;
  }

  // A point of least value, downhill from one of the core. `stride`: the length of the first step.
  [[nodiscard]] FieldPoint descend(const Vec3& start, Real stride) const {
    return *descend_while(start, stride, infinity, [](const Vec3&) { return true; });
  }
  // The same with steps of bounded length; nothing where the way leads to where a condition is not met.
  template <class Condition>
  [[nodiscard]] std::optional<FieldPoint> descend_while(const Vec3& start, Real stride, Real longest,
                                                        Condition&& is_met) const {
    constexpr Real least_gain_share = 1e-7;  // of a cell
    const Real least_gain = least_gain_share * field_.finest();
    return downhill(
        at(start), {stride, longest, end_of_steps(), least_gain},
        [&](const Vec3& point) { return std::optional(nearest(point)); }, [&](const Vec3& point) { return at(point); },
        is_met);
  }

  // Where a point of the core is as it lies in the field, and what is nearest to it on the surface there.
  struct Touch {
    Vec3 point;      // of the core
    Vec3 normal;     // unit, out of the solid
    Real distance;   // to the surface, against the normal; the value where there is no surface
    bool is_proven;  // that point of the surface was found

    // Apart from a solid that has no surface, and so no point.
    [[nodiscard]] bool is_of_nothing() const { return !is_proven && distance > 0; }
  };
  [[nodiscard]] Touch touch(const Vec3& point) const {
    const Vec3 placed = pose_ * point;
    const FieldValue start = field_.value_at(placed);
    const Vec3 normal = UnitVec3::make(start.gradient).value_or(away(placed));
    const std::optional<Real> way = way_to_surface(placed, normal, start.value);
    // Where the gradient is bent, as in the middle of a solid, it may lead along the surface.
    constexpr Real most_detour = 1.02, like = 1e-2;
    if (way && std::fabs(*way) <= most_detour * std::fabs(start.value) + like * field_.finest()) {
      return {placed, normal, *way, true};
    }
    if (const std::optional<Vec3> found =
            surface_around(placed, start.value, way ? std::optional(placed - *way * normal) : std::nullopt)) {
      const Vec3 between = placed - nearest_on_surface(placed, *found);
      const Real length = norm(between), sign = start.value < 0 ? -1 : 1;
      return length > 0 ? Touch{placed, (sign / length) * between, sign * length, true}
                        : Touch{placed, normal, way.value_or(start.value), true};
    }
    return {placed, normal, start.value, false};
  }
  // The point of the surface that is nearest to a point, from one that is close. It slides along tangent planes as long
  // as they lead nearer.
  [[nodiscard]] Vec3 nearest_on_surface(const Vec3& point, const Vec3& start) const {
    // Half the square of the distance, and its gradient along the surface.
    const auto half_square_at = [&](const Vec3& there) {
      const Vec3 between = point - there;
      const auto normal = UnitVec3::make(field_.value_at(there).gradient);
      const Vec3 aside = normal ? between - dot(between, *normal) * normal->vec() : Vec3{0, 0, 0};
      return FieldPoint{there, {0.5 * squared_norm(between), -aside}};
    };
    return downhill(
               half_square_at(start), {1, infinity, end_of_steps(), 0},
               [&](const Vec3& there) { return surface_below(there); }, half_square_at,
               [](const Vec3&) { return true; })
        ->point;
  }
  // A point of the surface, down or up the gradient from a point in the frame of the field.
  [[nodiscard]] std::optional<Vec3> surface_below(const Vec3& start) const {
    constexpr int most_steps = 48;
    Vec3 point = start;
    for (int i = 0; i < most_steps; ++i) {
      const FieldValue found = field_.value_at(point);
      const Real slope = norm(found.gradient);
      if (std::fabs(found.value) <= surface_share * field_.finest()) {
        return point;
      }
      if (!(slope > 0)) {
        break;
      }
      // By Newton's method; a bent gradient is too short.
      constexpr Real least_slope = 0.75;
      point = point - (found.value / (slope * std::max(slope, least_slope))) * found.gradient;
    }
    return std::nullopt;
  }

 private:
  static constexpr Real surface_share = 1e-6, end_share = 1e-5;  // of a cell
  [[nodiscard]] static Real squared(Real value) { return value * value; }
  // Where a descent ends.
  [[nodiscard]] Real end_of_steps() const { return end_share * field_.finest(); }
  // Where the gradient vanishes.
  [[nodiscard]] UnitVec3 away(const Vec3& point) const {
    const Real sign = field_.is_inside_out() ? -1 : 1;
    return UnitVec3::make(sign * (point - field_.solid_box().centre())).value_or(UnitVec3::axis_z());
  }
  // A point that is known, or down the gradient; straight along an axis where that is nearer. Where values are no
  // distances, as around a single sample that is inside, none of these ways may lead there.
  [[nodiscard]] std::optional<Vec3> surface_around(const Vec3& point, Real value,
                                                   const std::optional<Vec3>& known) const {
    std::optional<Vec3> best = known ? known : surface_below(point);
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      for (const Vec3& direction : {axis, -axis}) {
        const std::optional<Real> way = way_to_surface(point, direction, value);
        if (way && (!best || squared(*way) < squared_norm(*best - point))) {
          best = point - *way * direction;
        }
      }
    }
    return best ? best : nearest_listed(point);
  }
  // Of the points of the whole surface the nearest one. There is none where the solid has no surface.
  [[nodiscard]] std::optional<Vec3> nearest_listed(const Vec3& point) const {
    const SurfacePoints& surface = field_.surface();
    std::optional<Vec3> best;
    Real least = infinity;
    for (const SurfacePoints::Run& run : surface.runs) {
      const Vec3 beyond = maximum(maximum(run.box.low - point, point - run.box.high), Vec3{0, 0, 0});
      if (squared_norm(beyond) >= least) {
        continue;
      }
      for (const Vec3& listed : std::span(surface.points).subspan(run.first, run.count)) {
        if (const Real square = squared_norm(listed - point); square < least) {
          least = square;
          best = listed;
        }
      }
    }
    return best ? surface_below(*best).value_or(*best) : best;
  }
  // To a zero of the value along a line: in steps as long as the value (Hart, "Sphere tracing", 1996), then by secants.
  [[nodiscard]] std::optional<Real> way_to_surface(const Vec3& start, const Vec3& normal, Real start_value) const {
    constexpr int most_steps = 24;
    Real way = 0, before = 0, value = start_value, value_before = value;
    for (int i = 0; i < most_steps; ++i) {
      if (way * start_value < 0) {
        return std::nullopt;  // past the point itself
      }
      if (std::fabs(value) <= surface_share * surface_share * field_.finest()) {
        return way;
      }
      const Real rise = value_before - value, secant = rise != 0 ? value * (way - before) / rise : value;
      before = way;
      value_before = value;
      way += i > 0 && std::fabs(secant) <= 2 * std::fabs(value) ? secant : value;
      value = field_.value_at(start - way * normal).value;
      if (!std::isfinite(value)) {
        return std::nullopt;
      }
    }
    return std::fabs(value) <= surface_share * field_.finest() ? std::optional(way) : std::nullopt;
  }

  const F& field_;
  const B& b_;
  Pose pose_;
};

}  // namespace abut
