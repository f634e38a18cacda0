// SPDX-License-Identifier: Apache-2.0
// The triangles of two surfaces that may be within a reach of each other.
export module abut.narrow.parts.two_parts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.triangle.quick_axes;
import abut.trees.boxes.two_trees;

export namespace abut {

// How far the places of parts of two surfaces may be off by rounding.
template <Surface A, Surface B>
[[nodiscard]] Real noise_of_two(const A& a, const B& b, const Pose& ab) {
  const auto size_of = [](const Aabb& box) {
    return largest_magnitude(maximum(absolute(box.low), absolute(box.high)));
  };
  return noise_of(size_of(a.aabb(Pose::identity())) + size_of(b.aabb(Pose::identity())) +
                  largest_magnitude(ab.position));
}

// Where a surface begins along a direction, or just before. Of a flat surface not all parts are asked.
template <Surface S>
[[nodiscard]] Real lowest_of(const S& surface, const Vec3& direction) {
  const Aabb box = surface.aabb(Pose::identity());
  const Real noise = noise_of(largest_magnitude(maximum(absolute(box.low), absolute(box.high))));
  Real limit = infinity;
  surface.visit_below(direction, limit, [&](const Triangle& part, std::uint32_t) {
    limit = std::min(limit, least_along(part.corners(), direction) - noise);
  });
  return limit;
}

// The parts of two items. Often several parts of a meet one of b, one after the other.
template <Surface A, Surface B>
class [[gsl::Pointer]] TwoParts {
 public:
  TwoParts(const A& a, const B& b, const Pose& ab) : a_(a), b_(b), ab_(ab) {}

  // Calls visit(part of a, part of b) if near(corners of both in the frame of a) has a bit.
  template <class Near, class Visitor>
  [[gnu::always_inline]] inline void visit(std::uint32_t of_a, std::uint32_t of_b, Near&& near, Visitor&& visit) {
    if (!held_ || held_->part.index() != of_b) {
      const Triangle part = b_.part(of_b);
      const TriangleCorners& corners = part.corners();
      held_.emplace(Held{part, FourTriangles::all({ab_ * corners[0], ab_ * corners[1], ab_ * corners[2]})});
    }
    FourTriangles of_part = FourTriangles::all(a_.corners(of_a));
    of_part.numbers.fill(of_a);
    if (near(of_part, held_->placed) != 0) {
      visit(a_.part(of_a), held_->part);
    }
  }

 private:
  struct Held {
    Triangle part;
    FourTriangles placed;  // the same one in all lanes
  };

  const A& a_;
  const B& b_;
  const Pose& ab_;
  std::optional<Held> held_;
};

// Calls visit(part of a, part of b) for parts that may be within `reach`, mostly nearer ones first. visit returns the
// reach that is wanted from then on. Parts may be left out, as by visit_two.
template <Surface A, Surface B, class Visitor, class Wants = WantsAnyItem>
void visit_two_parts(const A& a, const B& b, const Pose& ab, Real reach, Visitor&& visit, Wants&& wants = {}) {
  TwoParts<A, B> parts(a, b, ab);
  const Real noise = noise_of_two(a, b, ab);
  const auto visit_items = [&](std::uint32_t of_a, std::uint32_t of_b) {
    const auto near = [&](const FourTriangles& part, const FourTriangles& placed) {
      return QuickAxes<Triangle>::near(part, placed, reach);
    };
    parts.visit(of_a, of_b, near, [&](const Triangle& part, const Triangle& other) { reach = visit(part, other); });
    return reach + noise;
  };
  visit_two(a, b, GapOrder(a.origin(), b.origin(), ab), reach + noise, visit_items, wants);
}

}  // namespace abut
