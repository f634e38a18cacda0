// Solid cone along local Z: the base below, the apex above, the origin half-way up.
module;
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
export module abut.shape.cone;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

class Cone {
 public:
  static constexpr std::string_view name = "cone";
  static constexpr std::array<std::string_view, 2> parameter_names{"radius", "half_height"};
  static constexpr bool is_curved = true;

  [[nodiscard]] static Result<Cone> make(std::span<const Real> parameters, std::span<const Real> reals,
                                             std::span<const std::uint32_t> indices) {
    if (Fault fault = check_count("parameter_count", parameters.size(), parameter_names.size())) {
      return *fault;
    }
    if (Fault fault = check_no_buffers(reals, indices)) {
      return *fault;
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (Fault fault = check_not_negative(parameter_names[i], parameters[i])) {
        return *fault;
      }
    }
    return Cone(parameters[0], parameters[1]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_, half_height_}; }
  [[nodiscard]] static std::vector<Cone> samples() {
    return {Cone(0.5, 1), Cone(1, 0.1), Cone(1e-3, 10), Cone(20, 30), Cone(1, 0), Cone(0, 1)};
  }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Vec3 &x = pose.rotation.x, &y = pose.rotation.y;
    const Vec3 disc = radius_ * Vec3{std::hypot(x.x, y.x), std::hypot(x.y, y.y), std::hypot(x.z, y.z)};
    const Vec3 up = half_height_ * pose.rotation.z, base = pose.position - up, apex = pose.position + up;
    return {minimum(base - disc, apex), maximum(base + disc, apex)};
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return std::max(radius_, half_height_); }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const Sideways side = sideways_of(direction);
    if (2 * half_height_ * direction.z > radius_ * side.length) {
      return {{0, 0, half_height_}, apex_number};
    }
    return {{radius_ * side.x, radius_ * side.y, -half_height_}, no_index};
  }

  // In the half-plane through the axis and the point: a triangle with a base along x and a side up to the apex.
  [[nodiscard]] SurfacePoint nearest(const Vec3& p) const {
    const Sideways around = sideways_of(p);
    const Real height = p.z + half_height_, slant = std::hypot(2 * half_height_, radius_);
    const auto lifted = [&](Real x, Real z, Real normal_x, Real normal_z, Real distance) {
      return SurfacePoint{{x * around.x, x * around.y, z - half_height_}, {normal_x * around.x, normal_x * around.y, normal_z}, distance};
    };
    const auto from_corner = [&](Real x, Real z) {
      const Real dx = around.length - x, dz = height - z, distance = std::hypot(dx, dz);
      return distance > 0 ? lifted(x, z, dx / distance, dz / distance, distance) : lifted(x, z, 0, z > 0 ? 1 : -1, 0);
    };
    if (slant == 0) {
      return from_corner(0, 0);
    }
    // Out of the side, and along it from the rim.
    const Real out_x = 2 * half_height_ / slant, out_z = radius_ / slant;
    const Real beside = (around.length - radius_) * out_x + height * out_z;
    const Real along = (radius_ - around.length) * out_z + height * out_x;
    if (height <= 0 && around.length <= radius_) {
      return lifted(around.length, 0, 0, -1, -height);
    }
    if (height <= 0 || beside > 0) {
      if (along <= 0) {
        return from_corner(radius_, 0);
      }
      if (along >= slant) {
        return from_corner(0, 2 * half_height_);
      }
    }
    if (beside > 0 || beside >= -height) {
      return lifted(around.length - beside * out_x, height - beside * out_z, out_x, out_z, beside);
    }
    return lifted(around.length, 0, 0, -1, -height);
  }

  // Face 0 is the base and face 1 its back where there is no height; corners and edges below 16 are the rim,
  // vertex 16 the apex, edge 16 the side.
  [[nodiscard]] Face supporting_face(const Vec3& direction) const {
    const Sideways side = sideways_of(direction);
    if (half_height_ == 0 && radius_ > 0) {
      return rim_face(radius_, 0, direction.z >= 0, direction.z >= 0 ? 1 : 0, 0);
    }
    const Real toward_side = (2 * half_height_ * side.length + radius_ * direction.z) / std::hypot(2 * half_height_, radius_);
    if (radius_ > 0 && -direction.z >= toward_side) {
      return rim_face(radius_, -half_height_, false, 0, 0);
    }
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, half_height_}, apex_number, apex_number});
    if (half_height_ > 0 && !(radius_ > 0 && direction.z > toward_side)) {
      face.vertices.push_back({{radius_ * side.x, radius_ * side.y, -half_height_}, apex_number + 1, apex_number});
    }
    return face;
  }

  // Crossings with the base and with the side, of which a convex solid has at most two.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Vec3 d = direction;
    std::optional<RayHit> best;
    const auto consider = [&](Real distance, const Vec3& normal, std::uint32_t face) {
      if (distance >= 0 && distance <= max_distance && (!best || distance < best->distance)) {
        best = RayHit{distance, normal, {FeatureKind::face, face}};
      }
    };
    if (d.z != 0) {
      const Real distance = (-half_height_ - origin.z) / d.z;
      if (std::hypot(origin.x + distance * d.x, origin.y + distance * d.y) <= radius_) {
        consider(distance, {0, 0, -1}, 0);
      }
    }
    if (half_height_ == 0) {
      return best;
    }
    // x^2 + y^2 = slope^2 * below^2, below being the depth under the apex.
    const Real slope = radius_ / (2 * half_height_), steep = slope * slope;
    const Real below = half_height_ - origin.z;
    const Real a = d.x * d.x + d.y * d.y - steep * d.z * d.z;
    const Real b = origin.x * d.x + origin.y * d.y + steep * below * d.z;
    const Real c = origin.x * origin.x + origin.y * origin.y - steep * below * below;
    const Real under = b * b - a * c;
    if (under < 0) {
      return best;
    }
    // The root without cancellation first, the other one from the product of both.
    const Real q = -(b + std::copysign(std::sqrt(under), b));
    for (const Real distance : {q / a, c / q}) {
      const Vec3 p = origin + distance * d;
      if (std::fabs(p.z) <= half_height_) {
        const Sideways out = sideways_of(p);
        const Real length = std::hypot(Real{1}, slope);
        consider(distance, {out.x / length, out.y / length, slope / length}, 1);
      }
    }
    return best;
  }

 private:
  static constexpr std::uint32_t apex_number = rim_corners;

  Cone(Real radius, Real half_height) : radius_(radius), half_height_(half_height) {}
  Real radius_;
  Real half_height_;
};
static_assert(Shape<Cone> && Curved<Cone> && Field<Cone>);

}  // namespace abut
