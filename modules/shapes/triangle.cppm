// SPDX-License-Identifier: Apache-2.0
// A triangle by itself, both sides solid; meshes and height fields are made of surface triangles instead.
export module abut.shapes.triangle;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class FreeTriangle : public Triangle {
 public:
  static constexpr std::string_view name = "triangle";
  static constexpr std::array<std::string_view, 9> parameter_names{"a_x", "a_y", "a_z", "b_x", "b_y",
                                                                   "b_z", "c_x", "c_y", "c_z"};

  [[nodiscard]] static Result<FreeTriangle> make(std::span<const Real> parameters, std::span<const Real> reals,
                                                 std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), parameter_names.size())) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (Fault fault = check_finite(parameter_names[i], parameters[i])) {
        return *fault;
      }
    }
    const auto corner = [&](std::size_t i) { return Vec3{parameters[i], parameters[i + 1], parameters[i + 2]}; };
    return FreeTriangle(corner(0), corner(3), corner(6));
  }
  [[nodiscard]] std::vector<Real> parameters() const {
    std::vector<Real> numbers;
    for (const Vec3& p : corners()) {
      numbers.insert(numbers.end(), {p.x, p.y, p.z});
    }
    return numbers;
  }
  [[nodiscard]] static std::vector<FreeTriangle> samples() {
    return {FreeTriangle({1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}),
            FreeTriangle({0, 0, 0}, {10, 0, 0}, {10, 1e-3, 0}), FreeTriangle({-1, 0, 1}, {0, 0, 0}, {1, 0, -1}),
            FreeTriangle({0.2, 0.3, 0.4}, {0.2, 0.3, 0.4}, {0.2, 0.3, 0.4})};
  }

  [[nodiscard]] Triangles triangles() const { return {{corners().begin(), corners().end()}, {0, 1, 2}}; }

 private:
  FreeTriangle(const Vec3& a, const Vec3& b, const Vec3& c) : Triangle(a, b, c, 0, false) {}
};
static_assert(Shape<FreeTriangle> && FewFaced<FreeTriangle> && Triangulated<FreeTriangle>);

}  // namespace abut
