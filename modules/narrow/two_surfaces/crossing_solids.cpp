// SPDX-License-Identifier: Apache-2.0
// Two surfaces of which one or both are solids: what of one is inside of the other one, and how it gets out.
//
// Two solids use the search for any two surfaces. If no triangles cross but a point of one lies inside the other, the
// translation goes on to the surface of that solid. Separating axes give the length at which two triangles touch,
// without a search.
module abut.narrow.two_surfaces.crossing_surfaces;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.two_surfaces.leaving_pairs;
import abut.narrow.two_surfaces.placed_triangles;
import abut.narrow.ways.translation_search;
import abut.narrow.surface.triangle_source;

namespace abut {

bool CrossingSurfaces::has_solid() const {
  return source_a_.sides() == StoppingSides::solid || source_b_.sides() == StoppingSides::solid;
}
bool CrossingSurfaces::do_boxes_overlap(const Vec3& move) const {
  const Vec3 shared = minimum(box_a_.high, box_b_.high + move) - maximum(box_a_.low, box_b_.low + move);
  const Vec3 thinner = minimum(box_a_.high - box_a_.low, box_b_.high - box_b_.low);
  const Vec3 least = minimum(thinner, 4 * touching_ * Vec3{1, 1, 1});
  return minimum(shared, least) == least;
}
Real CrossingSurfaces::depth_in_a(const Vec3& place) const {
  return source_a_.contains(place) ? source_a_.nearest(place).distance : 0;
}
Real CrossingSurfaces::depth_in_b(const Vec3& place) const {
  const Vec3 local = ab_.undo(place);
  return source_b_.contains(local) ? source_b_.nearest(local).distance : 0;
}

std::optional<CrossingSurfaces::PointInside> CrossingSurfaces::point_inside(const Vec3& direction, Real length) const {
  const Vec3 move = length * direction;
  if (!has_solid() || !do_boxes_overlap(move)) {
    return std::nullopt;
  }
  const auto piece = piece_inside(move);
  return piece ? piece : flush_inside(direction, length);
}

std::optional<CrossingSurfaces::PointInside> CrossingSurfaces::piece_inside(const Vec3& move) const {
  if (source_a_.sides() == StoppingSides::solid) {
    for (const Vec3& piece : source_b_.pieces()) {
      if (const Vec3 place = ab_ * piece + move; depth_in_a(place) > tolerance_) {
        return PointInside{place, place, false};
      }
    }
  }
  if (source_b_.sides() == StoppingSides::solid) {
    for (const Vec3& piece : source_a_.pieces()) {
      if (depth_in_b(piece - move) > tolerance_) {
        return PointInside{piece, piece, true};
      }
    }
  }
  return std::nullopt;
}

// Where faces of solids lie in each other, or end at each other, triangles touch but do not cross, although both share
// a volume. Then triangles that touch have a side in both.
std::optional<CrossingSurfaces::PointInside> CrossingSurfaces::flush_inside(const Vec3& direction, Real length) const {
  const Vec3 move = length * direction;
  std::optional<PointInside> found;
  std::uint32_t last = no_index;
  // What is near may lie between a touch and a piece that is inside.
  visit_near(a_, b_, {direction, length}, tie(), [&](const PlacedTriangle& a, const PlacedTriangle& b) {
    if (std::exchange(last, a.number) != a.number) {
      found = flush_inside(a, true, move);
    }
    found = found ? found : flush_inside(b, false, move);
    return !found;
  });
  return found;
}
// In the middle, and near the corners.
std::optional<CrossingSurfaces::PointInside> CrossingSurfaces::flush_inside(const PlacedTriangle& triangle,
                                                                            bool is_of_a, const Vec3& move) const {
  constexpr Real beside_share = 1e-6;  // of the size
  const SurfaceSource &own = is_of_a ? source_a_ : source_b_, &other = is_of_a ? source_b_ : source_a_;
  if (other.sides() != StoppingSides::solid) {
    return std::nullopt;
  }
  const auto& [p, q, r] = triangle.corners;
  const Vec3 beside = beside_share * size_ * triangle.part().normal();
  const auto is_in = [&](const SurfaceSource& surface, bool is_a, const Vec3& place) {
    return surface.contains(is_a ? place : ab_.undo(place - move));
  };
  for (const auto& [of_p, of_q, of_r] :
       {std::tuple(1 / 3., 1 / 3., 1 / 3.), {.8, .1, .1}, {.1, .8, .1}, {.1, .1, .8}}) {
    const Vec3 point = of_p * p + of_q * q + of_r * r + (is_of_a ? Vec3{0, 0, 0} : move);
    const bool before = is_in(other, !is_of_a, point + beside), behind = is_in(other, !is_of_a, point - beside);
    if (own.sides() != StoppingSides::solid) {
      if (before && behind) {
        return PointInside{point, point, is_of_a};
      }
    } else if (before && is_in(own, is_of_a, point + beside)) {
      return PointInside{point, point + beside, is_of_a};
    } else if (behind && is_in(own, is_of_a, point - beside)) {
      return PointInside{point, point - beside, is_of_a};
    }
  }
  return std::nullopt;
}

void CrossingSurfaces::look_inside() {
  set_reaches({0, 0, 0});
  const auto inside = point_inside({0, 0, 0}, 0);
  if (!inside) {
    return;
  }
  is_inside_ = true;
  const Vec3 local = ab_.undo(inside->place);
  const Vec3 way = inside->is_of_a ? ab_.rotation * (local - source_b_.nearest(local).point)
                                   : source_a_.nearest(inside->place).point - inside->place;
  least_ = std::max(norm(way) - norm(inside->place - inside->point), 0.0);
  deepest_way_ = UnitVec3::make(way).value_or(UnitVec3::from_unit_unchecked(deepest_way_));
}

bool CrossingSurfaces::leave_inside(const Vec3& direction, Real enough, SurfaceExit& exit) {
  const Vec3 move = exit.length * direction;
  const auto inside = point_inside(direction, exit.length);
  if (!inside) {
    return false;
  }
  const auto way = inside->is_of_a
                       ? source_b_.way_to_surface(ab_.undo(inside->place - move), -ab_.rotation.undo(direction))
                       : source_a_.way_to_surface(inside->place, direction);
  if (!way) {
    exit.stop({direction, infinity, {}});
    return true;
  }
  const Vec3 normal = inside->is_of_a ? -(ab_.rotation * way->normal) : way->normal;
  // Until the point itself is where the place beside it reaches the surface.
  const Vec3 ahead = inside->is_of_a ? inside->point - inside->place : inside->place - inside->point;
  const Real further = way->length + dot(normal, ahead) / dot(normal, direction);
  const SurfaceTouch touch{normal, exit.length + std::max(further, tolerance_), {}};
  if (touch.length >= enough - tolerance_) {
    exit.stop(touch);
    return true;
  }
  // Where a corner reaches the surface from inside, triangles only touch. They overlap just after.
  SurfaceExit after;
  after.length = touch.length + 8 * tolerance_;
  const Real start = after.length;
  static_cast<void>(leave_those_ahead(direction, enough, after));
  if (after.length > start) {
    exit = after;
  } else {
    static_cast<void>(exit.note(touch, tie()));
  }
  return true;
}

// The points that are last to part lay deep before.
Real CrossingSurfaces::least_by(const SeparatingTranslation& translation) {
  const auto last = has_solid() ? last_pair(translation) : std::nullopt;
  if (!last) {
    return 0;
  }
  const Vec3 of_b = last_point_of(last->a.corners, last->b.corners, translation.direction, last->length),
             of_a = of_b + translation.length * translation.direction;
  const Real least = std::max(depth_in_a(of_b), depth_in_b(of_a));
  return std::max(least, climb(0.5 * (of_a + of_b), translation.length));
}
Real CrossingSurfaces::climb(Vec3 place, Real most) const {
  constexpr int most_steps = 4;
  Real best = 0;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 local = ab_.undo(place);
    if (!source_a_.contains(place) || !source_b_.contains(local)) {
      break;
    }
    const PointOnSurface of_a = source_a_.nearest(place), of_b = source_b_.nearest(local);
    const Real sum = of_a.distance + of_b.distance;
    if (sum <= best) {
      break;
    }
    best = sum;
    const auto unit = [](const Vec3& way) {
      return UnitVec3::make(way).value_or(UnitVec3::from_unit_unchecked({0, 0, 0}));
    };
    place += 0.25 * (most - sum) * (unit(place - of_a.point).vec() + unit(ab_.rotation * (local - of_b.point)).vec());
  }
  return best;
}

// What was inside may reach the surface with a whole face, without crossing it.
void CrossingSurfaces::visit_faces_met(const SeparatingTranslation& translation, const TakeTouched& take) const {
  constexpr Real least_along = 1e-6;  // of a normal, along the way
  visit_near(a_, b_, {translation.direction, translation.length}, tie(),
             [&](const PlacedTriangle& a, const PlacedTriangle& b) {
               const Vec3 of_a = a.part().normal(), of_b = b.part().normal();
               const Real along = dot(of_a, translation.direction), cosine = dot(of_a, of_b);
               if (std::fabs(cosine) > same_normal && std::fabs(along) > least_along) {
                 const Vec3 normal = along > 0 ? of_a : -of_a;
                 take({a, b, normal, dot(normal, a.corners[0] - b.corners[0]) / std::fabs(along)});
               }
               return true;
             });
}

}  // namespace abut
