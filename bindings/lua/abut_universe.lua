-- SPDX-License-Identifier: Apache-2.0
-- A universe: parts that move, geometries on them, and steps that find what touches.
local ffi = require "ffi"
local core = require "abut_core"
local library, check = core.library, core.check

local Universe = {}
Universe.__index = Universe

-- A universe with fields of abut_universe_options, such as {threads = 4}. Lua collects it, unless its filter names it:
-- destroy it then.
local function universe(options)
  local out = ffi.new("abut_universe *[1]")
  check(library.abut_universe_create(core.options("abut_universe_options", options), out))
  -- What is collected must not name the universe itself, so the callback of its filter is in a table of its own.
  local filter = {}
  local function free(its)
    library.abut_universe_destroy(its)
    if filter.callback then filter.callback:free() end
    filter.callback = nil
  end
  return setmetatable({pointer = ffi.gc(out[0], free), filter = filter, free = free}, Universe)
end

-- Frees it now; calls that come later are refused. Twice is allowed.
function Universe:destroy()
  if self.pointer ~= nil then self.free(ffi.gc(self.pointer, nil)) end
  self.pointer = nil
end

-- A part with fields of abut_part_options, such as {motion = "static", pose = abut.pose(0, 0, 1)}.
function Universe:add_part(options)
  local out = ffi.new("abut_part_id")
  check(library.abut_part_create(self.pointer, core.options("abut_part_options", options), out))
  return out
end

-- Puts a shape on a part, with fields of abut_geometry_options, such as {mask = 2}.
function Universe:add_geometry(part, shape, options)
  local out = ffi.new("abut_geometry_id")
  check(library.abut_geometry_create(self.pointer, part, shape, core.options("abut_geometry_options", options), out))
  return out
end

function Universe:remove_part(part) check(library.abut_part_destroy(self.pointer, part)) end
function Universe:remove_geometry(geometry) check(library.abut_geometry_destroy(self.pointer, geometry)) end
function Universe:set_pose(part, pose) check(library.abut_part_set_pose(self.pointer, part, pose)) end

-- Places parts, all or none; both are tables.
function Universe:set_poses(parts, poses)
  if #parts ~= #poses then core.refuse("parts has %d ids and poses has %d; expected as many", #parts, #poses) end
  check(library.abut_parts_set_poses(
    self.pointer, core.array("abut_part_id", parts), core.array("abut_pose", poses), #parts))
end

function Universe:pose(part)
  local out = ffi.new("abut_pose")
  check(library.abut_part_pose(self.pointer, part, out))
  return out
end

-- Parks a geometry: "short_term", "long_term", or "none" to bring it back. A filter may do that, too.
function Universe:park(geometry, parking)
  check(library.abut_geometry_park(self.pointer, geometry, core.value("parking", parking)))
end

local reasons = {"part", "motion", "parking", "exclusion", "layers", "rule", "filter", "kinds", "boxes", "policy", "detection", "side"}

-- A table of the reasons why two geometries are not examined, such as "layers"; empty where they are.
function Universe:why_apart(a, b)
  local out, found = ffi.new("uint32_t[1]"), {}
  check(library.abut_universe_why_apart(self.pointer, a, b, out))
  for i, reason in ipairs(reasons) do
    if bit.band(out[0], bit.lshift(1, i - 1)) ~= 0 then found[#found + 1] = reason end
  end
  return found
end

-- Whether pairs meet: rule is "enable", "disable", or "none" to take one away. A side is {geometry = id}, {part = id},
-- {label = number} or "any".
function Universe:set_rule(a, b, rule)
  local sides = {}
  for i, side in ipairs({a, b}) do
    local kind, id
    if side == "any" then kind, id = 3, {0, 0}
    elseif type(side) == "table" and side.geometry then kind, id = 0, {side.geometry.slot, side.geometry.generation}
    elseif type(side) == "table" and side.part then kind, id = 1, {side.part.slot, side.part.generation}
    elseif type(side) == "table" and side.label then kind, id = 2, {side.label, 0}
    else core.refuse("%s is no side of a rule: {geometry = id}, {part = id}, {label = number} or 'any'", i == 1 and "a" or "b") end
    sides[i] = ffi.new("abut_collidable")
    core.set(sides[i], "abut_collidable", "kind", kind)
    core.set(sides[i], "abut_collidable", "slot", id[1])
    core.set(sides[i], "abut_collidable", "generation", id[2])
  end
  check(library.abut_rule_set(self.pointer, sides[1], sides[2], core.value("rule", rule)))
end

-- keeps(a, b) says whether two geometries that come near meet; nil for no filter. What it raises leaves the pair in,
-- and comes out of the step.
function Universe:set_filter(keeps)
  local filter, callback = self.filter, nil
  if keeps then
    -- Callbacks of LuaJIT take no structs by value, and nothing may be raised through C.
    callback = ffi.cast("abut_pointer_filter", function(_, _, a, b)
      local is_fine, is_kept = pcall(keeps, ffi.new("abut_geometry_id", a[0]), ffi.new("abut_geometry_id", b[0]))
      if not is_fine then
        filter.failure = filter.failure or {is_kept}
        return 1
      end
      return is_kept and 1 or 0
    end)
  end
  check(library.abut_universe_set_pointer_filter(self.pointer, callback, nil))
  if filter.callback then filter.callback:free() end
  filter.callback = callback
end

function Universe:refilter() check(library.abut_universe_refilter(self.pointer)) end

local function detect(self, call, ...)
  local status = call(self.pointer, ...)
  local failure = self.filter.failure
  self.filter.failure = nil
  if failure then error(failure[1], 0) end
  check(status)
end
-- A compiled call must not come back into Lua, which a filter does.
jit.off(detect)

-- Finds what touches at the present poses; moves nothing.
function Universe:step(dt) detect(self, library.abut_universe_step, dt) end
function Universe:detect_all() detect(self, library.abut_universe_detect_all) end
function Universe:detect_changed() detect(self, library.abut_universe_detect_changed) end
function Universe:refresh() check(library.abut_universe_refresh(self.pointer)) end

-- What the library lends until the universe changes: a pointer, from index 0, and a count. For loops that must be quick.
function Universe:lent_contacts()
  local values, count = ffi.new("const abut_contact *[1]"), ffi.new("size_t[1]")
  check(library.abut_universe_contacts(self.pointer, values, count))
  return values[0], tonumber(count[0])
end

-- A table of the abut_contact of the last step, for keeps.
function Universe:contacts() return core.copies("abut_contact", self:lent_contacts()) end

-- A table of the abut_event of the last step, for keeps.
function Universe:events()
  local values, count = ffi.new("const abut_event *[1]"), ffi.new("size_t[1]")
  check(library.abut_universe_events(self.pointer, values, count))
  return core.copies("abut_event", values[0], count[0])
end

-- The first geometry that a ray meets, as an abut_query_hit; nil for none. Filters are fields of abut_query_filter.
function Universe:cast_ray(origin, direction, max_distance, filter)
  local hit, count = ffi.new("abut_query_hit[1]"), ffi.new("size_t[1]")
  check(library.abut_universe_cast_ray(
    self.pointer, core.ray(origin, direction, max_distance), core.options("abut_query_filter", filter),
    library.ABUT_HIT_NEAREST, hit, 1, count))
  return count[0] > 0 and ffi.new("abut_query_hit", hit[0]) or nil
end

-- The first geometry that a shape meets while it moves, as an abut_cast_hit; nil for none.
function Universe:cast_shape(shape, pose, displacement, filter)
  local hit, count = ffi.new("abut_cast_hit[1]"), ffi.new("size_t[1]")
  check(library.abut_universe_cast_shape(
    self.pointer, shape, pose, core.vec3(displacement, "displacement"), core.options("abut_query_filter", filter),
    library.ABUT_HIT_NEAREST, hit, 1, count))
  return count[0] > 0 and ffi.new("abut_cast_hit", hit[0]) or nil
end

-- A table of the geometries that a shape touches, or has within a margin.
function Universe:overlaps(shape, pose, margin, filter)
  local its = core.options("abut_query_filter", filter)
  return core.fill("abut_geometry_id", function(place, capacity, count)
    return library.abut_universe_overlaps(self.pointer, shape, pose, its, margin or 0, place, capacity, count)
  end)
end

-- The geometry nearest to a shape, as an abut_closest; nil when none is as near as max_distance.
function Universe:closest(shape, pose, max_distance, filter)
  local out, found = ffi.new("abut_closest"), ffi.new("uint32_t[1]")
  check(library.abut_universe_closest(
    self.pointer, shape, pose, max_distance or math.huge, core.options("abut_query_filter", filter), out, found))
  return found[0] == 1 and out or nil
end

-- A text that is equal for equal ids, since cdata cannot be the key of a table.
function Universe.key(id) return id.slot .. ":" .. id.generation end

return universe
