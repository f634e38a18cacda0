# SPDX-License-Identifier: Apache-2.0
"""Parts of a universe: where they are, how they move, whether they sleep."""

from __future__ import annotations

from ctypes import byref, c_uint32, c_uint64
from typing import Any

from .. import answers, c, given, options
from ..c import library
from ..lending import Lender
from ..records import Records


class Parts(Lender):
    """Where several parts are asked for, they are a list, Records or an array of PartId."""

    def add_part(self, **fields: Any) -> c.PartId:
        """A new part; the fields are those of PartOptions."""
        out = c.PartId()
        described = options.filled(c.PartOptions, library.abut_part_options_init, fields)
        self._change(library.abut_part_create, byref(described), byref(out))
        return out

    def add_parts(self, poses: Any, **fields: Any) -> Records:
        """New parts at (N, 7) poses; a field of PartOptions is the same for all, or one for each."""
        places = given.structs(c.Pose, "poses", poses)
        out = (c.PartId * len(places))()
        described = options.of_each(c.PartOptions, library.abut_part_options_init, len(out),
                                    {"pose": Records(places.memory), **fields})
        self._change(library.abut_parts_create, described, len(out), out)
        return Records(out)

    def _change_parts(self, function, parts, *more):
        """An exclusive call on parts, with further arguments that belong to each of them."""
        ids = given.structs(c.PartId, "parts", parts)
        _fit(ids, *more)
        self._change(function, ids.memory, *(each.memory for each in more), len(ids))

    def destroy_parts(self, parts: Any) -> None:
        """Destroys parts and their geometries, all or none."""
        self._change_parts(library.abut_parts_destroy, parts)

    def set_pose(self, part: c.PartId, at: Any) -> None:
        """Places one part."""
        self._change(library.abut_part_set_pose, part, byref(given.pose("at", at)))

    def pose(self, part: c.PartId) -> c.Pose:
        """The pose of one part."""
        out = c.Pose()
        self._read(library.abut_part_pose, part, byref(out))
        return out

    def set_poses(self, parts: Any, poses: Any) -> None:
        """Places parts at (N, 7) poses, or all at one pose."""
        self._change_parts(library.abut_parts_set_poses, parts, given.structs(c.Pose, "poses", poses))

    def poses(self, parts: Any) -> Records:
        """Poses of parts; their array has the shape (N, 7)."""
        return self._of_each_part(c.Pose, library.abut_parts_poses, parts)

    def _of_each_part(self, kind, ask, parts):
        ids = given.structs(c.PartId, "parts", parts)
        out = (kind * len(ids))()
        self._read(ask, ids.memory, len(ids), out)
        return Records(out)

    def set_motions(self, parts: Any, motions: Any) -> None:
        """How parts move: MOTION_DYNAMIC, MOTION_ANIMATED or MOTION_STATIC, for all or one for each."""
        is_one = not hasattr(motions, "__len__")
        numbers = given.numbers("motions", [motions] if is_one else motions, c_uint32)
        self._change_parts(library.abut_parts_set_motions, parts, given.Given("motions", numbers, is_one))

    def motion(self, part: c.PartId) -> int:
        """How a part moves."""
        out = c_uint32()
        self._read(library.abut_part_motion, part, byref(out))
        return out.value

    def user_data(self, part: c.PartId) -> int:
        """Your number on a part."""
        out = c_uint64()
        self._read(library.abut_part_user_data, part, byref(out))
        return out.value

    def set_user_data(self, parts: Any, values: Any) -> None:
        """Puts numbers of yours on parts, one on each or one on all."""
        self._change_parts(library.abut_parts_set_user_data, parts, numbers_of_each(values))

    def parts(self) -> Records:
        """All parts, ordered by slot."""
        return answers.records(c.PartId, lambda *rest: self._read(library.abut_universe_parts, *rest))

    def set_sleep(self, parts: Any, **fields: Any) -> None:
        """Lets parts fall asleep; the fields are those of Sleep."""
        sleep = options.filled(c.Sleep, library.abut_sleep_init, fields)
        self._change_parts(library.abut_parts_set_sleep, parts, given.structs(c.Sleep, "sleep", sleep))

    def keep_awake(self, parts: Any) -> None:
        """Parts that never fall asleep by themselves, which is how they are made."""
        ids = given.structs(c.PartId, "parts", parts)
        self._change(library.abut_parts_set_sleep, ids.memory, None, len(ids))

    def is_asleep(self, part: c.PartId) -> bool:
        """Whether a part slept at the end of the last step."""
        out = c_uint32()
        self._read(library.abut_part_is_asleep, part, byref(out))
        return out.value == 1

    def wake(self, parts: Any) -> None:
        """Wakes parts at the next step."""
        self._change_parts(library.abut_parts_wake, parts)

    def set_velocities(self, parts: Any, velocities: Any) -> None:
        """Gives parts (N, 6) velocities, linear and then angular, or one to all; None takes them away."""
        if velocities is None:
            ids = given.structs(c.PartId, "parts", parts)
            self._change(library.abut_parts_set_velocities, ids.memory, None, len(ids))
            return
        self._change_parts(library.abut_parts_set_velocities, parts, given.structs(c.Velocity, "velocities", velocities))

    def measure_velocities(self, parts: Any) -> None:
        """From now on velocities of parts follow from their poses."""
        self._change_parts(library.abut_parts_measure_velocities, parts)

    def velocities(self, parts: Any) -> Records:
        """Velocities of parts; their array has the shape (N, 6)."""
        return self._of_each_part(c.Velocity, library.abut_parts_velocities, parts)

    def set_accelerations(self, parts: Any, accelerations: Any) -> None:
        """Gives parts (N, 6) accelerations, linear and then angular, or one to all; None takes them away."""
        if accelerations is None:
            ids = given.structs(c.PartId, "parts", parts)
            self._change(library.abut_parts_set_accelerations, ids.memory, None, len(ids))
            return
        self._change_parts(library.abut_parts_set_accelerations, parts,
                           given.structs(c.Acceleration, "accelerations", accelerations))

    def accelerations(self, parts: Any) -> Records:
        """Accelerations of parts; their array has the shape (N, 6)."""
        return self._of_each_part(c.Acceleration, library.abut_parts_accelerations, parts)

    def velocity_source(self, part: c.PartId) -> int:
        """Where the velocity of a part comes from: VELOCITY_NONE, VELOCITY_GIVEN or VELOCITY_FROM_POSES."""
        velocity, source = c.Velocity(), c_uint32()
        self._read(library.abut_part_velocity, part, byref(velocity), byref(source))
        return source.value


def numbers_of_each(values):
    """User data: a number for all, or one for each."""
    is_one = not hasattr(values, "__len__")
    return given.Given("values", given.numbers("values", [values] if is_one else values, c_uint64), is_one)


def _fit(ids, *more):
    """Arguments that belong to each id: one serves for all, but ids are never repeated."""
    ids.is_one = ids.is_one and len(ids) != 1
    given.together(ids, *more)
