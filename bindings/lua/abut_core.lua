-- SPDX-License-Identifier: Apache-2.0
-- What shapes and universes share: the library, failures, values and options.
local ffi = require "ffi"
local version = require "abut_cdef"

local core = {}
local name = os.getenv("ABUT_LIBRARY") or ("libabut.so.%d.%d"):format(version.major, version.minor)
local is_there, library = pcall(ffi.load, name)
if not is_there then error(name .. " cannot be loaded; install abut, or name the file of the library in ABUT_LIBRARY", 0) end
core.library = library

local Error = {}
Error.__index = Error
function Error:__tostring() return self.message end

-- Raises what a status stands for: a table with `status`, such as "ABUT_OUT_OF_RANGE", and `message`.
function core.check(status)
  if status ~= library.ABUT_OK then
    error(setmetatable({
      status = ffi.string(library.abut_status_name(status)),
      message = ffi.string(library.abut_last_error_message()),
    }, Error), 0)
  end
end

function core.refuse(...)
  error(setmetatable({status = "ABUT_INVALID_ARGUMENT", message = string.format(...)}, Error), 0)
end

core.check(library.abut_check_version(version.major, version.minor))

function core.vec3(values, name)
  if ffi.istype("abut_vec3", values) then return values end
  if type(values) ~= "table" or #values ~= 3 then core.refuse("%s is not a table of three numbers", name) end
  return ffi.new("abut_vec3", values[1], values[2], values[3])
end

-- At x, y, z, and turned by a unit quaternion {w, x, y, z}.
function core.pose(x, y, z, orientation)
  local turn = orientation or {1, 0, 0, 0}
  if #turn ~= 4 then core.refuse("orientation has %d numbers; expected w, x, y, z", #turn) end
  return ffi.new("abut_pose", {{x or 0, y or 0, z or 0}, {turn[1], turn[2], turn[3], turn[4]}})
end

function core.ray(origin, direction, max_distance)
  return ffi.new("abut_ray", {core.vec3(origin, "origin"), core.vec3(direction, "direction"), max_distance or math.huge})
end

-- Fields that may be words, such as motion = "static", and what the names of their values begin with.
local words = {
  algorithm = "ABUT_ALGORITHM_",
  broadphase = "ABUT_BROADPHASE_",
  motion = "ABUT_MOTION_",
  parking = "ABUT_PARKING_",
  ray_start = "ABUT_RAY_START_",
  rule = "ABUT_RULE_",
  tolerance_mode = "ABUT_TOLERANCE_",
}

local function constant(name) return library[name] end

-- The number of a word of a field; numbers are left as they are.
function core.value(field, word)
  if type(word) ~= "string" then return word end
  local is_known, number = pcall(constant, (words[field] or "") .. word:upper())
  if not is_known then core.refuse("%s is '%s', which abut.h does not know", field, word) end
  return number
end

-- Sets a field of a struct from a number or a word. LuaJIT would cut whole numbers that do not fit.
function core.set(struct, name, field, value)
  local number = core.value(field, value)
  local is_known, kept = pcall(function()
    struct[field] = number
    return struct[field]
  end)
  if not is_known then core.refuse("%s cannot be %s in %s", field, tostring(value), name) end
  if type(number) == "number" and number == number and tonumber(kept) ~= number then
    core.refuse("%s is %s; expected a whole number from 0 on that fits", field, tostring(value))
  end
end

-- A struct of options with the defaults of the library, and the fields of a table on top; null where there is no table.
function core.options(name, fields)
  if not fields then return nil end
  local struct = ffi.new(name)
  library[name .. "_init"](struct, ffi.sizeof(struct))
  for field, value in pairs(fields) do core.set(struct, name, field, value) end
  return struct
end

-- Copies of what a call fills, as a table: call(place, capacity, count) is asked again with room for all.
function core.fill(name, call)
  local count, capacity = ffi.new("size_t[1]"), 8
  repeat
    local place = ffi.new(name .. "[?]", capacity)
    core.check(call(place, capacity, count))
    local is_complete = count[0] <= capacity
    capacity = tonumber(count[0])
    if is_complete then return core.copies(name, place, capacity) end
  until false
end

-- A table of copies, each of which lives as long as somebody has it.
function core.copies(name, place, count)
  local type_, copies = ffi.typeof(name), {}
  for i = 0, tonumber(count) - 1 do copies[i + 1] = type_(place[i]) end
  return copies
end

-- An array for the library: of numbers or structs that a table holds. `what` names it in a failure.
function core.array(name, values, what)
  local array = ffi.new(name .. "[?]", math.max(#values, 1), values)
  if name == "uint32_t" then
    for i, value in ipairs(values) do
      if array[i - 1] ~= value then
        core.refuse("%s[%d] is %s; expected a whole number from 0 to 4294967295", what, i, tostring(value))
      end
    end
  end
  return array, #values
end

return core
