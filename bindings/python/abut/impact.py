# SPDX-License-Identifier: Apache-2.0
"""When two shapes that move and turn first touch."""

from __future__ import annotations

from ctypes import byref
from typing import Any

from . import c, given
from .c import library
from .options import impact_options_of
from .progress import Progress, chunks
from .records import Records, empty, part_of
from .shapes import Shape

__all__ = ["movement", "movement_between", "pair_time_of_impact", "pairs_time_of_impact"]

_NONE = (0.0, 0.0, 0.0)


def movement(velocity: Any = _NONE, angular_velocity: Any = _NONE, acceleration: Any = _NONE,
             angular_acceleration: Any = _NONE, centre: Any = _NONE) -> c.Movement:
    """How a body moves: in the world, by the unit of time; it turns around the centre, a point of the shape."""
    return c.Movement(given.vec3("velocity", velocity), given.vec3("angular_velocity", angular_velocity),
                      given.vec3("acceleration", acceleration),
                      given.vec3("angular_acceleration", angular_acceleration), given.vec3("centre", centre))


def movement_between(start: Any, end: Any, duration: float = 1.0, centre: Any = _NONE) -> c.Movement:
    """The movement from one pose to another: the centre goes straight, the turn takes the shorter way."""
    out = c.Movement()
    library.abut_movement_between(byref(given.pose("start", start)), byref(given.pose("end", end)),
                                  byref(given.vec3("centre", centre)), *given.reals(duration=duration), byref(out))
    return out


def pair_time_of_impact(a: Shape, pose_a: Any, movement_a: Any, b: Shape, pose_b: Any, movement_b: Any,
                        duration: float = 1.0, **fields: Any) -> c.Impact:
    """When two shapes that move and turn first touch; the fields are those of ImpactOptions.

    Movements are Movement or 15 numbers, in the order of movement().
    """
    out = c.Impact()
    library.abut_pair_time_of_impact(
        given.shape_pointer("a", a), byref(given.pose("pose_a", pose_a)),
        byref(given.one(c.Movement, "movement_a", movement_a)), given.shape_pointer("b", b),
        byref(given.pose("pose_b", pose_b)), byref(given.one(c.Movement, "movement_b", movement_b)),
        *given.reals(duration=duration), impact_options_of(fields), byref(out))
    return out


def pairs_time_of_impact(a: Shape, poses_a: Any, movements_a: Any, b: Shape, poses_b: Any, movements_b: Any,
                         duration: float = 1.0, progress: Progress = None, **fields: Any) -> Records:
    """The same for many poses and movements; a single one of any serves for all."""
    belonging = (given.structs(c.Pose, "poses_a", poses_a), given.structs(c.Movement, "movements_a", movements_a),
                 given.structs(c.Pose, "poses_b", poses_b), given.structs(c.Movement, "movements_b", movements_b))
    count = given.together(*belonging)
    pointers, settings = (given.shape_pointer("a", a), given.shape_pointer("b", b)), impact_options_of(fields)
    time, = given.reals(duration=duration)
    found = empty(c.Impact, count)
    for start, length in chunks(count, progress):
        places_a, ways_a, places_b, ways_b = (part_of(each.memory, start, length) for each in belonging)
        library.abut_pairs_time_of_impact(pointers[0], places_a, ways_a, pointers[1], places_b, ways_b, length, time,
                                          settings, part_of(found, start, length))
    return Records(found)
