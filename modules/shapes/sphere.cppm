// Solid ball, centred.
module;
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
export module abut.shape.sphere;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

class Sphere : public PointCore {
 public:
  static constexpr std::string_view name = "sphere";
  static constexpr std::array<std::string_view, 1> parameter_names{"radius"};

  [[nodiscard]] static Result<Sphere> make(std::span<const Real> parameters, std::span<const Real> reals,
                                           std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 1)) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    if (Fault fault = check_positive("radius", parameters[0])) {
      return *fault;
    }
    return Sphere(parameters[0]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_}; }
  [[nodiscard]] static std::vector<Sphere> samples() { return {Sphere(1), Sphere(0.25), Sphere(1e-3), Sphere(50)}; }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const { return Aabb::around(pose.position, {radius_, radius_, radius_}); }
  [[nodiscard]] inline Real radius() const { return radius_; }

  // The two roots of |origin + t direction| = radius, in the form without cancellation
  // (Haines et al., "Precision improvements for ray/sphere intersection", 2019).
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Real along = -dot(origin, direction);
    const Vec3 nearest = origin + along * direction.vec();
    const Real under = radius_ * radius_ - squared_norm(nearest);
    if (under < 0) {
      return std::nullopt;
    }
    const Real half_chord = std::sqrt(under);
    const Real distance = along - half_chord >= 0 ? along - half_chord : along + half_chord;
    if (!(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    const auto normal = UnitVec3::make(origin + distance * direction.vec());
    return RayHit{distance, normal.value_or(direction), {FeatureKind::whole, 0}};
  }

 private:
  explicit Sphere(Real radius) : radius_(radius) {}
  Real radius_;
};
static_assert(Shape<Sphere> && Placeable<Sphere> && BoxCored<Sphere> && FewFaced<Sphere>);

}  // namespace abut
