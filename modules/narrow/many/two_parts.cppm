// SPDX-License-Identifier: Apache-2.0
// The triangles of two surfaces that may be within a reach of each other.
export module abut.narrow.many.two_parts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.many.quick_axes;
import abut.trees.slab;
import abut.trees.two_trees;

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
class TwoParts {
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
      return QuickAxes<Triangle>::near_on_way(part, placed, {0, 0, 0}, reach);
    };
    parts.visit(of_a, of_b, near, [&](const Triangle& part, const Triangle& other) { reach = visit(part, other); });
    return reach + noise;
  };
  visit_two(a, b, GapOrder(a.origin(), b.origin(), ab), reach + noise, visit_items, wants);
}

// The same for parts that may be within `reach` of each other while b moves along a direction, as far as `length`:
// those of which near(corners of both in the frame of a) has a bit.
template <Surface A, Surface B, class Near, class Visitor>
void visit_two_parts_on_way(const A& a, const B& b, const Pose& ab, const Vec3& direction, Real length, Real reach,
                            Near&& near, Visitor&& visit) {
  TwoParts<A, B> parts(a, b, ab);
  const auto visit_items = [&](std::uint32_t of_a, std::uint32_t of_b) {
    parts.visit(of_a, of_b, near, visit);
    return length;
  };
  const Real slack = std::max(reach, Real{0}) + noise_of_two(a, b, ab);
  visit_two(a, b, PassageOrder(a.origin(), b.origin(), ab, direction, slack), length, visit_items);
}

// What is within a reach of the plane of a triangle while that moves along a way, or anything: slivers have no plane.
[[nodiscard]] inline Slab slab_around(const TriangleCorners& corners, const Vec3& normal, const Vec3& way, Real reach) {
  const Real moved = dot(normal, way);
  return {normal, least_along(corners, normal) + std::min(moved, Real{0}) - reach,
          -least_along(corners, -normal) + std::max(moved, Real{0}) + reach};
}

// The same where b has few parts under a, or under a on the way back along a vector. Each of these asks the tree of a,
// which answers for four parts at once: near(corners of parts, corners of one of b) has a bit for each. False, with
// nothing visited, where b has many. In no order.
template <Surface A, Terrain B, class Near, class Visitor>
[[nodiscard]] bool visit_parts_on(const A& a, const B& b, const Pose& ab, const Vec3& way, Real reach, Near&& near,
                                  Visitor&& visit) {
  constexpr std::size_t few = 2048;
  const Real around = std::max(reach, Real{0}) + noise_of_two(a, b, ab);
  Aabb under_a = a.aabb(ab.inverse()).swept({0, 0, 0}, -ab.rotation.undo(way)).inflated(around);
  if (b.most_parts_under(under_a) > few) {
    return false;
  }
  b.visit_parts(under_a, [&](const Triangle& other, std::uint32_t) {
    const TriangleCorners& corners = other.corners();
    const TriangleCorners placed{ab * corners[0], ab * corners[1], ab * corners[2]};
    const FourTriangles in_all = FourTriangles::all(placed);
    Aabb near_other = box_around(placed).swept({0, 0, 0}, way).inflated(around);
    const auto ask = [&](const FourTriangles& parts) { return near(parts, in_all); };
    const Slab slab = slab_around(placed, ab.rotation * other.normal(), way, around);
    a.visit_parts(near_other, InSlab{ask, slab}, [&](const Triangle& part, std::uint32_t) { visit(part, other); });
  });
  return true;
}

}  // namespace abut
