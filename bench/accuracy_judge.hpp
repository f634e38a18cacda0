// SPDX-License-Identifier: Apache-2.0
// What the signed distance of two solids is: by the oracle of the tests, in 113-bit floating point. It shares no code
// with abut.
#pragma once
#include <functional>
#include <optional>

#include "oracle/distance.hpp"
#include "oracle/solid.hpp"
#include "scene.hpp"

namespace bench {

// A solid as the oracle sees it. Faces and edges, which take seconds to find for a large hull, are found when they are
// asked for.
class Judge {
 public:
  explicit Judge(const Solid& solid);

  [[nodiscard]] const oracle::Solid& solid() const { return solid_; }
  // Nothing of a cylinder.
  [[nodiscard]] const std::optional<oracle::Measured>& features();

 private:
  std::optional<oracle::Body> body_;
  oracle::Solid solid_;
  std::optional<oracle::Measured> features_;
};

[[nodiscard]] oracle::Pose oracle_pose(const Placement& placement);

// Exact to about 1e-18 of the size. Of solids apart, and of rounded ones whose cores are apart, from support points;
// of other overlapping ones from their features, which takes longer: only where overlaps are asked for. Nothing where a
// cylinder overlaps the core of the other.
[[nodiscard]] std::optional<oracle::Quad> true_distance(Judge& a, const oracle::Pose& at_a, Judge& b,
                                                        const oracle::Pose& at_b, bool with_overlaps);

// No more than the distance, from support points alone; nothing where the cores touch.
[[nodiscard]] std::optional<oracle::Quad> least_distance(const Judge& a, const oracle::Pose& at_a, const Judge& b,
                                                         const oracle::Pose& at_b);

// The share of the motion of b, which does not turn, at which it first touches a; 1 where it passes. Solids that are
// apart at the start. Each step is the way that the plane between both allows, Newton's method on a convex function.
[[nodiscard]] oracle::Quad true_cast(const Judge& a, const oracle::Pose& at_a, const Judge& b, oracle::Pose at_b,
                                     const Point& motion);

// The same of b that turns as well, from its distances on the way. No point of b, all within the reach of its origin,
// can go as far in one step. Close to the touch a step is most of the way to where the line through the last two ends.
// Nothing where that does not end. `distance_at` has nothing where the cores touch.
using DistanceAt = std::function<std::optional<oracle::Quad>(const oracle::Pose& at_b)>;
[[nodiscard]] std::optional<oracle::Quad> true_impact(const DistanceAt& distance_at, const oracle::Pose& from,
                                                      const Point& motion, const Point& turn, double reach);

}  // namespace bench
