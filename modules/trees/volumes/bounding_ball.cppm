// SPDX-License-Identifier: Apache-2.0
// A ball around points, as the nodes of a tree of spheres have one.
export module abut.trees.volumes.bounding_ball;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;

export namespace abut {

class BoundingBall {
 public:
  BoundingBall() = default;
  // Badoiu and Clarkson, "Smaller core-sets for balls", 2003: a step toward the furthest point, each shorter than the
  // one before.
  [[nodiscard]] static inline BoundingBall around(std::span<const Vec3> points) {
    constexpr int steps = 16;
    Aabb box = Aabb::empty();
    for (const Vec3& point : points) {
      box.include(point);
    }
    Vec3 centre = box.centre();
    BoundingBall best = about(centre, points);
    for (int step = 1; step <= steps; ++step) {
      const auto further = [&](const Vec3& a, const Vec3& b) {
        return squared_norm(a - centre) < squared_norm(b - centre);
      };
      centre += (Real{1} / (step + 1)) * (*std::max_element(points.begin(), points.end(), further) - centre);
      const BoundingBall ball = about(centre, points);
      best = ball.radius_ < best.radius_ ? ball : best;
    }
    return best;
  }
  // What was around both before says nothing.
  [[nodiscard]] static inline BoundingBall around(const BoundingBall& a, const BoundingBall& b, const BoundingBall&) {
    if (a.is_empty() || b.is_empty()) {
      return a.is_empty() ? b : a;
    }
    const Vec3 between = b.centre_ - a.centre_;
    const Real distance = norm(between);
    if (distance + b.radius_ <= a.radius_) {
      return a;
    }
    if (distance + a.radius_ <= b.radius_) {
      return b;
    }
    const Real radius = 0.5 * (distance + a.radius_ + b.radius_);
    BoundingBall both;
    both.centre_ = a.centre_ + ((radius - a.radius_) / distance) * between;
    both.radius_ = radius;
    return both.padded();
  }

  [[nodiscard]] bool is_empty() const { return radius_ < 0; }
  [[nodiscard]] const Vec3& centre() const [[clang::lifetimebound]] { return centre_; }
  [[nodiscard]] Real radius() const { return radius_; }
  [[nodiscard]] inline bool overlaps(const Aabb& box) const {
    return !is_empty() && squared_norm(minimum(maximum(centre_, box.low), box.high) - centre_) <= radius_ * radius_;
  }
  // Of no volume it is without end.
  [[nodiscard]] inline Real lowest_along(const Vec3& direction) const {
    return is_empty() ? infinity : dot(direction, centre_) - radius_ * norm(direction);
  }
  // Where a ray enters, zero inside; without end where it misses.
  [[nodiscard]] inline Real entry_of(const Vec3& origin, const Vec3& direction) const {
    if (is_empty()) {
      return infinity;
    }
    const Vec3 offset = centre_ - origin;
    const Real square = squared_norm(direction), along = dot(offset, direction) / square;
    const Real beside = squared_norm(offset - along * direction), inside = radius_ * radius_ - beside;
    if (inside < 0) {
      return infinity;
    }
    const Real half = std::sqrt(inside / square);
    return along + half < 0 ? infinity : std::max(along - half, Real{0});
  }
  [[nodiscard]] inline Real distance_to(const Vec3& point) const {
    return is_empty() ? infinity : std::max(norm(point - centre_) - radius_, Real{0});
  }
  // What the chance of being visited is proportional to.
  [[nodiscard]] Real surface() const { return is_empty() ? 0 : radius_ * radius_; }
  [[nodiscard]] inline bool holds(const Vec3& point) const {
    return !is_empty() && squared_norm(point - centre_) <= radius_ * radius_;
  }

 private:
  [[nodiscard]] static inline BoundingBall about(const Vec3& centre, std::span<const Vec3> points) {
    Real square = 0;
    for (const Vec3& point : points) {
      square = std::max(square, squared_norm(point - centre));
    }
    BoundingBall ball;
    ball.centre_ = centre;
    ball.radius_ = std::sqrt(square);
    return ball.padded();
  }
  // By more than the rounding of what is asked of it.
  [[nodiscard]] inline BoundingBall padded() const {
    BoundingBall larger = *this;
    larger.radius_ += noise_of(radius_ + largest_magnitude(centre_));
    return larger;
  }

  Vec3 centre_{0, 0, 0};
  Real radius_ = -1;
};

}  // namespace abut
