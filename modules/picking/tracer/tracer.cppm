// SPDX-License-Identifier: Apache-2.0
// The scene of rays: what Embree holds of a world, and how rays meet it.
//
//  - still:   surfaces of geometries that are used once and have not moved, baked as they lie; rays
//             meet them at Embree's own speed.
//  - moving:  one box per remaining geometry. A surface has an Embree scene of its own, in the frame
//             of its shape, that rays enter after their transformation in double: far from the
//             origin costs no digits. Any other shape is asked in double. The boxes are in scenes of
//             several levels: what came or moved last is in a small one, which is built anew with each
//             change. When a level is full, all in it go up to the next one.
//  - apart:   shapes without bounds, or too far for single precision, asked one after the other.
//
// What no query can meet is in none of them: parked geometries, and those without a layer or a mask.
// Each scene is traced in single precision inside a space of its own (vector.cppm).
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

module abut.picking:tracer;
import :box_scene;
import :box_table;
import :camera;
import :crossing;
import :entry;
import :region;
import :source;
import :surface;
import :vector;

namespace abut::picking {

// How many scenes hold what moves.
inline constexpr std::uint8_t level_count = 3;
// A counter that no world has: nothing was seen yet.
inline constexpr std::uint64_t never = ~std::uint64_t{0};
// How many planes are asked for on each side of one that was hit: two lines of the cache.
inline constexpr std::size_t planes_beside = 4;

class Tracer;

// Context of a query; says which of the types below it is.
struct Trace : embree::Query {
  bool collects;                                              // it is AllHits
  std::unique_ptr<const abut_query_filter, Borrowed> wanted;  // null when all geometries count
  Trace(bool are_neighbours, bool collects_all, const abut_query_filter* given) noexcept
      : embree::Query(are_neighbours), collects(collects_all), wanted(given) {}
};

// The first hit of one ray in a moving scene.
struct FirstHit : Trace {
  std::unique_ptr<const Tracer, Borrowed> tracer;
  abut_ray ray;          // unit direction
  double advance = 0;    // where the float ray starts, from the origin of the ray
  abut_ray_hit exact{};  // when the hit is one of a shape asked in double
  FirstHit(const Tracer& its, const abut_ray& unit_ray, const abut_query_filter* given) noexcept
      : Trace(false, false, given), tracer(&its), ray(unit_ray) {}
};

// Filter functions of the still scene.
void reject_hits(const RTCFilterFunctionNArguments* arguments);
void reject_any(const RTCFilterFunctionNArguments* arguments);

// First hits in the still scene, where Embree asks about each hit only when some may not count.
struct StillHit : Trace {
  StillHit(bool are_neighbours, bool skips_back_faces, const abut_query_filter* given) noexcept;
};

// Any hits in the still scene, of up to 16 rays. Those beyond a limit in single precision are not sure.
struct AnyHit : Trace {
  std::array<float, 16> sure_until;  // of each ray
  std::uint32_t unsure = 0;          // bits of rays
  AnyHit(bool are_neighbours, bool asks, const abut_query_filter* given) noexcept;
};

// Any hits of one ray in a moving scene.
struct MovingAnyHit : Trace {
  std::unique_ptr<const Tracer, Borrowed> tracer;
  abut_ray ray;  // unit direction
  MovingAnyHit(const Tracer& its, const abut_ray& unit_ray, const abut_query_filter* given) noexcept
      : Trace(false, false, given), tracer(&its), ray(unit_ray) {}
};

// Collects everything that one ray meets.
struct AllHits : Trace {
  abut_ray ray;                    // unit direction
  std::vector<std::uint32_t> met;  // entries of moving scenes with a box on the way
  bool out_of_memory = false;
  struct Crossing {
    abut_pick pick;
    double blur;  // two crossings of equal facing closer than this are one; negative: all count
  };
  std::vector<Crossing> crossings;
  AllHits(const abut_ray& unit_ray, const abut_query_filter* given) noexcept
      : Trace(false, true, given), ray(unit_ray) {}
};

class Tracer {
 public:
  Tracer(std::unique_ptr<Source> source, Counters counters) noexcept
      : source_(std::move(source)), counters_(std::move(counters)) {}

  // Brings the scenes up to date when the world has changed.
  [[nodiscard]] inline abut_status follow() { return is_current() ? ABUT_OK : catch_up(); }

  // As trace, for the usual ray only; false for any other, and when the scenes are not up to date.
  [[nodiscard]] bool trace_usual(const abut_ray& ray, abut_pick& out) const noexcept;
  void trace(const abut_ray& ray, const abut_query_filter* filter, abut_pick& out) const;
  // Without surfaces in the still scene packets have nothing to share.
  void trace_each(std::span<const abut_ray> rays, const abut_query_filter* filter, std::span<abut_pick> out) const;
  void trace_neighbours(std::span<const abut_ray> rays, const abut_query_filter* filter,
                        std::span<abut_pick> out) const;
  void trace_unrelated(std::span<const abut_ray> rays, const abut_query_filter* filter, std::span<abut_pick> out) const;
  void render(const abut_camera& camera, const abut_query_filter* filter, std::span<abut_pick> out) const;
  [[nodiscard]] abut_status trace_all(const abut_ray& ray, const abut_query_filter* filter,
                                      std::vector<abut_pick>& out) const;
  [[nodiscard]] abut_status pick_pixel(const Aim& aim, const abut_query_filter* filter, abut_pick& out) const;
  // Whether a ray meets anything.
  [[nodiscard]] bool meets(const abut_ray& ray, const abut_query_filter* filter) const;
  void meet_each(std::span<const abut_ray> rays, const abut_query_filter* filter, std::span<std::uint32_t> out) const;
  void meet_neighbours(std::span<const abut_ray> rays, const abut_query_filter* filter,
                       std::span<std::uint32_t> out) const;
  [[nodiscard]] abut_status select(const View& view, const Rectangle& rectangle, bool inside,
                                   const abut_query_filter* filter, std::vector<abut_geometry_id>& out) const;
  [[nodiscard]] abut_status snap(const Aim& aim, abut_snap_kinds kinds, const abut_query_filter* filter,
                                 abut_snap& out) const;
  [[nodiscard]] abut_status weigh(abut_geometry_id id, std::uint32_t face, const abut_vec3& point,
                                  abut_barycentric& out) const;

  // What queries see.
  void set_flags(bool sees_sensors, bool skips_back_faces);
  void set_clip_planes(std::vector<HalfSpace> planes);

 private:
  [[nodiscard]] inline bool is_current() const noexcept {
    return seen_geometries_.load(std::memory_order_acquire) == *counters_.geometries &&
           seen_poses_.load(std::memory_order_acquire) == *counters_.poses;
  }
  // tracer_follow.cpp
  [[nodiscard]] abut_status catch_up();
  [[nodiscard]] abut_status synchronize();
  [[nodiscard]] abut_status follow_changes(bool& is_known);
  [[nodiscard]] abut_status follow_one(abut_geometry_id id);
  [[nodiscard]] abut_status move_entry(std::uint32_t index, const abut_pose& pose);
  [[nodiscard]] std::uint32_t entry_in_slot(std::uint32_t slot) const;
  [[nodiscard]] bool is_met(const GeometryView& view) const;
  void note_box(const Entry& entry);
  [[nodiscard]] abut_status list_geometries();
  [[nodiscard]] abut_status add_entry(abut_geometry_id id, const GeometryView& view);
  [[nodiscard]] abut_status take_place(std::uint32_t index);
  [[nodiscard]] abut_status describe_surface(ShapeRecord& record) const;
  [[nodiscard]] abut_status find_shape(abut_geometry_id id, std::uintptr_t key, std::uint32_t& out);
  [[nodiscard]] abut_status follow_poses();
  [[nodiscard]] abut_status place_box(Entry& entry) const;
  void remove_entry(std::uint32_t index);
  void leave_place(Entry& entry);
  void leave_moving(MovingScene& moving, bool is_first, std::uint32_t place);
  void release_shape(std::uint32_t index);
  void forget_everything();
  // tracer_build.cpp, tracer_build_moving.cpp
  [[nodiscard]] abut_status build();
  [[nodiscard]] abut_status make_device();
  [[nodiscard]] abut_status build_still();
  [[nodiscard]] embree::Scene make_still(RTCDevice device, bool is_robust);
  [[nodiscard]] bool attach(RTCDevice device, RTCScene scene, std::size_t place, const TriangleList& list);
  [[nodiscard]] abut_status build_moving();
  [[nodiscard]] abut_status make_instanced(ShapeRecord& shape);
  [[nodiscard]] abut_status become_moving(std::uint32_t index);
  [[nodiscard]] abut_status embree_status() const;
  template <class Write>
  [[nodiscard]] embree::Geometry make_polygons(RTCDevice device, std::size_t count, std::size_t sides,
                                               const Write& write);
  [[nodiscard]] embree::Geometry make_triangles(RTCDevice device, const TriangleList& list, const Space& space,
                                                Outlines outlines);
  [[nodiscard]] embree::Geometry make_quads(RTCDevice device, const TriangleList& list, const Space& space);
  [[nodiscard]] bool prefers_quads() const;
  void move_up(std::uint8_t level);
  [[nodiscard]] abut_status commit(MovingScene& moving);
  void settle_still_space();
  void settle_usual_rays();
  static void report_bounds(const RTCBoundsFunctionArguments* arguments);
  // tracer_meet.cpp
  static void report_hits(const RTCIntersectFunctionNArguments* arguments);
  [[nodiscard]] bool is_nearer(const abut_ray_hit& hit, const Entry& entry, const FirstHit& query,
                               std::uint32_t present, double limit) const;
  void meet(FirstHit& query, const MovingScene& moving, const RTCIntersectFunctionNArguments& arguments) const;
  void meet_moving(FirstHit& query, const MovingScene& moving, abut_pick& out, bool& is_exact) const;
  // tracer_all.cpp
  [[nodiscard]] abut_status cross(AllHits& query, std::uint32_t index) const;
  [[nodiscard]] abut_status cross_surface(AllHits& query, const Entry& entry, const ShapeRecord& shape) const;
  static void cross_exact(AllHits& query, const Entry& entry, const ShapeRecord& shape);
  [[nodiscard]] abut_status make_crossed(const ShapeRecord& shape) const;
  // tracer_cut.cpp
  [[nodiscard]] bool trim(abut_ray& ray, double& skipped) const;
  [[nodiscard]] bool is_kept(const abut_vec3& point) const;
  [[nodiscard]] bool is_behind(const Baked& baked, const RTCFilterFunctionNArguments& arguments, unsigned ray) const;
  [[nodiscard]] std::optional<abut_ray_hit> cast_seen(const Entry& entry, const abut_ray& ray) const;
  // tracer_any.cpp
  static void report_any(const RTCOccludedFunctionNArguments* arguments);
  [[nodiscard]] bool meets_entry(const Entry& entry, const abut_ray& ray) const;
  [[nodiscard]] bool meets_moving(const abut_ray& ray, const abut_query_filter* filter) const;
  [[nodiscard]] bool asks_about_hits(const abut_query_filter* filter) const {
    return filter != nullptr || skips_back_faces_;
  }
  // tracer_select.cpp, tracer_snap.cpp
  [[nodiscard]] abut_status touching_at_edges(const View& view, const Rectangle& rectangle,
                                              std::span<const std::uint32_t> entries,
                                              std::vector<std::uint32_t>& out) const;
  [[nodiscard]] bool is_visible(const View& view, const abut_query_filter* filter, abut_snap& snap) const;
  [[nodiscard]] abut_status make_wires(const ShapeRecord& shape) const;
  // tracer_trace.cpp
  [[nodiscard]] inline bool has_moving() const noexcept {
    return !apart_.empty() || !std::ranges::all_of(moving_, &MovingScene::is_empty);
  }
  void trace_moving(const abut_ray& ray, const abut_query_filter* filter, abut_pick& out) const;
  // tracer_near.cpp
  [[nodiscard]] bool pick_thin(const Aim& aim, const abut_query_filter* filter, abut_pick& out) const;
  [[nodiscard]] abut_status pick_near(const Aim& aim, const abut_query_filter* filter, abut_pick& out) const;
  void meet_apart(const abut_query_filter* filter, abut_ray& ray, abut_pick& out) const;
  [[nodiscard]] inline const Facet& plane_of(const Baked& baked, std::uint32_t triangle) const {
    return still_planes_[baked.first_plane + triangle];
  }
  // Asks for the planes on both sides of one: the next ray of a picture mostly meets a neighbour of the triangle, and
  // neighbours are mostly near each other in a mesh.
  [[gnu::always_inline]] inline void prefetch_beside(const Baked& baked, std::uint32_t triangle) const {
    const std::size_t place = baked.first_plane + triangle;
    __builtin_prefetch(&still_planes_[place - planes_beside]);
    __builtin_prefetch(&still_planes_[place - planes_beside / 2]);
    __builtin_prefetch(&still_planes_[place + planes_beside / 2]);
    __builtin_prefetch(&still_planes_[place + planes_beside]);
  }
  [[nodiscard]] inline std::uint32_t face_of(const Baked& baked, std::uint32_t triangle) const {
    if (baked.first_face == nowhere) [[likely]]
      return triangle;
    return still_faces_[std::size_t{baked.first_face} + triangle];
  }
  // Whether the ray reaches the plane of a triangle on which a hit was found; `from` and `along` are
  // the halves of a ray with a unit direction, the fourth number of `along` is not looked at.
  [[gnu::always_inline]] inline bool resolve_still(const Four& from, const Four& along, double limit, const RTCHit& hit,
                                                   double found, abut_pick& out) const {
    const Baked& baked = baked_[hit.geomID];
    const std::uint32_t triangle = triangle_of(baked, hit.primID, hit.u, hit.v);
    const Four plane = numbers_of(plane_of(baked, triangle));
    prefetch_beside(baked, triangle);
    const double distance = distance_to(plane, from - still_space_.numbers(), along, found, still_space_.extent);
    if (distance > limit) return false;
    const Four end = from + along * distance;
    out.geometry = baked.id;
    out.feature = {ABUT_FEATURE_FACE, face_of(baked, triangle)};
    out.child = 0;
    out.reserved = 0;
    out.distance = distance;
    out.point = {end[0], end[1], end[2]};
    out.normal = {plane[0], plane[1], plane[2]};
    return true;
  }
  void resolve_instance(const abut_ray& ray, const Entry& entry, std::uint32_t triangle, double found,
                        abut_pick& out) const;
  friend struct PacketTracer;
  friend void reject_hits(const RTCFilterFunctionNArguments* arguments);
  friend void reject_any(const RTCFilterFunctionNArguments* arguments);

  std::unique_ptr<Source> source_;
  Counters counters_;
  std::mutex mutex_;
  std::atomic<std::uint64_t> seen_geometries_{never};
  std::atomic<std::uint64_t> seen_poses_{never};

  bool sees_sensors_ = false;
  bool skips_back_faces_ = false;
  std::vector<HalfSpace> clip_planes_;

  std::uint64_t epoch_ = 0;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> free_entries_;
  std::vector<std::uint32_t> entry_of_slot_;  // by slot of the geometry id
  BoxTable boxes_;                            // of entries that are not apart
  std::vector<ShapeRecord> shapes_;
  std::vector<std::uint32_t> free_shapes_;
  std::unordered_map<std::uintptr_t, std::uint32_t> shape_of_key_;  // looked up, never walked
  std::vector<std::uint32_t> arrivals_;                             // surfaces without a place yet

  embree::Device device_;
  embree::Device single_device_;  // for rays one by one; none where the other serves them as well
  std::size_t widest_ = 4;        // rays in the largest packet that the processor holds in registers
  Space still_space_;
  embree::Scene still_;
  embree::Scene single_still_;  // the same, for rays one by one
  std::vector<Baked> baked_;
  Surface still_planes_;                    // relative to the space; `planes_beside` more at both ends
  std::vector<std::uint32_t> still_faces_;  // of triangles that are not faces themselves
  Four usual_reach_ = -1;                   // of the coordinates of a usual ray in the space; none when negative
  bool still_changed_ = false;
  std::array<MovingScene, level_count> moving_;
  std::vector<std::uint32_t> apart_;
  std::size_t thin_count_ = 0;  // entries that are points or segments
  mutable std::mutex crossed_mutex_;
};

template <std::size_t Width>
struct Batch;

// Rays in packets (tracer_packet.cpp).
struct PacketTracer {
  template <std::size_t Width, class Expect, class Fill, class Place>
  static void trace(const Tracer& tracer, Trace& query, std::size_t count, const Expect& expect, const Fill& fill,
                    const Place& place);
  template <std::size_t Width>
  static void shoot(const Tracer& tracer, embree::Query& query, Batch<Width>& batch);
  template <std::size_t Width, class Place>
  static void prefetch_picks(const Batch<Width>& batch, const Place& place);
  template <std::size_t Width>
  static void prefetch_planes(const Tracer& tracer, const Batch<Width>& batch);
  template <std::size_t Width, class Place>
  static void finish(const Tracer& tracer, const Trace& query, Batch<Width>& batch, const Place& place);
  template <std::size_t Width, class Place>
  static void resolve_four(const Tracer& tracer, const Batch<Width>& batch, std::size_t k, const Place& place);
  template <std::size_t Width>
  static void read(Batch<Width>& batch, std::span<const abut_ray, Width> rays);
  template <std::size_t Width, class Place>
  static void trace_moving(const Tracer& tracer, const Trace& query, const Batch<Width>& batch, const Place& place);
  template <std::size_t Width>
  static void load(Batch<Width>& batch, std::span<const abut_ray> rays);
  template <std::size_t Width>
  static void trace_batch(const Tracer& tracer, std::span<const abut_ray> rays, Trace& query, std::span<abut_pick> out);
  template <std::size_t Width>
  static void meet_batch(const Tracer& tracer, std::span<const abut_ray> rays, AnyHit& query,
                         std::span<std::uint32_t> out);
  template <std::size_t Width>
  static void render(const Tracer& tracer, const abut_camera& camera, Trace& query, std::span<abut_pick> out);
};

// A miss.
[[nodiscard]] inline abut_pick nothing() { return {{0, 0}, {0, 0}, 0, 0, infinity, {0, 0, 0}, {0, 0, 0}}; }

[[nodiscard]] inline abut_pick pick_of(const abut_geometry_id& id, const abut_ray_hit& hit) {
  return {id, hit.feature, hit.child, 0, hit.distance, hit.point, hit.normal};
}

}  // namespace abut::picking
