// SPDX-License-Identifier: Apache-2.0
module abut.narrow.polytope.polytope_depth;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.polytope.epa;

namespace abut {

void set_depth(const EpaResult& found, Real size, CoreSeparation& core) {
  core.algorithm = Algorithm::gjk_epa;
  core.iterations += found.iterations;
  core.rounding = noise_of(size);  // normals of slender triangles are off by more than their corners
  core.normal = found.normal;
  core.distance = -found.depth;
  core.lower = -found.upper;
  core.upper = -found.lower;
  core.point_a = found.point_a;
  core.point_b = found.point_b;
}

void separate_by_polytope(const Difference& cores, Real error, const Simplex& start, CoreSeparation& core) {
  set_depth(epa(cores, error, start), cores.size, core);
  // The polytope knows one triangle of a face, which need not hold the closest points of both faces. Curved
  // surfaces have no such faces.
  const Vec3 aside = core.point_b - core.point_a - core.distance * core.normal;
  core.points_open = !cores.is_curved && largest_magnitude(aside) > noise_of(cores.size);
}

bool separate_by_touch(const Difference& cores, Real error, const Simplex& start, CoreSeparation& core) {
  const EpaResult found = epa(cores, error, start);
  const Real apart = norm(found.point_b - found.point_a);
  // Points of cores that are apart are as far apart as these.
  const Real farthest = found.depth < 0 ? noise_of(cores.size) - found.depth : error;
  if (!(std::fabs(found.depth) <= error && found.upper - found.lower <= error && apart <= farthest)) {
    core.iterations += found.iterations;
    return false;
  }
  set_depth(found, cores.size, core);
  core.overlap = true;
  core.upper = std::fmax(apart, core.upper);
  return true;
}

}  // namespace abut
