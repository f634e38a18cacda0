# SPDX-License-Identifier: Apache-2.0
# The parts that a build may leave out, each in folders of its own. A part is a feature of ABUT_FEATURES, or what a shape of the
# build NEEDS (cmake/registry.cmake). The linker leaves out what nothing in the rest asks for.
include_guard(GLOBAL)

set(abut_known_parts "")
# FOLDERS: left out together; where a folder `<folder>_absent` lies beside one, that takes its place.
# EMPTY: modules of these folders that templates import whatever the shapes are. An empty module of that name takes the place of each:
# a template for a shape that needs none of it names nothing of it.
function(abut_part name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FOLDERS;EMPTY")
  set(abut_known_parts ${abut_known_parts} ${name} PARENT_SCOPE)
  set(abut_folders_${name} ${arg_FOLDERS} PARENT_SCOPE)
  set(abut_empty_${name} ${arg_EMPTY} PARENT_SCOPE)
endfunction()

abut_part(universe FOLDERS modules/broadphase modules/detect modules/queries modules/report modules/scene modules/universe capi/universe)
abut_part(motion FOLDERS modules/motion/impacts modules/pairs/taken_apart modules/detect/continuous modules/queries/motion
                         modules/universe/motion capi/motion capi/universe/motion)
abut_part(deforming FOLDERS modules/deforming modules/elements modules/proximity modules/trees/elements modules/triangles/elements
                            modules/detect/elements capi/deforming capi/universe/deforming)
abut_part(libccd FOLDERS modules/narrow/libccd/query)
abut_part(threads FOLDERS modules/core/threads)

abut_part(surfaces FOLDERS modules/narrow/surface modules/narrow/sides modules/narrow/two_surfaces modules/narrow/overlap/surfaces
                           modules/pairs/surfaces/met
                   EMPTY abut.narrow.two_surfaces abut.narrow.overlap.surfaces.surface_overlap)
abut_part(fields FOLDERS modules/narrow/field modules/trees/samples
                 EMPTY abut.narrow.field.field_contacts abut.narrow.field.field_surfaces)
abut_part(fields_of_meshes FOLDERS modules/pairs/any_shape/fields capi/shapes/fields)
abut_part(walls FOLDERS modules/narrow/walls EMPTY abut.narrow.walls.half_space abut.narrow.walls.hole_surfaces)
abut_part(discs FOLDERS modules/narrow/fan/discs EMPTY abut.narrow.fan.discs.disc_depth_of_pair)
abut_part(composites FOLDERS modules/pairs/composites/rows)

# Of the sources in `in_out_files`, relative to the folder `room` of the project, those that the build has.
function(abut_leave_out_parts room in_out_files)
  foreach(part IN LISTS abut_known_parts)
    foreach(folder IN LISTS abut_folders_${part})
      if(folder MATCHES "^${room}/(.*)$")
        set(absent "${CMAKE_MATCH_1}")
        if(part IN_LIST abut_parts_of_build)
          string(APPEND absent "_absent")
        endif()
        list(FILTER ${in_out_files} EXCLUDE REGEX "^${absent}/")
      endif()
    endforeach()
  endforeach()
  set(${in_out_files} ${${in_out_files}} PARENT_SCOPE)
endfunction()

# Writes the modules that stand in for what is left out, and appends their names to `in_out_files`.
function(abut_write_empty_modules in_out_files)
  foreach(part IN LISTS abut_known_parts)
    if(NOT part IN_LIST abut_parts_of_build)
      foreach(name IN LISTS abut_empty_${part})
        set(file ${CMAKE_BINARY_DIR}/gen/absent/${name}.cppm)
        file(CONFIGURE OUTPUT ${file} CONTENT "// SPDX-License-Identifier: Apache-2.0\n// No shape of this build needs it.\nexport module ${name};\n")
        list(APPEND ${in_out_files} ${file})
      endforeach()
    endif()
  endforeach()
  set(${in_out_files} ${${in_out_files}} PARENT_SCOPE)
endfunction()
