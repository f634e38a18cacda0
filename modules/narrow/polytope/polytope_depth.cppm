// SPDX-License-Identifier: Apache-2.0
// The separation of two cores that overlap or touch, from what the expanding polytope finds. Compiled once.
export module abut.narrow.polytope.polytope_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.polytope.epa;

export namespace abut {

// As the record of a separation.
void set_depth(const EpaResult& found, Real size, CoreSeparation& core);

// `start`: the simplex on which the search for a common point ended.
void separate_by_polytope(const Difference& cores, Real error, const Simplex& start, CoreSeparation& core);

// Where the rim of a round core touches, GJK may end on slivers near the common point. A polytope finds that point.
// False unless the cores surely neither overlap nor are apart by more than the error.
[[nodiscard]] bool separate_by_touch(const Difference& cores, Real error, const Simplex& start, CoreSeparation& core);

}  // namespace abut
