// SPDX-License-Identifier: Apache-2.0
// The kernels of distances that begin where the last query ended. Knows no shape by name.
export module abut.pairs.rows.from_hint;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.convex.hinted_distance;
export import abut.pairs.table;

export namespace abut {

template <class Any, class A, class B>
[[nodiscard]] Outcome distance_from_hint_kernel(const Any& a, const Any& b, const Pose& pose_a, const Pose& pose_b,
                                                bool swapped, const QuerySettings& settings, PairHint& hint,
                                                Distance& out) {
  [[clang::uninitialized]] Distance found;
  const Outcome outcome = convex_distance_from_hint(core_of(std::get<A>(a)), core_of(std::get<B>(b)),
                                                    relative(pose_a, pose_b), settings, hint, found);
  if (outcome == Outcome::ok) [[likely]] {
    move_by(found, pose_a, swapped);
    out = found;
  }
  return outcome;
}

template <class Any, class A, class B>
[[nodiscard]] consteval auto distance_from_hint_of() -> decltype(PairKernels<Any>::distance_from_hint) {
  if constexpr (route<A, B>() == Route::convex) {
    if constexpr (gains_from_hint<CoreOf<A>, CoreOf<B>>) {
      return distance_from_hint_kernel<Any, A, B>;
    }
  }
  return nullptr;
}

}  // namespace abut
