/* SPDX-License-Identifier: Apache-2.0 */
/* Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit. */
/* Sizes and offsets of the structs of the C interface, as every binding may rely on them: TYPE(struct, size) and
 * FIELD(struct, field, offset, size). On targets with 64-bit pointers, whatever the compiler. */
#ifndef ABUT_LAYOUT_TABLE_H
#define ABUT_LAYOUT_TABLE_H

/* clang-format off */
#define ABUT_LAYOUT(TYPE, FIELD) \
  TYPE(abut_vec3, 24) \
  FIELD(abut_vec3, x, 0, 8) \
  FIELD(abut_vec3, y, 8, 8) \
  FIELD(abut_vec3, z, 16, 8) \
  TYPE(abut_quat, 32) \
  FIELD(abut_quat, w, 0, 8) \
  FIELD(abut_quat, x, 8, 8) \
  FIELD(abut_quat, y, 16, 8) \
  FIELD(abut_quat, z, 24, 8) \
  TYPE(abut_pose, 56) \
  FIELD(abut_pose, position, 0, 24) \
  FIELD(abut_pose, orientation, 24, 32) \
  TYPE(abut_aabb, 48) \
  FIELD(abut_aabb, minimum, 0, 24) \
  FIELD(abut_aabb, maximum, 24, 24) \
  TYPE(abut_part_id, 8) \
  FIELD(abut_part_id, slot, 0, 4) \
  FIELD(abut_part_id, generation, 4, 4) \
  TYPE(abut_geometry_id, 8) \
  FIELD(abut_geometry_id, slot, 0, 4) \
  FIELD(abut_geometry_id, generation, 4, 4) \
  TYPE(abut_feature, 8) \
  FIELD(abut_feature, kind, 0, 4) \
  FIELD(abut_feature, index, 4, 4) \
  TYPE(abut_hull_report, 48) \
  FIELD(abut_hull_report, struct_size, 0, 4) \
  FIELD(abut_hull_report, dimension, 4, 4) \
  FIELD(abut_hull_report, point_count, 8, 8) \
  FIELD(abut_hull_report, vertex_count, 16, 8) \
  FIELD(abut_hull_report, edge_count, 24, 8) \
  FIELD(abut_hull_report, face_count, 32, 8) \
  FIELD(abut_hull_report, error, 40, 8) \
  TYPE(abut_mesh_options, 32) \
  FIELD(abut_mesh_options, struct_size, 0, 4) \
  FIELD(abut_mesh_options, sides, 4, 4) \
  FIELD(abut_mesh_options, corners, 8, 4) \
  FIELD(abut_mesh_options, merges_vertices, 12, 4) \
  FIELD(abut_mesh_options, merge_distance, 16, 8) \
  FIELD(abut_mesh_options, tree, 24, 4) \
  FIELD(abut_mesh_options, reserved, 28, 4) \
  TYPE(abut_mesh_report, 120) \
  FIELD(abut_mesh_report, struct_size, 0, 4) \
  FIELD(abut_mesh_report, reserved, 4, 4) \
  FIELD(abut_mesh_report, triangles, 8, 8) \
  FIELD(abut_mesh_report, vertices, 16, 8) \
  FIELD(abut_mesh_report, merged_vertices, 24, 8) \
  FIELD(abut_mesh_report, collapsed_triangles, 32, 8) \
  FIELD(abut_mesh_report, duplicate_vertices, 40, 8) \
  FIELD(abut_mesh_report, duplicate_triangles, 48, 8) \
  FIELD(abut_mesh_report, slivers, 56, 8) \
  FIELD(abut_mesh_report, open_edges, 64, 8) \
  FIELD(abut_mesh_report, non_manifold_edges, 72, 8) \
  FIELD(abut_mesh_report, reversed_triangles, 80, 8) \
  FIELD(abut_mesh_report, twisted_patches, 88, 8) \
  FIELD(abut_mesh_report, components, 96, 8) \
  FIELD(abut_mesh_report, merge_error, 104, 8) \
  FIELD(abut_mesh_report, volume, 112, 8) \
  TYPE(abut_uv_grid_options, 40) \
  FIELD(abut_uv_grid_options, struct_size, 0, 4) \
  FIELD(abut_uv_grid_options, sides, 4, 4) \
  FIELD(abut_uv_grid_options, axis_u, 8, 4) \
  FIELD(abut_uv_grid_options, axis_v, 12, 4) \
  FIELD(abut_uv_grid_options, cells_u, 16, 4) \
  FIELD(abut_uv_grid_options, cells_v, 20, 4) \
  FIELD(abut_uv_grid_options, corners, 24, 4) \
  FIELD(abut_uv_grid_options, merges_vertices, 28, 4) \
  FIELD(abut_uv_grid_options, merge_distance, 32, 8) \
  TYPE(abut_height_field_desc, 48) \
  FIELD(abut_height_field_desc, struct_size, 0, 4) \
  FIELD(abut_height_field_desc, diagonal, 4, 4) \
  FIELD(abut_height_field_desc, columns, 8, 4) \
  FIELD(abut_height_field_desc, rows, 12, 4) \
  FIELD(abut_height_field_desc, spacing_x, 16, 8) \
  FIELD(abut_height_field_desc, spacing_y, 24, 8) \
  FIELD(abut_height_field_desc, heights, 32, 8) \
  FIELD(abut_height_field_desc, below, 40, 4) \
  FIELD(abut_height_field_desc, reserved, 44, 4) \
  TYPE(abut_distance_field_desc, 80) \
  FIELD(abut_distance_field_desc, struct_size, 0, 4) \
  FIELD(abut_distance_field_desc, is_inside_out, 4, 4) \
  FIELD(abut_distance_field_desc, columns, 8, 4) \
  FIELD(abut_distance_field_desc, rows, 12, 4) \
  FIELD(abut_distance_field_desc, layers, 16, 4) \
  FIELD(abut_distance_field_desc, interpolation, 20, 4) \
  FIELD(abut_distance_field_desc, spacing, 24, 24) \
  FIELD(abut_distance_field_desc, origin, 48, 24) \
  FIELD(abut_distance_field_desc, values, 72, 8) \
  TYPE(abut_distance_field_options, 32) \
  FIELD(abut_distance_field_options, struct_size, 0, 4) \
  FIELD(abut_distance_field_options, is_inside_out, 4, 4) \
  FIELD(abut_distance_field_options, spacing, 8, 8) \
  FIELD(abut_distance_field_options, band, 16, 8) \
  FIELD(abut_distance_field_options, interpolation, 24, 4) \
  FIELD(abut_distance_field_options, reserved, 28, 4) \
  TYPE(abut_distance_field_report, 56) \
  FIELD(abut_distance_field_report, struct_size, 0, 4) \
  FIELD(abut_distance_field_report, interpolation, 4, 4) \
  FIELD(abut_distance_field_report, block_count, 8, 8) \
  FIELD(abut_distance_field_report, held_block_count, 16, 8) \
  FIELD(abut_distance_field_report, error, 24, 8) \
  FIELD(abut_distance_field_report, far_error, 32, 8) \
  FIELD(abut_distance_field_report, least_stretch, 40, 8) \
  FIELD(abut_distance_field_report, most_stretch, 48, 8) \
  TYPE(abut_composite_child, 72) \
  FIELD(abut_composite_child, pose, 0, 56) \
  FIELD(abut_composite_child, material, 56, 4) \
  FIELD(abut_composite_child, is_hole, 60, 4) \
  FIELD(abut_composite_child, cut_begin, 64, 4) \
  FIELD(abut_composite_child, cut_end, 68, 4) \
  TYPE(abut_shape_desc, 56) \
  FIELD(abut_shape_desc, struct_size, 0, 4) \
  FIELD(abut_shape_desc, kind, 4, 4) \
  FIELD(abut_shape_desc, parameters, 8, 8) \
  FIELD(abut_shape_desc, parameter_count, 16, 8) \
  FIELD(abut_shape_desc, reals, 24, 8) \
  FIELD(abut_shape_desc, real_count, 32, 8) \
  FIELD(abut_shape_desc, indices, 40, 8) \
  FIELD(abut_shape_desc, index_count, 48, 8) \
  TYPE(abut_ray, 56) \
  FIELD(abut_ray, origin, 0, 24) \
  FIELD(abut_ray, direction, 24, 24) \
  FIELD(abut_ray, max_distance, 48, 8) \
  TYPE(abut_ray_hit, 72) \
  FIELD(abut_ray_hit, distance, 0, 8) \
  FIELD(abut_ray_hit, point, 8, 24) \
  FIELD(abut_ray_hit, normal, 32, 24) \
  FIELD(abut_ray_hit, feature, 56, 8) \
  FIELD(abut_ray_hit, child, 64, 4) \
  FIELD(abut_ray_hit, reserved, 68, 4) \
  TYPE(abut_query_options, 48) \
  FIELD(abut_query_options, struct_size, 0, 4) \
  FIELD(abut_query_options, algorithm, 4, 4) \
  FIELD(abut_query_options, error_bound, 8, 8) \
  FIELD(abut_query_options, margin, 16, 8) \
  FIELD(abut_query_options, max_contacts, 24, 4) \
  FIELD(abut_query_options, max_pair_contacts, 28, 4) \
  FIELD(abut_query_options, threads, 32, 4) \
  FIELD(abut_query_options, flags, 36, 4) \
  FIELD(abut_query_options, time_budget, 40, 8) \
  TYPE(abut_route, 32) \
  FIELD(abut_route, algorithm, 0, 4) \
  FIELD(abut_route, flags, 4, 4) \
  FIELD(abut_route, error_bound, 8, 8) \
  FIELD(abut_route, seconds, 16, 8) \
  FIELD(abut_route, worst_error, 24, 8) \
  TYPE(abut_distance, 104) \
  FIELD(abut_distance, distance, 0, 8) \
  FIELD(abut_distance, lower, 8, 8) \
  FIELD(abut_distance, upper, 16, 8) \
  FIELD(abut_distance, point_a, 24, 24) \
  FIELD(abut_distance, point_b, 48, 24) \
  FIELD(abut_distance, normal, 72, 24) \
  FIELD(abut_distance, algorithm, 96, 4) \
  FIELD(abut_distance, iterations, 100, 4) \
  TYPE(abut_contact, 192) \
  FIELD(abut_contact, geometry_a, 0, 8) \
  FIELD(abut_contact, geometry_b, 8, 8) \
  FIELD(abut_contact, id, 16, 8) \
  FIELD(abut_contact, feature_a, 24, 8) \
  FIELD(abut_contact, feature_b, 32, 8) \
  FIELD(abut_contact, child_a, 40, 4) \
  FIELD(abut_contact, child_b, 44, 4) \
  FIELD(abut_contact, point_a, 48, 24) \
  FIELD(abut_contact, point_b, 72, 24) \
  FIELD(abut_contact, normal, 96, 24) \
  FIELD(abut_contact, distance, 120, 8) \
  FIELD(abut_contact, toi, 128, 8) \
  FIELD(abut_contact, flags, 136, 4) \
  FIELD(abut_contact, age, 140, 4) \
  FIELD(abut_contact, user_data, 144, 8) \
  FIELD(abut_contact, material_a, 152, 4) \
  FIELD(abut_contact, material_b, 156, 4) \
  FIELD(abut_contact, tangent, 160, 24) \
  FIELD(abut_contact, reserved, 184, 8) \
  TYPE(abut_pair_memory, 64) \
  FIELD(abut_pair_memory, opaque, 0, 64) \
  TYPE(abut_first_touch, 24) \
  FIELD(abut_first_touch, touches, 0, 4) \
  FIELD(abut_first_touch, reserved, 4, 4) \
  FIELD(abut_first_touch, lower, 8, 8) \
  FIELD(abut_first_touch, upper, 16, 8) \
  TYPE(abut_element_counts, 32) \
  FIELD(abut_element_counts, vertices, 0, 8) \
  FIELD(abut_element_counts, edges, 8, 8) \
  FIELD(abut_element_counts, triangles, 16, 8) \
  FIELD(abut_element_counts, faces, 24, 8) \
  TYPE(abut_elements_options, 64) \
  FIELD(abut_elements_options, struct_size, 0, 4) \
  FIELD(abut_elements_options, method, 4, 4) \
  FIELD(abut_elements_options, kinds, 8, 4) \
  FIELD(abut_elements_options, flags, 12, 4) \
  FIELD(abut_elements_options, threads, 16, 4) \
  FIELD(abut_elements_options, reserved, 20, 4) \
  FIELD(abut_elements_options, reach, 24, 8) \
  FIELD(abut_elements_options, tolerance, 32, 8) \
  FIELD(abut_elements_options, rest_distance, 40, 8) \
  FIELD(abut_elements_options, cone_angle, 48, 8) \
  FIELD(abut_elements_options, cone_factor, 56, 8) \
  TYPE(abut_stencil, 104) \
  FIELD(abut_stencil, kind, 0, 4) \
  FIELD(abut_stencil, of_a, 4, 4) \
  FIELD(abut_stencil, element_a, 8, 4) \
  FIELD(abut_stencil, element_b, 12, 4) \
  FIELD(abut_stencil, vertices, 16, 16) \
  FIELD(abut_stencil, weights, 32, 32) \
  FIELD(abut_stencil, normal, 64, 24) \
  FIELD(abut_stencil, distance, 88, 8) \
  FIELD(abut_stencil, toi, 96, 8) \
  TYPE(abut_element_pair, 12) \
  FIELD(abut_element_pair, kind, 0, 4) \
  FIELD(abut_element_pair, a, 4, 4) \
  FIELD(abut_element_pair, b, 8, 4) \
  TYPE(abut_crossing, 48) \
  FIELD(abut_crossing, edge, 0, 4) \
  FIELD(abut_crossing, face, 4, 4) \
  FIELD(abut_crossing, edge_is_of_b, 8, 4) \
  FIELD(abut_crossing, reserved, 12, 4) \
  FIELD(abut_crossing, share, 16, 8) \
  FIELD(abut_crossing, point, 24, 24) \
  TYPE(abut_movement, 120) \
  FIELD(abut_movement, velocity, 0, 24) \
  FIELD(abut_movement, angular_velocity, 24, 24) \
  FIELD(abut_movement, acceleration, 48, 24) \
  FIELD(abut_movement, angular_acceleration, 72, 24) \
  FIELD(abut_movement, centre, 96, 24) \
  TYPE(abut_impact_options, 32) \
  FIELD(abut_impact_options, struct_size, 0, 4) \
  FIELD(abut_impact_options, most_rounds, 4, 4) \
  FIELD(abut_impact_options, tolerance, 8, 8) \
  FIELD(abut_impact_options, margin, 16, 8) \
  FIELD(abut_impact_options, threads, 24, 4) \
  FIELD(abut_impact_options, reserved, 28, 4) \
  TYPE(abut_impact, 136) \
  FIELD(abut_impact, state, 0, 4) \
  FIELD(abut_impact, rounds, 4, 4) \
  FIELD(abut_impact, lower, 8, 8) \
  FIELD(abut_impact, upper, 16, 8) \
  FIELD(abut_impact, contact, 24, 104) \
  FIELD(abut_impact, child_a, 128, 4) \
  FIELD(abut_impact, child_b, 132, 4) \
  TYPE(abut_universe_options, 56) \
  FIELD(abut_universe_options, struct_size, 0, 4) \
  FIELD(abut_universe_options, broadphase, 4, 4) \
  FIELD(abut_universe_options, tolerance_mode, 8, 4) \
  FIELD(abut_universe_options, max_contacts, 12, 4) \
  FIELD(abut_universe_options, origin, 16, 24) \
  FIELD(abut_universe_options, threads, 40, 4) \
  FIELD(abut_universe_options, events, 44, 4) \
  FIELD(abut_universe_options, flags, 48, 4) \
  FIELD(abut_universe_options, max_pair_contacts, 52, 4) \
  TYPE(abut_part_options, 72) \
  FIELD(abut_part_options, struct_size, 0, 4) \
  FIELD(abut_part_options, motion, 4, 4) \
  FIELD(abut_part_options, pose, 8, 56) \
  FIELD(abut_part_options, user_data, 64, 8) \
  TYPE(abut_sleep, 40) \
  FIELD(abut_sleep, struct_size, 0, 4) \
  FIELD(abut_sleep, steps, 4, 4) \
  FIELD(abut_sleep, linear_speed, 8, 8) \
  FIELD(abut_sleep, linear_acceleration, 16, 8) \
  FIELD(abut_sleep, angular_speed, 24, 8) \
  FIELD(abut_sleep, angular_acceleration, 32, 8) \
  TYPE(abut_geometry_options, 120) \
  FIELD(abut_geometry_options, struct_size, 0, 4) \
  FIELD(abut_geometry_options, flags, 4, 4) \
  FIELD(abut_geometry_options, pose, 8, 56) \
  FIELD(abut_geometry_options, tolerance, 64, 8) \
  FIELD(abut_geometry_options, user_data, 72, 8) \
  FIELD(abut_geometry_options, layers, 80, 8) \
  FIELD(abut_geometry_options, mask, 88, 8) \
  FIELD(abut_geometry_options, exclusion, 96, 8) \
  FIELD(abut_geometry_options, label, 104, 4) \
  FIELD(abut_geometry_options, tag, 108, 4) \
  FIELD(abut_geometry_options, material, 112, 4) \
  FIELD(abut_geometry_options, parking, 116, 4) \
  TYPE(abut_geometry_info, 200) \
  FIELD(abut_geometry_info, struct_size, 0, 4) \
  FIELD(abut_geometry_info, kind, 4, 4) \
  FIELD(abut_geometry_info, part, 8, 8) \
  FIELD(abut_geometry_info, shape, 16, 8) \
  FIELD(abut_geometry_info, pose, 24, 56) \
  FIELD(abut_geometry_info, local, 80, 56) \
  FIELD(abut_geometry_info, tolerance, 136, 8) \
  FIELD(abut_geometry_info, user_data, 144, 8) \
  FIELD(abut_geometry_info, layers, 152, 8) \
  FIELD(abut_geometry_info, mask, 160, 8) \
  FIELD(abut_geometry_info, exclusion, 168, 8) \
  FIELD(abut_geometry_info, label, 176, 4) \
  FIELD(abut_geometry_info, tag, 180, 4) \
  FIELD(abut_geometry_info, material, 184, 4) \
  FIELD(abut_geometry_info, parking, 188, 4) \
  FIELD(abut_geometry_info, flags, 192, 4) \
  FIELD(abut_geometry_info, reserved, 196, 4) \
  TYPE(abut_revision, 16) \
  FIELD(abut_revision, geometries, 0, 8) \
  FIELD(abut_revision, poses, 8, 8) \
  TYPE(abut_collidable, 12) \
  FIELD(abut_collidable, kind, 0, 4) \
  FIELD(abut_collidable, slot, 4, 4) \
  FIELD(abut_collidable, generation, 8, 4) \
  TYPE(abut_policy, 88) \
  FIELD(abut_policy, struct_size, 0, 4) \
  FIELD(abut_policy, algorithm, 4, 4) \
  FIELD(abut_policy, detail, 8, 4) \
  FIELD(abut_policy, period, 12, 4) \
  FIELD(abut_policy, tolerance, 16, 8) \
  FIELD(abut_policy, error_bound, 24, 8) \
  FIELD(abut_policy, method, 32, 4) \
  FIELD(abut_policy, kinds, 36, 4) \
  FIELD(abut_policy, flags, 40, 4) \
  FIELD(abut_policy, reserved, 44, 4) \
  FIELD(abut_policy, contact_distance, 48, 8) \
  FIELD(abut_policy, rest_distance, 56, 8) \
  FIELD(abut_policy, cone_angle, 64, 8) \
  FIELD(abut_policy, cone_factor, 72, 8) \
  FIELD(abut_policy, time_budget, 80, 8) \
  TYPE(abut_focus, 32) \
  FIELD(abut_focus, struct_size, 0, 4) \
  FIELD(abut_focus, near_tag, 4, 4) \
  FIELD(abut_focus, far_tag, 8, 4) \
  FIELD(abut_focus, reserved, 12, 4) \
  FIELD(abut_focus, near_distance, 16, 8) \
  FIELD(abut_focus, far_distance, 24, 8) \
  TYPE(abut_contact_material, 96) \
  FIELD(abut_contact_material, struct_size, 0, 4) \
  FIELD(abut_contact_material, reserved, 4, 4) \
  FIELD(abut_contact_material, friction_primary, 8, 8) \
  FIELD(abut_contact_material, friction_secondary, 16, 8) \
  FIELD(abut_contact_material, friction_spin, 24, 8) \
  FIELD(abut_contact_material, friction_roll, 32, 8) \
  FIELD(abut_contact_material, static_scale, 40, 8) \
  FIELD(abut_contact_material, slip, 48, 8) \
  FIELD(abut_contact_material, compliance, 56, 8) \
  FIELD(abut_contact_material, damping, 64, 8) \
  FIELD(abut_contact_material, restitution, 72, 8) \
  FIELD(abut_contact_material, restitution_threshold, 80, 8) \
  FIELD(abut_contact_material, adhesive_force, 88, 8) \
  TYPE(abut_backend_pair, 152) \
  FIELD(abut_backend_pair, geometry_a, 0, 8) \
  FIELD(abut_backend_pair, geometry_b, 8, 8) \
  FIELD(abut_backend_pair, shape_a, 16, 8) \
  FIELD(abut_backend_pair, shape_b, 24, 8) \
  FIELD(abut_backend_pair, pose_a, 32, 56) \
  FIELD(abut_backend_pair, pose_b, 88, 56) \
  FIELD(abut_backend_pair, margin, 144, 8) \
  TYPE(abut_backend_contact, 104) \
  FIELD(abut_backend_contact, point_a, 0, 24) \
  FIELD(abut_backend_contact, point_b, 24, 24) \
  FIELD(abut_backend_contact, normal, 48, 24) \
  FIELD(abut_backend_contact, feature_a, 72, 8) \
  FIELD(abut_backend_contact, feature_b, 80, 8) \
  FIELD(abut_backend_contact, child_a, 88, 4) \
  FIELD(abut_backend_contact, child_b, 92, 4) \
  FIELD(abut_backend_contact, id, 96, 8) \
  TYPE(abut_event, 40) \
  FIELD(abut_event, kind, 0, 4) \
  FIELD(abut_event, flags, 4, 4) \
  FIELD(abut_event, geometry_a, 8, 8) \
  FIELD(abut_event, geometry_b, 16, 8) \
  FIELD(abut_event, contact_id, 24, 8) \
  FIELD(abut_event, first_contact, 32, 4) \
  FIELD(abut_event, contact_count, 36, 4) \
  TYPE(abut_sleep_change, 16) \
  FIELD(abut_sleep_change, part, 0, 8) \
  FIELD(abut_sleep_change, is_asleep, 8, 4) \
  FIELD(abut_sleep_change, reserved, 12, 4) \
  TYPE(abut_local_points, 48) \
  FIELD(abut_local_points, a, 0, 24) \
  FIELD(abut_local_points, b, 24, 24) \
  TYPE(abut_step_stats, 160) \
  FIELD(abut_step_stats, struct_size, 0, 4) \
  FIELD(abut_step_stats, reserved, 4, 4) \
  FIELD(abut_step_stats, parts, 8, 8) \
  FIELD(abut_step_stats, geometries, 16, 8) \
  FIELD(abut_step_stats, parked, 24, 8) \
  FIELD(abut_step_stats, moved, 32, 8) \
  FIELD(abut_step_stats, candidate_pairs, 40, 8) \
  FIELD(abut_step_stats, filtered_pairs, 48, 8) \
  FIELD(abut_step_stats, examined_pairs, 56, 8) \
  FIELD(abut_step_stats, kept_pairs, 64, 8) \
  FIELD(abut_step_stats, touching_pairs, 72, 8) \
  FIELD(abut_step_stats, contacts, 80, 8) \
  FIELD(abut_step_stats, unsupported_pairs, 88, 8) \
  FIELD(abut_step_stats, events, 96, 8) \
  FIELD(abut_step_stats, bytes, 104, 8) \
  FIELD(abut_step_stats, refresh_microseconds, 112, 8) \
  FIELD(abut_step_stats, broadphase_microseconds, 120, 8) \
  FIELD(abut_step_stats, pair_microseconds, 128, 8) \
  FIELD(abut_step_stats, narrowphase_microseconds, 136, 8) \
  FIELD(abut_step_stats, contact_microseconds, 144, 8) \
  FIELD(abut_step_stats, asleep, 152, 8) \
  TYPE(abut_finding, 192) \
  FIELD(abut_finding, code, 0, 4) \
  FIELD(abut_finding, reserved, 4, 4) \
  FIELD(abut_finding, geometry, 8, 8) \
  FIELD(abut_finding, other, 16, 8) \
  FIELD(abut_finding, message, 24, 168) \
  TYPE(abut_island, 16) \
  FIELD(abut_island, id, 0, 8) \
  FIELD(abut_island, first_part, 8, 4) \
  FIELD(abut_island, part_count, 12, 4) \
  TYPE(abut_velocity, 48) \
  FIELD(abut_velocity, linear, 0, 24) \
  FIELD(abut_velocity, angular, 24, 24) \
  TYPE(abut_acceleration, 48) \
  FIELD(abut_acceleration, linear, 0, 24) \
  FIELD(abut_acceleration, angular, 24, 24) \
  TYPE(abut_step_impact, 48) \
  FIELD(abut_step_impact, geometry_a, 0, 8) \
  FIELD(abut_step_impact, geometry_b, 8, 8) \
  FIELD(abut_step_impact, lower, 16, 8) \
  FIELD(abut_step_impact, upper, 24, 8) \
  FIELD(abut_step_impact, first_contact, 32, 4) \
  FIELD(abut_step_impact, contact_count, 36, 4) \
  FIELD(abut_step_impact, is_undecided, 40, 4) \
  FIELD(abut_step_impact, reserved, 44, 4) \
  TYPE(abut_element_contact, 144) \
  FIELD(abut_element_contact, geometry_a, 0, 8) \
  FIELD(abut_element_contact, geometry_b, 8, 8) \
  FIELD(abut_element_contact, stencil, 16, 104) \
  FIELD(abut_element_contact, gap, 120, 8) \
  FIELD(abut_element_contact, id, 128, 8) \
  FIELD(abut_element_contact, age, 136, 4) \
  FIELD(abut_element_contact, reserved, 140, 4) \
  TYPE(abut_query_filter, 48) \
  FIELD(abut_query_filter, struct_size, 0, 4) \
  FIELD(abut_query_filter, flags, 4, 4) \
  FIELD(abut_query_filter, layers, 8, 8) \
  FIELD(abut_query_filter, mask, 16, 8) \
  FIELD(abut_query_filter, ignore_part, 24, 8) \
  FIELD(abut_query_filter, ignore_geometry, 32, 8) \
  FIELD(abut_query_filter, ray_start, 40, 4) \
  FIELD(abut_query_filter, reserved, 44, 4) \
  TYPE(abut_query_hit, 80) \
  FIELD(abut_query_hit, geometry, 0, 8) \
  FIELD(abut_query_hit, feature, 8, 8) \
  FIELD(abut_query_hit, child, 16, 4) \
  FIELD(abut_query_hit, reserved, 20, 4) \
  FIELD(abut_query_hit, distance, 24, 8) \
  FIELD(abut_query_hit, point, 32, 24) \
  FIELD(abut_query_hit, normal, 56, 24) \
  TYPE(abut_cast_hit, 144) \
  FIELD(abut_cast_hit, geometry, 0, 8) \
  FIELD(abut_cast_hit, fraction, 8, 8) \
  FIELD(abut_cast_hit, contact, 16, 104) \
  FIELD(abut_cast_hit, feature_a, 120, 8) \
  FIELD(abut_cast_hit, feature_b, 128, 8) \
  FIELD(abut_cast_hit, child_a, 136, 4) \
  FIELD(abut_cast_hit, child_b, 140, 4) \
  TYPE(abut_impact_hit, 144) \
  FIELD(abut_impact_hit, geometry, 0, 8) \
  FIELD(abut_impact_hit, impact, 8, 136) \
  TYPE(abut_closest, 112) \
  FIELD(abut_closest, geometry, 0, 8) \
  FIELD(abut_closest, distance, 8, 104) \
  TYPE(abut_layout_entry, 32) \
  FIELD(abut_layout_entry, type, 0, 8) \
  FIELD(abut_layout_entry, field, 8, 8) \
  FIELD(abut_layout_entry, offset, 16, 8) \
  FIELD(abut_layout_entry, size, 24, 8)

#define ABUT_PICKING_LAYOUT(TYPE, FIELD) \
  TYPE(abut_pick, 80) \
  FIELD(abut_pick, geometry, 0, 8) \
  FIELD(abut_pick, feature, 8, 8) \
  FIELD(abut_pick, child, 16, 4) \
  FIELD(abut_pick, reserved, 20, 4) \
  FIELD(abut_pick, distance, 24, 8) \
  FIELD(abut_pick, point, 32, 24) \
  FIELD(abut_pick, normal, 56, 24) \
  TYPE(abut_camera, 136) \
  FIELD(abut_camera, struct_size, 0, 4) \
  FIELD(abut_camera, width, 4, 4) \
  FIELD(abut_camera, height, 8, 4) \
  FIELD(abut_camera, projection, 12, 4) \
  FIELD(abut_camera, pose, 16, 56) \
  FIELD(abut_camera, vertical_fov, 72, 8) \
  FIELD(abut_camera, near_distance, 80, 8) \
  FIELD(abut_camera, far_distance, 88, 8) \
  FIELD(abut_camera, vertical_extent, 96, 8) \
  FIELD(abut_camera, pixel_aspect, 104, 8) \
  FIELD(abut_camera, shift_x, 112, 8) \
  FIELD(abut_camera, shift_y, 120, 8) \
  FIELD(abut_camera, depth_axis, 128, 4) \
  FIELD(abut_camera, reserved, 132, 4) \
  TYPE(abut_clip_plane, 32) \
  FIELD(abut_clip_plane, normal, 0, 24) \
  FIELD(abut_clip_plane, offset, 24, 8) \
  TYPE(abut_snap, 72) \
  FIELD(abut_snap, geometry, 0, 8) \
  FIELD(abut_snap, kind, 8, 4) \
  FIELD(abut_snap, vertices, 12, 8) \
  FIELD(abut_snap, reserved, 20, 4) \
  FIELD(abut_snap, parameter, 24, 8) \
  FIELD(abut_snap, pixels, 32, 8) \
  FIELD(abut_snap, distance, 40, 8) \
  FIELD(abut_snap, point, 48, 24) \
  TYPE(abut_barycentric, 40) \
  FIELD(abut_barycentric, triangle, 0, 4) \
  FIELD(abut_barycentric, vertices, 4, 12) \
  FIELD(abut_barycentric, weights, 16, 24)

#define ABUT_RESPONSE_LAYOUT(TYPE, FIELD) \
  TYPE(abut_contact_problem, 128) \
  FIELD(abut_contact_problem, struct_size, 0, 4) \
  FIELD(abut_contact_problem, body_count, 4, 4) \
  FIELD(abut_contact_problem, contact_count, 8, 4) \
  FIELD(abut_contact_problem, reserved, 12, 4) \
  FIELD(abut_contact_problem, masses, 16, 8) \
  FIELD(abut_contact_problem, inertias, 24, 8) \
  FIELD(abut_contact_problem, centres, 32, 8) \
  FIELD(abut_contact_problem, free_velocities, 40, 8) \
  FIELD(abut_contact_problem, bodies, 48, 8) \
  FIELD(abut_contact_problem, points, 56, 8) \
  FIELD(abut_contact_problem, normals, 64, 8) \
  FIELD(abut_contact_problem, tangents, 72, 8) \
  FIELD(abut_contact_problem, frictions, 80, 8) \
  FIELD(abut_contact_problem, compliances, 88, 8) \
  FIELD(abut_contact_problem, offsets, 96, 8) \
  FIELD(abut_contact_problem, surface_velocities, 104, 8) \
  FIELD(abut_contact_problem, first_velocities, 112, 8) \
  FIELD(abut_contact_problem, first_impulses, 120, 8) \
  TYPE(abut_solver_options, 32) \
  FIELD(abut_solver_options, struct_size, 0, 4) \
  FIELD(abut_solver_options, most_rounds, 4, 4) \
  FIELD(abut_solver_options, tolerance, 8, 8) \
  FIELD(abut_solver_options, speed, 16, 8) \
  FIELD(abut_solver_options, solver, 24, 4) \
  FIELD(abut_solver_options, reserved, 28, 4) \
  TYPE(abut_residuals, 48) \
  FIELD(abut_residuals, contact, 0, 8) \
  FIELD(abut_residuals, motion, 8, 8) \
  FIELD(abut_residuals, dissipation, 16, 8) \
  FIELD(abut_residuals, speed, 24, 8) \
  FIELD(abut_residuals, rounds, 32, 4) \
  FIELD(abut_residuals, newton_steps, 36, 4) \
  FIELD(abut_residuals, is_converged, 40, 4) \
  FIELD(abut_residuals, reserved, 44, 4) \
  TYPE(abut_mass_properties, 104) \
  FIELD(abut_mass_properties, mass, 0, 8) \
  FIELD(abut_mass_properties, centre, 8, 24) \
  FIELD(abut_mass_properties, inertia, 32, 72) \
  TYPE(abut_response_options, 64) \
  FIELD(abut_response_options, struct_size, 0, 4) \
  FIELD(abut_response_options, most_rounds, 4, 4) \
  FIELD(abut_response_options, gravity, 8, 24) \
  FIELD(abut_response_options, tolerance, 32, 8) \
  FIELD(abut_response_options, slop, 40, 8) \
  FIELD(abut_response_options, flags, 48, 4) \
  FIELD(abut_response_options, solver, 52, 4) \
  FIELD(abut_response_options, threads, 56, 4) \
  FIELD(abut_response_options, reserved, 60, 4) \
  TYPE(abut_body_options, 120) \
  FIELD(abut_body_options, struct_size, 0, 4) \
  FIELD(abut_body_options, integrator, 4, 4) \
  FIELD(abut_body_options, density, 8, 8) \
  FIELD(abut_body_options, mass, 16, 104) \
  TYPE(abut_elastic_options, 32) \
  FIELD(abut_elastic_options, struct_size, 0, 4) \
  FIELD(abut_elastic_options, reserved, 4, 4) \
  FIELD(abut_elastic_options, young, 8, 8) \
  FIELD(abut_elastic_options, poisson, 16, 8) \
  FIELD(abut_elastic_options, damping, 24, 8) \
  TYPE(abut_contact_law, 64) \
  FIELD(abut_contact_law, friction_primary, 0, 8) \
  FIELD(abut_contact_law, friction_secondary, 8, 8) \
  FIELD(abut_contact_law, compliance, 16, 8) \
  FIELD(abut_contact_law, offset, 24, 8) \
  FIELD(abut_contact_law, pull, 32, 8) \
  FIELD(abut_contact_law, surface_velocity, 40, 24) \
  TYPE(abut_response_side, 12) \
  FIELD(abut_response_side, kind, 0, 4) \
  FIELD(abut_response_side, slot, 4, 4) \
  FIELD(abut_response_side, generation, 8, 4) \
  TYPE(abut_link_options, 104) \
  FIELD(abut_link_options, struct_size, 0, 4) \
  FIELD(abut_link_options, reserved, 4, 4) \
  FIELD(abut_link_options, a, 8, 8) \
  FIELD(abut_link_options, b, 16, 8) \
  FIELD(abut_link_options, point_a, 24, 24) \
  FIELD(abut_link_options, point_b, 48, 24) \
  FIELD(abut_link_options, stiffness, 72, 8) \
  FIELD(abut_link_options, damping, 80, 8) \
  FIELD(abut_link_options, most_force, 88, 8) \
  FIELD(abut_link_options, break_force, 96, 8) \
  TYPE(abut_response_contact, 152) \
  FIELD(abut_response_contact, geometry_a, 0, 8) \
  FIELD(abut_response_contact, geometry_b, 8, 8) \
  FIELD(abut_response_contact, id, 16, 8) \
  FIELD(abut_response_contact, point, 24, 24) \
  FIELD(abut_response_contact, normal, 48, 24) \
  FIELD(abut_response_contact, impulse, 72, 24) \
  FIELD(abut_response_contact, force, 96, 24) \
  FIELD(abut_response_contact, distance, 120, 8) \
  FIELD(abut_response_contact, normal_velocity, 128, 8) \
  FIELD(abut_response_contact, state, 136, 4) \
  FIELD(abut_response_contact, island, 140, 4) \
  FIELD(abut_response_contact, kind, 144, 4) \
  FIELD(abut_response_contact, reserved, 148, 4) \
  TYPE(abut_response_object, 88) \
  FIELD(abut_response_object, geometry_a, 0, 8) \
  FIELD(abut_response_object, geometry_b, 8, 8) \
  FIELD(abut_response_object, kind, 16, 4) \
  FIELD(abut_response_object, event, 20, 4) \
  FIELD(abut_response_object, contact_count, 24, 4) \
  FIELD(abut_response_object, bond_count, 28, 4) \
  FIELD(abut_response_object, age, 32, 4) \
  FIELD(abut_response_object, reserved, 36, 4) \
  FIELD(abut_response_object, impulse, 40, 24) \
  FIELD(abut_response_object, force, 64, 24) \
  TYPE(abut_response_island, 64) \
  FIELD(abut_response_island, body_count, 0, 4) \
  FIELD(abut_response_island, contact_count, 4, 4) \
  FIELD(abut_response_island, integrator, 8, 4) \
  FIELD(abut_response_island, reserved, 12, 4) \
  FIELD(abut_response_island, residuals, 16, 48) \
  TYPE(abut_energy, 64) \
  FIELD(abut_energy, kinetic, 0, 8) \
  FIELD(abut_energy, potential, 8, 8) \
  FIELD(abut_energy, linear_momentum, 16, 24) \
  FIELD(abut_energy, angular_momentum, 40, 24) \
  TYPE(abut_response_finding, 192) \
  FIELD(abut_response_finding, code, 0, 4) \
  FIELD(abut_response_finding, rule, 4, 4) \
  FIELD(abut_response_finding, part, 8, 8) \
  FIELD(abut_response_finding, geometry, 16, 8) \
  FIELD(abut_response_finding, message, 24, 168)

/* clang-format on */

#endif
