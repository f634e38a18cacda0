// SPDX-License-Identifier: Apache-2.0
// The first touch of two whole shapes by their distance alone.
export module abut.motion.impacts.whole_impact;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.motion.impacts.convex_impact;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.pairs.shape_handle;

export namespace abut {

// How a body moves, and where on it a shape is.
struct [[gsl::Pointer]] Carrier {
  const Path& path;
  Pose local;

  [[nodiscard]] Pose at(Real time) const { return path.at(time) * local; }
};

// What a search says, unless it cannot answer at all.
struct WholeImpact {
  Outcome outcome = Outcome::ok;
  Impact impact;
};

// A half-space and anything. The gap is the least of those of the points. So two values of it prove the time between
// them free, as for convex parts.
[[nodiscard]] WholeImpact half_space_impact(const AnyShape& half_space, const Carrier& a, const AnyShape& b,
                                            const Carrier& on_b, const TimeSpan& span, const ImpactSettings& settings);

// Whatever has a distance: steps are as long as its lower bound over the largest speed of approach, or a stride.
[[nodiscard]] WholeImpact distance_impact(const AnyShape& a, const Carrier& on_a, const AnyShape& b,
                                          const Carrier& on_b, const TimeSpan& span, const ImpactSettings& settings);

}  // namespace abut
