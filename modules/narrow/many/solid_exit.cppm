// SPDX-License-Identifier: Apache-2.0
// How far a convex shape, or another surface, has to move along a direction until it is out of a solid surface. Each
// triangle that is in the way is left by its own: the distance to it is a convex function of the way, so that Newton's
// method from the far side never passes its zero. Where nothing is in the way, the shape is out, or between surfaces
// inside.
export module abut.narrow.many.solid_exit;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
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

// What a surface is made of, or a convex shape itself.
template <class B>
struct SolidPart {
  using type = B;
};
template <Surface B>
struct SolidPart<B> {
  using type = typename B::Part;
};

// Of two surfaces either one may be the solid.
template <Enclosing A, class B>
class SolidExit {
 public:
  SolidExit(const A& a, const B& b, const Pose& ab, const QuerySettings& settings)
      : a_(a), b_(b), ab_(ab), settings_(settings), box_(a.aabb(Pose::identity())) {
    const Aabb around = b.aabb(ab);
    const Vec3 furthest =
        maximum(maximum(absolute(box_.low), absolute(box_.high)), maximum(absolute(around.low), absolute(around.high)));
    touching_ = touching_share * largest_magnitude(furthest);
    visit_overlaps_at(ab_, false, [&](const Triangle& part, const Part&, std::uint32_t index) {
      at_start_.push_back({part.index(), index});
    });
  }

  // Lengths below this are rounding.
  [[nodiscard]] Real touching() const { return touching_; }

  // Calls visit(part, convex) for the parts of both that overlap at the start.
  template <class Visitor>
  void visit_overlaps(Visitor&& visit) const {
    for (const Overlap& overlap : at_start_.span()) {
      visit(a_.part(overlap.part), other(overlap.other));
    }
  }

  // A place of b inside, or of a inside b, after a move; none where both are outside. Their surfaces do not cross.
  [[nodiscard]] std::optional<Vec3> place_inside(const Vec3& move) const {
    const auto is_in_a = [&](const Vec3& place) { return box_.overlaps({place, place}) && a_.contains(place); };
    if constexpr (Convex<B>) {
      const Vec3 centre = placed_centre(b_, ab_) + move;
      return is_in_a(centre) ? std::optional(centre) : std::nullopt;
    } else {
      const Pose at{ab_.rotation, ab_.position + move};
      if (a_.is_solid()) {
        for (const Vec3& piece : b_.pieces()) {
          if (is_in_a(at * piece)) {
            return at * piece;
          }
        }
      }
      if (b_.is_solid()) {
        const Aabb box_of_b = b_.aabb(Pose::identity());
        for (const Vec3& piece : a_.pieces()) {
          const Vec3 local = at.undo(piece);
          if (box_of_b.overlaps({local, local}) && b_.contains(local)) {
            return piece;
          }
        }
      }
      return std::nullopt;
    }
  }

  // The end of a way along a direction, or a way that is `enough` or more, as soon as that is known. Two surfaces take
  // long to pass each other part by part. So ways grow from some steps on; then the end is not surely the first one.
  [[nodiscard]] WayOut along(const UnitVec3& direction, Real enough) const {
    const Vec3 d = direction, last = last_along(d);
    const Real clear = furthest_of(box_, d) - dot(d, last);  // then the boxes are apart
    WayOut out{d, 0, last, d, no_index};
    Real blocked = 0;
    for (int step = 0; step < most_steps && out.length + touching_ < std::min(clear, enough); ++step) {
      const Real before = out.length;
      if (advance(out)) {
        return step > steps_before_growth && !Convex<B> ? shortened(out, blocked) : out;
      }
      blocked = before;
      if (step >= steps_before_growth && !Convex<B>) {
        out.length = std::max(out.length, growth * before);
      }
    }
    out.length = out.length < enough ? clear : out.length;
    return out;
  }

 private:
  using Part = typename SolidPart<B>::type;
  static constexpr Real touching_share = 2e-12, growth = 1.4;
  static constexpr int most_steps = 24, steps_before_growth = 2, most_halvings = 6, most_newton_steps = 32;
  static constexpr std::size_t parts_at_once = 64;

  struct Overlap {
    std::uint32_t part, other;
  };
  struct PlacedPart {
    Aabb box;
    std::uint32_t index;
  };
  struct InTheWay {
    Real clear;  // a way after which the parts have passed each other
    std::uint32_t part, other;
  };

  [[nodiscard]] static Real furthest_of(const Aabb& box, const Vec3& d) {
    return std::max(d.x * box.low.x, d.x * box.high.x) + std::max(d.y * box.low.y, d.y * box.high.y) +
           std::max(d.z * box.low.z, d.z * box.high.z);
  }
  // The point of b that is last out; of a surface, a corner of its box.
  [[nodiscard]] Vec3 last_along(const Vec3& d) const {
    if constexpr (Convex<B>) {
      return placed_support(b_, place(b_, ab_), -d).point - b_.radius() * d;
    } else {
      const Aabb box = b_.aabb(ab_);
      return {d.x > 0 ? box.low.x : box.high.x, d.y > 0 ? box.low.y : box.high.y, d.z > 0 ? box.low.z : box.high.z};
    }
  }
  [[nodiscard]] decltype(auto) other(std::uint32_t index) const {
    if constexpr (Convex<B>) {
      return (b_);
    } else {
      return b_.part(index);
    }
  }

  // Further on along a direction, past what is in the way. Whether b is out.
  [[nodiscard]] bool advance(WayOut& out) const {
    const Real before = out.length;
    pass_overlaps(out);
    if (out.length > before) {
      return false;
    }
    const Vec3 move = out.length * out.direction;
    const std::optional<Vec3> inside = place_inside(move);
    if (!inside) {
      return true;
    }
    out.length += way_to_surface(*inside, move, UnitVec3::from_unit_unchecked(out.direction)) + 2 * touching_;
    return false;
  }

  // Halves what lies between a way that is blocked and one that is out, and passes what is in the way in the end.
  [[nodiscard]] WayOut shortened(WayOut out, Real blocked) const {
    for (int halving = 0; halving < most_halvings && out.length - blocked > touching_; ++halving) {
      const Real middle = 0.5 * (blocked + out.length);
      (is_out(middle * out.direction) ? out.length : blocked) = middle;
    }
    WayOut passed = out;
    passed.length = blocked;
    return !advance(passed) && passed.length < out.length && is_out(passed.length * out.direction) ? passed : out;
  }

  [[nodiscard]] bool is_out(const Vec3& move) const {
    bool is_met = false;
    visit_overlaps_at({ab_.rotation, ab_.position + move}, is_met,
                      [&](const Triangle&, const Part&, std::uint32_t) { is_met = true; });
    return !is_met && !place_inside(move);
  }

  // Calls visit(part, convex, index) for the parts that overlap where b is placed so, until it is to stop.
  template <class Visitor>
  void visit_overlaps_at(const Pose& at, const bool& is_to_stop, Visitor&& visit) const {
    if constexpr (Convex<B>) {
      const QuickAxes<B> axes(b_, at);
      Aabb query = b_.aabb(at);
      const InFours is_near{[&](const FourTriangles& triangles) { return axes.near(triangles, b_.radius()); }};
      a_.visit_parts(query, is_near, [&](const Triangle& part, std::uint32_t) {
        if (!is_to_stop && do_overlap(part, b_, at)) {
          visit(part, b_, 0);
        }
      });
    } else {
      SmallVector<PlacedPart, parts_at_once> parts;
      Aabb query = a_.aabb(at.inverse());
      b_.visit_parts(query, [&](const Part& part, std::uint32_t index) {
        parts.push_back({part.aabb(at), index});
        if (parts.size() == parts_at_once) {
          visit_overlaps_of(parts, at, is_to_stop, visit);
        }
      });
      visit_overlaps_of(parts, at, is_to_stop, visit);
    }
  }
  // Parts that come one after the other lie near each other: most of them meet nothing, all at once.
  template <class Visitor>
  void visit_overlaps_of(SmallVector<PlacedPart, parts_at_once>& parts, const Pose& at, const bool& is_to_stop,
                         Visitor&& visit) const {
    Aabb query = Aabb::empty();
    for (const PlacedPart& each : parts.span()) {
      query.include(each.box);
    }
    if (is_to_stop) {
      return;
    }
    a_.visit_parts(query, [&](const Triangle& part, std::uint32_t) {
      const Aabb box = part.box();
      for (const PlacedPart& each : parts.span()) {
        if (!is_to_stop && box.overlaps(each.box)) {
          const Part convex = b_.part(each.index);
          const FourTriangles triangle = FourTriangles::all(part.corners());
          if (QuickAxes<Part>(convex, at).near(triangle, 0) != 0 && do_overlap(part, convex, at)) {
            visit(part, convex, each.index);
          }
        }
      }
    });
    parts.clear();
  }
  [[nodiscard]] bool do_overlap(const Triangle& part, const Part& convex, const Pose& at) const {
    const CoreSeparation core = separate_from_triangle(part, convex, at, settings_, convex.radius());
    return !core.beyond && core.distance - convex.radius() < -touching_;
  }

  // From a place inside of a, or of a inside b, to the surface that is around it.
  [[nodiscard]] Real way_to_surface(const Vec3& place, const Vec3& move, const UnitVec3& direction) const {
    const auto length = [](const std::optional<RayHit>& hit) { return hit ? hit->distance : infinity; };
    if constexpr (Convex<B>) {
      return length(a_.cast_ray(place, direction, infinity));
    } else {
      if (a_.is_solid() && a_.contains(place)) {
        return length(a_.cast_ray(place, direction, infinity));
      }
      const Pose at{ab_.rotation, ab_.position + move};
      const auto back = UnitVec3::from_unit_unchecked(at.rotation.undo(-direction.vec()));
      return length(b_.cast_ray(at.undo(place), back, infinity));
    }
  }

  void pass_overlaps(WayOut& out) const {
    SmallVector<InTheWay, 64> met;
    const Vec3 d = out.direction;
    const auto add = [&](const Triangle& part, const Part& convex, std::uint32_t index) {
      const Vec3 last = placed_support(convex, place(convex, ab_), -d).point;
      met.push_back({dot(d, part.support(d).point - last) + convex.radius(), part.index(), index});
    };
    if (out.length == 0) {
      for (const Overlap& overlap : at_start_.span()) {
        add(a_.part(overlap.part), other(overlap.other), overlap.other);
      }
    } else {
      visit_overlaps_at({ab_.rotation, ab_.position + out.length * d}, false, add);
    }
    std::ranges::sort(met.span(), [](const InTheWay& a, const InTheWay& b) {
      return std::tuple(-a.clear, a.part, a.other) < std::tuple(-b.clear, b.part, b.other);
    });
    const Real start = out.length;
    for (const InTheWay& each : met.span()) {
      if (each.clear <= out.length && out.length > start) {
        break;
      }
      pass(a_.part(each.part), other(each.other), std::max(each.clear, start) + touching_, start, out);
    }
  }

  // From a way after which the parts have passed back to where they touch.
  void pass(const Triangle& part, const Part& convex, Real clear, Real start, WayOut& out) const {
    Real way = clear;
    Distance found{};
    for (int step = 0; step < most_newton_steps; ++step) {
      const Pose at{ab_.rotation, ab_.position + way * out.direction};
      const Outcome outcome = convex_distance(part, convex, at, settings_, found);
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
  SmallVector<Overlap, 64> at_start_;
};

}  // namespace abut
