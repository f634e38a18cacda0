module abut.narrow.fan.disc_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;

namespace abut {
namespace {

struct Flat {
  Real x, y;
};
[[nodiscard]] inline Flat operator-(const Flat& a, const Flat& b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Real dot(const Flat& a, const Flat& b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline Real cross(const Flat& a, const Flat& b) { return a.x * b.y - a.y * b.x; }

// The support of the shadow of the polyhedron and one of the discs along a direction.
struct FlatSupport {
  Flat direction;
  Flat foot;   // the point that reaches furthest
  Real depth;  // how far
  Real slope;  // of the depth, as the direction turns
  Real bend;   // radius of curvature there
};

class Shadow {
 public:
  Shadow(const PlacedDiscs& discs, const EdgeArc& arc)
      : discs_(discs),
        corner_{arc.corner_x, arc.corner_y},
        axis_{arc.axis_x, arc.axis_y},
        along_square_(arc.axis_along * arc.axis_along) {}

  // `side`: which of the points of a disc that is across the direction: the first one as the direction turns, or the
  // last.
  [[nodiscard]] inline FlatSupport support(std::size_t disc, const Flat& direction, Real side) const {
    const Real up = dot(axis_, direction), turn = cross(direction, axis_), height = discs_.height[disc],
               radius = discs_.radius[disc];
    const Real square = along_square_ + turn * turn, out = std::sqrt(square);
    const Real lean = out > 0 ? turn / out : side * up;
    const Real depth = dot(corner_, direction) + height * up + radius * out;
    const Real slope = cross(direction, corner_) + height * turn - radius * up * lean;
    const Real bend = out > 0 ? radius * along_square_ / (square * out) : 0;
    return {direction,
            {depth * direction.x - slope * direction.y, depth * direction.y + slope * direction.x},
            depth,
            slope,
            bend};
  }
  // The disc that reaches further along a direction of any length.
  [[nodiscard]] inline std::size_t disc_toward(const Flat& direction) const {
    const Real up = dot(axis_, direction), turn = cross(direction, axis_);
    const Real out = std::sqrt(along_square_ * dot(direction, direction) + turn * turn);
    return discs_.height[0] * up + discs_.radius[0] * out > discs_.height[1] * up + discs_.radius[1] * out ? 0 : 1;
  }
  // Where the supporting disc or the trend of the curvature may change: across the side, along the axis and across it.
  // Tells which of them are across the side.
  template <class Visit>
  inline void visit_seams(Visit&& visit) const {
    const Real square = dot(axis_, axis_);
    if (!(square > 0)) {
      return;
    }
    const Real length = std::sqrt(square);
    const Flat up{axis_.x / length, axis_.y / length}, aside{-up.y, up.x};
    const auto visit_pair = [&](Real along, Real across, bool is_side) {
      visit(Flat{along * up.x + across * aside.x, along * up.y + across * aside.y}, is_side);
      visit(Flat{along * up.x - across * aside.x, along * up.y - across * aside.y}, is_side);
    };
    const Real along = discs_.side_up / length;
    visit_pair(0, 1, along == 0);
    visit(up, false);
    visit({-up.x, -up.y}, false);
    if (along != 0 && std::fabs(along) < 1) {
      visit_pair(along, std::sqrt((1 - along) * (1 + along)), true);
    }
  }

 private:
  PlacedDiscs discs_;
  Flat corner_, axis_;
  Real along_square_;
};

[[nodiscard]] inline bool is_between(const Flat& from, const Flat& direction, const Flat& to) {
  return cross(from, direction) > 0 && cross(direction, to) > 0;
}
[[nodiscard]] inline Flat unit(const Flat& a) {
  const Real scale = 1 / std::sqrt(dot(a, a));
  return {scale * a.x, scale * a.y};
}

struct Stretch {
  FlatSupport from, to;
};

// Where the slope vanishes that is negative at one end and positive at the other, by Newton's method within what is
// left.
[[nodiscard]] inline FlatSupport level_between(const Shadow& shadow, std::size_t disc, Stretch rest, FlatSupport at,
                                               Real noise) {
  constexpr int rounds = 64;
  for (int round = 0; round < rounds && std::fabs(at.slope) > noise; ++round) {
    (at.slope < 0 ? rest.from : rest.to) = at;
    const Real rise = at.bend - at.depth, turn = rise > 0 ? -at.slope / rise : 0;
    Flat next = unit({at.direction.x - turn * at.direction.y, at.direction.y + turn * at.direction.x});
    if (!(rise > 0) || !is_between(rest.from.direction, next, rest.to.direction)) {
      next = unit({rest.from.direction.x + rest.to.direction.x, rest.from.direction.y + rest.to.direction.y});
      if (!is_between(rest.from.direction, next, rest.to.direction)) {
        break;
      }
    }
    at = shadow.support(disc, next, 1);
  }
  return at;
}

inline constexpr std::size_t seam_limit = 8;
inline constexpr int cut_limit = 256;

// Between two seams one disc supports, its shadow is smooth, and its radius of curvature rises or falls. Let d be the
// least depth so far, and h the depth, not less at both ends. h + h'' is the radius.
// - The chord between the feet of both ends lies in the shadow: nothing is less than the distance of its line.
// - Where the radius is at most d + e, h - d is not below -e / 2 between ends at or above zero, as far as a quarter of
// a turn.
// - Where it is at least d, h - d is not below zero on either side of a level place where it is not, as far as a
// quarter of a turn. (Comparison theorem of Sturm.) What is neither is divided.
[[nodiscard]] bool search_between(const Shadow& shadow, const EdgeArc& arc, std::size_t disc, const Stretch& whole,
                                  DiscDepth& least) {
  const auto offer = [&](const FlatSupport& found) {
    least.offer(found.depth, found.direction.x * arc.x + found.direction.y * arc.y);
  };
  offer(whole.from);
  offer(whole.to);
  [[clang::uninitialized]] std::array<Stretch, 64> rest;
  std::size_t count = 1;
  rest[0] = whole;
  for (int cuts = 0; count > 0; ++cuts) {
    // Without a common ball there is nothing to divide by.
    if (cuts > cut_limit || count == rest.size() || !(least.goal() > 0)) {
      return false;
    }
    const Stretch stretch = rest[--count];
    const auto& [from, to] = stretch;
    const Flat chord = to.foot - from.foot;
    const Real square = dot(chord, chord), least_bend = from.bend < to.bend ? from.bend : to.bend;
    const Real round = 2 * least.depth() - least.goal();
    if (least.is_excluded(cross(from.foot, chord), square) || (from.bend <= round && to.bend <= round)) {
      continue;
    }
    const bool is_level_at_most_once = least_bend >= least.depth();
    if (is_level_at_most_once && (from.slope >= 0 || to.slope <= 0)) {
      continue;
    }
    const Real length = std::sqrt(square);
    Flat across{chord.y / length, -chord.x / length};
    if (!is_between(from.direction, across, to.direction)) {
      across = unit({from.direction.x + to.direction.x, from.direction.y + to.direction.y});
      if (!is_between(from.direction, across, to.direction)) {
        continue;  // less than a rounding apart
      }
    }
    const FlatSupport cut = shadow.support(disc, across, 1);
    if (is_level_at_most_once) {
      offer(level_between(shadow, disc, stretch, cut, least.noise()));
      continue;
    }
    offer(cut);
    rest[count++] = {from, cut};
    rest[count++] = {cut, to};
  }
  return true;
}

}  // namespace

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

void DiscDepth::search(const EdgeArc& arc) {
  const Shadow shadow(discs_, arc);
  [[clang::uninitialized]] std::array<Flat, seam_limit + 2> seams;
  std::size_t count = 0;
  const Flat start{1, 0}, end{arc.end_x, arc.end_y};
  seams[count++] = start;
  const auto insert = [&](const Flat& seam, bool is_side) {
    if (is_between(start, seam, end)) {
      if (is_side) {
        const Real depth = shadow.support(shadow.disc_toward(seam), seam, 1).depth;
        offer(depth, seam.x * arc.x + seam.y * arc.y, {arc.edge, core_edge(side_of_discs)});
      }
      std::size_t place = count++;
      for (; cross(seam, seams[place - 1]) > 0; --place) {
        seams[place] = seams[place - 1];
      }
      seams[place] = seam;
    }
  };
  shadow.visit_seams(insert);
  if (arc.end_x < 0) {
    insert({0, 1}, false);
  }
  seams[count++] = end;
  for (std::size_t i = 1; i < count; ++i) {
    const Flat &from = seams[i - 1], &to = seams[i];
    const std::size_t disc = shadow.disc_toward({from.x + to.x, from.y + to.y});
    if (!search_between(shadow, arc, disc, {shadow.support(disc, from, 1), shadow.support(disc, to, -1)}, *this)) {
      give_up();
      return;
    }
  }
}

void search_edge(std::size_t number, const Vec3& from, const Vec3& along, const Vec3& left, const Vec3& right,
                 DiscDepth& least) {
  const PlacedDiscs& discs = least.discs();
  const Vec3 edge = (1 / norm(along)) * along;
  const Vec3 x = UnitVec3::make(left - dot(left, edge) * edge).value_or(UnitVec3::from_unit_unchecked(left));
  const Vec3 y = cross(edge, x), corner = from + discs.centre;
  const Real end_x = dot(right, x), end_y = dot(right, y), length = std::sqrt(end_x * end_x + end_y * end_y);
  least.search({x, y, end_x / length, end_y / length, dot(corner, x), dot(corner, y), dot(discs.axis, x),
                dot(discs.axis, y), dot(discs.axis, edge), core_edge(number)});
}

void search_box(const Vec3& half, DiscDepth& least) {
  const PlacedDiscs& discs = least.discs();
  const Vec3 &axis = discs.axis, &centre = discs.centre;
  const auto component = [](Vec3& v, int i) -> Real& { return i == 0 ? v.x : i == 1 ? v.y : v.z; };
  // Faces. Of each the point of the discs that reaches furthest.
  std::array<std::array<Vec3, 2>, 3> feet;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1, k = 3 - i - j;
    const Real out = std::sqrt(axis[j] * axis[j] + axis[k] * axis[k]), per_out = out > least_aside ? 1 / out : 0;
    for (std::size_t side = 0; side < 2; ++side) {
      const Real sign = side == 0 ? -1 : 1, up = sign * axis[i];
      const Real first = discs.height[0] * up + discs.radius[0] * out,
                 second = discs.height[1] * up + discs.radius[1] * out;
      const std::size_t disc = first > second ? 0 : 1;
      const Real along = discs.height[disc] - discs.radius[disc] * up * per_out;
      Vec3 foot = centre + along * axis;
      component(foot, i) = centre[i] + sign * (first > second ? first : second);
      feet[static_cast<std::size_t>(i)][side] = foot;
      Vec3 normal{0, 0, 0};
      component(normal, i) = sign;
      least.offer(half[i] + sign * foot[i], normal, {core_face(2 * static_cast<std::size_t>(i) + side), {}});
    }
  }
  // Ends of the discs.
  const Vec3 reach = {half.x * std::fabs(axis.x), half.y * std::fabs(axis.y), half.z * std::fabs(axis.z)};
  const Real along = dot(centre, axis), span = reach.x + reach.y + reach.z,
             top = std::fmax(discs.height[0], discs.height[1]);
  least.offer(span + along + top, axis, {{}, core_face(face_along_axis)});
  least.offer(span - along + top, -axis, {{}, core_face(face_against_axis)});
  // The side against corners.
  const Real side = discs.side();
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 p = centre + Vec3{(corner & 1) != 0 ? half.x : -half.x, (corner & 2) != 0 ? half.y : -half.y,
                                 (corner & 4) != 0 ? half.z : -half.z};
    const Real out_x = dot(p, discs.x), out_y = dot(p, discs.y);
    const Real spare = side + discs.side_up * dot(p, axis) - least.depth();
    const Real square = out_x * out_x + out_y * out_y;
    if (discs.side_out * discs.side_out * square < spare * std::fabs(spare)) {
      continue;
    }
    // Only the corner that reaches furthest along the normal counts. Beside the axis its signs need no unit vector.
    const Vec3 toward = square > least_aside * least_aside ? (discs.side_up * std::sqrt(square)) * axis -
                                                                 discs.side_out * (out_x * discs.x + out_y * discs.y)
                                                           : normal_of_side(discs, p);
    if (((corner & 1) != 0) != (toward.x >= 0) || ((corner & 2) != 0) != (toward.y >= 0) ||
        ((corner & 4) != 0) != (toward.z >= 0)) {
      continue;
    }
    const Vec3 u = normal_of_side(discs, p);
    const Real depth =
        half.x * std::fabs(u.x) + half.y * std::fabs(u.y) + half.z * std::fabs(u.z) + dot(centre, u) + side;
    least.offer(depth, u);
  }
  // Edges. Of one without length no direction across it is a minimum.
  for (int i = 0; i < 3; ++i) {
    if (half[i] == 0) {
      continue;
    }
    const int j = i == 2 ? 0 : i + 1, k = 3 - i - j;
    for (unsigned sides = 0; sides < 4; ++sides) {
      const std::size_t side_j = sides & 1, side_k = sides >> 1;
      const Real sign_j = side_j == 0 ? -1 : 1, sign_k = side_k == 0 ? -1 : 1;
      const Vec3 &from = feet[static_cast<std::size_t>(j)][side_j], &to = feet[static_cast<std::size_t>(k)][side_k];
      const Flat foot{half[j] + sign_j * from[j], half[k] + sign_k * from[k]};
      const Flat chord{sign_j * (to[j] - from[j]), sign_k * (to[k] - from[k])};
      if (least.is_excluded(cross(foot, chord), dot(chord, chord))) {
        continue;
      }
      Vec3 x{0, 0, 0}, y{0, 0, 0};
      component(x, j) = sign_j;
      component(y, k) = sign_k;
      least.search({x, y, 0, 1, half[j] + sign_j * centre[j], half[k] + sign_k * centre[k], sign_j * axis[j],
                    sign_k * axis[k], axis[i], core_edge(static_cast<std::size_t>(i))});
    }
  }
}

void search_triangle(const std::array<Vec3, 3>& corners, const Vec3& normal, DiscDepth& least) {
  const PlacedDiscs& discs = least.discs();
  const auto offer = [&](const Vec3& u, const CoreFeatures& features) {
    const Real reach = std::fmax(dot(corners[0], u), std::fmax(dot(corners[1], u), dot(corners[2], u)));
    least.offer(reach + discs.reach(u), u, features);
  };
  offer(normal, {core_face(1), {}});
  offer(-normal, {core_face(0), {}});
  offer(discs.axis, {{}, core_face(face_along_axis)});
  offer(-discs.axis, {{}, core_face(face_against_axis)});
  for (const Vec3& corner : corners) {
    offer(normal_of_side(discs, corner + discs.centre), {});
  }
  // Across an edge from the normal of one side outward, and on to that of the other.
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 along = corners[i == 2 ? 0 : i + 1] - corners[i];
    const Vec3 outward = *UnitVec3::make(cross(along, normal));
    search_edge(i, corners[i], along, normal, outward, least);
    search_edge(i, corners[i], along, outward, -normal, least);
  }
}

}  // namespace abut
