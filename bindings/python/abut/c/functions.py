# SPDX-License-Identifier: Apache-2.0
"""Functions of abut.h and picking.h: what each answers and takes."""

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p

from .structs import *

__all__ = ["Allocate", "FUNCTIONS", "Filter", "Log", "PICKING_FUNCTIONS", "Release"]

Status = c_int32

# Hears of failures: context, level and a sentence.
Log = ctypes.CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)
# Gives memory: context, size and alignment to an address. Takes it back: context, address, size and alignment. They run on
# threads of the library, several at once.
Allocate = ctypes.CFUNCTYPE(c_void_p, c_void_p, c_size_t, c_size_t)
Release = ctypes.CFUNCTYPE(None, c_void_p, c_void_p, c_size_t, c_size_t)
# A filter of pairs: context, universe and two geometries to a number, of which 0 leaves the pair out.
Filter = ctypes.CFUNCTYPE(c_uint32, c_void_p, c_void_p, GeometryId, GeometryId)
PointerFilter = ctypes.CFUNCTYPE(c_uint32, c_void_p, c_void_p, POINTER(GeometryId), POINTER(GeometryId))

FUNCTIONS = {
    "abut_set_last_error": (Status, [Status, c_char_p]),
    "abut_set_log": (Status, [Log, c_void_p, c_uint32]),
    "abut_set_allocator": (Status, [Allocate, Release, c_void_p]),
    "abut_memory_in_use": (Status, [POINTER(c_uint64), POINTER(c_uint64)]),
    "abut_memory_allocate": (c_void_p, [c_size_t, c_size_t]),
    "abut_memory_release": (None, [c_void_p, c_size_t, c_size_t]),
    "abut_status_name": (c_char_p, [Status]),
    "abut_last_error_message": (c_char_p, []),
    "abut_version_string": (c_char_p, []),
    "abut_check_version": (Status, [c_uint32, c_uint32]),
    "abut_has_feature": (c_uint32, [c_char_p]),
    "abut_shape_kind_count": (c_size_t, []),
    "abut_shape_kind_at": (c_uint32, [c_size_t]),
    "abut_shape_kind_by_name": (c_uint32, [c_char_p]),
    "abut_shape_kind_name": (c_char_p, [c_uint32]),
    "abut_shape_kind_parameter_count": (c_size_t, [c_uint32]),
    "abut_shape_kind_parameter_name": (c_char_p, [c_uint32, c_size_t]),
    "abut_pair_support": (Status, [c_uint32, c_uint32, c_uint32, POINTER(c_uint32)]),
    "abut_sphere_create": (Status, [c_double, POINTER(c_void_p)]),
    "abut_box_create": (Status, [c_double, c_double, c_double, POINTER(c_void_p)]),
    "abut_capsule_create": (Status, [c_double, c_double, POINTER(c_void_p)]),
    "abut_composite_create": (Status, [POINTER(c_void_p), POINTER(Pose), c_size_t, POINTER(c_void_p)]),
    "abut_composite_create_with_materials": (Status, [
        POINTER(c_void_p), POINTER(Pose), POINTER(c_uint32), c_size_t, POINTER(c_void_p)]),
    "abut_cylinder_create": (Status, [c_double, c_double, POINTER(c_void_p)]),
    "abut_cone_create": (Status, [c_double, c_double, POINTER(c_void_p)]),
    "abut_ellipsoid_create": (Status, [c_double, c_double, c_double, POINTER(c_void_p)]),
    "abut_point_create": (Status, [POINTER(c_void_p)]),
    "abut_segment_create": (Status, [c_double, POINTER(c_void_p)]),
    "abut_triangle_create": (Status, [POINTER(Vec3), POINTER(Vec3), POINTER(Vec3), POINTER(c_void_p)]),
    "abut_sphere_hole_create": (Status, [c_double, POINTER(c_void_p)]),
    "abut_cylinder_hole_create": (Status, [c_double, c_double, c_uint32, POINTER(c_void_p)]),
    "abut_box_hole_create": (Status, [c_double, c_double, c_double, c_uint32, POINTER(c_void_p)]),
    "abut_plane_create": (Status, [POINTER(Vec3), c_double, POINTER(c_void_p)]),
    "abut_hull_create": (Status, [POINTER(c_double), c_size_t, POINTER(c_void_p)]),
    "abut_hull_report_init": (None, [POINTER(HullReport), c_uint32]),
    "abut_hull_describe": (Status, [c_void_p, POINTER(HullReport)]),
    "abut_mesh_options_init": (None, [POINTER(MeshOptions), c_uint32]),
    "abut_mesh_create": (Status, [
        POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t, POINTER(MeshOptions), POINTER(c_void_p)]),
    "abut_mesh_report_init": (None, [POINTER(MeshReport), c_uint32]),
    "abut_mesh_describe": (Status, [
        POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t, POINTER(MeshOptions), POINTER(MeshReport)]),
    "abut_uv_grid_options_init": (None, [POINTER(UvGridOptions), c_uint32]),
    "abut_uv_grid_create": (Status, [
        POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t, POINTER(UvGridOptions), POINTER(c_void_p)]),
    "abut_height_field_desc_init": (None, [POINTER(HeightFieldDesc), c_uint32]),
    "abut_height_field_create": (Status, [POINTER(HeightFieldDesc), POINTER(c_void_p)]),
    "abut_distance_field_desc_init": (None, [POINTER(DistanceFieldDesc), c_uint32]),
    "abut_distance_field_create": (Status, [POINTER(DistanceFieldDesc), POINTER(c_void_p)]),
    "abut_distance_field_report_init": (None, [POINTER(DistanceFieldReport), c_uint32]),
    "abut_distance_field_describe": (Status, [c_void_p, POINTER(DistanceFieldReport)]),
    "abut_distance_field_options_init": (None, [POINTER(DistanceFieldOptions), c_uint32]),
    "abut_distance_field_from_mesh": (Status, [
        POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t, POINTER(DistanceFieldOptions), POINTER(c_void_p)]),
    "abut_particles_create": (Status, [POINTER(c_double), c_size_t, c_double, POINTER(c_void_p)]),
    "abut_particles_create_with_radii": (Status, [POINTER(c_double), POINTER(c_double), c_size_t, POINTER(c_void_p)]),
    "abut_shape_desc_init": (None, [POINTER(ShapeDesc), c_uint32]),
    "abut_shape_create": (Status, [POINTER(ShapeDesc), POINTER(c_void_p)]),
    "abut_shape_retain": (None, [c_void_p]),
    "abut_shape_release": (None, [c_void_p]),
    "abut_shape_kind_of": (c_uint32, [c_void_p]),
    "abut_shape_parameters": (Status, [c_void_p, POINTER(c_double), c_size_t, POINTER(c_size_t)]),
    "abut_shape_aabb": (Status, [c_void_p, POINTER(Pose), POINTER(Aabb)]),
    "abut_shape_triangles": (Status, [
        c_void_p, POINTER(c_double), c_size_t, POINTER(c_size_t), POINTER(c_uint32), c_size_t,
        POINTER(c_size_t)]),
    "abut_shape_prepare": (Status, [c_void_p, c_uint32]),
    "abut_shape_cast_ray": (Status, [
        c_void_p, POINTER(Pose), POINTER(Ray), POINTER(RayHit), POINTER(c_uint32)]),
    "abut_query_options_init": (None, [POINTER(QueryOptions), c_uint32]),
    "abut_pair_distance": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(Distance)]),
    "abut_pair_distance_with_memory": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(Distance)]),
    "abut_pairs_distance_with_memories": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), c_size_t, POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(Distance)]),
    "abut_pair_contacts_with_memory": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(Contact), c_size_t, POINTER(c_size_t)]),
    "abut_pairs_distance": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), c_size_t, POINTER(QueryOptions),
        POINTER(Distance)]),
    "abut_pairs_contacts": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), c_size_t, POINTER(QueryOptions), POINTER(c_uint64),
        POINTER(Contact), c_size_t, POINTER(c_size_t)]),
    "abut_pairs_contacts_with_memories": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), c_size_t, POINTER(QueryOptions), POINTER(PairMemory),
        POINTER(c_uint64), POINTER(Contact), c_size_t, POINTER(c_size_t)]),
    "abut_pair_contacts": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(Contact),
        c_size_t, POINTER(c_size_t)]),
    "abut_pair_overlaps": (Status, [
        c_void_p, POINTER(Pose), c_void_p, POINTER(Pose), POINTER(QueryOptions), POINTER(c_uint32)]),
    "abut_pairs_overlap": (Status, [
        POINTER(c_void_p), POINTER(Pose), POINTER(c_void_p), POINTER(Pose), c_size_t, POINTER(QueryOptions),
        POINTER(c_uint32)]),
    "abut_vertices_touch_faces": (Status, [
        POINTER(c_double), POINTER(c_double), c_size_t, c_double, c_double, POINTER(FirstTouch)]),
    "abut_edges_touch_edges": (Status, [
        POINTER(c_double), POINTER(c_double), c_size_t, c_double, c_double, POINTER(FirstTouch)]),
    "abut_elements_create": (Status, [c_void_p, POINTER(c_void_p)]),
    "abut_elements_destroy": (None, [c_void_p]),
    "abut_elements_count": (Status, [c_void_p, POINTER(ElementCounts)]),
    "abut_elements_edges": (Status, [c_void_p, POINTER(c_uint32), c_size_t, POINTER(c_size_t)]),
    "abut_elements_set_vertices": (Status, [c_void_p, POINTER(c_double), POINTER(c_double), c_size_t]),
    "abut_elements_options_init": (None, [POINTER(ElementsOptions), c_uint32]),
    "abut_elements_candidates": (Status, [
        c_void_p, c_void_p, POINTER(ElementsOptions), POINTER(ElementPair), c_size_t, POINTER(c_size_t)]),
    "abut_elements_closest": (Status, [
        c_void_p, c_void_p, POINTER(ElementsOptions), POINTER(Stencil), c_size_t, POINTER(c_size_t)]),
    "abut_elements_first_touches": (Status, [
        c_void_p, c_void_p, POINTER(ElementsOptions), POINTER(Stencil), c_size_t, POINTER(c_size_t)]),
    "abut_elements_crossings": (Status, [
        c_void_p, c_void_p, POINTER(ElementsOptions), POINTER(Crossing), c_size_t, POINTER(c_size_t)]),
    "abut_movement_between": (Status, [POINTER(Pose), POINTER(Pose), POINTER(Vec3), c_double, POINTER(Movement)]),
    "abut_impact_options_init": (None, [POINTER(ImpactOptions), c_uint32]),
    "abut_pair_time_of_impact": (Status, [
        c_void_p, POINTER(Pose), POINTER(Movement), c_void_p, POINTER(Pose), POINTER(Movement), c_double,
        POINTER(ImpactOptions), POINTER(Impact)]),
    "abut_pairs_time_of_impact": (Status, [
        c_void_p, POINTER(Pose), POINTER(Movement), c_void_p, POINTER(Pose), POINTER(Movement), c_size_t, c_double,
        POINTER(ImpactOptions), POINTER(Impact)]),
    "abut_universe_options_init": (None, [POINTER(UniverseOptions), c_uint32]),
    "abut_universe_save": (Status, [c_void_p, c_void_p, c_size_t, POINTER(c_size_t)]),
    "abut_universe_load": (Status, [c_void_p, c_size_t, POINTER(c_void_p)]),
    "abut_universe_create": (Status, [POINTER(UniverseOptions), POINTER(c_void_p)]),
    "abut_universe_destroy": (None, [c_void_p]),
    "abut_part_options_init": (None, [POINTER(PartOptions), c_uint32]),
    "abut_part_create": (Status, [c_void_p, POINTER(PartOptions), POINTER(PartId)]),
    "abut_parts_create": (Status, [c_void_p, POINTER(PartOptions), c_size_t, POINTER(PartId)]),
    "abut_part_destroy": (Status, [c_void_p, PartId]),
    "abut_parts_destroy": (Status, [c_void_p, POINTER(PartId), c_size_t]),
    "abut_part_set_pose": (Status, [c_void_p, PartId, POINTER(Pose)]),
    "abut_parts_set_poses": (Status, [c_void_p, POINTER(PartId), POINTER(Pose), c_size_t]),
    "abut_part_pose": (Status, [c_void_p, PartId, POINTER(Pose)]),
    "abut_parts_poses": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(Pose)]),
    "abut_part_set_motion": (Status, [c_void_p, PartId, c_uint32]),
    "abut_parts_set_motions": (Status, [c_void_p, POINTER(PartId), POINTER(c_uint32), c_size_t]),
    "abut_part_motion": (Status, [c_void_p, PartId, POINTER(c_uint32)]),
    "abut_part_user_data": (Status, [c_void_p, PartId, POINTER(c_uint64)]),
    "abut_part_set_user_data": (Status, [c_void_p, PartId, c_uint64]),
    "abut_parts_set_user_data": (Status, [c_void_p, POINTER(PartId), POINTER(c_uint64), c_size_t]),
    "abut_geometry_set_user_data": (Status, [c_void_p, GeometryId, c_uint64]),
    "abut_geometries_set_user_data": (Status, [c_void_p, POINTER(GeometryId), POINTER(c_uint64), c_size_t]),
    "abut_part_geometries": (Status, [c_void_p, PartId, POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_geometry_options_init": (None, [POINTER(GeometryOptions), c_uint32]),
    "abut_geometry_create": (Status, [
        c_void_p, PartId, c_void_p, POINTER(GeometryOptions), POINTER(GeometryId)]),
    "abut_geometries_create": (Status, [
        c_void_p, POINTER(PartId), POINTER(c_void_p), POINTER(GeometryOptions), c_size_t,
        POINTER(GeometryId)]),
    "abut_geometry_destroy": (Status, [c_void_p, GeometryId]),
    "abut_geometries_destroy": (Status, [c_void_p, POINTER(GeometryId), c_size_t]),
    "abut_geometry_set_options": (Status, [c_void_p, GeometryId, POINTER(GeometryOptions)]),
    "abut_geometries_set_options": (Status, [
        c_void_p, POINTER(GeometryId), POINTER(GeometryOptions), c_size_t]),
    "abut_geometry_set_shape": (Status, [c_void_p, GeometryId, c_void_p]),
    "abut_geometries_set_shapes": (Status, [c_void_p, POINTER(GeometryId), POINTER(c_void_p), c_size_t]),
    "abut_geometry_set_parameters": (Status, [c_void_p, GeometryId, POINTER(c_double), c_size_t]),
    "abut_geometries_set_parameters": (Status, [c_void_p, POINTER(GeometryId), POINTER(c_double), c_size_t, c_size_t]),
    "abut_geometry_set_heights": (
        Status, [c_void_p, GeometryId, c_uint32, c_uint32, c_uint32, c_uint32, POINTER(c_double)]),
    "abut_geometry_set_field_values": (
        Status, [c_void_p, GeometryId, c_uint32, c_uint32, c_uint32, c_uint32, c_uint32, c_uint32, POINTER(c_double)]),
    "abut_geometry_set_field_lattice": (
        Status, [c_void_p, GeometryId, c_uint32, c_uint32, c_uint32, POINTER(c_double)]),
    "abut_geometry_set_particles": (
        Status, [c_void_p, GeometryId, c_size_t, POINTER(c_double), POINTER(c_double), c_size_t]),
    "abut_geometry_set_vertices": (Status, [c_void_p, GeometryId, c_size_t, POINTER(c_double), c_size_t]),
    "abut_geometry_set_vertices_at": (
        Status, [c_void_p, GeometryId, POINTER(c_uint32), POINTER(c_double), c_size_t]),
    "abut_geometry_remove_triangles": (Status, [c_void_p, GeometryId, POINTER(c_uint32), c_size_t]),
    "abut_geometry_set_mesh": (
        Status, [c_void_p, GeometryId, POINTER(c_double), c_size_t, POINTER(c_uint32), c_size_t]),
    "abut_geometry_shape": (Status, [c_void_p, GeometryId, POINTER(c_void_p)]),
    "abut_geometry_park": (Status, [c_void_p, GeometryId, c_uint32]),
    "abut_geometries_park": (Status, [c_void_p, POINTER(GeometryId), c_size_t, c_uint32]),
    "abut_geometry_info_init": (None, [POINTER(GeometryInfo), c_uint32]),
    "abut_geometry_describe": (Status, [c_void_p, GeometryId, POINTER(GeometryInfo)]),
    "abut_geometries_poses": (Status, [c_void_p, POINTER(GeometryId), c_size_t, POINTER(Pose)]),
    "abut_universe_parts": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_geometries": (Status, [c_void_p, POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_revision": (Status, [c_void_p, POINTER(Revision)]),
    "abut_universe_counters": (Status, [c_void_p, POINTER(POINTER(c_uint64)), POINTER(POINTER(c_uint64))]),
    "abut_universe_changes": (Status, [c_void_p, POINTER(Revision), POINTER(GeometryId), c_size_t, POINTER(c_size_t),
                                       POINTER(c_uint32)]),
    "abut_universe_validate": (Status, [c_void_p, POINTER(Finding), c_size_t, POINTER(c_size_t)]),
    "abut_contact_material_init": (None, [POINTER(ContactMaterial), c_uint32]),
    "abut_material_pair_set": (Status, [c_void_p, c_uint32, c_uint32, POINTER(ContactMaterial)]),
    "abut_material_pair_get": (Status, [c_void_p, c_uint32, c_uint32, POINTER(ContactMaterial)]),
    "abut_rule_set": (Status, [c_void_p, POINTER(Collidable), POINTER(Collidable), c_uint32]),
    "abut_rules_clear": (Status, [c_void_p]),
    "abut_rule_between": (Status, [
        c_void_p, GeometryId, GeometryId, POINTER(c_uint32), POINTER(Collidable), POINTER(Collidable)]),
    "abut_universe_why_apart": (Status, [c_void_p, GeometryId, GeometryId, POINTER(c_uint32)]),
    "abut_universe_set_filter": (Status, [c_void_p, Filter, c_void_p]),
    "abut_universe_set_pointer_filter": (Status, [c_void_p, PointerFilter, c_void_p]),
    "abut_universe_refilter": (Status, [c_void_p]),
    "abut_sleep_init": (None, [POINTER(Sleep), c_uint32]),
    "abut_part_set_sleep": (Status, [c_void_p, PartId, POINTER(Sleep)]),
    "abut_parts_set_sleep": (Status, [c_void_p, POINTER(PartId), POINTER(Sleep), c_size_t]),
    "abut_part_is_asleep": (Status, [c_void_p, PartId, POINTER(c_uint32)]),
    "abut_part_wake": (Status, [c_void_p, PartId]),
    "abut_parts_wake": (Status, [c_void_p, POINTER(PartId), c_size_t]),
    "abut_universe_sleep_changes": (Status, [c_void_p, POINTER(POINTER(SleepChange)), POINTER(c_size_t)]),
    "abut_universe_follow_islands": (Status, [c_void_p, c_uint32]),
    "abut_universe_islands": (Status, [c_void_p, POINTER(POINTER(Island)), POINTER(c_size_t)]),
    "abut_universe_island_parts": (Status, [c_void_p, POINTER(POINTER(PartId)), POINTER(c_size_t)]),
    "abut_part_island": (Status, [c_void_p, PartId, POINTER(Island)]),
    "abut_part_set_velocity": (Status, [c_void_p, PartId, POINTER(Velocity)]),
    "abut_parts_set_velocities": (Status, [c_void_p, POINTER(PartId), POINTER(Velocity), c_size_t]),
    "abut_part_measure_velocity": (Status, [c_void_p, PartId]),
    "abut_parts_measure_velocities": (Status, [c_void_p, POINTER(PartId), c_size_t]),
    "abut_part_velocity": (Status, [c_void_p, PartId, POINTER(Velocity), POINTER(c_uint32)]),
    "abut_parts_velocities": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(Velocity)]),
    "abut_part_set_acceleration": (Status, [c_void_p, PartId, POINTER(Acceleration)]),
    "abut_parts_set_accelerations": (Status, [c_void_p, POINTER(PartId), POINTER(Acceleration), c_size_t]),
    "abut_parts_accelerations": (Status, [c_void_p, POINTER(PartId), c_size_t, POINTER(Acceleration)]),
    "abut_universe_impacts": (Status, [c_void_p, POINTER(POINTER(StepImpact)), POINTER(c_size_t)]),
    "abut_universe_advance_to_first_impact": (Status, [c_void_p, c_double, POINTER(StepImpact)]),
    "abut_universe_attach": (Status, [c_void_p, c_char_p]),
    "abut_universe_detach": (Status, [c_void_p, c_char_p]),
    "abut_policy_init": (None, [POINTER(Policy), c_uint32]),
    "abut_policy_set": (Status, [c_void_p, c_uint32, c_uint32, POINTER(Policy)]),
    "abut_policy_get": (Status, [c_void_p, c_uint32, c_uint32, POINTER(Policy)]),
    "abut_focus_init": (None, [POINTER(Focus), c_uint32]),
    "abut_universe_set_focus": (Status, [c_void_p, POINTER(Focus), POINTER(Vec3), c_size_t]),
    "abut_universe_step": (Status, [c_void_p, c_double]),
    "abut_universe_detect_all": (Status, [c_void_p]),
    "abut_universe_detect_changed": (Status, [c_void_p]),
    "abut_universe_detect_pairs": (Status, [c_void_p, POINTER(GeometryId), POINTER(GeometryId), c_size_t]),
    "abut_universe_detect_region": (Status, [c_void_p, POINTER(Aabb)]),
    "abut_universe_refresh": (Status, [c_void_p]),
    "abut_universe_events": (Status, [c_void_p, POINTER(POINTER(Event)), POINTER(c_size_t)]),
    "abut_universe_hash": (Status, [c_void_p, POINTER(c_uint64)]),
    "abut_contacts_set_user_data": (Status, [c_void_p, POINTER(c_uint64), c_size_t]),
    "abut_universe_contacts": (Status, [c_void_p, POINTER(POINTER(Contact)), POINTER(c_size_t)]),
    "abut_universe_local_points": (Status, [c_void_p, POINTER(POINTER(LocalPoints)), POINTER(c_size_t)]),
    "abut_contact_validate": (Status, [POINTER(Contact)]),
    "abut_step_stats_init": (None, [POINTER(StepStats), c_uint32]),
    "abut_universe_stats": (Status, [c_void_p, POINTER(StepStats)]),
    "abut_universe_explain": (Status, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)]),
    "abut_universe_explain_json": (Status, [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)]),
    "abut_query_filter_init": (None, [POINTER(QueryFilter), c_uint32]),
    "abut_universe_cast_ray": (Status, [
        c_void_p, POINTER(Ray), POINTER(QueryFilter), c_uint32, POINTER(QueryHit), c_size_t, POINTER(c_size_t)]),
    "abut_universe_cast_rays": (Status, [
        c_void_p, POINTER(Ray), c_size_t, POINTER(QueryFilter), POINTER(QueryHit)]),
    "abut_universe_cast_shape": (Status, [
        c_void_p, c_void_p, POINTER(Pose), POINTER(Vec3), POINTER(QueryFilter), c_uint32, POINTER(CastHit), c_size_t,
        POINTER(c_size_t)]),
    "abut_universe_cast_shapes": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), POINTER(Vec3), c_size_t, POINTER(QueryFilter), POINTER(CastHit)]),
    "abut_universe_cast_movement": (Status, [
        c_void_p, c_void_p, POINTER(Pose), POINTER(Movement), c_double, POINTER(ImpactOptions), POINTER(QueryFilter),
        c_uint32, POINTER(ImpactHit), c_size_t, POINTER(c_size_t)]),
    "abut_universe_cast_movements": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), POINTER(Movement), c_size_t, c_double, POINTER(ImpactOptions),
        POINTER(QueryFilter), POINTER(ImpactHit)]),
    "abut_universe_overlaps": (Status, [
        c_void_p, c_void_p, POINTER(Pose), POINTER(QueryFilter), c_double, POINTER(GeometryId), c_size_t,
        POINTER(c_size_t)]),
    "abut_universe_overlaps_of_each": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), c_size_t, POINTER(QueryFilter), c_double, POINTER(c_uint64),
        POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_at_point": (Status, [
        c_void_p, POINTER(Vec3), POINTER(QueryFilter), POINTER(GeometryId), c_size_t, POINTER(c_size_t)]),
    "abut_universe_at_points": (Status, [
        c_void_p, POINTER(Vec3), c_size_t, POINTER(QueryFilter), POINTER(c_uint64), POINTER(GeometryId), c_size_t,
        POINTER(c_size_t)]),
    "abut_universe_closest": (Status, [
        c_void_p, c_void_p, POINTER(Pose), c_double, POINTER(QueryFilter), POINTER(Closest), POINTER(c_uint32)]),
    "abut_universe_closest_to_each": (Status, [
        c_void_p, POINTER(c_void_p), POINTER(Pose), c_size_t, c_double, POINTER(QueryFilter), POINTER(Closest)]),
    "abut_pair_cast": (Status, [
        c_void_p, POINTER(Pose), POINTER(Vec3), c_void_p, POINTER(Pose), POINTER(Vec3), POINTER(QueryOptions),
        POINTER(CastHit), POINTER(c_uint32)]),
    "abut_pairs_cast": (Status, [
        c_void_p, POINTER(Pose), POINTER(Vec3), c_void_p, POINTER(Pose), POINTER(Vec3), c_size_t,
        POINTER(QueryOptions), POINTER(CastHit)]),
    "abut_layout_count": (c_size_t, []),
    "abut_layout_at": (Status, [c_size_t, POINTER(LayoutEntry)]),
}

PICKING_FUNCTIONS = {
    "abut_camera_init": (None, [POINTER(Camera), c_uint32]),
    "abut_camera_look_at": (Status, [POINTER(Camera), POINTER(Vec3), POINTER(Vec3), POINTER(Vec3)]),
    "abut_camera_ray": (Status, [POINTER(Camera), c_double, c_double, POINTER(Ray)]),
    "abut_picker_create": (Status, [c_void_p, POINTER(c_void_p)]),
    "abut_picker_destroy": (None, [c_void_p]),
    "abut_picker_update": (Status, [c_void_p]),
    "abut_picker_cast_ray": (Status, [c_void_p, POINTER(Ray), POINTER(QueryFilter), POINTER(Pick)]),
    "abut_picker_cast_rays": (Status, [
        c_void_p, POINTER(Ray), c_size_t, c_uint32, POINTER(QueryFilter), POINTER(Pick)]),
    "abut_picker_cast_ray_all": (Status, [
        c_void_p, POINTER(Ray), POINTER(QueryFilter), POINTER(Pick), c_size_t, POINTER(c_size_t)]),
    "abut_picker_pick_pixel": (Status, [
        c_void_p, POINTER(Camera), c_double, c_double, c_double, POINTER(QueryFilter), POINTER(Pick)]),
    "abut_picker_render": (Status, [c_void_p, POINTER(Camera), POINTER(QueryFilter), POINTER(Pick), c_size_t]),
}
