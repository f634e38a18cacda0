// SPDX-License-Identifier: Apache-2.0
module abut.narrow.many.two_sources;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.many.crossing_surfaces;
import abut.narrow.many.leaving_pairs;
import abut.narrow.many.nearest_of_parts;
import abut.narrow.many.triangle_source;

namespace abut {
namespace {

// The pair that is left last.
std::optional<TouchedPair> last_pair(CrossingSurfaces& surfaces, const SeparatingTranslation& found) {
  std::optional<TouchedPair> last;
  const auto key = [](const TouchedPair& pair) { return std::tuple(-pair.length, pair.a.number, pair.b.number); };
  surfaces.visit_touched(found, [&](const TouchedPair& pair) {
    if (!last || key(pair) < key(*last)) {
      last = pair;
    }
  });
  return last;
}

}  // namespace

bool depth_of_surfaces(const TriangleSource& a, const TriangleSource& b, const Pose& ab, const QuerySettings& settings,
                       Distance& out) {
  if (is_moved_first(a, b, ab)) {
    const bool is_found = depth_of_surfaces(b, a, ab.inverse(), settings, out);
    move_by(out, ab, true);
    return is_found;
  }
  CrossingSurfaces surfaces(a, b, ab, settings, 0);
  if (!surfaces.is_overlapped()) {
    return false;
  }
  const SeparatingTranslation found = surfaces.find();
  const std::optional<TouchedPair> last = last_pair(surfaces, found);
  if (!last) {
    return false;
  }
  out = no_distance();
  out.distance = -found.length;
  out.lower = -found.length - surfaces.tolerance();
  out.upper = -std::min(surfaces.least(), found.length) + surfaces.tolerance();
  out.normal = found.direction;
  out.point_b = last_point_of(last->a.corners, last->b.corners, found.direction, last->length);
  out.point_a = out.point_b + found.length * found.direction;
  out.iterations = 1;
  return true;
}

}  // namespace abut
