// SPDX-License-Identifier: Apache-2.0
// A triangle: the part that meshes and height fields are made of, and the core of a triangle by itself. Not a solid: it
// has two sides unless it is told to be one-sided.
export module abut.capability.parts.part_triangle;
import abut.capability.concepts;
import abut.capability.records;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

using TriangleCorners = std::array<Vec3, 3>;

[[nodiscard]] inline Aabb box_around(const TriangleCorners& corners) {
  return {minimum(minimum(corners[0], corners[1]), corners[2]), maximum(maximum(corners[0], corners[1]), corners[2])};
}

[[nodiscard]] inline SupportPoint support_of(const TriangleCorners& corners, const Vec3& direction) {
  const Real a = dot(corners[0], direction), b = dot(corners[1], direction), c = dot(corners[2], direction);
  if (a >= b && a >= c) {
    return {corners[0], 0};
  }
  return b >= c ? SupportPoint{corners[1], 1} : SupportPoint{corners[2], 2};
}

// Of their lowest point along a direction.
[[nodiscard]] inline Real least_along(const TriangleCorners& corners, const Vec3& direction) {
  return std::min(std::min(dot(direction, corners[0]), dot(direction, corners[1])), dot(direction, corners[2]));
}

// A ray that is asked for its distance to triangles. Woop, Benthin, Wald, "Watertight ray/triangle intersection", 2013:
// seen along the ray, the side of an edge is the same number, but for its sign, for both triangles that share it. So no
// ray slips between them.
class TriangleRay {
 public:
  inline TriangleRay(const Vec3& origin, const UnitVec3& direction) : origin_(origin) {
    const Vec3 d = direction, wide = absolute(d);
    kz_ = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
    kx_ = kz_ == 2 ? 0 : kz_ + 1;
    ky_ = kx_ == 2 ? 0 : kx_ + 1;
    scale_ = 1 / d[kz_];
    slope_x_ = d[kx_] * scale_;
    slope_y_ = d[ky_] * scale_;
  }

  [[nodiscard]] inline std::optional<Real> distance_to(const TriangleCorners& corners, Real max_distance) const {
    const Seen a = seen(corners[0]), b = seen(corners[1]), c = seen(corners[2]);
    const Real at_a = c.x * b.y - c.y * b.x, at_b = a.x * c.y - a.y * c.x, at_c = b.x * a.y - b.y * a.x;
    const Real determinant = at_a + at_b + at_c;
    if (determinant == 0 || ((at_a < 0 || at_b < 0 || at_c < 0) && (at_a > 0 || at_b > 0 || at_c > 0))) {
      return std::nullopt;
    }
    const Real distance = (at_a * a.depth + at_b * b.depth + at_c * c.depth) / determinant;
    return distance >= 0 && distance <= max_distance ? std::optional(distance) : std::nullopt;
  }

 private:
  struct Seen {
    Real x, y, depth;
  };
  [[nodiscard]] inline Seen seen(const Vec3& corner) const {
    const Vec3 p = corner - origin_;
    const Real z = p[kz_];
    return {p[kx_] - slope_x_ * z, p[ky_] - slope_y_ * z, scale_ * z};
  }

  Vec3 origin_;
  int kx_, ky_, kz_;
  Real scale_, slope_x_, slope_y_;
};

class Triangle {
 public:
  using Core = Triangle;
  static constexpr bool is_symmetric = false;

  inline Triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t index, bool one_sided)
      : Triangle(TriangleCorners{a, b, c}, index, one_sided) {}
  inline Triangle(const TriangleCorners& corners, std::uint32_t index, bool one_sided)
      : corners_(corners),
        normal_(unit_normal(corners[0], corners[1], corners[2])),
        index_(index),
        one_sided_(one_sided) {}

  [[nodiscard]] inline const TriangleCorners& corners() const [[clang::lifetimebound]] { return corners_; }
  [[nodiscard]] inline const Vec3& normal() const [[clang::lifetimebound]] { return normal_; }  // zero for no area
  [[nodiscard]] inline std::uint32_t index() const { return index_; }
  [[nodiscard]] inline bool is_one_sided() const { return one_sided_; }
  [[nodiscard]] inline bool has_area() const { return squared_norm(normal_) > 0; }

  [[nodiscard]] inline std::uint32_t corner_count() const { return 3; }
  [[nodiscard]] inline Vec3 corner(std::uint32_t index) const { return corners_[index]; }

  [[nodiscard]] inline Aabb box() const { return box_around(corners_); }
  [[nodiscard]] inline Aabb aabb(const Pose& pose) const {
    const Vec3 a = pose * corners_[0], b = pose * corners_[1], c = pose * corners_[2];
    return {minimum(minimum(a, b), c), maximum(maximum(a, b), c)};
  }
  [[nodiscard]] inline Real radius() const { return 0; }
  [[nodiscard]] inline Vec3 centre() const { return (1.0 / 3.0) * (corners_[0] + corners_[1] + corners_[2]); }
  [[nodiscard]] inline Real extent() const {
    return largest_magnitude(maximum(absolute(corners_[1] - corners_[0]), absolute(corners_[2] - corners_[0])));
  }
  [[nodiscard]] inline SupportPoint support(const Vec3& direction) const { return support_of(corners_, direction); }
  [[nodiscard]] inline Face supporting_face(const Vec3& direction) const {
    [[clang::uninitialized]] Face face;
    face.index = 0;
    const bool back = dot(normal_, direction) < 0;
    face.normal = back ? -normal_ : normal_;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t corner = back ? 2 - i : i;
      face.vertices.push_back({corners_[corner], corner, back ? (corner + 2) % 3 : corner});
    }
    return face;
  }
  [[nodiscard]] inline FewCorners few_corners(const Vec3& direction) const {
    const Lanes a = lanes_of(corners_[0]), b = lanes_of(corners_[1]), c = lanes_of(corners_[2]);
    return dot(normal_, direction) < 0 ? FewCorners{Columns::of(c, b, a, a), -normal_, 0, {2, 1, 0, 0}, {1, 0, 2, 2}}
                                       : FewCorners{Columns::of(a, b, c, c), normal_, 0, {0, 1, 2, 2}, {0, 1, 2, 2}};
  }
  [[nodiscard]] inline std::array<Vec3, 1> face_normals() const { return {normal_}; }
  [[nodiscard]] inline std::array<Vec3, 3> edge_directions() const {
    return {corners_[1] - corners_[0], corners_[2] - corners_[1], corners_[0] - corners_[2]};
  }

  // Both sides count.
  [[nodiscard]] inline std::optional<RayHit> cast_ray(const Vec3& origin, const UnitVec3& direction,
                                                      Real max_distance) const {
    const auto distance = TriangleRay(origin, direction).distance_to(corners_, max_distance);
    return distance ? std::optional(RayHit{*distance, normal_, {FeatureKind::face, index_}}) : std::nullopt;
  }

 private:
  [[nodiscard]] static inline Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 n = cross(ab, ac);
    const Real square = squared_norm(n);
    if (square > 1e-200 && square < 1e200 && square > 1e-6 * squared_norm(ab) * squared_norm(ac)) [[likely]] {
      return (1 / std::sqrt(square)) * n;
    }
    return normal_of_needle(ab, c - b, -ac);
  }
  // From the longest edge and the shortest one, which are least parallel. What rounding has left of the normal along
  // the longest edge is taken out, as its length would multiply it; across that edge the triangle is thin.
  [[nodiscard]] static Vec3 normal_of_needle(const Vec3& ab, const Vec3& bc, const Vec3& ca) {
    Vec3 first = ab, second = bc, third = ca;  // in turn, the first one the longest
    for (int turns = 0;
         turns < 2 && (squared_norm(first) < squared_norm(second) || squared_norm(first) < squared_norm(third));
         ++turns) {
      const Vec3 next = second;
      second = third;
      third = first;
      first = next;
    }
    const auto across =
        UnitVec3::make(squared_norm(second) < squared_norm(third) ? cross(first, second) : cross(third, first));
    if (!across) {
      return {0, 0, 0};
    }
    const Vec3 n = *across;
    return UnitVec3::make(n - (dot(n, first) / squared_norm(first)) * first).value_or(*across);
  }

  TriangleCorners corners_;
  Vec3 normal_;
  std::uint32_t index_;
  bool one_sided_;
};
static_assert(FewFaced<Triangle> && FewCornered<Triangle> && RayCastable<Triangle>);

}  // namespace abut
