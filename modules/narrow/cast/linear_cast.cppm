// SPDX-License-Identifier: Apache-2.0
// When two shapes first touch, one of which moves along a line without turning.
export module abut.narrow.cast.linear_cast;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;

export namespace abut {

// A way of some length in a direction.
struct LinearMotion {
  UnitVec3 direction;
  Real length;
};

// The shapes do not touch before this way is travelled. They do at it: within rounding, and no further apart than the
// upper bound of their distance says.
struct FirstTouch {
  Real travelled;
  Distance contact;    // there
  Vec3 normal_before;  // of the last distance found before it, if any
};

// What rounding leaves of coordinates after a way: within it shapes touch.
[[nodiscard]] inline Real touching_after(Real size, Real travelled) { return touching_distance(size + travelled); }

// Newton's method takes a few steps, and one for each bit of the way when the shapes graze each other. Whoever needs
// more than these is stopped before the contact.
inline constexpr std::uint32_t most_cast_steps = 256;

// A point and a triangle have a difference without volume. At distance zero both signs of the normal are as good.
// A shape that came from a distance moved against the normal, not along it.
[[nodiscard]] inline Distance turned_against(const UnitVec3& direction, Distance contact, Real touching) {
  if (std::fabs(contact.distance) <= touching && dot(direction, contact.normal) > 0) {
    contact.normal = -contact.normal;
    contact.distance = -contact.distance;
    contact.lower = -std::exchange(contact.upper, -contact.lower);
  }
  return contact;
}

// The distance of convex shapes is a convex function of the way, with the derivative dot(direction, normal): Newton's
// method from the near side never passes its zero. A step goes to where b reaches the plane between the shapes. No step
// goes too far, whatever the normal is. Source: van den Bergen, "Ray casting against general convex objects with
// application to continuous collision detection", 2004.
//
// b moves. distance_at(way, out): of the shapes after a way. gap_along(normal): how far they are apart along a unit
// vector at the start, least of b less most of a, or -infinity. They touch when they come as near as `margin`.
template <class DistanceAt, class GapAlong>
[[nodiscard]] Outcome first_touch(const LinearMotion& motion, Real size, Real margin, DistanceAt&& distance_at,
                                  GapAlong&& gap_along, std::optional<FirstTouch>& out) {
  Real travelled = 0;
  Distance found{};
  Vec3 normal_before{0, 0, 0};
  for (std::uint32_t step = 0; step < most_cast_steps; ++step) {
    found = {};
    if (const Outcome outcome = distance_at(travelled, found); outcome != Outcome::ok) {
      return outcome;
    }
    const Real touching = touching_after(size, travelled);
    if (!(found.distance - margin > touching)) {
      break;
    }
    normal_before = found.normal;
    const Real approach = -dot(motion.direction, found.normal);
    const Real gap = gap_along(found.normal) - travelled * approach - margin;
    if (gap > touching && approach <= 0) {
      return Outcome::ok;
    }
    const Real certain = std::max(found.lower - margin, Real{0});
    const Real step_length = gap > 0 && approach > 0 ? std::max(certain, gap / approach) : certain;
    if (!(step_length > touching)) {
      break;  // nothing is known of what is left
    }
    const Real left = motion.length - travelled;
    if (step_length > left) {
      // What lies between the shapes at the end of the way.
      if (std::max(gap - left * approach, certain - left) > touching_after(size, motion.length) || left == 0) {
        return Outcome::ok;
      }
      travelled = motion.length;
    } else {
      travelled += step_length;
    }
  }
  const Real touching = touching_after(size, travelled);
  out = FirstTouch{travelled, travelled > 0 ? turned_against(motion.direction, found, touching) : found, normal_before};
  return Outcome::ok;
}

// The part of a way on which a moving box meets one that stands still.
struct Passage {
  Real enter, leave;
};
[[nodiscard]] inline std::optional<Passage> passage_of(const Aabb& still, const Aabb& moving,
                                                       const LinearMotion& motion) {
  Passage passage{0, motion.length};
  const Vec3 direction = motion.direction;
  for (int axis = 0; axis < 3; ++axis) {
    const Real first = still.low[axis] - moving.high[axis], last = still.high[axis] - moving.low[axis];
    if (direction[axis] == 0) {
      if (first > 0 || last < 0) {
        return std::nullopt;
      }
      continue;
    }
    const Real a = first / direction[axis], b = last / direction[axis];
    passage.enter = std::max(passage.enter, std::min(a, b));
    passage.leave = std::min(passage.leave, std::max(a, b));
  }
  return passage.enter <= passage.leave ? std::optional(passage) : std::nullopt;
}

// The box around a box on a part of its way.
[[nodiscard]] inline Aabb swept(const Aabb& box, const LinearMotion& motion, Real begin, Real end) {
  return box.swept(begin * motion.direction.vec(), end * motion.direction.vec());
}

// The same for shapes that are not convex, on a part of the way that begins without a touch: no step is longer than the
// lower bound of the distance, nor shorter than a stride. A stride that ends in a touch is halved until rounding is
// left. A touch that comes and goes within a stride is not seen. An upper bound of infinity says that nothing is there
// that could be touched, and then the distance is only a lower bound.
inline constexpr int most_halvings = 64;

template <class DistanceAt>
[[nodiscard]] Outcome first_touch_by_strides(const Passage& passage, Real size, Real margin, Real stride,
                                             DistanceAt&& distance_at, std::optional<FirstTouch>& out) {
  const Real touching = touching_after(size, passage.leave);
  const auto touches = [&](const Distance& found) {
    return found.upper < infinity && found.distance - margin <= touching;
  };
  Distance found{};
  Real travelled = passage.enter, before = passage.enter;
  for (;;) {
    if (const Outcome outcome = distance_at(travelled, found); outcome != Outcome::ok) {
      return outcome;
    }
    if (touches(found)) {
      break;
    }
    if (!(travelled < passage.leave)) {
      return Outcome::ok;
    }
    before = travelled;
    travelled = std::min(travelled + std::max(found.lower - margin, stride), passage.leave);
  }
  Real after = travelled;
  for (int halving = 0; halving < most_halvings && after - before > touching; ++halving) {
    const Real middle = 0.5 * (before + after);
    Distance between{};
    if (const Outcome outcome = distance_at(middle, between); outcome != Outcome::ok) {
      return outcome;
    }
    if (touches(between)) {
      after = middle;
      found = between;
    } else {
      before = middle;
    }
  }
  out = FirstTouch{before, found, found.normal};
  return Outcome::ok;
}

}  // namespace abut
