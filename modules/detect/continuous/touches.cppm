// SPDX-License-Identifier: Apache-2.0
// The touches of two geometries on their paths through a step, in order of time.
//
// Two convex bodies on straight paths overlap during one interval. The curvature and rotation of their paths bound how
// far they can separate and touch again, so resting bodies are not examined again. An overlap also takes time to end;
// that time is the distance between two samples.
export module abut.detect.continuous.touches;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.time_of_impact;

export namespace abut {

// So many touches of a pair are found in a step.
inline constexpr std::size_t most_touches = 8;
// Two that part for a shorter share of the step may be missed.
inline constexpr Real shortest_parting = 1. / 64;
// They have parted when they are apart by this share of the smaller of the two.
inline constexpr Real share_of_parting = 1. / 64;

// Both paths have 1 as their duration. What comes as near as the margin touches.
struct PathPair {
  MovingShape a, b;
  Real margin;
};

// From a time on, at which they are apart or which is the start. What is not proven, but shows no touch at times that
// are near each other, counts as apart. Not ok where the two kinds do not meet.
[[nodiscard]] Outcome find_touch(const PathPair& pair, Real begin, Impact& out);

// The next touch of two that touch at a time: after they have parted. Nothing where there is none.
[[nodiscard]] std::optional<Impact> find_touch_after(const PathPair& pair, Real time);

}  // namespace abut
