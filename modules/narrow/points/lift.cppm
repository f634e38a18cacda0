// SPDX-License-Identifier: Apache-2.0
// Faces seen along a normal: points of them in the plane across it, and back from there onto a face.
export module abut.narrow.points.lift;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;

export namespace abut {

// Projection along the normal onto its tangents, about a base point that keeps coordinates small.
struct Projection {
  Vec3 base;
  Tangents tangents;
  Vec3 normal;
  Real tie;  // places that are nearer to each other are the same one

  [[nodiscard]] inline Vec2 operator()(const Vec3& p) const {
    const Vec3 d = p - base;
    return {dot(d, tangents.first), dot(d, tangents.second)};
  }
};

// A face whose normal is further than this from the contact normal is met at an edge or a vertex.
inline constexpr Real steepest_cosine = 0.05;

// Within which places of two faces tie: beside rounding of both, by the size of the smaller one. Sizes are from a
// corner of each.
[[nodiscard]] inline Real tie_of_sizes(Real size_a, Real size_b, const Vec3& corner_a, const Vec3& corner_b) {
  const Real reach = std::fmax(size_a, largest_magnitude(corner_b - corner_a) + size_b) + largest_magnitude(corner_a);
  return rounding_of(reach) + tie_share * std::fmin(size_a, size_b);
}

// Lifts projected points onto a polygon: onto its plane, or, where that misses the corners, onto chords between its
// edges. The plane of a sliver is rounding along the short way, and that of a merged face is a mean.
class Lift {
 public:
  Lift(const Face& face, const Projection& projection) {
    const Real along = dot(face.normal, projection.normal);
    slope_u_ = -dot(face.normal, projection.tangents.first) / along;
    slope_v_ = -dot(face.normal, projection.tangents.second) / along;
    for (const FaceVertex& vertex : face.vertices.span()) {
      const Vec3 d = vertex.point - projection.base;
      corners_.push_back(
          {{dot(d, projection.tangents.first), dot(d, projection.tangents.second)}, dot(d, projection.normal)});
    }
    height_ = corners_[0].height - slope_u_ * corners_[0].at.x - slope_v_ * corners_[0].at.y;
    for (const Corner& corner : corners_.span()) {
      is_plane_ = is_plane_ && std::fabs(height_on_plane(corner.at) - corner.height) <= projection.tie;
    }
  }
  [[nodiscard]] inline Vec3 operator()(const Vec2& p, const Projection& projection) const {
    const Real height = is_plane_ ? height_on_plane(p) : height_on_chord(p);
    return projection.base + p.x * projection.tangents.first + p.y * projection.tangents.second +
           height * projection.normal;
  }

 private:
  struct Corner {
    Vec2 at;
    Real height;
  };
  [[nodiscard]] inline Real height_on_plane(const Vec2& p) const { return height_ + slope_u_ * p.x + slope_v_ * p.y; }

  // On the chord across the longest edge.
  [[nodiscard]] [[gnu::noinline]] Real height_on_chord(const Vec2& p) const {
    const std::span<const Corner> corners = corners_.span();
    const auto next = [&](std::size_t i) { return i + 1 < corners.size() ? i + 1 : 0; };
    Vec2 edge{0, 0};
    Real nearest = infinity, height = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 along = corners[next(i)].at - corners[i].at, way = corners[i].at - p;
      edge = dot(along, along) > dot(edge, edge) ? along : edge;
      height = dot(way, way) < nearest ? corners[i].height : height;
      nearest = std::min(nearest, dot(way, way));
    }
    Real low = infinity, high = -infinity, height_low = 0, height_high = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &from = corners[i], &to = corners[next(i)];
      const Real start = dot(edge, from.at - p), end = dot(edge, to.at - p);
      if ((start <= 0) == (end <= 0)) {
        continue;
      }
      const Real t = start / (start - end), at = cross(edge, mix(from.at, to.at, t) - p),
                 here = from.height + t * (to.height - from.height);
      height_low = at < low ? here : height_low;
      height_high = at > high ? here : height_high;
      low = std::min(low, at);
      high = std::max(high, at);
    }
    if (!(low <= high)) {
      return height;  // beyond the ends: that of the nearest corner
    }
    const Real share = high > low ? std::clamp(-low / (high - low), Real{0}, Real{1}) : 0.5;
    return height_low + share * (height_high - height_low);
  }

  SmallVector<Corner, 16> corners_;
  Real height_ = 0, slope_u_ = 0, slope_v_ = 0;
  bool is_plane_ = true;
};

}  // namespace abut
