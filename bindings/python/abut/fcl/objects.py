# SPDX-License-Identifier: Apache-2.0
"""Transforms, and objects: a geometry at a transform."""

from __future__ import annotations

from typing import Any

import numpy

from ..rotations import quaternions
from ..values import matrices, pose
from .shapes import CollisionGeometry

__all__ = ["CollisionObject", "Transform"]


def _rotation(name, values):
    """A 3 x 3 matrix, from itself or from a quaternion, scalar first."""
    array = numpy.array(values, "f8")
    if array.shape == (3, 3):
        quaternions(name, array)  # refuses what is no rotation
        return array
    if array.shape != (4,):
        hint = "; a homogeneous matrix m is Transform(m[:3, :3], m[:3, 3])" if array.shape == (4, 4) else ""
        raise ValueError(f"{name} has shape {array.shape}; it must be (3, 3), or (4,) for a quaternion{hint}")
    return matrices(pose(orientation=array))[:3, :3]


def _translation(name, values):
    array = numpy.array(values, "f8").squeeze()
    if array.shape != (3,):
        raise ValueError(f"{name} has shape {array.shape}; it must be (3,)")
    return array


class Transform:
    """Transform(), (transform), (R), (q), (T), (R, T) or (q, T): R a matrix, q w, x, y, z, T a translation."""

    def __init__(self, *args: Any) -> None:
        self._rotation, self._translation = numpy.eye(3), numpy.zeros(3)
        if len(args) > 2:
            raise ValueError(f"Transform takes at most 2 arguments, not {len(args)}")
        if len(args) == 1 and isinstance(args[0], Transform):
            self._rotation, self._translation = args[0]._rotation, args[0]._translation
        elif len(args) == 1 and numpy.shape(args[0]) == (3,):
            self.setTranslation(args[0])
        elif args:
            self._rotation = _rotation("rotation", args[0])
            if len(args) == 2:
                self.setTranslation(args[1])

    def getRotation(self) -> Any:
        return self._rotation.copy()

    def getTranslation(self) -> Any:
        return self._translation.copy()

    def getQuatRotation(self) -> Any:
        return numpy.array(quaternions("rotation", self._rotation))

    def setRotation(self, R: Any) -> None:
        self._rotation = _rotation("R", R)

    def setTranslation(self, T: Any) -> None:
        self._translation = _translation("T", T)

    def setQuatRotation(self, q: Any) -> None:
        self._rotation = _rotation("q", q)

    @property
    def pose(self) -> Any:
        """The same as a pose of abut."""
        return pose(*self._translation, self._rotation)

    def __repr__(self) -> str:
        return f"<Transform at {tuple(self._translation.tolist())}, turned {tuple(self.getQuatRotation().tolist())}>"


class CollisionObject:
    """A geometry at a transform. It takes a copy of the transform, and shares the geometry."""

    def __init__(self, geom: Any = None, tf: Any = None) -> None:
        if not isinstance(geom, CollisionGeometry):
            raise ValueError(f"geom is of type {type(geom).__name__}; it must be a CollisionGeometry")
        self.geometry = geom
        self.setTransform(Transform() if tf is None else tf)

    def getObjectType(self) -> int:
        return self.geometry._object_type

    def getNodeType(self) -> Any:
        return self.geometry.getNodeType()

    def getTransform(self) -> Transform:
        return Transform(self._transform)

    def setTransform(self, tf: Transform) -> None:
        self._transform = Transform(tf)
        self._pose = self._box = None

    def getTranslation(self) -> Any:
        return self._transform.getTranslation()

    def setTranslation(self, vec: Any) -> None:
        self._transform.setTranslation(vec)
        self._pose = self._box = None

    def getRotation(self) -> Any:
        return self._transform.getRotation()

    def setRotation(self, mat: Any) -> None:
        self._transform.setRotation(mat)
        self._pose = self._box = None

    def getQuatRotation(self) -> Any:
        return self._transform.getQuatRotation()

    def setQuatRotation(self, q: Any) -> None:
        self._transform.setQuatRotation(q)
        self._pose = self._box = None

    def isOccupied(self) -> bool:
        return True

    def isFree(self) -> bool:
        return False

    def isUncertain(self) -> bool:
        return False

    @property
    def pose(self) -> Any:
        """Where it is, as a pose of abut."""
        if self._pose is None:
            self._pose = self._transform.pose
        return self._pose

    @property
    def box(self) -> Any:
        """The lower and the upper corner of its box; a plane lies within those of both of its half-spaces."""
        shapes = self.geometry.shapes
        if self._box is None or self._boxed is not shapes:
            found = [shape.aabb(self.pose) for shape in shapes]
            self._box = tuple(max(corners) for corners in zip(*(box.minimum for box in found))), tuple(
                min(corners) for corners in zip(*(box.maximum for box in found)))
            self._boxed = shapes
        return self._box

    def __repr__(self) -> str:
        return f"<CollisionObject {type(self.geometry).__name__}, {self._transform!r}>"
