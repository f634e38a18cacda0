// SPDX-License-Identifier: Apache-2.0
// The first touch of two convex parts that move and turn.
export module abut.motion.impacts.convex_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.taken_apart.convex_part;
import abut.motion.paths.path;
import abut.motion.time_of_impact;

export namespace abut {

// A convex part of a body, where it is on the body, and how the body moves.
struct [[gsl::Pointer]] MovingPart {
  ConvexPart part;
  const Path* path;  // which outlives it
  Pose local;
  Reach reach;  // of the core
  bool has_frame_of_body;

  [[nodiscard]] Pose at(Real time) const { return has_frame_of_body ? path->at(time) : path->at(time) * local; }
};
[[nodiscard]] MovingPart moving_part(const ConvexPart& part, const Path& path [[clang::lifetimebound]],
                                     const Pose& local);
// The same where the box of the part in the frame of the body is known.
[[nodiscard]] MovingPart moving_part(const ConvexPart& part, const Path& path [[clang::lifetimebound]],
                                     const Pose& local, const Aabb& box);

// What holds for all parts of two bodies.
struct ImpactSettings {
  Real size;  // of the coordinates on the way
  Real tolerance, margin;
  std::uint32_t most_rounds;
};

struct MovingPair {
  MovingPart a, b;
  ImpactSettings settings;
};

// A convex part on its path: what is known of it before any search.
struct [[gsl::Pointer]] PassingPart {
  const ConvexPart& part;  // in the frame of the body
  const Path& path;
  Reach reach;      // of its core; of what does not turn it has no say
  const Pose& end;  // of the path
};
// A time of both paths up to which two parts are certainly further apart than a margin, along one direction: from
// centre to centre, at the start or when these are nearest to each other on straight ways. Most that do not touch are
// apart along the latter all the time, and this takes less than a search. 0 where it does not tell.
[[nodiscard]] Real free_until(const PassingPart& a, const PassingPart& b, Real margin);

// Within a span of time, in the frame of the paths. Of parts that overlap at its begin the contact says nothing.
[[nodiscard]] Impact convex_impact(const MovingPair& pair, const TimeSpan& span);

// From a time at which two parts touch, or overlap within rounding, with the plane across a unit vector between them: a
// time up to which they certainly do not overlap any further. The parts are further apart than the tolerance then, or
// it is the end of the span. Nothing where the parts approach.
[[nodiscard]] std::optional<Real> parting_time(const MovingPair& pair, const Vec3& normal, const TimeSpan& span);

// How far b is from a along a unit vector at a time, less the margin.
[[nodiscard]] Real gap_along_at(const MovingPair& pair, const Vec3& normal, Real time);

// How much of a time is certainly free, from 0 to 1, by a gap that is positive at its begin. The way of every point is
// bent by at most `bend`. So the gap is above the straight line between its ends less bend / 2 * t * (length - t).
[[nodiscard]] Real free_share(Real at_begin, Real at_end, Real bend, Real length);

}  // namespace abut
