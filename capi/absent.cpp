// SPDX-License-Identifier: Apache-2.0
// Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.
// clang-format off
// Functions of features and of kinds of shapes that a build may leave out. They are weak: where the build has the
// feature, its own function takes their place. Options are filled with zeros, since nothing reads them.
#include "guard.hpp"
#include "options.hpp"

import abut.core.standard;

using namespace abut::capi;

namespace {

abut_status refuse_absent(std::initializer_list<std::string_view> features) {
  return guard([&] {
    std::string_view missing;
    for (const std::string_view name : features) {
      missing = missing.empty() && abut_has_feature(name.data()) == 0 ? name : missing;
    }
    return refuse(ABUT_UNSUPPORTED, "this build of abut is without the feature \"" + std::string(missing) + "\"");
  });
}

abut_status refuse_kind(std::string_view name) {
  return guard([&] { return refuse(ABUT_UNSUPPORTED, "this build of abut has no shape named " + std::string(name)); });
}

}  // namespace

[[gnu::weak]] void abut_distance_field_desc_init(abut_distance_field_desc * desc, uint32_t struct_size) {
  fill_defaults(abut_distance_field_desc{}, struct_size, desc);
}
[[gnu::weak]] abut_status abut_distance_field_create(const abut_distance_field_desc *, abut_shape **) {
  return refuse_kind("distance_field");
}
[[gnu::weak]] void abut_distance_field_options_init(abut_distance_field_options * options, uint32_t struct_size) {
  fill_defaults(abut_distance_field_options{}, struct_size, options);
}
[[gnu::weak]] abut_status abut_distance_field_from_mesh(const double *, size_t, const uint32_t *, size_t, const
    abut_distance_field_options *, abut_shape **) {
  return refuse_kind("distance_field");
}
[[gnu::weak]] void abut_distance_field_report_init(abut_distance_field_report * report, uint32_t struct_size) {
  fill_defaults(abut_distance_field_report{}, struct_size, report);
}
[[gnu::weak]] abut_status abut_distance_field_describe(const abut_shape *, abut_distance_field_report *) {
  return refuse_kind("distance_field");
}
[[gnu::weak]] abut_status abut_vertices_touch_faces(const double *, const double *, size_t, double, double,
    abut_first_touch *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_edges_touch_edges(const double *, const double *, size_t, double, double,
    abut_first_touch *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_elements_create(const abut_shape *, abut_elements **) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] void abut_elements_destroy(abut_elements *) {
}
[[gnu::weak]] abut_status abut_elements_count(const abut_elements *, abut_element_counts *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_elements_edges(const abut_elements *, uint32_t *, size_t, size_t *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_elements_set_vertices(abut_elements *, const double *, const double *, size_t) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] void abut_elements_options_init(abut_elements_options * options, uint32_t struct_size) {
  fill_defaults(abut_elements_options{}, struct_size, options);
}
[[gnu::weak]] abut_status abut_elements_candidates(abut_elements *, abut_elements *, const abut_elements_options *,
    abut_element_pair *, size_t, size_t *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_elements_closest(abut_elements *, abut_elements *, const abut_elements_options *,
    abut_stencil *, size_t, size_t *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_elements_first_touches(abut_elements *, abut_elements *, const abut_elements_options *,
    abut_stencil *, size_t, size_t *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_elements_crossings(abut_elements *, abut_elements *, const abut_elements_options *,
    abut_crossing *, size_t, size_t *) {
  return refuse_absent({"deforming"});
}
[[gnu::weak]] abut_status abut_movement_between(const abut_pose *, const abut_pose *, const abut_vec3 *, double,
    abut_movement *) {
  return refuse_absent({"motion"});
}
[[gnu::weak]] void abut_impact_options_init(abut_impact_options * options, uint32_t struct_size) {
  fill_defaults(abut_impact_options{}, struct_size, options);
}
[[gnu::weak]] abut_status abut_pair_time_of_impact(const abut_shape *, const abut_pose *, const abut_movement *, const
    abut_shape *, const abut_pose *, const abut_movement *, double, const abut_impact_options *, abut_impact *) {
  return refuse_absent({"motion"});
}
[[gnu::weak]] abut_status abut_pairs_time_of_impact(const abut_shape *, const abut_pose *, const abut_movement *,
    const abut_shape *, const abut_pose *, const abut_movement *, size_t, double, const abut_impact_options *,
    abut_impact *) {
  return refuse_absent({"motion"});
}
[[gnu::weak]] void abut_universe_options_init(abut_universe_options * options, uint32_t struct_size) {
  fill_defaults(abut_universe_options{}, struct_size, options);
}
[[gnu::weak]] abut_status abut_universe_create(const abut_universe_options *, abut_universe **) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_universe_destroy(abut_universe *) {
}
[[gnu::weak]] abut_status abut_universe_save(const abut_universe *, void *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_load(const void *, size_t, abut_universe **) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_part_options_init(abut_part_options * options, uint32_t struct_size) {
  fill_defaults(abut_part_options{}, struct_size, options);
}
[[gnu::weak]] abut_status abut_part_create(abut_universe *, const abut_part_options *, abut_part_id *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_create(abut_universe *, const abut_part_options *, size_t, abut_part_id *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_destroy(abut_universe *, abut_part_id) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_destroy(abut_universe *, const abut_part_id *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_set_pose(abut_universe *, abut_part_id, const abut_pose *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_set_poses(abut_universe *, const abut_part_id *, const abut_pose *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_pose(const abut_universe *, abut_part_id, abut_pose *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_poses(const abut_universe *, const abut_part_id *, size_t, abut_pose *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_set_motion(abut_universe *, abut_part_id, abut_motion) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_set_motions(abut_universe *, const abut_part_id *, const abut_motion *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_motion(const abut_universe *, abut_part_id, abut_motion *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_user_data(const abut_universe *, abut_part_id, uint64_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_set_user_data(abut_universe *, abut_part_id, uint64_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_set_user_data(abut_universe *, const abut_part_id *, const uint64_t *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_geometries(const abut_universe *, abut_part_id, abut_geometry_id *, size_t, size_t
    *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_sleep_init(abut_sleep * sleep, uint32_t struct_size) {
  fill_defaults(abut_sleep{}, struct_size, sleep);
}
[[gnu::weak]] abut_status abut_part_set_sleep(abut_universe *, abut_part_id, const abut_sleep *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_set_sleep(abut_universe *, const abut_part_id *, const abut_sleep *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_is_asleep(const abut_universe *, abut_part_id, uint32_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_wake(abut_universe *, abut_part_id) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_wake(abut_universe *, const abut_part_id *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_geometry_options_init(abut_geometry_options * options, uint32_t struct_size) {
  fill_defaults(abut_geometry_options{}, struct_size, options);
}
[[gnu::weak]] abut_status abut_geometry_create(abut_universe *, abut_part_id, const abut_shape *, const
    abut_geometry_options *, abut_geometry_id *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_create(abut_universe *, const abut_part_id *, const abut_shape *const *,
    const abut_geometry_options *, size_t, abut_geometry_id *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_destroy(abut_universe *, abut_geometry_id) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_destroy(abut_universe *, const abut_geometry_id *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_options(abut_universe *, abut_geometry_id, const abut_geometry_options *)
    {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_set_options(abut_universe *, const abut_geometry_id *, const
    abut_geometry_options *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_user_data(abut_universe *, abut_geometry_id, uint64_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_set_user_data(abut_universe *, const abut_geometry_id *, const uint64_t *,
    size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_shape(abut_universe *, abut_geometry_id, const abut_shape *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_set_shapes(abut_universe *, const abut_geometry_id *, const abut_shape
    *const *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_parameters(abut_universe *, abut_geometry_id, const double *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_set_parameters(abut_universe *, const abut_geometry_id *, const double *,
    size_t, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_heights(abut_universe *, abut_geometry_id, uint32_t, uint32_t, uint32_t,
    uint32_t, const double *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_field_values(abut_universe *, abut_geometry_id, uint32_t, uint32_t,
    uint32_t, uint32_t, uint32_t, uint32_t, const double *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_field_lattice(abut_universe *, abut_geometry_id, uint32_t, uint32_t,
    uint32_t, const double *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_particles(abut_universe *, abut_geometry_id, size_t, const double *, const
    double *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_vertices(abut_universe *, abut_geometry_id, size_t, const double *,
    size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_vertices_at(abut_universe *, abut_geometry_id, const uint32_t *, const
    double *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_vertices(const abut_universe *, abut_geometry_id, const double **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_next_vertices(abut_universe *, abut_geometry_id, double **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_advance(abut_universe *, abut_geometry_id) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_advance(abut_universe *, const abut_geometry_id *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_remove_triangles(abut_universe *, abut_geometry_id, const uint32_t *, size_t)
    {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_set_mesh(abut_universe *, abut_geometry_id, const double *, size_t, const
    uint32_t *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_shape(const abut_universe *, abut_geometry_id, abut_shape **) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometry_park(abut_universe *, abut_geometry_id, abut_parking) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_park(abut_universe *, const abut_geometry_id *, size_t, abut_parking) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_geometry_info_init(abut_geometry_info * info, uint32_t struct_size) {
  fill_defaults(abut_geometry_info{}, struct_size, info);
}
[[gnu::weak]] abut_status abut_geometry_describe(const abut_universe *, abut_geometry_id, abut_geometry_info *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_geometries_poses(const abut_universe *, const abut_geometry_id *, size_t, abut_pose *)
    {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_parts(const abut_universe *, abut_part_id *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_geometries(const abut_universe *, abut_geometry_id *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_revision(const abut_universe *, abut_revision *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_counters(const abut_universe *, const uint64_t **, const uint64_t **) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_changes(const abut_universe *, const abut_revision *, abut_geometry_id *,
    size_t, size_t *, uint32_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_rule_set(abut_universe *, const abut_collidable *, const abut_collidable *, abut_rule)
    {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_rules_clear(abut_universe *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_rule_between(const abut_universe *, abut_geometry_id, abut_geometry_id, abut_rule *,
    abut_collidable *, abut_collidable *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_set_filter(abut_universe *, abut_filter, void *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_set_pointer_filter(abut_universe *, abut_pointer_filter, void *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_refilter(abut_universe *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_policy_init(abut_policy * policy, uint32_t struct_size) {
  fill_defaults(abut_policy{}, struct_size, policy);
}
[[gnu::weak]] abut_status abut_policy_set(abut_universe *, uint32_t, uint32_t, const abut_policy *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_policy_get(const abut_universe *, uint32_t, uint32_t, abut_policy *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_focus_init(abut_focus * focus, uint32_t struct_size) {
  fill_defaults(abut_focus{}, struct_size, focus);
}
[[gnu::weak]] abut_status abut_universe_set_focus(abut_universe *, const abut_focus *, const abut_vec3 *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_contact_material_init(abut_contact_material * material, uint32_t struct_size) {
  fill_defaults(abut_contact_material{}, struct_size, material);
}
[[gnu::weak]] abut_status abut_material_pair_set(abut_universe *, uint32_t, uint32_t, const abut_contact_material *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_material_pair_get(const abut_universe *, uint32_t, uint32_t, abut_contact_material *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_backend_set(abut_universe *, abut_backend_accepts, abut_backend_find, void *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_backend_answer(abut_universe *, size_t, const abut_backend_contact *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_step(abut_universe *, double) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_detect_all(abut_universe *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_detect_changed(abut_universe *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_detect_pairs(abut_universe *, const abut_geometry_id *, const abut_geometry_id
    *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_detect_region(abut_universe *, const abut_aabb *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_refresh(abut_universe *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_events(const abut_universe *, const abut_event **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_sleep_changes(const abut_universe *, const abut_sleep_change **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_hash(const abut_universe *, uint64_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_contacts(const abut_universe *, const abut_contact **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_local_points(const abut_universe *, const abut_local_points **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_contacts_set_user_data(abut_universe *, const uint64_t *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_step_stats_init(abut_step_stats * stats, uint32_t struct_size) {
  fill_defaults(abut_step_stats{}, struct_size, stats);
}
[[gnu::weak]] abut_status abut_universe_stats(const abut_universe *, abut_step_stats *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_explain(const abut_universe *, char *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_explain_json(const abut_universe *, char *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_why_apart(const abut_universe *, abut_geometry_id, abut_geometry_id,
    abut_apart_reasons *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_validate(const abut_universe *, abut_finding *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_follow_islands(abut_universe *, uint32_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_islands(const abut_universe *, const abut_island **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_island_parts(const abut_universe *, const abut_part_id **, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_island(const abut_universe *, abut_part_id, abut_island *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_set_velocity(abut_universe *, abut_part_id, const abut_velocity *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_set_velocities(abut_universe *, const abut_part_id *, const abut_velocity *,
    size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_measure_velocity(abut_universe *, abut_part_id) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_measure_velocities(abut_universe *, const abut_part_id *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_velocity(const abut_universe *, abut_part_id, abut_velocity *,
    abut_velocity_source *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_velocities(const abut_universe *, const abut_part_id *, size_t, abut_velocity *)
    {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_part_set_acceleration(abut_universe *, abut_part_id, const abut_acceleration *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_set_accelerations(abut_universe *, const abut_part_id *, const abut_acceleration
    *, size_t) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_parts_accelerations(const abut_universe *, const abut_part_id *, size_t,
    abut_acceleration *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_impacts(const abut_universe *, const abut_step_impact **, size_t *) {
  return refuse_absent({"universe", "motion"});
}
[[gnu::weak]] abut_status abut_universe_advance_to_first_impact(abut_universe *, double, abut_step_impact *) {
  return refuse_absent({"universe", "motion"});
}
[[gnu::weak]] abut_status abut_universe_element_contacts(const abut_universe *, const abut_element_contact **, size_t
    *) {
  return refuse_absent({"universe", "deforming"});
}
[[gnu::weak]] abut_status abut_universe_attach(const abut_universe *, const char *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_detach(const abut_universe *, const char *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] void abut_query_filter_init(abut_query_filter * filter, uint32_t struct_size) {
  fill_defaults(abut_query_filter{}, struct_size, filter);
}
[[gnu::weak]] abut_status abut_universe_cast_ray(const abut_universe *, const abut_ray *, const abut_query_filter *,
    abut_hit_mode, abut_query_hit *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_cast_rays(const abut_universe *, const abut_ray *, size_t, const
    abut_query_filter *, abut_query_hit *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_cast_shape(const abut_universe *, const abut_shape *, const abut_pose *, const
    abut_vec3 *, const abut_query_filter *, abut_hit_mode, abut_cast_hit *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_cast_shapes(const abut_universe *, const abut_shape *const *, const abut_pose
    *, const abut_vec3 *, size_t, const abut_query_filter *, abut_cast_hit *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_cast_movement(const abut_universe *, const abut_shape *, const abut_pose *,
    const abut_movement *, double, const abut_impact_options *, const abut_query_filter *, abut_hit_mode,
    abut_impact_hit *, size_t, size_t *) {
  return refuse_absent({"universe", "motion"});
}
[[gnu::weak]] abut_status abut_universe_cast_movements(const abut_universe *, const abut_shape *const *, const
    abut_pose *, const abut_movement *, size_t, double, const abut_impact_options *, const abut_query_filter *,
    abut_impact_hit *) {
  return refuse_absent({"universe", "motion"});
}
[[gnu::weak]] abut_status abut_universe_overlaps(const abut_universe *, const abut_shape *, const abut_pose *, const
    abut_query_filter *, double, abut_geometry_id *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_overlaps_of_each(const abut_universe *, const abut_shape *const *, const
    abut_pose *, size_t, const abut_query_filter *, double, uint64_t *, abut_geometry_id *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_at_point(const abut_universe *, const abut_vec3 *, const abut_query_filter *,
    abut_geometry_id *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_at_points(const abut_universe *, const abut_vec3 *, size_t, const
    abut_query_filter *, uint64_t *, abut_geometry_id *, size_t, size_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_closest(const abut_universe *, const abut_shape *, const abut_pose *, double,
    const abut_query_filter *, abut_closest *, uint32_t *) {
  return refuse_absent({"universe"});
}
[[gnu::weak]] abut_status abut_universe_closest_to_each(const abut_universe *, const abut_shape *const *, const
    abut_pose *, size_t, double, const abut_query_filter *, abut_closest *) {
  return refuse_absent({"universe"});
}
// clang-format on
