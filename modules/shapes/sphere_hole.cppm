// SPDX-License-Identifier: Apache-2.0
// A hole in the shape of a ball, centred: cuts the solids of the composite that it is a child of.
export module abut.shapes.sphere_hole;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class SphereHole {
 public:
  static constexpr std::string_view name = "sphere_hole";
  static constexpr std::array<std::string_view, 1> parameter_names{"radius"};

  [[nodiscard]] static Result<SphereHole> make(std::span<const Real> parameters, std::span<const Real> reals,
                                               std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    return SphereHole(parameters[0]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_}; }
  [[nodiscard]] static std::vector<SphereHole> samples() { return {SphereHole(1), SphereHole(0.25)}; }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    return Aabb::around(pose.position, {radius_, radius_, radius_});
  }
  [[nodiscard]] inline FlatWalls flat_walls() const { return {}; }
  [[nodiscard]] inline std::optional<RoundWall> round_wall() const { return RoundWall{radius_, false, 0}; }
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    return cast_ray_at_walls(*this, origin, direction, max_distance);
  }

 private:
  explicit SphereHole(Real radius) : radius_(radius) {}
  Real radius_;
};
static_assert(Shape<SphereHole> && Hole<SphereHole>);

}  // namespace abut
