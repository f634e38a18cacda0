// SPDX-License-Identifier: Apache-2.0
// A point: the origin of its own frame.
export module abut.shapes.point;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class Point : public PointCore {
 public:
  static constexpr std::string_view name = "point";
  static constexpr std::array<std::string_view, 0> parameter_names{};

  inline Point() : PointCore(0) {}

  [[nodiscard]] static Result<Point> make(std::span<const Real> parameters, std::span<const Real> reals,
                                          std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), 0)) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    return Point();
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {}; }
  [[nodiscard]] static std::vector<Point> samples() { return {Point()}; }

  // No ray meets a point, but for rounding.
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3&, const UnitVec3&, Real) const { return std::nullopt; }
};
static_assert(Shape<Point> && Placeable<Point> && PointCored<Point> && FewFaced<Point>);

}  // namespace abut
