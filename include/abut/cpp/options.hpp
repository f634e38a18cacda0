// SPDX-License-Identifier: Apache-2.0
// Options with the defaults of the library. Fields are those of the C structs, where abut.h describes them; change them
// in place, or name them: PartOptions().with_motion(ABUT_MOTION_STATIC).with_pose(pose({0, 0, 2})).
#ifndef ABUT_CPP_OPTIONS_HPP
#define ABUT_CPP_OPTIONS_HPP

#include <abut/abut.h>
#include <abut/cpp/values.hpp>

#include <cstdint>

namespace abut {

// A C struct that begins with the defaults of the library.
template <class Self, class Struct, void (*init)(Struct*, std::uint32_t)>
struct Defaulted : Struct {
  Defaulted() noexcept : Struct() { init(this, sizeof(Struct)); }

 protected:
  template <class Field, class Value>
  [[nodiscard]] Self with(Field Struct::* field, Value value) const noexcept {
    Self changed = static_cast<const Self&>(*this);
    changed.*field = value;
    return changed;
  }
};

struct UniverseOptions : Defaulted<UniverseOptions, abut_universe_options, abut_universe_options_init> {
  using C = abut_universe_options;
  [[nodiscard]] UniverseOptions with_broadphase(Broadphase value) const { return with(&C::broadphase, value); }
  [[nodiscard]] UniverseOptions with_tolerance_mode(ToleranceMode value) const {
    return with(&C::tolerance_mode, value);
  }
  [[nodiscard]] UniverseOptions with_max_contacts(std::uint32_t value) const { return with(&C::max_contacts, value); }
  [[nodiscard]] UniverseOptions with_max_pair_contacts(std::uint32_t value) const {
    return with(&C::max_pair_contacts, value);
  }
  [[nodiscard]] UniverseOptions with_origin(Vec3 value) const { return with(&C::origin, value); }
  [[nodiscard]] UniverseOptions with_threads(std::uint32_t value) const { return with(&C::threads, value); }
  [[nodiscard]] UniverseOptions with_events(abut_event_bits value) const { return with(&C::events, value); }
  [[nodiscard]] UniverseOptions with_flags(abut_universe_flags value) const { return with(&C::flags, value); }
};

struct PartOptions : Defaulted<PartOptions, abut_part_options, abut_part_options_init> {
  using C = abut_part_options;
  [[nodiscard]] PartOptions with_motion(Motion value) const { return with(&C::motion, value); }
  [[nodiscard]] PartOptions with_pose(const Pose& value) const { return with(&C::pose, value); }
  [[nodiscard]] PartOptions with_user_data(std::uint64_t value) const { return with(&C::user_data, value); }
};

struct GeometryOptions : Defaulted<GeometryOptions, abut_geometry_options, abut_geometry_options_init> {
  using C = abut_geometry_options;
  [[nodiscard]] GeometryOptions with_flags(abut_geometry_flags value) const { return with(&C::flags, value); }
  [[nodiscard]] GeometryOptions with_pose(const Pose& value) const { return with(&C::pose, value); }
  [[nodiscard]] GeometryOptions with_tolerance(double value) const { return with(&C::tolerance, value); }
  [[nodiscard]] GeometryOptions with_user_data(std::uint64_t value) const { return with(&C::user_data, value); }
  [[nodiscard]] GeometryOptions with_layers(std::uint64_t value) const { return with(&C::layers, value); }
  [[nodiscard]] GeometryOptions with_mask(std::uint64_t value) const { return with(&C::mask, value); }
  [[nodiscard]] GeometryOptions with_exclusion(std::uint64_t value) const { return with(&C::exclusion, value); }
  [[nodiscard]] GeometryOptions with_label(std::uint32_t value) const { return with(&C::label, value); }
  [[nodiscard]] GeometryOptions with_tag(std::uint32_t value) const { return with(&C::tag, value); }
  [[nodiscard]] GeometryOptions with_material(std::uint32_t value) const { return with(&C::material, value); }
  [[nodiscard]] GeometryOptions with_parking(Parking value) const { return with(&C::parking, value); }
};

struct MeshOptions : Defaulted<MeshOptions, abut_mesh_options, abut_mesh_options_init> {
  using C = abut_mesh_options;
  [[nodiscard]] MeshOptions with_sides(Sides value) const { return with(&C::sides, value); }
  [[nodiscard]] MeshOptions with_corners(std::uint32_t value) const { return with(&C::corners, value); }
  [[nodiscard]] MeshOptions with_tree(MeshTree value) const { return with(&C::tree, value); }
  // Of vertices within a distance.
  [[nodiscard]] MeshOptions with_merging(double distance) const {
    return with(&C::merges_vertices, 1u).with(&C::merge_distance, distance);
  }
};

struct UvGridOptions : Defaulted<UvGridOptions, abut_uv_grid_options, abut_uv_grid_options_init> {
  [[nodiscard]] UvGridOptions with_sides(Sides value) const { return with(&abut_uv_grid_options::sides, value); }
  [[nodiscard]] UvGridOptions with_axes(Axis u, Axis v) const {
    return with(&abut_uv_grid_options::axis_u, u).with(&abut_uv_grid_options::axis_v, v);
  }
  [[nodiscard]] UvGridOptions with_cells(std::uint32_t u, std::uint32_t v) const {
    return with(&abut_uv_grid_options::cells_u, u).with(&abut_uv_grid_options::cells_v, v);
  }
  [[nodiscard]] UvGridOptions with_corners(std::uint32_t value) const {
    return with(&abut_uv_grid_options::corners, value);
  }
  [[nodiscard]] UvGridOptions with_merging(double distance) const {
    return with(&abut_uv_grid_options::merges_vertices, 1u).with(&abut_uv_grid_options::merge_distance, distance);
  }
};

struct ImpactOptions : Defaulted<ImpactOptions, abut_impact_options, abut_impact_options_init> {
  using C = abut_impact_options;
  [[nodiscard]] ImpactOptions with_most_rounds(std::uint32_t value) const { return with(&C::most_rounds, value); }
  [[nodiscard]] ImpactOptions with_tolerance(double value) const { return with(&C::tolerance, value); }
  [[nodiscard]] ImpactOptions with_margin(double value) const { return with(&C::margin, value); }
  [[nodiscard]] ImpactOptions with_threads(std::uint32_t value) const { return with(&C::threads, value); }
};

struct ElementsOptions : Defaulted<ElementsOptions, abut_elements_options, abut_elements_options_init> {
  using C = abut_elements_options;
  [[nodiscard]] ElementsOptions with_method(ClosestMethod value) const { return with(&C::method, value); }
  [[nodiscard]] ElementsOptions with_kinds(abut_stencil_kinds value) const { return with(&C::kinds, value); }
  [[nodiscard]] ElementsOptions with_flags(abut_elements_flags value) const { return with(&C::flags, value); }
  [[nodiscard]] ElementsOptions with_threads(std::uint32_t value) const { return with(&C::threads, value); }
  [[nodiscard]] ElementsOptions with_reach(double value) const { return with(&C::reach, value); }
  [[nodiscard]] ElementsOptions with_tolerance(double value) const { return with(&C::tolerance, value); }
  [[nodiscard]] ElementsOptions with_rest_distance(double value) const { return with(&C::rest_distance, value); }
  [[nodiscard]] ElementsOptions with_cone_angle(double value) const { return with(&C::cone_angle, value); }
  [[nodiscard]] ElementsOptions with_cone_factor(double value) const { return with(&C::cone_factor, value); }
};

struct QueryOptions : Defaulted<QueryOptions, abut_query_options, abut_query_options_init> {
  using C = abut_query_options;
  [[nodiscard]] QueryOptions with_algorithm(Algorithm value) const { return with(&C::algorithm, value); }
  [[nodiscard]] QueryOptions with_error_bound(double value) const { return with(&C::error_bound, value); }
  [[nodiscard]] QueryOptions with_margin(double value) const { return with(&C::margin, value); }
  [[nodiscard]] QueryOptions with_max_contacts(std::uint32_t value) const { return with(&C::max_contacts, value); }
  [[nodiscard]] QueryOptions with_max_pair_contacts(std::uint32_t value) const {
    return with(&C::max_pair_contacts, value);
  }
  [[nodiscard]] QueryOptions with_threads(std::uint32_t value) const { return with(&C::threads, value); }
  [[nodiscard]] QueryOptions with_flags(abut_query_flags value) const { return with(&C::flags, value); }
  [[nodiscard]] QueryOptions with_time_budget(double value) const { return with(&C::time_budget, value); }
};

struct QueryFilter : Defaulted<QueryFilter, abut_query_filter, abut_query_filter_init> {
  using C = abut_query_filter;
  [[nodiscard]] QueryFilter with_flags(abut_query_filter_flags value) const { return with(&C::flags, value); }
  [[nodiscard]] QueryFilter with_layers(std::uint64_t value) const { return with(&C::layers, value); }
  [[nodiscard]] QueryFilter with_mask(std::uint64_t value) const { return with(&C::mask, value); }
  [[nodiscard]] QueryFilter with_ignore_part(PartId value) const { return with(&C::ignore_part, value); }
  [[nodiscard]] QueryFilter with_ignore_geometry(GeometryId value) const { return with(&C::ignore_geometry, value); }
  [[nodiscard]] QueryFilter with_ray_start(RayStart value) const { return with(&C::ray_start, value); }
};

struct Sleep : Defaulted<Sleep, abut_sleep, abut_sleep_init> {
  using C = abut_sleep;
  [[nodiscard]] Sleep with_steps(std::uint32_t value) const { return with(&C::steps, value); }
  [[nodiscard]] Sleep with_linear_speed(double value) const { return with(&C::linear_speed, value); }
  [[nodiscard]] Sleep with_linear_acceleration(double value) const { return with(&C::linear_acceleration, value); }
  [[nodiscard]] Sleep with_angular_speed(double value) const { return with(&C::angular_speed, value); }
  [[nodiscard]] Sleep with_angular_acceleration(double value) const { return with(&C::angular_acceleration, value); }
};

struct Policy : Defaulted<Policy, abut_policy, abut_policy_init> {
  using C = abut_policy;
  [[nodiscard]] Policy with_algorithm(Algorithm value) const { return with(&C::algorithm, value); }
  [[nodiscard]] Policy with_detail(Detail value) const { return with(&C::detail, value); }
  [[nodiscard]] Policy with_period(std::uint32_t value) const { return with(&C::period, value); }
  [[nodiscard]] Policy with_tolerance(double value) const { return with(&C::tolerance, value); }
  [[nodiscard]] Policy with_error_bound(double value) const { return with(&C::error_bound, value); }
  [[nodiscard]] Policy with_time_budget(double value) const { return with(&C::time_budget, value); }
  // The following are looked at for ABUT_DETAIL_ELEMENTS alone.
  [[nodiscard]] Policy with_method(ClosestMethod value) const { return with(&C::method, value); }
  [[nodiscard]] Policy with_kinds(abut_stencil_kinds value) const { return with(&C::kinds, value); }
  [[nodiscard]] Policy with_flags(abut_elements_flags value) const { return with(&C::flags, value); }
  [[nodiscard]] Policy with_contact_distance(double value) const { return with(&C::contact_distance, value); }
  [[nodiscard]] Policy with_rest_distance(double value) const { return with(&C::rest_distance, value); }
  [[nodiscard]] Policy with_cone_angle(double value) const { return with(&C::cone_angle, value); }
  [[nodiscard]] Policy with_cone_factor(double value) const { return with(&C::cone_factor, value); }
};

struct Focus : Defaulted<Focus, abut_focus, abut_focus_init> {
  using C = abut_focus;
  [[nodiscard]] Focus with_near(std::uint32_t tag, double distance) const {
    return with(&C::near_tag, tag).with(&C::near_distance, distance);
  }
  [[nodiscard]] Focus with_far(std::uint32_t tag, double distance) const {
    return with(&C::far_tag, tag).with(&C::far_distance, distance);
  }
};

// Its numbers are the caller's own; abut applies none of them.
struct ContactMaterial : Defaulted<ContactMaterial, abut_contact_material, abut_contact_material_init> {
  using C = abut_contact_material;
  [[nodiscard]] ContactMaterial with_friction(double primary, double secondary) const {
    return with(&C::friction_primary, primary).with(&C::friction_secondary, secondary);
  }
  [[nodiscard]] ContactMaterial with_friction_spin(double value) const { return with(&C::friction_spin, value); }
  [[nodiscard]] ContactMaterial with_friction_roll(double value) const { return with(&C::friction_roll, value); }
  [[nodiscard]] ContactMaterial with_static_scale(double value) const { return with(&C::static_scale, value); }
  [[nodiscard]] ContactMaterial with_slip(double value) const { return with(&C::slip, value); }
  [[nodiscard]] ContactMaterial with_compliance(double value) const { return with(&C::compliance, value); }
  [[nodiscard]] ContactMaterial with_damping(double value) const { return with(&C::damping, value); }
  [[nodiscard]] ContactMaterial with_restitution(double value) const { return with(&C::restitution, value); }
  [[nodiscard]] ContactMaterial with_restitution_threshold(double value) const {
    return with(&C::restitution_threshold, value);
  }
  [[nodiscard]] ContactMaterial with_adhesive_force(double value) const { return with(&C::adhesive_force, value); }
};

// Answers that grow over time.
struct HullReport : Defaulted<HullReport, abut_hull_report, abut_hull_report_init> {};
struct DistanceFieldReport
    : Defaulted<DistanceFieldReport, abut_distance_field_report, abut_distance_field_report_init> {};
struct MeshReport : Defaulted<MeshReport, abut_mesh_report, abut_mesh_report_init> {};
struct GeometryInfo : Defaulted<GeometryInfo, abut_geometry_info, abut_geometry_info_init> {};
struct StepStats : Defaulted<StepStats, abut_step_stats, abut_step_stats_init> {};

// Arrays of these are handed to the library as arrays of the structs that they are derived from.
static_assert(sizeof(PartOptions) == sizeof(abut_part_options) && sizeof(Sleep) == sizeof(abut_sleep) &&
              sizeof(GeometryOptions) == sizeof(abut_geometry_options) &&
              sizeof(PairMemory) == sizeof(abut_pair_memory));

}  // namespace abut

#endif
