// SPDX-License-Identifier: Apache-2.0
// Which pairs of shapes are asked by discs how deep they overlap, and what they answer.
export module abut.narrow.fan.disc_pairs;
import abut.capability;
import abut.math;
import abut.narrow.cores.core_separation;

export namespace abut {

template <class S>
inline constexpr bool is_tried_on_discs = (BoxCored<S> && !PointCored<S>) || Faceted<S> || Triangular<S>;
template <class A, class B>
inline constexpr bool has_discs =
    (Rimmed<B> && (is_tried_on_discs<A> || Rimmed<A>)) || (Rimmed<A> && is_tried_on_discs<B>);

struct ProvenDepth {
  Real depth, lower;
  Vec3 normal;  // unit, from a to b, in the frame of a
  CoreFeatures features;
};

}  // namespace abut
