// SPDX-License-Identifier: Apache-2.0
// What a search for the separation of two cores may leave open.
export module abut.narrow.apart.search_bounds;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;

export namespace abut {

struct SearchBounds {
  Real size;   // of the coordinates
  Real error;  // of the distance
  Real limit;  // cores that are further apart need no other answer
  // An error that is allowed while nothing proves the cores apart: what searches for overlaps say of cores that are
  // apart bounds their distance from below only. A coarse bound must not send any there.
  Real unproven;

  [[nodiscard]] inline bool are_met(Real lower, Real upper) const { return upper - lower <= error + noise_of(size); }
};
template <Convex A, Convex B>
[[nodiscard]] inline SearchBounds search_bounds(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                Real limit) {
  const Real size = core_size(a, b, ab);
  return {size, error_of(a, b, size, settings), limit, error_of(a, b, size, QuerySettings{})};
}

}  // namespace abut
