# SPDX-License-Identifier: Apache-2.0
"""Two objects: whether and where they overlap, how far apart they are, and when they first touch."""

from __future__ import annotations

from typing import Any

import numpy

from .. import c
from ..impact import movement, movement_between, pair_time_of_impact
from ..pairs import pair_contacts, pair_distance, pair_overlaps
from .data import (CCDMotionType, CollisionRequest, CollisionResult, Contact, ContinuousCollisionRequest,
                   ContinuousCollisionResult, DistanceRequest, DistanceResult)
from .objects import CollisionObject, Transform
from .shapes import BVHModel

__all__ = ["collide", "continuousCollide", "defaultCollisionCallback", "defaultDistanceCallback", "distance"]


def _shapes_of(o1, o2):
    """The shapes to ask about. Of the two half-spaces of a plane it is the one that the other object is less inside."""
    for name, each in (("o1", o1), ("o2", o2)):
        if not isinstance(each, CollisionObject):
            raise TypeError(f"{name} is of type {type(each).__name__}; it must be a CollisionObject")
    sides = [(a, b) for a in o1.geometry.shapes for b in o2.geometry.shapes]
    if len(sides) == 1:
        return sides[0]
    return max(sides, key=lambda pair: pair_distance(pair[0], o1.pose, pair[1], o2.pose).distance)


def _triangle(geometry, feature):
    is_triangle = isinstance(geometry, BVHModel) and feature.kind == c.FEATURE_FACE
    return feature.index if is_triangle else -1


def collide(o1: CollisionObject, o2: CollisionObject, request: Any = None, result: Any = None) -> int:
    """How many contacts two objects have; `result` gets them, deepest first.

    Without enable_contact it is 1 or 0, and the contact names the two geometries only.
    """
    request = CollisionRequest() if request is None else request
    result = CollisionResult() if result is None else result
    a, b = _shapes_of(o1, o2)
    if request.enable_contact:
        most = int(min(max(request.num_max_contacts, 1), 2**32 - 1))
        found = [_contact(o1, o2, each) for each in pair_contacts(
            a, o1.pose, b, o2.pose, max_contacts=0, max_pair_contacts=most)]
    else:
        found = [_contact(o1, o2, None)] if pair_overlaps(a, o1.pose, b, o2.pose) else []
    result.is_collision = result.is_collision or bool(found)
    result.contacts.extend(found)
    return len(found)


def _contact(o1, o2, found):
    contact = Contact()
    contact.o1, contact.o2 = o1.geometry, o2.geometry
    if found is not None:
        contact.b1, contact.b2 = _triangle(o1.geometry, found.feature_a), _triangle(o2.geometry, found.feature_b)
        contact.normal = numpy.array([*found.normal])
        contact.pos = (numpy.array([*found.point_a]) + [*found.point_b]) / 2
        contact.penetration_depth = -found.distance
    return contact


def distance(o1: CollisionObject, o2: CollisionObject, request: Any = None, result: Any = None) -> float:
    """The distance of two objects; `result` gets it where it is less than what stands there.

    Where they overlap it is minus their depth with enable_signed_distance, and -1 without.
    """
    request = DistanceRequest() if request is None else request
    result = DistanceResult() if result is None else result
    a, b = _shapes_of(o1, o2)
    found = pair_distance(a, o1.pose, b, o2.pose)
    apart = found.distance if found.distance >= 0 or request.enable_signed_distance else -1.0
    if apart < result.min_distance:
        result.min_distance = apart
        result.nearest_points = [numpy.array([*found.point_a]), numpy.array([*found.point_b])]
        result.o1, result.o2 = o1.geometry, o2.geometry
        result.b1 = result.b2 = -1
        if request.enable_nearest_points and BVHModel in (type(o1.geometry), type(o2.geometry)):
            result.b1, result.b2 = _nearest_triangles(o1, a, o2, b, found.distance)
    return apart


def _nearest_triangles(o1, a, o2, b, apart):
    """Distances do not tell triangles; the deepest contact up to that distance does."""
    found = pair_contacts(a, o1.pose, b, o2.pose, margin=max(apart, 0) * (1 + 1e-9) + 1e-300, max_pair_contacts=1)
    if not found:
        return -1, -1
    return _triangle(o1.geometry, found[0].feature_a), _triangle(o2.geometry, found[0].feature_b)


def continuousCollide(o1: CollisionObject, tf1_end: Transform, o2: CollisionObject, tf2_end: Transform,
                      request: Any = None, result: Any = None) -> float:
    """When two objects first touch on their ways to the other transforms, from 0 to 1; 1.0 where they do not.

    Both go straight. With CCDM_TRANS, the default, they keep their orientations, and turn at an even rate otherwise.
    """
    request = ContinuousCollisionRequest() if request is None else request
    result = ContinuousCollisionResult() if result is None else result
    a, b = _shapes_of(o1, o2)
    ways = [_way(o1, tf1_end, request), _way(o2, tf2_end, request)]
    found = pair_time_of_impact(a, o1.pose, ways[0], b, o2.pose, ways[1], tolerance=request.toc_err)
    touches = found.state in (c.IMPACT_TOUCHES, c.IMPACT_STARTS_TOGETHER)
    time = found.lower if touches else 1.0
    result.is_collide = result.is_collide or touches
    result.time_of_contact = min(time, result.time_of_contact)
    return time


def _way(moving, end, request):
    if request.ccd_motion_type == CCDMotionType.CCDM_TRANS:
        return movement(end.getTranslation() - moving.getTranslation())
    return movement_between(moving.pose, end.pose)


def defaultCollisionCallback(o1: CollisionObject, o2: CollisionObject, cdata: Any) -> bool:
    """Collides the two, and ends the traversal once there are more contacts than were asked for."""
    if cdata.done:
        return True
    request, result = cdata.request, cdata.result
    collide(o1, o2, request, result)
    if not request.enable_cost and result.is_collision and len(result.contacts) > request.num_max_contacts:
        cdata.done = True
    return cdata.done


def defaultDistanceCallback(o1: CollisionObject, o2: CollisionObject, cdata: Any) -> "tuple[bool, float]":
    """Measures the two, and ends the traversal at an overlap."""
    if cdata.done:
        return True, cdata.result.min_distance
    distance(o1, o2, cdata.request, cdata.result)
    least = cdata.result.min_distance
    return least <= 0 or cdata.done, least
