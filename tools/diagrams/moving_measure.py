#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what the pictures `springs` and `settling` show, and writes moving.json beside this file.

Needs the Python binding and libraries that are built: PYTHONPATH=bindings/python and ABUT_LIBRARY, ABUT_RESPONSE_LIBRARY.
"""

import json
import math
from pathlib import Path

import abut

UP = (0, 0, 1)
STIFFNESSES = tuple(10.0 ** i for i in range(2, 13))
STEPS = tuple(10.0 ** (-5 + j / 2) for j in range(9))


def world(reach, **options):
    universe = abut.Universe(tolerance_mode=abut.TOLERANCE_MARGIN)
    ground = universe.add_part(motion=abut.MOTION_STATIC)
    universe.add_geometry(ground, abut.Shape.plane(UP, 0), tolerance=reach)
    return universe, abut.Response(universe, **options)


def bounce(stiffness, step, integrator):
    """The speed that is left of an approach at 1 m/s, of a ball of 1 kg on a spring without damping."""
    universe, response = world(1e-9, gravity=(0, 0, 0), tolerance=1e-13)
    response.add_rule(None, None, "friction", f"k={stiffness!r}&mu=0")
    part = universe.add_part(pose=abut.pose(0, 0, 0.5))
    universe.add_geometry(part, abut.Shape.sphere(0.5), tolerance=1e-9)
    response.add_bodies([part], density=1 / (4 / 3 * math.pi * 0.125), integrator=integrator)
    universe.set_velocities([part], [abut.Velocity(abut.Vec3(0, 0, -1), abut.Vec3(0, 0, 0))])
    for _ in range(int(1.2 * 2 * math.pi / math.sqrt(stiffness) / step) + 40):
        response.step(step)
        speed = universe.velocities([part])[0].linear.z
        if speed > 0 and universe.pose(part).position.z >= 0.5:
            break
    return universe.velocities([part])[0].linear.z


def settling(step=0.01, seconds=6.0):
    """Boxes and balls that fall on each other: energy, the deepest overlap and the worst residual after each step."""
    universe, response = world(0.01)
    response.add_rule(None, None, "friction", "mu=0.4")
    for i in range(12):
        shape = abut.Shape.box(0.4, 0.4, 0.4) if i % 2 == 0 else abut.Shape.sphere(0.5)
        part = universe.add_part(pose=abut.pose(0.3 * (i % 3), 0.2 * (i % 2), 1.0 + 1.3 * i))
        universe.add_geometry(part, shape, tolerance=0.01)
        response.add_bodies([part])
    rows = []
    for i in range(round(seconds / step)):
        response.step(step)
        energy = response.energy()
        depth = max([0.0, *(-contact.distance for contact in response.contacts())])
        residual = max([0.0, *(max(its.residuals.contact, its.residuals.motion) for its in response.islands())])
        rows.append([step * (i + 1), energy.kinetic, energy.potential, depth, residual])
    return rows


def shortened(number):
    return float(f"{number:.3g}")


def main():
    springs = {}
    for name, integrator in (("implicit", abut.INTEGRATOR_IMPLICIT), ("midpoint", abut.INTEGRATOR_MIDPOINT)):
        springs[name] = [[round(bounce(stiffness, step, integrator), 3) for stiffness in STIFFNESSES] for step in STEPS]
    document = {"springs": springs, "settling": [[shortened(number) for number in row] for row in settling()]}
    lines = json.dumps(document).replace("], [", "],\n[").replace('"settling"', '\n"settling"').replace('"midpoint"', '\n"midpoint"')
    Path(__file__).with_name("moving.json").write_text(lines + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
