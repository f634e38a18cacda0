// SPDX-License-Identifier: Apache-2.0
// Solid rounded cone along local Z: the convex hull of two balls, the origin half-way between their centres.
export module abut.shapes.rounded_cone;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class RoundedCone {
 public:
  static constexpr std::string_view name = "rounded_cone";
  static constexpr std::array<std::string_view, 3> parameter_names{"bottom_radius", "top_radius", "half_height"};
  static constexpr bool is_curved = true;

  [[nodiscard]] static Result<RoundedCone> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                std::span<const std::uint32_t> indices) {
    const Fault fault = check_lengths(parameter_names, parameters, reals, indices);
    return fault ? Result<RoundedCone>(*fault) : RoundedCone(parameters[0], parameters[1], parameters[2]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {parameters_.begin(), parameters_.end()}; }
  [[nodiscard]] static std::vector<RoundedCone> samples() {
    return {{1, 0.4, 0.5}, {0, 1, 1}, {0.2, 1, 0.1}, {1e-3, 2e-3, 10}};
  }
  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Vec3 a = pose * centre_of(0), b = pose * centre_of(1), one{1, 1, 1};
    return {minimum(a - radii_[0] * one, b - radii_[1] * one), maximum(a + radii_[0] * one, b + radii_[1] * one)};
  }
  [[nodiscard]] inline Real radius() const {
    return std::fmin(radii_[0], radii_[1]);
  }  // the core is a ball and a point
  [[nodiscard]] inline Vec3 centre() const { return 0.5 * (centre_of(0) + centre_of(1)); }
  [[nodiscard]] inline Real extent() const {
    return (heights_[1] - heights_[0]) / 2 + std::fabs(radii_[0] - radii_[1]);
  }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const Vec3 normal = unit(direction);
    return {core(normal.z > sine_ ? 1 : 0, normal), no_index};
  }
  // Vertices 0 and 1 are the ends, edge 0 runs along the side from one to the other.
  [[nodiscard]] Face supporting_face(const Vec3& direction) const {
    const Vec3 normal = unit(direction), beside = side_normal(sideways_of(normal));
    const std::uint32_t end = normal.z > sine_ ? 1 : 0;
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({core(end, normal), end, 0});
    if (heights_[0] < heights_[1] && dot(normal, beside) > std::fabs(normal.z)) {
      face.vertices.push_back({core(1 - end, beside), 1 - end, 0});
    }
    return face;
  }
  // The normal leads from the centre of a ball to its own part of the surface, or else out of the side.
  [[nodiscard]] SurfacePoint nearest(const Vec3& p) const {
    const Vec3 down = p - centre_of(0), up = p - centre_of(1);
    const bool top = up.z > sine_ * norm(up), bottom = down.z <= sine_ * norm(down);
    const Vec3 normal = top ? unit(up) : bottom ? unit(down) : side_normal(sideways_of(p));
    const Real distance = dot(p - core(top ? 1 : 0, normal), normal);
    return {p - distance * normal, normal, distance};
  }
  // Enters where the ray first meets a ball, or the side between the circles where it touches them; leaves where it
  // last does.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Real start = -dot(origin, direction),
               square = cosine_ * cosine_;  // from q on, so that far rays lose no digits
    const Vec3 d = direction, q = origin + start * d, e{d.x, d.y, 0}, f{q.x, q.y, 0};
    Real enter = infinity, leave = -infinity;
    // Roots t of u (x^2 + y^2) + v (l + t m)^2 = w between two heights, the one without cancellation first; NaN for
    // none.
    const auto meet = [&](Real u, Real v, Real l, Real m, Real w, Real low, Real high) {
      const Real a = u * dot(e, e) + v * m * m, b = u * dot(e, f) + v * l * m, c = u * dot(f, f) + v * l * l - w;
      const Real under = a * w - u * (u * squared_norm(cross(e, f)) + v * squared_norm(l * e - m * f));
      const Real sum = -(b + std::copysign(std::sqrt(under), b));
      for (const Real t : {a != 0 ? sum / a : infinity, sum != 0 ? c / sum : infinity}) {
        const bool counts = q.z + t * d.z > low && q.z + t * d.z < high;
        enter = counts ? std::fmin(enter, t) : enter;
        leave = counts ? std::fmax(leave, t) : leave;
      }
    };
    meet(1, 1, q.z - heights_[0], d.z, radii_[0] * radii_[0], -infinity, infinity);
    meet(1, 1, q.z - heights_[1], d.z, radii_[1] * radii_[1], -infinity, infinity);
    const Real low = heights_[0] + sine_ * radii_[0], high = heights_[1] + sine_ * radii_[1];
    meet(square, -1, radii_[0] - sine_ * (q.z - heights_[0]), -sine_ * d.z, 0, low, high);
    const Real at = start + enter >= 0 ? enter : leave, distance = start + at;
    const bool is_hit = enter <= leave && distance >= 0 && distance <= max_distance;
    return is_hit ? std::optional(RayHit{distance, nearest(q + at * d).normal, {FeatureKind::whole, 0}}) : std::nullopt;
  }

 private:
  RoundedCone(Real bottom, Real top, Real h)
      : RoundedCone(bottom, top, h, bottom - top >= 2 * h, top - bottom >= 2 * h) {}
  RoundedCone(Real bottom, Real top, Real h, bool bottom_holds, bool top_holds)
      : parameters_{bottom, top, h},
        radii_{top_holds ? top : bottom, bottom_holds ? bottom : top},
        heights_{top_holds ? h : -h, bottom_holds ? -h : h},
        sine_(bottom_holds || top_holds ? 0 : (bottom - top) / (2 * h)),
        cosine_(std::sqrt((1 - sine_) * (1 + sine_))) {}
  [[nodiscard]] static inline Vec3 unit(const Vec3& v) { return UnitVec3::make(v).value_or(-UnitVec3::axis_z()); }
  [[nodiscard]] inline Vec3 centre_of(std::uint32_t end) const { return {0, 0, heights_[end]}; }
  [[nodiscard]] inline Vec3 core(std::uint32_t end, const Vec3& n) const {
    return centre_of(end) + (radii_[end] - radius()) * n;
  }
  [[nodiscard]] inline Vec3 side_normal(const Sideways& out) const { return {cosine_ * out.x, cosine_ * out.y, sine_}; }
  std::array<Real, 3> parameters_;
  std::array<Real, 2> radii_, heights_;  // where one ball holds the other, it stands for both
  Real sine_, cosine_;                   // of how far the normal of the side rises
};
static_assert(Shape<RoundedCone> && Curved<RoundedCone> && Field<RoundedCone>);

}  // namespace abut
