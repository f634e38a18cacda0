// SPDX-License-Identifier: Apache-2.0
// Solid box, centred, by half extents. Vertex i has the sign bits of i (bit 0: x positive, ...).
export module abut.shapes.box;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;

namespace abut {

[[nodiscard]] constexpr std::uint32_t edge_number_of_cube(std::uint32_t axis, std::uint32_t bits) {
  const std::uint32_t others = axis == 0 ? bits >> 1 : axis == 1 ? (bits & 1u) | ((bits >> 1) & 2u) : bits & 3u;
  return 4 * axis + others;
}
// A side of a cube of half extents 1 by its numbers. An edge is numbered by its direction and the octant bits of the
// two other axes: 4 * axis + bits.
struct SideOfCube {
  std::array<std::uint32_t, 4> vertices, edges;
};
[[nodiscard]] constexpr SideOfCube side_of_cube(std::uint32_t axis, bool positive) {
  SideOfCube side{};
  const std::uint32_t first = axis == 0 ? 1 : axis == 1 ? 2 : 0;   // the axes of the face, such that
  const std::uint32_t second = axis == 0 ? 2 : axis == 1 ? 0 : 1;  // first x second = axis
  const std::uint32_t base = positive ? 1u << axis : 0u;
  for (std::uint32_t step = 0; step < 4; ++step) {
    const std::uint32_t turn = positive ? step : 3 - step;
    const std::uint32_t bits = base | (turn == 1 || turn == 2 ? 1u << first : 0u) | (turn >= 2 ? 1u << second : 0u);
    const std::uint32_t next = positive ? (turn + 1) % 4 : (turn + 3) % 4;
    const bool along_first = turn / 2 == next / 2 && (turn + next == 1 || turn + next == 5);
    side.vertices[step] = bits;
    side.edges[step] = edge_number_of_cube(along_first ? first : second, bits);
  }
  return side;
}
// -x, +x, -y, +y, -z, +z.
inline constexpr std::array<SideOfCube, 6> sides_of_cube{side_of_cube(0, false), side_of_cube(0, true),
                                                         side_of_cube(1, false), side_of_cube(1, true),
                                                         side_of_cube(2, false), side_of_cube(2, true)};
// The corners of the sides, one per lane.
[[nodiscard]] constexpr Lanes signs_along(std::uint32_t axis, const SideOfCube& side) {
  const auto sign = [&](std::size_t i) { return (side.vertices[i] >> axis & 1u) != 0 ? Real{1} : Real{-1}; };
  return {sign(0), sign(1), sign(2), sign(3)};
}
[[nodiscard]] constexpr Columns corners_of_side(const SideOfCube& side) {
  return {signs_along(0, side), signs_along(1, side), signs_along(2, side)};
}
inline constexpr std::array<Columns, 6> corners_of_cube{
    corners_of_side(sides_of_cube[0]), corners_of_side(sides_of_cube[1]), corners_of_side(sides_of_cube[2]),
    corners_of_side(sides_of_cube[3]), corners_of_side(sides_of_cube[4]), corners_of_side(sides_of_cube[5])};

}  // namespace abut

export namespace abut {

class Box {
 public:
  static constexpr std::string_view name = "box";
  static constexpr std::array<std::string_view, 3> parameter_names{"half_x", "half_y", "half_z"};
  static constexpr bool is_symmetric = true;
  static constexpr int core_axes = 3;

  [[nodiscard]] static Result<Box> make(std::span<const Real> parameters, std::span<const Real> reals,
                                        std::span<const std::uint32_t> indices) {
    if (Fault fault = check_lengths(parameter_names, parameters, reals, indices)) {
      return *fault;
    }
    return Box({parameters[0], parameters[1], parameters[2]});
  }
  [[nodiscard]] std::vector<Real> parameters() const { return {half_.x, half_.y, half_.z}; }
  [[nodiscard]] static std::vector<Box> samples() {
    return {Box({1, 1, 1}), Box({0.5, 1, 2}), Box({1, 1, 0}), Box({1e-3, 1e-3, 10}), Box({30, 20, 10}), Box({0, 0, 0})};
  }

  [[nodiscard]] inline const Vec3& half() const [[clang::lifetimebound]] { return half_; }
  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Rotation& r = pose.rotation;
    return Aabb::around(pose.position, half_.x * absolute(r.x) + half_.y * absolute(r.y) + half_.z * absolute(r.z));
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return {0, 0, 0}; }
  [[nodiscard]] inline Real extent() const { return largest_magnitude(half_); }
  [[nodiscard]] inline SupportPoint support(const Vec3& d) const {
    return {{std::copysign(half_.x, d.x), std::copysign(half_.y, d.y), std::copysign(half_.z, d.z)},
            octant(d.x, d.y, d.z)};
  }

  // From outside every coordinate is clamped; from inside the nearest face counts.
  [[nodiscard]] [[gnu::always_inline]] inline SurfacePoint nearest(const Vec3& p) const {
    const Vec3 clamped = minimum(maximum(p, -half_), half_), out = p - clamped;
    const Real square = squared_norm(out);
    if (square > 1e-280) [[likely]] {
      const Real distance = std::sqrt(square);
      return {clamped, (1 / distance) * out, distance};
    }
    return nearest_within(p, clamped);
  }
  // Whether a point is further from the box than `reach`, which leaves room for rounding.
  [[nodiscard]] [[gnu::always_inline]] inline bool is_beyond(const Vec3& p, Real reach) const {
    return squared_norm(p - minimum(maximum(p, -half_), half_)) > reach * std::fabs(reach) && reach >= 0;
  }

  [[nodiscard]] inline std::uint32_t corner_count() const { return 8; }
  [[nodiscard]] inline Vec3 corner(std::uint32_t index) const { return vertex(index); }
  [[nodiscard]] inline Real reach(const Vec3& d) const {
    return half_.x * std::fabs(d.x) + half_.y * std::fabs(d.y) + half_.z * std::fabs(d.z);
  }

  // The box as centre + sum of three signed half edges: a support point costs three dot products.
  struct Placed {
    Vec3 centre, x, y, z;
    [[nodiscard]] inline SupportPoint support(const Vec3& d) const {
      const Real dx = dot(x, d), dy = dot(y, d), dz = dot(z, d);
      return {centre + std::copysign(Real{1}, dx) * x + std::copysign(Real{1}, dy) * y + std::copysign(Real{1}, dz) * z,
              octant(dx, dy, dz)};
    }
    [[nodiscard]] inline Real reach(const Vec3& d) const {
      return std::fabs(dot(x, d)) + std::fabs(dot(y, d)) + std::fabs(dot(z, d));
    }
  };
  [[nodiscard]] inline Placed placed(const Pose& pose) const {
    return {pose.position, half_.x * pose.rotation.x, half_.y * pose.rotation.y, half_.z * pose.rotation.z};
  }

  [[nodiscard]] Face supporting_face(const Vec3& d) const {
    const int axis = longest_axis(d);
    const bool is_positive = d[axis] >= 0;
    if (half_.x > 0 && half_.y > 0 && half_.z > 0) [[likely]] {
      return side_of(axis, is_positive);  // a face is large: no copy is made of it
    }
    const bool flat_first = half_[axis == 0   ? 1
                                  : axis == 1 ? 2
                                              : 0] == 0,
               flat_second = half_[axis == 0   ? 2
                                   : axis == 1 ? 0
                                               : 1] == 0;
    return flat_first || flat_second ? without_area(side_of(axis, is_positive), flat_first, flat_second)
                                     : side_of(axis, is_positive);
  }
  [[nodiscard]] inline FewCorners few_corners(const Vec3& d) const {
    const int axis = longest_axis(d);
    const bool is_positive = d[axis] >= 0;
    const auto number = static_cast<std::uint32_t>(2 * axis + (is_positive ? 1 : 0));
    const SideOfCube& side = sides_of_cube[number];
    const auto& [x, y, z] = corners_of_cube[number];
    const bool has_area = half_.x > 0 && half_.y > 0 && half_.z > 0;
    return {{x * half_.x, y * half_.y, z * half_.z},
            has_area ? normal_of_side(axis, is_positive) : Vec3{0, 0, 0},
            number,
            side.vertices,
            side.edges};
  }
  [[nodiscard]] inline Feature supporting_feature(const Vec3& d) const {
    if (half_.x > 0 && half_.y > 0 && half_.z > 0) [[likely]] {
      const int axis = longest_axis(d);
      return {FeatureKind::face, static_cast<std::uint32_t>(2 * axis + (d[axis] >= 0 ? 1 : 0))};
    }
    return feature_of(supporting_face(d));
  }
  [[nodiscard]] inline std::array<Vec3, 3> face_normals() const {
    return {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  }
  [[nodiscard]] inline std::array<Vec3, 3> edge_directions() const { return face_normals(); }

  // Slabs (Kay and Kajiya 1986). A ray that starts inside meets the far side.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction, Real max_distance) const {
    Real enter = -infinity, leave = infinity;
    int enter_axis = 0, leave_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Real d = direction.vec()[axis], o = origin[axis], h = half_[axis];
      if (d == 0) {
        if (std::fabs(o) > h) {
          return std::nullopt;
        }
        continue;
      }
      const Real near = (std::copysign(h, -d) - o) / d, far = (std::copysign(h, d) - o) / d;
      if (near > enter) {
        enter = near;
        enter_axis = axis;
      }
      if (far < leave) {
        leave = far;
        leave_axis = axis;
      }
    }
    if (!(enter <= leave)) {
      return std::nullopt;
    }
    const bool entering = enter >= 0;
    const Real distance = entering ? enter : leave;
    if (!(distance >= 0 && distance <= max_distance)) {
      return std::nullopt;
    }
    const int axis = entering ? enter_axis : leave_axis;
    const bool positive = (direction.vec()[axis] > 0) != entering;
    const Real sign = positive ? 1 : -1;
    const Vec3 normal{axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
    return RayHit{distance, normal, {FeatureKind::face, static_cast<std::uint32_t>(2 * axis + (positive ? 1 : 0))}};
  }

  // Two triangles per face; triangle 2 f and 2 f + 1 belong to face f.
  [[nodiscard]] Triangles triangles() const {
    Triangles out;
    for (std::uint32_t bits = 0; bits < 8; ++bits) {
      out.vertices.push_back(vertex(bits));
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (const Real sign : {-1.0, 1.0}) {
        const Face face = side_of(axis, sign > 0);
        for (const std::size_t corner : std::to_array<std::size_t>({0, 1, 2, 0, 2, 3})) {
          out.indices.push_back(face.vertices[corner].vertex);
        }
      }
    }
    return out;
  }

 private:
  explicit Box(const Vec3& half) : half_(half) {}

  // From a point inside, or so near that squares vanish.
  [[nodiscard]] [[gnu::noinline]] SurfacePoint nearest_within(const Vec3& p, const Vec3& clamped) const {
    const Vec3 out = p - clamped;
    if (const auto normal = UnitVec3::make(out)) {
      return {clamped, *normal, norm(out)};
    }
    const Vec3 below = half_ - absolute(p);
    const int axis = below.x <= below.y && below.x <= below.z ? 0 : below.y <= below.z ? 1 : 2;
    const Vec3 normal{axis == 0 ? std::copysign(1.0, p.x) : 0, axis == 1 ? std::copysign(1.0, p.y) : 0,
                      axis == 2 ? std::copysign(1.0, p.z) : 0};
    return {p + below[axis] * normal, normal, -below[axis]};
  }

  [[nodiscard]] static inline Vec3 normal_of_side(int axis, bool positive) {
    const Real sign = positive ? 1 : -1;
    return {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
  }
  // All four corners of a side, also where they coincide.
  [[nodiscard]] inline Face side_of(int axis, bool positive) const {
    [[clang::uninitialized]] Face face;
    face.index = static_cast<std::uint32_t>(2 * axis + (positive ? 1 : 0));
    face.normal = normal_of_side(axis, positive);
    const SideOfCube& side = sides_of_cube[face.index];
    for (std::size_t step = 0; step < 4; ++step) {
      face.vertices.push_back({vertex(side.vertices[step]), side.vertices[step], side.edges[step]});
    }
    return face;
  }

  // The side of a flat box is an edge or a vertex. Corners 0 and 2 of a side differ in both of its
  // directions; its edges run along the first direction from corner 0 and along the second from 1.
  [[nodiscard]] static Face without_area(const Face& side, bool flat_first, bool flat_second) {
    [[clang::uninitialized]] Face face;
    const std::uint32_t edge = side.vertices[flat_second ? 0 : 1].edge;
    face.vertices.push_back({side.vertices[0].point, side.vertices[0].vertex, edge});
    if (!(flat_first && flat_second)) {
      face.vertices.push_back({side.vertices[2].point, side.vertices[2].vertex, edge});
    }
    return face;
  }

  [[nodiscard]] static inline std::uint32_t octant(Real x, Real y, Real z) {
    return (std::signbit(x) ? 0u : 1u) | (std::signbit(y) ? 0u : 2u) | (std::signbit(z) ? 0u : 4u);
  }
  [[nodiscard]] inline Vec3 vertex(std::uint32_t bits) const {
    return {bits & 1u ? half_.x : -half_.x, bits & 2u ? half_.y : -half_.y, bits & 4u ? half_.z : -half_.z};
  }

  Vec3 half_;
};
static_assert(Shape<Box> && FewCornered<Box> && Placeable<Box> && BoxCored<Box> && Field<Box> && FewFaced<Box> &&
              Triangulated<Box>);

}  // namespace abut
