# SPDX-License-Identifier: Apache-2.0
"""Questions about two shapes without a universe: `pair_` asks once, `pairs_` asks for many poses."""

from __future__ import annotations

import array
from ctypes import byref, c_uint32
from typing import Any

from . import answers, c, given, options
from .c import library
from .progress import Progress, chunks
from .records import Groups, Records, empty, part_of
from .shapes import Shape, kind_number
from .values import poses

__all__ = [
    "load_routes", "pair_cast", "pair_contacts", "pair_distance", "pair_memories", "pair_overlaps", "pair_routes",
    "pairs_cast", "pairs_contacts", "pairs_distance", "pairs_overlap", "points_distance", "validate_contact"]

_NO_WAY = (0.0, 0.0, 0.0)


def _placed(a, pose_a, b, pose_b):
    return (given.shape_pointer("a", a), byref(given.pose("pose_a", pose_a)),
            given.shape_pointer("b", b), byref(given.pose("pose_b", pose_b)))


def pair_distance(a: Shape, pose_a: Any, b: Shape, pose_b: Any, memory: Any = None,
                  **fields: Any) -> c.Distance:
    """Signed distance of two shapes; a PairMemory of the two makes it faster; the fields are those of QueryOptions."""
    out, asked = c.Distance(), (*_placed(a, pose_a, b, pose_b), options.query(fields))
    if memory is None:
        library.abut_pair_distance(*asked, byref(out))
    else:
        library.abut_pair_distance_with_memory(*asked, byref(memory), byref(out))
    return out


def pairs_distance(a: Shape, poses_a: Any, b: Shape, poses_b: Any, memories: Any = None, out: Records | None = None,
                   progress: Progress = None, **fields: Any) -> Records:
    """Signed distances of two shapes at many pairs of poses; one pose of either serves for all of the other.

    Poses are (N, 7) numbers or Poses. `memories` are as many PairMemory. `out` is an earlier answer of as many, to be
    filled again; a failure may leave it filled in part. The fields are those of QueryOptions.
    """
    first, second = given.structs(c.Pose, "poses_a", poses_a), given.structs(c.Pose, "poses_b", poses_b)
    belonging = [first, second] + ([] if memories is None else [given.structs(c.PairMemory, "memories", memories)])
    count = given.together(*belonging)
    found = empty(c.Distance, count) if out is None else _memory_of(out, count)
    pointers, query = (given.shape_pointer("a", a), given.shape_pointer("b", b)), options.query(fields)
    for start, length in chunks(count, progress):
        asked = [part_of(each.memory, start, length) for each in belonging]
        call = (pointers[0], asked[0], pointers[1], asked[1], length, query)
        if memories is None:
            library.abut_pairs_distance(*call, part_of(found, start, length))
        else:
            library.abut_pairs_distance_with_memories(*call, asked[2], part_of(found, start, length))
    return Records(found) if out is None else out


def _memory_of(out, count):
    if not isinstance(out, Records) or out.kind is not c.Distance or len(out) != count:
        raise ValueError(f"out is {out!r}; it must be the answer for {count} distances")
    return out.memory


def points_distance(shape: Shape, at: Any, points: Any, progress: Progress = None, **fields: Any) -> Records:
    """Signed distances of a shape at a pose from (N, 3) points, which are b."""
    with Shape.point() as point:
        return pairs_distance(shape, given.pose("at", at), point, poses(_rows_of("points", points)), progress=progress,
                              **fields)


def _rows_of(name, points):
    memory, count = given.rows(name, points, 3)
    return (c.Vec3 * count).from_buffer(memory) if count else (c.Vec3 * 0)()


def pair_contacts(a: Shape, pose_a: Any, b: Shape, pose_b: Any, memory: Any = None,
                  **fields: Any) -> Records:
    """Contacts of two shapes, deepest first; a PairMemory makes it faster; the fields are those of QueryOptions."""
    asked = (*_placed(a, pose_a, b, pose_b), options.query(fields))
    if memory is None:
        return answers.records(c.Contact, lambda *rest: library.abut_pair_contacts(*asked, *rest))
    return answers.records(
        c.Contact, lambda *rest: library.abut_pair_contacts_with_memory(*asked, byref(memory), *rest))


def pairs_contacts(a: Shape, poses_a: Any, b: Shape, poses_b: Any, memories: Any = None, progress: Progress = None,
                   **fields: Any) -> Groups:
    """Contacts of two shapes at many pairs of poses: group i are those of pair i, deepest first.

    Poses and memories are as in pairs_distance. The fields are those of QueryOptions.
    """
    first, second = given.structs(c.Pose, "poses_a", poses_a), given.structs(c.Pose, "poses_b", poses_b)
    belonging = [first, second] + ([] if memories is None else [given.structs(c.PairMemory, "memories", memories)])
    count = given.together(*belonging)
    pointers, query = (given.shape_pointer("a", a), given.shape_pointer("b", b)), options.query(fields)
    ask = library.abut_pairs_contacts if memories is None else library.abut_pairs_contacts_with_memories
    parts = []
    for start, length in chunks(count, progress):
        poses_of_a, poses_of_b, *kept = (part_of(each.memory, start, length) for each in belonging)
        call = (pointers[0], poses_of_a, pointers[1], poses_of_b, length, query, *kept)
        parts.append(answers.groups(c.Contact, length, lambda *rest: ask(*call, *rest), 4 * length + 16))
    return answers.joined(parts)


def pair_routes(kind_a: str, kind_b: str, query: int = c.QUERY_DISTANCE, **fields: Any) -> Records:
    """The measured routes of two kinds: algorithm, error_bound, seconds of one question, worst_error.

    ROUTE_CHOSEN in `flags` marks the one that `time_budget` takes. The fields are those of QueryOptions.
    """
    asked = (kind_number("kind_a", kind_a), kind_number("kind_b", kind_b), query, options.query(fields))
    return answers.records(c.Route, lambda *rest: library.abut_pair_routes(*asked, *rest))


def load_routes(text: str | None = None) -> None:
    """Routes as `abut tune` writes them, for all pairs of this process; without a text those that abut comes with.

    No other thread may ask abut anything meanwhile.
    """
    library.abut_routes_load(None if text is None else text.encode())


def pair_overlaps(a: Shape, pose_a: Any, b: Shape, pose_b: Any, **fields: Any) -> bool:
    """Whether two shapes are within the margin, by default 0; the fields are those of QueryOptions."""
    out = c_uint32()
    library.abut_pair_overlaps(*_placed(a, pose_a, b, pose_b), options.query(fields), byref(out))
    return out.value == 1


def pairs_overlap(a: Any, poses_a: Any, b: Any, poses_b: Any, progress: Progress = None, **fields: Any) -> array.array:
    """Whether shapes overlap, pair by pair: numbers that are 1 or 0, which NumPy takes without a copy.

    One shape or one pose serves for all of the others. Poses are as in pairs_distance. The fields are those of
    QueryOptions.
    """
    belonging = (given.shape_pointers("a", a), given.structs(c.Pose, "poses_a", poses_a),
                 given.shape_pointers("b", b), given.structs(c.Pose, "poses_b", poses_b))
    count, query = given.together(*belonging), options.query(fields)
    found = array.array("I", bytes(4 * count))
    answered = (c_uint32 * count).from_buffer(found) if count else (c_uint32 * 0)()
    for start, length in chunks(count, progress):
        shapes_a, places_a, shapes_b, places_b = (part_of(each.memory, start, length) for each in belonging)
        library.abut_pairs_overlap(shapes_a, places_a, shapes_b, places_b, length, query,
                                   part_of(answered, start, length))
    return found


def validate_contact(contact: c.Contact) -> None:
    """Raises Error, which names the field, for a record that no detection would report."""
    library.abut_contact_validate(byref(contact))


def pair_cast(a: Shape, pose_a: Any, displacement_a: Any, b: Shape, pose_b: Any, displacement_b: Any = _NO_WAY,
              **fields: Any) -> c.CastHit | None:
    """When two shapes that move by their displacements first touch, or None; the fields are those of QueryOptions."""
    hit, found = c.CastHit(), c_uint32()
    pointer_a, place_a, pointer_b, place_b = _placed(a, pose_a, b, pose_b)
    library.abut_pair_cast(pointer_a, place_a, byref(given.vec3("displacement_a", displacement_a)), pointer_b, place_b,
                           byref(given.vec3("displacement_b", displacement_b)), options.query(fields), byref(hit),
                           byref(found))
    return hit if found.value else None


def pairs_cast(a: Shape, poses_a: Any, displacements_a: Any, b: Shape, poses_b: Any, displacements_b: Any = _NO_WAY,
               progress: Progress = None, **fields: Any) -> Records:
    """The same for many poses and displacements; `fraction` is infinite where the two never touch."""
    belonging = (given.structs(c.Pose, "poses_a", poses_a), given.structs(c.Vec3, "displacements_a", displacements_a),
                 given.structs(c.Pose, "poses_b", poses_b), given.structs(c.Vec3, "displacements_b", displacements_b))
    count = given.together(*belonging)
    pointers, query = (given.shape_pointer("a", a), given.shape_pointer("b", b)), options.query(fields)
    hits = empty(c.CastHit, count)
    for start, length in chunks(count, progress):
        places_a, ways_a, places_b, ways_b = (part_of(each.memory, start, length) for each in belonging)
        library.abut_pairs_cast(pointers[0], places_a, ways_a, pointers[1], places_b, ways_b, length, query,
                                part_of(hits, start, length))
    return Records(hits)


def pair_memories(count: int) -> Records:
    """Memories for pairs_distance, empty at first."""
    return Records((c.PairMemory * count)())
