# SPDX-License-Identifier: Apache-2.0
"""Geometries with the arguments of FCL: full sizes where abut takes half sizes. They are shapes of abut inside."""

from __future__ import annotations

from typing import Any

import numpy

from ..shapes import Shape
from .data import NODE_TYPE, OBJECT_TYPE

__all__ = [
    "BVHModel", "Box", "Capsule", "CollisionGeometry", "Cone", "Convex", "Cylinder", "Ellipsoid", "Halfspace", "Plane",
    "Sphere", "TriangleP"]


class CollisionGeometry:
    """What a geometry is made of are its attributes, such as Box.side. Setting one makes its shape anew."""

    _node_type: Any = None
    _object_type = OBJECT_TYPE.OT_GEOM
    is_unbounded = False
    _shapes: Any = None

    def _made(self) -> "tuple[Shape, ...]":
        raise ValueError("a CollisionGeometry has no shape; use one of the classes that derive from it")

    @property
    def shapes(self) -> "tuple[Shape, ...]":
        """The shape of abut; of a plane, the two half-spaces that it bounds."""
        if self._shapes is None:
            self.__dict__["_shapes"] = self._made()
        return self._shapes

    def __setattr__(self, name: str, value: Any) -> None:
        self.__dict__[name] = value
        self.__dict__["_shapes"] = None

    def getNodeType(self) -> Any:
        return self._node_type

    def computeLocalAABB(self) -> None:
        """Does nothing: boxes are computed when they are needed."""

    @property
    def aabb_center(self) -> Any:
        box = self.shapes[0].aabb()
        return (numpy.array([*box.minimum]) + [*box.maximum]) / 2


def _vector(values):
    return numpy.array(values, "f8").reshape(3)


class TriangleP(CollisionGeometry):
    """The triangle of three points."""

    _node_type = NODE_TYPE.GEOM_TRIANGLE

    def __init__(self, a: Any, b: Any, c: Any) -> None:
        self.a, self.b, self.c = _vector(a), _vector(b), _vector(c)

    def _made(self):
        return (Shape.triangle(self.a, self.b, self.c),)


class Box(CollisionGeometry):
    """A box with the sides x, y and z, centred."""

    _node_type = NODE_TYPE.GEOM_BOX

    def __init__(self, x: float, y: float, z: float) -> None:
        self.side = _vector((x, y, z))

    def _made(self):
        return (Shape.box(*(side / 2 for side in self.side)),)


class Sphere(CollisionGeometry):
    """A ball, centred."""

    _node_type = NODE_TYPE.GEOM_SPHERE

    def __init__(self, radius: float) -> None:
        self.radius = radius

    def _made(self):
        return (Shape.sphere(self.radius),)


class Ellipsoid(CollisionGeometry):
    """An ellipsoid with the radii a, b and c, centred."""

    _node_type = NODE_TYPE.GEOM_ELLIPSOID

    def __init__(self, a: float, b: float, c: float) -> None:
        self.radii = _vector((a, b, c))

    def _made(self):
        return (Shape.ellipsoid(*self.radii),)


class _Round(CollisionGeometry):
    """A radius, and a length along Z, centred."""

    _make: Any = None

    def __init__(self, radius: float, lz: float) -> None:
        self.radius, self.lz = radius, lz

    def _made(self):
        return (self._make(self.radius, self.lz / 2),)


class Capsule(_Round):
    """All points within the radius of a segment of length lz along Z, centred."""

    _node_type, _make = NODE_TYPE.GEOM_CAPSULE, Shape.capsule


class Cone(_Round):
    """A cone along Z: its base at -lz / 2, its apex at lz / 2."""

    _node_type, _make = NODE_TYPE.GEOM_CONE, Shape.cone


class Cylinder(_Round):
    """A cylinder of length lz along Z, centred."""

    _node_type, _make = NODE_TYPE.GEOM_CYLINDER, Shape.cylinder


class Convex(CollisionGeometry):
    """The convex hull of vertices. Faces, each a count and as many indices, are kept but not needed."""

    _node_type = NODE_TYPE.GEOM_CONVEX

    def __init__(self, vertices: Any, num_faces: int, faces: Any) -> None:
        self.vertices = numpy.array(vertices, "f8").reshape(-1, 3)
        self.num_faces, self.faces = num_faces, numpy.array(faces)

    def _made(self):
        return (Shape.hull(self.vertices),)


class Halfspace(CollisionGeometry):
    """The points p with dot(n, p) <= d. As in FCL, a normal that is not unit scales d as well."""

    _node_type = NODE_TYPE.GEOM_HALFSPACE
    is_unbounded = True

    def __init__(self, n: Any, d: float) -> None:
        normal = _vector(n)
        length = float(numpy.linalg.norm(normal)) or 1.0
        self.n, self.d = normal / length, d / length

    def _made(self):
        return (Shape.plane(self.n, self.d),)


class Plane(Halfspace):
    """The points p with dot(n, p) == d. Both of its sides push: a body leaves on the side where more of it lies."""

    _node_type = NODE_TYPE.GEOM_PLANE

    def _made(self):
        return Shape.plane(self.n, self.d), Shape.plane(-self.n, -self.d)


_EMPTY, _BEGUN, _PROCESSED = range(3)  # BVHBuildState of FCL


class BVHModel(CollisionGeometry):
    """A surface of triangles without an inside: beginModel, addSubModel or addTriangle, endModel."""

    _node_type = NODE_TYPE.BV_OBBRSS
    _object_type = OBJECT_TYPE.OT_BVH

    def __init__(self) -> None:
        self._vertices: list = []
        self._triangles: list = []
        self._state = _EMPTY

    def _made(self):
        if self._state != _PROCESSED:
            raise ValueError("BVH geometry is not prepared: endModel() is missing")
        return (Shape.mesh(numpy.concatenate(self._vertices), numpy.concatenate(self._triangles)),)

    def _expect(self, state):
        if self._state != state:
            raise ValueError("BVH construction does not follow correct sequence: beginModel, addSubModel, endModel")

    def num_tries_(self) -> int:
        """How many triangles there are; the name is that of python-fcl."""
        return sum(len(triangles) for triangles in self._triangles)

    def buildState(self) -> int:
        """0 before beginModel, 1 before endModel, then 2."""
        return self._state

    def beginModel(self, num_tris_: int = 0, num_vertices_: int = 0) -> int:
        """Begins; the numbers are not needed."""
        self._expect(_EMPTY)
        self._state = _BEGUN
        return 0

    def addVertex(self, x: float, y: float, z: float) -> bool:
        self._expect(_BEGUN)
        self._vertices.append(numpy.array([[x, y, z]], "f8"))
        return True

    def addTriangle(self, v1: Any, v2: Any, v3: Any) -> bool:
        return self.addSubModel([v1, v2, v3], [(0, 1, 2)])

    def addSubModel(self, verts: Any, triangles: Any) -> bool:
        """Adds vertices and triangles, which count from the first of these vertices."""
        self._expect(_BEGUN)
        before = sum(len(vertices) for vertices in self._vertices)
        self._vertices.append(numpy.array(verts, "f8").reshape(-1, 3))
        self._triangles.append(numpy.array(triangles, "i8").reshape(-1, 3) + before)
        return True

    def endModel(self) -> int:
        self._expect(_BEGUN)
        if not self.num_tries_():
            raise ValueError("BVH geometry is not prepared: it has no triangles")
        self._state = _PROCESSED
        return 0
