// SPDX-License-Identifier: Apache-2.0
// Places of a convex shape by which it is told to be in a solid, and how deep.
export module abut.narrow.parts.places_of_body;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

struct BallInside {
  Vec3 centre;
  Real radius;
};
// A ball in a convex shape, in its frame.
template <Convex B>
[[nodiscard]] BallInside ball_inside(const B& b) {
  if constexpr (BoxCored<B>) {
    const Vec3 half = b.half();
    return {{0, 0, 0}, b.radius() + std::min(std::min(half.x, half.y), half.z)};
  } else if constexpr (Field<B>) {
    return {b.centre(), b.radius() + std::max(-b.nearest(b.centre()).distance, Real{0})};
  } else if constexpr (Faceted<B>) {
    const auto& facets = b.facets();
    return facets.inner > 0 ? BallInside{facets.middle, b.radius() + facets.inner} : BallInside{b.centre(), b.radius()};
  } else {
    return {b.centre(), b.radius()};
  }
}

// The corners of a convex shape that has no inside; none of any other.
template <Convex B>
[[nodiscard]] SmallVector<Vec3, 8> corners_of_thin(const B& b, const Pose& at) {
  SmallVector<Vec3, 8> corners;
  if constexpr (requires { b.corners(); }) {
    for (const Vec3& corner : b.corners()) {
      corners.push_back(at * corner);
    }
  } else if constexpr (BoxCored<B>) {
    const Vec3 half = b.half();
    if (b.radius() + std::min(std::min(half.x, half.y), half.z) <= 0) {
      for (const Real x : {-half.x, half.x}) {
        for (const Real y : {-half.y, half.y}) {
          for (const Real z : {-half.z, half.z}) {
            const Vec3 corner = at * Vec3{x, y, z};
            if (std::ranges::find(corners.span(), corner) == corners.span().end()) {
              corners.push_back(corner);
            }
          }
        }
      }
    }
  }
  return corners;
}

}  // namespace abut
