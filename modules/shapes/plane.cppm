// SPDX-License-Identifier: Apache-2.0
// Half-space: everything behind a plane. Unbounded; the normal points out of the solid.
export module abut.shapes.plane;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class Plane {
 public:
  static constexpr std::string_view name = "plane";
  static constexpr std::array<std::string_view, 4> parameter_names{"normal_x", "normal_y", "normal_z", "offset"};

  [[nodiscard]] static Result<Plane> make(std::span<const Real> parameters, std::span<const Real> reals,
                                          std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 4)) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (Fault fault = check_finite(parameter_names[i], parameters[i])) {
        return *fault;
      }
    }
    const Vec3 given{parameters[0], parameters[1], parameters[2]};
    const auto normal = UnitVec3::make(given);
    if (!normal) {
      return Error{Errc::zero_vector, "normal is (0, 0, 0); it must have a direction"};
    }
    // One of length one within rounding stays as it is: what a plane tells about itself makes the same plane again.
    const bool is_unit = std::fabs(squared_norm(given) - 1) <= 4 * epsilon;
    return Plane(is_unit ? UnitVec3::from_unit_unchecked(given) : *normal, parameters[3]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {normal_.x, normal_.y, normal_.z, offset_}; }
  [[nodiscard]] static std::vector<Plane> samples() {
    return {Plane(UnitVec3::axis_z(), 0), Plane(UnitVec3::from_unit_unchecked({0.6, 0, 0.8}), 1)};
  }

  [[nodiscard]] inline Aabb aabb(const Pose&) const { return Aabb::everything(); }
  [[nodiscard]] inline Vec3 normal() const { return normal_; }
  [[nodiscard]] inline Real offset() const { return offset_; }

  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction,
                                                      Real max_distance) const {
    const Real approach = dot(normal_, direction);
    const Real height = dot(normal_, origin) - offset_;
    if (approach == 0) {
      return std::nullopt;
    }
    const Real distance = -height / approach;
    if (!(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    return RayHit{distance, normal_, {FeatureKind::whole, 0}};
  }

 private:
  Plane(const UnitVec3& normal, Real offset) : normal_(normal), offset_(offset) {}
  Vec3 normal_;
  Real offset_;
};
static_assert(Shape<Plane> && HalfSpace<Plane>);

}  // namespace abut
