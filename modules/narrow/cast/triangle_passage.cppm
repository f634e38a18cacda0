// SPDX-License-Identifier: Apache-2.0
// When two triangles first touch of which one moves without turning: on each separating axis they overlap in a stretch
// of the way, and touch in what all stretches have in common (Gottschalk et al., "OBBTree", 1996).
export module abut.narrow.cast.triangle_passage;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;

export namespace abut {

// They do not touch before `enter`. The normal leads from the one that stands still to the other, and has any length.
struct TrianglePassage {
  Real enter;
  Vec3 normal;
};

class TrianglePassageSearch {
 public:
  // b moves along a direction. Up to `slack` apart they touch.
  TrianglePassageSearch(const TriangleCorners& a, const TriangleCorners& b, const Vec3& direction, Real limit,
                        Real slack)
      : direction_(direction), limit_(limit) {
    Real size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      a_[i] = a[i] - a[0];
      b_[i] = b[i] - a[0];
      size = std::max(size, std::max(largest_magnitude(a_[i]), largest_magnitude(b_[i])));
    }
    slack_ = slack + noise_of(size);
  }

  // Nothing where they do not touch before the limit. An axis that is rounding rules nothing out wrongly.
  [[nodiscard]] std::optional<TrianglePassage> find() {
    const std::array<Vec3, 3> of_a = edges_of(a_), of_b = edges_of(b_);
    const Vec3 normal_a = cross(of_a[0], of_a[1]), normal_b = cross(of_b[0], of_b[1]);
    if (!narrow(normal_a) || !narrow(normal_b)) {
      return std::nullopt;
    }
    for (const Vec3& edge : of_a) {
      for (const Vec3& other : of_b) {
        if (!narrow(cross(edge, other))) {
          return std::nullopt;
        }
      }
      if (!narrow(cross(normal_a, edge))) {
        return std::nullopt;
      }
    }
    for (const Vec3& edge : of_b) {
      if (!narrow(cross(normal_b, edge))) {
        return std::nullopt;
      }
    }
    return found_;
  }

 private:
  [[nodiscard]] static std::array<Vec3, 3> edges_of(const TriangleCorners& corners) {
    return {corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  }
  // Whether a stretch is left.
  [[nodiscard]] bool narrow(const Vec3& axis) {
    const Real speed = dot(axis, direction_);
    const Real slack = slack_ * (std::fabs(axis.x) + std::fabs(axis.y) + std::fabs(axis.z));
    const Real before = least_along(b_, axis) + least_along(a_, -axis) - slack;  // b lies this far ahead of a
    const Real behind = least_along(a_, axis) + least_along(b_, -axis) - slack;
    if (speed == 0) {
      return before <= 0 && behind <= 0;
    }
    const Real enter = (speed < 0 ? before : behind) / std::fabs(speed);
    const Real leave = -(speed < 0 ? behind : before) / std::fabs(speed);
    if (enter > found_.enter) {
      found_ = {enter, speed < 0 ? axis : -axis};
    }
    leave_ = std::min(leave_, leave);
    return found_.enter <= leave_ && found_.enter <= limit_;
  }

  Vec3 direction_;
  Real limit_;
  TriangleCorners a_, b_;
  Real slack_;
  TrianglePassage found_{0, {0, 0, 0}};
  Real leave_ = infinity;
};

[[nodiscard]] inline std::optional<TrianglePassage> passage_of_triangles(const TriangleCorners& a,
                                                                         const TriangleCorners& b,
                                                                         const Vec3& direction, Real limit,
                                                                         Real slack) {
  return TrianglePassageSearch(a, b, direction, limit, slack).find();
}

}  // namespace abut
