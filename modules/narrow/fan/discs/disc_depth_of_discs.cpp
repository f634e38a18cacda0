// SPDX-License-Identifier: Apache-2.0
// Two hulls of discs, added up. Their sum has flat faces, along the axes and where lines of both sides meet, and two
// families of places at which it may be nearest to the origin:
//
// - a side and a rim of the other body: where the rim is deepest under the side, or, beyond the axis, least deep;
// - two rims: where points of both, added up, are nearest to the origin. Only there is the sum curved both ways.
//
// A half plane through the axis of one body shows that body as its outline. A rim of the other is a closed curve there.
// The aim of a walk around the rim is a corner of the outline, or a line of it (rim_walk.cppm).
module abut.narrow.fan.discs.disc_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.discs.rim_walk;

namespace abut {
namespace {

// A line of the outline, or the one across the axis for a rim that is beyond it: a point is
// side + up * z - turn * out * its distance from the axis below it.
struct SideAim {
  Real side, up, out, turn;  // 1, or -1 beyond the axis
  Real from, to;             // where the line begins and ends, along itself

  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number below(Number z, Number distance) const {
    return side + up * z - (turn * out) * distance;
  }
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t lanes_left(const RimPlace<Lanes>& at, Real reach,
                                                                       Real goal) const {
    const Lanes depth = below(at.z, at.out), along = (turn * up) * at.out + out * at.z;
    return signs_of(depth - (goal + reach)) &
           ~(signs_of(depth + reach) | signs_of(along - (from - reach)) | signs_of((to + reach) - along));
  }
  template <class Visit>
  [[gnu::always_inline]] static inline void visit_starts(Visit&& visit) {
    visit_turn(visit);
  }
  // Of the distance from the line beside the axis, times the distance from the axis.
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number slope(const RimCurve<Number>& at) const {
    return out * at.half - (turn * up) * (at.dz * at.out);
  }
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number bend(const RimCurve<Number>& at) const {
    return out * at.d_half - (turn * up) * (at.ddz * at.out + at.dz * at.d_out);
  }
  [[nodiscard]] static inline Real unit_of_speed(Real size) { return size; }
  [[nodiscard]] [[gnu::always_inline]] static inline std::uint64_t lanes_level(const RimPlace<Lanes>& at,
                                                                               Lanes steepest, Real,
                                                                               const DiscDepth& least) {
    return bits_of(steepest <= least.slack() * at.out);
  }
  // The direction turns the faster the nearer the axis is.
  [[nodiscard]] static inline Real shortened(const RimPlace<Real>& at, Real size) { return std::sqrt(at.out / size); }
  [[nodiscard]] inline bool is_deeper(const RimPlace<Real>& at, Real depth) const {
    return below(at.z, at.out) < depth;
  }
  // Away from the axis and along it, of the normal of the sum.
  [[nodiscard]] inline std::pair<Real, Real> normal(const RimPlace<Real>&) const { return {-turn * out, up}; }
};

// A corner of the outline, where z is -height.
struct RimAim {
  Real height, radius;
  Real up, out;  // of the normal of the line, away from the rim's own disc

  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t lanes_left(const RimPlace<Lanes>& at, Real reach,
                                                                       Real goal) const {
    const Lanes along = at.z + height, beyond = at.out - radius, within = out * along + up * beyond;
    return signs_of(along * along + beyond * beyond - (goal + reach) * (goal + reach)) &
           ~(signs_of(reach - beyond) | signs_of(within + reach));
  }
  template <class Visit>
  [[gnu::always_inline]] static inline void visit_starts(Visit&& visit) {
    visit_turn(visit);
  }
  // Of half the square of the distance from the corner, times the distance from the axis.
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number slope(const RimCurve<Number>& at) const {
    return at.out * ((at.z + height) * at.dz) + (at.out - radius) * at.half;
  }
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number bend(const RimCurve<Number>& at) const {
    const Number along = at.z + height;
    return at.d_out * (along * at.dz + at.half) + at.out * (at.dz * at.dz + along * at.ddz) +
           (at.out - radius) * at.d_half;
  }
  [[nodiscard]] static inline Real unit_of_speed(Real size) { return size * size; }
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t lanes_level(const RimPlace<Lanes>& at, Lanes steepest, Real,
                                                                        const DiscDepth& least) const {
    const Lanes along = at.z + height, beyond = at.out - radius;
    return bits_of(steepest <= least.slack() * at.out * root(along * along + beyond * beyond));
  }
  [[nodiscard]] inline Real square(const RimPlace<Real>& at) const {
    const Real along = at.z + height, beyond = at.out - radius;
    return along * along + beyond * beyond;
  }
  // And the nearer the rims are to each other.
  [[nodiscard]] inline Real shortened(const RimPlace<Real>& at, Real size) const {
    return std::sqrt(std::fmin(at.out, std::sqrt(square(at))) / size);
  }
  [[nodiscard]] inline bool is_deeper(const RimPlace<Real>& at, Real depth) const { return square(at) < depth * depth; }
  [[nodiscard]] inline std::pair<Real, Real> normal(const RimPlace<Real>& at) const {
    return {at.out - radius, at.z + height};
  }
};

// The distance beside the axis is a convex function on the whole disc within a walk. So on this side of the axis there
// is at most one point that is looked for: the nearest of all, if it is on the rim. Whether it surely is within.
[[nodiscard]] bool is_nearest_within(const RimWalk& walk, const SideAim& aim) {
  constexpr Real surely = 0.999;
  const Vec3& middle = walk.middle;
  const Real ahead = middle.x * walk.radius, across = middle.y * walk.along_x;
  return ahead * ahead + across * across < surely * walk.radius * walk.radius * walk.along_x * walk.along_x &&
         std::fabs(aim.up * walk.along_z) < surely * aim.out * std::fabs(walk.along_x);
}

// Two bodies to be added up: the rims of one of them, seen from the axis of the other.
struct Sum {
  PlacedDiscs walker, other;
  AxisFrame frame;
  Real size;

  inline void offer(const Vec3& direction, const CoreFeatures& features, DiscDepth& least) const {
    least.offer(walker.reach(direction) + other.reach(direction), direction, features);
  }
  // Where a rim meets what has a tangent, or all lines of a side around their axis. False where the rim leads along it.
  [[nodiscard]] bool offer_across(const Vec3& tangent, const Vec3& other_tangent, Real up, DiscDepth& least) const;
  template <class Aim>
  [[nodiscard]] bool offer_place(const RimWalk& walk, const Aim& aim, const RimPlace<Real>& at, DiscDepth& least) const;
  template <class Aim>
  [[nodiscard]] bool search(const RimWalk& walk, const Aim& aim, DiscDepth& least) const;
  [[nodiscard]] bool search_side(const RimWalk& walk, const RimPlace<Real>& centre, DiscDepth& least) const;
  [[nodiscard]] bool search_rims(const RimWalk& walk, const RimPlace<Real>& centre, DiscDepth& least) const;
};
[[nodiscard]] Sum added(const PlacedDiscs& walker, const PlacedDiscs& other) {
  return {walker, other, frame_along(other.axis, walker.axis), walker.size() + other.size()};
}

bool Sum::offer_across(const Vec3& tangent, const Vec3& other_tangent, Real up, DiscDepth& least) const {
  const AxisFrame across = frame_along(tangent, other_tangent);
  if (!(across.axis_x * across.axis_x > slender_square)) {
    return false;
  }
  across.visit_lines(up, 0, [&](Real x, Real y, Real) { offer(x * across.x + y * across.y, {}, least); });
  return true;
}

// The normal of the sum at a place of the rim. False where there is none.
template <class Aim>
bool Sum::offer_place(const RimWalk& walk, const Aim& aim, const RimPlace<Real>& at, DiscDepth& least) const {
  if (!aim.is_deeper(at, least.depth())) {
    return true;
  }
  const auto in_space = [&](Real x, Real y, Real z) { return x * frame.x + y * frame.y + z * frame.z; };
  const auto tangent = [&] {
    return (1 / walk.radius) *
           cross(walker.axis, in_space(at.x - walk.middle.x, at.y - walk.middle.y, at.z - walk.middle.z));
  };
  const auto [out, up] = aim.normal(at);
  const Real near = near_of(least);
  if (!(at.out > near) && !(walk.radius > 0)) {
    // A tip on the axis is as deep all around. Of these directions one of two leads out of the tip, if any does.
    offer(in_space(out, 0, up), {}, least);
    offer(in_space(-out, 0, up), {}, least);
    return true;
  }
  if (!(at.out > near)) {
    return offer_across(tangent(), other.axis, other.side_up, least);
  }
  const Real share = 1 / at.out;
  if (!(out * out + up * up > near * near)) {
    return offer_across(tangent(), in_space(-share * at.y, share * at.x, 0), 0, least);
  }
  const auto n = UnitVec3::make(in_space(out * share * at.x, out * share * at.y, up));
  if (n) {
    offer(*n, {}, least);
  }
  return n.has_value();
}

template <class Aim>
bool Sum::search(const RimWalk& walk, const Aim& aim, DiscDepth& least) const {
  bool is_proven = true;
  const auto visit = [&](const RimPlace<Real>& at) { is_proven = offer_place(walk, aim, at, least) && is_proven; };
  return walk_around(walk, aim, size, least, visit) && is_proven;
}

// A rim, or a tip, against the side.
bool Sum::search_side(const RimWalk& walk, const RimPlace<Real>& centre, DiscDepth& least) const {
  const auto end_of = [&](std::size_t i) { return other.side_up * other.radius[i] - other.side_out * other.height[i]; };
  const Real from = std::fmin(end_of(0), end_of(1)), to = std::fmax(end_of(0), end_of(1)), touch = least.touch();
  bool is_proven = true;
  for (const Real turn : {1.0, -1.0}) {
    const SideAim aim{other.side(), other.side_up, other.side_out, turn, from - touch, to + touch};
    const Real below = aim.below(centre.z, centre.out);
    const bool is_near = below + walk.radius >= -touch && below - walk.radius < least.goal();
    if (!is_near || (turn > 0 && is_nearest_within(walk, aim))) {
      continue;
    }
    is_proven = (walk.radius > 0 ? search(walk, aim, least) : offer_place(walk, aim, centre, least)) && is_proven;
  }
  return is_proven;
}

// A rim against both rims. A tip and a rim make an edge, where the sum is never nearest.
bool Sum::search_rims(const RimWalk& walk, const RimPlace<Real>& centre, DiscDepth& least) const {
  bool is_proven = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const Real away = i == 0 ? -1 : 1;  // the first disc is below
    const RimAim aim{other.height[i], other.radius[i], away * other.side_up, away * other.side_out};
    const Real up = centre.z + aim.height, far = least.goal() + walk.radius;
    const bool is_near = std::fabs(up) - std::fabs(walk.along_z) < least.goal() && aim.square(centre) < far * far;
    if (is_near && walk.radius > 0 && aim.radius > 0) {
      is_proven = search(walk, aim, least) && is_proven;
    }
  }
  return is_proven;
}

// The rims of the walker against the side of the other body, and, where asked, against its rims.
[[nodiscard]] bool search_rims_of(const Sum& sum, bool with_rims, DiscDepth& least) {
  const PlacedDiscs& other = sum.other;
  const Real bottom = -std::fmax(other.height[0], other.height[1]), top = -std::fmin(other.height[0], other.height[1]);
  bool is_proven = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const RimWalk walk = sum.frame.walk(sum.walker.centre + other.centre, sum.walker, i);
    const RimPlace<Real> centre = middle_of(walk);
    const Real rise = std::fabs(walk.along_z), goal = least.goal();
    if (centre.z - rise <= top + goal && centre.z + rise >= bottom - goal) {
      is_proven = sum.search_side(walk, centre, least) && is_proven;
      is_proven = (!with_rims || sum.search_rims(walk, centre, least)) && is_proven;
    }
  }
  return is_proven;
}

// Flat faces: discs, and where a line of one side and a line of the other meet.
void search_faces(const Sum& sum, DiscDepth& least) {
  // Of the other body, which is not mirrored, the axis leads out of the upper disc.
  sum.offer(sum.other.axis, {core_face(face_against_axis), {}}, least);
  sum.offer(-sum.other.axis, {core_face(face_along_axis), {}}, least);
  sum.offer(sum.walker.axis, {{}, core_face(face_along_axis)}, least);
  sum.offer(-sum.walker.axis, {{}, core_face(face_against_axis)}, least);
  sum.frame.visit_lines(sum.walker.side_up, sum.other.side_up, [&](Real x, Real y, Real z) {
    if (const auto n = UnitVec3::make(x * sum.frame.x + y * sum.frame.y + z * sum.frame.z)) {
      sum.offer(*n, {core_edge(side_of_discs), core_edge(side_of_discs)}, least);
    }
  });
}

// Whether both turn around one axis, but for rounding.
[[nodiscard]] bool is_coaxial(const Sum& sum, Real noise) {
  return largest_magnitude(cross(sum.other.axis, sum.walker.axis)) <= touching_distance(1) &&
         largest_magnitude(cross(sum.other.axis, sum.walker.centre)) <= noise;
}

// Then the sum turns around that axis too, and is as deep all around it: both sides need one direction each.
void search_sides(const Sum& sum, DiscDepth& least) {
  const PlacedDiscs &a = sum.other, &b = sum.walker;
  sum.offer(a.side_out * a.x + a.side_up * a.axis, {}, least);
  sum.offer(b.side_out * a.x + b.side_up * b.axis, {}, least);
}

}  // namespace

void search_discs(const Discs& other, DiscDepth& least) {
  const PlacedDiscs a = placed(other, {0, 0, 0}, {0, 0, 1}), &b = least.discs();
  const Sum sum = added(b, a);
  search_faces(sum, least);
  if (is_coaxial(sum, least.noise())) {
    search_sides(sum, least);
    return;
  }
  if (!(least.goal() > 0) || !search_rims_of(added(a, b), true, least) || !search_rims_of(sum, false, least)) {
    least.give_up();
  }
}

}  // namespace abut
