# SPDX-License-Identifier: Apache-2.0
"""Answers of C whose length is not known before."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_size_t, c_uint64
from typing import Any, Callable

from . import c
from .records import Groups, Records, empty, is_numpy_loaded, numpy, part_of


def filled(kind: Any, ask: Callable, room: int = 16) -> ctypes.Array:
    """The whole answer of a function that fills arrays of unknown length. It is asked again where room was missing."""
    count = c_size_t()
    while True:
        values = empty(kind, room)
        ask(values, room, byref(count))
        if count.value <= room:
            return part_of(values, 0, count.value)
        room = count.value


def records(kind: Any, ask: Callable) -> Records:
    return Records(filled(kind, ask))


def groups(kind: Any, query_count: int, ask: Callable, room: int) -> Groups:
    """Records of each query of a batch."""
    offsets = (c_uint64 * (query_count + 1))()
    found = filled(kind, lambda *rest: ask(offsets, *rest), room)
    return Groups(offsets, Records(found))


def joined(parts: list[Groups]) -> Groups:
    """Groups of batches that follow each other, as those of one batch."""
    if len(parts) == 1:
        return parts[0]
    offsets = (c_uint64 * (sum(map(len, parts)) + 1))()
    found = empty(parts[0].records.kind, sum(len(part.records) for part in parts))
    query = record = 0
    for part in parts:
        memory, size = part.records.memory, len(part.records)
        ctypes.memmove(part_of(found, record, size), memory, ctypes.sizeof(memory))
        if is_numpy_loaded():
            numpy().frombuffer(offsets, "u8")[query:query + len(part) + 1] = Records(part.offsets).array + record
        else:
            offsets[query:query + len(part) + 1] = [offset + record for offset in part.offsets]
        query, record = query + len(part), record + size
    return Groups(offsets, Records(found))


def text(ask: Callable) -> str:
    """The whole answer of a function that fills a text of unknown length."""
    needed = c_size_t()
    ask(None, 0, byref(needed))
    characters: Any = ctypes.create_string_buffer(needed.value)
    ask(characters, needed, byref(needed))
    return characters.value.decode()
