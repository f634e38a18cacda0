// Two hulls of discs, added up. Their sum has flat faces, along the axes and where lines of both sides meet, and two
// families of places at which it may be nearest to the origin:
// - A side and a rim of the other body: where the rim is deepest under the side, or, beyond the axis, least deep.
// - Two rims: where points of both, added up, are nearest to the origin. Only there is the sum curved both ways; it can
// be
//   nearest where it is curved less than the ball around the origin, and then it is the surface of all those sums
//   around.
// Seen in the half plane through the axis of one body, that body is its outline and a rim of the other a closed curve.
// Asked for is where that curve is nearest to a corner of the outline, or to its axis beside a line (rim_walk.cppm).
module abut.narrow.fan.disc_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.fan.rim_walk;

namespace abut {
namespace {

// The line of the outline, or the one across the axis, where a rim that comes from there is beyond it: a point is
// side + up * z - turn * out * its distance from the axis below it.
struct SideAim {
  Real side, up, out, turn;  // 1 or -1: beyond the axis
  Real from, to;             // where the line begins and ends, along itself

  [[nodiscard]] inline Real below(Real z, Real distance) const { return side + up * z - turn * out * distance; }
  // A bit for each arc that may hold what is looked for, whose ends are as far from its middle.
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t lanes_left(const RimPlace<Lanes>& at, Real reach,
                                                                       Real goal) const {
    const Lanes below = side + up * at.z - (turn * out) * at.out, along = (turn * up) * at.out + out * at.z;
    return signs_of(below - (goal + reach)) &
           ~(signs_of(below + reach) | signs_of(along - (from - reach)) | signs_of((to + reach) - along));
  }
  // Below zero where the distance from the line beside the axis falls, by a factor above zero; and the derivative of
  // that.
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number slope(const RimCurve<Number>& at) const {
    return out * at.half - (turn * up) * (at.dz * at.out);
  }
  template <class Number>
  [[nodiscard]] [[gnu::always_inline]] inline Number bend(const RimCurve<Number>& at) const {
    return out * at.d_half - (turn * up) * (at.ddz * at.out + at.dz * at.d_out);
  }
  [[nodiscard]] static inline Real unit_of_slope(Real size) { return size * size; }
  // What share of the usual last step is short enough: the direction turns the faster the nearer the axis is.
  [[nodiscard]] static inline Real shortened(const RimPlace<Real>& at, Real size) { return std::sqrt(at.out / size); }
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
  [[nodiscard]] static inline Real unit_of_slope(Real size) { return size * size * size; }
  // And the nearer the rims are to each other.
  [[nodiscard]] inline Real shortened(const RimPlace<Real>& at, Real size) const {
    const Real along = at.z + height, beyond = at.out - radius;
    return std::sqrt(std::fmin(at.out, std::sqrt(along * along + beyond * beyond)) / size);
  }
  [[nodiscard]] inline std::pair<Real, Real> normal(const RimPlace<Real>& at) const {
    return {at.out - radius, at.z + height};
  }
};

struct Pair {
  Real x, y;
};

// The distance beside the axis is a convex function on the whole disc within a walk, so that on this side of the axis
// there is at most one point of those that are looked for: the nearest of all, if it has the gradient across the rim.
// Whether it has not.
[[nodiscard]] bool is_nearest_within(const RimWalk& walk, const SideAim& aim) {
  const Vec3& middle = walk.middle;
  const Real ahead = middle.x * walk.radius, across = middle.y * walk.along_x;
  return ahead * ahead + across * across < 0.999 * walk.radius * walk.radius * walk.along_x * walk.along_x &&
         std::fabs(aim.up * walk.along_z) < 0.999 * aim.out * std::fabs(walk.along_x);
}
// That point, by Newton's method; nothing where it is not found.
[[nodiscard]] std::optional<RimPlace<Real>> nearest_on_rim(const RimWalk& walk, const SideAim& aim,
                                                           const RimPlace<Real>& middle, Real size) {
  constexpr int rounds = 8;
  constexpr Real longest_step = 0.7;
  // The gradient within the disc, times the radius, where there is one.
  const auto slope_within = [&](const RimPlace<Real>& at) {
    const Real scale = at.out > 0 ? aim.out / at.out : 0;
    return Pair{scale * at.x * walk.along_x - aim.up * walk.along_z, scale * at.y * walk.radius};
  };
  const Pair start = slope_within(middle);
  const Real length = std::sqrt(start.x * start.x + start.y * start.y);
  if (!(length > 0)) {
    return std::nullopt;
  }
  Real cosine = -start.x / length, sine = -start.y / length;
  for (int round = 0; round < rounds; ++round) {
    const RimPlace<Real> at = point_at(walk, cosine, sine);
    if (!(at.out > 0)) {
      return std::nullopt;
    }
    const RimCurve<Real> curve = curve_at(walk, at, cosine, sine);
    const Real slope = aim.slope(curve), bend = aim.bend(curve);
    const Real turn = bend > 0 ? -slope / bend : std::copysign(longest_step, -slope);
    const Real step = std::fmin(std::fmax(turn, -longest_step), longest_step), scale = 1 / std::sqrt(1 + step * step);
    const Real next = scale * (cosine - step * sine);
    sine = scale * (sine + step * cosine);
    cosine = next;
    if (std::fabs(turn) < last_step * aim.shortened(at, size)) {
      const Pair gradient = slope_within(at);
      const bool is_across = gradient.x * cosine + gradient.y * sine < -1e-6 * walk.radius;
      return is_across ? std::optional(point_at(walk, cosine, sine)) : std::nullopt;
    }
  }
  return std::nullopt;
}

// The point of a walk nearest to the point of the axis at -height.
[[nodiscard]] RimPlace<Real> nearest_to_tip(const RimWalk& walk, Real height) {
  const Real ahead = walk.middle.x * walk.along_x + (walk.middle.z + height) * walk.along_z,
             across = walk.middle.y * walk.radius;
  const Real length = std::sqrt(ahead * ahead + across * across);
  return length > 0 ? point_at(walk, -ahead / length, -across / length) : point_at(walk, Real{1}, Real{0});
}

// Two bodies to be added up, and the least distance of the sum from the origin so far.
struct Sum {
  PlacedDiscs a, b;
  Real size;

  inline void offer(const Vec3& direction, const CoreFeatures& features, DiscDepth& least) const {
    least.offer(a.reach(direction) + b.reach(direction), direction, features);
  }
};

// Flat faces: discs, and where a line of one side and a line of the other meet.
void search_faces(const Sum& sum, DiscDepth& least) {
  const PlacedDiscs &a = sum.a, &b = sum.b;
  // Of the first body, which is not mirrored, the axis leads out of the upper disc.
  sum.offer(a.axis, {core_face(face_against_axis), {}}, least);
  sum.offer(-a.axis, {core_face(face_along_axis), {}}, least);
  sum.offer(b.axis, {{}, core_face(face_along_axis)}, least);
  sum.offer(-b.axis, {{}, core_face(face_against_axis)}, least);
  // Directions n with a.axis . n = a.side_up and b.axis . n = b.side_up, in terms of both axes and what is across them.
  const Vec3 across = cross(a.axis, b.axis);
  const Real square = squared_norm(across), cosine = dot(a.axis, b.axis);
  if (!(square > 0)) {
    return;  // lines along each other end in rims
  }
  // The difference of both parts would lose digits where the axes are nearly parallel.
  const Real turn = std::copysign(Real{1}, cosine), shared = (a.side_up - turn * b.side_up) / square,
             apart = turn / (1 + std::fabs(cosine));
  const Real along_a = shared + apart * b.side_up, along_b = apart * a.side_up - turn * shared;
  const Real rest = 1 - (along_a * a.side_up + along_b * b.side_up);
  if (rest < 0) {
    return;
  }
  const Real aside = std::sqrt(rest / square);
  for (const Real side : {aside, -aside}) {
    if (const auto n = UnitVec3::make(along_a * a.axis + along_b * b.axis + side * across)) {
      sum.offer(*n, {core_edge(side_of_discs), core_edge(side_of_discs)}, least);
    }
  }
}

// Rims of one body against the side of the other, and, where asked, against its rims.
[[nodiscard]] bool search_walks(const Sum& sum, const PlacedDiscs& walker, const PlacedDiscs& other, bool with_rims,
                                DiscDepth& least) {
  const Vec3& z = other.axis;
  const Vec3 y = UnitVec3::make(cross(z, walker.axis)).value_or(UnitVec3::from_unit_unchecked(tangents_of(z).first));
  const Vec3 x = cross(y, z), along = cross(y, walker.axis);
  const Real bottom = -std::fmax(other.height[0], other.height[1]), top = -std::fmin(other.height[0], other.height[1]);
  const auto end_of = [&](std::size_t i) { return other.side_up * other.radius[i] - other.side_out * other.height[i]; };
  const std::array<Real, 2> ends{end_of(0), end_of(1)};
  const Real slack = least.touch();
  bool is_proven = true;
  const auto offer = [&](const std::pair<Real, Real>& normal, const RimPlace<Real>& at) {
    const auto [out, up] = normal;
    // Rims that cross, and a rim that meets the axis, have no normal there.
    const Real near = std::fmax(5e4 * least.noise(), least.touch());
    if (!(out * out + up * up > near * near) || !(at.out > near)) {
      is_proven = false;
      return;
    }
    const Real scale = out / at.out;
    if (const auto n = UnitVec3::make((scale * at.x) * x + (scale * at.y) * y + up * z)) {
      sum.offer(*n, {}, least);
    } else {
      is_proven = false;
    }
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 middle = walker.centre + walker.height[i] * walker.axis + other.centre;
    const Real radius = walker.radius[i];
    const RimWalk walk{
        {dot(middle, x), dot(middle, y), dot(middle, z)}, radius, radius * dot(along, x), radius * dot(along, z)};
    const RimPlace<Real> centre{walk.middle.x, walk.middle.y, walk.middle.z,
                                std::sqrt(walk.middle.x * walk.middle.x + walk.middle.y * walk.middle.y)};
    const Real rise = std::fabs(walk.along_z), goal = least.goal();
    if (centre.z - rise > top + goal || centre.z + rise < bottom - goal) {
      continue;
    }
    const auto aim_at = [&](const auto& aim) {
      const auto visit = [&](const RimPlace<Real>& at) { offer(aim.normal(at), at); };
      if (radius > 0) {
        is_proven = walk_around(walk, aim, sum.size, least, visit) && is_proven;
      } else {
        visit(centre);
      }
    };
    for (const Real turn : {1.0, -1.0}) {
      const SideAim side{other.side(),
                         other.side_up,
                         other.side_out,
                         turn,
                         std::fmin(ends[0], ends[1]) - slack,
                         std::fmax(ends[0], ends[1]) + slack};
      const Real below = side.below(centre.z, centre.out);
      if (!(below + radius >= -slack && below - radius < goal) || (turn > 0 && is_nearest_within(walk, side))) {
        continue;
      }
      if (const auto nearest = turn > 0 ? nearest_on_rim(walk, side, centre, sum.size) : std::nullopt) {
        offer(side.normal(*nearest), *nearest);
      } else {
        aim_at(side);
      }
    }
    for (std::size_t j = 0; j < 2 && with_rims; ++j) {
      const Real away = j == 0 ? -1 : 1;  // the first disc is below
      const RimAim rim{other.height[j], other.radius[j], away * other.side_up, away * other.side_out};
      const Real up = centre.z + rim.height, out = centre.out - rim.radius, far = goal + radius;
      if (std::fabs(up) - rise >= goal || up * up + out * out >= far * far) {
        continue;
      }
      if (rim.radius > 0) {
        aim_at(rim);
      } else {
        const RimPlace<Real> at = nearest_to_tip(walk, rim.height);
        offer(rim.normal(at), at);
      }
    }
  }
  return is_proven;
}

}  // namespace

void search_discs(const Discs& other, DiscDepth& least) {
  const PlacedDiscs a = placed(other, {0, 0, 0}, {0, 0, 1}), &b = least.discs();
  const auto size_of = [](const PlacedDiscs& discs) {
    return largest_magnitude(discs.centre) + std::fabs(discs.height[0]) + discs.radius[0] + discs.radius[1];
  };
  const Sum sum{a, b, size_of(a) + size_of(b)};
  search_faces(sum, least);
  if (!(least.goal() > 0) || !search_walks(sum, a, b, true, least) || !search_walks(sum, b, a, false, least)) {
    least.give_up();
  }
}

}  // namespace abut
