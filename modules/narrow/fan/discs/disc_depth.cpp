// SPDX-License-Identifier: Apache-2.0
// An edge of a polytope and discs, added up: the edge sweeps the outline that the discs have along it.
// - A line of the side and the edge span a face.
// - A rim is nearest to the origin where its distance from the line of the edge is least.
module abut.narrow.fan.discs.disc_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.discs.rim_walk;

namespace abut {

PlacedDiscs placed(const Discs& discs, const Vec3& centre, const Vec3& axis) {
  const Real out = 2 * discs.half_height, up = discs.bottom - discs.top, length = norm({out, up, 0});
  const Tangents across = tangents_of(axis);
  return {centre,
          axis,
          across.first,
          across.second,
          {-discs.half_height, discs.half_height},
          {discs.bottom, discs.top},
          length > 0 ? out / length : 1,
          length > 0 ? up / length : 0};
}

PlacedDiscs mirrored(const Discs& discs, const Vec3& centre, const Vec3& axis) {
  return placed({discs.half_height, discs.bottom, discs.top}, -centre, axis);
}

Vec3 normal_of_side(const PlacedDiscs& discs, const Vec3& point) {
  const Sideways out = discs.across(point);
  const Vec3 normal = discs.side_up * discs.axis - discs.side_out * (out.x * discs.x + out.y * discs.y);
  return UnitVec3::make(normal).value_or(UnitVec3::from_unit_unchecked(discs.axis));
}

namespace {

// The line of an edge, along Z through the origin, seen from a rim.
struct EdgeAim {
  Vec2 after_left, before_right;  // directions between the normals of both faces have a part along each
  std::optional<Vec2> middle;     // of the part of the rim whose normals are between, if that is a third of a turn
  Real axis, up, away;            // the rim supports where away * (axis * x - up * distance) is above zero

  [[nodiscard]] inline bool is_between(Real x, Real y) const {
    return after_left.x * x + after_left.y * y > 0 && before_right.x * x + before_right.y * y > 0;
  }
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t lanes_left(const RimPlace<Lanes>& at, Real reach,
                                                                       Real goal) const {
    const Lanes left = after_left.x * at.x + after_left.y * at.y, right = before_right.x * at.x + before_right.y * at.y;
    const Lanes supports = (away * axis) * at.x - (away * up) * at.out;
    return signs_of(at.out - (goal + reach)) & ~signs_of(minimum(minimum(left, right), 0.5 * supports) + reach);
  }
  template <class Visit>
  [[gnu::always_inline]] inline void visit_starts(Visit&& visit) const {
    if (middle) {
      visit(middle->x, middle->y);
    } else {
      visit_turn(visit);
    }
  }
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number slope(const RimCurve<Number>& at) const {
    return at.half;
  }
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number bend(const RimCurve<Number>& at) const {
    return at.d_half;
  }
  [[nodiscard]] static inline Real unit_of_speed(Real size) { return size; }
  [[nodiscard]] [[gnu::always_inline]] static inline std::uint64_t lanes_level(const RimPlace<Lanes>& at, Lanes slope,
                                                                               Real angle, const DiscDepth& least) {
    const Real near = near_of(least);
    return bits_of(slope <= least.slack() * at.out) |
           bits_of(at.out * at.out + (2 * angle) * slope <= all_lanes(near * near));
  }
  [[nodiscard]] static inline Real shortened(const RimPlace<Real>& at, Real size) { return std::sqrt(at.out / size); }
};

// The middle of the angles of a rim at which its normals lie between two directions across an edge. Nothing where they
// are more than a third of a turn apart.
[[nodiscard]] inline std::optional<Vec2> middle_between(const AxisFrame& frame, const Vec3& left, const Vec3& right) {
  const auto place_toward = [&](const Vec3& n) -> Vec2 {
    const Real x = frame.axis_z * dot(n, frame.x), y = dot(n, frame.y), square = x * x + y * y;
    const Real scale = square > 0 ? 1 / std::sqrt(square) : infinity;  // without a place nothing is between
    return {scale * x, scale * y};
  };
  const Vec2 sum = place_toward(left) + place_toward(right);
  const Real square = dot(sum, sum);
  if (!(square > 1)) {
    return std::nullopt;
  }
  return (1 / std::sqrt(square)) * sum;
}

// Whether nothing between the directions of both faces and one in the middle is below the goal: of each two, the chord
// between their feet belongs to the difference.
[[nodiscard]] bool is_above_chords(const EdgeOfFaces& edge, const DiscDepth& least) {
  const Vec3 sum = edge.left + edge.right;
  const Vec3 middle = squared_norm(sum) > slender_square ? sum : cross(edge.along, edge.left);  // of a flat polytope
  const Vec3 foot = edge.from + least.discs().support(middle);
  const auto is_above = [&](const Vec3& from, const Vec3& to) {
    const Vec3 chord = to - from;
    const Real reach = dot(edge.along, cross(from, chord));
    return reach >= 0 && reach * reach >= least.goal() * least.goal() * squared_norm(cross(chord, edge.along));
  };
  return is_above(edge.from + edge.left_foot, foot) && is_above(foot, edge.from + edge.right_foot);
}

}  // namespace

void search_edge(const EdgeOfFaces& edge, DiscDepth& least) {
  if (!(least.goal() > 0)) {
    least.give_up();  // without a common ball there is nothing to come near to
    return;
  }
  if (is_above_chords(edge, least)) {
    return;
  }
  const PlacedDiscs& discs = least.discs();
  const Vec3 z = (1 / norm(edge.along)) * edge.along, corner = edge.from + discs.centre;
  const AxisFrame frame = frame_along(z, discs.axis);
  const Vec3 after_left = cross(z, edge.left), before_right = cross(edge.right, z);
  EdgeAim aim{{dot(after_left, frame.x), dot(after_left, frame.y)},
              {dot(before_right, frame.x), dot(before_right, frame.y)},
              middle_between(frame, edge.left, edge.right),
              frame.axis_x,
              discs.side_up,
              0};
  const auto offer = [&](Real x, Real y, const CoreFeatures& features) {
    if (aim.is_between(x, y)) {
      const Vec3 n = x * frame.x + y * frame.y;
      least.offer(dot(edge.from, n) + discs.reach(n), n, features);
    }
  };
  frame.visit_lines(discs.side_up, 0,
                    [&](Real x, Real y, Real) { offer(x, y, {edge.feature, core_edge(side_of_discs)}); });
  const Real near = near_of(least), size = discs.size() + largest_magnitude(edge.from);
  for (std::size_t i = 0; i < 2; ++i) {
    const RimWalk walk = frame.walk(corner, discs, i);
    if (!(walk.radius > 0)) {
      continue;  // a tip and an edge make an edge
    }
    aim.away = i == 0 ? -1 : 1;
    const auto visit = [&](const RimPlace<Real>& at) {
      Real x = at.x, y = at.y;
      if (!(at.out > near)) {
        // Where the rim meets the line of the edge its own normal is the one.
        x = at.x - walk.middle.x;
        y = (at.y - walk.middle.y) * (frame.axis_z * frame.axis_z);
      }
      const Real square = x * x + y * y;
      if (square > 0) {
        const Real scale = 1 / std::sqrt(square);
        offer(scale * x, scale * y, {});
      }
    };
    if (!walk_around(walk, aim, size, least, visit)) {
      least.give_up();
      return;
    }
  }
}

}  // namespace abut
