// SPDX-License-Identifier: Apache-2.0
// Questions to a whole universe: rays, points, overlaps, closest geometries and moving shapes. They see boxes and poses
// as of the last step or refresh, and never a parked geometry. They change nothing, and may run at once on many
// threads.
export module abut.queries;
import abut.pairs.any_shape;
export import abut.pairs.any_shape.casts.shape_cast;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.motion.time_of_impact;
import abut.scene;

export namespace abut {

// Which geometries a query looks at. It has layers and a mask as geometries do, and both sides have to agree.
struct QueryFilter {
  std::uint64_t layers = ~std::uint64_t{0};
  std::uint64_t mask = ~std::uint64_t{0};
  PartId ignored_part;          // null for none
  GeometryId ignored_geometry;  // null for none
  bool skips_sensors = false;
};

// Of all geometries that are met: the first one, whichever is found first, or each once, in order.
enum class HitMode : std::uint32_t { nearest, any, all };

// What a ray meets that starts inside a solid: the far side, the solid itself at distance 0 with a normal of zeros, or
// nothing of it.
enum class RayStart : std::uint32_t { far_side, solid, skip };

struct Ray {
  Vec3 origin;
  UnitVec3 direction;
  Real max_distance;
};

struct RayContact {
  GeometryId geometry;
  Real distance;
  Vec3 point;
  Vec3 normal;  // zero where the ray starts inside
  Feature feature;
  std::uint32_t child;  // of a composite; else 0
};

struct CastContact {
  GeometryId geometry;
  ShapeCastHit hit;  // the moving shape is a, the geometry b
};

struct ImpactContact {
  GeometryId geometry;
  Impact impact;  // the moving shape is a, the geometry b
};

struct NearGeometry {
  GeometryId geometry;
  Distance distance;  // from the shape to the geometry
};

// Ordered by the distance or the fraction, then by slot. A ray that ends on a surface meets it.
[[nodiscard]] std::vector<RayContact> cast_ray(const Scene& scene, const Ray& ray, const QueryFilter& filter,
                                               HitMode mode, RayStart start);
// The nearest hit alone, which asks for no memory.
[[nodiscard]] std::optional<RayContact> cast_ray(const Scene& scene, const Ray& ray, const QueryFilter& filter,
                                                 RayStart start);
[[nodiscard]] std::vector<CastContact> cast_shape(const Scene& scene, const AnyShape& shape, const Pose& pose,
                                                  const Vec3& displacement, const QueryFilter& filter, HitMode mode);
// Ordered by the time up to which they are apart, then by slot. What is undecided counts: it may be a touch. Only in a
// build with the feature `motion`.
[[nodiscard]] std::vector<ImpactContact> cast_movement(const Scene& scene, const AnyShape& shape, const Path& path,
                                                       const ImpactOptions& options, const QueryFilter& filter,
                                                       HitMode mode);

// Ordered by slot. Overlaps: what a shape has contacts with up to a distance. At a point: solids that hold it, and
// surfaces that it lies on.
[[nodiscard]] std::vector<GeometryId> find_overlaps(const Scene& scene, const AnyShape& shape, const Pose& pose,
                                                    Real margin, const QueryFilter& filter);
[[nodiscard]] std::vector<GeometryId> find_at_point(const Scene& scene, const Vec3& point, const QueryFilter& filter);

// The geometry of the least signed distance up to `max_distance`, which may be infinite; of equal ones the lowest slot.
[[nodiscard]] std::optional<NearGeometry> find_closest(const Scene& scene, const AnyShape& shape, const Pose& pose,
                                                       Real max_distance, const QueryFilter& filter);

}  // namespace abut
