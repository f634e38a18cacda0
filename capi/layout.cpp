// SPDX-License-Identifier: Apache-2.0
// The memory layout of every public struct: fixed here, and reported to bindings.
#include "border.hpp"
#include "guard.hpp"

import abut.core;

using namespace abut::capi;

static_assert(sizeof(void*) == 8 && sizeof(std::size_t) == 8, "the sizes below are those of 64-bit platforms");

namespace {

// Plain data of a size that never changes.
template <class Struct>
constexpr bool is_plain(std::size_t size) {
  return std::is_standard_layout_v<Struct> && std::is_trivially_copyable_v<Struct> && sizeof(Struct) == size &&
         alignof(Struct) <= 8;
}

static_assert(is_plain<abut_vec3>(24));
static_assert(is_plain<abut_quat>(32));
static_assert(is_plain<abut_pose>(56));
static_assert(is_plain<abut_aabb>(48));
static_assert(is_plain<abut_part_id>(8));
static_assert(is_plain<abut_geometry_id>(8));
static_assert(is_plain<abut_feature>(8));
static_assert(is_plain<abut_hull_report>(48));
static_assert(is_plain<abut_mesh_options>(32));
static_assert(is_plain<abut_mesh_report>(120));
static_assert(is_plain<abut_uv_grid_options>(40));
static_assert(is_plain<abut_distance_field_desc>(80));
static_assert(is_plain<abut_distance_field_options>(32));
static_assert(is_plain<abut_distance_field_report>(56));
static_assert(is_plain<abut_height_field_desc>(48));
static_assert(is_plain<abut_shape_desc>(56));
static_assert(is_plain<abut_ray>(56));
static_assert(is_plain<abut_ray_hit>(72));
static_assert(is_plain<abut_query_options>(40));
static_assert(is_plain<abut_distance>(104));
static_assert(is_plain<abut_contact>(192));
static_assert(is_plain<abut_pair_memory>(64));
static_assert(is_plain<abut_first_touch>(24));
static_assert(is_plain<abut_movement>(120));
static_assert(is_plain<abut_impact_options>(32));
static_assert(is_plain<abut_impact>(136));
static_assert(is_plain<abut_impact_hit>(144));
static_assert(is_plain<abut_local_points>(48));
static_assert(is_plain<abut_universe_options>(56));
static_assert(is_plain<abut_part_options>(72));
static_assert(is_plain<abut_geometry_options>(120));
static_assert(is_plain<abut_geometry_info>(200));
static_assert(is_plain<abut_revision>(16));
static_assert(is_plain<abut_collidable>(12));
static_assert(is_plain<abut_policy>(32));
static_assert(is_plain<abut_focus>(32));
static_assert(is_plain<abut_contact_material>(96));
static_assert(is_plain<abut_sleep>(40));
static_assert(is_plain<abut_event>(40));
static_assert(is_plain<abut_sleep_change>(16));
static_assert(is_plain<abut_step_stats>(160));
static_assert(is_plain<abut_finding>(192));
static_assert(is_plain<abut_island>(16));
static_assert(is_plain<abut_velocity>(48));
static_assert(is_plain<abut_acceleration>(48));
static_assert(is_plain<abut_step_impact>(48));
static_assert(is_plain<abut_layout_entry>(32));

#define ABUT_STRUCT(type) \
  abut_layout_entry { #type, "", 0, sizeof(type) }
#define ABUT_FIELD(type, field) \
  abut_layout_entry { #type, #field, offsetof(type, field), sizeof(type::field) }

constexpr auto layout = std::to_array<abut_layout_entry>({
    ABUT_STRUCT(abut_vec3),
    ABUT_FIELD(abut_vec3, x),
    ABUT_FIELD(abut_vec3, y),
    ABUT_FIELD(abut_vec3, z),
    ABUT_STRUCT(abut_quat),
    ABUT_FIELD(abut_quat, w),
    ABUT_FIELD(abut_quat, x),
    ABUT_FIELD(abut_quat, y),
    ABUT_FIELD(abut_quat, z),
    ABUT_STRUCT(abut_pose),
    ABUT_FIELD(abut_pose, position),
    ABUT_FIELD(abut_pose, orientation),
    ABUT_STRUCT(abut_aabb),
    ABUT_FIELD(abut_aabb, minimum),
    ABUT_FIELD(abut_aabb, maximum),
    ABUT_STRUCT(abut_part_id),
    ABUT_FIELD(abut_part_id, slot),
    ABUT_FIELD(abut_part_id, generation),
    ABUT_STRUCT(abut_geometry_id),
    ABUT_FIELD(abut_geometry_id, slot),
    ABUT_FIELD(abut_geometry_id, generation),
    ABUT_STRUCT(abut_feature),
    ABUT_FIELD(abut_feature, kind),
    ABUT_FIELD(abut_feature, index),
    ABUT_STRUCT(abut_hull_report),
    ABUT_FIELD(abut_hull_report, struct_size),
    ABUT_FIELD(abut_hull_report, dimension),
    ABUT_FIELD(abut_hull_report, point_count),
    ABUT_FIELD(abut_hull_report, vertex_count),
    ABUT_FIELD(abut_hull_report, edge_count),
    ABUT_FIELD(abut_hull_report, face_count),
    ABUT_FIELD(abut_hull_report, error),
    ABUT_STRUCT(abut_mesh_options),
    ABUT_FIELD(abut_mesh_options, struct_size),
    ABUT_FIELD(abut_mesh_options, sides),
    ABUT_FIELD(abut_mesh_options, corners),
    ABUT_FIELD(abut_mesh_options, merges_vertices),
    ABUT_FIELD(abut_mesh_options, merge_distance),
    ABUT_FIELD(abut_mesh_options, tree),
    ABUT_FIELD(abut_mesh_options, reserved),
    ABUT_STRUCT(abut_mesh_report),
    ABUT_FIELD(abut_mesh_report, struct_size),
    ABUT_FIELD(abut_mesh_report, reserved),
    ABUT_FIELD(abut_mesh_report, triangles),
    ABUT_FIELD(abut_mesh_report, vertices),
    ABUT_FIELD(abut_mesh_report, merged_vertices),
    ABUT_FIELD(abut_mesh_report, collapsed_triangles),
    ABUT_FIELD(abut_mesh_report, duplicate_vertices),
    ABUT_FIELD(abut_mesh_report, duplicate_triangles),
    ABUT_FIELD(abut_mesh_report, slivers),
    ABUT_FIELD(abut_mesh_report, open_edges),
    ABUT_FIELD(abut_mesh_report, non_manifold_edges),
    ABUT_FIELD(abut_mesh_report, reversed_triangles),
    ABUT_FIELD(abut_mesh_report, twisted_patches),
    ABUT_FIELD(abut_mesh_report, components),
    ABUT_FIELD(abut_mesh_report, merge_error),
    ABUT_FIELD(abut_mesh_report, volume),
    ABUT_STRUCT(abut_uv_grid_options),
    ABUT_FIELD(abut_uv_grid_options, struct_size),
    ABUT_FIELD(abut_uv_grid_options, sides),
    ABUT_FIELD(abut_uv_grid_options, axis_u),
    ABUT_FIELD(abut_uv_grid_options, axis_v),
    ABUT_FIELD(abut_uv_grid_options, cells_u),
    ABUT_FIELD(abut_uv_grid_options, cells_v),
    ABUT_FIELD(abut_uv_grid_options, corners),
    ABUT_FIELD(abut_uv_grid_options, merges_vertices),
    ABUT_FIELD(abut_uv_grid_options, merge_distance),
    ABUT_STRUCT(abut_height_field_desc),
    ABUT_FIELD(abut_height_field_desc, struct_size),
    ABUT_FIELD(abut_height_field_desc, diagonal),
    ABUT_FIELD(abut_height_field_desc, columns),
    ABUT_FIELD(abut_height_field_desc, rows),
    ABUT_FIELD(abut_height_field_desc, spacing_x),
    ABUT_FIELD(abut_height_field_desc, spacing_y),
    ABUT_FIELD(abut_height_field_desc, heights),
    ABUT_FIELD(abut_height_field_desc, below),
    ABUT_FIELD(abut_height_field_desc, reserved),
    ABUT_STRUCT(abut_distance_field_desc),
    ABUT_FIELD(abut_distance_field_desc, struct_size),
    ABUT_FIELD(abut_distance_field_desc, is_inside_out),
    ABUT_FIELD(abut_distance_field_desc, columns),
    ABUT_FIELD(abut_distance_field_desc, rows),
    ABUT_FIELD(abut_distance_field_desc, layers),
    ABUT_FIELD(abut_distance_field_desc, interpolation),
    ABUT_FIELD(abut_distance_field_desc, spacing),
    ABUT_FIELD(abut_distance_field_desc, origin),
    ABUT_FIELD(abut_distance_field_desc, values),
    ABUT_STRUCT(abut_distance_field_options),
    ABUT_FIELD(abut_distance_field_options, struct_size),
    ABUT_FIELD(abut_distance_field_options, is_inside_out),
    ABUT_FIELD(abut_distance_field_options, spacing),
    ABUT_FIELD(abut_distance_field_options, band),
    ABUT_FIELD(abut_distance_field_options, interpolation),
    ABUT_FIELD(abut_distance_field_options, reserved),
    ABUT_STRUCT(abut_distance_field_report),
    ABUT_FIELD(abut_distance_field_report, struct_size),
    ABUT_FIELD(abut_distance_field_report, interpolation),
    ABUT_FIELD(abut_distance_field_report, block_count),
    ABUT_FIELD(abut_distance_field_report, held_block_count),
    ABUT_FIELD(abut_distance_field_report, error),
    ABUT_FIELD(abut_distance_field_report, far_error),
    ABUT_FIELD(abut_distance_field_report, least_stretch),
    ABUT_FIELD(abut_distance_field_report, most_stretch),
    ABUT_STRUCT(abut_shape_desc),
    ABUT_FIELD(abut_shape_desc, struct_size),
    ABUT_FIELD(abut_shape_desc, kind),
    ABUT_FIELD(abut_shape_desc, parameters),
    ABUT_FIELD(abut_shape_desc, parameter_count),
    ABUT_FIELD(abut_shape_desc, reals),
    ABUT_FIELD(abut_shape_desc, real_count),
    ABUT_FIELD(abut_shape_desc, indices),
    ABUT_FIELD(abut_shape_desc, index_count),
    ABUT_STRUCT(abut_ray),
    ABUT_FIELD(abut_ray, origin),
    ABUT_FIELD(abut_ray, direction),
    ABUT_FIELD(abut_ray, max_distance),
    ABUT_STRUCT(abut_ray_hit),
    ABUT_FIELD(abut_ray_hit, distance),
    ABUT_FIELD(abut_ray_hit, point),
    ABUT_FIELD(abut_ray_hit, normal),
    ABUT_FIELD(abut_ray_hit, feature),
    ABUT_FIELD(abut_ray_hit, child),
    ABUT_FIELD(abut_ray_hit, reserved),
    ABUT_STRUCT(abut_query_options),
    ABUT_FIELD(abut_query_options, struct_size),
    ABUT_FIELD(abut_query_options, algorithm),
    ABUT_FIELD(abut_query_options, error_bound),
    ABUT_FIELD(abut_query_options, margin),
    ABUT_FIELD(abut_query_options, max_contacts),
    ABUT_FIELD(abut_query_options, max_pair_contacts),
    ABUT_FIELD(abut_query_options, threads),
    ABUT_FIELD(abut_query_options, reserved),
    ABUT_STRUCT(abut_distance),
    ABUT_FIELD(abut_distance, distance),
    ABUT_FIELD(abut_distance, lower),
    ABUT_FIELD(abut_distance, upper),
    ABUT_FIELD(abut_distance, point_a),
    ABUT_FIELD(abut_distance, point_b),
    ABUT_FIELD(abut_distance, normal),
    ABUT_FIELD(abut_distance, algorithm),
    ABUT_FIELD(abut_distance, iterations),
    ABUT_STRUCT(abut_contact),
    ABUT_FIELD(abut_contact, geometry_a),
    ABUT_FIELD(abut_contact, geometry_b),
    ABUT_FIELD(abut_contact, id),
    ABUT_FIELD(abut_contact, feature_a),
    ABUT_FIELD(abut_contact, feature_b),
    ABUT_FIELD(abut_contact, child_a),
    ABUT_FIELD(abut_contact, child_b),
    ABUT_FIELD(abut_contact, point_a),
    ABUT_FIELD(abut_contact, point_b),
    ABUT_FIELD(abut_contact, normal),
    ABUT_FIELD(abut_contact, distance),
    ABUT_FIELD(abut_contact, toi),
    ABUT_FIELD(abut_contact, flags),
    ABUT_FIELD(abut_contact, age),
    ABUT_FIELD(abut_contact, user_data),
    ABUT_FIELD(abut_contact, material_a),
    ABUT_FIELD(abut_contact, material_b),
    ABUT_FIELD(abut_contact, tangent),
    ABUT_FIELD(abut_contact, reserved),

    ABUT_STRUCT(abut_pair_memory),
    ABUT_FIELD(abut_pair_memory, opaque),
    ABUT_STRUCT(abut_first_touch),
    ABUT_FIELD(abut_first_touch, touches),
    ABUT_FIELD(abut_first_touch, reserved),
    ABUT_FIELD(abut_first_touch, lower),
    ABUT_FIELD(abut_first_touch, upper),
    ABUT_STRUCT(abut_movement),
    ABUT_FIELD(abut_movement, velocity),
    ABUT_FIELD(abut_movement, angular_velocity),
    ABUT_FIELD(abut_movement, acceleration),
    ABUT_FIELD(abut_movement, angular_acceleration),
    ABUT_FIELD(abut_movement, centre),
    ABUT_STRUCT(abut_impact_options),
    ABUT_FIELD(abut_impact_options, struct_size),
    ABUT_FIELD(abut_impact_options, most_rounds),
    ABUT_FIELD(abut_impact_options, tolerance),
    ABUT_FIELD(abut_impact_options, margin),
    ABUT_FIELD(abut_impact_options, threads),
    ABUT_FIELD(abut_impact_options, reserved),
    ABUT_STRUCT(abut_impact),
    ABUT_FIELD(abut_impact, state),
    ABUT_FIELD(abut_impact, rounds),
    ABUT_FIELD(abut_impact, lower),
    ABUT_FIELD(abut_impact, upper),
    ABUT_FIELD(abut_impact, contact),
    ABUT_FIELD(abut_impact, child_a),
    ABUT_FIELD(abut_impact, child_b),
    ABUT_STRUCT(abut_local_points),
    ABUT_FIELD(abut_local_points, a),
    ABUT_FIELD(abut_local_points, b),
    ABUT_STRUCT(abut_universe_options),
    ABUT_FIELD(abut_universe_options, struct_size),
    ABUT_FIELD(abut_universe_options, broadphase),
    ABUT_FIELD(abut_universe_options, tolerance_mode),
    ABUT_FIELD(abut_universe_options, max_contacts),
    ABUT_FIELD(abut_universe_options, origin),
    ABUT_FIELD(abut_universe_options, threads),
    ABUT_FIELD(abut_universe_options, events),
    ABUT_FIELD(abut_universe_options, flags),
    ABUT_FIELD(abut_universe_options, max_pair_contacts),
    ABUT_STRUCT(abut_part_options),
    ABUT_FIELD(abut_part_options, struct_size),
    ABUT_FIELD(abut_part_options, motion),
    ABUT_FIELD(abut_part_options, pose),
    ABUT_FIELD(abut_part_options, user_data),
    ABUT_STRUCT(abut_geometry_options),
    ABUT_FIELD(abut_geometry_options, struct_size),
    ABUT_FIELD(abut_geometry_options, flags),
    ABUT_FIELD(abut_geometry_options, pose),
    ABUT_FIELD(abut_geometry_options, tolerance),
    ABUT_FIELD(abut_geometry_options, user_data),
    ABUT_FIELD(abut_geometry_options, layers),
    ABUT_FIELD(abut_geometry_options, mask),
    ABUT_FIELD(abut_geometry_options, exclusion),
    ABUT_FIELD(abut_geometry_options, label),
    ABUT_FIELD(abut_geometry_options, tag),
    ABUT_FIELD(abut_geometry_options, material),
    ABUT_FIELD(abut_geometry_options, parking),
    ABUT_STRUCT(abut_geometry_info),
    ABUT_FIELD(abut_geometry_info, struct_size),
    ABUT_FIELD(abut_geometry_info, kind),
    ABUT_FIELD(abut_geometry_info, part),
    ABUT_FIELD(abut_geometry_info, shape),
    ABUT_FIELD(abut_geometry_info, pose),
    ABUT_FIELD(abut_geometry_info, local),
    ABUT_FIELD(abut_geometry_info, tolerance),
    ABUT_FIELD(abut_geometry_info, user_data),
    ABUT_FIELD(abut_geometry_info, layers),
    ABUT_FIELD(abut_geometry_info, mask),
    ABUT_FIELD(abut_geometry_info, exclusion),
    ABUT_FIELD(abut_geometry_info, label),
    ABUT_FIELD(abut_geometry_info, tag),
    ABUT_FIELD(abut_geometry_info, material),
    ABUT_FIELD(abut_geometry_info, parking),
    ABUT_FIELD(abut_geometry_info, flags),
    ABUT_FIELD(abut_geometry_info, reserved),
    ABUT_STRUCT(abut_revision),
    ABUT_FIELD(abut_revision, geometries),
    ABUT_FIELD(abut_revision, poses),
    ABUT_STRUCT(abut_collidable),
    ABUT_FIELD(abut_collidable, kind),
    ABUT_FIELD(abut_collidable, slot),
    ABUT_FIELD(abut_collidable, generation),
    ABUT_STRUCT(abut_policy),
    ABUT_FIELD(abut_policy, struct_size),
    ABUT_FIELD(abut_policy, algorithm),
    ABUT_FIELD(abut_policy, detail),
    ABUT_FIELD(abut_policy, period),
    ABUT_FIELD(abut_policy, tolerance),
    ABUT_FIELD(abut_policy, error_bound),
    ABUT_STRUCT(abut_focus),
    ABUT_FIELD(abut_focus, struct_size),
    ABUT_FIELD(abut_focus, near_tag),
    ABUT_FIELD(abut_focus, far_tag),
    ABUT_FIELD(abut_focus, reserved),
    ABUT_FIELD(abut_focus, near_distance),
    ABUT_FIELD(abut_focus, far_distance),
    ABUT_STRUCT(abut_contact_material),
    ABUT_FIELD(abut_contact_material, struct_size),
    ABUT_FIELD(abut_contact_material, reserved),
    ABUT_FIELD(abut_contact_material, friction_primary),
    ABUT_FIELD(abut_contact_material, friction_secondary),
    ABUT_FIELD(abut_contact_material, friction_spin),
    ABUT_FIELD(abut_contact_material, friction_roll),
    ABUT_FIELD(abut_contact_material, static_scale),
    ABUT_FIELD(abut_contact_material, slip),
    ABUT_FIELD(abut_contact_material, compliance),
    ABUT_FIELD(abut_contact_material, damping),
    ABUT_FIELD(abut_contact_material, restitution),
    ABUT_FIELD(abut_contact_material, restitution_threshold),
    ABUT_FIELD(abut_contact_material, adhesive_force),
    ABUT_STRUCT(abut_sleep),
    ABUT_FIELD(abut_sleep, struct_size),
    ABUT_FIELD(abut_sleep, steps),
    ABUT_FIELD(abut_sleep, linear_speed),
    ABUT_FIELD(abut_sleep, linear_acceleration),
    ABUT_FIELD(abut_sleep, angular_speed),
    ABUT_FIELD(abut_sleep, angular_acceleration),
    ABUT_STRUCT(abut_event),
    ABUT_FIELD(abut_event, kind),
    ABUT_FIELD(abut_event, flags),
    ABUT_FIELD(abut_event, geometry_a),
    ABUT_FIELD(abut_event, geometry_b),
    ABUT_FIELD(abut_event, contact_id),
    ABUT_FIELD(abut_event, first_contact),
    ABUT_FIELD(abut_event, contact_count),
    ABUT_STRUCT(abut_sleep_change),
    ABUT_FIELD(abut_sleep_change, part),
    ABUT_FIELD(abut_sleep_change, is_asleep),
    ABUT_FIELD(abut_sleep_change, reserved),
    ABUT_STRUCT(abut_step_stats),
    ABUT_FIELD(abut_step_stats, struct_size),
    ABUT_FIELD(abut_step_stats, reserved),
    ABUT_FIELD(abut_step_stats, parts),
    ABUT_FIELD(abut_step_stats, geometries),
    ABUT_FIELD(abut_step_stats, parked),
    ABUT_FIELD(abut_step_stats, moved),
    ABUT_FIELD(abut_step_stats, candidate_pairs),
    ABUT_FIELD(abut_step_stats, filtered_pairs),
    ABUT_FIELD(abut_step_stats, examined_pairs),
    ABUT_FIELD(abut_step_stats, kept_pairs),
    ABUT_FIELD(abut_step_stats, touching_pairs),
    ABUT_FIELD(abut_step_stats, contacts),
    ABUT_FIELD(abut_step_stats, unsupported_pairs),
    ABUT_FIELD(abut_step_stats, events),
    ABUT_FIELD(abut_step_stats, bytes),
    ABUT_FIELD(abut_step_stats, refresh_microseconds),
    ABUT_FIELD(abut_step_stats, broadphase_microseconds),
    ABUT_FIELD(abut_step_stats, pair_microseconds),
    ABUT_FIELD(abut_step_stats, narrowphase_microseconds),
    ABUT_FIELD(abut_step_stats, contact_microseconds),
    ABUT_FIELD(abut_step_stats, asleep),
    ABUT_STRUCT(abut_island),
    ABUT_FIELD(abut_island, id),
    ABUT_FIELD(abut_island, first_part),
    ABUT_FIELD(abut_island, part_count),
    ABUT_STRUCT(abut_velocity),
    ABUT_FIELD(abut_velocity, linear),
    ABUT_FIELD(abut_velocity, angular),
    ABUT_STRUCT(abut_acceleration),
    ABUT_FIELD(abut_acceleration, linear),
    ABUT_FIELD(abut_acceleration, angular),
    ABUT_STRUCT(abut_step_impact),
    ABUT_FIELD(abut_step_impact, geometry_a),
    ABUT_FIELD(abut_step_impact, geometry_b),
    ABUT_FIELD(abut_step_impact, lower),
    ABUT_FIELD(abut_step_impact, upper),
    ABUT_FIELD(abut_step_impact, first_contact),
    ABUT_FIELD(abut_step_impact, contact_count),
    ABUT_FIELD(abut_step_impact, is_undecided),
    ABUT_FIELD(abut_step_impact, reserved),
    ABUT_STRUCT(abut_finding),
    ABUT_FIELD(abut_finding, code),
    ABUT_FIELD(abut_finding, reserved),
    ABUT_FIELD(abut_finding, geometry),
    ABUT_FIELD(abut_finding, other),
    ABUT_FIELD(abut_finding, message),
    ABUT_STRUCT(abut_query_filter),
    ABUT_FIELD(abut_query_filter, struct_size),
    ABUT_FIELD(abut_query_filter, flags),
    ABUT_FIELD(abut_query_filter, layers),
    ABUT_FIELD(abut_query_filter, mask),
    ABUT_FIELD(abut_query_filter, ignore_part),
    ABUT_FIELD(abut_query_filter, ignore_geometry),
    ABUT_FIELD(abut_query_filter, ray_start),
    ABUT_FIELD(abut_query_filter, reserved),
    ABUT_STRUCT(abut_query_hit),
    ABUT_FIELD(abut_query_hit, geometry),
    ABUT_FIELD(abut_query_hit, feature),
    ABUT_FIELD(abut_query_hit, child),
    ABUT_FIELD(abut_query_hit, reserved),
    ABUT_FIELD(abut_query_hit, distance),
    ABUT_FIELD(abut_query_hit, point),
    ABUT_FIELD(abut_query_hit, normal),
    ABUT_STRUCT(abut_cast_hit),
    ABUT_FIELD(abut_cast_hit, geometry),
    ABUT_FIELD(abut_cast_hit, fraction),
    ABUT_FIELD(abut_cast_hit, contact),
    ABUT_FIELD(abut_cast_hit, feature_a),
    ABUT_FIELD(abut_cast_hit, feature_b),
    ABUT_FIELD(abut_cast_hit, child_a),
    ABUT_FIELD(abut_cast_hit, child_b),
    ABUT_STRUCT(abut_impact_hit),
    ABUT_FIELD(abut_impact_hit, geometry),
    ABUT_FIELD(abut_impact_hit, impact),
    ABUT_STRUCT(abut_closest),
    ABUT_FIELD(abut_closest, geometry),
    ABUT_FIELD(abut_closest, distance),
    ABUT_STRUCT(abut_layout_entry),
    ABUT_FIELD(abut_layout_entry, type),
    ABUT_FIELD(abut_layout_entry, field),
    ABUT_FIELD(abut_layout_entry, offset),
    ABUT_FIELD(abut_layout_entry, size),
});

}  // namespace

size_t abut_layout_count(void) { return layout.size(); }

abut_status abut_layout_at(size_t index, abut_layout_entry* out) {
  return guard([&]() -> abut_status {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    if (index >= layout.size()) {
      return refuse(abut::error_about(abut::Errc::index_out_of_range, "index", std::uint64_t{index},
                                      "below " + std::to_string(layout.size())));
    }
    *out = layout[index];
    return ABUT_OK;
  });
}
