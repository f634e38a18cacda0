// SPDX-License-Identifier: Apache-2.0
// Solid cone along local Z: the base below, the apex above, the origin half-way up.
export module abut.shapes.cone;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

class Cone {
 public:
  static constexpr std::string_view name = "cone";
  static constexpr std::array<std::string_view, 2> parameter_names{"radius", "half_height"};
  static constexpr bool is_curved = true;

  [[nodiscard]] static Result<Cone> make(std::span<const Real> parameters, std::span<const Real> reals,
                                         std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
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

  // The apex alone, or the base with an edge to the apex.
  [[nodiscard]] inline SecondOrder second_order(const DirectionFrame& frame) const {
    const Sideways side = sideways_of(frame.n);
    const Vec3 apex{0, 0, half_height_};
    if (side.length < flat_sine) {
      SecondOrder near = second_order_of_point(in_frame(frame, frame.n.z > 0 ? apex : -apex));
      near.disc = frame.n.z > 0 && half_height_ > 0 ? 0 : radius_;
      return near;
    }
    const Vec3 rim{radius_ * side.x, radius_ * side.y, -half_height_};
    const InFrame edge = in_frame(frame, apex - rim);
    if (edge.n > apex_lead * half_height_) {
      return second_order_of_point(in_frame(frame, apex));
    }
    SecondOrder near = second_order_of_point(in_frame(frame, rim));
    bend_by_disc(frame, {side.x, side.y, side.length}, radius_, near);
    if (half_height_ > 0) {
      near.edges[0] = edge;
      near.edge_count = 1;
      near.is_sum = false;
    }
    return near;
  }

  [[nodiscard]] inline Discs discs() const { return {half_height_, 0, radius_}; }
  // The circle inside the triangle that a plane through the axis cuts out.
  [[nodiscard]] inline InnerBalls inner_balls() const {
    const Real sides = radius_ + norm({2 * half_height_, radius_, 0});
    const Real ball = sides > 0 ? 2 * radius_ * half_height_ / sides : 0;
    return {{0, 0, ball - half_height_}, {0, 0, 0}, ball};
  }

  // In the half-plane through the axis and the point: a triangle with a base along x and a side up to the apex.
  [[nodiscard]] SurfacePoint nearest(const Vec3& p) const {
    const Sideways around = sideways_of(p);
    const Real height = p.z + half_height_, slant = norm({2 * half_height_, radius_, 0});
    const auto lifted = [&](Real x, Real z, Real normal_x, Real normal_z, Real distance) {
      return SurfacePoint{{x * around.x, x * around.y, z - half_height_},
                          {normal_x * around.x, normal_x * around.y, normal_z},
                          distance};
    };
    // Away from a corner by differences that are exact near to it. At the corner itself as a neighbour faces.
    const auto from_corner = [&](Real x, Real z, Real dx, Real dz, Real usual_x, Real usual_z) {
      const Real distance = norm({dx, dz, 0});
      return distance > 0 ? lifted(x, z, dx / distance, dz / distance, distance) : lifted(x, z, usual_x, usual_z, 0);
    };
    if (slant == 0) {
      return from_corner(0, 0, around.length, p.z, 0, 1);
    }
    // Out of the side, and along it from the rim.
    const Real out_x = 2 * half_height_ / slant, out_z = radius_ / slant;
    const Real beside = (around.length - radius_) * out_x + height * out_z;
    const Real along = (radius_ - around.length) * out_z + height * out_x;
    if (height <= 0 && around.length <= radius_) {
      return lifted(around.length, 0, 0, -1, -height);
    }
    // It is beyond an end of the side only where the way from the corner is one of its normals. Rounding of `along` may
    // miss that.
    if (height <= 0 || beside >= 0) {
      const Real from_rim = around.length - radius_, from_apex = p.z - half_height_;
      if (along <= 0 && from_rim * out_z >= height * out_x) {
        return from_corner(radius_, 0, from_rim, height, out_x, out_z);
      }
      if (along >= slant && from_apex * out_x >= around.length * out_z) {
        return from_corner(0, 2 * half_height_, around.length, from_apex, 0, 1);
      }
    }
    if (beside > 0 || beside >= -height) {
      return lifted(around.length - beside * out_x, height - beside * out_z, out_x, out_z, beside);
    }
    return lifted(around.length, 0, 0, -1, -height);
  }

  // Face 0 is the base and face 1 its back where there is no height; corners and edges below 16 are the rim,
  // vertex 16 the apex, edge 16 the side.
  [[nodiscard]] inline std::optional<Rim> supporting_rim(const Vec3& direction) const {
    if (half_height_ == 0 && radius_ > 0) {
      const bool is_up = direction.z >= 0;
      return Rim{radius_, 0, is_up, is_up ? 1u : 0u, 0};
    }
    if (radius_ > 0 && -direction.z >= toward_side(direction)) {
      return Rim{radius_, -half_height_, false, 0, 0};
    }
    return std::nullopt;
  }
  [[nodiscard]] Face supporting_face(const Vec3& direction) const {
    if (const std::optional<Rim> rim = supporting_rim(direction)) {
      return rim_face(*rim);
    }
    const Sideways side = sideways_of(direction);
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{0, 0, half_height_}, apex_number, apex_number});
    if (supports_side(direction)) {
      face.vertices.push_back({{radius_ * side.x, radius_ * side.y, -half_height_}, apex_number + 1, apex_number});
    }
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3& direction) const {
    if (const std::optional<Rim> rim = supporting_rim(direction)) {
      return {FeatureKind::face, rim->index};
    }
    return {supports_side(direction) ? FeatureKind::edge : FeatureKind::vertex, apex_number};
  }

  // The stretch of the ray between the planes of the base and of the apex and within the endless cone. From the
  // point of the ray nearest to the apex on, so that far rays lose no digits.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Vec3 d = direction;
    if (half_height_ == 0) {
      return cast_ray_at_disc(origin, d, max_distance);
    }
    const Vec3 from_apex = origin - Vec3{0, 0, half_height_};
    const Real start = -dot(from_apex, d);
    const Vec3 q = from_apex + start * d;
    if (d.z == 0 && !(q.z <= 0 && q.z >= -2 * half_height_)) {
      return std::nullopt;
    }
    const Real base = d.z != 0 ? (-2 * half_height_ - q.z) / d.z : infinity, top = d.z != 0 ? -q.z / d.z : -infinity;
    const Inside inside = within_endless(q, d);
    const Real enter = std::max(std::min(base, top), inside.from), leave = std::min(std::max(base, top), inside.to);
    const Real at = start + enter >= 0 ? enter : leave, distance = start + at;
    if (!(enter <= leave) || !(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    if (at == base) {
      return RayHit{distance, {0, 0, -1}, {FeatureKind::face, 0}};
    }
    const Sideways out = sideways_of(q + at * d);
    const Real slant = std::hypot(2 * half_height_, radius_), up = radius_ / slant, across = 2 * half_height_ / slant;
    return RayHit{
        distance, out.length > 0 ? Vec3{across * out.x, across * out.y, up} : Vec3{0, 0, 1}, {FeatureKind::face, 1}};
  }

 private:
  static constexpr std::uint32_t apex_number = rim_corners;
  static constexpr Real apex_lead = 0.5;  // so much further, in half heights, the base is out of sight of the apex

  // Along the normal of the side.
  [[nodiscard]] inline Real toward_side(const Vec3& direction) const {
    return (2 * half_height_ * sideways_of(direction).length + radius_ * direction.z) /
           norm({2 * half_height_, radius_, 0});
  }
  // Of a direction in which the base is no support: whether the whole side is, and not the apex alone.
  [[nodiscard]] inline bool supports_side(const Vec3& direction) const {
    return half_height_ > 0 && !(radius_ > 0 && direction.z > toward_side(direction));
  }

  struct Inside {
    Real from, to;
  };
  // Where the line q + t d, seen from the apex, is within x^2 + y^2 = slope^2 z^2 below the apex.
  [[nodiscard]] Inside within_endless(const Vec3& q, const Vec3& d) const {
    const Real slope = radius_ / (2 * half_height_), steep = slope * slope;
    const Real a = d.x * d.x + d.y * d.y - steep * d.z * d.z;
    const Real b = q.x * d.x + q.y * d.y - steep * q.z * d.z;
    const Real c = q.x * q.x + q.y * q.y - steep * q.z * q.z;
    const Real under = b * b - a * c;
    if (a > 0 && under < 0) {
      return {infinity, -infinity};
    }
    // The root without cancellation first, the other one from the product of both.
    const Real sum = -(b + std::copysign(std::sqrt(std::max(under, Real{0})), b));
    const Real one = a != 0 ? sum / a : infinity, other = sum != 0 ? c / sum : 0;
    const Real low = std::min(one, other), high = std::max(one, other);
    if (a > 0) {
      return {low, high};
    }
    if (a == 0 && b == 0) {
      return c <= 0 ? Inside{-infinity, infinity} : Inside{infinity, -infinity};
    }
    // Steeper than the side the line runs through both cones, and ends in the lower one.
    if (a == 0) {
      return b > 0 ? Inside{-infinity, other} : Inside{other, infinity};
    }
    return d.z < 0 ? Inside{high, infinity} : Inside{-infinity, low};
  }

  // Without height, both sides of the disc.
  [[nodiscard]] std::optional<RayHit> cast_ray_at_disc(const Vec3& origin, const Vec3& d, Real max_distance) const {
    const Real distance = -origin.z / d.z;
    if (!(distance >= 0 && distance <= max_distance) ||
        std::hypot(origin.x + distance * d.x, origin.y + distance * d.y) > radius_) {
      return std::nullopt;
    }
    const bool from_above = d.z < 0;
    return RayHit{distance, {0, 0, from_above ? 1.0 : -1.0}, {FeatureKind::face, from_above ? 1u : 0u}};
  }

  Cone(Real radius, Real half_height) : radius_(radius), half_height_(half_height) {}
  Real radius_;
  Real half_height_;
};
static_assert(Shape<Cone> && Curved<Cone> && Field<Cone>);

}  // namespace abut
