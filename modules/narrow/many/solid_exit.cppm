// SPDX-License-Identifier: Apache-2.0
// How far a convex shape has to move along a direction until it is out of a solid surface. Each
// triangle that is in the way is left by its own: the distance to it is a convex function of the way, so that Newton's
// method from the far side never passes its zero. Where nothing is in the way, the shape is out, or between surfaces
// inside.
export module abut.narrow.many.solid_exit;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.convex;
import abut.narrow.many.quick_axes;
import abut.narrow.many.triangle_contacts;

export namespace abut {

// A way out, and where the shape touches the surface at its end. It overlaps nothing there.
struct WayOut {
  Vec3 direction;  // unit
  Real length;
  Vec3 point;   // of the surface
  Vec3 normal;  // unit, from the surface
  std::uint32_t part;
};

// Below this lengths are rounding: of a solid with a box, and of what has another one.
[[nodiscard]] inline Real touching_of_solids(const Aabb& box, const Aabb& other) {
  constexpr Real share = 2e-12;
  return share * largest_magnitude(maximum(maximum(absolute(box.low), absolute(box.high)),
                                           maximum(absolute(other.low), absolute(other.high))));
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

template <Enclosing A, Convex B>
class SolidExit {
 public:
  SolidExit(const A& a, const B& b, const Pose& ab, const QuerySettings& settings)
      : a_(a),
        b_(b),
        ab_(ab),
        settings_(settings),
        box_(a.aabb(Pose::identity())),
        touching_(touching_of_solids(box_, b.aabb(ab))),
        corners_(corners_of_thin(b, ab)) {
    visit_overlaps_at(ab_, [&](const Triangle& part) { at_start_.push_back(part.index()); });
    // A tree gives them in an order of its own, which edits change.
    std::ranges::sort(at_start_.span());
  }

  // Lengths below this are rounding.
  [[nodiscard]] Real touching() const { return touching_; }

  // Calls visit(part) for the parts that overlap at the start.
  template <class Visitor>
  void visit_overlaps(Visitor&& visit) const {
    for (const std::uint32_t part : at_start_.span()) {
      visit(a_.part(part));
    }
  }

  // The corners of b at the start, where it is thin.
  [[nodiscard]] std::span<const Vec3> corners() const { return corners_.span(); }

  // The point, where it is inside.
  [[nodiscard]] std::optional<Vec3> inside_at(const Vec3& point) const {
    return box_.overlaps({point, point}) && a_.contains(point) ? std::optional(point) : std::nullopt;
  }
  // A place of b inside after a move; none where it is outside. The surface does not cross it.
  [[nodiscard]] std::optional<Vec3> place_inside(const Vec3& move) const {
    return inside_at(placed_centre(b_, ab_) + move);
  }

  // The end of a way along a direction, or a way that is `enough` or more, as soon as that is known.
  [[nodiscard]] WayOut along(const UnitVec3& direction, Real enough) const {
    const Vec3 d = direction, last = placed_support(b_, place(b_, ab_), -d).point - b_.radius() * d;
    const Real clear = furthest_of(box_, d) - dot(d, last);  // then the boxes are apart
    WayOut out{d, 0, last, d, no_index};
    for (int step = 0; step < most_steps && out.length + touching_ < std::min(clear, enough); ++step) {
      if (advance(out)) {
        return out;
      }
    }
    out.length = out.length < enough ? clear : out.length;
    return out;
  }

 private:
  static constexpr int most_steps = 24, most_newton_steps = 32;

  struct InTheWay {
    Real clear;  // a way after which the part is passed
    std::uint32_t part;
  };

  [[nodiscard]] static Real furthest_of(const Aabb& box, const Vec3& d) {
    return std::max(d.x * box.low.x, d.x * box.high.x) + std::max(d.y * box.low.y, d.y * box.high.y) +
           std::max(d.z * box.low.z, d.z * box.high.z);
  }

  // Further on along a direction, past what is in the way. Whether b is out.
  [[nodiscard]] bool advance(WayOut& out) const {
    const Real before = out.length;
    pass_overlaps(out);
    if (out.length > before) {
      return false;
    }
    // Not just at the surface: there rounding tells.
    const Real further = out.length + 2 * touching_;
    if (const auto inside = place_inside(further * out.direction)) {
      if (!reach_surface(*inside, further, out)) {
        out.length = infinity;
      }
      return false;
    }
    // What is thin may cross the surface where triangles meet, and overlap none of them. Then a corner of it is inside.
    return std::ranges::none_of(corners_.span(), [&](const Vec3& corner) {
      const auto inside = inside_at(corner + further * out.direction);
      return inside && reach_surface(*inside, further, out);
    });
  }

  // From a place inside, which a point of b has reached after some way, on to the surface. Whether there is any.
  [[nodiscard]] bool reach_surface(const Vec3& inside, Real way, WayOut& out) const {
    const Vec3 d = out.direction;
    const auto hit = a_.cast_ray(inside, UnitVec3::from_unit_unchecked(d), infinity);
    if (hit) {
      out.length = way + hit->distance;
      out.point = inside + hit->distance * d;
      out.normal = dot(hit->normal, d) < 0 ? -hit->normal : hit->normal;
      out.part = hit->feature.index;
    }
    return hit.has_value();
  }

  // Calls visit(part) for the parts that overlap where b is placed so.
  template <class Visitor>
  void visit_overlaps_at(const Pose& at, Visitor&& visit) const {
    const QuickAxes<B> axes(b_, at);
    Aabb query = b_.aabb(at);
    const InFours is_near{[&](const FourTriangles& triangles) { return axes.near(triangles, b_.radius()); }};
    a_.visit_parts(query, is_near, [&](const Triangle& part, std::uint32_t) {
      const CoreSeparation core = separate_from_triangle(part, b_, at, settings_, b_.radius());
      if (!core.beyond && core.distance - b_.radius() < -touching_) {
        visit(part);
      }
    });
  }

  void pass_overlaps(WayOut& out) const {
    SmallVector<InTheWay, 64> met;
    const Vec3 d = out.direction, last = placed_support(b_, place(b_, ab_), -d).point;
    const auto add = [&](const Triangle& part) {
      met.push_back({dot(d, part.support(d).point - last) + b_.radius(), part.index()});
    };
    if (out.length == 0) {
      visit_overlaps(add);
    } else {
      visit_overlaps_at({ab_.rotation, ab_.position + out.length * d}, add);
    }
    std::ranges::sort(met.span(), [](const InTheWay& a, const InTheWay& b) {
      return std::tuple(-a.clear, a.part) < std::tuple(-b.clear, b.part);
    });
    const Real start = out.length;
    for (const InTheWay& each : met.span()) {
      if (each.clear <= out.length && out.length > start) {
        break;
      }
      pass(a_.part(each.part), std::max(each.clear, start) + touching_, start, out);
    }
  }

  // From a way after which a part is passed back to where both touch.
  void pass(const Triangle& part, Real clear, Real start, WayOut& out) const {
    Real way = clear;
    Distance found{};
    for (int step = 0; step < most_newton_steps; ++step) {
      const Pose at{ab_.rotation, ab_.position + way * out.direction};
      const Outcome outcome = convex_distance(part, b_, at, settings_, found);
      const Real slope = dot(out.direction, found.normal);
      if (outcome != Outcome::ok || !(found.distance > touching_) || !(slope > 0)) {
        break;
      }
      way = std::max(way - found.distance / slope, start);
      if (way == start) {
        break;
      }
    }
    if (way > out.length) {
      out.length = way;
      out.point = found.point_a;
      out.normal = found.normal;
      out.part = part.index();
    }
  }

  const A& a_;
  const B& b_;
  const Pose& ab_;
  const QuerySettings& settings_;
  Aabb box_;
  Real touching_;
  SmallVector<Vec3, 8> corners_;  // where b is thin
  SmallVector<std::uint32_t, 64> at_start_;
};

}  // namespace abut
