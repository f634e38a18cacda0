// Solid regular octahedron |x| + |y| + |z| <= radius.
module;
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
export module abut.shape.octahedron;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

class Octahedron {
 public:
  static constexpr std::string_view name = "octahedron";
  static constexpr std::array<std::string_view, 1> parameter_names{"radius"};

  [[nodiscard]] static Result<Octahedron> make(std::span<const Real> parameters, std::span<const Real> reals,
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
    return Octahedron(parameters[0]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_}; }
  [[nodiscard]] static std::vector<Octahedron> samples() { return {Octahedron(1), Octahedron(0.01)}; }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Rotation& r = pose.rotation;
    return Aabb::around(pose.position, radius_ * maximum(maximum(absolute(r.x), absolute(r.y)), absolute(r.z)));
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return radius_; }
  [[nodiscard]] inline SupportPoint support(const Vec3& d) const {
    const Vec3 m = absolute(d);
    const std::uint32_t axis = m.x >= m.y && m.x >= m.z ? 0 : m.y >= m.z ? 1 : 2;
    return at_vertex(axis, std::signbit(d[static_cast<int>(axis)]));
  }

  // Face i has the sign bits of i (bit 0: x negative, ...). An edge is numbered by the axis that it
  // avoids and the signs of the two others.
  [[nodiscard]] Face supporting_face(const Vec3& d) const {
    const std::array<bool, 3> negative{std::signbit(d.x), std::signbit(d.y), std::signbit(d.z)};
    const bool mirrored = (negative[0] != negative[1]) != negative[2];
    Face face;
    face.normal = normal_of(negative);
    face.index = (negative[0] ? 1u : 0u) | (negative[1] ? 2u : 0u) | (negative[2] ? 4u : 0u);
    for (std::uint32_t step = 0; step < 3; ++step) {
      const std::uint32_t axis = mirrored ? 2 - step : step, next = mirrored ? (axis + 2) % 3 : (axis + 1) % 3;
      const SupportPoint corner = at_vertex(axis, negative[axis]);
      const std::uint32_t avoided = 3 - axis - next;
      face.vertices.push_back({corner.point, corner.index, 8 * avoided + (face.index & ~(1u << avoided))});
    }
    return face;
  }

  // Cut by eight half-spaces. A ray that starts inside meets the far side.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    std::optional<RayHit> enter, leave;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Vec3 normal = normal_of({(i & 1u) != 0, (i & 2u) != 0, (i & 4u) != 0});
      const Real height = radius_ / std::sqrt(Real{3}) - dot(normal, origin), speed = dot(normal, direction.vec());
      const RayHit hit{height / speed, normal, {FeatureKind::face, i}};
      if (speed < 0 && (!enter || hit.distance > enter->distance)) {
        enter = hit;
      } else if (speed > 0 && (!leave || hit.distance < leave->distance)) {
        leave = hit;
      } else if (!(speed < 0 || speed > 0) && height < 0) {
        return std::nullopt;
      }
    }
    if (!enter || !leave || enter->distance > leave->distance) {
      return std::nullopt;
    }
    const RayHit& hit = enter->distance >= 0 ? *enter : *leave;
    return hit.distance >= 0 && hit.distance <= max_distance ? std::optional(hit) : std::nullopt;
  }

 private:
  explicit Octahedron(Real radius) : radius_(radius) {}
  [[nodiscard]] inline SupportPoint at_vertex(std::uint32_t axis, bool negative) const {
    const Real r = negative ? -radius_ : radius_;
    return {{axis == 0 ? r : 0, axis == 1 ? r : 0, axis == 2 ? r : 0}, 2 * axis + (negative ? 0u : 1u)};
  }
  [[nodiscard]] static inline Vec3 normal_of(const std::array<bool, 3>& negative) {
    const Real n = 1 / std::sqrt(Real{3});
    return {negative[0] ? -n : n, negative[1] ? -n : n, negative[2] ? -n : n};
  }

  Real radius_;
};
static_assert(Shape<Octahedron> && Convex<Octahedron>);

}  // namespace abut
