// SPDX-License-Identifier: Apache-2.0
// What the scene of rays holds: geometries, the shapes that they share, and where a geometry lies in the scene.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

module abut.picking:entry;
import :box_scene;
import :crossing;
import :source;
import :surface;
import :vector;

namespace abut::picking {

inline constexpr std::uint32_t nowhere = ~std::uint32_t{0};
// In a hit: the rest of the geometry number is an entry, not the number of a baked surface.
inline constexpr std::uint32_t entry_flag = std::uint32_t{1} << 31u;

enum class Role : std::uint8_t { baked, instance, exact, apart };

// A geometry.
struct Entry {
  abut_geometry_id id{};
  std::uint32_t shape = nowhere;
  std::uint32_t place = nowhere;  // in baked_, in a level of moving_, or in apart_
  Role role = Role::exact;
  std::uint8_t level = 0;   // of those with a box
  std::uint64_t epoch = 0;  // when it was last listed
  Traits traits{};
  abut_pose pose{};
  Frame frame;
  abut_aabb box = empty_box;  // world
};

// Whether a filter lets rays meet a geometry; null lets them meet all.
[[nodiscard]] inline bool admits(const abut_query_filter* filter, const Entry& entry) noexcept {
  if (filter == nullptr) return true;
  const Traits& its = entry.traits;
  const auto is = [](const auto& ignored, const auto& id) {
    return ignored.slot != 0 && ignored.slot == id.slot && ignored.generation == id.generation;
  };
  const bool skips_sensors = (filter->flags & ABUT_QUERY_FILTER_SKIP_SENSORS) != 0;
  return (its.layers & filter->mask) != 0 && (its.mask & filter->layers) != 0 && !(skips_sensors && its.is_sensor) &&
         !is(filter->ignore_part, its.part) && !is(filter->ignore_geometry, entry.id);
}

// A surface in the frame of its shape with a scene of its own.
struct Instanced {
  Space space;
  Surface surface;
  embree::Scene scene;
};

// What a cursor snaps to: vertices that triangles use, and edges by their ends.
struct Wires {
  std::vector<double> xyz;
  std::vector<std::uint32_t> vertices;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

// A shape, shared by entries.
struct ShapeRecord {
  std::uintptr_t key = 0;
  std::unique_ptr<PickableShape> access;
  std::uint32_t users = 0;
  std::size_t triangle_count = 0;
  bool is_surface = false;
  bool is_paired = false;            // a surface whose triangles come in pairs
  bool is_steep = false;             // of these, one that is there twice
  abut_aabb local_box = empty_box;   // of a surface
  std::vector<std::uint32_t> faces;  // of its triangles, of a surface; empty when they are the faces
  std::optional<RoundedSegment> rounded;
  std::unique_ptr<Instanced> instanced;  // made when first needed
  // The same, by a query: under the lock of the tracer.
  mutable std::unique_ptr<const CrossedSurface> crossed;
  mutable std::unique_ptr<const Wires> wires;

  [[nodiscard]] bool is_thin() const noexcept { return rounded && rounded->radius == 0; }
};

// A surface as it lies in the world. Found by a shift, since each hit asks for it.
struct alignas(32) Baked {
  abut_geometry_id id{};
  std::uint32_t entry = nowhere;
  std::uint32_t first_face = nowhere;  // in the faces of the still scene; nowhere when its triangles are the faces
  bool has_quads = false;              // of two triangles each
  std::uint8_t shift = 0;              // 1 where each triangle is there twice
  std::size_t first_plane = 0;         // in the planes of the still scene
};
static_assert(sizeof(Baked) == 32);

// The triangle that was hit. The coordinates on a quad are those on its first half, or 1 minus those
// on its second one.
[[nodiscard]] [[gnu::always_inline]] inline std::uint32_t triangle_of(const Baked& baked, std::uint32_t primitive,
                                                                      float u, float v) {
  return baked.has_quads ? 2 * primitive + (u + v > 1 ? 1u : 0u) : primitive >> baked.shift;
}

struct MovingBox {
  FloatBox box;
  std::uint32_t entry;  // nowhere where it has left
};

// Boxes of geometries that are traced one by one. Which of several such scenes a box is in is its level.
struct MovingScene {
  Space space;
  embree::Geometry geometry;
  embree::Scene scene;
  std::vector<MovingBox> boxes;
  std::size_t left = 0;  // boxes without an entry
  bool is_changed = false;

  [[nodiscard]] inline bool is_empty() const noexcept { return boxes.size() == left; }
};

}  // namespace abut::picking
