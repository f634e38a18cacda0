// SPDX-License-Identifier: Apache-2.0
// The rims of cylinders and cones for clipping: regular polygons that turn with the shape, so that their
// corners keep their numbers while it moves.
export module abut.capability.cores.rim;
import abut.capability.records;
import abut.core.standard;
import abut.math;

export namespace abut {

inline constexpr std::uint32_t rim_corners = 16;

// Cosine of an angle in parts of a full turn.
[[nodiscard]] inline constexpr Real rim_cosine(std::uint32_t corner) {
  constexpr Real high = 0.92387953251128675613, even = 0.70710678118654752440, low = 0.38268343236508977173;
  constexpr std::array<Real, rim_corners> turn{1,  high,  even,  low,  0, -low, -even, -high,
                                               -1, -high, -even, -low, 0, low,  even,  high};
  return turn[corner % rim_corners];
}

// Two discs around Z, at this height and below the origin by as much: their radii.
struct Discs {
  Real half_height, top, bottom;
};

// The disc of a radius at a height along Z, facing up or down, as a face of the given number. Its corners and edges are
// numbered from `first` on.
struct Rim {
  Real radius, height;
  bool is_up;
  std::uint32_t index, first;
};
// A rim that leans less than this rests on its face: where it is deepest says little, as that runs around the rim
// faster than the inverse of the lean. A rim that leans more stands on its edge.
inline constexpr Real resting_sine = 1e-3;
// What a rim touches with where it is deepest and none of its corners is: on its face no feature of its own, else the
// edge named after the first one. `across_square`: of the part of a unit normal across the axis.
[[nodiscard]] [[gnu::always_inline]] inline Feature feature_where_deepest(std::uint32_t first_edge,
                                                                          Real across_square) {
  return across_square < resting_sine * resting_sine ? Feature{FeatureKind::whole, 0}
                                                     : Feature{FeatureKind::edge, first_edge};
}

// As a polygon.
[[nodiscard]] inline Face rim_face(const Rim& rim) {
  [[clang::uninitialized]] Face face;
  face.normal = {0, 0, rim.is_up ? 1.0 : -1.0};
  face.index = rim.index;
  for (std::uint32_t i = 0; i < rim_corners; ++i) {
    const std::uint32_t corner = rim.is_up ? i : rim_corners - 1 - i;
    const std::uint32_t edge = rim.is_up ? corner : (corner + rim_corners - 1) % rim_corners;
    const Vec3 point{rim.radius * rim_cosine(corner), rim.radius * rim_cosine(corner + 12), rim.height};
    face.vertices.push_back({point, rim.first + corner, rim.first + edge});
  }
  return face;
}

// The part of a direction across Z, of length one; X where there is none.
struct Sideways {
  Real x, y, length;
};
[[nodiscard]] inline Sideways sideways_of(const Vec3& direction) {
  Real length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
  if (!(length > 1e-140)) [[unlikely]] {
    length = std::hypot(direction.x, direction.y);  // squares of tiny numbers vanish
    if (!(length > 0)) {
      return {1, 0, 0};
    }
    const Real scale = std::fmax(std::fabs(direction.x), std::fabs(direction.y));
    const Real x = direction.x / scale, y = direction.y / scale, unit = 1 / std::sqrt(x * x + y * y);
    return {unit * x, unit * y, length};
  }
  const Real inverse = 1 / length;
  return {inverse * direction.x, inverse * direction.y, length};
}

}  // namespace abut
