// SPDX-License-Identifier: Apache-2.0
module abut.narrow.overlap.surfaces.surface_overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.triangle.quick_axes;
import abut.narrow.surface.triangle_source;
import abut.narrow.overlap.convex_overlap;
import abut.narrow.overlap.convex_side;
import abut.narrow.overlap.surfaces.core_among_triangles;
import abut.trees.volumes.eight_boxes;
import abut.trees.boxes.two_trees;

namespace abut {
namespace {

[[nodiscard]] Real size_of(const Aabb& box) {
  return largest_magnitude(maximum(absolute(box.low), absolute(box.high)));
}

// The plane of a triangle, of which only the front stops.
class Front {
 public:
  explicit Front(const TriangleCorners& corners)
      : normal_(cross(corners[1] - corners[0], corners[2] - corners[0])), height_(dot(normal_, corners[0])) {}

  [[nodiscard]] const Vec3& normal() const [[clang::lifetimebound]] { return normal_; }
  [[nodiscard]] bool is_before(const Vec3& point) const { return dot(normal_, point) > height_ + noise_at(point); }
  [[nodiscard]] bool is_behind(const Vec3& point) const { return dot(normal_, point) < height_ - noise_at(point); }

 private:
  [[nodiscard]] Real noise_at(const Vec3& point) const {
    return noise_of(largest_magnitude(point)) * largest_magnitude(normal_);
  }

  Vec3 normal_;
  Real height_;
};

// Whether the triangles of a surface stop a core.
class [[gsl::Pointer]] CoreQuestion {
 public:
  CoreQuestion(const CoreAmongTriangles& core, const Pose& ab, Real reach, Real noise, bool has_fronts)
      : core_(core), ab_(ab), reach_(reach), noise_(noise), has_fronts_(has_fronts) {}

  // Until one does.
  [[nodiscard]] Met ask(const SurfaceSource& surface, const Aabb& near) {
    Met met = Met::no;
    surface.visit(near, [&](const FourTriangles& four, std::uint64_t present) {
      std::uint64_t left = present == 0 ? 0 : present & core_.near(four, reach_);
      for (; left != 0 && met != Met::yes; left &= left - 1) {
        const Met found = met_by(four[static_cast<std::size_t>(std::countr_zero(left))]);
        met = found == Met::no ? met : found;
      }
      return met != Met::yes;
    });
    return met;
  }

 private:
  [[nodiscard]] Met met_by(const TriangleCorners& corners) const {
    return !is_within(corners, reach_) ? Met::no : has_fronts_ ? meets_front(corners) : Met::yes;
  }
  [[nodiscard]] bool is_within(const TriangleCorners& corners, Real reach) const {
    if (const std::optional<bool> answer = core_.is_within(corners, reach + noise_)) {
      return *answer;
    }
    return is_core_within(core_, {ab_.undo(corners[0]), ab_.undo(corners[1]), ab_.undo(corners[2])}, reach);
  }
  // A core that is all before a front is pushed back by it, and one that is all behind is not.
  [[nodiscard]] Met meets_front(const TriangleCorners& corners) const {
    const Front front(corners);
    const Vec3 up = ab_.rotation.undo(front.normal());
    if (!front.is_before(ab_ * core_.support(up))) {
      return Met::no;
    }
    const bool is_through = front.is_behind(ab_ * core_.support(-up));
    return !is_through || (front.is_before(ab_ * core_.centre) && is_within(corners, 0)) ? Met::yes
                                                                                         : Met::left_to_contacts;
  }

  const CoreAmongTriangles& core_;
  const Pose& ab_;
  Real reach_, noise_;
  bool has_fronts_;
};

// Whether triangles only stop what comes from their fronts. What a solid encloses is inside from all sides.
[[nodiscard]] bool has_open_fronts(const SurfaceSource& surface) { return surface.sides() == StoppingSides::front; }
[[nodiscard]] bool is_solid(const SurfaceSource& surface) { return surface.sides() == StoppingSides::solid; }

// Of a shape that is near no triangle: any point of it tells.
[[nodiscard]] bool is_inside(const SurfaceSource& surface, const ConvexSide& core, const Pose& ab) {
  return surface.contains(ab * core.support({0, 0, 1}));
}

// The boxes of a surface as a Hierarchy.
class [[gsl::Pointer]] TreeOfSource {
 public:
  explicit TreeOfSource(const SurfaceSource& surface) : surface_(surface) {}

  [[nodiscard]] Vec3 origin() const { return surface_.middle(); }
  template <class Visitor>
  void visit_children(std::uint32_t node, Visitor&& visit) const {
    surface_.visit_node(node, [&visit](const EightBoxes& boxes) { visit(boxes); });
  }

 private:
  const SurfaceSource& surface_;
};

// The order of two trees in which boxes come first that reach furthest into each other.
class DeepestFirst {
 public:
  DeepestFirst(const Vec3& origin_a, const Vec3& origin_b, const Pose& ab) : axes_(origin_a, origin_b, ab) {}

  // Along the best axis of both, how far boxes are apart at least, or how far in each other at most.
  [[nodiscard]] [[gnu::always_inline]] inline EightWays ways(const EightBoxes& eight, const OneBox& other,
                                                             bool are_of_b) const {
    EightFloats gap = EightFloats(-std::numeric_limits<float>::max());
    axes_.for_each<EightFloats>(eight, 0, other, are_of_b, [&](int, EightFloats between, EightFloats reach) {
      const EightFloats beyond = magnitudes(between) - reach;
      gap = beyond > gap ? beyond : gap;
    });
    return in_double(gap);
  }
  [[nodiscard]] static inline Real way_of(Real reach) { return reach; }

 private:
  BoxAxes axes_;
};

[[nodiscard]] bool has_point_inside(const SurfaceSource& surface, const SurfaceSource& other, const Pose& placing) {
  const auto is_inside = [&](const Vec3& point) { return surface.contains(placing * point); };
  return is_solid(surface) && std::ranges::any_of(other.pieces(), is_inside);
}

// Of two triangles that are within reach: whether the second one is pushed back by the front of the first one.
[[nodiscard]] Met meets_front(const TriangleCorners& front, const TriangleCorners& other) {
  const Front its(front);
  const auto count = [&](const auto& is_there) {
    return int{is_there(other[0])} + int{is_there(other[1])} + int{is_there(other[2])};
  };
  if (count([&](const Vec3& point) { return its.is_before(point); }) == 0) {
    return Met::no;
  }
  return count([&](const Vec3& point) { return its.is_behind(point); }) == 0 ? Met::yes : Met::left_to_contacts;
}

}  // namespace

Met meets(const SurfaceSource& surface, CoreAmongTriangles& core, const Pose& ab, Real reach, Fronts fronts) {
  const Aabb box = core.box_at(ab), around = surface.box();
  const Real noise = noise_of(std::fmax(size_of(box), size_of(around)));
  const Aabb near = box.inflated(std::fmax(reach - core.radius, 0.0) + noise);
  if (!near.overlaps(around)) {
    return Met::no;
  }
  core.place(ab);
  CoreQuestion question(core, ab, reach, noise, fronts == Fronts::respected && has_open_fronts(surface));
  const Met met = question.ask(surface, near);
  return met != Met::yes && is_solid(surface) && is_inside(surface, core, ab) ? Met::yes : met;
}

Met meets(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, Real reach, Fronts fronts) {
  const Aabb box_a = a.box(), box_b = b.box();
  const Real noise = noise_of(size_of(box_a) + size_of(box_b) + largest_magnitude(ab.position));
  if (!transformed(box_b, ab).inflated(reach + noise).overlaps(box_a)) {
    return Met::no;
  }
  const bool fronts_a = fronts == Fronts::respected && has_open_fronts(a),
             fronts_b = fronts == Fronts::respected && has_open_fronts(b);
  Met met = Met::no;
  const auto visit = [&](std::uint32_t of_a, std::uint32_t of_b) {
    const TriangleCorners first = a.corners(of_a), local = b.corners(of_b),
                          second{ab * local[0], ab * local[1], ab * local[2]};
    const FourTriangles of_first = FourTriangles::all(first), of_second = FourTriangles::all(second);
    if (QuickAxes<Triangle>::near(of_first, of_second, reach) != 0 && are_triangles_within(first, second, reach)) {
      const Met front_a = fronts_a ? meets_front(first, second) : Met::yes,
                front_b = fronts_b ? meets_front(second, first) : Met::yes;
      if (front_a == Met::yes && front_b == Met::yes) {
        met = Met::yes;
      } else if (front_a != Met::no && front_b != Met::no) {
        met = Met::left_to_contacts;
      }
    }
    return met == Met::yes ? -infinity : reach + noise;
  };
  const TreeOfSource tree_a(a), tree_b(b);
  visit_two(tree_a, tree_b, DeepestFirst(tree_a.origin(), tree_b.origin(), ab), reach + noise, visit);
  return met != Met::yes && (has_point_inside(a, b, ab) || has_point_inside(b, a, ab.inverse())) ? Met::yes : met;
}

}  // namespace abut
