# SPDX-License-Identifier: Apache-2.0
"""When features first touch whose vertices move on straight lines: the triangles of meshes that deform."""

from __future__ import annotations

from ctypes import POINTER, c_double, cast
from typing import Any

from . import c, given
from .c import library
from .progress import Progress, chunks
from .records import Records, empty, part_of

__all__ = ["edges_touch_edges", "vertices_touch_faces"]

_NUMBERS = 12


def _vertices(name, values):
    if given.is_array(values) and getattr(values, "ndim", 0) == 3 and values.shape[1:] == (4, 3):
        values = values.reshape(len(values), _NUMBERS)
    if isinstance(values, (list, tuple)) and values and hasattr(values[0], "__len__") and len(values[0]) == 4:
        values = [[number for vertex in row for number in vertex] for row in values]
    return given.rows(name, values, _NUMBERS)


def _first_touches(ask, start, end, separation, tolerance, progress):
    first, count = _vertices("start", start)
    last, count_of_end = _vertices("end", end)
    if count_of_end != count:
        raise ValueError(f"start has {count} and end has {count_of_end}; they must have as many elements")
    found = empty(c.FirstTouch, count)
    for begin, length in chunks(count, progress):
        at = [cast(part_of(each, _NUMBERS * begin, _NUMBERS * length), POINTER(c_double)) for each in (first, last)]
        ask(*at, length, separation, tolerance, part_of(found, begin, length))
    return Records(found)


def vertices_touch_faces(start: Any, end: Any, separation: float = 0.0, tolerance: float = 1e-9,
                         progress: Progress = None) -> Records:
    """When vertices first touch faces: `touches`, and `lower` and `upper` of the time, from 0 to 1.

    `start` and `end` are (N, 4, 3) or (N, 12) numbers: a vertex and the three corners of a face, at time 0 and at
    time 1. With separation 0 the answer is exact; else what comes as near touches, within the tolerance.
    """
    return _first_touches(library.abut_vertices_touch_faces, start, end, separation, tolerance, progress)


def edges_touch_edges(start: Any, end: Any, separation: float = 0.0, tolerance: float = 1e-9,
                      progress: Progress = None) -> Records:
    """The same for pairs of edges: the two ends of one, then those of the other."""
    return _first_touches(library.abut_edges_touch_edges, start, end, separation, tolerance, progress)
