// SPDX-License-Identifier: Apache-2.0
// Whether shapes touch where a motion starts, and whether that stops the motion.
export module abut.pairs.any_shape.casts.starting_touch;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.any_shape;

export namespace abut {

struct StartingTouch {
  std::optional<ContactPoint> contact;
  bool stops = false;  // whatever a search for a touch would find
};

struct StartSettings {
  QuerySettings query;
  Real tolerance;  // as much further apart than the margin, shapes may touch
  Real rounding;   // contacts that are this deep may be rounding
  bool is_still;   // whether nothing moves
};

// How fast b moves relative to a along the normal of a contact, as a share of how fast it moves.
using SpeedAlong = std::function<Real(const ContactPoint&)>;

// The deepest contact stops a motion that starts deeper than rounding, whichever way it leads. Contacts that rounding
// may make or unmake stop it where it leads against their normals.
[[nodiscard]] Outcome find_starting_touch(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                          const StartSettings& settings, const SpeedAlong& speed_along,
                                          StartingTouch& out);

}  // namespace abut
