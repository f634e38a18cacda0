# SPDX-License-Identifier: Apache-2.0
"""Geometries of a universe: shapes on parts, and what is said about them."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, byref, c_double, c_size_t, c_uint32, c_void_p
from typing import Any

from .. import answers, c, given, options
from ..c import library
from ..lending import Borrowed, Lender
from ..records import Records
from ..shapes import Shape
from .parts import _fit, numbers_of_each


class Geometries(Lender):
    """Where several geometries are asked for, they are a list, Records or an array of GeometryId."""

    def add_geometry(self, part: c.PartId, shape: Shape, **fields: Any) -> c.GeometryId:
        """A shape on a part; the fields are those of GeometryOptions."""
        out = c.GeometryId()
        described = options.filled(c.GeometryOptions, library.abut_geometry_options_init, fields)
        pointer = given.shape_pointer("shape", shape)
        self._change(library.abut_geometry_create, part, pointer, byref(described), byref(out))
        return out

    def add_geometries(self, parts: Any, shapes: Any, **fields: Any) -> Records:
        """A shape on each part, or one shape on all; a field of GeometryOptions is the same for all, or one for each."""
        ids, pointers = given.structs(c.PartId, "parts", parts), given.shape_pointers("shapes", shapes)
        out = (c.GeometryId * given.together(ids, pointers))()
        described = options.of_each(c.GeometryOptions, library.abut_geometry_options_init, len(out), fields)
        self._change(library.abut_geometries_create, ids.memory, pointers.memory, described, len(out), out)
        return Records(out)

    def _change_geometries(self, function, geometries, *more):
        ids = given.structs(c.GeometryId, "geometries", geometries)
        _fit(ids, *more)
        self._change(function, ids.memory, *(each.memory for each in more), len(ids))

    def destroy_geometries(self, geometries: Any) -> None:
        """Takes geometries away, all or none."""
        self._change_geometries(library.abut_geometries_destroy, geometries)

    def geometries(self, part: c.PartId | None = None) -> Records:
        """Geometries of one part, or all."""
        if part is None:
            return answers.records(c.GeometryId, lambda *rest: self._read(library.abut_universe_geometries, *rest))
        return answers.records(c.GeometryId, lambda *rest: self._read(library.abut_part_geometries, part, *rest))

    def describe(self, geometry: c.GeometryId) -> c.GeometryInfo:
        """What a geometry is and where."""
        out = options.filled(c.GeometryInfo, library.abut_geometry_info_init, {})
        self._read(library.abut_geometry_describe, geometry, byref(out))
        return out

    def shape_of(self, geometry: c.GeometryId) -> Shape:
        """The shape that a geometry has at present."""
        out = c_void_p()
        self._read(library.abut_geometry_shape, geometry, byref(out))
        return Shape(out)

    def geometry_poses(self, geometries: Any) -> Records:
        """World poses of geometries; their array has the shape (N, 7)."""
        ids = given.structs(c.GeometryId, "geometries", geometries)
        out = (c.Pose * len(ids))()
        self._read(library.abut_geometries_poses, ids.memory, len(ids), out)
        return Records(out)

    def options_of(self, geometry: c.GeometryId) -> c.GeometryOptions:
        """The options of a geometry as they are, for set_options."""
        info = self.describe(geometry)
        names = [field[0] for field in c.GeometryOptions._fields_ if field[0] not in ("struct_size", "pose")]
        fields = {name: getattr(info, name) for name in names}
        return options.filled(c.GeometryOptions, library.abut_geometry_options_init, {"pose": info.local, **fields})

    def set_options(self, geometries: Any, described: Any) -> None:
        """Replaces the options of geometries, all of them."""
        self._change_geometries(library.abut_geometries_set_options, geometries,
                                given.structs(c.GeometryOptions, "options", described))

    def change(self, geometry: c.GeometryId, **fields: Any) -> None:
        """Changes some fields of the GeometryOptions of a geometry."""
        described = self.options_of(geometry)
        options.set_fields(described, fields)
        self.set_options([geometry], [described])

    def set_geometry_user_data(self, geometries: Any, values: Any) -> None:
        """Puts numbers of yours on geometries, one on each or one on all."""
        self._change_geometries(library.abut_geometries_set_user_data, geometries, numbers_of_each(values))

    def set_shapes(self, geometries: Any, shapes: Any) -> None:
        """Gives geometries other shapes, or all the same one."""
        self._change_geometries(library.abut_geometries_set_shapes, geometries, given.shape_pointers("shapes", shapes))

    def set_parameters(self, geometries: Any, parameters: Any) -> None:
        """Changes the parameters of the shapes of geometries: one row of them for each."""
        ids = given.structs(c.GeometryId, "geometries", geometries)
        if given.is_array(parameters):
            flat = given.borrowed(given.converted("parameters", parameters, c_double), c_double)
        else:
            flat = given.numbers("parameters", [number for row in parameters for number in row])
        if not len(ids) or len(flat) % len(ids):
            raise ValueError(f"parameters has {len(flat)} numbers; it must be as many for each of {len(ids)} geometries")
        self._change(library.abut_geometries_set_parameters, ids.memory, flat, len(flat) // len(ids), len(ids))

    def set_heights(self, geometry: c.GeometryId, column: int, row: int, heights: Any) -> None:
        """Changes heights of a height field: rows of them, from a first sample on. The array has two dimensions."""
        columns = len(heights[0]) if len(heights) else 0
        flat, rows = given.rows("heights", heights, columns or 1)
        self._change(library.abut_geometry_set_heights, geometry, column, row, columns, rows, flat)

    def set_field_values(self, geometry: c.GeometryId, column: int, row: int, layer: int, values: Any) -> None:
        """Changes values of a distance field: an array of (layers, rows, columns), from a first sample on."""
        rows = len(values[0]) if len(values) else 0
        columns = len(values[0][0]) if rows else 0
        if given.is_array(values):
            values = values.reshape(-1)
        else:
            values = [number for of_layer in values for of_row in of_layer for number in of_row]
        numbers = given.numbers("values", values)
        layers = len(numbers) // (rows * columns) if rows * columns else 0
        if len(numbers) != layers * rows * columns:
            raise ValueError(f"values has {len(numbers)} numbers; it must have as many in each of {rows} rows")
        self._change(library.abut_geometry_set_field_values, geometry, column, row, layer, columns, rows, layers, numbers)

    def set_field_lattice(self, geometry: c.GeometryId, columns: int, rows: int, layers: int, xyz: Any = ()) -> None:
        """Bends a distance field by (N, 3) points of a lattice over its grid, X fastest. None take the lattice away."""
        points, count = given.rows("xyz", xyz, 3)
        if count != columns * rows * layers:
            raise ValueError(f"xyz has {count} points; it must have {columns} * {rows} * {layers}")
        self._change(library.abut_geometry_set_field_lattice, geometry, columns, rows, layers, points)

    def set_particles(self, geometry: c.GeometryId, first: int, xyz: Any, radii: Any = None) -> None:
        """Moves particles of a geometry to (N, 3) centres, from the number `first` on."""
        centres, count = given.rows("xyz", xyz, 3)
        sizes = None if radii is None else given.numbers("radii", radii)
        if sizes is not None and len(sizes) != count:
            raise ValueError(f"xyz has {count} and radii has {len(sizes)}; they must have as many elements")
        self._change(library.abut_geometry_set_particles, geometry, c_size_t(first), centres, sizes, count)

    def set_vertices(self, geometry: c.GeometryId, vertices: Any, xyz: Any) -> None:
        """Moves vertices of a mesh to (N, 3) places: those from a number on, or those of a list of N numbers."""
        places, count = given.rows("xyz", xyz, 3)
        if isinstance(vertices, int):
            self._change(library.abut_geometry_set_vertices, geometry, c_size_t(vertices), places, count)
            return
        listed = given.numbers("vertices", vertices, c_uint32)
        if len(listed) != count:
            raise ValueError(f"xyz has {count} and vertices has {len(listed)}; they must have as many elements")
        self._change(library.abut_geometry_set_vertices_at, geometry, listed, places, count)

    def vertices(self, geometry: c.GeometryId) -> Records:
        """Vertices of a mesh as they are now, in the frame of its shape."""
        out = []

        def copy(pointer):
            xyz, count = POINTER(c_double)(), c_size_t()
            library.abut_geometry_vertices(pointer, geometry, byref(xyz), byref(count))
            memory = (c.Vec3 * count.value)()
            ctypes.memmove(memory, xyz, ctypes.sizeof(memory))
            out.append(Records(memory))

        self._read(copy)
        return out[0]

    def next_vertices(self, geometry: c.GeometryId) -> Borrowed:
        """Memory of the universe for where the vertices of a mesh move next: write into its `array`, then advance.

        Good until the universe changes. Then ask again: what was written is still there, until the geometry advances.
        """
        xyz, count = POINTER(c_double)(), c_size_t()
        self._change(library.abut_geometry_next_vertices, geometry, byref(xyz), byref(count))
        return Borrowed(self, c.Vec3, ctypes.cast(xyz, c_void_p).value or 0, count.value, self.change_count)

    def advance(self, geometries: Any) -> None:
        """The next vertices of one geometry, or of several, become the present ones: of all, or of none."""
        if isinstance(geometries, c.GeometryId):
            self._change(library.abut_geometry_advance, geometries)
        else:
            self._change_geometries(library.abut_geometries_advance, geometries)

    def remove_triangles(self, geometry: c.GeometryId, triangles: Any) -> None:
        """Takes triangles out of a mesh; the others keep their numbers."""
        going = given.numbers("triangles", triangles, c_uint32)
        self._change(library.abut_geometry_remove_triangles, geometry, going, len(going))

    def set_mesh(self, geometry: c.GeometryId, xyz: Any, triangles: Any) -> None:
        """Makes a mesh anew from vertices and triangles, each (N, 3). Contacts live on by the numbers of triangles."""
        points, corners = given.rows("xyz", xyz, 3), given.rows("triangles", triangles, 3, c_uint32)
        self._change(library.abut_geometry_set_mesh, geometry, *points, *corners)

    def park(self, geometries: Any, parking: int = c.PARKING_SHORT_TERM) -> None:
        """Parks geometries, or brings them back with PARKING_NONE. A filter may do that, too."""
        ids = given.structs(c.GeometryId, "geometries", geometries)
        self._change(library.abut_geometries_park, ids.memory, len(ids), parking)
