# SPDX-License-Identifier: Apache-2.0
"""How distances change with the poses of both shapes. Needs NumPy."""

from __future__ import annotations

from typing import Any

from . import c, given
from .records import Records, numpy

__all__ = ["distance_gradient"]


def distance_gradient(found: Any, poses_a: Any, poses_b: Any) -> tuple[Any, Any]:
    """The gradient of distances with respect to both poses: two arrays of (N, 6) numbers.

    `found` are the answers of pairs_distance, contacts, or a single one of either. A row holds the derivative by the
    position of the pose, then by a turn about that position around the axes of the world: the normal and its moment,
    with a minus for a. The product of a row with a velocity, linear and then angular, is the rate at which the distance
    grows. One pose serves for all answers. For a single answer both arrays have six numbers.
    """
    np = numpy()
    is_one = not isinstance(found, Records)
    if is_one and not hasattr(found, "point_a"):
        raise TypeError(f"found is of type {type(found).__name__}; it must be a Distance, a Contact or Records of them")
    answers = Records((type(found) * 1)(found)) if is_one else found
    counted = given.Given("found", answers.memory)
    places = given.structs(c.Pose, "poses_a", poses_a), given.structs(c.Pose, "poses_b", poses_b)
    given.together(counted, *places)
    normals, out = answers.normal, []
    for sign, points, poses in ((-1.0, answers.point_a, places[0]), (1.0, answers.point_b, places[1])):
        arms = points - Records(poses.memory).array[:, :3]
        rows = sign * np.concatenate([normals, np.cross(arms, normals)], axis=1)
        out.append(rows[0] if is_one else rows)
    return out[0], out[1]
