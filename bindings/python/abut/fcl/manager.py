# SPDX-License-Identifier: Apache-2.0
"""Many objects: callbacks for those whose boxes overlap, or may be nearer than what was found.

Boxes are rows of arrays: one box is compared with many others at once.
"""

from __future__ import annotations

import math
from typing import Any, Iterator

import numpy

from .objects import CollisionObject

__all__ = ["DynamicAABBTreeCollisionManager"]


class DynamicAABBTreeCollisionManager:
    """Objects with their boxes, as these were when an object was registered or updated.

    Pairs of half-spaces and planes are passed over.
    """

    def __init__(self) -> None:
        self._objects: list[CollisionObject] = []
        self._boxes: Any = None

    def registerObjects(self, other_objs: Any) -> None:
        self._objects.extend(other_objs)
        self._boxes = None

    def registerObject(self, obj: CollisionObject) -> None:
        self.registerObjects([obj])

    def unregisterObject(self, obj: Any) -> None:
        """Takes an object out; one that is not there is ignored, as python-fcl does."""
        row = self._row(obj)
        if row is not None:
            del self._objects[row]
            self._boxes = None

    def _row(self, wanted):
        return next((row for row, obj in enumerate(self._objects) if obj is wanted), None)

    def setup(self) -> None:
        """The same as update()."""
        self.update()

    def update(self, arg: Any = None) -> None:
        """Takes the boxes of all objects anew, or of one, or of a list."""
        if arg is None or self._boxes is None:
            self._boxes = None  # the next query makes them
            return
        for obj in arg if hasattr(arg, "__len__") else [arg]:
            row = self._row(obj)
            if row is not None:
                self._boxes[:, row] = obj.box

    @property
    def boxes(self) -> Any:
        """The lower corners of all objects, and the upper ones: (2, N, 3)."""
        if self._boxes is None:
            self._boxes = numpy.array([obj.box for obj in self._objects]).reshape(-1, 2, 3).swapaxes(0, 1).copy()
        return self._boxes

    def clear(self) -> None:
        self._objects.clear()
        self.update()

    def getObjects(self) -> "list[CollisionObject]":
        return list(self._objects)

    def empty(self) -> bool:
        return not self._objects

    def size(self) -> int:
        return len(self._objects)

    def collide(self, *args: Any) -> None:
        """collide(data, callback), collide(object, data, callback) or collide(manager, data, callback).

        callback(o1, o2, data) is called for objects whose boxes overlap, until it returns True. o1 is in this manager.
        """
        asked, data, callback = _arguments(args)
        for o1, o2 in self._near_each_other() if asked is None else self._near(asked):
            if _is_bounded(o1, o2) and callback(o1, o2, data):
                return

    def _near(self, asked) -> Iterator[Any]:
        """Each object of this manager with each of those asked about that overlaps its box."""
        for o2, (low, high), (lows, highs) in self._asked(asked):
            for row in numpy.flatnonzero(((lows <= high) & (highs >= low)).all(axis=1)):
                yield self._objects[row], o2

    def _near_each_other(self) -> Iterator[Any]:
        """Sweeps along X: of boxes in the order of their lower ends, those before the upper end of one are candidates."""
        order = numpy.argsort(self.boxes[0, :, 0], kind="stable")
        lows, highs = self.boxes[:, order]
        for first, end in enumerate(numpy.searchsorted(lows[:, 0], highs[:, 0], side="right")):
            later = slice(first + 1, end)
            is_near = (lows[later] <= highs[first]) & (highs[later] >= lows[first])
            for row in order[later][is_near.all(axis=1)]:
                yield self._objects[min(row, order[first])], self._objects[max(row, order[first])]

    def distance(self, *args: Any) -> None:
        """distance(data, callback), distance(object, data, callback) or distance(manager, data, callback).

        callback(o1, o2, data) returns whether to end, and the distance from which on no pair is of interest. Of the pairs
        of an object those whose boxes are nearer come first.
        """
        asked, data, callback = _arguments(args)
        limit = math.inf
        for o2, (low, high), (lows, highs) in self._asked(asked):
            gaps = numpy.linalg.norm(numpy.maximum(numpy.maximum(lows - high, low - highs), 0), axis=1)
            rows = numpy.flatnonzero(gaps < limit)
            for row in rows[numpy.argsort(gaps[rows], kind="stable")]:
                if gaps[row] >= limit:
                    break
                if _is_bounded(self._objects[row], o2):
                    is_done, limit = callback(self._objects[row], o2, data)
                    if is_done:
                        return

    def _asked(self, asked) -> Iterator[Any]:
        """Each object that is asked about, its box, and the boxes to compare it with."""
        if asked is None:
            for row, obj in enumerate(self._objects):
                yield obj, self.boxes[:, row], self.boxes[:, :row]
        elif isinstance(asked, DynamicAABBTreeCollisionManager):
            for row, obj in enumerate(asked._objects):
                yield obj, asked.boxes[:, row], self.boxes
        else:
            yield asked, asked.box, self.boxes


def _arguments(args):
    asked, data, callback = (None, *args) if len(args) == 2 else args if len(args) == 3 else (None, None, None)
    if not callable(callback):
        raise ValueError("the arguments must be (data, callback), (object, data, callback) or (manager, data, "
                         "callback)")
    return asked, data, callback


def _is_bounded(o1, o2):
    return not (o1.geometry.is_unbounded and o2.geometry.is_unbounded)
