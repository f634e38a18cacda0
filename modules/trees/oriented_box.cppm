// SPDX-License-Identifier: Apache-2.0
// A box with axes of its own around points, as the nodes of a tree of oriented boxes have one. Gottschalk, Lin and
// Manocha, "OBBTree: a hierarchical structure for rapid interference detection", 1996.
export module abut.trees.oriented_box;
import abut.core.standard;
import abut.math;
import abut.math.principal_axes;
import abut.math.tolerance;

export namespace abut {

class OrientedBox {
 public:
  OrientedBox() = default;
  // Along the principal axes of the points, or along those of the frame where that is smaller.
  [[nodiscard]] static inline OrientedBox around(std::span<const Vec3> points) {
    const PrincipalAxes axes = principal_axes(points);
    const auto spans = [&](const Vec3& direction) {
      Span span{infinity, -infinity};
      for (const Vec3& point : points) {
        span.include(dot(direction, point));
      }
      return span;
    };
    const OrientedBox turned = with({axes.first, axes.second, axes.third}, spans), straight = with(frame_axes, spans);
    return turned.surface() < straight.surface() ? turned : straight;
  }
  // Along the axes of the larger of both.
  [[nodiscard]] static inline OrientedBox around(const OrientedBox& a, const OrientedBox& b) {
    if (a.is_empty() || b.is_empty()) {
      return a.is_empty() ? b : a;
    }
    return with((a.surface() < b.surface() ? b : a).axes_, [&](const Vec3& direction) {
      Span span{infinity, -infinity};
      for (const OrientedBox* box : {&a, &b}) {
        const Real middle = dot(direction, box->centre_), reach = box->reach_along(direction);
        span.include(middle - reach);
        span.include(middle + reach);
      }
      return span;
    });
  }

  [[nodiscard]] bool is_empty() const { return half_.x < 0; }
  // By the axes of both, and by those across two edges.
  [[nodiscard]] inline bool overlaps(const Aabb& box) const {
    if (is_empty()) {
      return false;
    }
    if (!box.is_bounded()) {
      return overlaps_unbounded(box);
    }
    const Vec3 middle = box.centre(), half = 0.5 * (box.high - box.low), between = centre_ - middle;
    const auto is_apart_along = [&](const Vec3& direction) {
      return std::fabs(dot(direction, between)) > reach_along(direction) + dot(absolute(direction), half);
    };
    for (const Vec3& axis : frame_axes) {
      if (is_apart_along(axis)) {
        return false;
      }
    }
    for (const Vec3& axis : axes_) {
      if (is_apart_along(axis)) {
        return false;
      }
    }
    for (const Vec3& own : axes_) {
      for (const Vec3& other : frame_axes) {
        if (is_apart_along(cross(own, other))) {
          return false;
        }
      }
    }
    return true;
  }
  // Of no volume it is without end.
  [[nodiscard]] inline Real lowest_along(const Vec3& direction) const {
    return is_empty() ? infinity : dot(direction, centre_) - reach_along(direction);
  }
  // Where a ray enters, zero inside; without end where it misses.
  [[nodiscard]] inline Real entry_of(const Vec3& origin, const Vec3& direction) const {
    if (is_empty()) {
      return infinity;
    }
    Real enters = 0, leaves = infinity;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3& own = axes_[static_cast<std::size_t>(axis)];
      const Real offset = dot(own, centre_ - origin), speed = dot(own, direction), reach = half_[axis];
      if (speed == 0) {
        leaves = std::fabs(offset) > reach ? -1 : leaves;
        continue;
      }
      const Real first = (offset - reach) / speed, second = (offset + reach) / speed;
      enters = std::max(enters, std::min(first, second));
      leaves = std::min(leaves, std::max(first, second));
    }
    return enters * (1 - 8 * epsilon) <= leaves * (1 + 8 * epsilon) ? enters * (1 - 8 * epsilon) : infinity;
  }
  [[nodiscard]] inline Real distance_to(const Vec3& point) const {
    if (is_empty()) {
      return infinity;
    }
    Real square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Real along = std::fabs(dot(axes_[static_cast<std::size_t>(axis)], point - centre_)) - half_[axis];
      square += along > 0 ? along * along : 0;
    }
    return std::sqrt(square);
  }
  // What the chance of being visited is proportional to.
  [[nodiscard]] Real surface() const {
    return is_empty() ? 0 : half_.x * half_.y + half_.y * half_.z + half_.z * half_.x;
  }
  [[nodiscard]] inline bool holds(const Vec3& point) const {
    return !is_empty() && std::fabs(dot(axes_[0], point - centre_)) <= half_.x &&
           std::fabs(dot(axes_[1], point - centre_)) <= half_.y && std::fabs(dot(axes_[2], point - centre_)) <= half_.z;
  }

 private:
  struct Span {
    Real low, high;
    inline void include(Real value) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  };
  using Axes = std::array<Vec3, 3>;
  static constexpr Axes frame_axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

  // Larger by more than the rounding of what is asked of it.
  template <class Spans>
  [[nodiscard]] static inline OrientedBox with(const Axes& axes, const Spans& spans) {
    OrientedBox box;
    box.axes_ = axes;
    std::array<Real, 3> halves{};
    Real size = 0;
    box.centre_ = {0, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Span span = spans(axes[axis]);
      box.centre_ += 0.5 * (span.low + span.high) * axes[axis];
      halves[axis] = 0.5 * (span.high - span.low);
      size = std::max(size, std::max(std::fabs(span.low), std::fabs(span.high)));
    }
    const Real noise = noise_of(size);
    box.half_ = {halves[0] + noise, halves[1] + noise, halves[2] + noise};
    return box;
  }
  [[nodiscard]] inline Real reach_along(const Vec3& direction) const {
    return half_.x * std::fabs(dot(direction, axes_[0])) + half_.y * std::fabs(dot(direction, axes_[1])) +
           half_.z * std::fabs(dot(direction, axes_[2]));
  }
  [[nodiscard]] inline bool overlaps_unbounded(const Aabb& box) const {
    const Vec3 reach{reach_along(frame_axes[0]), reach_along(frame_axes[1]), reach_along(frame_axes[2])};
    return box.overlaps({centre_ - reach, centre_ + reach});
  }

  Axes axes_ = frame_axes;
  Vec3 centre_{0, 0, 0}, half_{-1, -1, -1};
};

}  // namespace abut
