# SPDX-License-Identifier: Apache-2.0
"""Bodies of a universe that contacts push, through the library for response. docs/response.md tells more."""

from __future__ import annotations

import ctypes
import json
from ctypes import POINTER, byref, c_char_p, c_double, c_size_t, c_ubyte, c_uint32, c_uint64, c_void_p
from typing import Any, Callable

from . import answers, c, given, options
from .c import response as library
from .owner import Owner
from .records import Records
from .shapes import Shape
from .universe import Universe
from .universe.detection import place_of

__all__ = ["Response", "mass_properties"]


def _expect_response():
    if library is None:
        raise RuntimeError(f"libabut_response is not there ({c.response_failure}); ABUT_RESPONSE_LIBRARY may name it")


def mass_properties(shape: Shape, density: float) -> c.MassProperties:
    """Mass, centre of mass and inertia of a shape, in its own frame."""
    _expect_response()
    out = c.MassProperties()
    library.abut_shape_mass_properties(given.shape_pointer("shape", shape), *given.reals(density=density), byref(out))
    return out


def _side(what):
    """What a side of a rule speaks of, as Universe.set_rule takes it; labels are numbers."""
    if what is None:
        return c.ResponseSide(c.RESPONSE_SIDE_ANY)
    if isinstance(what, c.ResponseSide):
        return what
    if isinstance(what, int):
        return c.ResponseSide(c.RESPONSE_SIDE_LABEL, what)
    kinds = {c.GeometryId: c.RESPONSE_SIDE_GEOMETRY, c.PartId: c.RESPONSE_SIDE_PART}
    if type(what) not in kinds:
        raise TypeError(f"a rule speaks of a GeometryId, a PartId, a label, a ResponseSide or None, not of a "
                        f"{type(what).__name__}")
    return c.ResponseSide(kinds[type(what)], what.slot, what.generation)


def _text_or_none(name, value):
    return None if value is None else given.text(name, value)


def _copied(kind, place, count):
    return Records((kind * count).from_buffer_copy(ctypes.string_at(place, ctypes.sizeof(kind) * count)))


class Response(Owner):
    """Moves the dynamic parts of a universe, which it keeps alive; the fields are those of ResponseOptions.

    What callbacks raise comes out of the step, which then has gone on without them.
    """

    def __init__(self, universe: Universe, **fields: Any) -> None:
        _expect_response()
        out, described = c_void_p(), options.filled(c.ResponseOptions, library.abut_response_options_init, fields)
        universe._read(library.abut_response_create, byref(described), byref(out))
        self._begin(universe, out)

    def _begin(self, universe, pointer):
        self._universe = universe
        self._callbacks: dict[str, Any] = {}
        self._failure: BaseException | None = None
        super().__init__(pointer)
        universe._attached.add(self)

    @classmethod
    def load(cls, universe: Universe, data: bytes) -> Response:
        """A response from the bytes of another one, on a universe with the same ids; callbacks have to be set again."""
        _expect_response()
        kept, out = bytes(data), c_void_p()
        universe._read(library.abut_response_load, kept, len(kept), byref(out))
        response = cls.__new__(cls)
        response._begin(universe, out)
        return response

    def save(self) -> bytes:
        """All of it but callbacks, as bytes."""
        return bytes(answers.filled(c_ubyte, lambda *rest: self._read(library.abut_response_save, *rest), 1 << 12))

    def __reduce_ex__(self, protocol: Any) -> Any:
        return type(self).load, (self._universe, self.save())

    def _release(self, pointer):
        library.abut_response_destroy(pointer)

    def _read(self, function, *arguments):
        pointer = self.pointer
        self._universe._read(lambda _: function(pointer, *arguments))

    def _change(self, function, *arguments):
        pointer = self.pointer
        self._universe._change(lambda _: function(pointer, *arguments))

    def __repr__(self) -> str:
        if not self._pointer:
            return "<Response, closed>"
        return f"<Response of {self.explain_json()['step'][0]['bodies']} bodies>"

    def set_options(self, **fields: Any) -> None:
        """Options from the next step on; fields that are left out have their defaults."""
        described = options.filled(c.ResponseOptions, library.abut_response_options_init, fields)
        self._change(library.abut_response_set_options, byref(described))

    def add_bodies(self, parts: Any, **fields: Any) -> None:
        """Makes bodies of dynamic parts; the fields are those of BodyOptions."""
        ids = given.structs(c.PartId, "parts", parts)
        described = options.filled(c.BodyOptions, library.abut_body_options_init, fields)
        self._change(library.abut_response_add_bodies, ids.memory, len(ids), byref(described))

    def remove_body(self, part: c.PartId) -> None:
        """Ends a body; its part stays where it is."""
        self._change(library.abut_response_remove_body, part)

    def body(self, part: c.PartId) -> c.MassProperties:
        """Mass of a body, in the frame of its part."""
        out = c.MassProperties()
        self._read(library.abut_response_body, part, byref(out))
        return out

    def apply_force(self, part: c.PartId, force: Any, at: Any = None) -> None:
        """Pushes a body in the next step, at a point of the world or at its centre of mass."""
        self._change(library.abut_response_apply_force, part, byref(given.vec3("force", force)),
                     None if at is None else byref(given.vec3("at", at)))

    def apply_torque(self, part: c.PartId, torque: Any) -> None:
        """Turns a body in the next step."""
        self._change(library.abut_response_apply_torque, part, byref(given.vec3("torque", torque)))

    def add_particles(self, geometry: c.GeometryId, masses: Any, xyz: Any, velocities: Any = None) -> None:
        """Makes bodies of the particles or vertices of a geometry: N masses, (N, 3) centres and velocities."""
        weights, (centres, count) = given.numbers("masses", masses), given.rows("xyz", xyz, 3)
        speeds, speed_count = (None, count) if velocities is None else given.rows("velocities", velocities, 3)
        if not len(weights) == count == speed_count:
            raise ValueError(f"masses has {len(weights)}, xyz {count} and velocities {speed_count}; they must have as "
                             "many elements")
        self._change(library.abut_response_add_particles, geometry, weights, centres, speeds, count)

    def add_springs(self, geometry: c.GeometryId, pairs: Any, stiffness: Any, damping: Any = 0.0,
                    rest_lengths: Any = None) -> None:
        """Springs between particles that are bodies: (N, 2) numbers of particles.

        Stiffness and damping are one number, or N. Without rest lengths springs are at rest now.
        """
        ends, count = given.rows("pairs", pairs, 2, c_uint32)
        stiff, damped = (given.numbers(name, value if hasattr(value, "__len__") else [value] * count)
                         for name, value in (("stiffness", stiffness), ("damping", damping)))
        rest = None if rest_lengths is None else given.numbers("rest_lengths", rest_lengths)
        for name, numbers in (("stiffness", stiff), ("damping", damped), ("rest_lengths", rest)):
            if numbers is not None and len(numbers) != count:
                raise ValueError(f"pairs has {count} and {name} has {len(numbers)}; they must have as many elements")
        self._change(library.abut_response_add_springs, geometry, ends, stiff, damped, rest, count)

    def add_tetrahedra(self, geometry: c.GeometryId, tetrahedra: Any, **fields: Any) -> None:
        """Elastic tetrahedra of particles that are bodies: (N, 4) numbers. The fields are those of ElasticOptions."""
        corners, count = given.rows("tetrahedra", tetrahedra, 4, c_uint32)
        material = options.filled(c.ElasticOptions, library.abut_elastic_options_init, fields)
        self._change(library.abut_response_add_tetrahedra, geometry, corners, count, byref(material))

    def map_vertices(self, surface: c.GeometryId, carrier: c.GeometryId, numbers: Any, weights: Any) -> None:
        """Vertices of a mesh follow particles: (N, 4) numbers and weights."""
        nodes, count = given.rows("numbers", numbers, 4, c_uint32)
        parts, part_count = given.rows("weights", weights, 4)
        if part_count != count:
            raise ValueError(f"numbers has {count} and weights has {part_count}; they must have as many elements")
        self._change(library.abut_response_map_vertices, surface, carrier, nodes, parts, count)

    def remove_particles(self, geometry: c.GeometryId) -> None:
        """Ends particles, or a mesh that follows some; they stay where they are."""
        self._change(library.abut_response_remove_particles, geometry)

    def particles(self, geometry: c.GeometryId) -> tuple[Records, Records]:
        """Centres and velocities of particles in the world."""
        xyz, velocities, count = POINTER(c_double)(), POINTER(c_double)(), c_size_t()
        self._read(library.abut_response_particles, geometry, byref(xyz), byref(velocities), byref(count))
        return _copied(c.Vec3, xyz, count.value), _copied(c.Vec3, velocities, count.value)

    def add_rule(self, a: Any, b: Any, kind: str, parameters: str | None = None) -> int:
        """Contacts of two sides have a kind and parameters; answers the number of the rule.

        A side is a GeometryId, a PartId, a label as a number, None for anything, or a ResponseSide.
        """
        out = c_uint32()
        self._change(library.abut_response_add_rule, byref(_side(a)), byref(_side(b)), given.text("kind", kind),
                     _text_or_none("parameters", parameters), byref(out))
        return out.value

    def set_rule_parameters(self, rule: int, parameters: str | None) -> None:
        """Other parameters of a rule, from the next step on."""
        self._change(library.abut_response_set_rule_parameters, rule, _text_or_none("parameters", parameters))

    def clear_rules(self) -> None:
        """Takes all rules away."""
        self._change(library.abut_response_clear_rules)

    def set_variable(self, name: str, value: str) -> None:
        """What `$name$` stands for in parameters that are set from now on."""
        self._change(library.abut_response_set_variable, given.text("name", name), given.text("value", value))

    def set_geometry_kind(self, geometry: c.GeometryId, kind: str | None, parameters: str | None = None) -> None:
        """What all contacts of a geometry do, before any rule."""
        self._change(library.abut_response_set_geometry_kind, geometry, _text_or_none("kind", kind),
                     _text_or_none("parameters", parameters))

    def rule_between(self, a: c.GeometryId, b: c.GeometryId) -> str:
        """Which rule counts for two geometries, in words."""
        return answers.text(lambda *rest: self._read(library.abut_response_rule_between, a, b, *rest))

    def kinds(self) -> list[str]:
        """Names of the kinds of contacts, yours last."""
        return [name.decode() for name in answers.filled(c_char_p, lambda *rest: self._read(
            library.abut_response_kinds, *rest))]

    def add_link(self, **fields: Any) -> int:
        """A spring, a bond or a mouse between two points; the fields are those of LinkOptions. Answers its number."""
        out, described = c_uint64(), options.filled(c.LinkOptions, library.abut_link_options_init, fields)
        self._change(library.abut_response_add_link, byref(described), byref(out))
        return out.value

    def move_link(self, link: int, point_a: Any) -> None:
        """Moves the point of a link that is held in the world."""
        self._change(library.abut_response_move_link, link, byref(given.vec3("point_a", point_a)))

    def link_force(self, link: int) -> c.Vec3:
        """Force on b in the last step."""
        out = c.Vec3()
        self._read(library.abut_response_link_force, link, byref(out))
        return out

    def remove_link(self, link: int) -> None:
        """Ends a link."""
        self._change(library.abut_response_remove_link, link)

    def release(self, a: c.GeometryId, b: c.GeometryId) -> None:
        """Ends the bonds of two geometries."""
        self._change(library.abut_response_release, a, b)

    def step(self, dt: float) -> None:
        """Finds contacts, solves them and moves all bodies by a time."""
        self._failure = None
        self._change(library.abut_response_step, *given.reals(dt=dt))
        failure, self._failure = self._failure, None
        if failure is not None:
            raise failure

    def contacts(self) -> Records:
        """Contacts of the last step that have an awake body, with impulses and forces."""
        return self._copied(c.ResponseContact, library.abut_response_contacts)

    def objects(self) -> Records:
        """Pairs of geometries that have contacts or bonds, and those that ended in the last step."""
        return self._copied(c.ResponseObject, library.abut_response_objects)

    def islands(self) -> Records:
        """Bodies that touch each other, and how well they were solved."""
        return self._copied(c.ResponseIsland, library.abut_response_islands)

    def _copied(self, kind, lend):
        out = []

        def copy(pointer, *_):
            out.append(_copied(kind, *place_of(pointer, kind, lend)))

        self._read(copy)
        return out[0]

    def energy(self) -> c.Energy:
        """Energy and momentum of all bodies."""
        out = c.Energy()
        self._read(library.abut_response_energy, byref(out))
        return out

    def hash(self) -> int:
        """A number of every bit of save()."""
        out = c_uint64()
        self._read(library.abut_response_hash, byref(out))
        return out.value

    def validate(self) -> list[tuple[int, str]]:
        """What is odd: pairs of a code and a sentence."""
        findings = answers.filled(c.ResponseFinding, lambda *rest: self._read(library.abut_response_validate, *rest))
        return [(finding.code, finding.message.decode()) for finding in findings]

    def explain(self) -> str:
        """What steps do and how well the last one was solved, in words."""
        return answers.text(lambda *rest: self._read(library.abut_response_explain, *rest))

    def explain_json(self) -> dict:
        """The same as a dictionary."""
        return json.loads(answers.text(lambda *rest: self._read(library.abut_response_explain_json, *rest)))

    def set_force_callback(self, force: Callable | None) -> None:
        """A field: force(part, pose, velocity, time) returns a force and a torque, or None."""
        def add(_, part, pose, velocity, time, out_force, out_torque):
            found = self._asked(force, None, part, pose[0], velocity[0], time)
            for out, vector in zip((out_force[0], out_torque[0]), found or ()):
                for axis, number in zip("xyz", vector):
                    setattr(out, axis, getattr(out, axis) + float(number))
        self._set("force", library.abut_response_set_force_callback, c.ForceCallback, add if force else 0)

    def set_contact_callback(self, edit: Callable | None) -> None:
        """edit(contact, material) may change the material, and says whether the contact counts."""
        self._set("contact", library.abut_response_set_contact_callback, c.ContactCallback, (
            lambda _, contact, material: int(bool(self._asked(edit, True, contact[0], material[0])))) if edit else 0)

    def set_listener(self, listener: Callable | None) -> None:
        """listener(object) is told of each object after a step."""
        self._set("listener", library.abut_response_set_listener, c.ResponseListener, (
            lambda _, told: self._asked(listener, None, told[0]) and None) if listener else 0)

    def add_kind(self, name: str, law: Callable) -> None:
        """A kind of contact of your own: law(contact, velocity, dt, law) changes the law, and says whether it acts."""
        def ask(_, contact, velocity, dt, out):
            return int(bool(self._asked(law, False, contact[0], velocity[0], dt, out[0])))
        self._set(f"kind {name}", lambda pointer, callback, context: library.abut_response_add_kind(
            pointer, given.text("name", name), callback, context), c.ContactLawCallback, ask)

    def _set(self, name, function, kind, callback):
        held = kind(callback)
        self._change(function, held, None)
        self._callbacks[name] = held

    def _asked(self, function, otherwise, *arguments):
        """What a callback returns; what it raises is kept for the end of the step."""
        try:
            return function(*arguments)
        except BaseException as failure:  # pylint: disable=broad-except - nothing may pass through C
            self._failure = self._failure or failure
            return otherwise
