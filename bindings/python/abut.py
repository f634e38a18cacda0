"""abut, 3D collision detection, in Python: shapes, distances and contacts of pairs, universes, picking.

    with Shape.sphere(1.0) as ball, Shape.box(1.0, 1.0, 1.0) as box:
        print(distance(ball, pose(), box, pose(3.0, 0.0, 0.0)).distance)

Objects are released by `with`, by close(), or when they are collected. Failures raise Error, which carries the status
and the message. Arrays are any sequences of numbers; buffers of doubles (array.array, NumPy) are not copied on the way
in. Results are ctypes structs and arrays, which NumPy can view.
"""

import ctypes
from ctypes import byref, c_size_t, c_uint32, c_uint64, c_void_p

import abut_c as c
from abut_c import *  # noqa: F401,F403 - the constants and structs are part of this module
from abut_c import Error, library, picking

_INNER = ("FUNCTIONS", "PICKING_FUNCTIONS", "POINTER")
__all__ = [name for name in dir(c) if name[0].isupper() and name not in _INNER] + [
    "Picker", "Shape", "Universe", "camera", "contacts", "distance", "distances", "pose", "ray", "version"]


def version():
    """Version of the library that was loaded."""
    return library.abut_version_string().decode()


def pose(x=0.0, y=0.0, z=0.0, orientation=(1.0, 0.0, 0.0, 0.0)):
    """A pose from a position and a unit quaternion, scalar first."""
    return c.Pose(c.Vec3(x, y, z), c.Quat(*orientation))


def ray(origin, direction, max_distance=float("inf")):
    """A ray from two triples of numbers."""
    return c.Ray(c.Vec3(*origin), c.Vec3(*direction), max_distance)


def _array(kind, values):
    """Values as a ctypes array; a writable buffer of the right kind is used where it lies."""
    try:
        view = memoryview(values)
        if view.contiguous and not view.readonly and view.format == kind._type_:
            return (kind * (view.nbytes // ctypes.sizeof(kind))).from_buffer(view.cast("B"))
    except TypeError:
        pass
    flat = list(values)
    return (kind * len(flat))(*flat)


def _structs(kind, values):
    return (kind * len(values))(*values)


def _options(struct, init, /, **fields):
    """An options struct with its defaults and then the given fields. An unknown field is an error."""
    options = struct()
    init(byref(options), ctypes.sizeof(struct))
    for name, value in fields.items():
        if name not in (field for field, _ in struct._fields_):
            raise TypeError(f"{struct.__name__} has no field {name}")
        setattr(options, name, value)
    return options


def _count_then_fill(kind, ask):
    """The whole answer of a function that fills arrays of unknown length."""
    count = c_size_t()
    ask(None, 0, byref(count))
    while True:
        values = (kind * count.value)()
        ask(values, len(values), byref(count))
        if count.value <= len(values):
            return values


class _Owner:
    """Owns one pointer of the library."""

    def __init__(self, pointer):
        self._pointer = pointer

    @property
    def pointer(self):
        if not self._pointer:
            raise ValueError(f"this {type(self).__name__.lower()} is closed")
        return self._pointer

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        if getattr(self, "_pointer", None):
            self.close()

    def close(self):
        pointer, self._pointer = self._pointer, None
        if pointer:
            self._release(pointer)


class Shape(_Owner):
    """A shape: immutable, shared, independent of any universe."""

    _release = staticmethod(library.abut_shape_release)

    @classmethod
    def _made_by(cls, function, *arguments):
        out = c_void_p()
        function(*arguments, byref(out))
        return cls(out)

    @classmethod
    def sphere(cls, radius):
        return cls._made_by(library.abut_sphere_create, radius)

    @classmethod
    def box(cls, half_x, half_y, half_z):
        return cls._made_by(library.abut_box_create, half_x, half_y, half_z)

    @classmethod
    def capsule(cls, radius, half_height):
        return cls._made_by(library.abut_capsule_create, radius, half_height)

    @classmethod
    def cylinder(cls, radius, half_height):
        return cls._made_by(library.abut_cylinder_create, radius, half_height)

    @classmethod
    def plane(cls, normal, offset):
        return cls._made_by(library.abut_plane_create, byref(c.Vec3(*normal)), offset)

    @classmethod
    def hull(cls, xyz):
        """Convex hull of points: x, y, z, x, y, z, ..."""
        points = _array(c.c_double, xyz)
        return cls._made_by(library.abut_hull_create, points, len(points) // 3)

    @classmethod
    def mesh(cls, xyz, triangles, **options):
        points, indices = _array(c.c_double, xyz), _array(c_uint32, triangles)
        filled = _options(c.MeshOptions, library.abut_mesh_options_init, **options)
        return cls._made_by(library.abut_mesh_create, points, len(points) // 3, indices, len(indices) // 3, byref(filled))

    @classmethod
    def height_field(cls, columns, rows, heights, spacing_x=1.0, spacing_y=1.0):
        values = _array(c.c_double, heights)
        if len(values) != columns * rows:
            raise ValueError(f"{len(values)} heights for {columns} x {rows} samples")
        desc = _options(c.HeightFieldDesc, library.abut_height_field_desc_init, columns=columns, rows=rows,
                        spacing_x=spacing_x, spacing_y=spacing_y, heights=values)
        return cls._made_by(library.abut_height_field_create, byref(desc))

    @classmethod
    def particles(cls, xyz, radius):
        """Many balls of one radius: x, y, z, x, y, z, ..."""
        points = _array(c.c_double, xyz)
        return cls._made_by(library.abut_particles_create, points, len(points) // 3, radius)

    @classmethod
    def composite(cls, children, poses):
        """Shapes, each at a pose of its own, as one."""
        if len(children) != len(poses):
            raise ValueError(f"{len(children)} children with {len(poses)} poses")
        pointers = (c_void_p * len(children))(*(child.pointer for child in children))
        return cls._made_by(library.abut_composite_create, pointers, _structs(c.Pose, poses), len(children))

    @classmethod
    def of_kind(cls, name, parameters=(), reals=(), indices=()):
        """A shape of any kind from its parameters and buffers."""
        numbers, points, corners = _array(c.c_double, parameters), _array(c.c_double, reals), _array(c_uint32, indices)
        desc = _options(c.ShapeDesc, library.abut_shape_desc_init, kind=library.abut_shape_kind_by_name(name.encode()),
                        parameters=numbers, parameter_count=len(numbers), reals=points, real_count=len(points),
                        indices=corners, index_count=len(corners))
        return cls._made_by(library.abut_shape_create, byref(desc))

    @property
    def kind(self):
        return library.abut_shape_kind_name(library.abut_shape_kind_of(self.pointer)).decode()

    @property
    def parameters(self):
        """Parameters by name."""
        kind = library.abut_shape_kind_of(self.pointer)
        values = _count_then_fill(c.c_double, lambda *rest: library.abut_shape_parameters(self.pointer, *rest))
        return {library.abut_shape_kind_parameter_name(kind, i).decode(): value for i, value in enumerate(values)}

    def hull_report(self):
        """What a hull has left of its points, and the error of that."""
        out = _options(c.HullReport, library.abut_hull_report_init)
        library.abut_hull_describe(self.pointer, byref(out))
        return out

    def aabb(self, at):
        out = c.Aabb()
        library.abut_shape_aabb(self.pointer, byref(at), byref(out))
        return out

    def triangles(self):
        """Vertices and indices of the surface, flat."""
        vertices, triangles = c_size_t(), c_size_t()
        library.abut_shape_triangles(self.pointer, None, 0, byref(vertices), None, 0, byref(triangles))
        xyz, indices = (c.c_double * (3 * vertices.value))(), (c_uint32 * (3 * triangles.value))()
        library.abut_shape_triangles(self.pointer, xyz, vertices, byref(vertices), indices, triangles, byref(triangles))
        return xyz, indices

    def cast_ray(self, at, along):
        """The first hit, or None."""
        hit, found = c.RayHit(), c_uint32()
        library.abut_shape_cast_ray(self.pointer, byref(at), byref(along), byref(hit), byref(found))
        return hit if found.value else None


def _query(options):
    return byref(_options(c.QueryOptions, library.abut_query_options_init, **options))


def distance(a, pose_a, b, pose_b, **options):
    """Signed distance of two shapes; the options are the fields of QueryOptions."""
    out = c.Distance()
    library.abut_shapes_distance(a.pointer, byref(pose_a), b.pointer, byref(pose_b), _query(options), byref(out))
    return out


def distances(a, poses_a, b, poses_b, **options):
    """Signed distances of as many pairs of poses of two shapes."""
    if len(poses_a) != len(poses_b):
        raise ValueError("as many poses of a as of b")
    out = (c.Distance * len(poses_a))()
    library.abut_shapes_distances(a.pointer, _structs(c.Pose, poses_a), b.pointer, _structs(c.Pose, poses_b), len(out),
                                  _query(options), out)
    return out


def contacts(a, pose_a, b, pose_b, **options):
    """Contacts of two shapes, deepest first."""
    return _count_then_fill(c.Contact, lambda *rest: library.abut_shapes_contacts(
        a.pointer, byref(pose_a), b.pointer, byref(pose_b), _query(options), *rest))


class Universe(_Owner):
    """A space in which parts meet; the options are the fields of UniverseOptions."""

    _release = staticmethod(library.abut_universe_destroy)

    def __init__(self, **options):
        out = c_void_p()
        library.abut_universe_create(
            byref(_options(c.UniverseOptions, library.abut_universe_options_init, **options)), byref(out))
        super().__init__(out)

    def add_part(self, **options):
        """A new part; the options are the fields of PartOptions."""
        out = c.PartId()
        filled = _options(c.PartOptions, library.abut_part_options_init, **options)
        library.abut_part_create(self.pointer, byref(filled), byref(out))
        return out

    def add_geometry(self, part, shape, **options):
        """A shape on a part; the options are the fields of GeometryOptions."""
        out = c.GeometryId()
        filled = _options(c.GeometryOptions, library.abut_geometry_options_init, **options)
        library.abut_geometry_create(self.pointer, part, shape.pointer, byref(filled), byref(out))
        return out

    def destroy_parts(self, parts):
        library.abut_parts_destroy(self.pointer, _structs(c.PartId, parts), len(parts))

    def destroy_geometries(self, geometries):
        library.abut_geometries_destroy(self.pointer, _structs(c.GeometryId, geometries), len(geometries))

    def set_poses(self, parts, poses):
        if len(parts) != len(poses):
            raise ValueError("as many poses as parts")
        library.abut_parts_set_poses(self.pointer, _structs(c.PartId, parts), _structs(c.Pose, poses), len(parts))

    def poses(self, parts):
        out = (c.Pose * len(parts))()
        library.abut_parts_poses(self.pointer, _structs(c.PartId, parts), len(parts), out)
        return out

    def user_data(self, part):
        out = c_uint64()
        library.abut_part_user_data(self.pointer, part, byref(out))
        return out.value

    def parts(self):
        return _count_then_fill(c.PartId, lambda *rest: library.abut_universe_parts(self.pointer, *rest))

    def geometries(self, part=None):
        """Geometries of one part, or all."""
        if part is None:
            return _count_then_fill(c.GeometryId, lambda *rest: library.abut_universe_geometries(self.pointer, *rest))
        return _count_then_fill(c.GeometryId, lambda *rest: library.abut_part_geometries(self.pointer, part, *rest))

    def describe(self, geometry):
        out = _options(c.GeometryInfo, library.abut_geometry_info_init)
        library.abut_geometry_describe(self.pointer, geometry, byref(out))
        return out

    def geometry_poses(self, geometries):
        out = (c.Pose * len(geometries))()
        library.abut_geometries_poses(self.pointer, _structs(c.GeometryId, geometries), len(geometries), out)
        return out

    def revision(self):
        out = c.Revision()
        library.abut_universe_revision(self.pointer, byref(out))
        return out

    def step(self, dt=0.0):
        library.abut_universe_step(self.pointer, dt)

    def contacts(self):
        """A copy of the contacts of the last step."""
        first, count = ctypes.POINTER(c.Contact)(), c_size_t()
        library.abut_universe_contacts(self.pointer, byref(first), byref(count))
        out = (c.Contact * count.value)()
        ctypes.memmove(out, first, ctypes.sizeof(out))
        return out

    def set_contact_user_data(self, values):
        """A number for each contact of the last step, which stays with it from step to step."""
        numbers = _array(c.c_uint64, values)
        library.abut_contacts_set_user_data(self.pointer, numbers, len(numbers))

    def stats(self):
        out = _options(c.StepStats, library.abut_step_stats_init)
        library.abut_universe_stats(self.pointer, byref(out))
        return out

    def explain(self):
        needed = c_size_t()
        library.abut_universe_explain(self.pointer, None, 0, byref(needed))
        text = ctypes.create_string_buffer(needed.value)
        library.abut_universe_explain(self.pointer, text, needed, byref(needed))
        return text.value.decode()


def camera(eye=None, target=None, up=(0.0, 0.0, 1.0), **fields):
    """A camera; the fields are those of Camera. With eye and target it looks from one to the other."""
    out = _options(c.Camera, picking.abut_camera_init, **fields)
    if eye is not None:
        picking.abut_camera_look_at(byref(out), byref(c.Vec3(*eye)), byref(c.Vec3(*target)), byref(c.Vec3(*up)))
    return out


class Picker(_Owner):
    """Rays against a universe; keeps the universe alive. Needs libabut_picking."""

    def __init__(self, universe):
        if picking is None:
            raise RuntimeError("libabut_picking is not installed; ABUT_PICKING_LIBRARY may name it")
        out = c_void_p()
        picking.abut_picker_create(universe.pointer, byref(out))
        self._universe = universe
        super().__init__(out)

    @staticmethod
    def _release(pointer):
        picking.abut_picker_destroy(pointer)

    def update(self):
        picking.abut_picker_update(self.pointer)

    def cast_ray(self, along):
        out = c.Pick()
        picking.abut_picker_cast_ray(self.pointer, byref(along), byref(out))
        return out

    def cast_rays(self, rays, coherence=c.COHERENCE_NONE):
        out = (c.Pick * len(rays))()
        picking.abut_picker_cast_rays(self.pointer, _structs(c.Ray, rays), len(rays), coherence, out)
        return out

    def cast_ray_all(self, along):
        return _count_then_fill(c.Pick, lambda *rest: picking.abut_picker_cast_ray_all(self.pointer, byref(along), *rest))

    def pick_pixel(self, through, x, y, radius=0.0):
        out = c.Pick()
        picking.abut_picker_pick_pixel(self.pointer, byref(through), x, y, radius, byref(out))
        return out

    def render(self, through):
        out = (c.Pick * (through.width * through.height))()
        picking.abut_picker_render(self.pointer, byref(through), out, len(out))
        return out
