# SPDX-License-Identifier: Apache-2.0
"""Steps of a universe, and what they found."""

from __future__ import annotations

import ctypes
import json
from ctypes import POINTER, byref, c_size_t, c_uint32, c_uint64
from typing import Any

from .. import answers, c, given, options
from ..c import library
from ..lending import Borrowed
from ..records import Records
from .filters import Filters


class Detection(Filters):
    """Answers are copies. Those of the methods `borrow_` lie in the universe and are good until it changes."""

    def _run(self, detection, *arguments):
        self._failure = None
        self._change(detection, *arguments)
        self._raise_what_the_filter_raised()

    def step(self, dt: float = 0.0) -> None:
        """Detects at the present poses; moves nothing."""
        self._run(library.abut_universe_step, dt)

    def detect_all(self) -> None:
        """A step that finds every pair anew."""
        self._run(library.abut_universe_detect_all)

    def detect_changed(self) -> None:
        """A step without time."""
        self._run(library.abut_universe_detect_changed)

    def detect_pairs(self, pairs: Any) -> None:
        """A step that looks at pairs of geometries only."""
        columns: Any = ([a for a, _ in pairs], [b for _, b in pairs]) if not given.is_array(pairs) else _columns(pairs)
        first, second = (given.structs(c.GeometryId, "pairs", column) for column in columns)
        self._run(library.abut_universe_detect_pairs, first.memory, second.memory, len(first))

    def detect_region(self, minimum: Any, maximum: Any) -> None:
        """A step that looks at what meets a box of the world only."""
        box = c.Aabb(given.vec3("minimum", minimum), given.vec3("maximum", maximum))
        self._run(library.abut_universe_detect_region, byref(box))

    def refresh(self) -> None:
        """Brings the boxes up to date with the poses, for queries."""
        self._run(library.abut_universe_refresh)

    def advance_to_first_impact(self, dt: float) -> c.StepImpact:
        """Moves all parts along their paths through dt, until the first of the fast geometries would touch."""
        out = c.StepImpact()
        self._run(library.abut_universe_advance_to_first_impact, dt, byref(out))
        return out

    def _copy(self, kind, lend):
        out = []

        def copy(pointer):
            address, count = place_of(pointer, kind, lend)
            memory = (kind * count)()
            ctypes.memmove(memory, address, ctypes.sizeof(memory))
            out.append(Records(memory))

        self._read(copy)
        return out[0]

    def _borrow(self, kind, lend):
        out = []
        self._read(lambda pointer: out.append(Borrowed(self, kind, *place_of(pointer, kind, lend), self.change_count)))
        return out[0]

    def contacts(self) -> Records:
        """Contacts of the last step, ordered by the slots of their geometries, then deepest first."""
        return self._copy(c.Contact, library.abut_universe_contacts)

    def borrow_contacts(self) -> Borrowed:
        """The same without a copy."""
        return self._borrow(c.Contact, library.abut_universe_contacts)

    def local_points(self) -> Records:
        """Points of the contacts in the frames of their geometries; for UNIVERSE_LOCAL_POINTS in flags."""
        return self._copy(c.LocalPoints, library.abut_universe_local_points)

    def borrow_local_points(self) -> Borrowed:
        """The same without a copy."""
        return self._borrow(c.LocalPoints, library.abut_universe_local_points)

    def events(self) -> Records:
        """Events of the last step."""
        return self._copy(c.Event, library.abut_universe_events)

    def borrow_events(self) -> Borrowed:
        """The same without a copy."""
        return self._borrow(c.Event, library.abut_universe_events)

    def element_contacts(self) -> Records:
        """Vertices, edges and faces that are near or touch; of pairs whose policy has DETAIL_ELEMENTS."""
        return self._copy(c.ElementContact, library.abut_universe_element_contacts)

    def borrow_element_contacts(self) -> Borrowed:
        """The same without a copy, until the next change of the universe."""
        return self._borrow(c.ElementContact, library.abut_universe_element_contacts)

    def impacts(self) -> Records:
        """What fast geometries touched on their paths through the last step, in order of time."""
        return self._copy(c.StepImpact, library.abut_universe_impacts)

    def sleep_changes(self) -> Records:
        """Which parts fell asleep or woke in the last step."""
        return self._copy(c.SleepChange, library.abut_universe_sleep_changes)

    def follow_islands(self, are_followed: bool = True) -> None:
        """Whether steps find islands."""
        self._change(library.abut_universe_follow_islands, 1 if are_followed else 0)

    def islands(self) -> Records:
        """Islands of the last step."""
        return self._copy(c.Island, library.abut_universe_islands)

    def island_parts(self) -> Records:
        """Parts of all islands, island by island."""
        return self._copy(c.PartId, library.abut_universe_island_parts)

    def island_of(self, part: c.PartId) -> c.Island:
        """Island of a part in the last step; zeros for a part that was in none."""
        out = c.Island()
        self._read(library.abut_part_island, part, byref(out))
        return out

    def hash(self) -> int:
        """A number of every bit of the contacts, events and sleep changes of the last step."""
        out = c_uint64()
        self._read(library.abut_universe_hash, byref(out))
        return out.value

    def set_contact_user_data(self, values: Any) -> None:
        """A number for each contact of the last step, which stays with it from step to step."""
        numbers = given.numbers("values", values, c_uint64)
        self._change(library.abut_contacts_set_user_data, numbers, len(numbers))

    def revision(self) -> c.Revision:
        """Counters that grow with each change."""
        out = c.Revision()
        self._read(library.abut_universe_revision, byref(out))
        return out

    def changes(self, since: c.Revision) -> Records | None:
        """Geometries that have changed since a revision; the generation of those that have gone is 0.

        None where more has changed than the universe remembers: all of them may have.
        """
        is_known = c_uint32()
        found = answers.filled(c.GeometryId, lambda values, room, count: self._read(
            library.abut_universe_changes, byref(since), values, room, count, byref(is_known)))
        return Records(found) if is_known.value else None

    def stats(self) -> c.StepStats:
        """Counts and times of the last step."""
        out = options.filled(c.StepStats, library.abut_step_stats_init, {})
        self._read(library.abut_universe_stats, byref(out))
        return out

    def validate(self) -> list[tuple[int, str]]:
        """What is odd about the scene: pairs of a code and a sentence."""
        findings = answers.filled(c.Finding, lambda *rest: self._read(library.abut_universe_validate, *rest))
        return [(finding.code, finding.message.decode()) for finding in findings]

    def explain(self) -> str:
        """What the last step did, and why, in words."""
        return answers.text(lambda *rest: self._read(library.abut_universe_explain, *rest))

    def explain_json(self) -> dict:
        """The same as a dictionary."""
        return json.loads(answers.text(lambda *rest: self._read(library.abut_universe_explain_json, *rest)))


def place_of(pointer, kind, lend):
    """Address and count of what the library lends."""
    first, count = POINTER(kind)(), c_size_t()
    lend(pointer, byref(first), byref(count))
    return ctypes.cast(first, ctypes.c_void_p).value or 0, count.value


def _columns(pairs):
    """Both columns of an array of pairs."""
    shape = getattr(pairs, "shape", (len(pairs),))
    if len(shape) != 2 or shape[1] != 2:
        raise ValueError(f"pairs has shape {shape}; it must be (N, 2)")
    return pairs[:, 0], pairs[:, 1]
