// SPDX-License-Identifier: Apache-2.0
// The points of both cores under a normal along which their depth is known.
export module abut.narrow.polytope.points_under;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.polytope.epa;

export namespace abut {

// By what the cores are to second order, under the normal or at a minimum beside it. Nothing where neither has this
// depth.
[[nodiscard]] std::optional<EpaResult> with_points(const Difference& cores, Real error, const EpaResult& found);

// By GJK, from where the cores are apart along the normal.
void find_points_under(const Difference& cores, Real error, EpaResult& found);

}  // namespace abut
