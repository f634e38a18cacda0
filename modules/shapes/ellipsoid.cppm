// SPDX-License-Identifier: Apache-2.0
// Solid ellipsoid, centred, by its radii along the axes.
export module abut.shapes.ellipsoid;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;

export namespace abut {

class Ellipsoid {
 public:
  static constexpr std::string_view name = "ellipsoid";
  static constexpr std::array<std::string_view, 3> parameter_names{"radius_x", "radius_y", "radius_z"};
  static constexpr bool is_curved = true;

  [[nodiscard]] static Result<Ellipsoid> make(std::span<const Real> parameters, std::span<const Real> reals,
                                              std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    return Ellipsoid({parameters[0], parameters[1], parameters[2]});
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radii_.x, radii_.y, radii_.z}; }
  [[nodiscard]] static std::vector<Ellipsoid> samples() {
    return {Ellipsoid({1, 1, 1}),        Ellipsoid({0.5, 1, 2}),  Ellipsoid({1, 1, 0.1}),
            Ellipsoid({1e-3, 1e-3, 10}), Ellipsoid({30, 20, 10}), Ellipsoid({1, 0.5, 0})};
  }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Rotation& r = pose.rotation;
    const auto reach = [&](int axis) { return norm(scaled({r.x[axis], r.y[axis], r.z[axis]})); };
    return Aabb::around(pose.position, {reach(0), reach(1), reach(2)});
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return largest_magnitude(radii_); }
  // The image of the support point of the unit ball that the ellipsoid is stretched from.
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const auto on_ball = UnitVec3::make(scaled(direction));
    return {on_ball ? scaled(*on_ball) : Vec3{0, 0, 0}, no_index};
  }
  // The support function is |E v| with the radii in E.
  [[nodiscard]] inline SecondOrder second_order(const DirectionFrame& frame) const {
    const Vec3 on_ball = scaled(frame.n);
    const Real length = norm(on_ball), largest = extent();
    if (!(length > flat_sine * largest)) {
      return second_order_of_point({0, 0, 0});
    }
    const Real inverse = 1 / length;
    const InFrame point = in_frame(frame, scaled(inverse * on_ball));
    SecondOrder near = second_order_of_point(point);
    const Vec3 x = scaled(frame.x), y = scaled(frame.y);
    near.xx = (squared_norm(x) - point.x * point.x) * inverse;
    near.xy = (dot(x, y) - point.x * point.y) * inverse;
    near.yy = (squared_norm(y) - point.y * point.y) * inverse;
    near.share = length / largest;
    near.slope = std::sqrt(point.x * point.x + point.y * point.y) / largest;
    if (const Real least = std::min({radii_.x, radii_.y, radii_.z}); length <= least * (1 + touching_distance(1))) {
      near.ball = least;
    }
    return near;
  }

  [[nodiscard]] inline InnerBalls inner_balls() const {
    return {{0, 0, 0}, {0, 0, 0}, std::min({radii_.x, radii_.y, radii_.z})};
  }

  // The nearest point x has p - x along the normal there. So for each axis
  //   x = r^2 p / (r^2 + t).
  // With the least radius m, t is the root above -m^2 of
  //   |r p / (r^2 + t)| = 1.
  // The inverse of that length is nearly linear. Newton's method on it comes from the left without overshooting (More
  // and Sorensen, "Computing a trust region step", 1983). It looks for t + m^2, so that nothing cancels next to the
  // plane across m. On that plane, inside, t may end at -m^2 itself.
  [[nodiscard]] SurfacePoint nearest(const Vec3& p) const {
    const int least = radii_.x <= radii_.y && radii_.x <= radii_.z ? 0 : radii_.y <= radii_.z ? 1 : 2;
    const Real m = radii_[least];
    const auto above = [&](int i) { return (radii_[i] - m) * (radii_[i] + m); };
    const auto share = [&](int i, Real s) { return radii_[i] * p[i] == 0 ? 0 : radii_[i] * p[i] / (above(i) + s); };
    const auto length = [&](Real s) { return norm({share(0, s), share(1, s), share(2, s)}); };
    Real s = 0;
    for (int i = 0; i < 3; ++i) {
      if (radii_[i] * p[i] != 0) {
        s = std::max(s, radii_[i] * std::fabs(p[i]) - above(i));
      }
    }
    if (s <= 0 && !(length(0) > 1)) {
      return nearest_across(p, least);
    }
    for (int round = 0; round < root_rounds; ++round) {
      const Real here = length(s);
      if (!(here > 1)) {
        break;
      }
      Real slope = 0;
      for (int i = 0; i < 3; ++i) {
        const Real one = share(i, s);
        slope += one == 0 ? 0 : one * one / (above(i) + s);
      }
      const Real next = s + (here - 1) * here * here / slope;
      if (!(next > s)) {
        break;
      }
      s = next;
    }
    const auto across = [&](int i) { return p[i] == 0 ? 0 : p[i] / (above(i) + s); };
    const Vec3 outward{across(0), across(1), across(2)};
    const Vec3 point{radii_.x * radii_.x * outward.x, radii_.y * radii_.y * outward.y, radii_.z * radii_.z * outward.z};
    return {point, UnitVec3::make(outward).value_or(UnitVec3::axis_z()), (s - m * m) * norm(outward)};
  }

  [[nodiscard]] inline Face supporting_face(const Vec3& direction) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({support(direction).point, 0, 0});
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const { return {FeatureKind::vertex, 0}; }

  // Against the unit ball, from where everything is stretched; distances stay the same numbers. A flat
  // ellipsoid is met in its plane.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const int flat_axes = (radii_.x == 0 ? 1 : 0) + (radii_.y == 0 ? 1 : 0) + (radii_.z == 0 ? 1 : 0);
    if (flat_axes > 0) {
      return flat_axes == 1 ? cast_ray_at_disc(origin, direction, max_distance) : std::nullopt;
    }
    const Vec3 o = shrunk(origin), d = shrunk(direction);
    const Real square = squared_norm(d), along = -dot(o, d) / square;
    const Real under = 1 - squared_norm(o + along * d);
    if (under < 0) {
      return std::nullopt;
    }
    const Real half_chord = std::sqrt(under / square);
    const Real distance = along - half_chord >= 0 ? along - half_chord : along + half_chord;
    if (!(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    // The gradient of x^2 / a^2 + y^2 / b^2 + z^2 / c^2.
    const auto normal = UnitVec3::make(shrunk(o + distance * d));
    return RayHit{distance, normal.value_or(direction), {FeatureKind::whole, 0}};
  }

 private:
  // Needed in tests on ratios of 1e6: a fourth of this.
  static constexpr int root_rounds = 64;

  explicit Ellipsoid(const Vec3& radii) : radii_(radii) {}

  [[nodiscard]] inline Vec3 scaled(const Vec3& v) const { return {radii_.x * v.x, radii_.y * v.y, radii_.z * v.z}; }
  [[nodiscard]] inline Vec3 shrunk(const Vec3& v) const { return {v.x / radii_.x, v.y / radii_.y, v.z / radii_.z}; }

  // Where all other radii leave room: the height over the plane across the least radius is free.
  [[nodiscard]] SurfacePoint nearest_across(const Vec3& p, int least) const {
    const Real end = -radii_[least] * radii_[least];
    const auto of = [&](int i, Real value, Real other) { return i == least ? value : other; };
    const auto share = [&](int i) {
      return radii_[i] * p[i] == 0 ? 0 : radii_[i] * p[i] / (radii_[i] * radii_[i] + end);
    };
    const Vec3 others{of(0, 0, share(0)), of(1, 0, share(1)), of(2, 0, share(2))};
    const Real left = std::sqrt(std::max(Real{0}, 1 - squared_norm(others))), side = std::copysign(Real{1}, p[least]);
    const Vec3 point{of(0, side * left, others.x) * radii_.x, of(1, side * left, others.y) * radii_.y,
                     of(2, side * left, others.z) * radii_.z};
    const Vec3 axis{of(0, side, 0), of(1, side, 0), of(2, side, 0)};
    if (radii_[least] == 0) {
      // The way out leads across the radii that are not zero: what is left along these is rounding.
      const auto across = [&](int i) { return radii_[i] == 0 ? p[i] : 0; };
      const Vec3 out{across(0), across(1), across(2)};
      return {point, UnitVec3::make(out).value_or(UnitVec3::from_unit_unchecked(axis)), norm(out)};
    }
    const auto normal = UnitVec3::make(
        {point.x / (radii_.x * radii_.x), point.y / (radii_.y * radii_.y), point.z / (radii_.z * radii_.z)});
    return {point, normal.value_or(UnitVec3::from_unit_unchecked(axis)), -norm(p - point)};
  }

  [[nodiscard]] std::optional<RayHit> cast_ray_at_disc(const Vec3& origin, const Vec3& d, Real max_distance) const {
    const int axis = radii_.x == 0 ? 0 : radii_.y == 0 ? 1 : 2;
    if (d[axis] == 0) {
      return std::nullopt;  // along the disc
    }
    const Real distance = -origin[axis] / d[axis];
    if (!(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    const Vec3 p = origin + distance * d;
    const auto part = [&](int i) { return i == axis ? 0 : p[i] / radii_[i]; };
    if (squared_norm({part(0), part(1), part(2)}) > 1) {
      return std::nullopt;
    }
    const Real side = -std::copysign(Real{1}, d[axis]);
    const Vec3 normal{axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0};
    return RayHit{distance, normal, {FeatureKind::whole, 0}};
  }

  Vec3 radii_;
};
static_assert(Shape<Ellipsoid> && Curved<Ellipsoid> && Field<Ellipsoid>);

}  // namespace abut
