// SPDX-License-Identifier: Apache-2.0
// A box with axes of its own around points, as the nodes of a tree of oriented boxes have one. Gottschalk, Lin and
// Manocha, "OBBTree: a hierarchical structure for rapid interference detection", 1996. A box along the axes of the
// frame goes with it.
export module abut.trees.volumes.oriented_box;
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
    OrientedBox least = turned.surface() < straight.surface() ? turned : straight;
    least.straight_ = {straight.centre_ - straight.half_, straight.centre_ + straight.half_};
    return least;
  }
  // Along the axes of one of both or of the box that was around them before, or along those of the frame.
  [[nodiscard]] static inline OrientedBox around(const OrientedBox& a, const OrientedBox& b,
                                                 const OrientedBox& before) {
    if (a.is_empty() || b.is_empty()) {
      return a.is_empty() ? b : a;
    }
    const auto spans = [&](const Vec3& direction) {
      Span span{infinity, -infinity};
      for (const OrientedBox* box : {&a, &b}) {
        span.include(box->lowest_along(direction));
        span.include(-box->lowest_along(-direction));
      }
      return span;
    };
    OrientedBox least = with(frame_axes, spans);
    for (const OrientedBox* box : {&a, &b, &before}) {
      const OrientedBox turned = with(box->axes_, spans);
      least = turned.surface() < least.surface() ? turned : least;
    }
    least.straight_ = a.straight_;
    least.straight_.include(b.straight_);
    return least;
  }

  [[nodiscard]] bool is_empty() const { return half_.x < 0; }
  // By the axes of both. Those across two edges would add little (see two_trees).
  [[nodiscard]] inline bool overlaps(const Aabb& box) const {
    if (!straight_.overlaps(box) || !box.is_bounded()) {
      return straight_.overlaps(box);
    }
    const Vec3 middle = box.centre(), half = 0.5 * (box.high - box.low), between = centre_ - middle;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3& own = axes_[static_cast<std::size_t>(axis)];
      if (std::fabs(dot(own, between)) > half_[axis] + dot(absolute(own), half)) {
        return false;
      }
    }
    return true;
  }
  // Of no volume it is without end.
  [[nodiscard]] inline Real lowest_along(const Vec3& direction) const {
    if (is_empty()) {
      return infinity;
    }
    const Real straight =
        dot(direction, straight_.centre()) - 0.5 * dot(absolute(direction), straight_.high - straight_.low);
    return std::max(dot(direction, centre_) - reach_along(direction), straight);
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

  Axes axes_ = frame_axes;
  Vec3 centre_{0, 0, 0}, half_{-1, -1, -1};
  Aabb straight_ = Aabb::empty();  // around the same, along the axes of the frame: unions of these stay tight
};

}  // namespace abut
