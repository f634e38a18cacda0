// Solid capsule along local Z: all points within a radius of a segment.
module;
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
export module abut.shape.capsule;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

class Capsule {
 public:
  static constexpr std::string_view name = "capsule";
  static constexpr std::array<std::string_view, 2> parameter_names{"radius", "half_height"};
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 1;

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
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_, half_height_}; }
  [[nodiscard]] static std::vector<Capsule> samples() {
    return {Capsule(0.5, 1), Capsule(0.25, 0), Capsule(1e-3, 10), Capsule(20, 30)};
  }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Vec3 r{radius_, radius_, radius_};
    return Aabb::around(pose.position, half_height_ * absolute(pose.rotation.z) + r);
  }
  [[nodiscard]] inline Vec3 half() const { return {0, 0, half_height_}; }
  [[nodiscard]] inline Real radius() const { return radius_; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return half_height_; }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const bool upper = direction.z >= 0;
    return {{0, 0, upper ? half_height_ : -half_height_}, upper ? 1u : 0u};
  }
  [[nodiscard]] inline Real reach(const Vec3& direction) const { return half_height_ * std::fabs(direction.z); }
  [[nodiscard]] inline PlacedSegment placed(const Pose& pose) const { return {pose.position, half_height_ * pose.rotation.z}; }
  [[nodiscard]] inline Face supporting_face(const Vec3&) const {
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, -half_height_}, 0, 0});
    if (half_height_ > 0) {
      face.vertices.push_back({{0, 0, half_height_}, 1, 0});
    }
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3&) const {
    return {half_height_ > 0 ? FeatureKind::edge : FeatureKind::vertex, 0};
  }
  [[nodiscard]] inline std::array<Vec3, 0> face_normals() const { return {}; }
  [[nodiscard]] inline std::array<Vec3, 1> edge_directions() const { return {Vec3{0, 0, 1}}; }

  // The surface is crossed where the ray enters or leaves the side or a cap; candidates are the two
  // roots on the infinite cylinder, kept between the caps, and the outer roots on both spheres.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Vec3 d = direction;
    Real best = infinity;
    const auto consider = [&](Real t, bool on_side) {
      if (t >= 0 && t < best) {
        const Real z = origin.z + t * d.z;
        if (on_side ? std::fabs(z) <= half_height_ : std::fabs(z) >= half_height_) {
          best = t;
        }
      }
    };
    const auto roots = [&](Real a, const Vec3& o, bool flat, bool on_side) {
      const Real along = -(o.x * d.x + o.y * d.y + (flat ? 0 : o.z * d.z)) / a;
      const Vec3 nearest = o + along * d;
      const Real under = radius_ * radius_ - (nearest.x * nearest.x + nearest.y * nearest.y + (flat ? 0 : nearest.z * nearest.z));
      if (under >= 0) {
        const Real half_chord = std::sqrt(under / a);
        consider(along - half_chord, on_side);
        consider(along + half_chord, on_side);
      }
    };
    const Real across = d.x * d.x + d.y * d.y;
    if (across > 0) {
      roots(across, origin, true, true);
    }
    roots(1, {origin.x, origin.y, origin.z - half_height_}, false, false);
    roots(1, {origin.x, origin.y, origin.z + half_height_}, false, false);
    if (best == infinity || !(best <= max_distance)) {
      return std::nullopt;
    }
    const Vec3 point = origin + best * d;
    const Vec3 axis_point{0, 0, std::clamp(point.z, -half_height_, half_height_)};
    return RayHit{best, UnitVec3::make(point - axis_point).value_or(direction), {FeatureKind::whole, 0}};
  }

 private:
  Capsule(Real radius, Real half_height) : radius_(radius), half_height_(half_height) {}
  Real radius_;
  Real half_height_;
};
static_assert(Shape<Capsule> && Placeable<Capsule> && BoxCored<Capsule> && FewFaced<Capsule>);

}  // namespace abut
