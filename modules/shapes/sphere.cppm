// SPDX-License-Identifier: Apache-2.0
// Solid ball, centred.
export module abut.shapes.sphere;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class Sphere : public Ball {
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
  [[nodiscard]] std::vector<Real> parameters() const { return {radius()}; }
  [[nodiscard]] static std::vector<Sphere> samples() { return {Sphere(1), Sphere(0.25), Sphere(1e-3), Sphere(50)}; }

 private:
  inline explicit Sphere(Real radius) : Ball(radius) {}
};
static_assert(Shape<Sphere> && Placeable<Sphere> && BoxCored<Sphere> && FewFaced<Sphere>);

}  // namespace abut
