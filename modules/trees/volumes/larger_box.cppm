// SPDX-License-Identifier: Apache-2.0
// How far boxes that are kept reach beyond the given ones.
export module abut.trees.volumes.larger_box;
import abut.core.standard;
import abut.math;

export namespace abut {

// Surfaces of boxes beyond this would overflow in float.
inline constexpr float largest_bounded = 1e18f;

[[nodiscard]] inline bool is_bounded(const CompactAabb& box) {
  bool bounded = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounded = bounded && box.low[axis] > -largest_bounded && box.high[axis] < largest_bounded;
  }
  return bounded;
}

// Larger on each side by a share of the mean side, and ahead by the present motion times some updates. More means fewer
// changes of the index and more pairs to look at in every step. What is not bounded stays as it is.
[[nodiscard]] inline CompactAabb enlarged(const CompactAabb& box, const CompactAabb& before) {
  constexpr float slack_share = 0.08f, updates_ahead = 9.0f, most_ahead = 0.5f;
  if (!is_bounded(box)) {
    return box;
  }
  const float side =
      (1.0f / 3.0f) * ((box.high[0] - box.low[0]) + (box.high[1] - box.low[1]) + (box.high[2] - box.low[2]));
  const bool has_motion = is_bounded(before);
  CompactAabb larger;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float shift = 0.5f * (box.low[axis] - before.low[axis]) + 0.5f * (box.high[axis] - before.high[axis]);
    const float ahead = has_motion ? std::clamp(updates_ahead * shift, -most_ahead * side, most_ahead * side) : 0.0f;
    larger.low[axis] = box.low[axis] - slack_share * side + std::min(ahead, 0.0f);
    larger.high[axis] = box.high[axis] + slack_share * side + std::max(ahead, 0.0f);
  }
  return larger;
}

}  // namespace abut
