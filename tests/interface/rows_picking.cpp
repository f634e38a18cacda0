// SPDX-License-Identifier: Apache-2.0
// Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit.
#include "table.hpp"

#include <abut/picking.h>

namespace abut_test::table {

// clang-format off
std::vector<Function> functions_of_picking() {
  return {
    {.name = "abut_camera_look_at",
     .call = [](const Given& given) { return abut_camera_look_at(given[0], given[1], given[2], given[3]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "camera", .role = Role::structure, .type = "abut_camera", .size = 96, .is_pointer = true, .is_output = true},
        {.name = "eye", .role = Role::structure, .type = "abut_vec3", .size = 24, .is_pointer = true},
        {.name = "target", .role = Role::structure, .type = "abut_vec3", .size = 24, .is_pointer = true},
        {.name = "up", .role = Role::structure, .type = "abut_vec3", .size = 24, .is_pointer = true, .range = {.may_be_far = true}},
     }},
    {.name = "abut_camera_ray",
     .call = [](const Given& given) { return abut_camera_ray(given[0], given[1], given[2], given[3]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "camera", .role = Role::structure, .type = "abut_camera", .size = 96, .is_pointer = true},
        {.name = "x", .role = Role::number, .type = "double", .size = 8, .is_real = true},
        {.name = "y", .role = Role::number, .type = "double", .size = 8, .is_real = true},
        {.name = "out", .role = Role::structure, .type = "abut_ray", .size = 56, .is_pointer = true, .is_output = true},
     }},
    {.name = "abut_picker_create",
     .call = [](const Given& given) { return abut_picker_create(given[0], given[1]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "universe", .role = Role::handle, .type = "abut_universe", .size = 8, .is_pointer = true},
        {.name = "out", .role = Role::made, .type = "abut_picker", .size = 8, .is_pointer = true, .is_output = true},
     }},
    {.name = "abut_picker_update",
     .call = [](const Given& given) { return abut_picker_update(given[0]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "picker", .role = Role::handle, .type = "abut_picker", .size = 8, .is_pointer = true},
     }},
    {.name = "abut_picker_cast_ray",
     .call = [](const Given& given) { return abut_picker_cast_ray(given[0], given[1], given[2], given[3]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "picker", .role = Role::handle, .type = "abut_picker", .size = 8, .is_pointer = true},
        {.name = "ray", .role = Role::structure, .type = "abut_ray", .size = 56, .is_pointer = true},
        {.name = "filter", .role = Role::structure, .type = "abut_query_filter", .size = 48, .is_pointer = true, .may_be_null = true},
        {.name = "out", .role = Role::structure, .type = "abut_pick", .size = 80, .is_pointer = true, .is_output = true},
     }},
    {.name = "abut_picker_cast_rays",
     .call = [](const Given& given) { return abut_picker_cast_rays(given[0], given[1], given[2], given[3], given[4], given[5]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "picker", .role = Role::handle, .type = "abut_picker", .size = 8, .is_pointer = true},
        {.name = "rays", .role = Role::structure, .type = "abut_ray", .size = 56, .is_pointer = true, .length = "count"},
        {.name = "count", .role = Role::number, .type = "size_t", .size = 8},
        {.name = "coherence", .role = Role::choice, .type = "abut_coherence", .size = 4, .known = 1},
        {.name = "filter", .role = Role::structure, .type = "abut_query_filter", .size = 48, .is_pointer = true, .may_be_null = true},
        {.name = "out", .role = Role::structure, .type = "abut_pick", .size = 80, .is_pointer = true, .length = "count", .is_output = true},
     }},
    {.name = "abut_picker_cast_ray_all",
     .call = [](const Given& given) { return abut_picker_cast_ray_all(given[0], given[1], given[2], given[3], given[4], given[5]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "picker", .role = Role::handle, .type = "abut_picker", .size = 8, .is_pointer = true},
        {.name = "ray", .role = Role::structure, .type = "abut_ray", .size = 56, .is_pointer = true},
        {.name = "filter", .role = Role::structure, .type = "abut_query_filter", .size = 48, .is_pointer = true, .may_be_null = true},
        {.name = "picks", .role = Role::structure, .type = "abut_pick", .size = 80, .is_pointer = true, .length = "capacity", .is_output = true},
        {.name = "capacity", .role = Role::number, .type = "size_t", .size = 8},
        {.name = "count", .role = Role::number, .type = "size_t", .size = 8, .is_pointer = true, .is_output = true},
     }},
    {.name = "abut_picker_pick_pixel",
     .call = [](const Given& given) { return abut_picker_pick_pixel(given[0], given[1], given[2], given[3], given[4], given[5], given[6]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "picker", .role = Role::handle, .type = "abut_picker", .size = 8, .is_pointer = true},
        {.name = "camera", .role = Role::structure, .type = "abut_camera", .size = 96, .is_pointer = true},
        {.name = "x", .role = Role::number, .type = "double", .size = 8, .is_real = true},
        {.name = "y", .role = Role::number, .type = "double", .size = 8, .is_real = true},
        {.name = "radius", .role = Role::number, .type = "double", .size = 8, .is_real = true, .range = {.least = 0.0}},
        {.name = "filter", .role = Role::structure, .type = "abut_query_filter", .size = 48, .is_pointer = true, .may_be_null = true},
        {.name = "out", .role = Role::structure, .type = "abut_pick", .size = 80, .is_pointer = true, .is_output = true},
     }},
    {.name = "abut_picker_render",
     .call = [](const Given& given) { return abut_picker_render(given[0], given[1], given[2], given[3], given[4]); },
     .is_exclusive = false,
     .arguments = {
        {.name = "picker", .role = Role::handle, .type = "abut_picker", .size = 8, .is_pointer = true},
        {.name = "camera", .role = Role::structure, .type = "abut_camera", .size = 96, .is_pointer = true},
        {.name = "filter", .role = Role::structure, .type = "abut_query_filter", .size = 48, .is_pointer = true, .may_be_null = true},
        {.name = "out", .role = Role::structure, .type = "abut_pick", .size = 80, .is_pointer = true, .length = "capacity", .is_output = true},
        {.name = "capacity", .role = Role::number, .type = "size_t", .size = 8},
     }},
  };
}

std::vector<Struct> structs_of_picking() {
  return {
    {.name = "abut_pick", .size = sizeof(abut_pick),
     .init = nullptr,
     .fields = {
        {.name = "geometry", .role = Role::id, .type = "abut_geometry_id", .size = 8, .offset = 0, .may_be_null = true},
        {.name = "feature", .role = Role::structure, .type = "abut_feature", .size = 8, .offset = 8},
        {.name = "child", .role = Role::number, .type = "uint32_t", .size = 4, .offset = 16},
        {.name = "reserved", .role = Role::number, .type = "uint32_t", .size = 4, .offset = 20, .range = {.is_reserved = true}},
        {.name = "distance", .role = Role::number, .type = "double", .size = 8, .offset = 24, .is_real = true, .range = {.may_be_infinite = true, .may_be_far = true}},
        {.name = "point", .role = Role::structure, .type = "abut_vec3", .size = 24, .offset = 32},
        {.name = "normal", .role = Role::structure, .type = "abut_vec3", .size = 24, .offset = 56},
     }},
    {.name = "abut_camera", .size = sizeof(abut_camera),
     .init = [](void* place, std::uint32_t size) { abut_camera_init(static_cast<abut_camera*>(place), size); },
     .fields = {
        {.name = "struct_size", .role = Role::number, .type = "uint32_t", .size = 4, .offset = 0},
        {.name = "width", .role = Role::number, .type = "uint32_t", .size = 4, .offset = 4, .range = {.least = 1.0}},
        {.name = "height", .role = Role::number, .type = "uint32_t", .size = 4, .offset = 8, .range = {.least = 1.0}},
        {.name = "reserved", .role = Role::number, .type = "uint32_t", .size = 4, .offset = 12, .range = {.is_reserved = true}},
        {.name = "pose", .role = Role::structure, .type = "abut_pose", .size = 56, .offset = 16},
        {.name = "vertical_fov", .role = Role::number, .type = "double", .size = 8, .offset = 72, .is_real = true},
        {.name = "near_distance", .role = Role::number, .type = "double", .size = 8, .offset = 80, .is_real = true},
        {.name = "far_distance", .role = Role::number, .type = "double", .size = 8, .offset = 88, .is_real = true, .range = {.may_be_infinite = true, .may_be_far = true}},
     }},
  };
}
// clang-format on

}  // namespace abut_test::table
