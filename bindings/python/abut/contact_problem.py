# SPDX-License-Identifier: Apache-2.0
"""Velocities and impulses of bodies in contact, on arrays and without a universe."""

from __future__ import annotations

from ctypes import POINTER, byref, c_double, c_uint32, cast
from typing import Any

from . import c, given, options
from .c import response as library
from .records import Records, empty

__all__ = ["solve_contact_problem"]

# Numbers of a body or of a contact.
_OF_BODIES = {"masses": 1, "inertias": 9, "centres": 3, "free_velocities": 6, "first_velocities": 6}
_OF_CONTACTS = {"bodies": 2, "points": 3, "normals": 3, "tangents": 3, "frictions": 2, "compliances": 1, "offsets": 1,
                "surface_velocities": 3, "first_impulses": 3}


def solve_contact_problem(solver: "dict | None" = None, **arrays: Any) -> "tuple[Records, Records, c.Residuals]":
    """Velocities of the bodies, impulses of the contacts on b, and by how much both miss the law of contact.

    The arrays are those of ContactProblem: masses (N,), inertias (N, 9), centres (N, 3) and free_velocities (N, 6) of
    bodies; bodies (M, 2), points (M, 3) and normals (M, 3) of contacts, and what may be left out. `solver` holds fields
    of SolverOptions. A body that is NO_BODY is a wall.
    """
    if library is None:
        raise RuntimeError(f"libabut_response is not there ({c.response_failure}); ABUT_RESPONSE_LIBRARY may name it")
    problem = options.filled(c.ContactProblem, library.abut_contact_problem_init, {})
    problem.body_count = _put(problem, _OF_BODIES, arrays)
    problem.contact_count = _put(problem, _OF_CONTACTS, arrays)
    if arrays:
        known = ", ".join([*_OF_BODIES, *_OF_CONTACTS])
        raise TypeError(f"a contact problem has no array {next(iter(arrays))}; it has {known}")
    settings = options.filled(c.SolverOptions, library.abut_solver_options_init, solver or {})
    velocities, impulses = empty(c.Velocity, problem.body_count), empty(c.Vec3, problem.contact_count)
    out = c.Residuals()
    library.abut_contact_problem_solve(byref(problem), byref(settings), cast(velocities, POINTER(c_double)),
                                       cast(impulses, POINTER(c_double)), byref(out))
    return Records(velocities), Records(impulses), out


def _put(problem, widths, arrays):
    """Takes the arrays that a problem has of its bodies or contacts, and tells how many those are."""
    counts = {}
    for name, width in widths.items():
        if arrays.get(name) is None:
            arrays.pop(name, None)
            continue
        kind = c_uint32 if name == "bodies" else c_double
        values = arrays.pop(name)
        if getattr(values, "ndim", 0) == 3:
            values = values.reshape(len(values), -1)
        numbers, counts[name] = given.rows(name, values, width, kind)
        setattr(problem, name, cast(numbers, POINTER(kind)))
        problem.keeps = [*getattr(problem, "keeps", ()), numbers]
    if len(set(counts.values())) > 1:
        told = " and ".join(f"{name} has {count}" for name, count in counts.items())
        raise ValueError(f"{told}; they must have as many elements")
    return next(iter(counts.values()), 0)
