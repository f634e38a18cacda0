# SPDX-License-Identifier: Apache-2.0
"""Queries on a universe. They see poses as of the last step or refresh(); the keywords are the fields of QueryFilter."""

from __future__ import annotations

from ctypes import byref, c_uint32
from typing import Any

from .. import answers, c, given
from ..c import library
from ..lending import Lender
from ..options import filter_of, impact_options_of
from ..progress import Progress, chunks
from ..records import Groups, Records, empty, part_of
from ..shapes import Shape
from ..values import INFINITY, given_rays


class Queries(Lender):
    """Batches take (N, 7) poses and (N, 3) points; one shape, pose or displacement serves for all others."""

    def cast_ray(self, along: c.Ray, mode: int = c.HIT_NEAREST, **filter: Any) -> Records:
        """Hits of a ray, in order."""
        line = given.one(c.Ray, "along", along)
        return answers.records(c.QueryHit, lambda *rest: self._read(
            library.abut_universe_cast_ray, byref(line), filter_of(filter), mode, *rest))

    def cast_rays(self, rays: Any, progress: Progress = None, **filter: Any) -> Records:
        """The nearest hit of each ray; its geometry is null where there is none. Rays are those of abut.rays, or
        (N, 6) numbers: origin and direction."""
        along = given_rays("rays", rays)
        return self._in_chunks(c.QueryHit, [along], progress, lambda lines, count, out: self._read(
            library.abut_universe_cast_rays, lines, count, filter_of(filter), out))

    def _in_chunks(self, kind, belonging, progress, ask):
        """The answer of a batch: one record for each of what belongs together."""
        count = given.together(*belonging)
        out = empty(kind, count)
        for start, length in chunks(count, progress):
            ask(*(part_of(each.memory, start, length) for each in belonging), length, part_of(out, start, length))
        return Records(out)

    def cast_shape(self, shape: Shape, at: Any, displacement: Any, mode: int = c.HIT_NEAREST, **filter: Any) -> Records:
        """Hits of a shape that moves without turning, in order."""
        place, way = given.pose("at", at), given.vec3("displacement", displacement)
        pointer = given.shape_pointer("shape", shape)
        return answers.records(c.CastHit, lambda *rest: self._read(
            library.abut_universe_cast_shape, pointer, byref(place), byref(way), filter_of(filter), mode, *rest))

    def cast_shapes(self, shapes: Any, poses: Any, displacements: Any, progress: Progress = None,
                    **filter: Any) -> Records:
        """The nearest hit of each shape; its geometry is null where there is none."""
        belonging = [*_placed(shapes, poses), given.structs(c.Vec3, "displacements", displacements)]
        return self._in_chunks(c.CastHit, belonging, progress, lambda pointers, places, ways, count, out: (
            self._read(library.abut_universe_cast_shapes, pointers, places, ways, count, filter_of(filter), out)))

    def cast_movement(self, shape: Shape, at: Any, movement: Any, duration: float = 1.0, mode: int = c.HIT_NEAREST,
                      options: dict | None = None, **filter: Any) -> Records:
        """Hits of a shape that moves and turns, in order; the options are fields of ImpactOptions."""
        place, way = given.pose("at", at), given.one(c.Movement, "movement", movement)
        pointer, (time,) = given.shape_pointer("shape", shape), given.reals(duration=duration)
        settings = impact_options_of(options or {})
        return answers.records(c.ImpactHit, lambda *rest: self._read(
            library.abut_universe_cast_movement, pointer, byref(place), byref(way), time, settings, filter_of(filter),
            mode, *rest))

    def cast_movements(self, shapes: Any, poses: Any, movements: Any, duration: float = 1.0, progress: Progress = None,
                       options: dict | None = None, **filter: Any) -> Records:
        """The first hit of each shape; its geometry is null where there is none."""
        belonging = [*_placed(shapes, poses), given.structs(c.Movement, "movements", movements)]
        (time,), settings = given.reals(duration=duration), impact_options_of(options or {})
        return self._in_chunks(c.ImpactHit, belonging, progress, lambda pointers, places, ways, count, out: (
            self._read(library.abut_universe_cast_movements, pointers, places, ways, count, time, settings,
                       filter_of(filter), out)))

    def overlaps(self, shape: Shape, at: Any, margin: float = 0.0, **filter: Any) -> Records:
        """Geometries with which a shape has contacts up to a distance."""
        place, pointer = given.pose("at", at), given.shape_pointer("shape", shape)
        return answers.records(c.GeometryId, lambda *rest: self._read(
            library.abut_universe_overlaps, pointer, byref(place), filter_of(filter), margin, *rest))

    def overlaps_of_each(self, shapes: Any, poses: Any, margin: float = 0.0, **filter: Any) -> Groups:
        """The same for each of many shapes: group i are the geometries of shape i."""
        pointers, places = _placed(shapes, poses)
        count = given.together(pointers, places)
        return answers.groups(c.GeometryId, count, lambda *rest: self._read(
            library.abut_universe_overlaps_of_each, pointers.memory, places.memory, count, filter_of(filter), margin,
            *rest), 2 * count + 16)

    def at_point(self, point: Any, **filter: Any) -> Records:
        """Geometries that hold a point."""
        place = given.vec3("point", point)
        return answers.records(c.GeometryId, lambda *rest: self._read(
            library.abut_universe_at_point, byref(place), filter_of(filter), *rest))

    def at_points(self, points: Any, **filter: Any) -> Groups:
        """Geometries that hold each of (N, 3) points: group i are those of point i."""
        places = given.structs(c.Vec3, "points", points)
        return answers.groups(c.GeometryId, len(places), lambda *rest: self._read(
            library.abut_universe_at_points, places.memory, len(places), filter_of(filter), *rest),
            2 * len(places) + 16)

    def closest(self, shape: Shape, at: Any, max_distance: float = INFINITY, **filter: Any) -> c.Closest | None:
        """The closest geometry and its distance, or None."""
        out, found, place = c.Closest(), c_uint32(), given.pose("at", at)
        self._read(library.abut_universe_closest, given.shape_pointer("shape", shape), byref(place), max_distance,
                                      filter_of(filter), byref(out), byref(found))
        return out if found.value else None

    def closest_to_each(self, shapes: Any, poses: Any, max_distance: float = INFINITY, progress: Progress = None,
                        **filter: Any) -> Records:
        """The same for each of many shapes; the geometry is null where nothing is near."""
        return self._in_chunks(c.Closest, _placed(shapes, poses), progress, lambda pointers, places, count, out: (
            self._read(library.abut_universe_closest_to_each, pointers, places, count, max_distance, filter_of(filter),
                                                  out)))


def _placed(shapes, poses):
    return [given.shape_pointers("shapes", shapes), given.structs(c.Pose, "poses", poses)]


def shape_cast_rays(shape: Shape, at: Any, rays: Any, progress: Progress = None) -> Records:
    """The first hit of each ray on a shape at a pose; its geometry is null where there is none."""
    from . import Universe

    with Universe() as universe:
        universe.add_geometry(universe.add_part(motion=c.MOTION_STATIC, pose=at), shape)
        universe.refresh()
        return universe.cast_rays(rays, progress)
