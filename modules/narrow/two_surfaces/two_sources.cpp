// SPDX-License-Identifier: Apache-2.0
module abut.narrow.two_surfaces.two_sources;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.two_surfaces.crossing_surfaces;
import abut.narrow.two_surfaces.leaving_pairs;
import abut.narrow.parts.nearest_of_parts;
import abut.narrow.surface.triangle_source;

namespace abut {
bool depth_of_surfaces(const SurfaceSource& a, const SurfaceSource& b, const Pose& ab, const QuerySettings& settings,
                       Distance& out) {
  if (is_moved_first(a, b, ab)) {
    const bool is_found = depth_of_surfaces(b, a, ab.inverse(), settings, out);
    move_by(out, ab, true);
    return is_found;
  }
  CrossingSurfaces surfaces(a, b, ab, settings, 0);
  if (!surfaces.is_met()) {
    return false;
  }
  const SeparatingTranslation found = surfaces.find();
  const std::optional<TouchedPair> last = surfaces.last_pair(found);
  if (!last) {
    return false;
  }
  out = no_distance();
  out.distance = -found.length;
  out.lower = -found.length - surfaces.tolerance();
  out.upper = -std::min(found.least, found.length) + surfaces.tolerance();
  out.normal = found.direction;
  out.point_b = last_point_of(last->a.corners, last->b.corners, found.direction, last->length);
  out.point_a = out.point_b + found.length * found.direction;
  out.algorithm = surfaces.has_solid() ? Algorithm::solid : Algorithm::separating_translation;
  out.iterations = 1;
  return true;
}

}  // namespace abut
