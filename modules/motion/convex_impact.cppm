// SPDX-License-Identifier: Apache-2.0
// The first touch of two convex parts that move and turn.
export module abut.motion.convex_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.convex_part;
import abut.motion.path;
import abut.motion.time_of_impact;

export namespace abut {

// A convex part of a body, where it is on the body, and how the body moves.
struct MovingPart {
  ConvexPart part;
  Path path;
  Pose local;
  Reach reach;  // of the core

  [[nodiscard]] Pose at(Real time) const { return path.at(time) * local; }
};
[[nodiscard]] MovingPart moving_part(const ConvexPart& part, const Path& path, const Pose& local);

// What holds for all parts of two bodies.
struct ImpactSettings {
  Real size;  // of the coordinates on the way
  Real tolerance, margin;
  std::uint32_t most_rounds;
};

// Within a span of time, in the frame of the paths. Of parts that overlap at its begin the contact says nothing.
[[nodiscard]] Impact convex_impact(const MovingPart& a, const MovingPart& b, const TimeSpan& span,
                                   const ImpactSettings& settings);

// A lower bound of a gap that is positive at both ends of a time, or at the begin of it: where the way of every point
// is bent by at most `bend`, the gap lies above the straight line between its ends less bend / 2 * t * (length - t).
// How much of the time is certainly free, from 0 to 1.
[[nodiscard]] Real free_share(Real at_begin, Real at_end, Real bend, Real length);

}  // namespace abut
