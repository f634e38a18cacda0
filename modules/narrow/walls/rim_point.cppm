// SPDX-License-Identifier: Apache-2.0
// The rim where the surfaces of two bodies cross: its point near a place, and its point that is nearest to a third body
// or deepest in it. A body is a function from a point to its signed distance, which may have no answer.
export module abut.narrow.walls.rim_point;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

struct RimPoint {
  Vec3 place;
  Vec3 along;  // unit, which way the rim runs
};

// Newton's method leads onto both tangent planes, and along the rim towards the place.
template <class ToFirst, class ToSecond>
[[nodiscard]] std::optional<RimPoint> rim_point_near(const Vec3& place, Real noise, const ToFirst& to_first,
                                                     const ToSecond& to_second) {
  constexpr int steps = 48;
  Vec3 at = place;
  constexpr Real parallel_normals = 1e-12;  // the square of a sine
  for (int step = 0; step < steps; ++step) {
    const std::optional<Distance> first = to_first(at), second = to_second(at);
    if (!first || !second) {
      return std::nullopt;
    }
    const Vec3 &n = first->normal, &m = second->normal;
    const Real cosine = dot(n, m), square = 1 - cosine * cosine;
    if (!(square > parallel_normals)) {
      return std::nullopt;
    }
    const Real to_n = -first->distance, to_m = -second->distance;
    const Vec3 onto = ((to_n - cosine * to_m) / square) * n + ((to_m - cosine * to_n) / square) * m;
    const Vec3 along = UnitVec3::make(cross(n, m)).value_or(UnitVec3::axis_z());
    const Vec3 move = onto + dot(place - at, along) * along;
    at += move;
    if (largest_magnitude(move) <= noise) {
      return RimPoint{at, along};
    }
  }
  return std::nullopt;
}

// A point of a rim, and its distance to a body.
struct RimContact {
  RimPoint rim;
  Distance found;
};

// Follows the rim from one of its points to where the signed distance is least: in steps that double until it rises,
// then between the last two points. `rim_near`: the point of the rim near a place. `to_body`: the distance from a point
// to the body. `reach`: about the size of the body.
template <class RimNear, class ToBody>
[[nodiscard]] RimContact nearest_on_rim(const RimContact& start, Real reach, Real noise, const RimNear& rim_near,
                                        const ToBody& to_body) {
  constexpr int strides = 16, cuts = 48;
  struct Side {
    RimContact contact;
    Real slope;  // of the distance along the rim
  };
  RimContact best = start;
  // The direction of the rim has either sign. Points that are near each other take the same one.
  const auto look = [&](const Vec3& place, const Vec3& forward) -> std::optional<Side> {
    std::optional<RimPoint> rim = rim_near(place);
    if (!rim) {
      return std::nullopt;
    }
    if (dot(rim->along, forward) < 0) {
      rim->along = -rim->along;
    }
    const std::optional<Distance> found = to_body(rim->place);
    if (!found) {
      return std::nullopt;
    }
    const RimContact contact{*rim, *found};
    best = found->distance < best.found.distance ? contact : best;
    return Side{contact, -dot(found->normal, rim->along)};
  };
  Side before{start, -dot(start.found.normal, start.rim.along)};
  if (before.slope > 0) {
    before.contact.rim.along = -before.contact.rim.along;
    before.slope = -before.slope;
  }
  Real stride = -before.slope * (std::fabs(start.found.distance) + reach) / 16;
  std::optional<Side> after;
  for (int i = 0; i < strides && !after && stride * -before.slope > noise; ++i) {
    const RimPoint& rim = before.contact.rim;
    const std::optional<Side> next = look(rim.place + stride * rim.along, rim.along);
    if (next && next->slope > 0) {
      after = next;
    } else if (next && next->contact.found.distance < before.contact.found.distance) {
      before = *next;
      stride *= 2;
    } else {
      // The rim ends or turns within the step.
      stride /= 4;
    }
  }
  for (int i = 0; i < cuts && after; ++i) {
    const RimContact &left = before.contact, &right = after->contact;
    const Vec3 chord = right.rim.place - left.rim.place;
    const Real length = norm(chord), bend = after->slope - before.slope;
    if (!(std::fmax(-before.slope, after->slope) * length > noise)) {
      break;
    }
    // In turn: where the tangents meet, which finds corners at once; where the slope vanishes, which finds round
    // bottoms; the middle, which bounds the work.
    const Real meet = (after->slope + (left.found.distance - right.found.distance) / length) / bend,
               zero = -before.slope / bend;
    const Real cut = i % 3 == 0 ? meet : i % 3 == 1 ? zero : Real{0.5};
    const std::optional<Side> middle =
        look(left.rim.place + std::clamp(cut, Real{0.01}, Real{0.99}) * chord, left.rim.along);
    if (!middle) {
      break;
    }
    if (middle->slope > 0) {
      after = middle;
    } else {
      before = *middle;
    }
  }
  return best;
}

}  // namespace abut
