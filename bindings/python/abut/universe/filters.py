# SPDX-License-Identifier: Apache-2.0
"""Who meets whom in a universe, and how: rules, a filter, policies, focus and materials."""

from __future__ import annotations

from ctypes import byref, c_uint32
from typing import Any, Callable

from .. import c, given, options
from ..c import library
from ..lending import Lender


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


def _named(collidable):
    """The same the other way."""
    names = {c.COLLIDABLE_GEOMETRY: c.GeometryId(collidable.slot, collidable.generation),
             c.COLLIDABLE_PART: c.PartId(collidable.slot, collidable.generation),
             c.COLLIDABLE_LABEL: collidable.slot}
    return names.get(collidable.kind)


_REASONS = {name[len("APART_"):].lower(): bit for name, bit in vars(c).items() if name.startswith("APART_")}


class Filters(Lender):
    """Takes effect at the next step."""

    _filter: Any = None
    _failure: BaseException | None = None

    def set_rule(self, a: Any, b: Any, rule: int) -> None:
        """Whether two collidables meet, each a GeometryId, a PartId, a label as a number, or None for anything."""
        self._change(library.abut_rule_set, byref(_collidable(a)), byref(_collidable(b)), rule)

    def clear_rules(self) -> None:
        """Takes all rules away."""
        self._change(library.abut_rules_clear)

    def rule_between(self, geometry_a: c.GeometryId, geometry_b: c.GeometryId) -> tuple[int, Any, Any]:
        """The rule that counts for two geometries, and the two collidables that it names, as set_rule takes them."""
        rule, a, b = c_uint32(), c.Collidable(), c.Collidable()
        self._read(library.abut_rule_between, geometry_a, geometry_b, byref(rule), byref(a), byref(b))
        return rule.value, _named(a), _named(b)

    def why_apart(self, geometry_a: c.GeometryId, geometry_b: c.GeometryId) -> set[str]:
        """Why two geometries are not examined; empty where they are, so that the distance of their shapes decides.

        Of "part", "motion", "parking", "exclusion", "layers", "rule", "filter", "kinds", "boxes", "policy" and
        "detection": what ABUT_APART_ names in abut.h.
        """
        out = c_uint32()
        self._read(library.abut_universe_why_apart, geometry_a, geometry_b, byref(out))
        return {name for name, bit in _REASONS.items() if out.value & bit}

    def set_filter(self, keeps: Callable[[c.GeometryId, c.GeometryId], Any] | None) -> None:
        """keeps(a, b) says whether two geometries that come near meet; None for no filter.

        It may read the universe and park. What it raises leaves the pair in, and comes out of the detection.
        """
        def ask(_context, _universe, a, b):
            try:
                return 1 if keeps(a, b) else 0
            except BaseException as failure:  # pylint: disable=broad-except - nothing may pass through C
                self._failure = self._failure or failure
                return 1

        filter_: Any = c.Filter(ask) if keeps else c.Filter(0)
        self._change(library.abut_universe_set_filter, filter_, None)
        self._filter = filter_

    def refilter(self) -> None:
        """Asks the filter about all pairs again at the next step."""
        self._change(library.abut_universe_refilter)

    def set_policy(self, tag_a: int, tag_b: int, **fields: Any) -> None:
        """How geometries of two tags meet; the fields are those of Policy, and without any the default is back."""
        policy = options.filled(c.Policy, library.abut_policy_init, fields)
        self._change(library.abut_policy_set, tag_a, tag_b, byref(policy))

    def policy(self, tag_a: int, tag_b: int) -> c.Policy:
        """How geometries of two tags meet."""
        out = options.filled(c.Policy, library.abut_policy_init, {})
        self._read(library.abut_policy_get, tag_a, tag_b, byref(out))
        return out

    def set_focus(self, centres: Any, **fields: Any) -> None:
        """Tags that follow the distance from (N, 3) centres; the fields are those of Focus. None sets no focus."""
        if centres is None:
            self._change(library.abut_universe_set_focus, None, None, 0)
            return
        focus = options.filled(c.Focus, library.abut_focus_init, fields)
        places = given.structs(c.Vec3, "centres", centres)
        self._change(library.abut_universe_set_focus, byref(focus), places.memory, len(places))

    def set_material(self, material_a: int, material_b: int, **fields: Any) -> None:
        """What contacts of two materials are like; the fields are those of ContactMaterial."""
        row = options.filled(c.ContactMaterial, library.abut_contact_material_init, fields)
        self._change(library.abut_material_pair_set, material_a, material_b, byref(row))

    def material(self, material_a: int, material_b: int) -> c.ContactMaterial:
        """What contacts of two materials are like."""
        out = options.filled(c.ContactMaterial, library.abut_contact_material_init, {})
        self._read(library.abut_material_pair_get, material_a, material_b, byref(out))
        return out

    def _raise_what_the_filter_raised(self):
        failure, self._failure = self._failure, None
        if failure is not None:
            raise failure
