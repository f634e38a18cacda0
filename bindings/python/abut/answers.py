# SPDX-License-Identifier: Apache-2.0
"""Answers of C whose length is not known before."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_size_t, c_uint64
from typing import Any, Callable

from . import c
from .records import Groups, Records


def filled(kind: Any, ask: Callable) -> ctypes.Array:
    """The whole answer of a function that fills arrays of unknown length: it is asked for the count first."""
    count = c_size_t()
    ask(None, 0, byref(count))
    while True:
        values = (kind * count.value)()
        ask(values, len(values), byref(count))
        if count.value <= len(values):
            return values if count.value == len(values) else (kind * count.value).from_buffer(values)


def records(kind: Any, ask: Callable) -> Records:
    return Records(filled(kind, ask))


def groups(query_count: int, ask: Callable) -> Groups:
    """Geometries of each query of a batch."""
    offsets = (c_uint64 * (query_count + 1))()
    return Groups(offsets, records(c.GeometryId, lambda *rest: ask(offsets, *rest)))


def text(ask: Callable) -> str:
    """The whole answer of a function that fills a text of unknown length."""
    needed = c_size_t()
    ask(None, 0, byref(needed))
    characters: Any = ctypes.create_string_buffer(needed.value)
    ask(characters, needed, byref(needed))
    return characters.value.decode()
