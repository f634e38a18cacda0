-- SPDX-License-Identifier: Apache-2.0
-- Tests of picking for LuaJIT.
local abut = require "abut"
local picking = require "abut_picking"

local function refused(words, call, ...)
  local is_fine, failure = pcall(call, ...)
  assert(not is_fine and tostring(failure):find(words, 1, true), tostring(failure) .. " lacks " .. words)
end

-- A row of unit cubes along X, 4 apart, and a camera in front of the one in the middle.
local universe, cube, geometries = abut.universe(), abut.box(1, 1, 1), {}
for i = 1, 3 do geometries[i] = universe:add_geometry(universe:add_part{pose = abut.pose(4 * i - 8)}, cube) end
local camera = picking.camera{width = 200, height = 100, eye = {0, -10, 0}, target = {0, 0, 0}}
local picker = picking.picker(universe)
local function is(id, i) return universe.key(id) == universe.key(geometries[i]) end

local hit = picker:pick_pixel(camera, 100, 50)
assert(is(hit.geometry, 2) and hit.distance == 9)
assert(picker:pick_pixel(camera, 100, 2) == nil)
local inside = picker:select(camera, 0, 0, 101, 100, true)
assert(#picker:select(camera, 0, 0, 101, 100) == 2 and #inside == 1 and is(inside[1], 1))
local picture, count = picker:render(camera)
assert(count == 20000 and picture[0].geometry.slot == 0 and is(picture[100 + 200 * 50].geometry, 2))
assert(is(picker:cast_ray({-10, 0, 0}, {1, 0, 0}).geometry, 1))
assert(picker:cast_ray({-10, 0, 3}, {1, 0, 0}) == nil)
assert(picker:cast_ray({-10, 0, 0}, {1, 0, 0}, 4) == nil)
assert(#picker:cast_ray_all({-10, 0, 0}, {1, 0, 0}) == 6)
picker:set_flags{skips_back_faces = true}
assert(#picker:cast_ray_all({-10, 0, 0}, {1, 0, 0}) == 3)

refused("radius is -1", picker.pick_pixel, picker, camera, 1, 1, -1)
refused("direction", picker.cast_ray, picker, {0, 0, 0}, {0, 0, 0})
refused("origin is not a table of three numbers", picker.cast_ray, picker, {0, 0}, {0, 0, 1})
refused("widht cannot be 3 in abut_camera", picking.camera, {widht = 3})
refused("mask is 'all'", picker.pick_pixel, picker, camera, 1, 1, 0, {mask = "all"})
universe:destroy()
assert(is(picker:pick_pixel(camera, 100, 50).geometry, 2)) -- the picker keeps the universe
picker:destroy()
picker:destroy()
refused("picker", picker.pick_pixel, picker, camera, 100, 50)
print("passed picking")
