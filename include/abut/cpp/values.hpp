// SPDX-License-Identifier: Apache-2.0
// The values of the C interface under names of C++. They are the same types, so either name fits everywhere.
#ifndef ABUT_CPP_VALUES_HPP
#define ABUT_CPP_VALUES_HPP

#include <abut/abut.h>
#include <abut/cpp/span.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace abut {

using Vec3 = abut_vec3;
using Quat = abut_quat;
using Pose = abut_pose;
using Aabb = abut_aabb;
using Ray = abut_ray;
using Velocity = abut_velocity;
using Acceleration = abut_acceleration;

using PartId = abut_part_id;
using GeometryId = abut_geometry_id;
using ShapeKind = abut_shape_kind;

// Enumerations whose values are those of the C interface: abut::Motion has ABUT_MOTION_STATIC.
using Algorithm = abut_algorithm_value;
using Broadphase = abut_broadphase_value;
using ClosestMethod = abut_closest_method_value;
using CollidableKind = abut_collidable_kind_value;
using Detail = abut_detail_value;
using HitMode = abut_hit_mode_value;
using Motion = abut_motion_value;
using Parking = abut_parking_value;
using Query = abut_query_value;
using RayStart = abut_ray_start_value;
using Rule = abut_rule_value;
using Sides = abut_sides_value;
using MeshTree = abut_mesh_tree_value;
using Axis = abut_axis_value;
using Diagonal = abut_diagonal_value;
using Interpolation = abut_interpolation_value;
using ToleranceMode = abut_tolerance_mode_value;
using VelocitySource = abut_velocity_source_value;

// Answers.
using BackendContact = abut_backend_contact;
using BackendPair = abut_backend_pair;
using CastHit = abut_cast_hit;
using Closest = abut_closest;
using CompositeChild = abut_composite_child;
using Contact = abut_contact;
using Crossing = abut_crossing;
using Distance = abut_distance;
using ElementContact = abut_element_contact;
using ElementCounts = abut_element_counts;
using ElementPair = abut_element_pair;
using Event = abut_event;
using Feature = abut_feature;
using Finding = abut_finding;
using FirstTouch = abut_first_touch;
using Impact = abut_impact;
using ImpactHit = abut_impact_hit;
using ImpactState = abut_impact_state_value;
using Island = abut_island;
using LayoutEntry = abut_layout_entry;
using LocalPoints = abut_local_points;
using Movement = abut_movement;
using QueryHit = abut_query_hit;
using RayHit = abut_ray_hit;
using Revision = abut_revision;
using Route = abut_route;
using SleepChange = abut_sleep_change;
using Stencil = abut_stencil;
using StepImpact = abut_step_impact;
using Collidable = abut_collidable;

// A pose by its parts; pose() is the identity, pose({0, 0, 2}) a place two up.
[[nodiscard]] constexpr Pose pose(Vec3 position = {0, 0, 0}, Quat orientation = {1, 0, 0, 0}) noexcept {
  return {position, orientation};
}

[[nodiscard]] constexpr bool is_null(PartId part) noexcept { return part.slot == 0 && part.generation == 0; }
[[nodiscard]] constexpr bool is_null(GeometryId geometry) noexcept {
  return geometry.slot == 0 && geometry.generation == 0;
}

// What rules speak of.
[[nodiscard]] constexpr Collidable collidable(GeometryId geometry) noexcept {
  return {ABUT_COLLIDABLE_GEOMETRY, geometry.slot, geometry.generation};
}
[[nodiscard]] constexpr Collidable collidable(PartId part) noexcept {
  return {ABUT_COLLIDABLE_PART, part.slot, part.generation};
}
[[nodiscard]] constexpr Collidable all_with_label(std::uint32_t label) noexcept {
  return {ABUT_COLLIDABLE_LABEL, label, 0};
}
[[nodiscard]] constexpr Collidable anything() noexcept { return {ABUT_COLLIDABLE_ANY, 0, 0}; }

// What queries remember of a pair of shapes; begins empty.
struct PairMemory : abut_pair_memory {
  constexpr PairMemory() noexcept : abut_pair_memory{} {}
};

// The rule that counts for two geometries, and the collidables that it names.
struct RuleVerdict {
  Rule rule;
  Collidable a, b;
};

struct PartVelocity {
  Velocity velocity;
  VelocitySource source;
};

// The change counters of a universe, good for as long as the universe is there.
struct Counters {
  const std::uint64_t* geometries;
  const std::uint64_t* poses;
};

struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// Answers of many queries, query after query.
template <class T>
struct Lists {
  std::vector<std::uint64_t> offsets;  // one more than there are queries
  std::vector<T> all;

  [[nodiscard]] std::size_t query_count() const noexcept { return offsets.empty() ? 0 : offsets.size() - 1; }
  [[nodiscard]] Span<const T> of(std::size_t query) const& {
    return {all.data() + offsets.at(query), static_cast<std::size_t>(offsets.at(query + 1) - offsets.at(query))};
  }
  Span<const T> of(std::size_t query) const&& = delete;
};
using GeometryLists = Lists<GeometryId>;
using ContactLists = Lists<Contact>;

}  // namespace abut

// Ids are compared and hashed where they are defined, which is outside of the namespace.
[[nodiscard]] constexpr bool operator==(abut_part_id a, abut_part_id b) noexcept {
  return a.slot == b.slot && a.generation == b.generation;
}
[[nodiscard]] constexpr bool operator!=(abut_part_id a, abut_part_id b) noexcept { return !(a == b); }
[[nodiscard]] constexpr bool operator<(abut_part_id a, abut_part_id b) noexcept {
  return a.slot != b.slot ? a.slot < b.slot : a.generation < b.generation;
}
[[nodiscard]] constexpr bool operator==(abut_geometry_id a, abut_geometry_id b) noexcept {
  return a.slot == b.slot && a.generation == b.generation;
}
[[nodiscard]] constexpr bool operator!=(abut_geometry_id a, abut_geometry_id b) noexcept { return !(a == b); }
[[nodiscard]] constexpr bool operator<(abut_geometry_id a, abut_geometry_id b) noexcept {
  return a.slot != b.slot ? a.slot < b.slot : a.generation < b.generation;
}

template <>
struct std::hash<abut_part_id> {
  [[nodiscard]] std::size_t operator()(abut_part_id id) const noexcept {
    return std::hash<std::uint64_t>()(std::uint64_t{id.generation} << 32 | id.slot);
  }
};
template <>
struct std::hash<abut_geometry_id> {
  [[nodiscard]] std::size_t operator()(abut_geometry_id id) const noexcept {
    return std::hash<std::uint64_t>()(std::uint64_t{id.generation} << 32 | id.slot);
  }
};

#endif
