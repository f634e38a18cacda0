-- SPDX-License-Identifier: Apache-2.0
-- Distance and contacts of two shapes, and one step of a universe.
local abut = require "abut"

local ball, cube = abut.sphere(1), abut.box(1, 1, 1)
local origin, above = abut.pose(), abut.pose(0, 0, 1.75)

local found = abut.distance(cube, origin, ball, above)
local n = found.normal
print(string.format("distance %g, normal (%g, %g, %g)", found.distance, n.x, n.y, n.z))
print(string.format("two boxes touch in %d points", #abut.contacts(cube, origin, cube, above)))

local universe = abut.universe()
universe:add_geometry(universe:add_part{pose = origin}, cube)
universe:add_geometry(universe:add_part{pose = above}, ball)
universe:step(0.01)
for _, contact in ipairs(universe:contacts()) do
  print(string.format("contact %g deep", -contact.distance))
end
