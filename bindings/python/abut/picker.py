# SPDX-License-Identifier: Apache-2.0
"""Rays and the mouse against a universe, through the library for picking."""

from __future__ import annotations

from ctypes import byref, c_uint32, c_void_p
from typing import Any

from . import answers, c, given, options
from .c import picking
from .options import filter_of
from .owner import Owner
from .records import Records
from .universe import Universe
from .values import given_rays

__all__ = ["Picker", "camera", "camera_ray", "clip_plane"]


def _expect_picking():
    if picking is None:
        raise RuntimeError(f"libabut_picking is not there ({c.picking_failure}); ABUT_PICKING_LIBRARY may name it")


def camera(eye: Any = None, target: Any = None, up: Any = (0.0, 0.0, 1.0), *, matrix: Any = None,
           depth: int = c.CLIP_DEPTH_SIGNED, **fields: Any) -> c.Camera:
    """A camera; the fields are those of Camera. With eye and target it looks from one to the other.

    `matrix` is a projection matrix of 4 x 4 numbers, row by row as NumPy has them, for column vectors.
    """
    _expect_picking()
    out = options.filled(c.Camera, picking.abut_camera_init, fields)
    if matrix is not None:
        rows, count = given.rows("matrix", matrix, 4)
        if count != 4:
            raise ValueError(f"matrix has {count} rows; it must have 4")
        columns = given.numbers("matrix", [rows[4 * row + column] for column in range(4) for row in range(4)])
        picking.abut_camera_set_projection(byref(out), columns, depth)
    if (eye is None) != (target is None):
        raise ValueError("eye and target belong together; one of them is missing")
    if eye is not None:
        picking.abut_camera_look_at(byref(out), byref(given.vec3("eye", eye)), byref(given.vec3("target", target)),
                                    byref(given.vec3("up", up)))
    return out


def camera_ray(through: c.Camera, x: float, y: float) -> c.Ray:
    """The ray through a point of the picture, in pixels from its upper left corner."""
    _expect_picking()
    out = c.Ray()
    picking.abut_camera_ray(byref(through), *given.reals(x=x, y=y), byref(out))
    return out


def clip_plane(normal: Any, offset: float = 0.0) -> c.ClipPlane:
    """Keeps the points p with dot(normal, p) >= offset, which is measured along the unit normal."""
    return c.ClipPlane(given.vec3("normal", normal), *given.reals(offset=offset))


class Picker(Owner):
    """Rays against a universe, which it keeps alive. The keywords are the fields of QueryFilter."""

    def __init__(self, universe: Universe) -> None:
        _expect_picking()
        out = c_void_p()
        universe._read(picking.abut_picker_create, byref(out))
        self._universe = universe
        super().__init__(out)
        universe._attached.add(self)

    def _ask(self, function, *arguments):
        """A call that reads the universe."""
        pointer = self.pointer
        self._universe._read(lambda _: function(pointer, *arguments))

    def _release(self, pointer):
        picking.abut_picker_destroy(pointer)

    def update(self) -> None:
        """Follows the universe now rather than at the next query."""
        self._ask(picking.abut_picker_update)

    def set_flags(self, flags: int) -> None:
        """What later queries see: PICKER_SENSORS, PICKER_SKIP_BACK_FACES."""
        picking.abut_picker_set_flags(self.pointer, flags)

    def set_clip_planes(self, planes: Any = ()) -> None:
        """Cuts away what lies behind planes, each from clip_plane, in all later queries."""
        planes = [given.one(c.ClipPlane, f"planes[{i}]", plane) for i, plane in enumerate(planes)]
        picking.abut_picker_set_clip_planes(self.pointer, (c.ClipPlane * len(planes))(*planes), len(planes))

    def cast_ray(self, along: c.Ray, **filter: Any) -> c.Pick:
        """What a ray meets first; the geometry is null when there is nothing."""
        out, line = c.Pick(), given.one(c.Ray, "along", along)
        self._ask(picking.abut_picker_cast_ray, byref(line), filter_of(filter), byref(out))
        return out

    def cast_rays(self, rays: Any, coherence: int = c.COHERENCE_NONE, **filter: Any) -> Records:
        """What each ray meets first. Rays are those of abut.rays, or (N, 6) numbers: origin and direction."""
        along = given_rays("rays", rays)
        out = (c.Pick * len(along))()
        self._ask(picking.abut_picker_cast_rays, along.memory, len(along), coherence, filter_of(filter), out)
        return Records(out)

    def ray_hits(self, along: c.Ray, **filter: Any) -> bool:
        """Whether a ray meets anything, which costs less than what it meets first."""
        out, line = c_uint32(), given.one(c.Ray, "along", along)
        self._ask(picking.abut_picker_ray_hits, byref(line), filter_of(filter), byref(out))
        return out.value == 1

    def rays_hit(self, rays: Any, coherence: int = c.COHERENCE_NONE, **filter: Any) -> Any:
        """Whether each ray meets anything, as numbers 1 and 0: an array of ctypes, which NumPy sees as one of its."""
        along = given_rays("rays", rays)
        out = (c_uint32 * len(along))()
        self._ask(picking.abut_picker_rays_hit, along.memory, len(along), coherence, filter_of(filter), out)
        return out

    def cast_ray_all(self, along: c.Ray, **filter: Any) -> Records:
        """Everything that a ray meets, nearest first."""
        line = given.one(c.Ray, "along", along)
        return answers.records(c.Pick, lambda *rest: self._ask(
            picking.abut_picker_cast_ray_all, byref(line), filter_of(filter), *rest))

    def pick_pixel(self, through: c.Camera, x: float, y: float, radius: float = 0.0, **filter: Any) -> c.Pick:
        """What lies under the mouse."""
        out = c.Pick()
        self._ask(picking.abut_picker_pick_pixel, byref(through), x, y, radius, filter_of(filter), byref(out))
        return out

    def select_rectangle(self, through: c.Camera, x0: float, y0: float, x1: float, y1: float,
                         selection: int = c.SELECTION_TOUCHING, **filter: Any) -> Records:
        """Geometries that touch a rectangle between two corners in pixels, or with SELECTION_INSIDE lie in it."""
        corners = given.reals(x0=x0, y0=y0, x1=x1, y1=y1)
        return answers.records(c.GeometryId, lambda *rest: self._ask(
            picking.abut_picker_select_rectangle, byref(through), *corners, selection, filter_of(filter), *rest))

    def snap(self, through: c.Camera, x: float, y: float, radius: float, kinds: int = 0, **filter: Any) -> c.Snap:
        """The nearest vertex, else middle of an edge, else point of an edge within a radius in pixels; kind is 0 where
        there is none. Kinds are SNAP_VERTEX, SNAP_MIDPOINT, SNAP_EDGE; 0 for all."""
        out = c.Snap()
        self._ask(picking.abut_picker_snap, byref(through), *given.reals(x=x, y=y, radius=radius), kinds,
                  filter_of(filter), byref(out))
        return out

    def barycentric(self, pick: c.Pick) -> c.Barycentric:
        """The triangle that a pick lies in, and the weights of its corners there."""
        out = c.Barycentric()
        self._ask(picking.abut_picker_barycentric, pick.geometry, pick.feature.index, byref(pick.point), byref(out))
        return out

    def render(self, through: c.Camera, **filter: Any) -> Records:
        """What each pixel of a camera shows, row by row from the top."""
        out = (c.Pick * (through.width * through.height))()
        self._ask(picking.abut_picker_render, byref(through), filter_of(filter), out, len(out))
        return Records(out)
