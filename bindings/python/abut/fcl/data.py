# SPDX-License-Identifier: Apache-2.0
"""Requests and results, with the fields and defaults of python-fcl. Fields that no query here reads say so."""

from __future__ import annotations

import sys
from typing import Any

import numpy

__all__ = [
    "CCDMotionType", "CCDSolverType", "CollisionData", "CollisionRequest", "CollisionResult", "Contact",
    "ContinuousCollisionRequest", "ContinuousCollisionResult", "CostSource", "DistanceData", "DistanceRequest",
    "DistanceResult", "GJKSolverType", "NODE_TYPE", "OBJECT_TYPE"]


class OBJECT_TYPE:
    OT_UNKNOWN, OT_BVH, OT_GEOM, OT_OCTREE, OT_COUNT = range(5)


class NODE_TYPE:
    (BV_UNKNOWN, BV_AABB, BV_OBB, BV_RSS, BV_kIOS, BV_OBBRSS, BV_KDOP16, BV_KDOP18, BV_KDOP24, GEOM_BOX, GEOM_SPHERE,
     GEOM_ELLIPSOID, GEOM_CAPSULE, GEOM_CONE, GEOM_CYLINDER, GEOM_CONVEX, GEOM_PLANE, GEOM_HALFSPACE, GEOM_TRIANGLE,
     GEOM_OCTREE, NODE_COUNT) = range(21)


class CCDMotionType:
    CCDM_TRANS, CCDM_LINEAR, CCDM_SCREW, CCDM_SPLINE = range(4)


class CCDSolverType:
    CCDC_NAIVE, CCDC_CONSERVATIVE_ADVANCEMENT, CCDC_RAY_SHOOTING, CCDC_POLYNOMIAL_SOLVER = range(4)


class GJKSolverType:
    GST_LIBCCD, GST_INDEP = range(2)


class Contact:
    """A contact: `normal` points from o1 to o2, `penetration_depth` is positive where they overlap.

    `o1` and `o2` are geometries. `b1` and `b2` are the triangles of a BVHModel, and -1 for other geometries.
    """

    def __init__(self) -> None:
        self.o1: Any = None
        self.o2: Any = None
        self.b1 = -1
        self.b2 = -1
        self.normal = numpy.zeros(3)
        self.pos = numpy.zeros(3)
        self.penetration_depth = 0.0


class CostSource:
    """No query makes any."""

    def __init__(self) -> None:
        self.aabb_min = numpy.zeros(3)
        self.aabb_max = numpy.zeros(3)
        self.cost_density = 0.0
        self.total_cost = 0.0


class CollisionRequest:
    """Only num_max_contacts and enable_contact are read."""

    def __init__(self, num_max_contacts: int = 1, enable_contact: bool = False, num_max_cost_sources: int = 1,
                 enable_cost: bool = False, use_approximate_cost: bool = True,
                 gjk_solver_type: int = GJKSolverType.GST_LIBCCD) -> None:
        self.num_max_contacts = num_max_contacts
        self.enable_contact = enable_contact
        self.num_max_cost_sources = num_max_cost_sources
        self.enable_cost = enable_cost
        self.use_approximate_cost = use_approximate_cost
        self.gjk_solver_type = gjk_solver_type


class CollisionResult:
    """Calls of collide() add to it."""

    def __init__(self, is_collision: bool = False) -> None:
        self.is_collision = is_collision
        self.contacts: list[Contact] = []
        self.cost_sources: list[CostSource] = []


class ContinuousCollisionRequest:
    """Only toc_err and ccd_motion_type are read."""

    def __init__(self, num_max_iterations: int = 10, toc_err: float = 0.0001,
                 ccd_motion_type: int = CCDMotionType.CCDM_TRANS, gjk_solver_type: int = GJKSolverType.GST_LIBCCD,
                 ccd_solver_type: int = CCDSolverType.CCDC_CONSERVATIVE_ADVANCEMENT) -> None:
        self.num_max_iterations = num_max_iterations
        self.toc_err = toc_err
        self.ccd_motion_type = ccd_motion_type
        self.gjk_solver_type = gjk_solver_type
        self.ccd_solver_type = ccd_solver_type


class ContinuousCollisionResult:
    """The earliest of all calls of continuousCollide() that were given it."""

    def __init__(self, is_collide: bool = False, time_of_contact: float = 1.0) -> None:
        self.is_collide = is_collide
        self.time_of_contact = time_of_contact


class DistanceRequest:
    """Distances always come with their points, and with b1 and b2 only with enable_nearest_points."""

    def __init__(self, enable_nearest_points: bool = False, enable_signed_distance: bool = False,
                 gjk_solver_type: int = GJKSolverType.GST_LIBCCD) -> None:
        self.enable_nearest_points = enable_nearest_points
        self.enable_signed_distance = enable_signed_distance
        self.gjk_solver_type = gjk_solver_type


class DistanceResult:
    """The least of all calls of distance() that were given it. Points are in the world."""

    def __init__(self, min_distance_: float = sys.float_info.max) -> None:
        self.min_distance = min_distance_
        self.nearest_points: list[Any] = [None, None]
        self.o1: Any = None
        self.o2: Any = None
        self.b1 = -1
        self.b2 = -1


class CollisionData:
    """A request and a result, as the default callback takes them; `done` ends a traversal."""

    def __init__(self, request: Any = None, result: Any = None) -> None:
        self.request = CollisionRequest() if request is None else request
        self.result = CollisionResult() if result is None else result
        self.done = False


class DistanceData:
    """A request and a result, as the default callback takes them; `done` ends a traversal."""

    def __init__(self, request: Any = None, result: Any = None) -> None:
        self.request = DistanceRequest() if request is None else request
        self.result = DistanceResult() if result is None else result
        self.done = False
