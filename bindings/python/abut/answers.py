# SPDX-License-Identifier: Apache-2.0
"""Answers of C whose length is not known before."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_size_t, c_uint64
from typing import Any, Callable

from . import c
from .records import Groups, Records, part_of


def filled(kind: Any, ask: Callable, room: int = 16) -> ctypes.Array:
    """The whole answer of a function that fills arrays of unknown length. It is asked again where room was missing."""
    count = c_size_t()
    while True:
        values = (kind * room)()
        ask(values, room, byref(count))
        if count.value <= room:
            return part_of(values, 0, count.value)
        room = count.value


def records(kind: Any, ask: Callable) -> Records:
    return Records(filled(kind, ask))


def groups(query_count: int, ask: Callable) -> Groups:
    """Geometries of each query of a batch."""
    offsets = (c_uint64 * (query_count + 1))()
    found = filled(c.GeometryId, lambda *rest: ask(offsets, *rest), 2 * query_count + 16)
    return Groups(offsets, Records(found))


def text(ask: Callable) -> str:
    """The whole answer of a function that fills a text of unknown length."""
    needed = c_size_t()
    ask(None, 0, byref(needed))
    characters: Any = ctypes.create_string_buffer(needed.value)
    ask(characters, needed, byref(needed))
    return characters.value.decode()
