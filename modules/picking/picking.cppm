// SPDX-License-Identifier: Apache-2.0
// Rays against a world, through Embree.
module;

#include <abut/picking.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

export module abut.picking;
export import :vector;
export import :source;
export import :camera;
export import :region;

namespace abut::picking {
class Tracer;
// Deletes a tracer where its type is complete.
struct TracerDeleter {
  void operator()(Tracer* tracer) const noexcept;
};
}  // namespace abut::picking

export namespace abut::picking {

// How similar the rays of a batch are; changes only the speed.
enum class Coherence : unsigned char { none, neighbours };

// Rays against one world. Follows its source by itself: each query first compares the counters
// with those that it has seen. Queries may run together. Arguments are trusted: finite, directions
// not zero, distances not negative. A filter may be null, when all geometries count.
class Picker {
 public:
  // The counters are there for as long as the picker is.
  Picker(std::unique_ptr<Source> source, Counters counters);

  // Follows the source now.
  [[nodiscard]] abut_status update() noexcept;
  // As cast_ray, for the usual ray only, which is then finite, with a direction and a limit that is not
  // negative. False, and nothing is written, for any other.
  [[nodiscard]] bool cast_usual_ray(const abut_ray& ray, abut_pick& out) const noexcept;
  // First thing that a ray meets; a null geometry when there is none.
  [[nodiscard]] abut_status cast_ray(const abut_ray& ray, const abut_query_filter* filter, abut_pick& out) noexcept;
  // First things that rays meet; `out` is as long as `rays`.
  [[nodiscard]] abut_status cast_rays(std::span<const abut_ray> rays, Coherence coherence,
                                      const abut_query_filter* filter, std::span<abut_pick> out) noexcept;
  // Everything that a ray meets, nearest first.
  [[nodiscard]] abut_status cast_ray_all(const abut_ray& ray, const abut_query_filter* filter,
                                         std::vector<abut_pick>& out) noexcept;
  // Whether a ray meets anything, or each of several.
  [[nodiscard]] abut_status meets(const abut_ray& ray, const abut_query_filter* filter, std::uint32_t& out) noexcept;
  [[nodiscard]] abut_status meet(std::span<const abut_ray> rays, Coherence coherence, const abut_query_filter* filter,
                                 std::span<std::uint32_t> out) noexcept;
  // What lies at a point of a picture, or nearest to it within a radius in pixels.
  [[nodiscard]] abut_status pick_pixel(const abut_camera& camera, double x, double y, double radius,
                                       const abut_query_filter* filter, abut_pick& out) noexcept;
  // One ray per pixel, row by row from the top; `out` holds width * height picks.
  [[nodiscard]] abut_status render(const abut_camera& camera, const abut_query_filter* filter,
                                   std::span<abut_pick> out) noexcept;
  // Geometries that touch what a rectangle shows, or lie in it, by slot.
  [[nodiscard]] abut_status select(const abut_camera& camera, const Rectangle& rectangle, bool inside,
                                   const abut_query_filter* filter, std::vector<abut_geometry_id>& out) noexcept;
  // Vertices, edges and their middles around a point of a picture.
  [[nodiscard]] abut_status snap(const abut_camera& camera, double x, double y, double radius, abut_snap_kinds kinds,
                                 const abut_query_filter* filter, abut_snap& out) noexcept;
  // Weights of a point in a face. ABUT_STALE_ID for a geometry that no ray sees.
  [[nodiscard]] abut_status weigh(abut_geometry_id id, std::uint32_t face, const abut_vec3& point,
                                  abut_barycentric& out) noexcept;

  // What later queries see. None may run meanwhile.
  void set_flags(bool sees_sensors, bool skips_back_faces) noexcept;
  [[nodiscard]] abut_status set_clip_planes(std::span<const abut_clip_plane> planes) noexcept;

 private:
  std::unique_ptr<Tracer, TracerDeleter> tracer_;
};

}  // namespace abut::picking
