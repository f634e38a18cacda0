// Depth of overlap of cores of which one is curved: by their outlines where they turn around one axis, else by the
// expanding polytope algorithm. And the points of both cores under a normal.
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
