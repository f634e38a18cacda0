# SPDX-License-Identifier: Apache-2.0
"""Distance and contacts of two shapes, and one step of a universe."""

import abut

ball = abut.Shape.sphere(1.0)
box = abut.Shape.box(1.0, 1.0, 1.0)
origin, above = abut.pose(), abut.pose(0.0, 0.0, 1.75)

distance = abut.pair_distance(box, origin, ball, above)
print(f"distance {distance.distance:g}, normal ({distance.normal.x:g}, {distance.normal.y:g}, {distance.normal.z:g})")
print(f"two boxes touch in {len(abut.pair_contacts(box, origin, box, above))} points")

with abut.Universe() as universe:
    universe.add_geometry(universe.add_part(pose=origin), box)
    universe.add_geometry(universe.add_part(pose=above), ball)
    universe.step(0.01)
    for contact in universe.contacts():
        print(f"contact {-contact.distance:g} deep")
