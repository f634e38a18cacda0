// SPDX-License-Identifier: Apache-2.0
// A hole in the shape of a cylinder along Z, centred: cuts the solids of the composite that it is a child of.
// Where an end is removed the hole goes on beyond it without end.
export module abut.shapes.cylinder_hole;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class CylinderHole {
 public:
  static constexpr std::string_view name = "cylinder_hole";
  static constexpr std::array<std::string_view, 3> parameter_names{"radius", "half_height", "open_ends"};
  // Values of open_ends, which add up.
  static constexpr std::uint32_t top = 1, bottom = 2;

  [[nodiscard]] static Result<CylinderHole> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                 std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    if (parameters[2] > (top | bottom) || parameters[2] != std::floor(parameters[2])) {
      return error_about(Errc::unknown_value, "open_ends", parameters[2], "0 (none), 1 (top), 2 (bottom) or 3 (both)");
    }
    return CylinderHole(parameters[0], parameters[1], static_cast<std::uint32_t>(parameters[2]));
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_, half_height_, static_cast<Real>(open_)}; }
  [[nodiscard]] static std::vector<CylinderHole> samples() {
    return {CylinderHole(0.5, 1, 0), CylinderHole(0.75, 0.5, top), CylinderHole(0.5, 1, top | bottom)};
  }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    return transformed({{-radius_, -radius_, -half_height_}, {radius_, radius_, half_height_}}, pose);
  }
  [[nodiscard]] inline FlatWalls flat_walls() const {
    FlatWalls walls;
    if ((open_ & top) == 0) {
      walls.push_back({{0, 0, 1}, half_height_, 0});
    }
    if ((open_ & bottom) == 0) {
      walls.push_back({{0, 0, -1}, half_height_, 1});
    }
    return walls;
  }
  [[nodiscard]] inline std::optional<RoundWall> round_wall() const { return RoundWall{radius_, true, 2}; }
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    return cast_ray_at_walls(*this, origin, direction, max_distance);
  }

 private:
  CylinderHole(Real radius, Real half_height, std::uint32_t open)
      : radius_(radius), half_height_(half_height), open_(open) {}
  Real radius_;
  Real half_height_;
  std::uint32_t open_;
};
static_assert(Shape<CylinderHole> && Hole<CylinderHole>);

}  // namespace abut
