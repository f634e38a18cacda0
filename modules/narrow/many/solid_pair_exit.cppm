// SPDX-License-Identifier: Apache-2.0
// How far a surface has to move along a direction until it is out of another one, where either is a solid. A place
// where it is out is looked for in growing steps. From there it comes back until it touches, so that it overlaps
// nothing at the end of the way.
export module abut.narrow.many.solid_pair_exit;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cast.triangle_passage;
import abut.narrow.convex;
import abut.narrow.many.solid_exit;
import abut.narrow.many.triangle_contacts;
import abut.narrow.many.two_parts;
import abut.trees.two_trees;

export namespace abut {

template <Enclosing A, Enclosing B>
class SolidPairExit {
 public:
  SolidPairExit(const A& a, const B& b, const Pose& ab, const QuerySettings& settings)
      : a_(a),
        b_(b),
        ab_(ab),
        settings_(settings),
        touching_(touching_of_solids(a.aabb(Pose::identity()), b.aabb(ab))) {}

  // Lengths below this are rounding.
  [[nodiscard]] Real touching() const { return touching_; }

  // A place of b inside, or of a inside b, after a move; none where both are outside. Their surfaces do not cross.
  [[nodiscard]] std::optional<Vec3> place_inside(const Vec3& move) const {
    const Pose at = moved_by(move);
    if (a_.is_solid()) {
      const Aabb box = a_.aabb(Pose::identity());
      for (const Vec3& piece : b_.pieces()) {
        const Vec3 place = at * piece;
        if (box.overlaps({place, place}) && a_.contains(place)) {
          return place;
        }
      }
    }
    if (b_.is_solid()) {
      const Aabb box = b_.aabb(Pose::identity());
      for (const Vec3& piece : a_.pieces()) {
        const Vec3 local = at.undo(piece);
        if (box.overlaps({local, local}) && b_.contains(local)) {
          return piece;
        }
      }
    }
    return std::nullopt;
  }

  // Whether triangles of both overlap after a move.
  [[nodiscard]] bool do_cross(const Vec3& move) const {
    const Pose at = moved_by(move);
    bool is_met = false;
    visit_two_parts(a_, b_, at, 0, [&](const Triangle& part, const Triangle& other) {
      const CoreSeparation core = separate_from_triangle(part, other, at, settings_, 0);
      is_met = is_met || (!core.beyond && core.distance < -touching_);
      return is_met ? -infinity : Real{0};
    });
    return is_met;
  }
  // Whether b is out after a way. What touches from inside is inside just before.
  [[nodiscard]] bool is_out(const Vec3& direction, Real length) const {
    return !do_cross(length * direction) && !place_inside((length - 4 * touching_) * direction);
  }

  // The end of a way along a direction, which is first looked for at the length `first`. Beyond `enough` only the place
  // is tried where both have surely passed each other.
  [[nodiscard]] WayOut along(const UnitVec3& direction, Real first, Real enough) const {
    const Vec3 d = direction;
    const Real clear = clear_along(d);
    Real out = std::max(first, least_share * clear);
    for (; out < clear && !is_out(d, out); out *= growth) {
      if (out >= enough) {
        out = clear;
      }
    }
    return back_from(d, std::min(out, clear));
  }

  // How far b has to go along a direction until it has passed all of a, rounded up to 24 bits: of parts that end nearly
  // at one height it depends on the trees which one is asked.
  [[nodiscard]] Real clear_along(const Vec3& d) const {
    constexpr int bits = 24;
    const Real high_a = -lowest_of(a_, -d), low_b = lowest_of(b_, ab_.rotation.undo(d)) + dot(d, ab_.position);
    const Real clear = std::max(high_a - low_b, Real{0}) + touching_;
    const Real step = std::ldexp(1.0, std::ilogb(clear) - bits);
    return std::ceil(clear / step) * step;
  }

 private:
  static constexpr Real growth = 1.5, least_share = 1.0 / 128;

  [[nodiscard]] Pose moved_by(const Vec3& move) const { return {ab_.rotation, ab_.position + move}; }

  // From a place that is out, along the way back, until triangles touch.
  [[nodiscard]] WayOut back_from(const Vec3& d, Real length) const {
    const Pose at = moved_by(length * d);
    Real travelled = length;
    WayOut out{d, length, at * b_.aabb(Pose::identity()).centre(), d, no_index};
    std::uint32_t other = no_index;
    const PassageOrder order(a_.origin(), b_.origin(), at, -d, touching_);
    visit_two(a_, b_, order, travelled, [&](std::uint32_t of_a, std::uint32_t of_b) {
      const TriangleCorners local = b_.corners(of_b);
      const TriangleCorners placed{at * local[0], at * local[1], at * local[2]};
      const auto passage = passage_of_triangles(a_.corners(of_a), placed, -d, travelled, 0);
      if (passage && std::tuple(passage->enter, of_a, of_b) < std::tuple(travelled, out.part, other)) {
        travelled = passage->enter;
        out.part = of_a;
        out.normal = UnitVec3::make(passage->normal).value_or(UnitVec3::from_unit_unchecked(d));
        other = of_b;
      }
      return travelled;
    });
    out.length = length - std::min(travelled, length);
    if (out.part != no_index) {
      Distance touch{};
      const Pose end = moved_by(out.length * d);
      if (convex_distance(a_.part(out.part), b_.part(other), end, settings_, touch) == Outcome::ok) {
        out.point = touch.point_a;
      }
    }
    return out;
  }

  const A& a_;
  const B& b_;
  const Pose& ab_;
  const QuerySettings& settings_;
  Real touching_;
};

}  // namespace abut
