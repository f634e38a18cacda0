// SPDX-License-Identifier: Apache-2.0
// Solid capsule along local Z: all points within a radius of a segment.
export module abut.shapes.capsule;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class Capsule : public SegmentCore {
 public:
  static constexpr std::string_view name = "capsule";
  static constexpr std::array<std::string_view, 2> parameter_names{"radius", "half_height"};

  [[nodiscard]] static Result<Capsule> make(std::span<const Real> parameters, std::span<const Real> reals,
                                            std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 2)) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    if (Fault fault = check_positive("radius", parameters[0])) {
      return *fault;
    }
    if (Fault fault = check_not_negative("half_height", parameters[1])) {
      return *fault;
    }
    return Capsule(parameters[0], parameters[1]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius(), half_length()}; }
  [[nodiscard]] static std::vector<Capsule> samples() {
    return {Capsule(0.5, 1), Capsule(0.25, 0), Capsule(1e-3, 10), Capsule(20, 30)};
  }

  // The ray enters and leaves the endless cylinder around the axis; where it does so beyond the segment,
  // it enters or leaves through the cap of that end instead. One of the two always has the crossing, so
  // that rounding at the seam loses none.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Vec3 d = direction;
    const Real across = d.x * d.x + d.y * d.y;
    const Real along = across > 0 ? -(origin.x * d.x + origin.y * d.y) / across : 0;
    const Real x = origin.x + along * d.x, y = origin.y + along * d.y;
    const Real under = radius() * radius() - (x * x + y * y);
    if (under < 0) {
      return std::nullopt;
    }
    const Real half_chord = across > 0 ? std::sqrt(under / across) : infinity;
    const auto crossing = [&](Real side) -> std::optional<Real> {
      const Real on_cylinder = along + side * half_chord;
      const Real z = across > 0 ? origin.z + on_cylinder * d.z : side * d.z * infinity;
      if (std::fabs(z) <= half_length()) {
        return on_cylinder;
      }
      const Vec3 o = origin - Vec3{0, 0, std::copysign(half_length(), z)};
      const Real nearest = -dot(o, d);
      const Real below = radius() * radius() - squared_norm(o + nearest * d);
      return below >= 0 ? std::optional(nearest + side * std::sqrt(below)) : std::nullopt;
    };
    std::optional<Real> hit = crossing(-1);
    if (hit && *hit < 0) {
      hit = crossing(1);
    }
    if (!hit || !(*hit >= 0 && *hit <= max_distance)) {
      return std::nullopt;
    }
    const Vec3 point = origin + *hit * d;
    const Vec3 axis_point{0, 0, std::clamp(point.z, -half_length(), half_length())};
    return RayHit{*hit, UnitVec3::make(point - axis_point).value_or(direction), {FeatureKind::whole, 0}};
  }

 private:
  Capsule(Real radius, Real half_height) : SegmentCore(half_height, radius) {}
};
static_assert(Shape<Capsule> && Placeable<Capsule> && BoxCored<Capsule> && FewFaced<Capsule>);

}  // namespace abut
