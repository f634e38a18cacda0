// SPDX-License-Identifier: Apache-2.0
// A hole in the shape of a box, centred: cuts the solids of the composite that it is a child of. Where a face is
// removed the hole goes on beyond it without end; faces are removed along one axis at most.
export module abut.shapes.box_hole;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class BoxHole {
 public:
  static constexpr std::string_view name = "box_hole";
  static constexpr std::array<std::string_view, 4> parameter_names{"half_x", "half_y", "half_z", "open_faces"};

  // open_faces: the sum of 1 (+X), 2 (-X), 4 (+Y), 8 (-Y), 16 (+Z) and 32 (-Z).
  [[nodiscard]] static Result<BoxHole> make(std::span<const Real> parameters, std::span<const Real> reals,
                                            std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    constexpr std::uint32_t all = 63;
    if (parameters[3] > all || parameters[3] != std::floor(parameters[3])) {
      return error_about(Errc::unknown_value, "open_faces", parameters[3], "a sum of 1, 2, 4, 8, 16 and 32");
    }
    const auto open = static_cast<std::uint32_t>(parameters[3]);
    const int axes = ((open & 3u) != 0 ? 1 : 0) + ((open & 12u) != 0 ? 1 : 0) + ((open & 48u) != 0 ? 1 : 0);
    if (axes > 1) {
      return error_about(Errc::invalid_argument, "open_faces", parameters[3], "faces of one axis only");
    }
    return BoxHole({parameters[0], parameters[1], parameters[2]}, open);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {half_.x, half_.y, half_.z, static_cast<Real>(open_)}; }
  [[nodiscard]] static std::vector<BoxHole> samples() {
    return {BoxHole({1, 0.75, 0.5}, 0), BoxHole({0.5, 0.5, 1}, 16), BoxHole({2, 0.5, 0.5}, 3)};
  }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const { return transformed({-half_, half_}, pose); }
  [[nodiscard]] inline FlatWalls flat_walls() const {
    FlatWalls walls;
    for (std::uint32_t face = 0; face < 6; ++face) {
      if ((open_ >> face & 1u) == 0) {
        const Real sign = face % 2 == 0 ? 1 : -1;
        const std::uint32_t axis = face / 2;
        walls.push_back(
            {{axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0}, half_[static_cast<int>(axis)], face});
      }
    }
    return walls;
  }
  [[nodiscard]] inline std::optional<RoundWall> round_wall() const { return std::nullopt; }
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    return cast_ray_at_walls(*this, origin, direction, max_distance);
  }

 private:
  BoxHole(const Vec3& half, std::uint32_t open) : half_(half), open_(open) {}
  Vec3 half_;
  std::uint32_t open_;
};
static_assert(Shape<BoxHole> && Hole<BoxHole>);

}  // namespace abut
