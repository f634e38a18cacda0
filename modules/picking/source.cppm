// SPDX-License-Identifier: Apache-2.0
// What the picker asks of the world that it looks at. One implementation stands on the C interface;
// another one can stand on any container of shapes.
module;

#include <abut/picking.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

export module abut.picking:source;

export using ::abut_aabb;
export using ::abut_barycentric;
export using ::abut_camera;
export using ::abut_clip_plane;
export using ::abut_geometry_id;
export using ::abut_pick;
export using ::abut_part_id;
export using ::abut_pose;
export using ::abut_query_filter;
export using ::abut_ray;
export using ::abut_ray_hit;
export using ::abut_snap;
export using ::abut_snap_kinds;
export using ::abut_status;
export using ::abut_vec3;

export namespace abut::picking {

// Triangles in the frame of their shape.
struct TriangleList {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
};

// A ray from the front of a triangle at its middle.
[[nodiscard]] abut_ray ray_at_triangle(const TriangleList& list, std::size_t triangle);

// All points within `radius` of the segment from (0, 0, -half_height) to (0, 0, half_height).
// A point or a segment when the radius is 0.
struct RoundedSegment {
  double radius;
  double half_height;
};

// A shape as the picker sees it. Keeps the shape alive.
class PickableShape {
 public:
  PickableShape() = default;
  PickableShape(const PickableShape&) = delete;
  PickableShape& operator=(const PickableShape&) = delete;
  virtual ~PickableShape() = default;

  // Box around the shape under a pose; infinite sides where it is unbounded.
  [[nodiscard]] virtual abut_status bounds(const abut_pose& pose, abut_aabb& out) const = 0;
  // Number of triangles of its surface; 0 when it has none.
  [[nodiscard]] virtual abut_status triangle_count(std::size_t& out) const = 0;
  // Its surface, when triangle_count is not 0.
  [[nodiscard]] virtual abut_status triangles(TriangleList& out) const = 0;
  // The face of each triangle, as rays name it; empty when triangle i is face i.
  [[nodiscard]] virtual abut_status faces(const TriangleList& list, std::vector<std::uint32_t>& out) const = 0;
  // First crossing with its surface, as abut_shape_cast_ray. Runs on several threads at once.
  [[nodiscard]] virtual std::optional<abut_ray_hit> cast(const abut_pose& pose, const abut_ray& ray) const noexcept = 0;
  // Whether the shape is a sphere, a capsule, a point or a segment, and which one.
  [[nodiscard]] virtual std::optional<RoundedSegment> rounded() const = 0;
  // Whether it has a point in common with a solid of its source, which lies as it was made.
  [[nodiscard]] virtual bool overlaps(const abut_pose& pose, const PickableShape& solid) const noexcept = 0;
};

// What queries are filtered by: see abut_query_filter.
struct Traits {
  std::uint64_t layers;
  std::uint64_t mask;
  abut_part_id part;
  bool is_sensor;
};

// A geometry: which shape, and where. Equal keys are the same shape.
struct GeometryView {
  std::uintptr_t shape_key;
  abut_pose pose;
  Traits traits;
  bool is_parked;
};

// Lent, and not freed with what borrows it.
struct Borrowed {
  template <class Lent>
  void operator()(const Lent* /*lent*/) const noexcept {}
};

// Numbers that grow with each change of the world: `geometries` when a geometry comes, goes or changes, `poses` when a
// pose is set. Read where they are, since each query looks at them.
struct Counters {
  std::unique_ptr<const std::uint64_t, Borrowed> geometries;
  std::unique_ptr<const std::uint64_t, Borrowed> poses;
};

// The world.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;

  // The geometries that have changed in any way since the counters were these; of one that has gone the generation is
  // 0. `is_known` is false where too much has changed to tell.
  [[nodiscard]] virtual abut_status changes(std::uint64_t geometries, std::uint64_t poses,
                                            std::vector<abut_geometry_id>& out, bool& is_known) const = 0;
  // All geometries, ordered by slot.
  [[nodiscard]] virtual abut_status geometries(std::vector<abut_geometry_id>& out) const = 0;
  [[nodiscard]] virtual abut_status describe(abut_geometry_id id, GeometryView& out) const = 0;
  // World poses, in the order of `ids`.
  [[nodiscard]] virtual abut_status poses(std::span<const abut_geometry_id> ids, std::vector<abut_pose>& out) const = 0;
  // Access to the shape of a geometry.
  [[nodiscard]] virtual abut_status shape(abut_geometry_id id, std::unique_ptr<PickableShape>& out) const = 0;
  // Solids that shapes may overlap: the points p with dot(normal, p) <= offset, and the hull of points.
  [[nodiscard]] virtual abut_status half_space(const abut_vec3& normal, double offset,
                                               std::unique_ptr<PickableShape>& out) const = 0;
  [[nodiscard]] virtual abut_status hull(std::span<const double> xyz, std::unique_ptr<PickableShape>& out) const = 0;
};

}  // namespace abut::picking
