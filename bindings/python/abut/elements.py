# SPDX-License-Identifier: Apache-2.0
"""Elements of meshes that deform: what is near, first touches or crosses, as vertices with weights."""

from __future__ import annotations

from ctypes import POINTER, byref, c_double, c_size_t, c_uint32, c_void_p, cast
from typing import Any

from . import c, given
from .c import library
from .options import elements_options_of
from .owner import Owner
from .records import Records, empty, part_of
from .shapes import Shape

__all__ = ["Elements"]


class Elements(Owner):
    """The vertices, edges and faces of a mesh whose vertices move. One thread at a time may use it.

    Searches are of the mesh with itself, or with another one in the same frame. Their fields are those of
    ElementsOptions. Answers are Records: `found.weights` is an array of all of them.
    """

    def __init__(self, shape: Shape) -> None:
        out = c_void_p()
        library.abut_elements_create(given.shape_pointer("shape", shape), byref(out))
        super().__init__(out)
        self._room = 1024

    def _release(self, pointer):
        library.abut_elements_destroy(pointer)

    def __repr__(self) -> str:
        if not self._pointer:
            return "<Elements, closed>"
        found = self.count()
        return f"<Elements of {found.vertices} vertices, {found.edges} edges and {found.faces} faces>"

    def count(self) -> c.ElementCounts:
        """How many vertices, edges, triangles and faces there are."""
        out = c.ElementCounts()
        library.abut_elements_count(self.pointer, byref(out))
        return out

    def edges(self) -> list[tuple[int, int]]:
        """The ends of all edges, the lower number first."""
        number = self.count().edges
        ends, count = (c_uint32 * (2 * number))(), c_size_t()
        library.abut_elements_edges(self.pointer, ends, number, byref(count))
        return list(zip(ends[::2], ends[1::2]))

    def set_vertices(self, start: Any, end: Any = None) -> None:
        """Where the vertices are, as (N, 3) numbers: at the start and, where they move, at the end of a step."""
        first, count = given.rows("start", start, 3)
        last, count_of_end = (None, count) if end is None else given.rows("end", end, 3)
        if count_of_end != count:
            raise ValueError(f"start has {count} and end has {count_of_end}; they must have as many elements")
        library.abut_elements_set_vertices(self.pointer, cast(first, POINTER(c_double)),
                                           None if last is None else cast(last, POINTER(c_double)), count)

    def candidates(self, other: Elements | None = None, **fields: Any) -> Records:
        """Pairs of a vertex and a face, and of two edges, whose boxes are within `reach` from start to end."""
        return self._search(library.abut_elements_candidates, c.ElementPair, other, fields)

    def closest(self, other: Elements | None = None, **fields: Any) -> Records:
        """Stencils of closest features within `reach`, where the vertices are at the start."""
        return self._search(library.abut_elements_closest, c.Stencil, other, fields)

    def first_touches(self, other: Elements | None = None, **fields: Any) -> Records:
        """Stencils of what first touches, or comes as near as `reach`, on the way from start to end."""
        return self._search(library.abut_elements_first_touches, c.Stencil, other, fields)

    def crossings(self, other: Elements | None = None, **fields: Any) -> Records:
        """Edges that pass faces where the vertices are at the start, exactly."""
        return self._search(library.abut_elements_crossings, c.Crossing, other, fields)

    def _search(self, ask, kind, other, fields):
        options, count = elements_options_of(fields), c_size_t()
        pointers = self.pointer, None if other is None else other.pointer
        # Each call searches, so a list begins with room for as many as before.
        found = empty(kind, self._room)
        ask(*pointers, options, part_of(found, 0, self._room), self._room, byref(count))
        if count.value > self._room:
            self._room = count.value + count.value // 4
            found = empty(kind, self._room)
            ask(*pointers, options, part_of(found, 0, self._room), self._room, byref(count))
        return Records((kind * count.value).from_buffer_copy(found) if count.value else empty(kind, 0))
