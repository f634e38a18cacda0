# SPDX-License-Identifier: Apache-2.0
"""Poses and rays, one by one and many at once."""

from __future__ import annotations

from ctypes import c_double
from typing import Any

from . import c, given
from .records import Records, is_numpy_loaded, numpy

__all__ = ["matrices", "pose", "poses", "ray", "rays"]

INFINITY = float("inf")


def pose(x: float = 0.0, y: float = 0.0, z: float = 0.0, orientation: Any = (1.0, 0.0, 0.0, 0.0)) -> c.Pose:
    """A pose from a position and an orientation.

    That is a unit quaternion, scalar first, a 3 x 3 rotation matrix, or a rotation of SciPy.
    """
    return c.Pose(c.Vec3(x, y, z), given.one(c.Quat, "orientation", orientation))


def poses(positions: Any, orientations: Any = (1.0, 0.0, 0.0, 0.0)) -> Records:
    """Poses from (N, 3) positions and N orientations; one of either serves for all.

    Orientations are (N, 4) unit quaternions, scalar first, (N, 3, 3) rotation matrices, or a rotation of SciPy.
    """
    places, turns = given.structs(c.Vec3, "positions", positions), given.structs(c.Quat, "orientations", orientations)
    return _joined(c.Pose, given.together(places, turns), position=places, orientation=turns)


def matrices(poses: Any) -> Any:
    """Poses as an array of (N, 4, 4) homogeneous matrices, or of (4, 4) for one pose."""
    np, read = numpy(), given.structs(c.Pose, "poses", poses)
    numbers = Records(read.memory).array
    w, i, j, k = numbers[:, 3:].T / np.linalg.norm(numbers[:, 3:], axis=1)
    out = np.zeros((len(read), 4, 4))
    out[:, 0, :3] = np.stack([1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j)], axis=1)
    out[:, 1, :3] = np.stack([2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i)], axis=1)
    out[:, 2, :3] = np.stack([2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j)], axis=1)
    out[:, :3, 3], out[:, 3, 3] = numbers[:, :3], 1
    return out[0] if read.is_one else out


def ray(origin: Any, direction: Any, max_distance: float = INFINITY) -> c.Ray:
    """A ray from two triples of numbers."""
    return c.Ray(given.vec3("origin", origin), given.vec3("direction", direction), max_distance)


def rays(origins: Any, directions: Any, max_distances: Any = INFINITY) -> Records:
    """Rays from (N, 3) origins and (N, 3) directions; one of either, or of the distances, serves for all."""
    starts, ways = given.structs(c.Vec3, "origins", origins), given.structs(c.Vec3, "directions", directions)
    is_one = not hasattr(max_distances, "__len__")
    limits = given.Given("max_distances", given.numbers("max_distances", [max_distances] if is_one else max_distances),
                         is_one)
    return _joined(c.Ray, given.together(starts, ways, limits), origin=starts, direction=ways, max_distance=limits)


def _joined(kind, count, **columns):
    """Records from one column for each of their fields."""
    out = Records((kind * count)())
    if is_numpy_loaded():
        for name, column in columns.items():
            getattr(out, name)[...] = Records(column.memory).array
        return out
    for name, column in columns.items():
        for each, value in zip(out, column.memory):
            setattr(each, name, value)
    return out


def given_rays(name: str, values: Any) -> given.Given:
    """Rays of a caller: a Ray, several of them, or (N, 6) numbers, origin and direction, of rays without an end."""
    if given.is_array(values) and not isinstance(values, Records):
        array = given.converted(name, values, c_double)
        if array.ndim == 2 and array.shape[1] == 6:
            return given.Given(name, rays(array[:, :3], array[:, 3:]).memory)
        if array.ndim == 2 and array.shape[1] == 7:
            return given.Given(name, given.borrowed(array, c.Ray))
        raise ValueError(f"{name} has shape {array.shape}; it must be (N, 6), origin and direction of each, or (N, 7) "
                         "with the greatest distance")
    return given.structs(c.Ray, name, values)

