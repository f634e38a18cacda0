// SPDX-License-Identifier: Apache-2.0
// Solid cylinder along local Z with flat ends, centred.
export module abut.shapes.cylinder;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;

export namespace abut {

class Cylinder {
 public:
  static constexpr std::string_view name = "cylinder";
  static constexpr std::array<std::string_view, 2> parameter_names{"radius", "half_height"};
  static constexpr bool is_curved = true;

  [[nodiscard]] static Result<Cylinder> make(std::span<const Real> parameters, std::span<const Real> reals,
                                             std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    return Cylinder(parameters[0], parameters[1]);
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {radius_, half_height_}; }
  [[nodiscard]] static std::vector<Cylinder> samples() {
    return {Cylinder(0.5, 1), Cylinder(1, 0.1), Cylinder(1e-3, 10), Cylinder(20, 30), Cylinder(1, 0), Cylinder(0, 1)};
  }

  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Vec3 &x = pose.rotation.x, &y = pose.rotation.y;
    const Vec3 across{std::hypot(x.x, y.x), std::hypot(x.y, y.y), std::hypot(x.z, y.z)};
    return Aabb::around(pose.position, half_height_ * absolute(pose.rotation.z) + radius_ * across);
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return std::max(radius_, half_height_); }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const {
    const Sideways side = sideways_of(direction);
    return {{radius_ * side.x, radius_ * side.y, std::copysign(half_height_, direction.z)}, no_index};
  }

  // A disc and a segment, added up.
  [[nodiscard]] inline SecondOrder second_order(const DirectionFrame& frame) const {
    const Sideways side = sideways_of(frame.n);
    const Real z = std::copysign(half_height_, frame.n.z);
    const bool is_flat = side.length < flat_sine;
    SecondOrder near =
        second_order_of_point(in_frame(frame, is_flat ? Vec3{0, 0, z} : Vec3{radius_ * side.x, radius_ * side.y, z}));
    if (is_flat) {
      near.disc = radius_;
      return near;
    }
    bend_by_disc(frame, {side.x, side.y, side.length}, radius_, near);
    if (half_height_ > 0) {
      near.edges[0] = in_frame(frame, {0, 0, -2 * z});
      near.edge_count = 1;
    }
    return near;
  }

  [[nodiscard]] inline Discs discs() const { return {half_height_, radius_, radius_}; }
  [[nodiscard]] inline InnerBalls inner_balls() const {
    const Real ball = radius_ < half_height_ ? radius_ : half_height_;
    return {{0, 0, 0}, {0, 0, half_height_ - ball}, ball};
  }

  // In the half-plane through the axis and the point: a rectangle.
  [[nodiscard]] [[gnu::always_inline]] inline SurfacePoint nearest(const Vec3& p) const {
    const Sideways side = sideways_of(p);
    const Real z = std::copysign(Real{1}, p.z), beside = side.length - radius_, above = std::fabs(p.z) - half_height_;
    if (above > beside && beside <= 0) {
      return {{p.x, p.y, z * half_height_}, {0, 0, z}, above};
    }
    if (above <= 0) {
      return {{radius_ * side.x, radius_ * side.y, p.z}, {side.x, side.y, 0}, beside};
    }
    const Real distance = norm({beside, above, 0});
    return {{radius_ * side.x, radius_ * side.y, z * half_height_},
            {side.x * (beside / distance), side.y * (beside / distance), z * (above / distance)},
            distance};
  }
  // Whether a point is further from the cylinder than `reach`; near its edges it need not be told.
  [[nodiscard]] [[gnu::always_inline]] inline bool is_beyond(const Vec3& p, Real reach) const {
    const Real wide = radius_ + reach, slack = 1 + rounding_of(1);
    return reach >= 0 &&
           (std::fabs(p.z) > slack * (half_height_ + reach) || p.x * p.x + p.y * p.y > slack * (wide * wide));
  }

  // Whether no point lies as far as `reach` along a direction; where rounding matters it need not be told.
  [[nodiscard]] [[gnu::always_inline]] inline bool is_short_of(const Vec3& d, Real reach) const {
    const Real left = reach - half_height_ * std::fabs(d.z) - rounding_of(std::fabs(reach) + half_height_);
    return left > 0 && left * left > (1 + rounding_of(1)) * (radius_ * radius_) * (d.x * d.x + d.y * d.y);
  }

  // Faces 0 and 1 are the top and the bottom, corners and edges below 32 their rims. Seen from the side a
  // cylinder is the edge 32 along it.
  [[nodiscard]] inline std::optional<Rim> supporting_rim(const Vec3& direction) const {
    if (!(radius_ > 0 && (std::fabs(direction.z) >= sideways_of(direction).length || half_height_ == 0))) {
      return std::nullopt;
    }
    const bool is_up = direction.z >= 0;
    return Rim{radius_, is_up ? half_height_ : -half_height_, is_up, is_up ? 0u : 1u, is_up ? 0u : rim_corners};
  }
  [[nodiscard]] Face supporting_face(const Vec3& direction) const {
    if (const std::optional<Rim> rim = supporting_rim(direction)) {
      return rim_face(*rim);
    }
    const Sideways side = sideways_of(direction);
    [[clang::uninitialized]] Face face;
    face.vertices.push_back({{radius_ * side.x, radius_ * side.y, -half_height_}, side_number, side_number});
    if (half_height_ > 0) {
      face.vertices.push_back({{radius_ * side.x, radius_ * side.y, half_height_}, side_number + 1, side_number});
    }
    return face;
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3& direction) const {
    if (const std::optional<Rim> rim = supporting_rim(direction)) {
      return {FeatureKind::face, rim->index};
    }
    return {half_height_ > 0 ? FeatureKind::edge : FeatureKind::vertex, side_number};
  }

  // The stretch of the ray between the planes of both ends and within the endless cylinder.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    const Vec3 d = direction;
    const Real across = d.x * d.x + d.y * d.y;
    const Real along = across > 0 ? -(origin.x * d.x + origin.y * d.y) / across : 0;
    const Real x = origin.x + along * d.x, y = origin.y + along * d.y;
    const Real under = radius_ * radius_ - (x * x + y * y);
    if (under < 0 || (d.z == 0 && std::fabs(origin.z) > half_height_)) {
      return std::nullopt;
    }
    const Real half_chord = across > 0 ? std::sqrt(under / across) : infinity;
    const Real low = d.z != 0 ? (-half_height_ - origin.z) / d.z : -infinity;
    const Real high = d.z != 0 ? (half_height_ - origin.z) / d.z : infinity;
    const Real enter = std::max(std::min(low, high), along - half_chord);
    const Real leave = std::min(std::max(low, high), along + half_chord);
    const Real distance = enter >= 0 ? enter : leave;
    if (!(enter <= leave) || !(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    if (distance == low || distance == high) {
      const bool top = enter >= 0 ? d.z < 0 : d.z > 0;
      return RayHit{distance, {0, 0, top ? 1.0 : -1.0}, {FeatureKind::face, top ? 0u : 1u}};
    }
    const Sideways out = sideways_of(origin + distance * d);
    return RayHit{distance, {out.x, out.y, 0}, {FeatureKind::face, 2}};
  }

 private:
  static constexpr std::uint32_t side_number = 2 * rim_corners;

  Cylinder(Real radius, Real half_height) : radius_(radius), half_height_(half_height) {}
  Real radius_;
  Real half_height_;
};
static_assert(Shape<Cylinder> && Curved<Cylinder> && Field<Cylinder>);

}  // namespace abut
