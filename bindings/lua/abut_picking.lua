-- SPDX-License-Identifier: Apache-2.0
-- abut_picking for LuaJIT: what rays and the mouse meet in a universe, through Embree. It needs libabut_picking.
-- Pictures have x to the right and y down, in pixels; (0.5, 0.5) is the centre of the first one.
local ffi = require "ffi"
local core = require "abut_core"
local version = require "abut_cdef"

local name = os.getenv("ABUT_PICKING_LIBRARY") or ("libabut_picking.so.%d.%d"):format(version.major, version.minor)
local is_there, library = pcall(ffi.load, name)
if not is_there then
  error(name .. " cannot be loaded; install abut, or name the file of the library in ABUT_PICKING_LIBRARY", 0)
end
local check = core.check
local picking = {library = library}

-- A camera with fields of abut_camera, such as {width = 800, height = 600, vertical_fov = 1}. With `eye` and `target`, tables of
-- three numbers, it looks there; `up` is +Z where it is left out.
function picking.camera(fields)
  local camera = ffi.new("abut_camera")
  library.abut_camera_init(camera, ffi.sizeof(camera))
  local place = {}
  for field, value in pairs(fields or {}) do
    if field == "eye" or field == "target" or field == "up" then
      place[field] = core.vec3(value, field)
    else
      core.set(camera, "abut_camera", field, value)
    end
  end
  if place.eye or place.target then
    local up = place.up or core.vec3({0, 0, 1}, "up")
    check(library.abut_camera_look_at(camera, place.eye, place.target, up))
  end
  return camera
end

local Picker = {}
Picker.__index = Picker

-- A picker of a universe, which it follows and keeps until both are gone. It sees poses as of the last step. Lua collects it.
function picking.picker(universe)
  local out = ffi.new("abut_picker *[1]")
  check(library.abut_picker_create(universe.pointer, out))
  return setmetatable({pointer = ffi.gc(out[0], library.abut_picker_destroy)}, Picker)
end

-- Frees it now; calls that come later are refused. Twice is allowed.
function Picker:destroy()
  if self.pointer ~= nil then library.abut_picker_destroy(ffi.gc(self.pointer, nil)) end
  self.pointer = nil
end

-- Chooses what queries meet: {sensors = true} for sensors as well, {skips_back_faces = true} for fronts alone.
function Picker:set_flags(flags)
  local bits = (flags.sensors and 1 or 0) + (flags.skips_back_faces and 2 or 0)
  check(library.abut_picker_set_flags(self.pointer, bits))
end

local function met(pick) return pick.geometry.slot ~= 0 and pick or nil end

-- The first thing that a ray meets, as an abut_pick; nil for none. Filters are fields of abut_query_filter.
function Picker:cast_ray(origin, direction, max_distance, filter)
  local out = ffi.new("abut_pick")
  check(library.abut_picker_cast_ray(
    self.pointer, core.ray(origin, direction, max_distance), core.options("abut_query_filter", filter), out))
  return met(out)
end

-- A table of all crossings of surfaces, nearest first.
function Picker:cast_ray_all(origin, direction, max_distance, filter)
  local ray, its = core.ray(origin, direction, max_distance), core.options("abut_query_filter", filter)
  return core.fill("abut_pick", function(place, capacity, count)
    return library.abut_picker_cast_ray_all(self.pointer, ray, its, place, capacity, count)
  end)
end

-- What lies under the mouse, or within `radius` pixels of it; nil for nothing.
function Picker:pick_pixel(camera, x, y, radius, filter)
  local out = ffi.new("abut_pick")
  check(library.abut_picker_pick_pixel(
    self.pointer, camera, x, y, radius or 0, core.options("abut_query_filter", filter), out))
  return met(out)
end

-- A table of the geometries of which any point lies in the rectangle from (x0, y0) to (x1, y1); with `is_inside`, all points.
function Picker:select(camera, x0, y0, x1, y1, is_inside, filter)
  local its = core.options("abut_query_filter", filter)
  return core.fill("abut_geometry_id", function(place, capacity, count)
    return library.abut_picker_select_rectangle(
      self.pointer, camera, x0, y0, x1, y1, is_inside and 1 or 0, its, place, capacity, count)
  end)
end

-- An array of abut_pick from index 0, one for each pixel, row by row from the top, and how many there are. Where a ray meets
-- nothing, the slot of the geometry is 0.
function Picker:render(camera, filter)
  local count = camera.width * camera.height
  local out = ffi.new("abut_pick[?]", math.max(count, 1))
  check(library.abut_picker_render(self.pointer, camera, core.options("abut_query_filter", filter), out, count))
  return out, count
end

return picking
