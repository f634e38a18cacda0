// SPDX-License-Identifier: Apache-2.0
// The distance of a shape of many parts, from those of its parts one by one.
export module abut.narrow.parts.nearest_of_parts;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// Before any part.
[[nodiscard]] inline Distance no_distance() {
  Distance none{};
  none.distance = none.lower = none.upper = infinity;
  none.normal = {0, 0, 1};
  none.algorithm = Algorithm::gjk_epa;
  return none;
}

// The true distance is the least of those of the parts, and so are its bounds. Whether the part is the nearest so far.
inline bool take_part(const Distance& part, Distance& best) {
  const Real lower = std::min(best.lower, part.lower), upper = std::min(best.upper, part.upper);
  const std::uint32_t iterations = best.iterations + part.iterations;
  const bool is_nearest = part.distance < best.distance;
  if (is_nearest) {
    best = part;
  }
  best.lower = lower;
  best.upper = upper;
  best.iterations = iterations;
  return is_nearest;
}

}  // namespace abut
