// SPDX-License-Identifier: Apache-2.0
// Rays and points against a scene.
module abut.queries;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.pairs.any_shape.casts.ray_child;
import abut.pairs.any_shape;
import abut.queries.filter;
import abut.scene;

namespace abut {
namespace {

Real touching_at(const AnyShape& shape, const Vec3& point) {
  const Aabb box = aabb_of(shape, Pose::identity());
  const Real size = box.is_bounded() ? std::max(largest_magnitude(box.low), largest_magnitude(box.high)) : 0;
  return touching_distance(size + largest_magnitude(point));
}

std::optional<RayContact> cast_at(const Scene& scene, std::uint32_t place, const Ray& ray, Real limit, RayStart start) {
  const AnyShape& shape = scene.shape_at(place);
  const Pose& pose = scene.world_at(place);
  const Vec3 origin = pose.undo(ray.origin);
  if (start != RayStart::far_side && holds(shape, origin, -touching_at(shape, origin))) {
    return start == RayStart::skip
               ? std::nullopt
               : std::optional(RayContact{scene.id_at(place), 0, ray.origin, {0, 0, 0}, {FeatureKind::whole, 0}, 0});
  }
  const auto direction = UnitVec3::from_unit_unchecked(pose.rotation.undo(ray.direction));
  const std::optional<RayHit> hit = cast_ray(shape, origin, direction, limit);
  if (!hit) {
    return std::nullopt;
  }
  const Real distance = std::min(hit->distance, ray.max_distance);
  return RayContact{scene.id_at(place),          distance,     ray.origin + distance * ray.direction.vec(),
                    pose.rotation * hit->normal, hit->feature, child_on_ray(shape, origin, direction, hit->distance)};
}

void find_hits(const Scene& scene, const Ray& ray, const QueryFilter& filter, RayStart start, Hits<RayContact>& hits) {
  scene.sweep({ray.origin, ray.origin}, ray.direction, hits.limit(), [&](std::uint32_t place, Real) {
    if (hits.limit() >= 0 && admits(filter, scene, place)) {
      if (const auto hit = cast_at(scene, place, ray, hits.limit(), start)) {
        hits.add(*hit, hit->distance);
      }
    }
    return hits.limit();
  });
}

// What ends on a surface must not miss it by rounding.
Real limit_of(const Ray& ray) {
  const bool is_endless = std::isinf(ray.max_distance);
  return ray.max_distance + (is_endless ? 0 : rounding_of(largest_magnitude(ray.origin) + ray.max_distance));
}

}  // namespace

std::vector<RayContact> cast_ray(const Scene& scene, const Ray& ray, const QueryFilter& filter, HitMode mode,
                                 RayStart start) {
  Hits<RayContact> hits(mode, limit_of(ray));
  find_hits(scene, ray, filter, start, hits);
  return hits.in_order();
}

std::optional<RayContact> cast_ray(const Scene& scene, const Ray& ray, const QueryFilter& filter, RayStart start) {
  Hits<RayContact> hits(HitMode::nearest, limit_of(ray));
  find_hits(scene, ray, filter, start, hits);
  return hits.first();
}

std::vector<GeometryId> find_at_point(const Scene& scene, const Vec3& point, const QueryFilter& filter) {
  std::vector<GeometryId> found;
  scene.visit({point, point}, [&](std::uint32_t place) {
    const AnyShape& shape = scene.shape_at(place);
    const Vec3 local = scene.world_at(place).undo(point);
    if (admits(filter, scene, place) && holds(shape, local, touching_at(shape, local))) {
      found.push_back(scene.id_at(place));
    }
  });
  std::ranges::sort(found, {}, &GeometryId::slot);
  return found;
}

}  // namespace abut
