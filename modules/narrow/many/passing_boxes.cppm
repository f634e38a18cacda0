// SPDX-License-Identifier: Apache-2.0
// Which of four pairs of triangles may meet while the second ones move: boxes around them, along the axes of the
// surfaces that they belong to, do at some time.
export module abut.narrow.many.passing_boxes;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;

export namespace abut {

class PassingBoxes {
 public:
  // `of_second`: the axes of the surface of the second triangles, in the frame of the first ones.
  explicit PassingBoxes(const Rotation& of_second) : of_second_(of_second) {}

  // After which shares of the way boxes come as near as `slack`; infinity where they never do.
  [[nodiscard]] Lanes enter(const FourTriangles& first, const FourTriangles& second, const Vec3& way,
                            Real slack) const {
    // The shares from which on, and until which, boxes overlap along all axes.
    Lanes enter = all_lanes(0), leave = all_lanes(1);
    const Lanes near = all_lanes(slack) + noise_of(maximum(first.size(), second.size()));
    const auto pass = [&](const Vec3& axis, const auto& along) {
      const Lanes a = along(first.a), b = along(first.b), c = along(first.c);
      const Lanes p = along(second.a), q = along(second.b), r = along(second.c);
      const Lanes begin = minimum(minimum(a, b), c) - maximum(maximum(p, q), r) - near,
                  end = maximum(maximum(a, b), c) - minimum(minimum(p, q), r) + near;
      // Slower parts of a way count as this one: boxes overlap or not, whenever that is.
      constexpr Real slowest = 1e-200;
      const Real speed = dot(axis, way), inverse = 1 / (std::fabs(speed) > slowest ? speed : slowest);
      enter = maximum(enter, (inverse > 0 ? begin : end) * inverse);
      leave = minimum(leave, (inverse > 0 ? end : begin) * inverse);
    };
    pass({1, 0, 0}, [](const Columns& corner) { return corner.x; });
    pass({0, 1, 0}, [](const Columns& corner) { return corner.y; });
    pass({0, 0, 1}, [](const Columns& corner) { return corner.z; });
    for (const Vec3& axis : {of_second_.x, of_second_.y, of_second_.z}) {
      pass(axis, [&](const Columns& corner) { return dot(Columns::all(axis), corner); });
    }
    return enter <= leave ? enter : all_lanes(infinity);
  }
  // A bit for each pair that comes as near.
  [[nodiscard]] std::uint64_t meet(const FourTriangles& first, const FourTriangles& second, const Vec3& way,
                                   Real slack) const {
    return bits_of(enter(first, second, way, slack) <= all_lanes(1));
  }

 private:
  Rotation of_second_;
};

}  // namespace abut
