// SPDX-License-Identifier: Apache-2.0
// Two shapes that move and turn: when they first touch.
#ifndef ABUT_CPP_IMPACT_HPP
#define ABUT_CPP_IMPACT_HPP

#include <abut/abut.h>
#include <abut/cpp/answer.hpp>
#include <abut/cpp/options.hpp>
#include <abut/cpp/shape.hpp>
#include <abut/cpp/values.hpp>

#include <cstddef>

namespace abut {
inline namespace ABUT_ANSWERS {

// From one pose to another with constant speeds: the centre on a straight line, the turn by the shorter way.
[[nodiscard]] inline Answer<Movement> movement_between(const Pose& start, const Pose& end, Vec3 centre,
                                                       double duration) {
  Movement out{};
  return detail::answer(abut_movement_between(&start, &end, &centre, duration, &out), out);
}

// When two shapes that move and turn first touch, from time 0 to the duration.
[[nodiscard]] inline Answer<Impact> pair_time_of_impact(const Shape& a, const Pose& pose_a, const Movement& movement_a,
                                                        const Shape& b, const Pose& pose_b, const Movement& movement_b,
                                                        double duration,
                                                        OptionalRef<abut_impact_options> options = {}) {
  Impact out{};
  return detail::answer(abut_pair_time_of_impact(a.get(), &pose_a, &movement_a, b.get(), &pose_b, &movement_b, duration,
                                                 options.get(), &out),
                        out);
}

// The same for many poses and movements of the same two shapes.
inline Answer<void> pairs_time_of_impact(const Shape& a, Span<const Pose> poses_a, Span<const Movement> movements_a,
                                         const Shape& b, Span<const Pose> poses_b, Span<const Movement> movements_b,
                                         double duration, Span<Impact> out,
                                         OptionalRef<abut_impact_options> options = {}) {
  const std::size_t count = poses_a.size();
  const abut_status sizes =
      detail::first_failure(detail::expect_as_many("movements_a", movements_a.size(), "poses_a", count),
                            detail::expect_as_many("poses_b", poses_b.size(), "poses_a", count),
                            detail::expect_as_many("movements_b", movements_b.size(), "poses_a", count),
                            detail::expect_as_many("out", out.size(), "poses_a", count));
  return detail::answer(sizes != ABUT_OK
                            ? sizes
                            : abut_pairs_time_of_impact(a.get(), poses_a.data(), movements_a.data(), b.get(),
                                                        poses_b.data(), movements_b.data(), count, duration,
                                                        options.get(), out.data()));
}

}  // namespace ABUT_ANSWERS
}  // namespace abut

#endif
