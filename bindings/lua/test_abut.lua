-- SPDX-License-Identifier: Apache-2.0
-- Tests of the LuaJIT module. Each is a function of this table; the first that raises ends the run.
local abut = require "abut"
local ffi = require "ffi"
local tests = {}

local function equal(found, expected, what)
  if found ~= expected then
    error((what or "value") .. " is " .. tostring(found) .. "; expected " .. tostring(expected), 2)
  end
end

local function near(found, expected)
  if not (math.abs(found - expected) < 1e-9) then error(found .. " is not near " .. expected, 2) end
end

local function refused(status, words, call, ...)
  local is_fine, failure = pcall(call, ...)
  if is_fine then error("nothing was refused", 2) end
  equal(failure.status, status, "status")
  if not tostring(failure):find(words, 1, true) then error("'" .. tostring(failure) .. "' lacks '" .. words .. "'", 2) end
end

-- A universe with a row of balls of radius 1, each 1.5 from the next.
local function row(count)
  local universe, ball, parts, geometries = abut.universe(), abut.sphere(1), {}, {}
  for i = 1, count do
    parts[i] = universe:add_part{pose = abut.pose(1.5 * (i - 1))}
    geometries[i] = universe:add_geometry(parts[i], ball)
  end
  return universe, parts, geometries
end

local function contacts_of_a_step(universe)
  universe:step(0.01)
  return #universe:contacts()
end

function tests.structs_are_those_of_the_library()
  local entry, structs = ffi.new("abut_layout_entry"), 0
  for index = 0, tonumber(abut.library.abut_layout_count()) - 1 do
    abut.library.abut_layout_at(index, entry)
    local name, field = ffi.string(entry.type), ffi.string(entry.field)
    if field == "" then
      structs = structs + 1
      equal(ffi.sizeof(name), tonumber(entry.size), name)
    else
      equal(ffi.offsetof(name, field), tonumber(entry.offset), name .. "." .. field)
    end
  end
  assert(structs > 20)
end

function tests.every_kind_can_be_made()
  local square = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}
  local ball = abut.sphere(1)
  for kind, shape in pairs{
    box = abut.box(1, 2, 3), capsule = abut.capsule(0.5, 2), cylinder = abut.cylinder(0.5, 2),
    plane = abut.plane({0, 0, 2}, 0), hull = abut.hull(square), particles = abut.particles(square, 0.1),
    mesh = abut.mesh(square, {0, 1, 2, 0, 2, 3}, {sides = abut.library.ABUT_SIDES_FRONT}),
    composite = abut.composite({ball, ball}, {abut.pose(), abut.pose(3)}), cone = abut.shape("cone", 1, 2),
  } do
    equal(abut.kind(shape), kind)
  end
end

function tests.bad_input_is_named()
  refused("ABUT_OUT_OF_RANGE", "radius is -1", abut.sphere, -1)
  refused("ABUT_INVALID_ARGUMENT", "xyz has 4 numbers", abut.hull, {1, 2, 3, 4})
  refused("ABUT_INVALID_ARGUMENT", "triangles has 2 numbers", abut.mesh, {0, 0, 0}, {0, 1})
  refused("ABUT_INVALID_ARGUMENT", "normal is not a table", abut.plane, {0, 1}, 0)
  refused("ABUT_INVALID_ARGUMENT", "children has 0 shapes", abut.composite, {}, {abut.pose()})
  refused("ABUT_INVALID_ARGUMENT", "orientation has 3 numbers", abut.pose, 0, 0, 0, {1, 0, 0})
  refused("ABUT_UNKNOWN_VALUE", "kind", abut.shape, "blob")
  local universe, parts = row(1)
  refused("ABUT_INVALID_ARGUMENT", "motion is 'still'", universe.add_part, universe, {motion = "still"})
  refused("ABUT_INVALID_ARGUMENT", "colour cannot be 3", universe.add_part, universe, {colour = 3})
  refused("ABUT_INVALID_ARGUMENT", "parts has 1 ids and poses has 0", universe.set_poses, universe, parts, {})
  universe:remove_part(parts[1])
  refused("ABUT_STALE_ID", "part", universe.pose, universe, parts[1])
end

function tests.two_boxes()
  local cube, here = abut.box(1, 1, 1), abut.pose()
  equal(abut.distance(cube, here, cube, abut.pose(3.5)).distance, 1.5)
  equal(abut.overlaps(cube, here, cube, abut.pose(3.5)), false)
  equal(abut.overlaps(cube, here, cube, abut.pose(3.5), {margin = 2}), true)
  local contacts = abut.contacts(cube, here, cube, abut.pose(0, 0, 1.75))
  equal(#contacts, 4)
  for _, contact in ipairs(contacts) do equal(contact.distance, -0.25) end
  equal(#abut.contacts(cube, here, cube, abut.pose(0, 0, 1.75), {max_contacts = 1}), 1)
  near(abut.cast(cube, here, {0, 0, 0}, cube, abut.pose(4), {-4, 0, 0}).fraction, 0.5)
  equal(abut.cast(cube, here, {0, 0, 0}, cube, abut.pose(4), {4, 0, 0}), nil)
  equal(abut.cast_ray(cube, here, {0, 0, 5}, {0, 0, -1}).distance, 4)
  equal(abut.cast_ray(cube, here, {0, 0, 5}, {0, 0, -1}, 3), nil)
end

function tests.more_contacts_than_expected_are_all_there()
  local ball, children, poses = abut.sphere(0.5), {}, {}
  for i = 1, 20 do children[i], poses[i] = ball, abut.pose(i, 0, 0.25) end
  local contacts = abut.contacts(abut.composite(children, poses), abut.pose(), abut.plane({0, 0, 1}, 0), abut.pose())
  equal(#contacts, 20)
end

function tests.steps_find_contacts_and_events()
  local universe, parts, geometries = row(2)
  equal(contacts_of_a_step(universe), 1)
  local contact = universe:contacts()[1]
  universe:set_poses(parts, {abut.pose(), abut.pose(9)})
  equal(contacts_of_a_step(universe), 0)
  equal(universe:events()[1].kind, abut.library.ABUT_EVENT_END)
  equal(contact.distance, -0.5, "the distance of a contact of the step before")
  equal(universe.key(contact.geometry_a), universe.key(geometries[1]))
  equal(universe:pose(parts[2]).position.x, 9)
end

function tests.a_filter_is_asked_and_may_park()
  local universe, _, geometries = row(3)
  local asked = {}
  universe:set_filter(function(a, b)
    asked[#asked + 1] = a.slot .. "-" .. b.slot
    universe:park(geometries[1], "long_term")
    return b.slot ~= geometries[3].slot
  end)
  equal(contacts_of_a_step(universe), 1)
  equal(table.concat(asked, " "), "1-2 2-3")
  equal(contacts_of_a_step(universe), 0, "contacts after parking")
  universe:set_filter(nil)
  equal(contacts_of_a_step(universe), 1)
end

function tests.what_a_filter_raises_comes_out_of_the_step()
  local universe = row(2)
  universe:set_filter(function() error("no idea", 0) end)
  local is_fine, failure = pcall(universe.step, universe, 0.01)
  equal(is_fine, false)
  equal(failure, "no idea")
  equal(#universe:contacts(), 1)
end

-- By its name the first one: LuaJIT does not compile a function any more that a filter has once interrupted.
function tests.a_compiled_loop_may_ask_a_filter()
  local universe, parts = row(2)
  local asked = 0
  universe:set_filter(function() asked = asked + 1; return true end)
  universe:set_pose(parts[2], abut.pose(50))
  -- The loop would be compiled while nothing is near and no filter is asked.
  for i = 1, 600 do
    if i == 500 then universe:set_pose(parts[2], abut.pose(1.5)) end
    universe:refilter()
    universe:step(0.01)
  end
  equal(asked, 101)
end

function tests.universes_and_their_filters_are_collected()
  -- LuaJIT has room for less than a thousand callbacks.
  for _ = 1, 5000 do
    local universe = row(1)
    universe:set_filter(function() return true end)
    universe = nil
    if _ % 100 == 0 then collectgarbage() collectgarbage() end
  end
end

function tests.destroyed_universes_are_refused()
  for _ = 1, 2000 do
    local universe = row(1)
    universe:set_filter(function() return universe ~= nil end)
    universe:destroy()
    universe:destroy()
    refused("ABUT_NULL_ARGUMENT", "universe", universe.step, universe, 0.01)
  end
end

function tests.queries_find_geometries()
  local universe, parts, geometries = row(3)
  universe:refresh()
  local key, point, above = universe.key, abut.sphere(0.1), abut.pose(3, 0, 3)
  equal(key(universe:cast_ray({-5, 0, 0}, {1, 0, 0}).geometry), key(geometries[1]))
  equal(key(universe:cast_ray({-5, 0, 0}, {1, 0, 0}, 99, {ignore_part = parts[1]}).geometry), key(geometries[2]))
  equal(universe:cast_ray({-5, 0, 0}, {-1, 0, 0}), nil)
  near(universe:closest(point, above).distance.distance, 1.9)
  equal(universe:closest(point, above, 1), nil)
  near(universe:cast_shape(point, above, {0, 0, -3.8}).fraction, 0.5)
  equal(#universe:overlaps(point, abut.pose(0.7)), 2)
end

function tests.rules_and_why_two_are_apart()
  local universe, parts, geometries = row(2)
  equal(contacts_of_a_step(universe), 1)
  equal(#universe:why_apart(geometries[1], geometries[2]), 0)
  universe:set_rule({part = parts[1]}, "any", "disable")
  equal(contacts_of_a_step(universe), 0)
  equal(table.concat(universe:why_apart(geometries[1], geometries[2]), " "), "rule")
  universe:set_rule({part = parts[1]}, "any", "none")
  universe:set_rule({geometry = geometries[1]}, {label = 0}, "enable")
  equal(contacts_of_a_step(universe), 1)
  refused("ABUT_INVALID_ARGUMENT", "b is no side of a rule", universe.set_rule, universe, "any", {}, "disable")
  refused("ABUT_INVALID_ARGUMENT", "rule is 'maybe'", universe.set_rule, universe, "any", "any", "maybe")
end

function tests.whole_numbers_that_do_not_fit_are_named()
  local square = {-1, -1, 0, 1, -1, 0, 1, 1, 0}
  refused("ABUT_INVALID_ARGUMENT", "triangles[3] is 4294967296", abut.mesh, square, {0, 1, 2 ^ 32})
  refused("ABUT_INVALID_ARGUMENT", "triangles[1] is 0.5", abut.mesh, square, {0.5, 1, 2})
  refused("ABUT_INVALID_ARGUMENT", "threads is 1.5", abut.universe, {threads = 1.5})
  local universe, parts = row(1)
  refused("ABUT_INVALID_ARGUMENT", "label is 4294967296", universe.add_geometry, universe, parts[1], abut.sphere(1), {label = 2 ^ 32})
  equal(abut.kind(abut.mesh(square, {0, 1, 2}, {sides = 1})), "mesh")
  equal(abut.kind(abut.height_field(2, 2, 1, 1, {0, 0, 0, 0})), "height_field")
  refused("ABUT_INVALID_ARGUMENT", "heights has 3", abut.height_field, 2, 2, 1, 1, {0, 0, 0})
end

local names = {}
for name in pairs(tests) do names[#names + 1] = name end
table.sort(names)
for _, name in ipairs(names) do
  local is_fine, failure = xpcall(tests[name], function(failure) return debug.traceback(tostring(failure), 2) end)
  print((is_fine and "passed " or "FAILED ") .. name)
  if not is_fine then print(failure) os.exit(1) end
end
