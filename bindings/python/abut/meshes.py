# SPDX-License-Identifier: Apache-2.0
"""Triangles from files and from objects of other libraries.

OBJ, PLY and STL are read here. Other formats are read by trimesh or meshio, where one of them is installed.
"""

from __future__ import annotations

import importlib.util
import os
import pathlib
import struct
from typing import Any

from . import ply

_BINARY_STL_HEADER = 84
_BINARY_STL_TRIANGLE = struct.Struct("<12fH")


def triangles_of(source: Any) -> tuple[Any, Any]:
    """Vertices and triangles of a file, or of an object that has `vertices` and `faces`."""
    if isinstance(source, (str, os.PathLike)):
        return _read(pathlib.Path(source))
    if hasattr(source, "vertices") and hasattr(source, "faces"):
        return source.vertices, source.faces
    raise TypeError(f"something of type {type(source).__name__} is no mesh: triangles are missing. Give vertices and "
                    "triangles, the name of a file, or an object that has vertices and faces")


def vertices_of(source: Any) -> Any:
    """Points: themselves, or the vertices of a file or of an object that has `vertices`."""
    if isinstance(source, (str, os.PathLike)):
        return _read(pathlib.Path(source))[0]
    return getattr(source, "vertices", source)


def _read(path):
    path.stat()  # a file that is missing is told by Python itself, whatever would read it
    suffix = path.suffix.lower()
    if suffix == ".obj":
        return _read_obj(path)
    if suffix == ".stl":
        return _read_stl(path)
    if suffix == ".ply":
        return ply.read(path)
    for name, read in (("trimesh", _read_by_trimesh), ("meshio", _read_by_meshio)):
        if importlib.util.find_spec(name):
            return read(path)
    raise ValueError(f"{path}: .obj, .ply and .stl are read by abut; {suffix or 'a file without a suffix'} needs "
                     "trimesh or meshio, and neither is installed: pip install trimesh")


def _read_by_trimesh(path):
    import trimesh  # type: ignore

    mesh = trimesh.load(path, force="mesh")
    return mesh.vertices, mesh.faces


def _read_by_meshio(path):
    import meshio  # type: ignore

    mesh = meshio.read(path)
    kinds = set(mesh.cells_dict) - {"vertex", "line"}
    if kinds != {"triangle"}:
        raise ValueError(f"{path} has cells of the kinds {', '.join(sorted(kinds))}; they must be triangles")
    return mesh.points, mesh.cells_dict["triangle"]


def _read_obj(path):
    """Vertices and faces of a Wavefront file; a face of more than three corners becomes a fan."""
    xyz, triangles = [], []
    with open(path, encoding="utf-8", errors="replace") as lines:
        for number, line in enumerate(lines, 1):
            words = line.split()
            try:
                if words[:1] == ["v"]:
                    x, y, z = words[1:4]
                    xyz.extend((float(x), float(y), float(z)))
                elif words[:1] == ["f"]:
                    corners = [_corner(word, len(xyz) // 3) for word in words[1:]]
                    for second, third in zip(corners[1:], corners[2:]):
                        triangles.extend((corners[0], second, third))
            except ValueError as failure:
                raise ValueError(f"{path}, line {number}: {line.strip()!r} cannot be read: {failure}") from None
    return xyz, triangles


def _corner(word, vertex_count):
    """Index of a vertex: files count from one, and backwards from the last one with negative numbers."""
    index = int(word.split("/")[0])
    found = index - 1 if index > 0 else vertex_count + index
    if index == 0 or found < 0:
        raise ValueError(f"there is no vertex {index}")
    return found


def _read_stl(path):
    """Triangles of an STL file, binary or text; corners at the same place become one vertex."""
    data = path.read_bytes()
    count = int.from_bytes(data[80:_BINARY_STL_HEADER], "little")
    if len(data) == _BINARY_STL_HEADER + count * _BINARY_STL_TRIANGLE.size:
        return _joined(numbers[i:i + 3] for numbers in _BINARY_STL_TRIANGLE.iter_unpack(data[_BINARY_STL_HEADER:])
                       for i in (3, 6, 9))
    if not data.lstrip().startswith(b"solid"):
        raise ValueError(f"{path} is no STL file: it has {len(data)} bytes and speaks of {count} triangles")
    return _joined(_text_corners(path, data.decode("utf-8", "replace")))


def _text_corners(path, text):
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if words[:1] == ["vertex"]:
            try:
                x, y, z = (float(word) for word in words[1:])
            except ValueError:
                raise ValueError(f"{path}, line {number}: {line.strip()!r} is no vertex") from None
            yield x, y, z


def _joined(corners):
    """Vertices, each once, and three indices per triangle."""
    places: dict = {}
    triangles = [places.setdefault(corner, len(places)) for corner in corners]
    return [number for place in places for number in place], triangles
