// SPDX-License-Identifier: Apache-2.0
// Conservative advancement that is as quick as Newton's method near the touch.
//
// A round finds the distance at a time, and with it a separating direction. Then a later time is proposed: where the
// gap along the direction is closed by the present speed. The gap along a direction is the least of many smooth
// functions, one for each two points. The second derivative of each is bounded. So two values of the gap prove the time
// between them free, or some of it. What the bound takes away shrinks with the square of the time.
//
// Far away the direction stays as it is. Near the touch it turns as the features turn that span it: as a face of one
// part does, or across two edges. Otherwise each corner of a face that turns would count as an approach.
module abut.motion.impacts.convex_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.math.turn;
import abut.pairs.taken_apart.convex_part;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.narrow.apart.gjk;
import abut.narrow.cores.simplex;

namespace abut {
namespace {

// How two parts lie at a time.
struct Placed {
  Pose a, b;
};

// A direction from a to b that turns around an axis across it.
struct Direction {
  Vec3 normal;
  Vec3 turning;  // an axis times a speed

  [[nodiscard]] Vec3 after(Real time) const {
    return squared_norm(turning) > 0 ? rotation_by(time * turning) * normal : normal;
  }
};

// What is known at the begin of a round.
struct Separation {
  Distance distance;  // in the world
  Direction direction;
  Real approach;   // how fast the distance shrinks
  Real following;  // how fast the direction turns with edges and faces; what is left follows the nearest points
};

// What bounds the motion of both parts within the whole span: the sum of the speeds of turning, each times the reach of
// its part, the same of the accelerations, and those of the centres.
struct Bounds {
  Real turning, turning_change;
  Vec3 acceleration;
  Real change;
};
Bounds bounds_of(const MovingPart& a, const MovingPart& b, const TimeSpan& span) {
  const auto times = [](Real factor, Real reach) { return factor > 0 ? factor * reach : 0; };
  const Vec3 acceleration = b.path->motion().acceleration - a.path->motion().acceleration;
  return {times(a.path->largest_turning(span), a.reach.radius) + times(b.path->largest_turning(span), b.reach.radius),
          times(a.path->largest_turning_acceleration(span), a.reach.radius) +
              times(b.path->largest_turning_acceleration(span), b.reach.radius),
          acceleration, norm(acceleration)};
}

bool is_identity(const Pose& pose) {
  const Rotation& turned = pose.rotation;
  return pose.position == Vec3{0, 0, 0} && turned.x == Vec3{1, 0, 0} && turned.y == Vec3{0, 1, 0};
}

Real radii_of(const MovingPair& pair) { return pair.a.part.radius() + pair.b.part.radius(); }
Placed placed_at(const MovingPair& pair, Real time) { return {pair.a.at(time), pair.b.at(time)}; }

// How far b is from a along a unit vector.
Real gap_along(const ConvexPart& a, const ConvexPart& b, const Pose& at_a, const Pose& at_b, const Vec3& normal) {
  const Vec3 on_a = at_a * a.support(at_a.rotation.undo(normal)).point;
  const Vec3 on_b = at_b * b.support(at_b.rotation.undo(-normal)).point;
  return dot(normal, on_b - on_a) - a.radius() - b.radius();
}

// The same less the margin and what rounding may add.
Real gap_along(const MovingPair& pair, const Placed& placed, const Vec3& normal) {
  return gap_along(pair.a.part, pair.b.part, placed.a, placed.b, normal) - pair.settings.margin -
         rounding_of(pair.settings.size);
}

// More than all coordinates on the way. No core point is further from its centre than twice the extent.
Real size_on_path(const PassingPart& its) {
  return 2 * (largest_magnitude(its.path.start().position) + largest_magnitude(its.path.centre_at(0)) +
              largest_magnitude(its.path.shift_at(its.path.duration())) + largest_magnitude(its.part.centre()) +
              2 * its.part.extent() + its.part.radius());
}

// The velocity of a point of a body in the world.
Vec3 velocity_of(const Path& path, const Vec3& point, Real time) {
  return path.velocity_at(time) + cross(path.turning_at(time), point - path.centre_at(time));
}

// How the direction n turns that a simplex spans: it stays across the edges of the simplex. Where it may still turn
// around them, it follows the nearest points.
struct Change {
  Vec3 with_edges, with_points;
};
Change change_of_normal(const Vec3& n, std::span<const Vec3> points, std::span<const Vec3> velocities,
                        const Vec3& velocity, Real distance) {
  const Vec3 none{0, 0, 0};
  if (points.size() == 3) {
    const Vec3 first = points[0] - points[2], second = points[1] - points[2];
    const Real along_first = -dot(n, velocities[0] - velocities[2]);
    const Real along_second = -dot(n, velocities[1] - velocities[2]);
    const Vec3 change = along_first * cross(second, n) + along_second * cross(n, first);
    return {(1 / dot(n, cross(first, second))) * change, none};
  }
  const Vec3 away = (-1 / distance) * (velocity - dot(velocity, n) * n);
  const auto edge = points.size() == 2 ? UnitVec3::make(points[0] - points[1]) : std::nullopt;
  if (!edge) {
    return {none, away};
  }
  const Real along = -dot(n, velocities[0] - velocities[1]) / norm(points[0] - points[1]);
  return {along * edge->vec(), away - dot(away, *edge) * edge->vec()};
}

// In the world, from a search in the frame of a. `time`: of the velocities.
Separation separation_of(const MovingPair& pair, const Placed& placed, const GjkResult& found, Real time) {
  Separation out{};
  const Rotation& turned = placed.a.rotation;
  const Vec3 n = turned * found.normal;
  const std::array<Real, 3> weights = weights_of(found.simplex, found.closest);
  std::array<Vec3, 3> points{}, velocities{};  // of the difference a - b
  Vec3 velocity{0, 0, 0}, on_a{0, 0, 0};
  const std::size_t size = std::min<std::size_t>(found.simplex.size, 3);
  for (std::size_t i = 0; i < size; ++i) {
    const DifferenceVertex& vertex = found.simplex.vertices[i];
    const Vec3 of_a = placed.a * vertex.a, difference = turned * vertex.w;
    points[i] = difference;
    velocities[i] = velocity_of(*pair.a.path, of_a, time) - velocity_of(*pair.b.path, of_a - difference, time);
    velocity += weights[i] * velocities[i];
    on_a += weights[i] * of_a;
  }
  const Change change =
      change_of_normal(n, std::span(points).first(size), std::span(velocities).first(size), velocity, found.upper);
  const Vec3 turning = cross(n, change.with_edges + change.with_points);
  const Vec3 on_b = on_a + found.upper * n;
  out.distance = {found.upper - radii_of(pair),
                  found.lower - radii_of(pair),
                  found.upper - radii_of(pair),
                  on_a + pair.a.part.radius() * n,
                  on_b - pair.b.part.radius() * n,
                  n,
                  Algorithm::gjk_epa,
                  found.iterations};
  const bool is_known = is_finite(turning);
  out.direction = {n, is_known ? turning : Vec3{0, 0, 0}};
  out.approach = dot(n, velocity);
  out.following = is_known ? norm(change.with_edges) : 0;
  return out;
}

// How much the ways of any two points along a direction that stays are bent at most.
Real bend_of_still(const MovingPair& pair, const Vec3& normal, const TimeSpan& span) {
  return pair.b.path->largest_acceleration_along(normal, span, pair.b.reach) +
         pair.a.path->largest_acceleration_along(-normal, span, pair.a.reach);
}

// The same along a direction n that turns with the speed v. The gap of two points at x apart is n.x, and its second
// derivative n.x'' + 2 n'.x' - v^2 n.x. The last term only counts where the gap is negative.
Real bend_of_turning(const MovingPair& pair, const Bounds& bounds, const Separation& begin, Real gap, Real time,
                     Real length) {
  const Path &a = *pair.a.path, &b = *pair.b.path;
  const Vec3 velocity = b.velocity_at(time) - a.velocity_at(time);
  const Vec3& n = begin.direction.normal;
  const Real turning = norm(begin.direction.turning), turn = turning * length, speed = norm(velocity);
  const Real gained = length * bounds.change;
  const Real across = norm(velocity - dot(velocity, n) * n) + turn * speed + gained + bounds.turning;
  const Real away = norm(b.centre_at(time) - a.centre_at(time)) + pair.a.reach.radius + pair.b.reach.radius +
                    radii_of(pair) + length * (speed + gained);
  const Real deepest = std::max(length * (speed + gained + bounds.turning + turning * away) - gap, Real{0});
  constexpr Real outward = 1 + 1e-13;
  return outward * (dot(n, bounds.acceleration) + bounds.change * turn + bounds.turning_change + 2 * turning * across +
                    turning * turning * deepest) +
         rounding_of(bounds.change);
}

// How far ahead to look, and along which direction.
struct Proposal {
  Real length, bend;
  Vec3 turning;
};

Proposal propose(const MovingPair& pair, const Bounds& bounds, const Separation& begin, Real gap,
                 const TimeSpan& rest) {
  const Real aim = std::max(gap - 0.5 * pair.settings.tolerance, 0.5 * gap);
  const Real wish = std::min(rest.length(), begin.approach > 0 ? aim / begin.approach : infinity);
  // A gap that is halved by its bend is left a half.
  const auto longest = [&](Real bend) { return bend > 0 ? std::sqrt(4 * gap / bend) : infinity; };

  const Real still = bend_of_still(pair, begin.direction.normal, rest);
  const Real lost = begin.following * (pair.a.reach.radius + pair.b.reach.radius) + std::max(begin.approach, Real{0});
  const Real while_still = std::min(wish, longest(still));
  if (!(squared_norm(begin.direction.turning) > 0) || lost * while_still <= 0.5 * gap) {
    return {while_still, still, {0, 0, 0}};
  }
  const auto bend_for = [&](Real length) { return bend_of_turning(pair, bounds, begin, gap, rest.begin, length); };
  const Real first_guess = std::min(wish, longest(bend_for(wish)));
  const Real turning = bend_for(first_guess), while_turning = std::min(wish, longest(turning));
  if (while_turning < std::min(while_still, gap / lost)) {
    return {while_still, still, {0, 0, 0}};
  }
  return {first_guess, turning, begin.direction.turning};
}

// A time up to which the parts are certainly apart, and how they lie then.
struct Reached {
  Real time;
  Placed placed;
};

// From a time at which they are.
Reached advance(const MovingPair& pair, const Bounds& bounds, const Placed& placed, const Separation& begin, Real time,
                Real end) {
  const Real gap = gap_along(pair, placed, begin.direction.normal);
  if (!(gap > 0)) {
    return {time, placed};
  }
  const Proposal ahead = propose(pair, bounds, begin, gap, {time, end});
  const Real next = ahead.length < end - time ? time + ahead.length : end;
  const Placed placed_then = placed_at(pair, next);
  const Vec3 normal = Direction{begin.direction.normal, ahead.turning}.after(next - time);
  const Real share = free_share(gap, gap_along(pair, placed_then, normal), ahead.bend, next - time);
  if (share < 1) {
    const Real reached = time + share * (next - time);
    return {reached, placed_at(pair, reached)};
  }
  return {next, placed_then};
}

}  // namespace

MovingPart moving_part(const ConvexPart& part, const Path& path, const Pose& local) {
  return moving_part(part, path, local, part.aabb(local));
}

MovingPart moving_part(const ConvexPart& part, const Path& path, const Pose& local, const Aabb& box) {
  return {part, &path, local, path.reach_of(box.inflated(-part.radius())), is_identity(local)};
}

Real free_share(Real at_begin, Real at_end, Real bend, Real length) {
  const Real half = 0.5 * bend * length * length;
  if (half <= 0 && at_end > 0) {
    return 1;
  }
  // The first zero of begin + (end - begin - half) s + half s^2.
  const Real slope = at_end - at_begin - half, discriminant = slope * slope - 4 * half * at_begin;
  if (discriminant < 0) {
    return 1;
  }
  const Real divisor = std::sqrt(discriminant) - slope;
  constexpr Real inward = 1 - 1e-12;
  const Real zero = 2 * at_begin / divisor;
  return divisor > 0 && zero <= 1 ? inward * zero : 1;
}

Real free_until(const PassingPart& a, const PassingPart& b, Real margin) {
  const TimeSpan span = a.path.whole();
  const Pose &start_a = a.path.start(), &start_b = b.path.start();
  const Vec3 centre_a = start_a * a.part.centre(), centre_b = start_b * b.part.centre(), first = centre_b - centre_a;
  const Real middle = 0.5 * span.end;
  const Vec3 way = span.end * (velocity_of(b.path, centre_b, middle) - velocity_of(a.path, centre_a, middle));
  const Real along = squared_norm(way), nearest = along > 0 ? std::clamp<Real>(-dot(first, way) / along, 0, 1) : 0;
  const Real kept = margin + rounding_of(size_on_path(a) + size_on_path(b));
  const auto free_along = [&](const Vec3& direction) {
    const auto normal = UnitVec3::make(direction);
    const Real gap = normal ? gap_along(a.part, b.part, start_a, start_b, *normal) - kept : 0;
    if (!(gap > 0)) {
      return Real{0};
    }
    const Real bend = b.path.largest_acceleration_along(*normal, span, b.reach) +
                      a.path.largest_acceleration_along(-*normal, span, a.reach);
    return free_share(gap, gap_along(a.part, b.part, a.end, b.end, *normal) - kept, bend, span.end);
  };
  Real share = free_along(first + nearest * way);
  if (share < 1 && nearest > 0) {
    share = std::max(share, free_along(first));
  }
  return share * span.end;
}

Real gap_along_at(const MovingPair& pair, const Vec3& normal, Real time) {
  const Placed placed = placed_at(pair, time);
  return gap_along(pair.a.part, pair.b.part, placed.a, placed.b, normal) - pair.settings.margin;
}

// The gap may shrink by a share of the tolerance, which is more than rounding takes from it.
std::optional<Real> parting_time(const MovingPair& pair, const Vec3& normal, const TimeSpan& span) {
  constexpr int most_halvings = 60;
  constexpr Real spare_share = 0.25;
  const Real tolerance = pair.settings.tolerance, begin = gap_along_at(pair, normal, span.begin);
  const Real spare = std::max(-begin, Real{0}) + spare_share * tolerance;
  const Real bend = bend_of_still(pair, normal, span);
  Real end = span.end;
  for (int i = 0; i < most_halvings && end > span.begin; ++i) {
    const Real gap = gap_along_at(pair, normal, end);
    const bool has_parted = gap > tolerance || end == span.end;
    if (has_parted && free_share(begin + spare, gap + spare, bend, end - span.begin) >= 1) {
      return end;
    }
    end = span.begin + 0.5 * (end - span.begin);
  }
  return std::nullopt;
}

Impact convex_impact(const MovingPair& pair, const TimeSpan& span) {
  const ConvexPart &a = pair.a.part, &b = pair.b.part;
  const ImpactSettings& settings = pair.settings;
  const Bounds bounds = bounds_of(pair.a, pair.b, span);
  Impact out;
  Real time = span.begin;
  Placed placed = placed_at(pair, time);
  Vec3 toward{0, 0, 0};
  for (; out.rounds < settings.most_rounds; ++out.rounds) {
    const Pose ab = relative(placed.a, placed.b);
    const Vec3 guess = out.rounds == 0 ? ab * b.centre() - a.centre() : placed.a.rotation.undo(toward);
    const GjkResult found = gjk(a, b, ab, guess, settings.size, 0.25 * settings.tolerance, infinity);
    out.lower = time;
    if (found.overlap || !(found.lower - radii_of(pair) - settings.margin > 0)) {
      out.state = out.rounds == 0 ? ImpactState::starts_together : ImpactState::touches;
      out.upper = time;
      if (!found.overlap) {
        out.contact = separation_of(pair, placed, found, time).distance;
      }
      return out;
    }
    const Separation now = separation_of(pair, placed, found, time);
    toward = now.direction.normal;
    if (now.distance.upper - settings.margin <= settings.tolerance) {
      out.state = out.rounds == 0 ? ImpactState::starts_together : ImpactState::touches;
      out.upper = time;
      out.contact = now.distance;
      return out;
    }
    const Reached next = advance(pair, bounds, placed, now, time, span.end);
    if (!(next.time < span.end)) {
      out.state = ImpactState::apart;
      out.lower = out.upper = span.end;
      return out;
    }
    if (!(next.time > time)) {
      break;
    }
    time = next.time;
    placed = next.placed;
  }
  out.state = ImpactState::undecided;
  out.lower = time;
  out.upper = span.end;
  return out;
}

}  // namespace abut
