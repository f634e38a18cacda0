# SPDX-License-Identifier: Apache-2.0
"""A thousand balls sink onto terrain: poses go in and contacts come out as NumPy arrays, without a loop over bodies."""

import numpy

import abut

COUNT, STEPS, DROP, RADIUS = 1000, 200, 0.05, 0.5

grid = numpy.arange(64)
heights = numpy.sin(grid / 5)[:, None] * numpy.cos(grid / 7)
random = numpy.random.default_rng(1)
positions = random.uniform((5, 5, 3), (58, 58, 12), (COUNT, 3))

with abut.Universe() as universe:
    ground = universe.add_part(motion=abut.MOTION_STATIC)
    universe.add_geometry(ground, abut.Shape.height_field(heights=heights))
    balls = universe.add_parts(abut.poses(positions))
    geometries = universe.add_geometries(balls, abut.Shape.sphere(RADIUS))
    # The row of a geometry in the arrays, by its slot; the ground has none.
    row = numpy.full(geometries.slot.max() + 1, -1)
    row[geometries.slot] = numpy.arange(COUNT)

    for _ in range(STEPS):
        positions[:, 2] -= DROP
        universe.set_poses(balls, abut.poses(positions))
        universe.step()
        contacts = universe.contacts()
        push = contacts.distance[:, None] * contacts.normal
        for side, sign in ((contacts.geometry_a, 1), (contacts.geometry_b, -1)):
            rows = row[side["slot"]]
            numpy.add.at(positions, rows[rows >= 0], sign * push[rows >= 0])

    print(f"{len(universe.contacts())} contacts after {STEPS} steps, the lowest ball at {positions[:, 2].min():.1f}")
