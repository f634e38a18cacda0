-- SPDX-License-Identifier: Apache-2.0
-- abut for LuaJIT: shapes, queries on two of them, and universes. Structs are those of abut.h.
local ffi = require "ffi"
local core = require "abut_core"
local library, check = core.library, core.check

local abut = {pose = core.pose, universe = require "abut_universe", library = library}

-- Shapes are collected by Lua; geometries of a universe keep theirs alive.
local function made(create, ...)
  local out = ffi.new("abut_shape *[1]")
  local arguments = {...}
  arguments[#arguments + 1] = out
  check(create(unpack(arguments)))
  return ffi.gc(out[0], library.abut_shape_release)
end

local function points(xyz, name)
  if #xyz % 3 ~= 0 then core.refuse("%s has %d numbers, which is not a multiple of 3", name, #xyz) end
  local array, count = core.array("double", xyz)
  return array, count / 3
end

function abut.sphere(radius) return made(library.abut_sphere_create, radius) end
function abut.box(x, y, z) return made(library.abut_box_create, x, y, z) end
function abut.capsule(radius, half_height) return made(library.abut_capsule_create, radius, half_height) end
function abut.cylinder(radius, half_height) return made(library.abut_cylinder_create, radius, half_height) end
function abut.plane(normal, offset) return made(library.abut_plane_create, core.vec3(normal, "normal"), offset) end

-- The convex hull of points, x, y, z each.
function abut.hull(xyz)
  local array, count = points(xyz, "xyz")
  return made(library.abut_hull_create, array, count)
end

-- A surface of triangles, each three indices from 0; options such as {sides = ...}, or {corners = 4} for quads.
function abut.mesh(xyz, triangles, options)
  local width = options and options.corners == 4 and 4 or 3
  if #triangles % width ~= 0 then
    core.refuse("triangles has %d numbers, which is not a multiple of %d", #triangles, width)
  end
  local array, count = points(xyz, "xyz")
  local indices, index_count = core.array("uint32_t", triangles, "triangles")
  return made(library.abut_mesh_create, array, count, indices, index_count / width,
              core.options("abut_mesh_options", options))
end

-- Terrain: columns * rows heights, X fastest.
function abut.height_field(columns, rows, spacing_x, spacing_y, heights)
  if #heights ~= columns * rows then
    core.refuse("heights has %d numbers; expected columns * rows, which is %d", #heights, columns * rows)
  end
  local array = core.array("double", heights)
  return made(library.abut_height_field_create, core.options("abut_height_field_desc", {
    columns = columns, rows = rows, spacing_x = spacing_x, spacing_y = spacing_y, heights = array}))
end

function abut.particles(xyz, radius)
  local array, count = points(xyz, "xyz")
  return made(library.abut_particles_create, array, count, radius)
end

function abut.composite(children, poses)
  if #children ~= #poses then core.refuse("children has %d shapes and poses has %d; expected as many", #children, #poses) end
  local array = ffi.new("const abut_shape *[?]", math.max(#children, 1), children)
  return made(library.abut_composite_create, array, core.array("abut_pose", poses), #children)
end

-- Any kind that numbers describe, such as abut.shape("cone", radius, half_height).
function abut.shape(kind, ...)
  local parameters, count = core.array("double", {...})
  local desc = core.options("abut_shape_desc", {
    kind = library.abut_shape_kind_by_name(kind), parameters = parameters, parameter_count = count})
  return made(library.abut_shape_create, desc)
end

function abut.kind(shape) return ffi.string(library.abut_shape_kind_name(library.abut_shape_kind_of(shape))) end

-- The abut_distance of two shapes; options are fields of abut_query_options.
function abut.distance(a, pose_a, b, pose_b, options)
  local out = ffi.new("abut_distance")
  check(library.abut_pair_distance(a, pose_a, b, pose_b, core.options("abut_query_options", options), out))
  return out
end

-- Whether two shapes are within the margin of the options, by default 0.
function abut.overlaps(a, pose_a, b, pose_b, options)
  local out = ffi.new("uint32_t[1]")
  check(library.abut_pair_overlaps(a, pose_a, b, pose_b, core.options("abut_query_options", options), out))
  return out[0] == 1
end

-- A table of the abut_contact of two shapes, deepest first.
function abut.contacts(a, pose_a, b, pose_b, options)
  local its = core.options("abut_query_options", options)
  return core.fill("abut_contact", function(place, capacity, count)
    return library.abut_pair_contacts(a, pose_a, b, pose_b, its, place, capacity, count)
  end)
end

-- When two shapes that move by displacements first touch, as an abut_cast_hit; nil when they do not.
function abut.cast(a, pose_a, displacement_a, b, pose_b, displacement_b, options)
  local hit, found = ffi.new("abut_cast_hit"), ffi.new("uint32_t[1]")
  check(library.abut_pair_cast(
    a, pose_a, core.vec3(displacement_a, "displacement_a"), b, pose_b, core.vec3(displacement_b, "displacement_b"),
    core.options("abut_query_options", options), hit, found))
  return found[0] == 1 and hit or nil
end

-- Where a ray first crosses a shape, as an abut_ray_hit; nil when it does not.
function abut.cast_ray(shape, pose, origin, direction, max_distance)
  local hit, found = ffi.new("abut_ray_hit"), ffi.new("uint32_t[1]")
  local ray = core.ray(origin, direction, max_distance)
  check(library.abut_shape_cast_ray(shape, pose, ray, hit, found))
  return found[0] == 1 and hit or nil
end

return abut
