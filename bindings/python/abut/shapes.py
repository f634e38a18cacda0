# SPDX-License-Identifier: Apache-2.0
"""Shapes: made once, immutable, shared by any number of universes."""

from __future__ import annotations

import functools
from ctypes import byref, c_double, c_size_t, c_uint32, c_void_p
from typing import Any, Callable, TypeVar

from . import answers, c, given, meshes, options
from .c import library
from .owner import Owner
from .values import pose

__all__ = ["Shape", "pair_support", "shape_kinds", "shape_parameters"]

Made = TypeVar("Made", bound=Callable[..., Any])

_SIDES = {"both": c.SIDES_BOTH, "front": c.SIDES_FRONT, "solid": c.SIDES_SOLID}


def _faces(struct, init, xyz, triangles, fields):
    """Options, vertices and faces as the library takes them."""
    if triangles is None:
        xyz, triangles = meshes.triangles_of(xyz)
    fields = dict(fields)
    if isinstance(fields.get("sides"), str):
        fields["sides"] = _sides_named(fields["sides"])
    if "merge_distance" in fields:
        fields.setdefault("merges_vertices", 1)
    if "corners" not in fields and _row_width(triangles) == 4:
        fields["corners"] = 4
    read_as = options.filled(struct, init, fields)
    width = 4 if read_as.corners == 4 else 3
    return read_as, *given.rows("xyz", xyz, 3), *given.rows("triangles", triangles, width, c_uint32)


def _row_width(rows):
    shape = getattr(rows, "shape", None)
    if shape is not None:
        return shape[1] if len(shape) == 2 else None
    try:
        return len(rows[0])
    except (TypeError, IndexError, KeyError):
        return None


def _sides_named(name: str) -> int:
    if name not in _SIDES:
        raise ValueError(f"sides is {name!r}; it must be one of {', '.join(_SIDES)}")
    return _SIDES[name]


def _instead_of(**arguments: str) -> Callable[[Made], Made]:
    """Refuses arguments that other libraries take, and names the one to give."""
    def wrap(function):
        @functools.wraps(function)
        def checked(*args, **given_by_name):
            for name in arguments.keys() & given_by_name.keys():
                raise TypeError(f"{function.__name__} has no argument {name}; give {arguments[name]}")
            return function(*args, **given_by_name)
        return checked
    return wrap


_HALF_HEIGHT = "half_height, which is half of it"
_along_z = _instead_of(height=_HALF_HEIGHT, length=_HALF_HEIGHT, lz=_HALF_HEIGHT, h=_HALF_HEIGHT,
                       half_length="half_height", diameter="radius, which is half of it")
_HALF_EXTENTS = "half_x, half_y and half_z, which are half of it"
_with_sides = _instead_of(size=_HALF_EXTENTS, extents=_HALF_EXTENTS, side=_HALF_EXTENTS, sides=_HALF_EXTENTS,
                          width=_HALF_EXTENTS, height=_HALF_EXTENTS, depth=_HALF_EXTENTS,
                          half_extents="half_x, half_y and half_z one by one")
_as_ball = _instead_of(diameter="radius, which is half of it")


class Shape(Owner):
    """A shape: immutable, shared, independent of any universe. docs/shapes.md tells the kinds and their frames."""

    def _release(self, pointer):
        library.abut_shape_release(pointer)

    @classmethod
    def _made_by(cls, function, *arguments):
        out = c_void_p()
        function(*arguments, byref(out))
        return cls(out)

    @classmethod
    @_as_ball
    def sphere(cls, radius: float) -> Shape:
        """A solid ball."""
        return cls._made_by(library.abut_sphere_create, *given.reals(radius=radius))

    @classmethod
    @_with_sides
    def box(cls, half_x: float, half_y: float, half_z: float) -> Shape:
        """A solid box, centred, from its half extents."""
        return cls._made_by(library.abut_box_create, *given.reals(half_x=half_x, half_y=half_y, half_z=half_z))

    @classmethod
    @_along_z
    def capsule(cls, radius: float, half_height: float) -> Shape:
        """All points within the radius of a segment along Z from -half_height to half_height."""
        return cls._made_by(library.abut_capsule_create, *given.reals(radius=radius, half_height=half_height))

    @classmethod
    @_along_z
    def cylinder(cls, radius: float, half_height: float) -> Shape:
        """A solid cylinder along Z, centred."""
        return cls._made_by(library.abut_cylinder_create, *given.reals(radius=radius, half_height=half_height))

    @classmethod
    @_along_z
    def cone(cls, radius: float, half_height: float) -> Shape:
        """A solid cone along Z: its base at -half_height, its apex at half_height."""
        return cls.of_kind("cone", given.reals(radius=radius, half_height=half_height))

    @classmethod
    def ellipsoid(cls, radius_x: float, radius_y: float, radius_z: float) -> Shape:
        """A solid ellipsoid, centred, from its radii along the axes."""
        return cls.of_kind("ellipsoid", given.reals(radius_x=radius_x, radius_y=radius_y, radius_z=radius_z))

    @classmethod
    def point(cls) -> Shape:
        """The origin of its frame."""
        return cls.of_kind("point")

    @classmethod
    @_instead_of(length="half_length, which is half of it", height="half_length, which is half of it")
    def segment(cls, half_length: float) -> Shape:
        """A segment along Z from -half_length to half_length."""
        return cls.of_kind("segment", given.reals(half_length=half_length))

    @classmethod
    def triangle(cls, a: Any, b: Any, c: Any) -> Shape:
        """A triangle of three points; both sides are solid."""
        corners = (given.vec3("a", a), given.vec3("b", b), given.vec3("c", c))
        return cls.of_kind("triangle", [number for corner in corners for number in corner])

    @classmethod
    def plane(cls, normal: Any, offset: float) -> Shape:
        """The half-space of the points p with dot(normal, p) <= offset."""
        return cls._made_by(library.abut_plane_create, byref(given.vec3("normal", normal)), *given.reals(offset=offset))

    @classmethod
    def hull(cls, xyz: Any) -> Shape:
        """Convex hull of points, (N, 3) or flat, of those in a file, or of an object that has vertices."""
        return cls._made_by(library.abut_hull_create, *given.rows("xyz", meshes.vertices_of(xyz), 3))

    @classmethod
    def mesh(cls, xyz: Any, triangles: Any = None, **fields: Any) -> Shape:
        """A triangle mesh from vertices and triangles, each (N, 3) or flat.

        Without triangles `xyz` is the name of an OBJ, PLY or STL file. Or it is an object that has `vertices` and `faces`,
        such as a mesh of trimesh. The fields are those of MeshOptions; sides may be "both", "front" or "solid". Rows
        of four are quads. Where merge_distance is given, vertices within it are merged.
        """
        read_as, *faces = _faces(c.MeshOptions, library.abut_mesh_options_init, xyz, triangles, fields)
        return cls._made_by(library.abut_mesh_create, *faces, byref(read_as))

    @staticmethod
    def describe_mesh(xyz: Any, triangles: Any = None, **fields: Any) -> c.MeshReport:
        """What is unusual about a mesh, given as to `mesh`, before it is made: open edges, slivers and the like."""
        read_as, *faces = _faces(c.MeshOptions, library.abut_mesh_options_init, xyz, triangles, fields)
        out = options.filled(c.MeshReport, library.abut_mesh_report_init, {})
        library.abut_mesh_describe(*faces, byref(read_as), byref(out))
        return out

    @classmethod
    def uv_grid(cls, xyz: Any, triangles: Any = None, **fields: Any) -> Shape:
        """A mesh whose tree is made by a grid of cells across two axes; given as to `mesh`.

        The fields are those of UvGridOptions.
        """
        read_as, *faces = _faces(c.UvGridOptions, library.abut_uv_grid_options_init, xyz, triangles, fields)
        return cls._made_by(library.abut_uv_grid_create, *faces, byref(read_as))

    @classmethod
    def height_field(cls, columns: int | None = None, rows: int | None = None, heights: Any = (),
                     spacing_x: float = 1.0, spacing_y: float = 1.0, diagonal: int = c.DIAGONAL_RISING,
                     solid_below: bool = False) -> Shape:
        """Terrain over a grid: `rows` times `columns` heights, X fastest. An array of two dimensions tells both.

        A height that is NaN makes a hole.
        """
        shape: Any = getattr(heights, "shape", ())
        if len(shape) == 2:
            if (rows or shape[0], columns or shape[1]) != tuple(shape):
                raise ValueError(f"heights has shape {tuple(shape)}; it must be (rows, columns), ({rows}, {columns})")
            (rows, columns), heights = shape, heights.reshape(-1)
        if columns is None or rows is None:
            raise ValueError("columns and rows are missing; only heights of two dimensions tell them")
        values = given.numbers("heights", heights)
        if len(values) != columns * rows:
            raise ValueError(f"heights has {len(values)} numbers; it must have {columns} * {rows}")
        desc = options.filled(c.HeightFieldDesc, library.abut_height_field_desc_init, {
            "columns": columns, "rows": rows, "spacing_x": spacing_x, "spacing_y": spacing_y,
            "diagonal": diagonal, "below": c.BELOW_SOLID if solid_below else c.BELOW_OPEN})
        desc.heights = values
        return cls._made_by(library.abut_height_field_create, byref(desc))

    @classmethod
    def distance_field(cls, values: Any, spacing: Any = 1.0, origin: Any = (0.0, 0.0, 0.0),
                       is_inside_out: bool = False, interpolation: int = c.INTERPOLATION_LINEAR) -> Shape:
        """A solid from its signed distance, an array of (layers, rows, columns). One spacing, or one for each axis."""
        counts: Any = getattr(values, "shape", None)
        if counts is None:
            counts = (len(values), len(values[0]) if len(values) else 0,
                      len(values[0][0]) if len(values) and len(values[0]) else 0)
            values = [value for layer in values for row in layer for value in row]
        elif len(counts) == 3:
            values = values.reshape(-1)
        if len(counts) != 3:
            raise ValueError(f"values has shape {tuple(counts)}; it must be (layers, rows, columns)")
        numbers = given.numbers("values", values)
        if len(numbers) != counts[0] * counts[1] * counts[2]:
            raise ValueError(f"values has {len(numbers)} numbers; it must have {' * '.join(map(str, counts))}")
        sides = spacing if hasattr(spacing, "__len__") else (spacing, spacing, spacing)
        desc = options.filled(c.DistanceFieldDesc, library.abut_distance_field_desc_init, {
            "columns": counts[2], "rows": counts[1], "layers": counts[0], "is_inside_out": int(is_inside_out),
            "interpolation": interpolation})
        desc.spacing, desc.origin = given.vec3("spacing", sides), given.vec3("origin", origin)
        desc.values = numbers
        return cls._made_by(library.abut_distance_field_create, byref(desc))

    @classmethod
    def distance_field_from_mesh(cls, xyz: Any, triangles: Any = None, **fields: Any) -> Shape:
        """The solid within a mesh, which is given as `mesh` takes it. The fields are those of DistanceFieldOptions."""
        if triangles is None:
            xyz, triangles = meshes.triangles_of(xyz)
        points, corners = given.rows("xyz", xyz, 3), given.rows("triangles", triangles, 3, c_uint32)
        read_as = options.filled(c.DistanceFieldOptions, library.abut_distance_field_options_init, fields)
        return cls._made_by(library.abut_distance_field_from_mesh, *points, *corners, byref(read_as))

    @classmethod
    def particles(cls, xyz: Any, radius: Any) -> Shape:
        """Many balls about (N, 3) centres, of one radius, or of N radii."""
        centres, count = given.rows("xyz", xyz, 3)
        if not hasattr(radius, "__len__"):
            return cls._made_by(library.abut_particles_create, centres, count, *given.reals(radius=radius))
        radii = given.numbers("radius", radius)
        if len(radii) != count:
            raise ValueError(f"xyz has {count} and radius has {len(radii)}; they must have as many elements")
        balls = (c_double * (4 * count))()
        for column in range(3):
            balls[column::4] = centres[column::3]
        balls[3::4] = radii[:]
        return cls.of_kind("particles", (0,), balls)

    @classmethod
    @_as_ball
    def sphere_hole(cls, radius: float) -> Shape:
        """A cavity of the shape of a ball, centred. Holes are children of composites, whose solids they cut."""
        return cls.of_kind("sphere_hole", given.reals(radius=radius))

    @classmethod
    @_along_z
    def cylinder_hole(cls, radius: float, half_height: float, open_ends: int = 0) -> Shape:
        """A cavity along Z; OPEN_TOP and OPEN_BOTTOM are ends without a wall."""
        return cls.of_kind("cylinder_hole", given.reals(radius=radius, half_height=half_height, open_ends=open_ends))

    @classmethod
    @_with_sides
    def box_hole(cls, half_x: float, half_y: float, half_z: float, open_faces: int = 0) -> Shape:
        """A cavity of the shape of a box; OPEN_X_HIGH and the like are faces without a wall, all of one axis."""
        return cls.of_kind("box_hole", given.reals(half_x=half_x, half_y=half_y, half_z=half_z, open_faces=open_faces))

    @classmethod
    def composite(cls, children: Any, poses: Any, materials: Any = None) -> Shape:
        """Shapes, each at a pose of its own, as one. Materials are one for each; 0 is that of the geometry."""
        shapes, places = given.shape_pointers("children", children), given.structs(c.Pose, "poses", poses)
        if materials is None:
            count = given.together(shapes, places)
            return cls._made_by(library.abut_composite_create, shapes.memory, places.memory, count)
        stuff = given.Given("materials", given.numbers("materials", materials, c_uint32))
        count = given.together(shapes, places, stuff)
        return cls._made_by(library.abut_composite_create_with_materials, shapes.memory, places.memory, stuff.memory,
                            count)

    @classmethod
    def of_kind(cls, name: str, parameters: Any = (), reals: Any = (), indices: Any = ()) -> Shape:
        """A shape of any kind from its parameters and buffers."""
        numbers, points = given.numbers("parameters", parameters), given.numbers("reals", reals)
        corners = given.numbers("indices", indices, c_uint32)
        desc = options.filled(c.ShapeDesc, library.abut_shape_desc_init, {})
        desc.kind = kind_number("name", name)
        desc.parameters, desc.parameter_count = numbers, len(numbers)
        desc.reals, desc.real_count = points, len(points)
        desc.indices, desc.index_count = corners, len(corners)
        return cls._made_by(library.abut_shape_create, byref(desc))

    @property
    def kind(self) -> str:
        """The name of its kind, such as "box"."""
        return library.abut_shape_kind_name(library.abut_shape_kind_of(self.pointer)).decode()

    @property
    def parameters(self) -> dict[str, float]:
        """Parameters by name."""
        values = answers.filled(c_double, lambda *rest: library.abut_shape_parameters(self.pointer, *rest))
        return dict(zip(_parameters_of(library.abut_shape_kind_of(self.pointer), len(values)), values))

    def distance_field_report(self) -> c.DistanceFieldReport:
        """How far values of a distance field may be off, and how much of it holds samples."""
        out = options.filled(c.DistanceFieldReport, library.abut_distance_field_report_init, {})
        library.abut_distance_field_describe(self.pointer, byref(out))
        return out

    def hull_report(self) -> c.HullReport:
        """What a hull has left of its points, and the error of that."""
        out = options.filled(c.HullReport, library.abut_hull_report_init, {})
        library.abut_hull_describe(self.pointer, byref(out))
        return out

    def aabb(self, at: Any = pose()) -> c.Aabb:
        """The box around it at a pose."""
        out = c.Aabb()
        library.abut_shape_aabb(self.pointer, byref(given.pose("at", at)), byref(out))
        return out

    def triangles(self) -> tuple[Any, Any]:
        """Vertices and indices of the surface, flat. numpy.reshape(vertices, (-1, 3)) makes rows of them."""
        vertices, triangles = self._surface_counts()
        xyz, indices = (c_double * (3 * vertices.value))(), (c_uint32 * (3 * triangles.value))()
        library.abut_shape_triangles(self.pointer, xyz, vertices, byref(vertices), indices, triangles, byref(triangles))
        return xyz, indices

    def children(self) -> list[tuple[Shape, c.CompositeChild]]:
        """The children of a composite, by their numbers: the shape of each, and where and what it is."""
        found = answers.filled(c.CompositeChild, lambda *rest: library.abut_composite_children(self.pointer, *rest))
        return [(self._made_by(library.abut_composite_child_shape, self.pointer, number), child)
                for number, child in enumerate(found)]

    def prepare(self, threads: int = 0) -> None:
        """Makes what queries would make when they first need it, such as the tree of a mesh; 0 threads: as many as may be."""
        library.abut_shape_prepare(self.pointer, threads)

    def cast_ray(self, at: Any, along: c.Ray) -> c.RayHit | None:
        """The first hit of a ray on the shape at a pose, or None."""
        hit, found = c.RayHit(), c_uint32()
        place, line = given.pose("at", at), given.one(c.Ray, "along", along)
        library.abut_shape_cast_ray(self.pointer, byref(place), byref(line), byref(hit), byref(found))
        return hit if found.value else None

    def __copy__(self) -> Shape:
        pointer = self.pointer
        library.abut_shape_retain(pointer)
        return type(self)(c_void_p(pointer.value))

    def __deepcopy__(self, memo: Any) -> Shape:
        # Nothing changes a shape, so both may be one.
        return self.__copy__()

    def __reduce_ex__(self, protocol: Any) -> Any:
        return _unpickled, (type(self), _bytes_of(self))

    def __repr__(self) -> str:
        if not self._pointer:
            return "<Shape, closed>"
        numbers = {**self.parameters, **self._counts()}
        return f"<Shape {' '.join([self.kind, *(f'{name}={value:g}' for name, value in numbers.items())])}>"

    def _counts(self):
        """How large it is, where its parameters do not tell."""
        if self.kind == "hull":
            report = self.hull_report()
            return {"vertices": report.vertex_count, "faces": report.face_count}
        if self.kind not in ("mesh", "uv_grid"):
            return {}
        vertices, triangles = self._surface_counts()
        return {"vertices": vertices.value, "triangles": triangles.value}

    def _surface_counts(self):
        vertices, triangles = c_size_t(), c_size_t()
        library.abut_shape_triangles(self.pointer, None, 0, byref(vertices), None, 0, byref(triangles))
        return vertices, triangles


# Only universes have bytes, so a shape travels as the one geometry of a universe.
def _bytes_of(shape):
    # Here, because universes import shapes.
    from .universe import Universe
    with Universe() as carrier:
        carrier.add_geometry(carrier.add_part(), shape)
        return carrier.save()


def _unpickled(cls, data):
    from .universe import Universe
    with Universe.load(data) as carrier:
        geometries = carrier.geometries()
        if len(geometries) != 1:
            raise ValueError(f"the bytes are a universe of {len(geometries)} geometries; they must be those of a Shape")
        found = carrier.shape_of(geometries[0])
    pointer, found._pointer = found._pointer, None
    return cls(pointer)


def kind_number(argument, name):
    """The number of a kind by its name."""
    kind = library.abut_shape_kind_by_name(given.text(argument, name))
    if not kind:
        raise ValueError(f"{argument} is {name!r}; the kinds of shape are {', '.join(shape_kinds())}")
    return kind


def shape_kinds() -> list[str]:
    """Names of the kinds of shape that the library contains."""
    return [library.abut_shape_kind_name(library.abut_shape_kind_at(i)).decode()
            for i in range(library.abut_shape_kind_count())]


def _parameters_of(kind, count):
    return [library.abut_shape_kind_parameter_name(kind, i).decode() for i in range(count)]


def shape_parameters(kind: str) -> list[str]:
    """Names of the parameters of a kind of shape, in the order in which Shape.of_kind takes them."""
    number = kind_number("kind", kind)
    return _parameters_of(number, library.abut_shape_kind_parameter_count(number))


def pair_support(kind_a: str, kind_b: str, query: int = c.QUERY_CONTACTS) -> bool:
    """Whether two kinds of shape answer QUERY_DISTANCE or QUERY_CONTACTS."""
    out = c_uint32()
    library.abut_pair_support(kind_number("kind_a", kind_a), kind_number("kind_b", kind_b), query, byref(out))
    return out.value == 1
