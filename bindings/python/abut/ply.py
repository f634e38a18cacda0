# SPDX-License-Identifier: Apache-2.0
"""Vertices and triangles of PLY files, text or binary: Turk 1994, "The PLY Polygon File Format"."""

from __future__ import annotations

import itertools
import struct
from typing import Any, Iterator, NamedTuple

_CODES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
          "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d",
          "float64": "d"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_END = b"end_header"


class _Property(NamedTuple):
    name: str
    code: str  # of struct
    count_code: str  # of the length of a list; empty for a single number


class _Element(NamedTuple):
    name: str
    count: int
    properties: "list[_Property]"


def read(path: Any) -> tuple[list, list]:
    """Coordinates and triangles, flat; a face of more than three corners becomes a fan."""
    data = path.read_bytes()
    order, elements, start = _header(path, data)
    source = _Binary(path, data, start, order) if order else _Text(path, data[start:])
    xyz, triangles = [], []
    for element in elements:
        rows = source.rows(element)
        if element.name == "vertex":
            columns = [_column(path, element, (axis,)) for axis in "xyz"]
            xyz = [row[column] for row in rows for column in columns]
        elif element.name == "face":
            column = _column(path, element, ("vertex_indices", "vertex_index"))
            for row in rows:
                corners = row[column]
                for second, third in zip(corners[1:], corners[2:]):
                    triangles.extend((corners[0], second, third))
        else:
            for _ in rows:  # what comes after it begins where it ends
                pass
    return xyz, triangles


def _header(path, data):
    """The order of bytes, empty for text, the elements in their order, and where their rows begin."""
    end = data.find(b"\n", data.find(_END)) + 1
    if not data.startswith(b"ply") or _END not in data or not end:
        raise ValueError(f"{path} is no PLY file: it has no header from ply to end_header")
    order, elements = None, []
    for number, line in enumerate(data[:end].decode("ascii", "replace").splitlines(), 1):
        words = line.split()
        try:
            if words[:1] == ["format"]:
                order = _ORDERS[words[1]]
            elif words[:1] == ["element"]:
                elements.append(_Element(words[1], int(words[2]), []))
            elif words[:2] == ["property", "list"]:
                elements[-1].properties.append(_Property(words[4], _CODES[words[3]], _CODES[words[2]]))
            elif words[:1] == ["property"]:
                elements[-1].properties.append(_Property(words[2], _CODES[words[1]], ""))
        except (IndexError, KeyError, ValueError):
            raise ValueError(f"{path}, line {number}: {line.strip()!r} cannot be read") from None
    if order is None:
        raise ValueError(f"{path} is no PLY file: its header names no format")
    return order, elements, end


def _column(path, element, wanted):
    names = [each.name for each in element.properties]
    for name in wanted:
        if name in names:
            return names.index(name)
    raise ValueError(f"{path}: the element {element.name} has no property {wanted[0]}; it has {', '.join(names)}")


class _Text:
    def __init__(self, path, data):
        self._path, self._lines = path, iter(data.split(b"\n"))

    def rows(self, element: _Element) -> Iterator[Any]:
        for number in range(element.count):
            line = next(self._lines, b"")
            words = iter(line.split())
            try:
                yield [self._list(each, words) if each.count_code else self._number(each, next(words))
                       for each in element.properties]
            except (StopIteration, ValueError):
                shown = line.decode("ascii", "replace").strip()
                raise ValueError(f"{self._path}: {element.name} {number} cannot be read from {shown!r}") from None

    @staticmethod
    def _number(described, word):
        return float(word) if described.code in "fd" else int(word)

    def _list(self, described, words):
        count = int(next(words))
        found = [self._number(described, word) for word in itertools.islice(words, count)]
        if len(found) != count:
            raise ValueError
        return found


class _Binary:
    def __init__(self, path, data, start, order):
        self._path, self._data, self._at, self._order = path, data, start, order

    def rows(self, element: _Element) -> Iterator[Any]:
        if any(each.count_code for each in element.properties):
            return self._rows_with_lists(element)
        row = struct.Struct(self._order + "".join(each.code for each in element.properties))
        found = memoryview(self._data)[self._at:self._at + row.size * element.count]
        if len(found) != row.size * element.count:
            self._raise_end(element, len(found) // row.size)
        self._at += len(found)
        return row.iter_unpack(found) if row.size else iter(())

    def _rows_with_lists(self, element):
        for number in range(element.count):
            try:
                yield [self._unpack(each.code, self._unpack(each.count_code, 1)[0]) if each.count_code
                       else self._unpack(each.code, 1)[0] for each in element.properties]
            except struct.error:
                self._raise_end(element, number)

    def _unpack(self, code, count):
        described = f"{self._order}{count}{code}"
        found = struct.unpack_from(described, self._data, self._at)
        self._at += struct.calcsize(described)
        return found

    def _raise_end(self, element, number):
        raise ValueError(f"{self._path} ends within {element.name} {number} of {element.count}") from None
