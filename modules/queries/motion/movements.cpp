// SPDX-License-Identifier: Apache-2.0
// What a shape meets in a universe while it moves and turns.
module abut.queries;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;
import abut.queries.filter;
import abut.scene;

namespace abut {
namespace {

// A box that goes straight, with constant speed, to where the centre of the shape ends. At all times it holds the
// shape.
Aabb box_of_way(const AnyShape& shape, const Path& path, const ImpactOptions& options) {
  const Vec3 centre = path.centre_at(0);
  const Real radius = path.radius_of(aabb_of(shape, Pose::identity()));
  const Aabb turned = Aabb{centre, centre}.inflated(radius);
  const Aabb box = path.turns() ? turned : aabb_of(shape, path.start());
  // Only the way of the centre is bent: the box holds the shape however it is turned.
  const Real bent = path.largest_deviation(path.whole(), 0);
  const Real size = std::max(
      {largest_magnitude(box.low), largest_magnitude(box.high), largest_magnitude(path.shift_at(path.duration()))});
  return box.inflated(bent + options.margin + options.tolerance + rounding_of(size));
}

}  // namespace

std::vector<ImpactContact> cast_movement(const Scene& scene, const AnyShape& shape, const Path& path,
                                         const ImpactOptions& options, const QueryFilter& filter, HitMode mode) {
  const Real duration = path.duration();
  Hits<ImpactContact> hits(mode, duration);
  const auto visit_place = [&](std::uint32_t place) {
    if (hits.limit() < 0 || !admits(filter, scene, place)) {
      return;
    }
    const Path still = Path::at_rest(scene.world_at(place), duration);
    Impact impact;
    const Outcome outcome = time_of_impact({shape, path}, {scene.shape_at(place), still}, options, impact);
    if (outcome == Outcome::ok && impact.state != ImpactState::apart) {
      hits.add({scene.id_at(place), impact}, impact.lower);
    }
  };
  const bool is_bounded = aabb_of(shape, path.start()).is_bounded();
  if (!is_bounded) {
    scene.visit(Aabb::everything(), visit_place);
  } else {
    scene.sweep(box_of_way(shape, path, options), path.shift_at(duration), 1, [&](std::uint32_t place, Real) {
      visit_place(place);
      return hits.limit() / duration;
    });
  }
  return hits.in_order();
}

}  // namespace abut
