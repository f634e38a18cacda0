// Depth of overlap of cores of which one is curved: the expanding polytope algorithm, in which whole caps of directions
// are proven at once.
//
// A polytope alone comes nearer to a round surface by a constant factor per vertex, and proves nothing where many
// directions are as good. Here Newton's method finds a least depth d among nearby directions and a cap of them in which
// nothing is less. A direction v outside all caps with less than d has d v outside the polytope, beyond one of its
// faces: within the angle of cosine distance / d from the normal of that face. Faces all of whose such directions lie
// in a cap need no vertex. When none is left, d is the depth.
export module abut.narrow.polytope.capped_epa;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.polytope.epa;

export namespace abut {

// A depth with the points of the minimum under its normal or near it; nothing where there is none of that depth.
[[nodiscard]] std::optional<EpaResult> with_points(const Difference& cores, Real error, const EpaResult& found);

[[nodiscard]] EpaResult capped_epa(const Difference& cores, Real error, const Simplex& start);

}  // namespace abut
