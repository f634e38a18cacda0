# SPDX-License-Identifier: Apache-2.0
"""abut, 3D collision detection, in Python: shapes, distances and contacts of pairs, universes, picking.

    with Shape.sphere(1.0) as ball, Shape.box(1.0, 1.0, 1.0) as box:
        print(pair_distance(ball, pose(), box, pose(3.0, 0.0, 0.0)).distance)

Objects are released by `with`, by close(), or when they are collected. Failures raise Error, which carries the status
and the message. Arrays are any sequences of numbers; buffers of doubles (array.array, NumPy) are not copied on the way
in. Results are ctypes structs and arrays, which NumPy can view.
"""

import ctypes
import json
from ctypes import byref, c_size_t, c_uint32, c_uint64, c_void_p

import abut_c as c
from abut_c import *  # noqa: F401,F403 - the constants and structs are part of this module
from abut_c import Error, library, picking

_INNER = ("FUNCTIONS", "Filter", "PICKING_FUNCTIONS", "POINTER")
__all__ = [name for name in dir(c) if name[0].isupper() and name not in _INNER] + [
    "Picker", "Shape", "Universe", "camera", "pair_cast", "pair_contacts", "pair_distance", "pairs_distance", "pose",
    "ray", "validate_contact", "version"]


def version():
    """Version of the library that was loaded."""
    return library.abut_version_string().decode()


def pose(x=0.0, y=0.0, z=0.0, orientation=(1.0, 0.0, 0.0, 0.0)):
    """A pose from a position and a unit quaternion, scalar first."""
    if len(orientation) != 4:
        raise ValueError(f"orientation has {len(orientation)} numbers; it must have 4")
    return c.Pose(c.Vec3(x, y, z), c.Quat(*orientation))


def ray(origin, direction, max_distance=float("inf")):
    """A ray from two triples of numbers."""
    return c.Ray(_vec3("origin", origin), _vec3("direction", direction), max_distance)


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


def _groups(kind, name, values, size):
    """An array of groups of numbers, such as x, y, z, and how many groups there are."""
    flat = _array(kind, values)
    if len(flat) % size:
        raise ValueError(f"{name} has {len(flat)} numbers; it must be a multiple of {size}")
    return flat, len(flat) // size


def _vec3(name, values):
    numbers = tuple(values)
    if len(numbers) != 3:
        raise ValueError(f"{name} has {len(numbers)} numbers; it must have 3")
    return c.Vec3(*numbers)


def _expect_as_many(**arrays):
    """Arrays that belong together have one length."""
    if len({len(array) for array in arrays.values()}) != 1:
        lengths = " and ".join(f"{name} has {len(array)}" for name, array in arrays.items())
        raise ValueError(f"{lengths}; they must have as many elements")


def _structs(kind, values):
    return (kind * len(values))(*values)


def _pointers(shapes):
    return (c_void_p * len(shapes))(*(shape.pointer for shape in shapes))


def _set_fields(struct, fields):
    """Sets fields of a struct. An unknown one is an error."""
    known = [name for name, _ in struct._fields_]
    for name, value in fields.items():
        if name not in known:
            raise TypeError(f"{type(struct).__name__} has no field {name}")
        setattr(struct, name, value)


def _options(struct, init, /, **fields):
    """An options struct with its defaults and then the given fields."""
    options = struct()
    init(byref(options), ctypes.sizeof(struct))
    _set_fields(options, fields)
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


def _text(ask):
    """The whole answer of a function that fills a text of unknown length."""
    needed = c_size_t()
    ask(None, 0, byref(needed))
    text = ctypes.create_string_buffer(needed.value)
    ask(text, needed, byref(needed))
    return text.value.decode()


def _collidable(what):
    """What a rule speaks of: a GeometryId, a PartId, a label as a number, or None for anything."""
    if what is None:
        return c.Collidable(c.COLLIDABLE_ANY)
    if isinstance(what, int):
        return c.Collidable(c.COLLIDABLE_LABEL, what)
    kinds = {c.GeometryId: c.COLLIDABLE_GEOMETRY, c.PartId: c.COLLIDABLE_PART}
    if type(what) not in kinds:
        raise TypeError(f"a rule speaks of a GeometryId, a PartId, a label or None, not of a {type(what).__name__}")
    return c.Collidable(kinds[type(what)], what.slot, what.generation)


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
        return cls._made_by(library.abut_plane_create, byref(_vec3("normal", normal)), offset)

    @classmethod
    def hull(cls, xyz):
        """Convex hull of points: x, y, z, x, y, z, ..."""
        return cls._made_by(library.abut_hull_create, *_groups(c.c_double, "xyz", xyz, 3))

    @classmethod
    def mesh(cls, xyz, triangles, **options):
        points, corners = _groups(c.c_double, "xyz", xyz, 3), _groups(c_uint32, "triangles", triangles, 3)
        filled = _options(c.MeshOptions, library.abut_mesh_options_init, **options)
        return cls._made_by(library.abut_mesh_create, *points, *corners, byref(filled))

    @classmethod
    def height_field(cls, columns, rows, heights, spacing_x=1.0, spacing_y=1.0):
        values = _array(c.c_double, heights)
        if len(values) != columns * rows:
            raise ValueError(f"heights has {len(values)} numbers; it must have {columns} * {rows}")
        desc = _options(c.HeightFieldDesc, library.abut_height_field_desc_init, columns=columns, rows=rows,
                        spacing_x=spacing_x, spacing_y=spacing_y, heights=values)
        return cls._made_by(library.abut_height_field_create, byref(desc))

    @classmethod
    def particles(cls, xyz, radius):
        """Many balls of one radius: x, y, z, x, y, z, ..."""
        return cls._made_by(library.abut_particles_create, *_groups(c.c_double, "xyz", xyz, 3), radius)

    @classmethod
    def composite(cls, children, poses, materials=None):
        """Shapes, each at a pose of its own, and with a material of its own, 0 for that of the geometry, as one."""
        _expect_as_many(children=children, poses=poses)
        if materials is not None:
            _expect_as_many(children=children, materials=materials)
            return cls._made_by(library.abut_composite_create_with_materials, _pointers(children), _structs(c.Pose, poses),
                                _array(c_uint32, materials), len(children))
        return cls._made_by(library.abut_composite_create, _pointers(children), _structs(c.Pose, poses), len(children))

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


def pair_distance(a, pose_a, b, pose_b, memory=None, **options):
    """Signed distance of two shapes; a PairMemory of the two makes it faster; the options are the fields of QueryOptions."""
    out, given = c.Distance(), (a.pointer, byref(pose_a), b.pointer, byref(pose_b), _query(options))
    if memory is None:
        library.abut_pair_distance(*given, byref(out))
    else:
        library.abut_pair_distance_with_memory(*given, byref(memory), byref(out))
    return out


def pairs_distance(a, poses_a, b, poses_b, memories=None, **options):
    """Signed distances of as many pairs of poses of two shapes; memories: an array of as many PairMemory."""
    _expect_as_many(poses_a=poses_a, poses_b=poses_b)
    out = (c.Distance * len(poses_a))()
    given = (a.pointer, _structs(c.Pose, poses_a), b.pointer, _structs(c.Pose, poses_b), len(out), _query(options))
    if memories is None:
        library.abut_pairs_distance(*given, out)
    else:
        _expect_as_many(poses_a=poses_a, memories=memories)
        library.abut_pairs_distance_with_memories(*given, memories, out)
    return out


def pair_contacts(a, pose_a, b, pose_b, memory=None, **options):
    """Contacts of two shapes, deepest first; a PairMemory of the two makes it faster."""
    given = (a.pointer, byref(pose_a), b.pointer, byref(pose_b), _query(options))
    if memory is None:
        return _count_then_fill(c.Contact, lambda *rest: library.abut_pair_contacts(*given, *rest))
    return _count_then_fill(
        c.Contact, lambda *rest: library.abut_pair_contacts_with_memory(*given, byref(memory), *rest))


def validate_contact(contact):
    """Raises Error, which names the field, for a record that no detection would report."""
    library.abut_contact_validate(byref(contact))


def pair_cast(a, pose_a, displacement_a, b, pose_b, displacement_b=(0.0, 0.0, 0.0), **options):
    """When two shapes that move by their displacements first touch, or None."""
    hit, found = c.CastHit(), c_uint32()
    library.abut_pair_cast(a.pointer, byref(pose_a), byref(_vec3("displacement_a", displacement_a)), b.pointer, byref(pose_b),
                           byref(_vec3("displacement_b", displacement_b)), _query(options), byref(hit), byref(found))
    return hit if found.value else None


def _filter(fields):
    return byref(_options(c.QueryFilter, library.abut_query_filter_init, **fields))


def _placed(shapes, poses):
    _expect_as_many(shapes=shapes, poses=poses)
    return _pointers(shapes), _structs(c.Pose, poses)


def _each_then_fill(query_count, ask):
    """A list of geometries for each query of a batch."""
    offsets = (c_uint64 * (query_count + 1))()
    found = _count_then_fill(c.GeometryId, lambda *rest: ask(offsets, *rest))
    return [found[first:last] for first, last in zip(offsets, offsets[1:])]


class Universe(_Owner):
    """A space in which parts meet; the options are the fields of UniverseOptions."""

    _release = staticmethod(library.abut_universe_destroy)

    def __init__(self, **options):
        out = c_void_p()
        library.abut_universe_create(
            byref(_options(c.UniverseOptions, library.abut_universe_options_init, **options)), byref(out))
        super().__init__(out)
        self._filter = None
        self._failure = None

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
        _expect_as_many(parts=parts, poses=poses)
        library.abut_parts_set_poses(self.pointer, _structs(c.PartId, parts), _structs(c.Pose, poses), len(parts))

    def poses(self, parts):
        out = (c.Pose * len(parts))()
        library.abut_parts_poses(self.pointer, _structs(c.PartId, parts), len(parts), out)
        return out

    def set_sleep(self, parts, **fields):
        """Lets parts fall asleep; the fields are those of Sleep."""
        sleep = _options(c.Sleep, library.abut_sleep_init, **fields)
        library.abut_parts_set_sleep(self.pointer, _structs(c.PartId, parts), _structs(c.Sleep, [sleep] * len(parts)), len(parts))

    def keep_awake(self, parts):
        """Parts that never fall asleep by themselves, which is how they are made."""
        library.abut_parts_set_sleep(self.pointer, _structs(c.PartId, parts), None, len(parts))

    def is_asleep(self, part):
        out = c_uint32()
        library.abut_part_is_asleep(self.pointer, part, byref(out))
        return out.value == 1

    def wake(self, parts):
        library.abut_parts_wake(self.pointer, _structs(c.PartId, parts), len(parts))

    def sleep_changes(self):
        """A copy of which parts fell asleep or woke in the last step."""
        return self._copy(c.SleepChange, library.abut_universe_sleep_changes)

    def set_motions(self, parts, motions):
        _expect_as_many(parts=parts, motions=motions)
        library.abut_parts_set_motions(self.pointer, _structs(c.PartId, parts), _array(c_uint32, motions), len(parts))

    def motion(self, part):
        out = c_uint32()
        library.abut_part_motion(self.pointer, part, byref(out))
        return out.value

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

    def options_of(self, geometry):
        """The options of a geometry as they are, for set_options."""
        info = self.describe(geometry)
        fields = {name: getattr(info, name) for name, _ in c.GeometryOptions._fields_ if name not in ("struct_size", "pose")}
        return _options(c.GeometryOptions, library.abut_geometry_options_init, pose=info.local, **fields)

    def set_options(self, geometries, options):
        """Replaces the options of geometries, all of them."""
        _expect_as_many(geometries=geometries, options=options)
        library.abut_geometries_set_options(self.pointer, _structs(c.GeometryId, geometries),
                                            _structs(c.GeometryOptions, options), len(geometries))

    def change(self, geometry, **fields):
        """Changes some fields of the GeometryOptions of a geometry."""
        options = self.options_of(geometry)
        _set_fields(options, fields)
        self.set_options([geometry], [options])

    def set_shapes(self, geometries, shapes):
        _expect_as_many(geometries=geometries, shapes=shapes)
        library.abut_geometries_set_shapes(
            self.pointer, _structs(c.GeometryId, geometries), _pointers(shapes), len(geometries))

    def park(self, geometries, parking=c.PARKING_SHORT_TERM):
        """Parks geometries, or brings them back with PARKING_NONE. A filter may do that, too."""
        library.abut_geometries_park(self.pointer, _structs(c.GeometryId, geometries), len(geometries), parking)

    def set_rule(self, a, b, rule):
        """Whether two collidables meet, each a GeometryId, a PartId, a label as a number, or None for anything."""
        library.abut_rule_set(self.pointer, byref(_collidable(a)), byref(_collidable(b)), rule)

    def clear_rules(self):
        library.abut_rules_clear(self.pointer)

    def set_filter(self, keeps):
        """keeps(a, b) says whether two geometries that come near meet; None for no filter.

        It may read the universe and park. What it raises leaves the pair in, and comes out of the detection.
        """
        def ask(_context, _universe, a, b):
            try:
                return 1 if keeps(a, b) else 0
            except BaseException as failure:  # pylint: disable=broad-except - nothing may pass through C
                self._failure = self._failure or failure
                return 1

        filter_ = c.Filter() if keeps is None else c.Filter(ask)
        library.abut_universe_set_filter(self.pointer, filter_, None)
        self._filter = filter_

    def refilter(self):
        library.abut_universe_refilter(self.pointer)

    def set_policy(self, tag_a, tag_b, **fields):
        """How geometries of two tags meet; the fields are those of Policy, and without any the default is back."""
        policy = _options(c.Policy, library.abut_policy_init, **fields)
        library.abut_policy_set(self.pointer, tag_a, tag_b, byref(policy))

    def policy(self, tag_a, tag_b):
        out = _options(c.Policy, library.abut_policy_init)
        library.abut_policy_get(self.pointer, tag_a, tag_b, byref(out))
        return out

    def set_focus(self, centres, **fields):
        """Tags that follow the distance from centres; the fields are those of Focus. None for the centres sets none."""
        if centres is None:
            library.abut_universe_set_focus(self.pointer, None, None, 0)
            return
        focus = _options(c.Focus, library.abut_focus_init, **fields)
        places = _structs(c.Vec3, [_vec3("centre", centre) for centre in centres])
        library.abut_universe_set_focus(self.pointer, byref(focus), places, len(places))

    def set_material(self, material_a, material_b, **fields):
        """What contacts of two materials are like; the fields are those of ContactMaterial."""
        row = _options(c.ContactMaterial, library.abut_contact_material_init, **fields)
        library.abut_material_pair_set(self.pointer, material_a, material_b, byref(row))

    def material(self, material_a, material_b):
        out = _options(c.ContactMaterial, library.abut_contact_material_init)
        library.abut_material_pair_get(self.pointer, material_a, material_b, byref(out))
        return out

    def validate(self):
        """What is odd about the scene: pairs of a code and a sentence."""
        findings = _count_then_fill(c.Finding, lambda *rest: library.abut_universe_validate(self.pointer, *rest))
        return [(finding.code, finding.message.decode()) for finding in findings]

    def geometry_poses(self, geometries):
        out = (c.Pose * len(geometries))()
        library.abut_geometries_poses(self.pointer, _structs(c.GeometryId, geometries), len(geometries), out)
        return out

    def revision(self):
        out = c.Revision()
        library.abut_universe_revision(self.pointer, byref(out))
        return out

    def _detect(self, detection, *arguments):
        self._failure = None
        detection(self.pointer, *arguments)
        failure, self._failure = self._failure, None
        if failure is not None:
            raise failure

    def step(self, dt=0.0):
        self._detect(library.abut_universe_step, dt)

    def detect_all(self):
        """A step that finds every pair anew."""
        self._detect(library.abut_universe_detect_all)

    def detect_changed(self):
        self._detect(library.abut_universe_detect_changed)

    def detect_pairs(self, pairs):
        """A step that looks at pairs of geometries only."""
        first, second = _structs(c.GeometryId, [a for a, _ in pairs]), _structs(c.GeometryId, [b for _, b in pairs])
        self._detect(library.abut_universe_detect_pairs, first, second, len(pairs))

    def detect_region(self, minimum, maximum):
        """A step that looks at what meets a box of the world only."""
        box = c.Aabb(_vec3("minimum", minimum), _vec3("maximum", maximum))
        self._detect(library.abut_universe_detect_region, byref(box))

    def refresh(self):
        """Brings the boxes up to date with the poses, for queries."""
        library.abut_universe_refresh(self.pointer)

    def _copy(self, kind, lend):
        first, count = ctypes.POINTER(kind)(), c_size_t()
        lend(self.pointer, byref(first), byref(count))
        out = (kind * count.value)()
        ctypes.memmove(out, first, ctypes.sizeof(out))
        return out

    def contacts(self):
        """A copy of the contacts of the last step."""
        return self._copy(c.Contact, library.abut_universe_contacts)

    def local_points(self):
        """A copy of the points of the contacts in the frames of their geometries; for UNIVERSE_LOCAL_POINTS in flags."""
        return self._copy(c.LocalPoints, library.abut_universe_local_points)

    def events(self):
        """A copy of the events of the last step."""
        return self._copy(c.Event, library.abut_universe_events)

    def hash(self):
        """A number of every bit of the contacts, events and sleep changes of the last step."""
        out = c_uint64()
        library.abut_universe_hash(self.pointer, byref(out))
        return out.value

    def set_contact_user_data(self, values):
        """A number for each contact of the last step, which stays with it from step to step."""
        numbers = _array(c.c_uint64, values)
        library.abut_contacts_set_user_data(self.pointer, numbers, len(numbers))

    def stats(self):
        out = _options(c.StepStats, library.abut_step_stats_init)
        library.abut_universe_stats(self.pointer, byref(out))
        return out

    def explain(self):
        return _text(lambda *rest: library.abut_universe_explain(self.pointer, *rest))

    def explain_json(self):
        """The same as a dictionary."""
        return json.loads(_text(lambda *rest: library.abut_universe_explain_json(self.pointer, *rest)))

    def cast_ray(self, along, mode=c.HIT_NEAREST, **filter):
        """Hits of a ray, in order; the filter is the fields of QueryFilter, here and below."""
        return _count_then_fill(c.QueryHit, lambda *rest: library.abut_universe_cast_ray(
            self.pointer, byref(along), _filter(filter), mode, *rest))

    def cast_rays(self, rays, **filter):
        """The nearest hit of each ray; its geometry is null where there is none."""
        out = (c.QueryHit * len(rays))()
        library.abut_universe_cast_rays(self.pointer, _structs(c.Ray, rays), len(rays), _filter(filter), out)
        return out

    def cast_shape(self, shape, at, displacement, mode=c.HIT_NEAREST, **filter):
        """Hits of a shape that moves, in order."""
        return _count_then_fill(c.CastHit, lambda *rest: library.abut_universe_cast_shape(
            self.pointer, shape.pointer, byref(at), byref(_vec3("displacement", displacement)), _filter(filter), mode, *rest))

    def cast_shapes(self, shapes, poses, displacements, **filter):
        """The nearest hit of each shape; its geometry is null where there is none."""
        pointers, placed = _placed(shapes, poses)
        _expect_as_many(displacements=displacements, shapes=shapes)
        ways = _structs(c.Vec3, [_vec3("way", way) for way in displacements])
        out = (c.CastHit * len(shapes))()
        library.abut_universe_cast_shapes(self.pointer, pointers, placed, ways, len(out), _filter(filter), out)
        return out

    def overlaps(self, shape, at, margin=0.0, **filter):
        """Geometries with which a shape has contacts up to a distance."""
        return _count_then_fill(c.GeometryId, lambda *rest: library.abut_universe_overlaps(
            self.pointer, shape.pointer, byref(at), _filter(filter), margin, *rest))

    def overlaps_of_each(self, shapes, poses, margin=0.0, **filter):
        pointers, placed = _placed(shapes, poses)
        return _each_then_fill(len(shapes), lambda *rest: library.abut_universe_overlaps_of_each(
            self.pointer, pointers, placed, len(shapes), _filter(filter), margin, *rest))

    def at_point(self, point, **filter):
        """Geometries that hold a point."""
        return _count_then_fill(c.GeometryId, lambda *rest: library.abut_universe_at_point(
            self.pointer, byref(_vec3("point", point)), _filter(filter), *rest))

    def at_points(self, points, **filter):
        places = _structs(c.Vec3, [_vec3("point", point) for point in points])
        return _each_then_fill(len(points), lambda *rest: library.abut_universe_at_points(
            self.pointer, places, len(points), _filter(filter), *rest))

    def closest(self, shape, at, max_distance=float("inf"), **filter):
        """The closest geometry and its distance, or None."""
        out, found = c.Closest(), c_uint32()
        library.abut_universe_closest(self.pointer, shape.pointer, byref(at), max_distance, _filter(filter), byref(out), byref(found))
        return out if found.value else None

    def closest_to_each(self, shapes, poses, max_distance=float("inf"), **filter):
        """The same for each shape; the geometry is null where nothing is near."""
        pointers, placed = _placed(shapes, poses)
        out = (c.Closest * len(shapes))()
        library.abut_universe_closest_to_each(self.pointer, pointers, placed, len(out), max_distance, _filter(filter), out)
        return out


def camera(eye=None, target=None, up=(0.0, 0.0, 1.0), **fields):
    """A camera; the fields are those of Camera. With eye and target it looks from one to the other."""
    out = _options(c.Camera, picking.abut_camera_init, **fields)
    if eye is not None:
        picking.abut_camera_look_at(byref(out), byref(_vec3("eye", eye)), byref(_vec3("target", target)),
                                    byref(_vec3("up", up)))
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

    def cast_ray(self, along, **filter):
        """What a ray meets first; the filter is the fields of QueryFilter, here and below."""
        out = c.Pick()
        picking.abut_picker_cast_ray(self.pointer, byref(along), _filter(filter), byref(out))
        return out

    def cast_rays(self, rays, coherence=c.COHERENCE_NONE, **filter):
        out = (c.Pick * len(rays))()
        picking.abut_picker_cast_rays(self.pointer, _structs(c.Ray, rays), len(rays), coherence, _filter(filter), out)
        return out

    def cast_ray_all(self, along, **filter):
        return _count_then_fill(c.Pick, lambda *rest: picking.abut_picker_cast_ray_all(
            self.pointer, byref(along), _filter(filter), *rest))

    def pick_pixel(self, through, x, y, radius=0.0, **filter):
        out = c.Pick()
        picking.abut_picker_pick_pixel(self.pointer, byref(through), x, y, radius, _filter(filter), byref(out))
        return out

    def render(self, through, **filter):
        out = (c.Pick * (through.width * through.height))()
        picking.abut_picker_render(self.pointer, byref(through), _filter(filter), out, len(out))
        return out
